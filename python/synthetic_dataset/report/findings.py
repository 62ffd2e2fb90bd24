"""Findings for the reader of the page, each with its figures and a remedy."""
import collections

import numpy as np

TINY, HARDLY_VISIBLE = 100, 0.1  # visible pixels, visibility
DARK, BRIGHT = 25, 230  # mean brightness, of 255
FEW = 0.1  # share of the labels of the class with the most

Finding = collections.namedtuple('Finding', 'is_problem text cure')


def share(count, of):
    return f'{count:,} of {of:,} ({100 * count / of:.3g} %)' if of else f'{count:,}'


def findings(dataset, measures, splits, counts, brightness, neighbours, variety):
    found = []

    def add(is_problem, text, cure=''):
        found.append(Finding(is_problem, text, cure))

    if not dataset.is_complete:
        add(True, f'The run is not finished: {len(dataset):,} of '
            f'{int(dataset.manifest.run["scene_count"]):,} scenes are there.',
            'The same command again continues it.')
    _add_classes(add, dataset.settings.get('split/by', 'blocks'), measures, splits, counts)
    _add_labels(add, measures)
    _add_pictures(add, brightness)
    if variety.is_plain and measures.count:
        add(True, 'One model of each class, and nothing else in view: '
            f'{100 * variety.detail:.0f} % of what surrounds labels is not plain. A network learns that by heart.',
            'Add `randomize: {preset: transfer}`.')
    near = {split: count for split, count in neighbours.by_split.items() if count}
    if near:
        text = ', '.join(f'{count:,} of {split}' for split, count in near.items())
        add(True, f'Scenes that hardly differ from one of another split: {text}.',
            cure_of_neighbours(dataset.settings))
    return found


def cure_of_neighbours(settings):
    """The remedy; it does not blame a setting that is not set."""
    others = 'lower `simulated_rate`, or give a split a motion of its own.'
    if settings.get('split/by') == 'scenes':
        return f'Leave `split/by: scenes` out, so that splits are stretches of time, {others}'
    gap = settings.get('split/gap') or 0.0
    if gap > 0.0:
        return f'A `split/gap` of more than {gap:g} s keeps them further apart; or {others}'
    return f'`split/gap: 2.0` leaves out 2 s between the splits of a recording; or {others}'


def _add_classes(add, split_by, measures, splits, counts):
    of_class = counts.sum(axis=1)
    for row, name in enumerate(measures.class_names):
        if of_class[row] == 0:
            add(True, f"No label has the class '{name}'.",
                'See whether its objects are in view: `draw_labels` shows a scene.')
            continue
        if of_class[row] < FEW * of_class.max():
            add(False, f"The class '{name}' has {of_class[row]:,} labels; the class with the most has "
                f'{of_class.max():,}.')
        missing = [split for column, split in enumerate(splits) if counts[row, column] == 0]
        if missing:
            add(True, f"The class '{name}' has no label in " + ' and '.join(missing) + '.',
                'Other shares, or a part of the recording in which it is seen more often, would help.'
                if split_by == 'balanced_blocks' else
                '`split/by: balanced_blocks` gives each split each class, where possible.')


def _add_labels(add, measures):
    if measures.visible_pixels is not None:
        tiny = int(np.count_nonzero(measures.visible_pixels < TINY))
        if tiny > 0.01 * measures.count:
            add(False, f'Labels with fewer than {TINY} visible pixels: '
                f'{share(tiny, measures.count)}.',
                f'`labels/min_pixels: {TINY}` leaves them out.')
    if measures.visibility is not None:
        hidden = int(np.count_nonzero(measures.visibility < HARDLY_VISIBLE))
        if hidden > 0.01 * measures.count:
            add(False, f'Labels of objects of which less than {100 * HARDLY_VISIBLE:.0f} % is '
                f'visible: {share(hidden, measures.count)}.',
                f'`labels/min_visibility: {HARDLY_VISIBLE}` leaves them out.')
    empty = int(np.count_nonzero(measures.labels_by_scene() == 0))
    if empty:
        add(False, f'Images without a label: {share(empty, len(measures.scene_index))}.')
    if measures.dropped:
        add(False, f'Labels left out by the thresholds of `labels`: {measures.dropped:,}.')


def _add_pictures(add, brightness):
    if brightness.unreadable:
        add(True, f'Images that cannot be read: {len(brightness.unreadable):,}; the first: '
            f'{brightness.unreadable[0]}', '`rosrun synthetic_dataset verify` names all.')
    values = brightness.values[~np.isnan(brightness.values)]
    for is_odd, what in ((values < DARK, 'dark'), (values > BRIGHT, 'bright')):
        if np.count_nonzero(is_odd) > 0.01 * len(values):
            limit = f'below {DARK}' if what == 'dark' else f'above {BRIGHT}'
            add(False, f'Images that are very {what} (mean {limit} of 255): '
                f'{share(int(np.count_nonzero(is_odd)), len(values))} that were read.',
                'See the lights of the world, and `randomize/lights` and `randomize/sensor`.')
