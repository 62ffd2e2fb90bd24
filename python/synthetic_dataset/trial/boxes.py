"""Boxes as [left, top, right, bottom], as shares of a picture's width and height."""
import numpy as np

NONE = np.zeros((0, 5))  # rows of [class, left, top, right, bottom]


def from_centre(values):
    """The corners of boxes given as [x, y, width, height], where x and y are the centre."""
    centre, half = np.asarray(values, float)[..., :2], np.asarray(values, float)[..., 2:4] / 2
    return np.concatenate((centre - half, centre + half), axis=-1)


def row_of(words):
    """[class, left, top, right, bottom] from a line of an Ultralytics label file.

    A class and four numbers are a box; a class and more pairs of numbers are the corners of a polygon or of a
    rotated box, for which the enclosing box is returned.
    @throws ValueError if it is neither
    """
    numbers = [float(word) for word in words]
    if not np.isfinite(numbers).all() or numbers[0] != int(numbers[0]):
        raise ValueError('found something that is no number')
    if len(numbers) == 5:
        return [numbers[0], *from_centre(numbers[1:])]
    if len(numbers) >= 7 and len(numbers) % 2 == 1:
        corners = np.reshape(numbers[1:], (-1, 2))
        return [numbers[0], *corners.min(axis=0), *corners.max(axis=0)]
    raise ValueError(f'found {len(numbers)} numbers')


def overlaps(some, others):
    """Intersection over union of each pair: a row for each of `some`, a column for each of `others`."""
    some, others = np.reshape(some, (-1, 1, 4)), np.reshape(others, (1, -1, 4))
    sides = np.minimum(some[..., 2:], others[..., 2:]) - np.maximum(some[..., :2], others[..., :2])
    both = np.clip(sides, 0, None).prod(axis=-1)
    areas = [(each[..., 2:] - each[..., :2]).prod(axis=-1) for each in (some, others)]
    return both / np.maximum(areas[0] + areas[1] - both, 1e-12)
