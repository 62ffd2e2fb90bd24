"""The room drawn by MuJoCo with OSMesa: colour and segmentation, each saved as a PNG.

  mujoco_rival.py FOLDER SCENES     prints the seconds from the first scene to the last, as JSON
"""

import json
import os
import sys
import time

os.environ["MUJOCO_GL"] = "osmesa"
import mujoco  # noqa: E402: it reads MUJOCO_GL
import numpy as np
from PIL import Image


def mjcf(scene):
    text = lambda values: " ".join(str(value) for value in values)
    half = lambda size: [value / 2 for value in size]
    fovy = np.degrees(2 * np.arctan(scene["height"] / 2 / scene["focal"]))
    rotation = np.array(scene["rotation"])
    axes = text([*rotation[:, 0], *-rotation[:, 1]])  # MuJoCo's cameras have y up
    kinds = sorted(set(zip(scene["models"], scene["pictures"])))
    assets = "".join(
        f"<mesh name='{model}' file='{model}' scale='{scene['scale']} {scene['scale']} {scene['scale']}'/>"
        f"<texture name='{picture}' type='2d' file='{picture}'/>"
        f"<material name='{picture}' texture='{picture}'/>" for model, picture in kinds)
    walls = "".join(f"<geom type='box' size='{text(half(size))}' pos='{text(centre)}' rgba='{text(colour)} 1'/>"
                    for _, size, centre, colour in scene["walls"])
    bodies = "".join(
        f"<body mocap='true' pos='0 0 1'><geom type='mesh' mesh='{model}' material='{picture}' contype='0' "
        f"conaffinity='0'/></body>" for model, picture in zip(scene["models"], scene["pictures"]))
    return f"""<mujoco><visual><global offwidth='{scene['width']}' offheight='{scene['height']}'/>
<quality shadowsize='2048' offsamples='4'/></visual><asset>{assets}</asset><worldbody>
<light directional='true' castshadow='true' pos='0 0 6' dir='{text(scene['light_direction'])}'/>
<camera name='camera' pos='{text(scene['camera'])}' xyaxes='{axes}' fovy='{fovy}'/>
{walls}{bodies}</worldbody></mujoco>"""


def main(folder, count):
    with open(f"{folder}/scene.json") as source:
        scene = json.load(source)
    model = mujoco.MjModel.from_xml_string(mjcf(scene))
    data = mujoco.MjData(model)
    renderer = mujoco.Renderer(model, scene["height"], scene["width"])
    began = 0.0
    for index in range(count + 1):  # the first is a warm-up
        if index == 1:
            began = time.monotonic()
        for number, (x, y, z, yaw) in enumerate(scene["scenes"][index % len(scene["scenes"])]):
            data.mocap_pos[number] = (x, y, z)
            data.mocap_quat[number] = (np.cos(yaw / 2), 0, 0, np.sin(yaw / 2))
        mujoco.mj_kinematics(model, data)
        mujoco.mj_camlight(model, data)
        renderer.disable_segmentation_rendering()
        renderer.update_scene(data, camera="camera")
        picture = renderer.render()
        renderer.enable_segmentation_rendering()
        renderer.update_scene(data, camera="camera")
        ids = renderer.render()
        Image.fromarray(picture).save(f"{folder}/mujoco_{index}.png", compress_level=1)
        Image.fromarray(ids[:, :, 0].astype(np.uint8)).save(f"{folder}/mujoco_{index}_ids.png",
                                                            compress_level=1)
    print(json.dumps({"seconds": time.monotonic() - began, "version": mujoco.__version__}))
    sys.stdout.flush()
    os._exit(0)  # its OSMesa context cannot be freed at the end


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
