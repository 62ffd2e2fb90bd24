"""The room drawn by BlenderProc with Cycles: colour, depth and instances. BlenderProc writes COCO; depth is written
as a 16-bit PNG.

  blenderproc_rival.py FOLDER SCENES SAMPLES     prints the seconds from the first scene to the last, as JSON

With one sample per pixel nothing is denoised; with more, Intel's denoiser is used. The interpreter needs
blenderproc_requirements.txt: BlenderProc, and Blender as a Python module instead of the one that it would download.
"""

import importlib
import json
import os
import sys
import tempfile
import time

# BlenderProc's start-up is made for the Python of the Blender that it downloads: it installs packages there, and
# removes the folder of its own package from the path.
os.environ["OUTSIDE_OF_THE_INTERNAL_BLENDER_PYTHON_ENVIRONMENT_BUT_IN_RUN_SCRIPT"] = "1"
import bpy
import blenderproc as bproc
from blenderproc.python.utility.SetupUtility import SetupUtility

SetupUtility.setup_pip = lambda *_, **__: ""
SetupUtility.main_setup_called = True
SetupUtility.setup_utility_paths(tempfile.mkdtemp())
sys.path.append(os.path.dirname(os.path.dirname(bproc.__file__)))
os.environ["INSIDE_OF_THE_INTERNAL_BLENDER_PYTHON_ENVIRONMENT"] = "1"
bproc = importlib.reload(bproc)

import cv2
import numpy as np
from blenderproc.python.utility.Initializer import _Initializer

DEPTH_UNIT = 0.001  # [m]
# In Blender, a sun of strength pi makes a matte white surface that faces it exactly white.
SUN_STRENGTH = np.pi


def init():
    """Replaces bproc.init(), which fails as Blender from PyPI has no languages to choose from."""
    bproc.clean_up(clean_up_camera=True)
    bpy.context.scene.render.engine = "CYCLES"
    bproc.renderer.set_render_devices()
    _Initializer.set_default_parameters()


def build(scene):
    """Builds the room, and returns the objects in it."""
    for name, size, centre, colour in scene["walls"]:
        wall = bproc.object.create_primitive("CUBE", scale=[each / 2 for each in size], location=centre)
        wall.set_cp("category_id", 0)
        material = bproc.material.create(name)
        material.set_principled_shader_value("Base Color", [*(each ** 2.2 for each in colour), 1.0])
        wall.replace_materials(material)
    objects = []
    for model in scene["models"]:
        loaded, = bproc.loader.load_obj(model)
        loaded.set_scale([scene["scale"]] * 3)
        loaded.set_cp("category_id", 1)
        objects.append(loaded)
    direction = np.array(scene["light_direction"])
    sun = bproc.types.Light("SUN")
    sun.set_energy(SUN_STRENGTH * scene["sun"])
    sun.set_rotation_mat(bproc.camera.rotation_from_forward_vec(direction / np.linalg.norm(direction)))
    bproc.renderer.set_world_background([scene["ambient"] ** 2.2] * 3)
    return objects


def set_up_renderer(samples):
    bproc.renderer.enable_depth_output(activate_antialiasing=False)
    bproc.renderer.enable_segmentation_output(map_by=["category_id", "instance"], default_values={"category_id": 0})
    bproc.renderer.set_max_amount_of_samples(samples)
    bproc.renderer.set_denoiser("INTEL" if samples > 1 else None)


def draw(scene, objects, pose, indices, folder):
    bproc.utility.reset_keyframes()
    for frame, index in enumerate(indices):
        for each, (x, y, z, yaw) in zip(objects, scene["scenes"][index % len(scene["scenes"])]):
            each.set_location([x, y, z], frame=frame)
            each.set_rotation_euler([0.0, 0.0, yaw], frame=frame)
        bproc.camera.add_camera_pose(pose, frame=frame)
    data = bproc.renderer.render()
    bproc.writer.write_coco_annotations(folder, instance_segmaps=data["instance_segmaps"],
                                        instance_attribute_maps=data["instance_attribute_maps"],
                                        colors=data["colors"], color_file_format="PNG")
    for index, depth in zip(indices, data["depth"]):
        units = np.clip(np.rint(depth / DEPTH_UNIT), 0, 65535).astype(np.uint16)
        cv2.imwrite(f"{folder}/depth_{index}.png", units, [cv2.IMWRITE_PNG_COMPRESSION, 1])


def main(folder, count, samples):
    with open(f"{folder}/scene.json") as source:
        scene = json.load(source)
    init()
    objects = build(scene)
    set_up_renderer(samples)
    cx, cy = (scene["width"] - 1) / 2, (scene["height"] - 1) / 2
    bproc.camera.set_intrinsics_from_K_matrix([[scene["focal"], 0.0, cx], [0.0, scene["focal"], cy], [0.0, 0.0, 1.0]],
                                              scene["width"], scene["height"])
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = scene["rotation"], scene["camera"]
    pose = bproc.math.change_source_coordinate_frame_of_transformation_matrix(pose, ["X", "-Y", "-Z"])
    output = tempfile.mkdtemp(prefix="blenderproc_", dir=folder)
    draw(scene, objects, pose, [0], output)  # a warm-up
    began, began_work = time.monotonic(), time.process_time()
    draw(scene, objects, pose, range(1, count + 1), output)
    print(json.dumps({"seconds": time.monotonic() - began,
                      "processor_seconds": time.process_time() - began_work,
                      "version": bproc.__version__, "blender": bpy.app.version_string}), flush=True)
    os._exit(0)  # Blender as a module crashes when it is unloaded


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
