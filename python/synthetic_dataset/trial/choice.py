"""Which photographs the page shows, of all that the network has looked at."""
import collections

import numpy as np

from synthetic_dataset.trial.precision import best_threshold, matches

MOST_SHOWN = 12  # in a section
DOUBT = 0.5  # of the threshold: from it on a score is not near it
USUAL_THRESHOLD = 0.25  # from which score on something counts as found, where no label says what is best

# A photograph with what is found in it, each the row of `truth` that it is or -1; both None without labels.
Result = collections.namedtuple('Result', 'file found truth match')
Section = collections.namedtuple('Section', 'title note results')


def results_of(files, founds, truths):
    """Without photographs that cannot be read, of which nothing is known."""
    return [Result(file, found, truth, None if truth is None else matches(found, truth))
            for file, found, truth in zip(files, founds, truths) if found is not None]


def threshold_of(results):
    """From which score on something counts as found."""
    if not results or results[0].truth is None:
        return USUAL_THRESHOLD
    return best_threshold([each.found for each in results], [each.truth for each in results]) or USUAL_THRESHOLD


def sections_of(results, threshold):
    """The most confident and the most doubtful first; a photograph is in one section alone."""
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
    """How much a photograph belongs into a section; None: not at all."""

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
