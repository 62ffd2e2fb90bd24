"""A dataset's pictures with their boxes, from a format for detectors."""
import collections
import json
import os

import numpy as np

from synthetic_dataset.manifest import DatasetError
from synthetic_dataset.pictures import is_image_name, kind_of
from synthetic_dataset.trial import boxes

FORMATS = ('UltralyticsYolo', 'Coco')
KEPT_BACK = 20  # one in so many pictures is held out for testing, if the dataset has no split `val`
MOST_KEPT_BACK = 200

Picture = collections.namedtuple('Picture', 'file truth split')


def read(dataset):
    """All pictures of a dataset, in the order of its scenes.

    @throws DatasetError if it has no format for detectors, no pictures or no labels
    """
    writer = _writer(dataset)
    files = dataset.manifest.rows(
        'SELECT path, scene.split FROM file JOIN scene ON scene."index" = file.scene '
        "WHERE writer = ? AND scene.state IN ('written', 'complete') ORDER BY scene, path", (writer.index,))
    images = [(dataset.folder / path, split) for path, split in files
              if is_image_name(path) and os.path.relpath(dataset.folder / path, writer.folder).startswith('images' + os.sep)]
    if not images:
        raise DatasetError(f"'{dataset.folder}': the dataset has no pictures; `rosrun synthetic_dataset describe_dataset.py "
                           f'{dataset.folder}` says what is in it')
    paths = [file for file, _ in images]
    if kind_of(writer.type) == 'Coco':
        truths = _of_coco(writer, dataset.settings.get(f'{writer.name}/annotation_file', 'instances'), paths)
    else:
        truths = _of_yolo(writer, dataset.settings.get(f'{writer.name}/task'), paths)
    found = [Picture(file, truth, split) for (file, split), truth in zip(images, truths)]
    if not any(len(each.truth) for each in found):
        raise DatasetError(f"'{dataset.folder}': none of its {len(found):,} pictures has a label, so that there is nothing "
                           'to learn')
    return found


def divided(pictures):
    """(pictures to train on, pictures to test on), which are of the same kind. Neither has those of the split `test`."""
    learnt = [each for each in pictures if each.split == 'train']
    tested = [each for each in pictures if each.split == 'val']
    if not learnt or not tested:
        rest = [each for each in pictures if each.split != 'test'] or pictures
        tested = rest[::KEPT_BACK]
        learnt = [each for at, each in enumerate(rest) if at % KEPT_BACK] or rest
    return learnt, tested[::max(1, -(-len(tested) // MOST_KEPT_BACK))]


def _writer(dataset):
    for wanted in FORMATS:
        for writer in dataset.writers:
            if kind_of(writer.type) == wanted:
                return writer
    found = ', '.join(writer.type for writer in dataset.writers) or 'none'
    raise DatasetError(
        f"'{dataset.folder}': has no format to train a detector with; its formats are {found}. Add "
        '`- {name: detect, type: synthetic_dataset/UltralyticsYolo}` to `writers`, and `detect: {task: detect}`; or '
        'synthetic_dataset/Coco')


def _of_yolo(writer, task, files):
    """Yields the boxes of each picture from its label file; with keypoints, the boxes before them."""
    for file in files:
        path = os.path.relpath(file, os.path.join(writer.folder, 'images'))
        label = os.path.join(writer.folder, 'labels', os.path.splitext(path)[0] + '.txt')
        rows = [line.split()[:5 if task == 'pose' else None] for line in _text(label).splitlines() if line.strip()]
        try:
            yield np.array([boxes.row_of(row) for row in rows]) if rows else boxes.NONE
        except ValueError as error:
            raise DatasetError(f"'{label}': {error}; `rosrun synthetic_dataset verify` looks for damage") from error


def _text(file):
    try:
        with open(file, encoding='utf-8') as opened:
            return opened.read()
    except OSError as error:
        raise DatasetError(f"'{file}': cannot be read: {error.strerror}; `rosrun synthetic_dataset describe_dataset.py` says "
                           'whether the run came to its end') from error


def _of_coco(writer, name, files):
    """Yields the boxes of each picture from the annotation files, whose categories count from 1."""
    found = {}
    for split in sorted({_split_of(writer, file) for file in files}):
        content = json.loads(_text(os.path.join(writer.folder, 'annotations', f"{name}_{split or 'train'}.json")))
        images = {each['id']: each for each in content['images']}
        for each in content['annotations']:
            image = images[each['image_id']]
            left, top, width, height = each['bbox']
            found.setdefault((split, image['file_name']), []).append(
                [each['category_id'] - 1, left / image['width'], top / image['height'],
                 (left + width) / image['width'], (top + height) / image['height']])
    for file in files:
        rows = found.get((_split_of(writer, file), os.path.basename(file)))
        yield np.array(rows) if rows else boxes.NONE


def _split_of(writer, file):
    """The split of a COCO picture, which is its folder in `images`; empty without splits."""
    return os.path.dirname(os.path.relpath(file, os.path.join(writer.folder, 'images')))
