"""Compares the bundled hall's light with that of a path tracer (Mitsuba 3): pictures, and how much they differ.

  path_tracer.py PROGRAMS RESULTS [SETTING:=VALUE ...] [--also SETTING:=VALUE ...] [--samples 256] [--scene 6]
                 [--sun 0.53] [--beside NAME=PICTURE ...]

PROGRAMS is the folder `lib` of a workspace's devel space. `generate` draws one scene of the bundled example with
the given settings; for each --also, once more with that setting. The path tracer takes the camera and the objects'
poses from the manifest, everything else from the world's files: it ignores settings that change materials, lights or
the sensor. Props stand upright on the floor in both. --beside adds a picture that another program, such as Gazebo,
has made of RESULTS/still.sdf with the same camera.

RESULTS gets the pictures, sheet.png and sheet.jpg (all side by side, with a detail below each), edges.png (the
outlines that the path tracer's rays find, drawn on our picture), and figures.json. Its figures are in grey levels of
255: the mean absolute difference from the path tracer's picture, and by how much a picture is brighter. `noise` is
the mean absolute error due to the path tracer's own noise.

Needs requirements.txt, python3-rosbag and LLVM 17 or newer.
"""

import argparse
import json
import os
import sqlite3
import subprocess
import xml.etree.ElementTree as xml

import hall
import numpy as np
import tracing
from PIL import Image, ImageDraw

HERE = os.path.dirname(os.path.abspath(__file__))
PACKAGE = os.path.realpath(f"{HERE}/../..")
NEAR = 0.3  # [m], the width of the floor around things
FLOOR_BELOW = 0.05  # [m]
REACHES_DOWN = 0.3  # [m] above the floor: things higher up block little of its light
LARGEST_JPEG = 120_000  # [byte]
PICTURES_OF = "bounding_shape"  # the example's writer that has the picture as PNG
OURS = "ours"
TRACED = "path tracer"


def generate(program, world, output, scene, settings):
    command = [program, "--config", f"{PACKAGE}/config/example.yaml", f"output_folder:={output}",
               "if_exists:=overwrite", f"only_scenes:=[{scene}]", f"world/file:={world}", *settings]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(done.stdout)
    return read_picture(f"{output}/{PICTURES_OF}/{scene:08d}.png")


def read_picture(file):
    with Image.open(file) as picture:
        return np.asarray(picture.convert("RGB")).astype(float)


class Manifest:
    def __init__(self, file, scene):
        self.scene = scene
        with sqlite3.connect(file) as manifest:
            manifest.row_factory = sqlite3.Row
            one = lambda query, *values: manifest.execute(query, values).fetchone()
            found = one('SELECT * FROM scene WHERE "index" = ?', scene)
            if found is None:
                raise SystemExit(f"--scene: found {scene}; the run has no such scene")
            self.stamp = found["stamp_ns"]
            self.X_WC = pose_in(found)
            model = one("SELECT * FROM camera_model")
            if model["distortion"] != "none":
                raise SystemExit("the camera has distortion; the path tracer has pinhole cameras alone")
            self.camera = {"width": found["width"], "height": found["height"],
                           **{each: model[each] for each in ("fx", "fy", "cx", "cy")}}
            self.objects, self.masks = {}, {}
            for row in manifest.execute('SELECT * FROM scene_object JOIN object ON object."index" = object '
                                        "JOIN scene_shape USING (scene, object) WHERE scene = ?", (scene,)):
                self.objects[row["name"]] = pose_in(row)
                self.masks[row["name"]] = mask_of(row["visible_mask"], found["height"], found["width"])


def pose_in(row):
    return hall.matrix(*(row[each] for each in ("x", "y", "z", "qx", "qy", "qz", "qw")))


def mask_of(blob, height, width):
    """Decodes a mask of the manifest (docs/manifest.md): a box, then how many of its pixels are off, on, off, ..."""
    numbers, value, shift = [], 0, 0
    for byte in blob or b"":
        value |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            numbers.append(value)
            value, shift = 0, 0
    mask = np.zeros((height, width), dtype=bool)
    if numbers:
        left, top, columns, rows, *runs = numbers
        inside = np.repeat(np.arange(len(runs)) % 2 == 1, runs)
        inside = np.pad(inside, (0, rows * columns - len(inside)))
        mask[top:top + rows, left:left + columns] = inside.reshape(rows, columns)
    return mask


