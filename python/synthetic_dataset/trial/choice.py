"""Which photographs the page shows, of all that the network has looked at."""
import collections

import numpy as np

from synthetic_dataset.trial.precision import best_threshold, matches

MOST_SHOWN = 12  # in a section
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
    chosen = [('Most confident', 'The surest find of each comes first.', _confidence),
              ('Most doubtful', f'Something is found with a score near {threshold:.2f}, from which on it counts.',
               lambda each: -np.abs(each.found.scores - threshold).min(initial=1))]
    if results and results[0].truth is not None:
        chosen += [('Confident and wrong', 'Something is found that no label has.', _wrong_confidence(threshold)),
                   ('Missed', 'Most of the labels are not found.', _missed(threshold))]
    else:
        chosen += [('Nothing found', 'No score is high enough to count.',
                    lambda each: None if _confidence(each) >= threshold else _confidence(each))]
    left, found = list(results), []
    for title, note, key in chosen:
        ranked = [(key(each), each) for each in left]
        ranked = sorted((each for each in ranked if each[0] is not None), key=lambda each: each[0], reverse=True)
        shown = [each for _, each in ranked[:MOST_SHOWN]]
        files = {each.file for each in shown}
        left = [each for each in left if each.file not in files]
        found.append(Section(title, note, shown))
    return [section for section in found if section.results]


def _confidence(result):
    return result.found.scores.max(initial=0)


def _wrong_confidence(threshold):
    def key(result):
        score = result.found.scores[result.match < 0].max(initial=0)
        return score if score >= threshold else None
    return key


def _missed(threshold):
    def key(result):
        seen = result.match[(result.match >= 0) & (result.found.scores >= threshold)]
        missed = len(result.truth) - len(seen)
        return missed if missed else None
    return key
