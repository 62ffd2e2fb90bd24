"""Datasets that are made in parts: some scenes, then all; by processes that are killed."""
import functools
import time
from typing import List

import job
from trial import Fault, Place, random_of, require, scaled

TRIALS = 8
PROCESSES = 2


def scenes_first(number: int, place: Place) -> None:
    """Twice only some scenes, then all of them."""
    random = random_of('only_scenes', number)
    for _ in range(2):
        chosen = sorted(random.sample(range(job.SMALL.instants), random.randrange(1, 5)))
        finished = place.run({'only_scenes': chosen})
        require(finished.code == 0, f'exits with {finished.code}:\n{finished.log}')
        place.look_for_losses()
    place.resume()


def kill_processes(number: int, place: Place) -> None:
    """Several processes are killed together; then a run resumes or overwrites the dataset."""
    random = random_of('processes', number)
    several = {'processes': PROCESSES}
    process = place.start(several)
    time.sleep(random.uniform(0.0, 0.9) * place.seconds)
    process.kill()
    place.end(process)
    place.look_for_losses()
    finished = place.run({**several, 'if_exists': random.choice(['resume', 'overwrite'])})
    require(finished.code == 0, f'exits with {finished.code}:\n{finished.log}')
    place.require_right()
    left = sorted(path.name for path in place.output.glob('.*'))
    require(not left, f'left behind: {left}')


def kill_then_one(number: int, place: Place) -> None:
    """A run with a single process keeps nothing of processes that were killed at their start."""
    random = random_of('killed start', number)
    process = place.start({'processes': PROCESSES})
    time.sleep(random.uniform(0.0, 0.4) * place.seconds)
    process.kill()
    place.end(process)
    finished = place.run({'if_exists': 'overwrite'})
    require(finished.code == 0, f'exits with {finished.code}:\n{finished.log}')
    place.require_right()
    left = sorted(path.name for path in place.output.glob('.*'))
    require(not left, f'left behind: {left}')


def numbered(what):
    return lambda percent: [functools.partial(what, number)
                            for number in range(scaled(TRIALS, percent))]


FAULTS: List[Fault] = [
    Fault('some scenes, then all', '`only_scenes`, twice, at random', numbered(scenes_first)),
    Fault('kill -9 with `processes`', 'at random moments; then again', numbered(kill_processes)),
    Fault('kill -9 of a start with `processes`', 'then a run without', numbered(kill_then_one)),
]
