"""Measures what a dataset costs besides its scenes: start, second core, memory, disk, manifest, resuming.

  costs.py PROGRAM RESULTS [--scenes 100 1000]

PROGRAM is `generate`. It makes the room with four objects, exact masks and depth in three formats,
at 640 x 480. RESULTS gets costs.json and costs.md.
"""

import argparse
import json
import os
import subprocess
import tempfile
import time

import ours
import room

OBJECTS = 4
SIZE = (640, 480)
SCENES = 60  # in measurements that are made once for each setting


class Run:
    """Runs the program in a folder with the room's files."""

    def __init__(self, program, folder, scene):
        self.program, self.folder, self.scene = program, folder, scene
        self.output = f"{folder}/dataset"

    def __call__(self, count, keep=False, before=(), **settings):
        """The time [s] and the peak memory [byte] of the whole process."""
        parameters = ours.settings(self.scene, self.folder, self.output, ours.EXACT,
                                   duration=(count - 0.5) / room.RATE, **settings)
        return ours.run(self.program, parameters, self.folder, before, keep)

    def scene_seconds(self, **settings):
        """The time of a scene [s], without the start; the best of three."""
        few = min(self(5, **settings)[0] for _ in range(3))
        many = min(self(5 + SCENES, **settings)[0] for _ in range(3))
        return (many - few) / SCENES


def example_seconds(program, folder):
    """The time [s] of a run of the bundled example with one scene; the best of five."""
    config = os.path.join(os.path.dirname(__file__), "../../config/example.yaml")
    command = [program, "--config", config, f"output_folder:={folder}/example", "duration:=0.5"]
    seconds = []
    for _ in range(5):
        ours.set_aside(f"{folder}/example")
        began = time.monotonic()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        seconds.append(time.monotonic() - began)
    return min(seconds)


def bytes_below(folder):
    return sum(os.path.getsize(os.path.join(path, name))
               for path, _, names in os.walk(folder) for name in names)


def measure(run, scene_counts):
    rows = []

    def add(what, value):
        rows.append([what, value])
        print(f"{what}: {value}", flush=True)

    add("from the program's start to its end, with one scene",
        f"{min(run(1)[0] for _ in range(5)):.2f} s")
    add("the bundled example from the program's start to its end, with one scene",
        f"{example_seconds(run.program, run.folder):.2f} s")
    two = run.scene_seconds()
    add("a scene", f"{1000 * two:.1f} ms")
    one = run.scene_seconds(before=("taskset", "-c", str(min(os.sched_getaffinity(0)))))
    add("a scene on one core", f"{1000 * one:.1f} ms, {one / two:.2f} times as long as on all cores")
    for sync in ("off", "scene"):
        seconds = run.scene_seconds(sync=sync)
        add(f"a scene with `sync: {sync}`", f"{seconds / two:.2f} times as long as with `batch`")
    full = run.scene_seconds(rendering={"light": "full"})
    add("a scene with `rendering/light: full`", f"{full / two:.2f} times as long")
    fresh = run.scene_seconds(rendering={"reuse": False})
    add("a scene with `rendering/reuse: false`", f"{fresh / two:.2f} times as long")
    for count in scene_counts:
        seconds, memory = run(count)
        on_disk = bytes_below(run.output)
        manifest = os.path.getsize(f"{run.output}/manifest.sqlite")
        add(f"{count} scenes", f"{1000 * seconds / count:.1f} ms a scene with the start, "
            f"{memory / 1e6:.0f} MB of memory, {on_disk / count / 1000:.0f} kB of files a scene, of "
            f"which the manifest has {manifest / count / 1000:.1f} kB")
        seconds, _ = run(count, keep=True, if_exists="resume")
        add(f"the same again, where all {count} scenes are there", f"{seconds:.2f} s")
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("results")
    parser.add_argument("--scenes", type=int, nargs="+", default=[100, 1000])
    arguments = parser.parse_args()
    os.makedirs(arguments.results, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        scene = room.write(folder, OBJECTS, max([*arguments.scenes, SCENES + 5]), *SIZE)
        ours.write_camera(scene, folder)
        rows = measure(Run(arguments.program, folder, scene), arguments.scenes)
    with open(f"{arguments.results}/costs.json", "w") as out:
        json.dump(dict(rows), out, indent=1)
    with open(f"{arguments.results}/costs.md", "w") as out:
        out.write("| what | measured |\n| --- | --- |\n")
        out.writelines(f"| {what} | {value} |\n" for what, value in rows)


if __name__ == "__main__":
    main()
