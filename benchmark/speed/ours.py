"""The settings with which synthetic_dataset makes the room's dataset, and its runs."""

import json
import os
import subprocess
import tempfile
import time

from room import camera_rotation, quaternion, RATE

# The writers: only the picture; three formats with depth and exact masks (as files and as polygons);
# and three formats with masks by background subtraction.
IMAGE = ["detect"]
EXACT = ["bop", "coco", "detect"]
SUBTRACTED = ["stvnet", "coco", "detect"]
TYPES = {"coco": "Coco", "detect": "UltralyticsYolo", "bop": "Bop", "stvnet": "StvNet"}
PARAMETERS = {"detect": {"task": "detect"}}


def settings(scene, folder, output, writers, mog2=False, bare=False, **more):
    """The content of a settings file. Bare pictures have no shadows and one sample per pixel, like the
    floor's."""
    objects = [f"object{i}" for i in range(len(scene["models"]))]
    half = 0.43 * scene["scale"]
    result = {
        "bag_file": f"{folder}/motion.bag", "simulated_rate": RATE, "global_frame": "map",
        "world": {"file": f"{folder}/{'bare_room' if bare else 'room'}.sdf"},
        "output_folder": output, "if_exists": "overwrite",
        "camera": {"pose": list(scene["camera"]) + quaternion(camera_rotation()),
                   "info_file": f"{folder}/camera.yaml"},
        "masks": {"method": "mog2" if mog2 else "exact"},
        "robot_list": objects,
        "writers": [{"name": name, "type": f"synthetic_dataset/{TYPES[name]}"} for name in writers],
    }
    if mog2:
        result["background_subtractor"] = {"history_length": 1, "var_threshold": 16.0,
                                           "detect_shadows": False}
    if bare:
        result["rendering"] = {"samples": 1}
    for name in writers:
        result[name] = dict(PARAMETERS.get(name, {}))
    for name in objects:
        corners = [[x, y, z] for x in (-half, half) for y in (-half, half) for z in (-half, half)]
        result[name] = {"class": "sphere", "id": name, "frame_id": "base",
                        "keypoints": [[half, 0.0, 0.0], [0.0, half, 0.0]], "bounding_shape": corners}
    result.update(more)
    return result


def write_camera(scene, folder):
    width, height, focal = scene["width"], scene["height"], scene["focal"]
    cx, cy = (width - 1) / 2, (height - 1) / 2
    matrix = [focal, 0.0, cx, 0.0, focal, cy, 0.0, 0.0, 1.0]
    projection = [focal, 0.0, cx, 0.0, 0.0, focal, cy, 0.0, 0.0, 0.0, 1.0, 0.0]
    with open(f"{folder}/camera.yaml", "w") as out:
        json.dump({
            "image_width": width, "image_height": height, "camera_name": "room",
            "camera_matrix": {"rows": 3, "cols": 3, "data": matrix},
            "distortion_model": "plumb_bob",
            "distortion_coefficients": {"rows": 1, "cols": 5, "data": [0.0] * 5},
            "rectification_matrix": {"rows": 3, "cols": 3,
                                     "data": [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]},
            "projection_matrix": {"rows": 3, "cols": 4, "data": projection}}, out)


def set_aside(output):
    """Moves an existing dataset out of the way instead of deleting it: for minutes after many files
    were deleted, ext4 takes longer to create new ones."""
    if os.path.exists(output):
        os.rename(output, tempfile.mkdtemp(prefix="earlier_", dir=os.path.dirname(output)))


def run(program, parameters, folder, before=(), keep=False):
    """Makes a dataset from scratch or, with `keep`, on top of what is there.

    Returns the time [s] and the peak memory [byte] of the whole process. `before` is a program,
    with arguments, that starts ours.
    """
    if not keep:
        set_aside(parameters["output_folder"])
    with open(f"{folder}/settings.yaml", "w") as out:
        json.dump(parameters, out)
    began = time.monotonic()
    process = subprocess.Popen([*before, program, "--config", f"{folder}/settings.yaml"],
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    log = process.stdout.read().decode(errors="replace")
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise RuntimeError(log)
    return time.monotonic() - began, 1024 * usage.ru_maxrss


def seconds_of(program, scene, folder, writers, count, **more):
    """The time of the whole process [s], with so many scenes."""
    return run(program, settings(scene, folder, f"{folder}/dataset", writers,
                                 duration=(count - 0.5) / RATE, **more), folder)[0]
