"""Measures how fast scenes are made, compared with alternatives, on the same scene in the same run.

  run.py PROGRAMS RESULTS [--objects 1 4 16 64] [--scenes 40] [--rounds 3] [--blenderproc PYTHON]

PROGRAMS is the folder `lib` of a workspace's devel space. All programs take turns in each round, so that other load on
the machine affects all equally; the best time of each counts. RESULTS gets results.json, table.md and, with matplotlib,
plot.png. BlenderProc takes part if an interpreter with blenderproc_requirements.txt is given.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile

import ours
import room

HERE = os.path.dirname(os.path.abspath(__file__))
RIVALS = ["mujoco", "pybullet", "pyrender"]
BLENDERPROC = {"BlenderProc, 1 sample": ("1", 10), "BlenderProc, 16 samples": ("16", 3)}  # samples, scenes
FLOOR = "floor"  # a bare OpenGL program
SAME = "floor, with shadows and smooth edges"  # the same picture as ours, drawn in the usual way
OURS = {"image": (ours.IMAGE, {}), "image, masks, depth": (ours.EXACT, {}),
        "the same, drawn as bare as the floor": (ours.EXACT, {"bare": True}),
        "image, MOG2 masks": (ours.SUBTRACTED, {"mog2": True})}


def scene_seconds(command, folder, scenes, *more):
    """Seconds per scene of a program whose last line has the seconds for so many scenes, as JSON."""
    done = subprocess.run([*command, folder, str(scenes), *more], stdout=subprocess.PIPE, text=True,
                          check=True)
    return json.loads(done.stdout.strip().splitlines()[-1])["seconds"] / scenes


def measure(programs, folder, objects, size, arguments):
    """The best time per scene [s] of each program and kind of output; ours is the difference between
    a long and a short run, which excludes the start."""
    few = 5
    many = few + arguments.scenes * max(1, 16 // objects)  # quick scenes are hard to tell from the start's noise
    scene = room.write(folder, objects, many, *size)
    ours.write_camera(scene, folder)
    best = {}

    def keep(key, seconds):
        best[key] = min(best.get(key, seconds), seconds)

    for _ in range(arguments.rounds):
        for name, (writers, how) in OURS.items():
            for count in (few, many):
                keep((name, count), ours.seconds_of(f"{programs}/synthetic_dataset/generate", scene, folder, writers,
                                                    count, **how))
        keep((FLOOR, None), scene_seconds([f"{programs}/synthetic_dataset_tests/benchmark_floor"], folder, many))
        keep((SAME, None), scene_seconds([f"{programs}/synthetic_dataset_tests/benchmark_floor"], folder, many // 4, "same"))
        for name in RIVALS if size == (640, 480) else []:
            keep((name, None), scene_seconds([sys.executable, f"{HERE}/{name}_rival.py"], folder,
                                            max(arguments.scenes // 4, 5)))
        for name, (samples, scenes) in BLENDERPROC.items() if arguments.blenderproc and size == (640, 480) else []:
            keep((name, None), scene_seconds([arguments.blenderproc, f"{HERE}/blenderproc_rival.py"], folder, scenes,
                                            samples))
    result = {name: (best[name, many] - best[name, few]) / (many - few) for name in OURS}
    result.update({name: seconds for (name, count), seconds in best.items() if count is None})
    return result


def table(results):
    lines = ["| objects | size | what | ms a scene | scenes/s | times the speed of MuJoCo | PyBullet | pyrender "
             "| the floor | the floor, with shadows and smooth edges | BlenderProc, 1 sample | 16 samples |",
             "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    for result in results:
        best = result["seconds"]
        for name, seconds in best.items():
            ratios = [f"{best[rival] / seconds:.2f}" if rival in best else ""
                      for rival in [*RIVALS, FLOOR, SAME, *BLENDERPROC]]
            lines.append(f"| {result['objects']} | {result['width']}x{result['height']} | {name} | "
                         f"{1000 * seconds:.1f} | {1 / seconds:.1f} | {' | '.join(ratios)} |")
    return "\n".join(lines) + "\n"


def plot(results, file):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(8, 4))
    small = [result for result in results if result["width"] == 640]
    for name in [each for each in [*OURS, FLOOR, SAME, *RIVALS, *BLENDERPROC] if each in small[0]["seconds"]]:
        axes.loglog([result["objects"] for result in small],
                    [1 / result["seconds"][name] for result in small],
                    marker="o", linestyle="-" if name in OURS else "--", label=name)
    axes.set(xlabel="objects of 5,000 triangles", ylabel="scenes a second, 640 x 480")
    counts = [result["objects"] for result in small]
    axes.set_xticks(counts, labels=[str(count) for count in counts])
    axes.minorticks_off()
    axes.yaxis.set_major_formatter("{x:g}")
    axes.grid(alpha=0.3)
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    figure.tight_layout()
    figure.savefig(file, dpi=100)


def has_blenderproc(python):
    """Whether BlenderProc can take part; prints why not."""
    if not python:
        print("no BlenderProc: --blenderproc names no interpreter that has it")
        return False
    look = "from importlib.metadata import version; version('blenderproc'), version('bpy')"
    done = subprocess.run([python, "-c", look], stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        print(f"no BlenderProc: {done.stderr.strip().splitlines()[-1]}")
    return done.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("programs")
    parser.add_argument("results")
    parser.add_argument("--objects", type=int, nargs="+", default=[1, 4, 16, 64])
    parser.add_argument("--scenes", type=int, default=40)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--blenderproc", help="a Python with blenderproc_requirements.txt")
    arguments = parser.parse_args()
    arguments.blenderproc = arguments.blenderproc if has_blenderproc(arguments.blenderproc) else None
    os.makedirs(arguments.results, exist_ok=True)
    results = []
    with tempfile.TemporaryDirectory() as folder:  # only deleted at the end (ours.set_aside)
        for size in ((640, 480), (1280, 720)):
            for objects in arguments.objects:
                place = tempfile.mkdtemp(dir=folder)
                best = measure(arguments.programs, place, objects, size, arguments)
                results.append({"objects": objects, "width": size[0], "height": size[1],
                                "seconds": best})
                print(table(results[-1:]), flush=True)
                with open(f"{arguments.results}/results.json", "w") as out:
                    json.dump(results, out, indent=1)
    with open(f"{arguments.results}/table.md", "w") as out:
        out.write(table(results))
    try:
        plot(results, f"{arguments.results}/plot.png")
    except ImportError:
        print("no plot: matplotlib is not installed")


if __name__ == "__main__":
    main()
