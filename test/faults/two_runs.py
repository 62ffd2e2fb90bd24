"""Two runs into one folder at once."""
import functools
import time
from typing import List

from trial import Fault, Finished, Place, random_of, require, scaled, wait_for

TRIALS = 20


def require_one_refused(place: Place, first: Finished, second: Finished) -> None:
    codes = sorted((first.code, second.code))
    if codes == [0, 0] and 'complete already' in first.log + second.log:
        place.require_right()  # on a busy machine, one run had ended when the other began
        return
    require(codes == [0, 1], f'exit codes {codes}:\n{first.log}\n{second.log}')
    refused = first if first.code == 1 else second
    place.require_refusal(refused, 'another run', str(place.output))
    place.require_right()


def at_once(number: int, place: Place) -> None:
    pause = random_of('two runs', number).uniform(0.0, 0.02)
    first = place.start()
    time.sleep(pause)
    second = place.start()
    second_end = place.end(second)
    require_one_refused(place, place.end(first), second_end)


def later(number: int, place: Place) -> None:
    first = place.start()
    wait_for(lambda: place.has_scene(number % 6), first)
    second = place.end(place.start())
    # The first run may be done before the second one checks.
    first_end = place.end(first)
    if second.code != 0:
        require_one_refused(place, first_end, second)
    place.require_right()


def overwriting(number: int, place: Place) -> None:
    first = place.start()
    wait_for(lambda: place.has_scene(number % 6), first)
    second = place.end(place.start({'if_exists': 'overwrite'}))
    first_end = place.end(first)
    if second.code != 0:
        require_one_refused(place, first_end, second)
    place.require_right()


def both_resume(number: int, place: Place) -> None:
    place.kill_in_the_middle(number % 6)
    at_once(number, place)


def lock_of_killed_run(place: Place) -> None:
    place.kill_in_the_middle(3)
    place.look_for_losses()
    place.resume()


def numbered(what, share: float):
    return lambda percent: [functools.partial(what, number)
                            for number in range(scaled(round(TRIALS * share), percent))]


def all_at_once(percent: int) -> List:
    return [*numbered(at_once, 1.0)(percent), *numbered(both_resume, 0.3)(percent)]


FAULTS = [
    Fault('two runs at once', 'started within 20 ms, on nothing and on what a killed run left; '
          'one is refused', all_at_once),
    Fault('a run into one that goes on', 'also with `if_exists: overwrite`',
          lambda percent: [*numbered(later, 0.2)(percent), *numbered(overwriting, 0.2)(percent)]),
    Fault('lock of a killed run', 'does not stay', lambda _: [lock_of_killed_run]),
]
