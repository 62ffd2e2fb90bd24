"""Average precision of a network's detections, as COCO defines it, at one overlap."""
import collections

import numpy as np

from synthetic_dataset.trial.boxes import overlaps

LEAST_OVERLAP = 0.5  # intersection over union of a detection and its object, for AP50

# A network's detections in one picture, most confident first: rows of [left, top, right, bottom], scores and classes.
Found = collections.namedtuple('Found', 'boxes scores classes')


def matches(found, truth):
    """For each detection, the row of `truth` that it matches, or -1.

    In order of confidence, each takes the remaining object of its class that it overlaps most.
    @param truth  rows of [class, left, top, right, bottom]
    """
    overlap = overlaps(found.boxes, truth[:, 1:])
    overlap[found.classes[:, None] != truth[None, :, 0]] = 0.0
    result = np.full(len(found.scores), -1)
    for row in np.argsort(-found.scores, kind='stable') if len(truth) else []:
        best = int(overlap[row].argmax())
        if overlap[row, best] >= LEAST_OVERLAP:
            result[row] = best
            overlap[:, best] = 0.0
    return result


def average_precision(scores, is_right, count):
    """The mean of the best precisions at recalls of 0, 0.01, ..., 1.

    @param count  the number of objects to be found, at least 1
    """
    order = np.argsort(-np.asarray(scores), kind='stable')
    right = np.cumsum(np.asarray(is_right, bool)[order])
    precision = right / np.arange(1, len(right) + 1)
    best_from_here_on = np.maximum.accumulate(precision[::-1])[::-1]
    at = np.searchsorted(right / count, np.linspace(0, 1, 101))
    return float(np.append(best_from_here_on, 0.0)[at].mean())


def mean_average_precision(founds, truths):
    """The mean over all classes that occur in `truths`; None if there are no objects."""
    classes = sorted({int(number) for truth in truths for number in truth[:, 0]})
    values = []
    for number in classes:
        scores, right = [], []
        for found, truth in zip(founds, truths):
            of_class = found.classes == number
            scores.append(found.scores[of_class])
            right.append(matches(found, truth)[of_class] >= 0)
        count = sum(int((truth[:, 0] == number).sum()) for truth in truths)
        values.append(average_precision(np.concatenate(scores), np.concatenate(right), count))
    return float(np.mean(values)) if values else None


def best_threshold(founds, truths):
    """The score threshold with the best F1 of precision and recall; None if no detection is right."""
    scores = np.concatenate([found.scores for found in founds])
    right = np.concatenate([matches(found, truth) >= 0 for found, truth in zip(founds, truths)])
    if not right.any():
        return None
    order = np.argsort(-scores, kind='stable')
    hits = np.cumsum(right[order])
    count = sum(len(truth) for truth in truths)
    balance = 2 * hits / (np.arange(1, len(hits) + 1) + count)
    return float(scores[order][int(balance.argmax())])
