"""The room drawn by PyBullet's TinyRenderer: colour, depth and segmentation in one call; colour and
segmentation are saved as PNGs.

  pybullet_rival.py FOLDER SCENES     prints the seconds from the first scene to the last, as JSON
"""

import json
import sys
import time

import numpy as np
import pybullet
from PIL import Image


def load(scene):
    pybullet.connect(pybullet.DIRECT)
    for _, size, centre, colour in scene["walls"]:
        shape = pybullet.createVisualShape(pybullet.GEOM_BOX, halfExtents=[v / 2 for v in size],
                                           rgbaColor=[*colour, 1])
        pybullet.createMultiBody(baseVisualShapeIndex=shape, basePosition=centre)
    bodies = []
    for model, picture in zip(scene["models"], scene["pictures"]):
        shape = pybullet.createVisualShape(pybullet.GEOM_MESH, fileName=model,
                                           meshScale=[scene["scale"]] * 3)
        bodies.append(pybullet.createMultiBody(baseVisualShapeIndex=shape))
        pybullet.changeVisualShape(bodies[-1], -1, textureUniqueId=pybullet.loadTexture(picture))
    return bodies


def main(folder, count):
    with open(f"{folder}/scene.json") as source:
        scene = json.load(source)
    bodies = load(scene)
    rotation = np.array(scene["rotation"])
    eye = np.array(scene["camera"])
    view = pybullet.computeViewMatrix(eye, eye + rotation[:, 2], -rotation[:, 1])
    fovy = np.degrees(2 * np.arctan(scene["height"] / 2 / scene["focal"]))
    projection = pybullet.computeProjectionMatrixFOV(fovy, scene["width"] / scene["height"], 0.05, 100)
    began = 0.0
    for index in range(count + 1):
        if index == 1:
            began = time.monotonic()
        for body, (x, y, z, yaw) in zip(bodies, scene["scenes"][index % len(scene["scenes"])]):
            pybullet.resetBasePositionAndOrientation(body, (x, y, z),
                                                     (0, 0, np.sin(yaw / 2), np.cos(yaw / 2)))
        shape = (scene["height"], scene["width"])
        _, _, colour, _, ids = pybullet.getCameraImage(
            scene["width"], scene["height"], view, projection, shadow=1,
            lightDirection=[-v for v in scene["light_direction"]],
            renderer=pybullet.ER_TINY_RENDERER)
        colour = np.reshape(colour, (*shape, 4)).astype(np.uint8)[:, :, :3]
        Image.fromarray(colour).save(f"{folder}/pybullet_{index}.png", compress_level=1)
        ids = np.reshape(ids, shape).astype(np.uint8)
        Image.fromarray(ids).save(f"{folder}/pybullet_{index}_ids.png", compress_level=1)
    print(json.dumps({"seconds": time.monotonic() - began, "version": str(pybullet.getAPIVersion())}))


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
