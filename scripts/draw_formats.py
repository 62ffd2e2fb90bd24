#!/usr/bin/env python3
"""Makes the pictures of docs/formats: the labels in the files of each format, drawn by draw_labels.

    ./scripts/draw_formats.py DATASET SCENE LEFT TOP WIDTH HEIGHT

DATASET has writers with the names below; the rest selects the part of a scene that is shown. The
documentation uses the bundled example at 1 scene per second, scene 3, `150 100 330 335`.
"""
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

FAMILIES = {
    'boxes': ['ultralytics_detect', 'ultralytics_obb', 'ultralytics_pose', 'pascal_voc'],
    'masks': ['coco', 'ultralytics_segment', 'cityscapes', 'stvnet'],
    'poses': ['bop', 'dope', 'kitti', 'pvnet'],
}
COLOURS = 128  # of a picture, to keep the files small


def drawn(dataset, scene, writer, part):
    """The part of a scene's picture, with the labels of one writer."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / 'labels.png'
        subprocess.run(['rosrun', 'synthetic_dataset', 'draw_labels', dataset, file, scene, writer],
                       check=True)
        left, top, width, height = part
        return Image.open(file).crop((left, top, left + width, top + height))


def main():
    dataset, scene, *numbers = sys.argv[1:]
    part = [int(number) for number in numbers]
    folder = pathlib.Path(__file__).resolve().parents[1] / 'docs/formats'
    folder.mkdir(exist_ok=True)
    for family, writers in FAMILIES.items():
        panels = [drawn(dataset, scene, writer, part) for writer in writers]
        picture = Image.new('RGB', (sum(panel.width for panel in panels), part[3]))
        for i, panel in enumerate(panels):
            picture.paste(panel, (i * part[2], 0))
        picture.quantize(COLOURS).save(folder / f'{family}.png', optimize=True)


if __name__ == '__main__':
    main()
