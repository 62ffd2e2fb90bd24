"""SIGINT and SIGTERM: an orderly end; after a second one, an immediate end."""
import functools
import signal
import time
from typing import List

import dataset
from trial import Fault, Place, random_of, require, scaled, wait_for

TRIALS = 5
CODES = {signal.SIGINT: 130, signal.SIGTERM: 143}


def stop(kind: signal.Signals, number: int, place: Place) -> None:
    process = place.start()
    wait_for(lambda: place.has_scene(number), process)
    process.send_signal(kind)
    finished = place.end(process)
    require(finished.code == CODES[kind],
            f'exits with {finished.code} instead of {CODES[kind]}:\n{finished.log}')
    require('same command' in finished.log, f'does not say how to go on:\n{finished.log}')
    place.look_for_losses()
    # Nothing is half done: only listed files are there, and no scene was only begun.
    there = {path for path, file in dataset.snapshot(place.output).items() if file.digest}
    listed = {path for paths in place.listed().values() for path in paths}
    require(there - listed == {'manifest.sqlite'},
            f'beside what is listed: {sorted(there - listed)[:4]}')
    require(len(place.listed()) > 0, 'no scene is listed')
    place.resume()


def stop_at_once(kind: signal.Signals, number: int, place: Place) -> None:
    pause = random_of('stop twice', number).uniform(0.0, 0.01)
    process = place.start()
    wait_for(lambda: place.has_scene(number), process)
    process.send_signal(kind)
    time.sleep(pause)
    if process.poll() is None:
        process.send_signal(kind)
    finished = place.end(process)
    # The first signal may have ended the run before the second one came.
    require(finished.code in (CODES[kind], -kind),
            f'exits with {finished.code}:\n{finished.log}')
    place.look_for_losses()
    place.resume()


def stop_while_starting(kind: signal.Signals, number: int, place: Place) -> None:
    pause = random_of('stop at the start', number).uniform(0.0, 0.5) * place.seconds
    process = place.start()
    time.sleep(pause)
    process.send_signal(kind)
    finished = place.end(process)
    # A quick run may have finished its last scene by then.
    require(finished.code in (CODES[kind], -kind, 0),
            f'exits with {finished.code}:\n{finished.log}')
    place.look_for_losses()
    place.resume()


def trials(kind_of_stop):
    def of(percent: int) -> List:
        return [functools.partial(kind_of_stop, kind, number)
                for kind in CODES for number in range(scaled(TRIALS, percent))]
    return of


FAULTS = [
    Fault('SIGINT, SIGTERM', 'after each of the first scenes; the scenes in work are finished',
          trials(stop)),
    Fault('SIGINT, SIGTERM while the run starts', 'at random moments', trials(stop_while_starting)),
    Fault('SIGINT, SIGTERM twice', 'at most 10 ms apart; the second ends the run at once',
          trials(stop_at_once)),
]
