"""Disks that fill up: tmpfs file systems with little space, or few files, for the dataset."""
import contextlib
import functools
import os
import pathlib
import subprocess
from typing import Iterator, List, Optional

from trial import Fault, Place, Skipped, require, scaled

TRIALS = 20
PLENTY = '64m,nr_inodes=100000'
PAGE = 4096
REASONS = ('No space left on device', 'disk is full')


@contextlib.contextmanager
def disk(place: Place, size: str, folder: Optional[pathlib.Path] = None) -> Iterator[None]:
    """Meanwhile, `folder`, by default the dataset's, is a disk of its own."""
    if os.geteuid() != 0:
        raise Skipped('only root may mount a disk, and there are no user namespaces')
    target = folder or place.output
    target.mkdir()
    mounted = subprocess.run(['mount', '-t', 'tmpfs', '-o', f'size={size},mode=755', 'none',
                              str(target)], check=False, capture_output=True, text=True)
    if mounted.returncode != 0:
        target.rmdir()
        raise Skipped('tmpfs cannot be mounted: ' + mounted.stderr.strip())
    try:
        yield
    finally:
        subprocess.run(['umount', str(target)], check=True)
        target.rmdir()


def make_space(place: Place) -> None:
    subprocess.run(['mount', '-o', f'remount,size={PLENTY}', str(place.output)], check=True)


def fill(size: str, place: Place) -> None:
    with disk(place, size):
        finished = place.run()
        place.require_refusal(finished, 'failed', str(place.output))
        require(any(reason in finished.log for reason in REASONS),
                f'does not say that the disk is full:\n{finished.log}')
        place.look_for_losses()
        make_space(place)
        place.resume()


def pages_needed(place: Place) -> int:
    """The pages of a complete dataset; while it is made, there is SQLite's log as well."""
    sizes: List[int] = []
    for path in place.output.rglob('*'):
        status = path.stat()
        if path.is_file():
            sizes.append(-(-status.st_size // PAGE) / status.st_nlink)
    return round(sum(sizes))


def fill_at(number: int, count: int, place: Place) -> None:
    finished = place.run()
    require(finished.code == 0, finished.log)
    pages = pages_needed(place)
    place.clear()
    # The smallest is one page, as a size of 0 means no limit. The largest is a page too small.
    fill(str(PAGE * (1 + (pages - 2) * number // max(1, count - 1))), place)


def fill_files_at(number: int, count: int, place: Place) -> None:
    whole = len([file for file in place.reference.values()])
    fill(f'64m,nr_inodes={2 + (whole // 2) * number // count}', place)


def space(percent: int) -> List:
    count = scaled(TRIALS, percent)
    return [functools.partial(fill_at, number, count) for number in range(count)]


def files(percent: int) -> List:
    count = scaled(TRIALS // 3, percent)
    return [functools.partial(fill_files_at, number, count) for number in range(count)]


FAULTS = [
    Fault('full disk', 'tmpfs of sizes from one page up to one page too few', space),
    Fault('no more files on the disk', 'tmpfs with few inodes', files),
]
