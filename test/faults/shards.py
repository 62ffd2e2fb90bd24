"""Shards that are killed, and their merging."""
import functools
import time
from typing import Dict, List

import dataset
from trial import Fault, Place, random_of, require, scaled

COUNT = 3
TRIALS = 6


def shard(index: int) -> Dict[str, int]:
    return {'shard/index': index, 'shard/count': COUNT}


def merge(place: Place) -> List[str]:
    return [str(place.programs / 'merge'), str(place.output)]


def require_merged(place: Place) -> None:
    finished = place.run(program=merge(place))
    require(finished.code == 0, f'merging exits with {finished.code}:\n{finished.log}')
    place.require_right()


def make_shards(place: Place) -> None:
    for index in range(COUNT):
        finished = place.run(shard(index))
        require(finished.code == 0, f'shard {index} exits with {finished.code}:\n{finished.log}')


def kill_shards(number: int, place: Place) -> None:
    random = random_of('shards', number)
    for index in random.sample(range(COUNT), COUNT):
        for _ in range(random.randrange(1, 3)):
            process = place.start(shard(index))
            time.sleep(random.uniform(0.3, 1.0) * place.seconds)
            process.kill()
            place.end(process)
            place.look_for_losses()
    make_shards(place)
    require_merged(place)


def kill_merge(number: int, place: Place) -> None:
    random = random_of('merge', number)
    make_shards(place)
    before = place.listed()
    process = place.start(program=merge(place))
    time.sleep(random.uniform(0.0, 0.3) * place.seconds)
    process.kill()
    place.end(process)
    place.look_for_losses()
    place.scene_lost += [f'scene {scene} is not listed any more'
                         for scene in before.keys() - place.listed().keys()]
    require_merged(place)


def at_once(number: int, place: Place) -> None:
    """All shards side by side in one folder."""
    processes = [place.start(shard(index)) for index in range(COUNT)]
    for process in processes:
        finished = place.end(process)
        require(finished.code == 0, f'exits with {finished.code}:\n{finished.log}')
    require_merged(place)


def merge_of_half(number: int, place: Place) -> None:
    """Merges while a shard is missing."""
    for index in range(COUNT):
        if index != number % COUNT:
            require(place.run(shard(index)).code == 0, 'a shard fails')
    before = dataset.snapshot(place.output)
    place.require_refusal(place.run(program=merge(place)), 'shard')
    require(dataset.snapshot(place.output) == before, 'merging changed something')
    make_shards(place)
    require_merged(place)


def shard_while_merging(place: Place) -> None:
    make_shards(place)
    process = place.start(program=merge(place))
    shard_run = place.run(shard(1))
    merged = place.end(process)
    require(merged.code in (0, 1), f'exits with {merged.code}:\n{merged.log}')
    require(shard_run.code in (0, 1), f'exits with {shard_run.code}:\n{shard_run.log}')
    require_merged(place)


def numbered(what):
    return lambda percent: [functools.partial(what, number)
                            for number in range(scaled(TRIALS, percent))]


FAULTS = [
    Fault('kill -9 of shards', 'each of three, once or twice, at random moments',
          numbered(kill_shards)),
    Fault('kill -9 of `merge`', 'at random moments', numbered(kill_merge)),
    Fault('shards side by side', 'three processes, one folder', numbered(at_once)),
    Fault('`merge` without all shards', 'refused; nothing is touched', lambda _: [
        functools.partial(merge_of_half, number) for number in range(COUNT)]),
    Fault('a shard while `merge` works', 'started together', lambda _: [shard_while_merging]),
]
