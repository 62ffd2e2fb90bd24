"""The bundled hall for a program that does not read SDF: its surfaces, its lights, and all poses at an instant.

Reads only the parts of SDF that the hall's files use; anything else is an error. Numbers have the same meaning as in
gz-sim (docs/models.md): colours of surfaces are sRGB-encoded, those of lights are linear; a matte white surface that
faces a light of intensity 1 is exactly white.
"""

import math
import os
import xml.etree.ElementTree as xml
from collections import defaultdict
from dataclasses import dataclass, field

import numpy as np
from PIL import Image

LIGHT_TYPES = ("directional", "point", "spot")
GEOMETRIES = ("mesh",)
STACKED = 0.2  # [m]: a prop whose origin is this close to another's, seen from above, lies on it


def linear(encoded):
    encoded = np.asarray(encoded, dtype=float)
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)


@dataclass
class Material:
    base: np.ndarray = field(default_factory=lambda: np.ones(3))  # linear
    picture: str = ""
    strength: float = 0.5  # from SDF's specular
    roughness: float = 0.5
    metalness: float = 0.0
    glow: np.ndarray = field(default_factory=lambda: np.zeros(3))

    def colours(self):
        """The picture times the colour, linear; a single pixel if there is no picture."""
        if not self.picture:
            return self.base.reshape(1, 1, 3)
        with Image.open(self.picture) as picture:
            return linear(np.asarray(picture.convert("RGB")) / 255.0) * self.base


@dataclass
class Surface:
    owner: str  # the model's name
    casts_shadows: bool
    material: Material
    points: np.ndarray  # the three corners of each triangle, in the world
    normals: np.ndarray
    places: np.ndarray  # texture coordinates, from the picture's upper left corner


@dataclass
class Light:
    type: str
    casts_shadows: bool
    position: np.ndarray
    direction: np.ndarray
    intensity: np.ndarray
    attenuation: tuple  # constant, linear, quadratic
    range: float
    cone: tuple  # cosines of half the inner and half the outer angle, falloff


def numbers(text):
    return np.array([float(each) for each in text.split()])


def pose_of(element):
    """X_PE, the pose of an element in its parent, from its <pose>."""
    found = element.find("pose")
    if found is not None and found.attrib:
        raise ValueError(f"<pose>: found {found.attrib}; only poses without attributes are read here")
    x, y, z, roll, pitch, yaw = numbers(found.text if found is not None else "0 0 0 0 0 0")
    (cr, cp, cy), (sr, sp, sy) = np.cos([roll, pitch, yaw]), np.sin([roll, pitch, yaw])
    return np.array([[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr, x],
                     [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr, y],
                     [-sp, cp * sr, cp * cr, z], [0.0, 0.0, 0.0, 1.0]])


def flag(element, name, usual):
    return element.findtext(name, str(usual)).strip().lower() in ("true", "1")


class Models:
    """The models and meshes that a world refers to."""

    def __init__(self, folder):
        self.folder = folder
        self.meshes = {}

    def path(self, uri):
        if not uri.startswith("model://"):
            raise ValueError(f"found {uri}; only model:// is read here")
        return f"{self.folder}/{uri[len('model://'):]}"

    def model(self, include):
        return xml.parse(self.path(include.findtext("uri").strip()) + "/model.sdf").getroot().find("model")

    def mesh(self, uri):
        """A list of (material, points, normals, places) from an OBJ file."""
        if uri not in self.meshes:
            self.meshes[uri] = read_obj(self.path(uri))
        return self.meshes[uri]


def read_materials(path):
    materials = {}
    with open(path) as file:
        for words in map(str.split, file):
            if not words:
                continue
            if words[0] == "newmtl":
                material = materials.setdefault(words[1], Material())
            elif words[0] == "Kd":
                material.base = linear([float(each) for each in words[1:4]])
            elif words[0] == "Ke":
                material.glow = linear([float(each) for each in words[1:4]])
            elif words[0] == "Ks":
                material.strength = max(float(each) for each in words[1:4])
            elif words[0] == "Ns":  # an equally wide highlight: Walter et al. 2007, section 5.2
                material.roughness = (2.0 / (float(words[1]) + 2.0)) ** 0.25
            elif words[0] == "map_Kd":
                material.picture = f"{os.path.dirname(path)}/{words[1]}"
    return materials


