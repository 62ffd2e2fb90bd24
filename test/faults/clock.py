"""The system's clock is set back by a day while a run goes on."""
import functools
import pathlib
import shutil
import subprocess
from typing import List

from trial import Fault, Place, Skipped, require

SOURCE = pathlib.Path(__file__).with_name('clock_set_back.c')
AFTER = [0, 1, 2, 5, 10, 20, 50, 100]  # calls that read the time


def preload(place: Place) -> pathlib.Path:
    if shutil.which('cc') is None:
        raise Skipped('there is no C compiler')
    library = place.folder / 'clock_set_back.so'
    subprocess.run(['cc', '-shared', '-fPIC', '-O1', '-o', str(library), str(SOURCE), '-ldl'],
                   check=True)
    return library


def environment_with(place: Place, after: int) -> dict:
    return {**place.environment, 'LD_PRELOAD': str(preload(place)), 'SET_BACK_AFTER': str(after)}


def set_back(after: int, place: Place) -> None:
    finished = place.run(environment=environment_with(place, after))
    require(finished.code == 0, f'exits with {finished.code}:\n{finished.log}')
    place.require_right()


def set_back_before_resuming(after: int, place: Place) -> None:
    """The clock is then earlier than the files that are there."""
    place.kill_in_the_middle(after % 7)
    set_back(0, place)


def trials(_: int) -> List:
    return [functools.partial(what, after) for after in AFTER
            for what in (set_back, set_back_before_resuming)]


FAULTS = [Fault('clock set back by a day', 'in the middle of a run, and between two', trials)]
