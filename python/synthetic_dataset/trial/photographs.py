"""Photographs in a folder, with their labels if there are any."""
import collections
import json
import os

import numpy as np

from synthetic_dataset.manifest import DatasetError
from synthetic_dataset.trial import boxes

ENDINGS = ('.jpg', '.jpeg', '.png', '.webp', '.bmp', '.tif', '.tiff')
INDEX = 'index.json'

Photograph = collections.namedtuple('Photograph', 'file truth')  # rows of [class, left, top, right, bottom]

Photographs = collections.namedtuple(
    'Photographs', 'all is_labelled has_classes without_file')


def read(folder, class_names):
    """Photographs of a folder and its subfolders.

    Labels are those of `index.json`, of text files for Ultralytics beside the photographs, or in `labels/` where they
    are in `images/`. If there are any labels, a photograph without a file shows nothing, as in Ultralytics.
    @param class_names  of the dataset, by number
    @throws DatasetError if there are no photographs, or a label cannot be understood
    """
    if not folder.is_dir():
        raise DatasetError(f"'{folder}': no such folder")
    if (folder / INDEX).is_file():
        return _of_index(folder, class_names)
    files = sorted(path for path in folder.rglob('*') if path.suffix.lower() in ENDINGS)
    if not files:
        raise DatasetError(f"'{folder}': no photographs are there; found no " + ', '.join(ENDINGS))
    labels = [_label_file(folder, file) for file in files]
    rows = [_rows_of(label) if label else boxes.NONE for label in labels]
    renumber = _numbering(folder, class_names, rows)
    truths = [_renumbered(row, renumber, label, class_names) for row, label in zip(rows, labels)]
    return Photographs([Photograph(*each) for each in zip(files, truths)],
                       any(labels), True, sum(label is None for label in labels))


def _of_index(folder, class_names):
    """Reads index.json. Its boxes have no class, so they count as any class if there are several."""
    number = next(iter(class_names)) if len(class_names) == 1 else 0
    found = []
    try:
        for name, rows in json.loads((folder / INDEX).read_text('utf-8')):
            corners = boxes.from_centre(np.reshape(np.asarray(rows, float), (-1, 4)))
            found.append(Photograph(folder / name, np.insert(corners, 0, number, axis=1)))
    except (OSError, ValueError, TypeError) as error:
        raise DatasetError(f"'{folder / INDEX}': should be [[file, [[x, y, width, height], ...]], ...], boxes as shares "
                           f'of the picture, centre first; {error}') from error
    if not found:
        raise DatasetError(f"'{folder / INDEX}': lists no photograph")
    return Photographs(found, True, len(class_names) == 1, 0)


def _label_file(folder, file):
    """The text file with a photograph's labels, or None."""
    candidates = [file.with_suffix('.txt')]
    parts = list(file.relative_to(folder).with_suffix('.txt').parts)
    if 'images' in parts[:-1]:
        at = len(parts) - 2 - parts[-2::-1].index('images')
        candidates.append(folder.joinpath(*parts[:at], 'labels', *parts[at + 1:]))
    elif folder.name == 'images':
        candidates.append(folder.parent.joinpath('labels', *parts))
    return next((each for each in candidates if each.is_file()), None)


def _rows_of(file):
    rows = []
    for number, line in enumerate(file.read_text('utf-8', 'replace').splitlines(), 1):
        try:
            if line.strip():
                rows.append(boxes.row_of(line.split()))
        except ValueError as error:
            raise DatasetError(f"'{file}', line {number}: {error}; it should be a class's number and x, y, width and "
                               'height of its box, as shares of the picture, centre first') from error
    return np.array(rows) if rows else boxes.NONE


def _numbering(folder, class_names, rows):
    """Maps class numbers of the labels to those of the dataset; None if they are the same.

    `classes.txt` names the classes of labels (LabelImg, Label Studio). If both sides have only one class, its number
    does not matter.
    """
    for place in (folder, folder / 'labels', folder.parent if folder.name == 'images' else folder):
        if (place / 'classes.txt').is_file():
            names = (place / 'classes.txt').read_text('utf-8').split('\n')
            numbers = {name: number for number, name in class_names.items()}
            return {number: numbers.get(name.strip()) for number, name in enumerate(names) if name.strip()}
    used = {int(number) for row in rows for number in row[:, 0]}
    if len(used) == 1 and len(class_names) == 1:
        return {used.pop(): next(iter(class_names))}
    return None


def _renumbered(rows, renumber, file, class_names):
    """The rows with the dataset's class numbers; drops classes that the dataset lacks, if the labels name theirs."""
    if renumber is not None:
        kept = [[renumber[int(row[0])], *row[1:]] for row in rows
                if renumber.get(int(row[0])) is not None]
        return np.array(kept, float) if kept else boxes.NONE
    for number in rows[:, 0]:
        if int(number) not in class_names:
            known = ', '.join(f'{each} {name}' for each, name in class_names.items())
            raise DatasetError(f"'{file}': has a label of class {int(number)}, and the dataset's classes are {known}; a "
                               f"file '{os.path.join('FOLDER', 'classes.txt')}' with a name a line says what the numbers "
                               'mean')
    return rows
