"""Measures what real cameras cost compared with a pinhole: lens distortion, motion blur, rolling shutters,
background subtraction, several cameras, full light, many point lights, skies and panoramas, weather. Each is measured for a
camera that stands, one on a swinging mast, and one on a rover.

  cameras.py PROGRAM RESULTS [--rounds 3] [--only TEXT] [--world FILE [--models FOLDER]]

PROGRAM is `generate`. It makes the bundled example at 640 x 480, with COCO and Yolo and exact masks. In the example the
camera is on a mast, which pans. Here the mast stands, or swings by 0.3 m with the camera on it (`rides`). A camera that
drives is on a rover and looks to its right, where the other objects are. --world adds a row with the example's objects
and cameras in that world. Measures user processor time and wall-clock time per instant, one camera after the other and
several times over, so that other load on the machine matters little; for the wall-clock time, nothing else should run.
RESULTS gets cameras.json and cameras.md.
"""

import argparse
import copy
import json
import math
import os
import resource
import sqlite3
import statistics
import struct
import subprocess
import tempfile
import time
import zlib

import rosbag
import yaml

HERE = os.path.dirname(os.path.abspath(__file__))
PACKAGE = os.path.realpath(f"{HERE}/../..")
EXAMPLE = f"{PACKAGE}/config/example.yaml"
RATE = 10.0  # [Hz]
FEW, MANY = 1.0, 5.0  # [s] of the recording: the difference between the two runs excludes the start

SWING = 0.3  # [m]
SWINGS = 0.5  # [Hz]

WIDE = math.radians(140.0)
PINHOLE = (474.0, "plumb_bob", [0.0] * 5)
BARREL = (474.0, "plumb_bob", [-0.28, 0.0, 0.0, 0.0, 0.0])
FISHEYE = (640.0 / WIDE, "equidistant", [0.0] * 4)
BEHIND = (640.0 / math.radians(190.0), "equidistant", [0.0] * 4)
BLUR = {"exposure_time": 0.02, "motion_samples": 8}
ROLLING = {"readout_time": 0.03, "readout_bands": 24}
SUBTRACTION = {"masks": {"method": "mog2"}}
SAMPLE = {"look_at": "any", "distance": {"uniform": [1.5, 4.0]}, "elevation": {"uniform": [0.1, 0.9]}}
FULL = {"rendering": {"light": "full"}}
CAMERAS = {  # lens: focal length [px], distortion; effects; other settings
    "pinhole": (PINHOLE, {}, {}),
    "plumb_bob, k1 -0.28": (BARREL, {}, {}),
    "equidistant, 140 degrees": (FISHEYE, {}, {}),
    "equidistant, 190 degrees": (BEHIND, {}, {}),
    "motion blur, 8 samples": (PINHOLE, BLUR, {}),
    "rolling shutter, 24 bands": (PINHOLE, ROLLING, {}),
    "MOG2": (PINHOLE, {}, SUBTRACTION),
    "full light": (PINHOLE, {}, FULL),
    "full light through plumb_bob": (BARREL, {}, FULL),
    "30 more lights": (PINHOLE, {}, {"lights": 30}),
    "300 more lights": (PINHOLE, {}, {"lights": 300}),
    "sky": (PINHOLE, {}, {"sky": True}),
    "full light, sky": (PINHOLE, {}, {"sky": True, **FULL}),
    "panorama": (PINHOLE, {}, {"panorama": True}),
    "full light, panorama": (PINHOLE, {}, {"panorama": True, **FULL}),
    "weather, fog": (PINHOLE, {}, {"randomize": {"weather": {"visibility": 50.0}}}),
    "weather, rain 20 mm/h": (PINHOLE, {}, {"randomize": {"weather": {"rain": 20.0}}}),
    "weather, snow 1 mm/h": (PINHOLE, {}, {"randomize": {"weather": {"snow": 1.0}}}),
    "four cameras": (PINHOLE, {}, {"count": 4}),
    "another pose in each scene": (PINHOLE, {}, {"sample": SAMPLE}),
}
MODELS = {"rover_1": "model://rover", "rover_2": "model://rover", "drone_1": "model://drone"}
STANDS, RIDES, DRIVES = "stands", "rides", "drives"
ON_ROVER = {"mounted_on": "rover_1", "pose": {"position": [0.0, -0.5, 0.6], "rpy": [0.0, 0.1, -math.pi / 2.0]}}