def read_obj(path):
    columns = {"v": [], "vt": [], "vn": []}
    faces = defaultdict(list)
    materials, current = {}, ""
    with open(path) as file:
        for words in map(str.split, file):
            if not words:
                continue
            if words[0] in columns:
                columns[words[0]].append([float(each) for each in words[1:]])
            elif words[0] == "mtllib":
                materials = read_materials(f"{os.path.dirname(path)}/{words[1]}")
            elif words[0] == "usemtl":
                current = words[1]
            elif words[0] == "f":
                corners = [[int(each) - 1 for each in word.split("/")] for word in words[1:]]
                for i in range(2, len(corners)):
                    faces[current] += [corners[0], corners[i - 1], corners[i]]
    points, places, normals = (np.array(columns[each]) for each in ("v", "vt", "vn"))
    places = places[:, :2] * (1.0, -1.0) + (0.0, 1.0)
    return [(materials[name], points[of[:, 0]], normals[of[:, 2]], places[of[:, 1]])
            for name, of in ((name, np.array(each)) for name, each in faces.items())]


def material_of(visual, models):
    """The material with which a visual overrides those of its mesh, or None."""
    element = visual.find("material")
    if element is None:
        return None
    metal = element.find("pbr/metal")
    if metal is None:
        raise ValueError("<material>: only <pbr><metal> is read here")
    material = Material()
    if element.find("diffuse") is not None:
        material.base = linear(numbers(element.findtext("diffuse"))[:3])
    if metal.find("albedo_map") is not None:
        material.picture = models.path(metal.findtext("albedo_map").strip())
    material.strength = max(numbers(element.findtext("specular"))[:3])
    material.roughness = float(metal.findtext("roughness"))
    material.metalness = float(metal.findtext("metalness"))
    return material


def surfaces_of(model, name, X_WM, models, X_WL):
    """@param X_WL  a function: a link's pose by its name, or None if the model's file gives it"""
    for link in model.iter("link"):
        known = X_WL(link.get("name"))
        X_link = X_WM @ pose_of(link) if known is None else known
        for visual in link.iter("visual"):
            shape = list(visual.find("geometry"))[0]
            if shape.tag not in GEOMETRIES:
                raise ValueError(f"{name}: found <{shape.tag}>; only meshes are read here")
            X = X_link @ pose_of(visual)
            own = material_of(visual, models)
            for material, points, normals, places in models.mesh(shape.findtext("uri").strip()):
                yield Surface(name, flag(visual, "cast_shadows", True), own or material,
                              points @ X[:3, :3].T + X[:3, 3], normals @ X[:3, :3].T, places)


def light_of(element):
    kind = element.get("type")
    if kind not in LIGHT_TYPES:
        raise ValueError(f"<light>: found type {kind}; it should be one of {', '.join(LIGHT_TYPES)}")
    X = pose_of(element)
    direction = X[:3, :3] @ numbers(element.findtext("direction", "0 0 -1"))
    read = lambda name, usual: float(element.findtext(name, str(usual)))
    return Light(kind, flag(element, "cast_shadows", False), X[:3, 3],
                 direction / np.linalg.norm(direction),
                 numbers(element.findtext("diffuse"))[:3] * read("intensity", 1.0),
                 tuple(read(f"attenuation/{each}", usual)
                       for each, usual in (("constant", 1.0), ("linear", 1.0), ("quadratic", 0.0))),
                 read("attenuation/range", 10.0),
                 (math.cos(read("spot/inner_angle", 0.0) / 2), math.cos(read("spot/outer_angle", 0.0) / 2),
                  read("spot/falloff", 0.0)))


