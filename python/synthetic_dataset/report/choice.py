"""Chooses the scenes that a page shows."""
import collections

import numpy as np

Chosen = collections.namedtuple('Chosen', 'row reason')

RANDOM, OF_EACH_KIND = 4, 2


def choose(measures, brightness):
    """The most informative scenes of a dataset, with the reason for each; no scene twice."""
    chosen = []

    def take(rows, reason, count):
        taken = {each.row for each in chosen}
        for row in [row for row in dict.fromkeys(map(int, rows)) if row not in taken][:count]:
            chosen.append(Chosen(row, reason))

    scene_count = len(measures.scene_index)
    take([0] if scene_count else [], 'first', 1)
    # The same scenes each time.
    take(np.random.RandomState(0).permutation(scene_count), 'random', RANDOM)
    rarest = _rarest(measures)
    if rarest is not None:
        of_class = np.flatnonzero(measures.label_class == rarest)
        largest = of_class[np.argsort(-measures.box_size[of_class].prod(axis=1), kind='stable')]
        take(measures.scene[largest], f'rarest class: {measures.class_names[rarest]}', OF_EACH_KIND)
    if measures.visibility is not None:
        take(measures.scene[np.argsort(measures.visibility, kind='stable')], 'least visible',
             OF_EACH_KIND)
    take(brightness.darkest(scene_count), 'darkest', OF_EACH_KIND)
    take(measures.scene[np.argsort(measures.box_size.prod(axis=1), kind='stable')],
         'smallest label', 1)
    return chosen


def _rarest(measures):
    """The class with the fewest labels, but at least one; None if only one class has labels."""
    counts = np.bincount(measures.label_class, minlength=len(measures.class_names))
    present = np.flatnonzero(counts)
    return int(present[np.argmin(counts[present])]) if len(present) > 1 else None
