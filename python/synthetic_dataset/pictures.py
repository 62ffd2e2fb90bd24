"""Finds a scene's image, depth and masks among its files, with patterns for each format."""
import json
import re

import numpy as np
from PIL import Image

from synthetic_dataset.manifest import DatasetError

# By type of writer: a pattern for paths relative to its folder. Other writers: any image file.
IMAGES = {
    'Bop': r'/rgb/', 'Cityscapes': r'^leftImg8bit/', 'Coco': r'^images/',
    'ImageFolder': r'/[^/.]+\.(png|jpg)$', 'Kitti': r'image_2/', 'PascalVoc': r'^JPEGImages/',
    'PvNet': r'/rgb/', 'RosBag': r'images/', 'StvNet': r'/JPEGImages/',
    'UltralyticsYolo': r'^images/',
}
INSTANCES = {'ImageFolder': r'\.mask\.png$', 'RosBag': r'instances/'}
DEPTHS = {'ImageFolder': r'\.depth\.tiff$', 'RosBag': r'depth/', 'Bop': r'/depth/'}


def read(file):
    """A picture as an array: 8 bit RGB, 16 bit integers or 32 bit floating point."""
    try:
        with Image.open(file) as picture:
            if picture.mode in ('P', 'RGBA', 'L', 'CMYK', 'LA'):
                picture = picture.convert('RGB')
            pixels = np.array(picture)
    except OSError as error:
        raise DatasetError(f"'{file}': the picture cannot be read: {error}") from error
    return pixels.astype(np.uint16) if pixels.dtype == np.int32 else pixels


def is_image_name(path):
    return path.lower().endswith(('.png', '.jpg', '.jpeg'))


def kind_of(writer_type):
    """`Coco` for `synthetic_dataset/Coco`; empty for writers of other packages."""
    package, _, kind = writer_type.partition('/')
    return kind if package == 'synthetic_dataset' else ''


def matching(files, patterns):
    """Yields the (writer, path relative to its folder, file) that match a table of patterns."""
    for writer, path, file in files:
        pattern = patterns.get(kind_of(writer.type))
        if pattern is not None and re.search(pattern, path):
            yield writer, path, file


def image_file(files):
    """The file with a scene's image, preferably a lossless one; None if there is none."""
    known = [file for _, path, file in matching(files, IMAGES) if is_image_name(path)]
    # From formats with one picture per scene, and writers of other packages.
    other = [file for writer, path, file in files
             if kind_of(writer.type) not in IMAGES and is_image_name(path)]
    found = sorted(known, key=lambda file: file.suffix != '.png') or other
    return found[0] if found else None


def instances(files):
    """The instance map; None if no format has one."""
    for _, _, file in matching(files, INSTANCES):
        return read(file)
    return None


def depth(files):
    """z in the optical frame [m], 0 where there is nothing; None if no format has depth."""
    for writer, _, file in matching(files, DEPTHS):
        pixels = read(file).astype(np.float32)
        if kind_of(writer.type) == 'Bop':
            cameras = json.loads((file.parents[1] / 'scene_camera.json').read_text('utf-8'))
            pixels *= np.float32(cameras[str(int(file.stem))]['depth_scale'] / 1000)
        return np.nan_to_num(pixels, nan=0.0)
    return None
