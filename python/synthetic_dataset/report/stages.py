"""The times of a run's stages, from the line that it prints at its end."""
import re

from synthetic_dataset.manifest import DatasetError

LINE = re.compile(r'time: set-up ([\d.]+) s; side by side drawing ([\d.]+) s, labels ([\d.]+) s, '
                  r'writing ([\d.]+) s; files of the whole dataset ([\d.]+) s')
NAMES = ('set-up', 'drawing', 'labels', 'writing', 'files of the whole dataset')


def stages_in(log):
    """The stages of the last run in a log file: names, seconds, per cent of the longest stage."""
    try:
        with open(log, encoding='utf-8', errors='replace') as stream:
            found = LINE.findall(stream.read())
    except OSError as error:
        raise DatasetError(f"'{log}': cannot be read: {error.strerror}") from error
    if not found:
        raise DatasetError(f"'{log}': has no line with the times of a run (`time: set-up ...`), "
                           'which a run prints that has made scenes')
    seconds = [float(number) for number in found[-1]]
    longest = max(max(seconds), 0.1)
    return [{'name': name, 'seconds': number, 'percent': 100 * number / longest}
            for name, number in zip(NAMES, seconds)]
