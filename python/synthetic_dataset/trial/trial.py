"""Trains a network on a dataset, tries it on photographs, and makes a page of its detections."""
import pathlib
import sys
import time

from synthetic_dataset import Dataset, DatasetError, pages
from synthetic_dataset.trial import choice, page, photographs, pictures
from synthetic_dataset.trial.precision import mean_average_precision

SECONDS_OF_A_LINE = 30.0  # between two lines of progress, without a terminal


class Progress:
    """Shows progress: one changing line in a terminal, else a line now and then."""

    def __init__(self, out=sys.stderr, clock=time.monotonic):
        self._out, self._clock = out, clock
        self._is_terminal = out.isatty()
        self._said_at, self._unsaid = None, None

    def __call__(self, text):
        if self._is_terminal:
            self._out.write(f'\r{text}\033[K')
            self._out.flush()
            self._unsaid = ''
        elif self._said_at is None or self._clock() - self._said_at >= SECONDS_OF_A_LINE:
            self._say(text)
        else:
            self._unsaid = text

    def end(self):
        """Prints the last text, and starts a new line."""
        if self._unsaid is not None:
            self._say(self._unsaid)
        self._said_at = None

    def _say(self, text):
        print(text, file=self._out, flush=True)
        self._said_at, self._unsaid = self._clock(), None


def run(arguments, make_network, is_stopped, progress):
    """Runs the program; `arguments` has the names of its command-line arguments.

    @param make_network  called as `Network`, with the classes' numbers and a weights file
    @throws DatasetError
    """
    dataset = Dataset(arguments.dataset)
    page.check_place(arguments.file, dataset)
    learnt, tested = pictures.divided(pictures.read(dataset))
    real = photographs.read(pathlib.Path(arguments.real), dataset.classes)
    if arguments.weights and not pathlib.Path(arguments.weights).is_file():
        raise DatasetError(f"'{arguments.weights}': no such file; weights are not fetched from anywhere")
    network = make_network(list(dataset.classes), arguments.weights)
    if not arguments.weights:
        print('try_training: without --weights the network starts untrained, and finds much less than one that has seen '
              'photographs of anything', file=sys.stderr)
    steps, seconds = _train(network, learnt, 60 * arguments.minutes, is_stopped, progress)
    of_own_kind = _score(*_looked(network, tested, None, progress, 'pictures'))
    founds, truths = _looked(network, real.all, real, progress, 'photographs')
    score = _score(founds, truths) if real.is_labelled else None
    results = choice.results_of([each.file for each in real.all], founds, truths)
    if not results:
        raise DatasetError(f"'{arguments.real}': none of the photographs can be read")
    threshold = choice.threshold_of(results)
    facts = [(f'{score:.2f}', 'AP50 in photographs')] if score is not None else []
    facts += [(f'{of_own_kind:.2f}', 'AP50 in pictures of the dataset')] if of_own_kind is not None else []
    facts += [(f'{len(results):,}', 'photographs'), (f'{len(learnt):,}', 'pictures learnt from'), (f'{steps:,}', 'steps'),
              (f'{seconds / 60:.1f}', 'minutes')]
    findings = _findings(arguments, dataset, network, real, founds, steps, is_stopped())
    text = page.page_of(page.Summary(dataset.folder.name, facts, findings), choice.sections_of(results, threshold),
                        threshold, _names(dataset, real))
    pages.write(text, arguments.file)
    print(_result(score, of_own_kind, real, results))
    print(arguments.file)


def _train(network, learnt, limit, is_stopped, progress):
    last = 0.0

    def after_step(step, seconds, loss):
        nonlocal last
        last = seconds
        progress(f'training on {network.device}: {_clock(seconds)} of {_clock(limit)}, step {step:,}, loss {loss:.2f}')

    steps = network.train(learnt, limit, is_stopped, after_step)
    progress.end()
    return steps, last


def _clock(seconds):
    return f'{int(seconds) // 60}:{int(seconds) % 60:02d}'


def _looked(network, some, real, progress, what):
    """(detections, truths) of pictures; all have class 0 if the labels have no classes."""
    found = list(network.find([each.file for each in some],
                              lambda done: progress(f'looking at {what}: {done:,} of {len(some):,}')))
    progress.end()
    truths = [each.truth if real is None or real.is_labelled else None for each in some]
    if real is not None and real.is_labelled and not real.has_classes:
        found = [each if each is None else each._replace(classes=0 * each.classes) for each in found]
    return found, truths


def _score(founds, truths):
    """AP50 over the pictures that could be read; None if they have no labels."""
    read = [(found, truth) for found, truth in zip(founds, truths) if found is not None]
    return mean_average_precision(*zip(*read)) if read else None


def _names(dataset, real):
    return dataset.classes if real.has_classes or not real.is_labelled else {0: 'object'}


def _findings(arguments, dataset, network, real, founds, steps, was_stopped):
    found = []
    if was_stopped:
        found.append((True, f'The training was stopped after {steps:,} steps: a full training would find something else.'))
    if not arguments.weights:
        found.append((True, 'The network started untrained. One that has seen photographs of anything, as --weights takes '
                            'it, finds much more after the same time.'))
    if not dataset.is_complete:
        found.append((False, 'The dataset is unfinished: its complete scenes were learnt from.'))
    unread = [each.file.name for each, what in zip(real.all, founds) if what is None]
    if unread:
        found.append((True, f'Photographs that cannot be read, and are left out: {len(unread):,}, such as {unread[0]}.'))
    if not real.is_labelled:
        found.append((False, 'The photographs have no labels, so it is not known what is right. Labels of 50 of them, as '
                             'text files beside them, give an AP50.'))
    elif real.without_file:
        found.append((False, f'{real.without_file:,} photographs have no file of labels and count as showing no object.'))
    if real.is_labelled and not real.has_classes:
        found.append((False, 'The labels have no classes: a find is right if there is an object of any class.'))
    found.append((False, f'A small network, which sees pictures {network.size} px wide or high, was trained for a short time on '
                         f'{network.device}. It compares datasets; a longer training of a larger network finds more.'))
    return found


def _result(score, of_own_kind, real, results):
    own = '' if of_own_kind is None else f'; in pictures of the dataset {of_own_kind:.3f}'
    if score is None:
        why = 'they show no object' if real.is_labelled else 'they have no labels'
        return f'{len(results):,} photographs, AP50 unknown: {why}{own}'
    count = sum(len(each.truth) for each in results)
    return f'AP50 in {len(results):,} photographs with {count:,} labels: {score:.3f}{own}'
