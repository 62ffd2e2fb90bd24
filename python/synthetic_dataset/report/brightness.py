"""Measures of a dataset's images that are not in the manifest."""
import numpy as np
from PIL import Image

from synthetic_dataset.manifest import DatasetError

MOST_IMAGES = 500  # to read; more would take long and not change the result
SMALL = 64  # width to which images are reduced to measure detail [px]: this removes noise and a ground's grain
PLAIN = 8  # largest difference between neighbouring pixels of a plain surface in such an image, of 255


class Brightness:
    """Measures of at most MOST_IMAGES scenes, spread evenly: the mean brightness of images, 0 to 255, and the share of the
    labels' surroundings that is not plain, 0 to 1."""

    def __init__(self, dataset, measures):
        count = len(measures.scene_index)
        self.rows = np.unique(np.linspace(0, count - 1, min(count, MOST_IMAGES)).astype(int))
        values, details, self.unreadable = [], [], []
        for row in self.rows:
            try:
                grey = _grey(dataset.scene(measures.scene_index[row]).image_file)
            except (DatasetError, OSError) as error:
                values.append(np.nan)
                self.unreadable.append(str(error))
                continue
            values.append(float(np.asarray(grey).mean()))
            details.append(detail(grey, measures.box[measures.scene == row] / measures.scene_size[row][0]))
        self.values = np.array(values, float)
        self.detail = float(np.nanmean(details)) if not np.all(np.isnan(details)) else None

    def darkest(self, count):
        """The rows of the darkest scenes, the darkest first."""
        order = np.argsort(self.values, kind='stable')
        return [int(row) for row in self.rows[order][:count]]


def _grey(file):
    with Image.open(file) as picture:
        width = max(SMALL, picture.width // 4)
        picture.draft('L', (width, width * picture.height // picture.width))  # only for JPEG: decodes at a reduced size
        return picture.convert('L')


def detail(grey, boxes):
    """The share of pixels outside the boxes that differ from a neighbour; NaN if boxes fill the image.

    @param boxes  as shares of the image's width
    """
    height = max(2, round(grey.height * SMALL / grey.width))
    small = np.asarray(grey.resize((SMALL, height), Image.BOX)).astype(int)
    around = np.ones(small.shape, bool)
    for left, top, right, bottom in np.floor(boxes * SMALL).astype(int):
        around[top:bottom + 2, left:right + 2] = False
    differences = np.maximum(np.abs(np.diff(small, axis=0))[:, :-1], np.abs(np.diff(small, axis=1))[:-1])
    found = differences[around[:-1, :-1]] > PLAIN
    return float(found.mean()) if len(found) else np.nan