def world_at(manifest, file, models):
    recording = hall.Recording(f"{PACKAGE}/worlds/example.bag")

    def X_W(model, link):
        if model not in manifest.objects:
            return None
        return recording.at(f"{model}/{link}", manifest.stamp) if link else manifest.objects[model]

    return hall.World(file, models, X_W)


def write_still(source, target, objects):
    """Writes the world with the objects at their poses, for programs that read no recording."""
    tree = xml.parse(source)
    for include in tree.getroot().iter("include"):
        X = objects.get(include.findtext("name"))
        if X is None:
            continue
        roll, pitch = np.arctan2(X[2, 1], X[2, 2]), np.arcsin(-X[2, 0])
        include.find("pose").text = " ".join(map(str, [*X[:3, 3], roll, pitch, np.arctan2(X[1, 0], X[0, 0])]))
        xml.SubElement(include, "static").text = "true"
    tree.write(target)


def encoded(light):
    """Converts light to pixels as our pictures do: compressed towards white above 0.8, then sRGB."""
    light = np.where(light > 0.8, 1.0 - 0.2 * np.exp((0.8 - light) / 0.2), light)
    return np.rint(255.0 * np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055))


def near_things(centres, surfaces):
    """The visible floor within NEAR of corners of things that cast shadows and reach down to it."""
    points = np.concatenate([each.points for each in surfaces if each.casts_shadows])
    floor = centres["floor"] & (centres["point"][:, :, 2] < FLOOR_BELOW)
    low = np.unique(points[points[:, 2] < REACHES_DOWN][:, :2].round(2), axis=0)
    seen = centres["point"][floor][:, :2]
    near = np.zeros(len(seen), dtype=bool)
    for part in np.array_split(low, max(1, len(low) // 64)):
        near |= (((seen[:, None] - part[None]) ** 2).sum(axis=2) < NEAR ** 2).any(axis=1)
    result = floor.copy()
    result[floor] = near
    return result


def regions_of(centres, owners, manifest, surfaces):
    near = near_things(centres, surfaces)
    objects = [owners.index(each) for each in manifest.objects]
    return {"all": np.ones(near.shape, dtype=bool), "objects": np.isin(centres["owner"], objects),
            f"floor within {NEAR} m of things": near,
            "of it, in the sun": near & centres["sunlit"], "of it, in shadow": near & ~centres["sunlit"]}


def figures_of(picture, traced, regions):
    difference = picture - traced
    return {name: {"pixels": int(where.sum()),
                   "mean absolute difference": round(float(np.abs(difference[where]).mean()), 2),
                   "brighter by": round(float(difference[where].mean()), 2)}
            for name, where in regions.items() if where.any()}


def agreement(centres, owners, manifest):
    """For pixels of objects, how many show the same object by our labels and by the path tracer's rays."""
    same = either = 0
    for name, mask in manifest.masks.items():
        rays = centres["owner"] == owners.index(name)
        same += int((mask & rays).sum())
        either += int((mask | rays).sum())
    return {"pixels": either, "same": same}


def picture_of(values):
    return Image.fromarray(np.clip(values, 0, 255).astype(np.uint8))


def edges(picture, centres):
    owner = centres["owner"] * 2 + centres["floor"]
    edge = np.zeros(owner.shape, dtype=bool)
    edge[:, 1:] |= owner[:, 1:] != owner[:, :-1]
    edge[1:] |= owner[1:] != owner[:-1]
    result = picture.copy()
    result[edge] = (0, 255, 0)
    return picture_of(result)


def detail_box(mask):
    """A box around an object and its surroundings, with the picture's aspect ratio."""
    rows, columns = np.nonzero(mask)
    height, width = mask.shape
    size = min(1.8 * max(np.ptp(columns) / width, np.ptp(rows) / height), 1.0)
    w, h = size * width, size * height
    left = min(max(columns.mean() - w / 2, 0), width - w)
    top = min(max(rows.mean() - h / 2, 0), height - h)
    return tuple(int(each) for each in (left, top, left + w, top + h))


def sheet(pictures, box):
    size = next(iter(pictures.values())).size
    result = Image.new("RGB", (size[0] * len(pictures), 2 * size[1]))
    for i, (name, picture) in enumerate(pictures.items()):
        result.paste(picture, (i * size[0], 0))
        result.paste(picture.crop(box).resize(size, Image.LANCZOS), (i * size[0], size[1]))
        ImageDraw.Draw(result).text((i * size[0] + 10, 8), name, fill="white", font_size=22, stroke_width=2,
                                    stroke_fill="black")
    return result


def write_small(picture, file):
    """Writes a JPEG with at most 1280 columns and, if possible, at most LARGEST_JPEG bytes."""
    width = min(picture.width, 1280)
    picture = picture.resize((width, picture.height * width // picture.width), Image.LANCZOS)
    for quality in range(85, 20, -5):
        picture.save(file, quality=quality, optimize=True)
        if os.path.getsize(file) <= LARGEST_JPEG:
            return


def arguments_of():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs")
    parser.add_argument("results")
    parser.add_argument("settings", nargs="*")
    parser.add_argument("--also", action="append", default=[])
    parser.add_argument("--beside", action="append", default=[])
    parser.add_argument("--samples", type=int, default=256)
    parser.add_argument("--scene", type=int, default=6)
    parser.add_argument("--sun", type=float, default=0.53, help="diameter of the sun [degree]")
    return parser.parse_intermixed_args()


def main():
    arguments = arguments_of()
    results = os.path.abspath(arguments.results)
    os.makedirs(results, exist_ok=True)
    models = hall.Models(f"{PACKAGE}/worlds/models")
    world_file, still_file = f"{results}/hall.sdf", f"{results}/still.sdf"
    hall.settle(f"{PACKAGE}/worlds/example.sdf", world_file, models, ("rover_1", "rover_2", "drone_1"))

    program = f"{os.path.abspath(arguments.programs)}/synthetic_dataset/generate"
    drawn = {}
    for i, more in enumerate(["", *arguments.also]):
        settings = arguments.settings + ([more] if more else [])
        drawn[f"{OURS}, {more}" if more else OURS] = generate(program, world_file, f"{results}/ours_{i}",
                                                                   arguments.scene, settings)
    for name, file in (each.split("=", 1) for each in arguments.beside):
        drawn[name] = read_picture(file)
    manifest = Manifest(f"{results}/ours_0/manifest.sqlite", arguments.scene)
    write_still(world_file, still_file, manifest.objects)

    world = world_at(manifest, world_file, models)
    tracer = tracing.Tracer(world, arguments.sun)
    centres = tracer.centres(manifest.camera, manifest.X_WC)
    first, second = tracer.picture(manifest.camera, manifest.X_WC, arguments.samples)
    traced = encoded((first + second) / 2.0)
    regions = regions_of(centres, tracer.owners, manifest, world.surfaces)

    figures = {name: figures_of(picture, traced, regions) for name, picture in drawn.items()}
    figures["noise"] = round(float(np.abs(encoded(first) - encoded(second)).mean() / 2.0), 2)
    figures["labels"] = agreement(centres, tracer.owners, manifest)
    with open(f"{results}/figures.json", "w") as out:
        json.dump(figures, out, indent=1)
    print(json.dumps(figures, indent=1))

    pictures = {name: picture_of(values) for name, values in {**drawn, TRACED: traced}.items()}
    for i, (name, picture) in enumerate(pictures.items()):
        picture.save(f"{results}/picture_{i}.png")
    largest = max(manifest.masks.values(), key=np.sum)
    whole = sheet(pictures, detail_box(largest))
    whole.save(f"{results}/sheet.png")
    write_small(whole, f"{results}/sheet.jpg")
    edges(next(iter(drawn.values())), centres).save(f"{results}/edges.png")


if __name__ == "__main__":
    main()
