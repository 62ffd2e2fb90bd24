"""The values that were drawn at random for the scenes of a dataset."""
import itertools
import json
import operator

import numpy as np

BARS = 24  # of a histogram
MOST_TEXTS = 4


def drawn_values(dataset):
    """A row for each random value: its name, range, mean, and the bars of a histogram."""
    rows = dataset.manifest.rows('SELECT name, value FROM draw ORDER BY name')
    found = []
    for name, draws in itertools.groupby(rows, key=operator.itemgetter(0)):
        values = json.loads('[' + ','.join(value for _, value in draws) + ']')
        if all(isinstance(value, list) for value in values) and len(set(map(len, values))) == 1:
            for component, of_component in enumerate(zip(*values)):
                found.append(_row(f'{name} [{component}]', of_component))
        else:
            found.append(_row(name, values))
    return found


def _row(name, values):
    if not all(isinstance(value, (int, float)) for value in values):
        return {'name': name, 'range': _texts(values), 'mean': '', 'bars': [],
                'count': len(values)}
    counts, _ = np.histogram(values, bins=BARS)
    return {'name': name, 'range': f'{min(values):.4g} … {max(values):.4g}',
            'mean': f'{np.mean(values):.4g}', 'count': len(values),
            'bars': [round(float(count) / counts.max(), 3) for count in counts]}


def _texts(values):
    texts, counts = np.unique([str(value) for value in values], return_counts=True)
    order = np.argsort(-counts, kind='stable')
    shown = ', '.join(f"{counts[row]} × '{texts[row]}'" for row in order[:MOST_TEXTS])
    return shown + (f' and {len(texts) - MOST_TEXTS} more' if len(texts) > MOST_TEXTS else '')
