"""Folders that cannot be written, or that disappear while a run writes into them."""
import contextlib
import functools
import os
import pathlib
import shutil
import subprocess
from typing import Iterator, List

import dataset
from full_disk import disk, make_space
from trial import Fault, Finished, Place, require, scaled, wait_for

TRIALS = 6


def without_privileges() -> List[str]:
    """The command before a program to which permissions apply even if root starts it."""
    if os.geteuid() != 0:
        return []
    return ['setpriv', '--inh-caps=-all', '--bounding-set=-all']


@contextlib.contextmanager
def closed(folder: pathlib.Path) -> Iterator[None]:
    """Meanwhile, nothing can be created or removed in the folder."""
    mode = folder.stat().st_mode
    folder.chmod(0o555)
    try:
        yield
    finally:
        folder.chmod(mode)


def require_permission_error(place: Place, finished: Finished) -> None:
    place.require_refusal(finished, 'Permission denied', str(place.output))


def no_permission_to_begin(place: Place) -> None:
    place.output.mkdir()
    with closed(place.output):
        require_permission_error(place, place.run(before=without_privileges()))
        require(not any(place.output.iterdir()), 'something was made')
    place.resume()


def no_permission_above(place: Place) -> None:
    outer = place.output
    outer.mkdir()
    with closed(outer):
        settings = {'output_folder': outer / 'deeper' / 'still'}
        require_permission_error(place, place.run(settings, before=without_privileges()))
        require(not any(outer.iterdir()), 'something was made')


def no_permission_to_go_on(inner: str, place: Place) -> None:
    place.kill_in_the_middle(4)
    with closed(place.output / inner):
        before = dataset.snapshot(place.output)
        finished = place.run(before=without_privileges())
        require_permission_error(place, finished)
        place.look_for_losses()
        gone = [path for path, file in before.items() if file.digest and
                not dataset.is_of_manifest(path) and not (place.output / path).exists()]
        listed = {path for paths in place.listed().values() for path in paths}
        require(not listed.intersection(gone), f'removed: {gone[:4]}')
    place.resume()


def permission_taken_away(number: int, place: Place) -> None:
    process = place.start(before=without_privileges())
    wait_for(lambda: place.has_scene(number), process)
    with closed(place.output / 'coco/images/train/front'):
        finished = place.end(process)
        if finished.code != 0:  # else all pictures were there already
            require_permission_error(place, finished)
        place.look_for_losses()
    place.resume()


def read_only_disk(place: Place) -> None:
    with disk(place, '64m'):
        place.kill_in_the_middle(4)
        subprocess.run(['mount', '-o', 'remount,ro', str(place.output)], check=True)
        place.require_refusal(place.run(), 'Read-only file system', str(place.output))
        place.look_for_losses()
        subprocess.run(['mount', '-o', 'remount,rw', str(place.output)], check=True)
        make_space(place)
        place.resume()


def gone(inner: str, number: int, place: Place) -> None:
    """The user removes or moves a folder; only what was in it is lost."""
    victim = place.output / inner
    process = place.start()
    wait_for(lambda: place.has_scene(number), process)
    # Renamed first, as a folder into which a run still writes cannot be emptied.
    elsewhere = place.folder / 'elsewhere'
    shutil.rmtree(elsewhere, ignore_errors=True)
    victim.rename(elsewhere)
    finished = place.end(process)
    require(finished.code in (0, 1), f'exits with {finished.code}:\n{finished.log}')
    if finished.code == 1:
        place.require_refusal(finished, str(place.output))
    shutil.rmtree(elsewhere, ignore_errors=True)


def whole_folder_gone(number: int, place: Place) -> None:
    gone('.', number, place)
    place.resume()


def becomes_a_file(number: int, place: Place) -> None:
    process = place.start()
    wait_for(lambda: place.has_scene(number), process)
    elsewhere = place.folder / 'elsewhere'
    shutil.rmtree(elsewhere, ignore_errors=True)
    place.output.rename(elsewhere)
    place.output.write_text('a file', encoding='ascii')
    finished = place.end(process)
    place.require_refusal(finished, 'failed', str(place.output))
    require(place.output.read_text(encoding='ascii') == 'a file', 'the file was changed')
    again = place.run()
    place.require_refusal(again, str(place.output))
    place.output.unlink()
    # The dataset that was moved away is unchanged.
    elsewhere.rename(place.output)
    place.look_for_losses()
    place.resume()


def numbered(what) -> 'function':
    return lambda percent: [functools.partial(what, number)
                            for number in range(scaled(TRIALS, percent))]


FAULTS = [
    Fault('no permission', 'folders that cannot be written, before the run or when it goes on',
          lambda _: [no_permission_to_begin, no_permission_above,
                     functools.partial(no_permission_to_go_on, 'coco/images/train/front'),
                     functools.partial(no_permission_to_go_on, 'yolo/high'),
                     functools.partial(no_permission_to_go_on, '.')]),
    Fault('permission taken away', 'from a folder that the run writes into',
          numbered(permission_taken_away)),
    Fault('read-only disk', 'remounted before the run goes on', lambda _: [read_only_disk]),
    Fault('folder removed', 'the whole dataset, while it is made', numbered(whole_folder_gone)),
    Fault('folder moved, a file in its place', 'while the dataset is made',
          numbered(becomes_a_file)),
]
