"""A world's light by path tracing, with Mitsuba 3's rays and textures and the materials and lights of gz-sim.

Surfaces reflect light as in src/render/light/surface_shading.*, and lights fall off as there. So the pictures
differ only in the transport of light: where ambient light does not reach, and light that surfaces pass on.
Ambient light comes from all directions. A surface with nothing near it receives as much of it as in that file.
Things that cast no shadows block no light: a ray that has left a surface and hits such a thing sees the ambient
light behind it, unless the surface that it hits faces up and so counts as a floor.
"""

import math

import drjit as dr
import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")

BOUNCES = 5
SAMPLES_AT_ONCE = 8
FACES_UP = 0.5  # the normal's z from which a surface counts as a floor
# Ambient light from a direction (x, y, z) is ambient * (LEVEL + SLOPE * z). For a surface with normal n, the
# cosine-weighted mean is LEVEL + 2 / 3 SLOPE n.z: 0.55 if it faces down, 1 if it faces up.
LEVEL, SLOPE = 0.775, 0.3375


def shape_of(surface, owner):
    colours = surface.material.colours()
    props = mi.Properties()
    props["bsdf"] = mi.load_dict({"type": "diffuse", "reflectance": {
        "type": "bitmap", "bitmap": mi.Bitmap(np.ascontiguousarray(colours, dtype=np.float32)),
        "raw": True, "wrap_mode": "repeat"}})
    corners = len(surface.points)
    mesh = mi.Mesh(surface.owner, corners, corners // 3, has_vertex_normals=True, has_vertex_texcoords=True,
                   props=props)
    params = mi.traverse(mesh)
    flat = lambda values: mi.Float(np.ravel(values).astype(np.float32))
    params["vertex_positions"] = flat(surface.points)
    params["vertex_normals"] = flat(surface.normals)
    params["vertex_texcoords"] = flat(surface.places)
    params["faces"] = mi.UInt32(np.arange(corners, dtype=np.uint32))
    params.update()
    material = surface.material
    reflectance = 0.16 * min(material.strength, 1.0) ** 2
    for name, values in (("face_gloss", (reflectance, material.roughness, material.metalness)),
                         ("face_glow", material.glow),
                         ("face_about", (float(surface.casts_shadows), float(owner), 0.0))):
        mesh.add_attribute(name, 3, flat(np.tile(values, corners // 3)))
    return mesh


def scene_of(shapes):
    return mi.load_dict({"type": "scene", **{f"shape{i}": shape for i, shape in enumerate(shapes)}})


def mix(a, b, share):
    return a + (b - a) * share


class Hit:
    """The surface that a ray hits, and how it reflects light."""

    def __init__(self, scene, ray, active):
        si = self.si = scene.ray_intersect(ray, active)
        self.valid = active & si.is_valid()
        self.to_eye = -ray.d
        turned = dr.dot(si.n, self.to_eye) < 0.0
        self.face = dr.select(turned, -si.n, si.n)
        self.normal = dr.select(turned, -si.sh_frame.n, si.sh_frame.n)
        base = si.bsdf().eval_diffuse_reflectance(si, self.valid)
        gloss = si.shape.eval_attribute_3("face_gloss", si, self.valid)
        self.glow = si.shape.eval_attribute_3("face_glow", si, self.valid)
        about = si.shape.eval_attribute_3("face_about", si, self.valid)
        self.casts, self.owner = about.x > 0.5, about.y
        self.metalness = gloss.z
        self.f0 = mix(mi.Color3f(gloss.x), base, gloss.z)
        self.matte = base * (1.0 - gloss.z)
        self.alpha = dr.maximum(gloss.y * gloss.y, 0.01)
        self.n_dot_v = dr.maximum(dr.dot(self.normal, self.to_eye), 1e-3)

    def answer(self, to_light):
        """pi times the BRDF."""
        n_dot_l = dr.maximum(dr.dot(self.normal, to_light), 1e-6)
        halfway = dr.normalize(to_light + self.to_eye)
        n_dot_h = dr.maximum(dr.dot(self.normal, halfway), 0.0)
        v_dot_h = dr.maximum(dr.dot(self.to_eye, halfway), 0.0)
        fresnel = self.f0 + (1.0 - self.f0) * (1.0 - v_dot_h) ** 5
        a2 = self.alpha * self.alpha
        bell = n_dot_h * n_dot_h * (a2 - 1.0) + 1.0
        rough = mix(2.0 * n_dot_l * self.n_dot_v, n_dot_l + self.n_dot_v, self.alpha)
        return self.matte + fresnel * (0.5 * a2 / (bell * bell * rough))

    def sample(self, choice, place):
        """A direction, the BRDF times the cosine divided by its probability density, and whether it is valid."""
        shiny = mix(0.2, 1.0, self.metalness)
        frame = mi.Frame3f(self.normal)
        spread = frame.to_world(mi.warp.square_to_cosine_hemisphere(place))
        a2 = self.alpha * self.alpha
        cosine2 = (1.0 - place.x) / (1.0 + (a2 - 1.0) * place.x)
        sine, angle = dr.safe_sqrt(1.0 - cosine2), 2.0 * math.pi * place.y
        halfway = frame.to_world(mi.Vector3f(sine * dr.cos(angle), sine * dr.sin(angle), dr.safe_sqrt(cosine2)))
        mirrored = 2.0 * dr.dot(self.to_eye, halfway) * halfway - self.to_eye
        way = dr.normalize(dr.select(choice < shiny, mirrored, spread))
        n_dot_l = dr.dot(self.normal, way)
        halfway = dr.normalize(way + self.to_eye)
        n_dot_h = dr.maximum(dr.dot(self.normal, halfway), 1e-4)
        v_dot_h = dr.maximum(dr.dot(self.to_eye, halfway), 1e-4)
        bell = n_dot_h * n_dot_h * (a2 - 1.0) + 1.0
        density = a2 / (math.pi * bell * bell) * n_dot_h / (4.0 * v_dot_h)
        probability = mix(dr.maximum(n_dot_l, 0.0) / math.pi, density, shiny)
        weight = self.answer(way) * (n_dot_l / math.pi / dr.maximum(probability, 1e-6))
        good = (n_dot_l > 1e-4) & (dr.dot(self.face, way) > 1e-4)
        return way, dr.select(good, weight, 0.0), good


class Tracer:
    """@param sun  the diameter of directional lights [degree], which SDF does not give"""

    def __init__(self, world, sun):
        self.sun_radius = math.tan(math.radians(sun / 2.0))
        self.owners = sorted({each.owner for each in world.surfaces})
        shapes = [shape_of(each, self.owners.index(each.owner)) for each in world.surfaces]
        self.scene = scene_of(shapes)
        self.casters = scene_of([shape for shape, each in zip(shapes, world.surfaces) if each.casts_shadows])
        self.world = world

    def direct(self, lights, hit, active, place=None):
        """The direct light that a surface reflects to the eye; directional lights shine from a point on a disc."""
        result = mi.Color3f(0.0)
        for light in lights:
            falling = mi.Float(1.0)
            if light.type == "directional":
                to_light = mi.Vector3f((-light.direction).tolist())
                if place is not None:
                    disc = self.sun_radius * mi.warp.square_to_uniform_disk_concentric(place)
                    to_light = dr.normalize(mi.Frame3f(to_light).to_world(mi.Vector3f(disc.x, disc.y, 1.0)))
                ray = hit.si.spawn_ray(to_light)
            else:
                position = mi.Point3f(light.position.tolist())
                way = position - hit.si.p
                d = dr.norm(way)
                to_light = way / d
                constant, by_distance, by_square = light.attenuation
                falling = dr.select(d <= light.range, 1.0 / (constant + by_distance * d + by_square * d * d), 0.0)
                ray = hit.si.spawn_ray_to(position)
            if light.type == "spot":
                inner, outer, falloff = light.cone
                share = (dr.dot(-to_light, mi.Vector3f(light.direction.tolist())) - outer) / (inner - outer)
                falling *= dr.clip(share, 0.0, 1.0) ** falloff
            n_dot_l = dr.dot(hit.normal, to_light)
            faces = active & (n_dot_l > 0.0) & (dr.dot(hit.face, to_light) > 0.0) & (falling > 0.0)
            if light.casts_shadows:
                faces &= ~self.casters.ray_test(ray, faces)
            sent = hit.answer(to_light) * mi.Color3f(light.intensity.tolist()) * (falling * n_dot_l)
            result += dr.select(faces, sent, 0.0)
        return result

    def radiance(self, ray, sampler):
        ambient, background = (mi.Color3f(each.tolist()) for each in (self.world.ambient, self.world.background))
        result, share, active = mi.Color3f(0.0), mi.Color3f(1.0), mi.Bool(True)
        for bounce in range(BOUNCES + 1):
            hit = Hit(self.scene, ray, active)
            beyond = active & ~hit.valid
            if bounce > 0:
                beyond |= hit.valid & ~hit.casts & (hit.face.z < FACES_UP)
            around = ambient * (LEVEL + SLOPE * ray.d.z) if bounce > 0 else background
            result += dr.select(beyond, share * around, 0.0)
            active = active & ~beyond
            direct = self.direct(self.world.lights, hit, active, sampler.next_2d())
            result += dr.select(active, share * (hit.glow + direct), 0.0)
            way, weight, good = hit.sample(sampler.next_1d(), sampler.next_2d())
            active &= good
            share *= weight
            ray = hit.si.spawn_ray(way)
        return result

    def rays(self, camera, X_WC, offsets, count):
        """Rays through pixels, whose centres have whole coordinates.

        @param offsets  of each ray from its pixel's centre [px]
        """
        index = dr.arange(mi.UInt32, camera["width"] * camera["height"] * count) // count
        u = mi.Float(index % camera["width"]) + offsets.x
        v = mi.Float(index // camera["width"]) + offsets.y
        way_C = mi.Vector3f((u - camera["cx"]) / camera["fx"], (v - camera["cy"]) / camera["fy"], 1.0)
        way = mi.Matrix3f(X_WC[:3, :3].tolist()) @ way_C
        return mi.Ray3f(o=mi.Point3f(X_WC[:3, 3].tolist()), d=dr.normalize(way))

    def picture(self, camera, X_WC, samples):
        """Two pictures with half of the samples each, in linear light; their difference shows the noise."""
        size = (camera["height"], camera["width"])
        halves = [np.zeros((*size, 3)), np.zeros((*size, 3))]
        passes = 2 * max(1, math.ceil(samples / SAMPLES_AT_ONCE / 2))
        sampler = mi.load_dict({"type": "independent"})
        for number in range(passes):
            sampler.seed(number, size[0] * size[1] * SAMPLES_AT_ONCE)
            ray = self.rays(camera, X_WC, sampler.next_2d() - 0.5, SAMPLES_AT_ONCE)
            light = np.array(self.radiance(ray, sampler)).T
            halves[number % 2] += light.reshape(*size, SAMPLES_AT_ONCE, 3).mean(axis=2)
        return tuple(half / (passes / 2) for half in halves)

    def centres(self, camera, X_WC):
        """What pixel centres see: the owner's index (-1: nothing), the point, whether it is floor, and in the sun."""
        size = (camera["height"], camera["width"])
        ray = self.rays(camera, X_WC, mi.Point2f(0.0), 1)
        hit = Hit(self.scene, ray, mi.Bool(True))
        owner = dr.select(hit.valid, hit.owner, -1.0)
        floor = hit.valid & ~hit.casts & (hit.face.z > FACES_UP)
        suns = [each for each in self.world.lights if each.type == "directional"]
        sunlit = dr.max(self.direct(suns, hit, hit.valid)) > 0.0
        return {"owner": np.array(owner).reshape(size).astype(int), "floor": np.array(floor).reshape(size),
                "point": np.array(hit.si.p).T.reshape(*size, 3),
                "sunlit": np.array(sunlit).reshape(size)}
