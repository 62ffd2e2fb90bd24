"""Recordings that are cut off, empty or still being made."""
import functools
from typing import List

import rosbag

from trial import Fault, Place, random_of, require, scaled

CUTS = 50


def refuse(place: Place, recording: bytes, name: str = 'broken.bag') -> None:
    broken = place.inputs / name
    broken.write_bytes(recording)
    try:
        finished = place.run({'bag_file': broken})
        place.require_refusal(finished, 'failed', name)
        require(not place.output.exists(), 'something was made')
    finally:
        broken.unlink()


def cut(number: int, place: Place) -> None:
    whole = (place.inputs / 'recording.bag').read_bytes()
    refuse(place, whole[:random_of('cut', number).randrange(1, len(whole))])


def cut_in_index(number: int, place: Place) -> None:
    """Cuts off the index, which is written last."""
    whole = (place.inputs / 'recording.bag').read_bytes()
    refuse(place, whole[:len(whole) - 1 - number * 7])


def empty(place: Place) -> None:
    refuse(place, b'')


def only_begun(place: Place) -> None:
    refuse(place, b'#ROSBAG V2.0\n')


def without_messages(place: Place) -> None:
    path = place.inputs / 'nothing.bag'
    rosbag.Bag(str(path), 'w').close()
    refuse(place, path.read_bytes())
    path.unlink()


def still_recorded(place: Place) -> None:
    """The file of a running `rosbag record`: whole chunks, no index, another name."""
    path = place.inputs / 'part.bag'
    source = rosbag.Bag(str(place.inputs / 'recording.bag'))
    recorder = rosbag.Bag(str(path), 'w', chunk_threshold=2048)
    for topic, message, time in source.read_messages():
        recorder.write(topic, message, time)
    recorder.flush()
    begun = path.read_bytes()
    recorder.close()
    source.close()
    path.unlink()
    refuse(place, begun, 'broken.bag.active')


def cuts(percent: int) -> List:
    count = scaled(CUTS, percent)
    return [functools.partial(cut, number) for number in range(count)] + [
        functools.partial(cut_in_index, number) for number in range(count // 5)]


FAULTS = [
    Fault('recording cut off', 'at random places in chunks, and in its index; nothing is made',
          cuts),
    Fault('recording empty or still being made', 'no byte, no message, no index',
          lambda _: [empty, only_begun, without_messages, still_recorded]),
]
