"""Chooses the photographs that the page shows."""
import collections

import numpy as np

from synthetic_dataset.trial.precision import best_threshold, matches

MOST_SHOWN = 12  # in a section
DOUBT = 0.5  # as a share of the threshold: scores at least this far from it are not near it
USUAL_THRESHOLD = 0.25  # the score from which a detection counts, if no labels tell the best one

# A photograph with its detections; `match` has the row of `truth` for each, or -1. Without labels, both are None.
Result = collections.namedtuple('Result', 'file found truth match')
Section = collections.namedtuple('Section', 'title note results')


def results_of(files, founds, truths):
    """The results, without those of photographs that cannot be read."""
    return [Result(file, found, truth, None if truth is None else matches(found, truth))
            for file, found, truth in zip(files, founds, truths) if found is not None]


def threshold_of(results):
    """The score from which a detection counts."""
    if not results or results[0].truth is None:
        return USUAL_THRESHOLD
    return best_threshold([each.found for each in results], [each.truth for each in results]) or USUAL_THRESHOLD


def sections_of(results, threshold):
    """The sections, the most confident and the most doubtful first; a photograph is in only one section."""
    keys = Keys(threshold)
    chosen = [('Most confident', 'The surest find of each comes first.', keys.confidence),
              ('Most doubtful', f'Something is found with a score near {threshold:.2f}, from which on it counts.', keys.doubt)]
    if results and results[0].truth is not None:
        chosen += [('Confident and wrong', 'Something is found that no label has.', keys.wrong_confidence),
                   ('Missed', 'Photographs with the most labels that are not found.', keys.missed)]
    else:
        chosen += [('Nothing found', 'No score is high enough to count.', keys.emptiness)]
    left, found = list(results), []
    for title, note, key in chosen:
        ranked = [(key(each), each) for each in left]
        ranked = sorted((each for each in ranked if each[0] is not None), key=lambda each: each[0], reverse=True)
        shown = [each for _, each in ranked[:MOST_SHOWN]]
        files = {each.file for each in shown}
        left = [each for each in left if each.file not in files]
        found.append(Section(title, note, shown))
    return [section for section in found if section.results]


class Keys:
    """How strongly a photograph belongs to a section; None: not at all."""

    def __init__(self, threshold):
        self._threshold = threshold

    def confidence(self, result):
        return self._highest(result.found.scores)

    def doubt(self, result):
        distance = np.abs(result.found.scores - self._threshold).min(initial=np.inf)
        return -distance if distance < DOUBT * self._threshold else None

    def wrong_confidence(self, result):
        return self._highest(result.found.scores[result.match < 0])

    def missed(self, result):
        seen = np.count_nonzero((result.match >= 0) & (result.found.scores >= self._threshold))
        return len(result.truth) - seen or None

    def emptiness(self, result):
        return 1 if self.confidence(result) is None else None

    def _highest(self, scores):
        score = scores.max(initial=0)
        return score if score >= self._threshold else None
