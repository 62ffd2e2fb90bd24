"""How bright a dataset's images are, which the manifest does not say."""
import numpy as np
from PIL import Image

from synthetic_dataset.manifest import DatasetError

MOST_IMAGES = 500  # that are read; more would take long and say the same


class Brightness:
    """The mean brightness of images, 0 to 255, of at most MOST_IMAGES scenes spread over all."""

    def __init__(self, dataset, measures):
        count = len(measures.scene_index)
        self.rows = np.unique(np.linspace(0, count - 1, min(count, MOST_IMAGES)).astype(int))
        values, self.unreadable = [], []
        for row in self.rows:
            try:
                values.append(_mean(dataset.scene(measures.scene_index[row]).image_file))
            except (DatasetError, OSError) as error:
                values.append(np.nan)
                self.unreadable.append(str(error))
        self.values = np.array(values, float)

    def darkest(self, count):
        """Rows of scenes, the darkest first."""
        order = np.argsort(self.values, kind='stable')
        return [int(row) for row in self.rows[order][:count]]


def _mean(file):
    with Image.open(file) as picture:
        picture.draft('L', (picture.width // 4, picture.height // 4))  # JPEG alone: decodes less
        return float(np.asarray(picture.convert('L')).mean())
