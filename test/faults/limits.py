"""Limits of the process: file sizes, descriptors, memory."""
import functools
from typing import List

from trial import Failed, Fault, Finished, Place, require

FILE_SIZES = [0, 1, 1000, 4096, 5000, 20000, 33000, 66000, 100000, 200000, 400000, 800000, 1600000]
DESCRIPTORS = [*range(3, 15), *range(16, 40, 3)]
MEGABYTES = [20, 100, 180, 240, 300, 360, 420, 460, 500, 600, 700, 1000]
NOT_LOADED = 127  # the dynamic loader says why


def check(place: Place, finished: Finished, may_die: bool) -> None:
    if finished.code == 0:
        place.require_right()
        return
    if not (may_die and finished.died) and finished.code != NOT_LOADED:
        place.require_refusal(finished, 'failed')
    require(finished.log != '' or finished.died, 'fails without a word')
    place.look_for_losses()
    place.resume()


def limit(option: str, may_die: bool, place: Place) -> None:
    finished = place.run(before=['prlimit', option])
    try:
        check(place, finished, may_die)
    except Failed as error:
        raise Failed(f'{option}: {error}') from None


def trials(name: str, values: List[int], may_die: bool = False):
    def of(percent: int) -> List:
        step = max(1, round(100 / percent))
        return [functools.partial(limit, f'--{name}={value}', may_die)
                for value in values[::step]]
    return of


FAULTS = [
    Fault('limit of file sizes', 'RLIMIT_FSIZE, 13 values; an error, not a signal',
          trials('fsize', FILE_SIZES)),
    Fault('limit of open files', 'RLIMIT_NOFILE, from 3 on', trials('nofile', DESCRIPTORS)),
    Fault('limit of memory', 'RLIMIT_AS, 20 MB to 1 GB',
          trials('as', [value << 20 for value in MEGABYTES], may_die=True)),
]
