"""The room drawn by pyrender with OSMesa: colour and depth with shadows, then segmentation; colour
and segmentation are saved as PNGs.

  pyrender_rival.py FOLDER SCENES     prints the seconds from the first scene to the last, as JSON
"""

import json
import os
import sys
import time

os.environ["PYOPENGL_PLATFORM"] = "osmesa"
import numpy as np  # noqa: E402: pyrender reads PYOPENGL_PLATFORM

if not hasattr(np, "infty"):
    np.infty = np.inf  # pyrender 0.1.45 is older than NumPy 2
import pyrender
import trimesh
from PIL import Image
from pyrender.constants import RenderFlags


def load(scene):
    room = pyrender.Scene(ambient_light=[scene["ambient"]] * 3)
    for _, size, centre, colour in scene["walls"]:
        box = trimesh.creation.box(size)
        box.visual.face_colors = [*(int(255 * v) for v in colour), 255]
        pose = np.eye(4)
        pose[:3, 3] = centre
        room.add(pyrender.Mesh.from_trimesh(box, smooth=False), pose=pose)
    nodes = []
    for model in scene["models"]:
        mesh = trimesh.load(model, process=False)
        mesh.apply_scale(scene["scale"])
        nodes.append(room.add(pyrender.Mesh.from_trimesh(mesh)))
    return room, nodes


def main(folder, count):
    with open(f"{folder}/scene.json") as source:
        scene = json.load(source)
    room, nodes = load(scene)
    rotation = np.array(scene["rotation"])
    pose = np.eye(4)
    pose[:3, :3] = rotation @ np.diag([1, -1, -1])  # OpenGL's cameras have y up and look along -z
    pose[:3, 3] = scene["camera"]
    cx, cy = scene["width"] / 2, scene["height"] / 2
    room.add(pyrender.IntrinsicsCamera(scene["focal"], scene["focal"], cx, cy, 0.05, 100), pose=pose)
    light = np.eye(4)
    z = -np.array(scene["light_direction"]) / np.linalg.norm(scene["light_direction"])
    x = np.cross((0, 1, 0), z)
    light[:3, 0], light[:3, 1], light[:3, 2] = x / np.linalg.norm(x), np.cross(z, x), z
    room.add(pyrender.DirectionalLight(intensity=3.0), pose=light)
    renderer = pyrender.OffscreenRenderer(scene["width"], scene["height"])
    colours = {node: (i + 1, 0, 0) for i, node in enumerate(nodes)}
    began = 0.0
    for index in range(count + 1):
        if index == 1:
            began = time.monotonic()
        for node, (x, y, z, yaw) in zip(nodes, scene["scenes"][index % len(scene["scenes"])]):
            pose = trimesh.transformations.rotation_matrix(yaw, (0, 0, 1))
            pose[:3, 3] = (x, y, z)
            room.set_pose(node, pose)
        colour, _ = renderer.render(room, flags=RenderFlags.SHADOWS_DIRECTIONAL)
        ids, _ = renderer.render(room, flags=RenderFlags.SEG, seg_node_map=colours)
        Image.fromarray(colour).save(f"{folder}/pyrender_{index}.png", compress_level=1)
        Image.fromarray(ids[:, :, 0]).save(f"{folder}/pyrender_{index}_ids.png", compress_level=1)
    print(json.dumps({"seconds": time.monotonic() - began, "version": pyrender.__version__}))


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
