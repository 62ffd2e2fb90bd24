"""What real cameras cost beside a pinhole: lenses with distortion, motion blur, a rolling shutter.

  cameras.py PROGRAM RESULTS [--rounds 3]

PROGRAM is `generate`. The bundled example at 640 x 480, COCO and Yolo, exact masks. Measured is
processor time, camera after camera, several times over, so that what else runs on the machine
matters little. RESULTS gets cameras.json and cameras.md.
"""

import argparse
import json
import math
import os
import resource
import statistics
import subprocess
import tempfile

import yaml

HERE = os.path.dirname(os.path.abspath(__file__))
EXAMPLE = f"{HERE}/../../config/example.yaml"
RATE = 10.0  # [Hz]
FEW, MANY = 1.0, 5.0  # [s] of the recording: the difference is without the start

WIDE = math.radians(140.0)
PINHOLE = (474.0, "plumb_bob", [0.0] * 5)
CAMERAS = {  # focal length [px], distortion, effects
    "pinhole": (PINHOLE, {}),
    "plumb_bob, k1 -0.28": ((474.0, "plumb_bob", [-0.28, 0.0, 0.0, 0.0, 0.0]), {}),
    "equidistant, 140 degrees": ((640.0 / WIDE, "equidistant", [0.0] * 4), {}),
    "motion blur, 8 samples": (PINHOLE, {"exposure_time": 0.02, "motion_samples": 8}),
    "rolling shutter, 24 bands": (PINHOLE, {"readout_time": 0.03, "readout_bands": 24}),
}


def write_calibration(lens, path):
    focal_length, model, coefficients = lens
    matrix = [focal_length, 0.0, 319.5, 0.0, focal_length, 239.5, 0.0, 0.0, 1.0]
    with open(path, "w") as out:
        json.dump({"image_width": 640, "image_height": 480, "camera_name": "benchmark",
                   "camera_matrix": {"rows": 3, "cols": 3, "data": matrix},
                   "distortion_model": model,
                   "distortion_coefficients": {"rows": 1, "cols": len(coefficients),
                                               "data": coefficients}}, out)


def settings_of(lens, effects, folder):
    with open(EXAMPLE) as file:
        settings = yaml.safe_load(file)
    write_calibration(lens, f"{folder}/camera.yaml")
    del settings["bounding_shape"]
    settings.update({
        "simulated_rate": RATE, "output_folder": f"{folder}/dataset", "if_exists": "overwrite",
        "writers": [{"name": "coco", "type": "synthetic_dataset/Coco"},
                    {"name": "yolo", "type": "synthetic_dataset/Yolo"}],
        "camera": {"info_file": f"{folder}/camera.yaml", "effects": effects}})
    return settings


def run(program, settings, folder):
    """The processor time of the whole process [s], and the number of scenes."""
    path = f"{folder}/settings.yaml"
    with open(path, "w") as out:
        yaml.safe_dump(settings, out)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "--config", path], check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime, len(os.listdir(f"{folder}/dataset/coco/images"))


def scene_seconds(program, camera, folder):
    """Processor time of a scene, without the start."""
    settings = settings_of(*CAMERAS[camera], folder)
    few, few_scenes = run(program, {**settings, "duration": FEW}, folder)
    many, many_scenes = run(program, {**settings, "duration": MANY}, folder)
    return (many - few) / (many_scenes - few_scenes)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("results")
    parser.add_argument("--rounds", type=int, default=3)
    arguments = parser.parse_args()
    os.makedirs(arguments.results, exist_ok=True)
    seconds = {camera: [] for camera in CAMERAS}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(arguments.rounds):
            for camera, measured in seconds.items():
                measured.append(scene_seconds(arguments.program, camera, folder))
    best = {camera: statistics.median(measured) for camera, measured in seconds.items()}
    with open(f"{arguments.results}/cameras.json", "w") as out:
        json.dump(seconds, out, indent=1)
    with open(f"{arguments.results}/cameras.md", "w") as out:
        out.write("| camera | processor time of a scene | as a multiple of the pinhole's |\n"
                  "| --- | --- | --- |\n")
        for camera, each in best.items():
            row = f"| {camera} | {1000 * each:.0f} ms | {each / best['pinhole']:.1f} |"
            print(row, flush=True)
            out.write(row + "\n")


if __name__ == "__main__":
    main()