def write_calibration(lens, path):
    focal_length, model, coefficients = lens
    matrix = [focal_length, 0.0, 319.5, 0.0, focal_length, 239.5, 0.0, 0.0, 1.0]
    with open(path, "w") as out:
        json.dump({"image_width": 640, "image_height": 480, "camera_name": "benchmark",
                   "camera_matrix": {"rows": 3, "cols": 3, "data": matrix},
                   "distortion_model": model,
                   "distortion_coefficients": {"rows": 1, "cols": len(coefficients),
                                               "data": coefficients}}, out)


def write_with_mast(source, path, swing):
    """Writes the recording with a mast that stays at its first pose, or swings there by so many metres."""
    first = None
    with rosbag.Bag(source) as bag, rosbag.Bag(path, "w") as out:
        for topic, message, stamp in bag.read_messages():
            for each in message.transforms if topic == "/tf" else []:
                if each.child_frame_id == "camera/mast":
                    first = first or each.transform
                    each.transform = copy.deepcopy(first)
                    phase = 2.0 * math.pi * SWINGS * each.header.stamp.to_sec()
                    each.transform.translation.y += swing * math.sin(phase)
            out.write(topic, message, stamp)


def write_panorama(folder):
    """Writes a picture of 2048 x 1024 pixels with a gradient."""
    rows = [b"\0" + bytes((row // 4, column // 8 % 256, 200)[channel] for column in range(2048)
                          for channel in range(3)) for row in range(1024)]

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    os.makedirs(folder, exist_ok=True)
    with open(f"{folder}/panorama.png", "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n"
                  + chunk(b"IHDR", struct.pack(">IIBBBBB", 2048, 1024, 8, 2, 0, 0, 0))
                  + chunk(b"IDAT", zlib.compress(b"".join(rows))) + chunk(b"IEND", b""))


def point_light(number, count):
    """One of many point lights under the hall's ceiling; it reaches 3 m and lights a part of the floor."""
    columns = math.ceil(math.sqrt(count))
    x, y = ((each + 0.5) / columns * 12.0 - 6.0 for each in divmod(number, columns))
    return (f"<light name='light_{number}' type='point'><pose>{x} {y} 2.5 0 0 0</pose><cast_shadows>false</cast_shadows>"
            "<diffuse>0.2 0.2 0.2 1</diffuse><attenuation><range>3</range><constant>0.5</constant><linear>0.1</linear>"
            "<quadratic>0.2</quadratic></attenuation></light>")


def what_lies_behind(others, settings, folder):
    """Settings for a sky, point lights or a panorama, if `others` contain one; these entries are removed."""
    sky, lights = others.pop("sky", False), others.pop("lights", 0)
    if sky or lights:
        with open(settings["world"]["file"]) as file:
            world = file.read()
        if sky:
            world = world.replace("<scene>", "<scene><sky/>", 1)
        world = world.replace("</world>", "".join(point_light(i, lights) for i in range(lights)) + "</world>")
        with open(f"{folder}/world.sdf", "w") as out:
            out.write(world)
        return {"world": {**settings["world"], "file": f"{folder}/world.sdf"}}
    if others.pop("panorama", False):
        write_panorama(f"{folder}/panoramas")
        return {"randomize": {"background": {"pictures": f"{folder}/panoramas", "projection": "panorama"}}}
    return {}


def camera_settings(calibration, effects, count, sample, how):
    camera = {"info_file": calibration, "effects": effects}
    if how == DRIVES:
        return {"camera": {**camera, **ON_ROVER}}
    if sample:
        return {"camera": {**camera, "sample": sample}}
    if count == 1:
        return {"camera": camera}
    corners = [[4.0, 3.0], [-4.0, 3.0], [-4.0, -3.0], [4.0, -3.0]]
    return {"cameras": {f"camera_{i}": {**camera, "pose": {"position": [x, y, 3.0],
                                                           "look_at": [0.0, 0.0, 0.0]}}
                        for i, (x, y) in enumerate(corners[:count])}}


def settings_of(camera, how, bag, folder):
    lens, effects, others = camera
    with open(EXAMPLE) as file:
        settings = yaml.safe_load(file.read().replace("$(find synthetic_dataset)", PACKAGE))
    if "world" in camera[2]:  # a different world, which lacks the example's models
        for name, model in MODELS.items():
            settings[name]["model"] = model
    calibration = f"{folder}/camera.yaml"
    write_calibration(lens, calibration)
    others = dict(others)
    count, sample = others.pop("count", 1), others.pop("sample", None)
    others.update(what_lies_behind(others, settings, folder))
    for name in ["bounding_shape", "camera"] + ([] if count == 1 and not sample and how != DRIVES else ["camera_frame_id"]):
        del settings[name]
    settings.update({
        "bag_file": bag, "simulated_rate": RATE, "output_folder": f"{folder}/dataset",
        "if_exists": "overwrite",
        "writers": [{"name": "coco", "type": "synthetic_dataset/Coco"},
                    {"name": "yolo", "type": "synthetic_dataset/Yolo"}],
        **camera_settings(calibration, effects, count, sample, how), **others})
    return settings


def run(program, settings, folder):
    """User processor time and wall-clock time of the whole process [s], and the number of instants."""
    path = f"{folder}/settings.yaml"
    with open(path, "w") as out:
        yaml.safe_dump(settings, out)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    began = time.monotonic()
    subprocess.run([program, "--config", path], check=True, stdout=subprocess.DEVNULL)
    clock = time.monotonic() - began
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    with sqlite3.connect(f"{folder}/dataset/manifest.sqlite") as manifest:
        instants, = manifest.execute("SELECT count(DISTINCT instant) FROM scene").fetchone()
    return (after.ru_utime - before.ru_utime, clock), instants


def instant_seconds(program, camera, how, bag, folder):
    """User processor time and wall-clock time per instant, without the start [s]."""
    settings = settings_of(camera, how, bag, folder)
    few, few_instants = run(program, {**settings, "duration": FEW}, folder)
    many, many_instants = run(program, {**settings, "duration": MANY}, folder)
    return [(b - a) / (many_instants - few_instants) for a, b in zip(few, many)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("results")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", default="", help="cameras with one of these texts, divided by semicolons, in their names, and the pinhole")
    parser.add_argument("--world", help="a world for a row of its own")
    parser.add_argument("--models", help="the folder of that world's models")
    arguments = parser.parse_args()
    os.makedirs(arguments.results, exist_ok=True)
    cameras = dict(CAMERAS)
    if arguments.world:
        world = {"file": os.path.abspath(arguments.world),
                 "model_folders": [f"{PACKAGE}/worlds/models"] + ([os.path.abspath(arguments.models)] if arguments.models else [])}
        cameras[f"pinhole in {os.path.basename(arguments.world)}"] = (PINHOLE, {}, {"world": world})
    chosen = [each for each in cameras if each == "pinhole" or any(text in each for text in arguments.only.split(";"))]
    # Four cameras only stand, and a random pose, which changes in each scene, is only measured with `rides`.
    rows = [(name, how) for name in chosen for how in (STANDS, RIDES, DRIVES)
            if (how == STANDS or "count" not in cameras[name][2])
            and (how == RIDES or "sample" not in cameras[name][2])]
    seconds = {row: [] for row in rows}
    with tempfile.TemporaryDirectory() as folder:
        recording = f"{PACKAGE}/worlds/example.bag"
        bags = {STANDS: f"{folder}/standing.bag", RIDES: f"{folder}/swinging.bag", DRIVES: recording}
        write_with_mast(recording, bags[STANDS], 0.0)
        write_with_mast(recording, bags[RIDES], SWING)
        for _ in range(arguments.rounds):
            for (name, how), measured in seconds.items():
                measured.append(instant_seconds(arguments.program, cameras[name], how, bags[how], folder))
    typical = {row: [statistics.median(each) for each in zip(*measured)] for row, measured in seconds.items()}
    units = typical["pinhole", STANDS]
    with open(f"{arguments.results}/cameras.json", "w") as out:
        json.dump({f"{name}, {how}": each for (name, how), each in seconds.items()}, out, indent=1)
    with open(f"{arguments.results}/cameras.md", "w") as out:
        out.write(f"As multiples of the standing pinhole's {1000 * units[0]:.0f} ms of processor time and "
                  f"{1000 * units[1]:.0f} ms of the clock an instant, in this order:\n\n"
                  "| camera | it stands | it rides | it drives |\n| --- | --- | --- | --- |\n")
        for name in chosen:
            cells = [", ".join(f"{each / unit:.1f}" for each, unit in zip(typical[name, how], units))
                     if (name, how) in typical else "-" for how in (STANDS, RIDES, DRIVES)]
            row = f"| {name} | {' | '.join(cells)} |"
            print(row, flush=True)
            out.write(row + "\n")


if __name__ == "__main__":
    main()
