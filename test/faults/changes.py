"""Settings or inputs that changed between a kill and the next run."""
import contextlib
import functools
import pathlib
from typing import Any, Dict, Iterator, List

import dataset
import job
from trial import Fault, Place, require

SETTINGS: List[Dict[str, Any]] = [
    {'seed': 8}, {'simulated_rate': 4.0}, {'cameras/front/effects/noise_stddev': 0.02},
    {'yolo/cut_to_image': 'false'}, {'image/png_compression': 9}, {'alpha/class': 'car'}]


@contextlib.contextmanager
def changed(file: pathlib.Path) -> Iterator[None]:
    """Restores the file afterwards."""
    before = file.read_bytes()
    try:
        yield
    finally:
        file.write_bytes(before)


def files_but_for_log(found: dataset.Snapshot) -> dataset.Snapshot:
    """All but the manifest: its rows are compared, and SQLite may keep what it likes beside it."""
    return {path: file for path, file in found.items() if not dataset.is_of_manifest(path)}


def refuse(place: Place, settings: Dict[str, Any], name: str) -> None:
    files = files_but_for_log(dataset.snapshot(place.output))
    listed = place.listed()
    finished = place.run(settings)
    place.require_refusal(finished, 'failed', name)
    require(files_but_for_log(dataset.snapshot(place.output)) == files, 'files were changed')
    require(place.listed() == listed, 'the manifest was changed')


def other_setting(settings: Dict[str, Any], place: Place) -> None:
    place.kill_in_the_middle(5)
    refuse(place, settings, next(iter(settings)))
    place.look_for_losses()
    place.resume()


def other_setting_later(settings: Dict[str, Any], place: Place) -> None:
    """Another setting once the dataset is complete."""
    require(place.run().code == 0, 'an unbroken run fails')
    refuse(place, settings, next(iter(settings)))
    place.require_right()


def other_recording(place: Place) -> None:
    place.kill_in_the_middle(5)
    recording = place.inputs / 'recording.bag'
    with changed(recording):
        job.write_recording(recording, job.SMALL.instants / job.SMALL.rate, rate=40.0, way=1.1)
        refuse(place, {}, 'recording.bag')
    place.look_for_losses()
    place.resume()


def other_text(name: str, old: str, new: str, place: Place) -> None:
    place.kill_in_the_middle(5)
    file = place.inputs / name
    with changed(file):
        text = file.read_text(encoding='ascii')
        require(old in text, f'{name} has no "{old}"')
        file.write_text(text.replace(old, new, 1), encoding='ascii')
        refuse(place, {}, name)
    place.look_for_losses()
    place.resume()


def input_gone(name: str, place: Place) -> None:
    place.kill_in_the_middle(5)
    file = place.inputs / name
    with changed(file):
        file.unlink()
        refuse(place, {}, name)
    place.look_for_losses()
    place.resume()


FAULTS = [
    Fault('settings changed before the run goes on', 'refused by name; nothing is touched',
          lambda _: [functools.partial(what, each) for each in SETTINGS
                     for what in (other_setting, other_setting_later)]),
    Fault('inputs changed before the run goes on', 'recording, world, camera; or one is gone',
          lambda _: [other_recording,
                     functools.partial(other_text, 'tiny.world', '0.9 0.2 0.1', '0.9 0.2 0.2'),
                     functools.partial(other_text, 'camera.yaml', '84.0', '85.0'),
                     functools.partial(input_gone, 'recording.bag'),
                     functools.partial(input_gone, 'tiny.world')]),
]
