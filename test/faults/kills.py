"""kill -9 at random moments."""
import functools
import time
from typing import List

import dataset
import job
from trial import Failed, Fault, Place, random_of, require, scaled, wait_for

KILLS = 100
KILLS_IN_A_ROW = 4
ROWS = 10
SHORTEST = 0.001  # [s]


class Phases:
    """The phases of a run, as seen from the files that appear."""

    @staticmethod
    def never(_: Place) -> bool:
        return True

    @staticmethod
    def begun(place: Place) -> bool:
        return (place.output / 'manifest.sqlite').exists()

    @staticmethod
    def last_scene(place: Place) -> bool:
        return place.has_scene(job.SMALL.instants - 1)


# The phase after which a kill comes, the longest wait from there on as a share of an unbroken
# run's time, and how many of ten kills are of this kind.
PHASES = [(Phases.never, 0.6, 2), (Phases.begun, 0.5, 5), (Phases.last_scene, 0.2, 3)]


def phase_of(number: int):
    after, share, _ = [phase for phase in PHASES for _ in range(phase[2])][number % 10]
    return after, share


def kill_once(place: Place, number: int, delay: float) -> bool:
    """Whether the run was still going when it was killed."""
    after, _ = phase_of(number)
    process = place.start()
    wait_for(lambda: after(place), process)
    time.sleep(delay)
    process.kill()
    finished = place.end(process)
    require(finished.code in (0, -9), f'exits with {finished.code}:\n{finished.log}')
    return finished.code == -9


def kill_somewhere(place: Place, number: int, random) -> None:
    """Makes sure that a run is killed: if it ends first, another one is killed sooner."""
    delay = random.uniform(0.0, phase_of(number)[1]) * place.seconds
    while not kill_once(place, number, delay):
        if delay < SHORTEST:
            raise Failed('the run ends before it can be killed')
        place.clear()
        delay *= 0.6


def kill_and_resume(number: int, place: Place) -> None:
    kill_somewhere(place, number, random_of('kill', number))
    place.look_for_losses()
    place.resume()


def kill_in_a_row(number: int, place: Place) -> None:
    random = random_of('kills in a row', number)
    for _ in range(KILLS_IN_A_ROW):
        before = place.listed()
        process = place.start()
        time.sleep(random.uniform(0.3, 0.9) * place.seconds)
        process.kill()
        place.end(process)
        place.look_for_losses()
        now = place.listed()
        place.scene_lost += [f'scene {scene} is not listed any more'
                             for scene in before.keys() - now.keys()]
    place.resume()


def finished_again(place: Place) -> None:
    """A complete dataset is left alone."""
    finished = place.run()
    require(finished.code == 0, finished.log)
    before = dataset.snapshot(place.output)
    place.resume()
    require(before == dataset.snapshot(place.output), 'a complete dataset was changed')


def single(percent: int) -> List:
    return [functools.partial(kill_and_resume, number) for number in range(scaled(KILLS, percent))]


def rows(percent: int) -> List:
    return [functools.partial(kill_in_a_row, number) for number in range(scaled(ROWS, percent))]


FAULTS = [
    Fault('none: the same command twice', 'the second has nothing to do',
          lambda _: [finished_again]),
    Fault('kill -9', 'at random moments: starting, between and in scenes, finishing', single),
    Fault('kill -9 again and again',
          f'{KILLS_IN_A_ROW} runs of a dataset in a row, at random moments', rows),
]
