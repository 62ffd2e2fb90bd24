"""The page that shows what a network finds in photographs."""
import collections
import os
import pathlib

import numpy as np

from synthetic_dataset import pages
from synthetic_dataset.manifest import DatasetError
from synthetic_dataset.trial import samples

WIDTH, HEIGHT = 480, 360  # of the frame of a picture in the page [px]
SHOWN = 0.5  # as a share of the threshold: the score from which a box is drawn

# The part above the pictures: `facts` are (value, what it is), `findings` sentences.
Summary = collections.namedtuple('Summary', 'name facts findings')


def page_of(summary, sections, threshold, class_names):
    """The page as HTML, with all its pictures in it."""
    return pages.rendered(
        pathlib.Path(__file__).parent, **summary._asdict(), threshold=threshold,
        is_labelled=any(each.truth is not None for section in sections for each in section.results),
        sections=[(section.title, section.note, [_tile(each, threshold, class_names) for each in section.results])
                  for section in sections])


def check_place(file, dataset):
    """@throws DatasetError if the page would be in the dataset's folder, or cannot be written"""
    target = pathlib.Path(file).resolve()
    if dataset.folder == target.parent or dataset.folder in target.parents:
        raise DatasetError(f"'{file}': is in the dataset's folder, where `verify` knows all files; choose another")
    if not target.parent.is_dir():
        raise DatasetError(f"'{file}': cannot be written: no such folder")
    if target.is_dir() or not os.access(target.parent, os.W_OK):
        raise DatasetError(f"'{file}': cannot be written")


def _tile(result, threshold, class_names):
    picture = samples.opened(result.file, WIDTH)
    boxes = []
    for at in np.argsort(result.found.scores, kind='stable'):  # the most confident is drawn last
        score = float(result.found.scores[at])
        if score < SHOWN * threshold:
            continue
        kind = 'found' if result.match is None else 'right' if result.match[at] >= 0 else 'wrong'
        name = class_names[int(result.found.classes[at])]
        boxes.append(_box(result.found.boxes[at], picture, kind + (' faint' if score < threshold else ''),
                          f'{score:.2f}', f'{name}, score {score:.3f}'))
    labels = [] if result.truth is None else [_box(row[1:], picture, 'label', '', 'label') for row in result.truth]
    return {'file': result.file.name, 'image': pages.embedded(picture), 'width': picture.width, 'height': picture.height,
            'labels': labels, 'boxes': boxes, 'text': _text(result, threshold)}


def _box(corners, picture, kind, text, title):
    left, top, right, bottom = (float(share * side) for share, side in zip(corners, picture.size * 2))
    # All pictures are shown in frames of the same size.
    size = (12 if kind.endswith('faint') else 15) * max(picture.width / WIDTH, picture.height / HEIGHT)
    return {'x': left, 'y': top, 'width': right - left, 'height': bottom - top, 'kind': kind, 'text': text,
            'title': title, 'text_size': size, 'text_x': min(left + 2, picture.width - 2.4 * size),
            'text_y': top - size / 4 if top > 1.3 * size else min(bottom, picture.height) - size / 2}


def _text(result, threshold):
    counts = int((result.found.scores >= threshold).sum())
    if result.truth is None:
        return f"{counts or 'nothing'} found"
    if not len(result.truth):
        return 'without a label' + (f', {counts} wrong' if counts else '')
    right = int(((result.match >= 0) & (result.found.scores >= threshold)).sum())
    return f'{right} of {len(result.truth)} found' + (f', {counts - right} wrong' if counts > right else '')
