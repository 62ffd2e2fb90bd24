"""Power cuts, as far as a test can simulate them: data not forced to the disk is lost or torn."""
import functools
import pathlib
import random as random_numbers
import re
from typing import List, Tuple

import dataset
from exact_places import strace
from trial import Fault, Place, random_of, require, scaled

TRIALS = 12
SQLITE_FRAME = 4096 + 24  # [bytes] of a page in the log


def tear(file: pathlib.Path, random: random_numbers.Random) -> None:
    """Leaves a file as file systems may if its name was written before its content."""
    size = file.stat().st_size
    kind = random.choice(('empty', 'shorter', 'zeros', 'missing', 'whole'))
    if kind == 'missing':
        file.unlink()
    elif kind == 'zeros':
        with open(file, 'r+b') as opened:
            opened.seek(random.randrange(size) if size else 0)
            opened.write(bytes(size - opened.tell()))
    elif kind != 'whole':
        with open(file, 'r+b') as opened:
            opened.truncate(0 if kind == 'empty' else size // 2)


def scenes_not_yet_safe(place: Place) -> Tuple[List[str], List[str]]:
    """The files of scenes that are safe, and the other files."""
    listed = dataset.listed_scenes(place.output / 'manifest.sqlite')
    safe = [path for scene in sorted(listed.complete) for path in sorted(listed.files[scene])]
    files = [str(path.relative_to(place.output)) for path in sorted(place.output.rglob('*'))
             if path.is_file()]
    return safe, [path for path in files if path not in safe and not dataset.is_of_manifest(path)]


def tear_files(place: Place, random: random_numbers.Random) -> None:
    for path in scenes_not_yet_safe(place)[1]:
        if (place.output / path).exists():
            tear(place.output / path, random)


def go_on(place: Place, settings: dict) -> None:
    safe = {path: (place.output / path).stat().st_ino for path in scenes_not_yet_safe(place)[0]}
    finished = place.run(settings)
    require(finished.code == 0, f'resuming exits with {finished.code}:\n{finished.log}')
    place.require_right()
    again = [path for path, inode in safe.items() if (place.output / path).stat().st_ino != inode]
    require(not again, f'made again although it was safe: {again[:4]}')


def files_torn(sync: str, number: int, place: Place) -> None:
    random = random_of('power cut', sync, number)
    settings = {'sync': sync}
    place.kill_in_the_middle(random.randrange(2, 10), settings)
    tear_files(place, random)
    go_on(place, settings)


def log_cut_short(number: int, place: Place) -> None:
    """The last scenes' rows are lost too; their files may be whole, torn or missing."""
    random = random_of('log', number)
    place.kill_in_the_middle(random.randrange(2, 10))
    log = place.output / 'manifest.sqlite-wal'
    kept = random.randrange(log.stat().st_size)
    with open(log, 'r+b') as opened:
        opened.truncate(kept)
    # The log's index is only in memory; that of the killed run is lost with the power.
    (place.output / 'manifest.sqlite-shm').unlink()
    tear_files(place, random)
    go_on(place, {})


def log_gone(place: Place) -> None:
    place.kill_in_the_middle(4)
    (place.output / 'manifest.sqlite-wal').unlink()
    (place.output / 'manifest.sqlite-shm').unlink()
    go_on(place, {})


def safe_in_this_order(place: Place) -> None:
    """With `sync: scene`, a scene's files reach the disk before the manifest calls it complete."""
    calls = 'rename,syncfs,fdatasync,fsync,pwrite64'
    finished = place.run({'sync': 'scene'}, before=strace(place, '-y', '-e', f'trace={calls}'))
    require(finished.code == 0, finished.log)
    place.require_right()
    trace = (place.folder / 'trace').read_text(errors='replace').splitlines()
    # r: a scene's file gets its name, s: the disk is synced, m: the manifest's log is written,
    # f: the log is synced.
    patterns = ((r'rename\(.*yolo/\w+/\d+\.txt"', 'r'), (r'syncfs\(', 's'),
                (r'pwrite64\(\d+<.*-wal>', 'm'), (r'f(data)?sync\(\d+<.*-wal>', 'f'))
    order = ''.join(letter for line in trace for pattern, letter in patterns
                    if re.search(pattern, line))
    scenes = len(place.listed())
    found = len(re.findall('r[^r]*?s[^r]*?m+f', order))
    require(found == scenes, f'{found} of {scenes} scenes are safe before they are called so: '
            + re.sub('m+', 'm', order))


def files(percent: int) -> List:
    return [functools.partial(files_torn, sync, number) for sync in ('batch', 'scene')
            for number in range(scaled(TRIALS, percent))]


def logs(percent: int) -> List:
    return [functools.partial(log_cut_short, number) for number in range(scaled(TRIALS, percent))]


FAULTS = [
    Fault('power cut: files', 'after a kill, files that were not yet safe are emptied, cut short, '
          'zeroed, removed', files),
    Fault('power cut: manifest', 'the end of its log is gone as well', lambda percent: [
        log_gone, *logs(percent)]),
    Fault('power cut with `sync: scene`', 'strace sees that files are forced to the disk before '
          'the manifest calls their scene complete', lambda _: [safe_in_this_order]),
]