def settle(source, target, models, objects):
    """Writes the world with its props at rest, upright, on the floor or on each other: no file of a
    dataset says where physics moves them."""
    tree = xml.parse(source)
    world = tree.getroot().find("world")
    tops = []  # x, y, height of each prop
    for include in world.iter("include"):
        model = models.model(include)
        name = include.findtext("name", model.get("name"))
        if flag(model, "static", False) or name in objects:
            continue
        x, y, _, _, _, yaw = numbers(include.findtext("pose"))
        heights = np.concatenate([each.points[:, 2] for each in
                                  surfaces_of(model, name, np.eye(4), models, lambda _: None)])
        floor = max([top for of_x, of_y, top in tops if math.hypot(x - of_x, y - of_y) < STACKED], default=0.0)
        tops.append((x, y, floor + heights.max() - heights.min()))
        include.find("pose").text = f"{x} {y} {floor - heights.min()} 0 0 {yaw}"
        xml.SubElement(include, "static").text = "true"
    tree.write(target)


class World:
    """@param X_W  a function: poses of objects and links by model and link ("" for the model itself), or None"""

    def __init__(self, file, models, X_W):
        world = xml.parse(file).getroot().find("world")
        self.ambient = linear(numbers(world.findtext("scene/ambient"))[:3])
        self.background = linear(numbers(world.findtext("scene/background"))[:3])
        self.lights = [light_of(each) for each in world.iter("light")]
        self.surfaces = []
        for include in world.iter("include"):
            model = models.model(include)
            name = include.findtext("name", model.get("name"))
            moved = X_W(name, "")
            self.surfaces += surfaces_of(model, name, pose_of(include) if moved is None else moved, models,
                                         lambda link, name=name: X_W(name, link))


class Recording:
    """The poses in a bag's TF, interpolated between stamps as in tf2."""

    def __init__(self, file):
        import rosbag

        self.parents, known = {}, defaultdict(list)
        with rosbag.Bag(file) as bag:
            for _, message, _ in bag.read_messages(topics=["/tf", "/tf_static"]):
                for each in message.transforms:
                    t, r = each.transform.translation, each.transform.rotation
                    self.parents[each.child_frame_id] = each.header.frame_id
                    known[each.child_frame_id].append((each.header.stamp.to_nsec(),
                                                       (t.x, t.y, t.z, r.x, r.y, r.z, r.w)))
        self.known = {frame: sorted(each) for frame, each in known.items()}

    def at(self, frame, stamp):
        """X_WF; the world is the root of all frames. None if the frame does not exist."""
        if frame not in self.known:
            return None
        X_WP = self.at(self.parents[frame], stamp)
        known = self.known[frame]
        stamps = [each for each, _ in known]
        after = min(int(np.searchsorted(stamps, stamp)), len(known) - 1)
        before = max(after - 1, 0)
        way = stamps[after] - stamps[before]
        share = min(max((stamp - stamps[before]) / way, 0.0), 1.0) if way else 0.0
        here = between(np.array(known[before][1]), np.array(known[after][1]), share)
        return here if X_WP is None else X_WP @ here


def between(first, second, share):
    q, r = first[3:], second[3:]
    cosine = q @ r
    if cosine < 0.0:
        r, cosine = -r, -cosine
    angle = math.acos(min(cosine, 1.0))
    if angle > 1e-6:
        q = (math.sin((1.0 - share) * angle) * q + math.sin(share * angle) * r) / math.sin(angle)
    result = matrix(*((1.0 - share) * first[:3] + share * second[:3]), *q)
    return result


def matrix(x, y, z, qx, qy, qz, qw):
    """The pose with a position and a unit quaternion."""
    return np.array([
        [1 - 2 * (qy * qy + qz * qz), 2 * (qx * qy - qz * qw), 2 * (qx * qz + qy * qw), x],
        [2 * (qx * qy + qz * qw), 1 - 2 * (qx * qx + qz * qz), 2 * (qy * qz - qx * qw), y],
        [2 * (qx * qz - qy * qw), 2 * (qy * qz + qx * qw), 1 - 2 * (qx * qx + qy * qy), z],
        [0.0, 0.0, 0.0, 1.0]])
