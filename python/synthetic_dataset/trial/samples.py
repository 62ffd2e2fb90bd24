"""The samples for training: pictures that are scaled, shifted, mirrored and combined."""
import functools

import numpy as np
from PIL import Image, ImageOps

GREY = 114  # around pictures, as in Ultralytics
SCALES = (0.5, 1.5)  # of a single picture
SCALES_OF_FOUR = (0.3, 1.0)  # of the four pictures of a mosaic, which meet in a point
SHARE_OF_FOUR = 0.6  # share of samples that are mosaics of four pictures
LEAST_SIDE = 3.0  # [px] of a box that counts, and
LEAST_SEEN = 0.2  # the least share of its area that has to be visible
HUE, SATURATION, BRIGHTNESS = 0.015, 0.6, 0.4  # the largest changes of colours, as shares
CACHE = 600e6  # [byte] of pictures kept in memory


def opened(file, size):
    """A picture, upright, whose longer side is `size` pixels.

    @throws OSError if it cannot be read
    """
    with Image.open(file) as picture:
        picture.draft('RGB', (2 * size, 2 * size))  # only for JPEG: faster decoding at a reduced size
        picture = ImageOps.exif_transpose(picture).convert('RGB')
    share = size / max(picture.size)
    return picture.resize([max(1, round(side * share)) for side in picture.size], Image.BILINEAR)


def letterboxed(picture, size):
    """(pixels, left, top): a picture in the middle of a square, and its position there."""
    left, top = ((size - side) // 2 for side in picture.size)
    canvas = Image.new('RGB', (size, size), (GREY,) * 3)
    canvas.paste(picture, (left, top))
    return np.asarray(canvas), left, top


class Samples:
    """Sample n depends on n alone: (pixels, rows of [class, left, top, right, bottom] [px])."""

    def __init__(self, pictures, size, seed=0):
        self._pictures, self._size, self._seed = pictures, size, seed
        kept = int(CACHE / (3 * size * size))
        self._opened = functools.lru_cache(kept)(lambda at: opened(pictures[at].file, size))

    def sample(self, number, may_be_of_four=True):
        random = np.random.RandomState((self._seed * 1000003 + number) % 2**32)
        canvas = Image.new('RGB', (self._size, self._size), (GREY,) * 3)
        if may_be_of_four and random.uniform() < SHARE_OF_FOUR:
            rows = self._four(canvas, random)
        else:
            rows = self._one(canvas, random)
        return recoloured(canvas, random), np.concatenate(rows)

    def _one(self, canvas, random):
        picture, truth = self._drawn(random, SCALES)
        # Places the picture anywhere in the square or, if it is larger, the square anywhere in the picture.
        left, top = (random.uniform(min(0, self._size - side), max(0, self._size - side)) for side in picture.size)
        return [pasted(canvas, picture, truth, round(left), round(top))]

    def _four(self, canvas, random):
        meet = random.uniform(0.3, 0.7, 2) * self._size
        rows = []
        for at in range(4):
            picture, truth = self._drawn(random, SCALES_OF_FOUR)
            part = Image.new('RGB', (self._size, self._size), (GREY,) * 3)
            left = meet[0] if at % 2 else meet[0] - picture.width
            top = meet[1] if at // 2 else meet[1] - picture.height
            corner = [int(meet[0]) if at % 2 else 0, int(meet[1]) if at // 2 else 0]
            end = [self._size if at % 2 else int(meet[0]), self._size if at // 2 else int(meet[1])]
            rows.append(pasted(part, picture, truth, round(left), round(top), (*corner, *end)))
            canvas.paste(part.crop((*corner, *end)), tuple(corner))
        return rows

    def _drawn(self, random, scales):
        """A random picture at a random size, perhaps mirrored, with its boxes as shares of it."""
        at = random.randint(len(self._pictures))
        picture, truth = self._opened(at), np.array(self._pictures[at].truth)
        scale = random.uniform(*scales)
        picture = picture.resize([max(1, round(side * scale)) for side in picture.size], Image.BILINEAR)
        if random.uniform() < 0.5:
            picture = ImageOps.mirror(picture)
            truth[:, [1, 3]] = 1 - truth[:, [3, 1]]
        return picture, truth


def pasted(canvas, picture, truth, left, top, window=None):
    """Pastes a picture onto the canvas, and returns the boxes [px] that are visible enough in a window of it."""
    canvas.paste(picture, (left, top))
    whole = truth.copy()
    whole[:, 1:] = truth[:, 1:] * (picture.size * 2) + np.array([left, top, left, top])
    low, high = np.split(np.array(window or (0, 0, *canvas.size), float), 2)
    seen = whole.copy()
    seen[:, 1:] = np.clip(whole[:, 1:], [*low, *low], [*high, *high])
    sides, sides_of_whole = (rows[:, 3:5] - rows[:, 1:3] for rows in (seen, whole))
    share = sides.prod(axis=1) / np.maximum(sides_of_whole.prod(axis=1), 1e-9)
    return seen[(sides.min(axis=1, initial=np.inf) >= LEAST_SIDE) & (share >= LEAST_SEEN)]


def recoloured(picture, random):
    """Changes hue, saturation and brightness of all pixels by the same random amounts."""
    hue, saturation, brightness = random.uniform(-1, 1, 3) * (HUE, SATURATION, BRIGHTNESS)
    values = np.array(picture.convert('HSV'), float)
    values[..., 0] = (values[..., 0] + 255 * hue) % 256
    values[..., 1:] = np.clip(values[..., 1:] * (1 + saturation, 1 + brightness), 0, 255)
    return np.array(Image.fromarray(values.astype(np.uint8), 'HSV').convert('RGB'))
