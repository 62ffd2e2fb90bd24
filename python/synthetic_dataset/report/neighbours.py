"""Finds scenes in different splits that look nearly the same, by the manifest's measures."""
import numpy as np

BOX_TOLERANCE = 0.01  # for a box's edges, as a share of the image's size
POSITION_TOLERANCE = 0.02  # for the camera [m]
ROTATION_TOLERANCE = np.radians(0.5)  # for the camera
WINDOW = 500  # how many neighbours in the order of the widest feature are compared with each scene


class Neighbours:
    """Pairs of scenes in which the camera and the boxes of all visible objects hardly differ."""

    def __init__(self, measures):
        # (difference as a share of the tolerances, rows of the two scenes), the closest pair first.
        self.pairs = []
        found = np.zeros(len(measures.scene_index), bool)
        for rows, features in _alike(measures):
            for first, second, difference in _close(rows, features, measures.scene_split):
                self.pairs.append((difference, first, second))
                found[[first, second]] = True
        self.pairs.sort()
        self.by_split = {split: int(np.count_nonzero(found[measures.scene_split == split]))
                         for split in sorted(set(measures.scene_split))}


def _alike(measures):
    """Yields groups of scenes of one camera with the same visible objects, and their features.

    Features are divided by their tolerances.
    """
    scene_count, object_count = len(measures.scene_index), len(measures.object_names)
    boxes = np.zeros((scene_count, object_count, 4))
    seen = np.zeros((scene_count, object_count), bool)
    seen[measures.scene, measures.object] = True
    sizes = np.tile(measures.scene_size, 2)
    boxes[measures.scene, measures.object] = measures.box / sizes[measures.scene] / BOX_TOLERANCE
    groups = {}
    for row in np.flatnonzero(seen.any(axis=1)):
        groups.setdefault((measures.scene_camera[row], seen[row].tobytes()), []).append(row)
    for rows in groups.values():
        X_GC = measures.scene_X_GC[rows]
        yield np.array(rows), np.concatenate(
            [boxes[rows].reshape(len(rows), -1), X_GC[:, :3, 3] / POSITION_TOLERANCE,
             X_GC[:, :3, :3].reshape(len(rows), 9) / ROTATION_TOLERANCE], axis=1)


def _close(rows, features, splits):
    """Yields pairs from different splits that differ by at most the tolerance in each feature.

    In the order of the feature that varies most, such scenes are near one another.
    """
    if len(rows) < 2 or len(set(splits[rows])) < 2:
        return
    widest = np.argmax(np.ptp(features, axis=0))
    order = np.argsort(features[:, widest], kind='stable')
    rows, features = rows[order], features[order]
    of = splits[rows]
    for step in range(1, min(WINDOW, len(rows) - 1) + 1):
        near = features[step:, widest] - features[:-step, widest] <= 1.0
        if not near.any():
            return
        first = np.flatnonzero(near & (of[step:] != of[:-step]))
        difference = np.abs(features[first + step] - features[first]).max(axis=1, initial=0.0)
        for place, value in zip(first[difference <= 1.0], difference[difference <= 1.0]):
            yield int(rows[place]), int(rows[place + step]), float(value)
