"""Manifests that are damaged, of another version, or no manifests at all."""
import functools
import os
import pathlib
import shutil
import signal
import sqlite3
from typing import Callable, List

import dataset
from trial import Fault, Finished, Place, random_of, require, scaled, wait_for

FLIPS = 40
CUTS = 8


def make(place: Place, complete: bool) -> pathlib.Path:
    """Makes a dataset, whole or stopped in the middle, whose manifest has no log beside it."""
    process = place.start()
    if not complete:
        wait_for(lambda: place.has_scene(5), process)
        process.send_signal(signal.SIGINT)
    finished = place.end(process)
    require(finished.code == (0 if complete else 130), finished.log)
    return place.output / 'manifest.sqlite'


def require_untouched(place: Place, before: dataset.Snapshot) -> None:
    wrong = dataset.differences(dataset.snapshot(place.output), before)
    require(not wrong, 'was changed: ' + '; '.join(wrong[:4]))


def refuse(damage: Callable[[pathlib.Path], None], complete: bool, word: str,
           place: Place) -> None:
    damage(make(place, complete))
    before = dataset.snapshot(place.output)
    for settings in ({}, {'if_exists': 'overwrite'}):
        place.require_refusal(place.run(settings), 'failed', word)
        require_untouched(place, before)


def empty(manifest: pathlib.Path) -> None:
    manifest.write_bytes(b'')


def text(manifest: pathlib.Path) -> None:
    manifest.write_text('no manifest\n' * 1000, encoding='ascii')


def folder(manifest: pathlib.Path) -> None:
    manifest.unlink()
    manifest.mkdir()


def link_to_nowhere(manifest: pathlib.Path) -> None:
    manifest.unlink()
    manifest.symlink_to('nowhere')


def link_to_itself(manifest: pathlib.Path) -> None:
    manifest.unlink()
    manifest.symlink_to(manifest.name)


def pipe(manifest: pathlib.Path) -> None:
    """Opening a pipe would wait forever."""
    manifest.unlink()
    os.mkfifo(manifest)


def cut_short(share: float):
    def damage(manifest: pathlib.Path) -> None:
        os.truncate(manifest, int(manifest.stat().st_size * share))
    return damage


def sql(*statements: str):
    def damage(manifest: pathlib.Path) -> None:
        database = sqlite3.connect(manifest)
        for statement in statements:
            database.execute(statement)
        database.commit()
        database.close()
    return damage


def files_beside_manifest(snapshot: dataset.Snapshot) -> dataset.Snapshot:
    return {path: file for path, file in snapshot.items() if not dataset.is_of_manifest(path)}


def require_right_or_stopped(place: Place, finished: Finished, before: dataset.Snapshot) -> None:
    if finished.code == 0:
        place.require_right()
        return
    require(finished.code == 1 and 'failed' in finished.log,
            f'exits with {finished.code}:\n{finished.log}')
    now = dataset.snapshot(place.output)
    wrong = [path for path in files_beside_manifest(before) if path not in now]
    require(not wrong, f'was removed: {wrong[:4]}')


def without_rows(statements: List[str], place: Place) -> None:
    """Scenes that the manifest no longer knows are made again, or an error ends the run."""
    sql(*statements)(make(place, complete=False))
    before = dataset.snapshot(place.output)
    require_right_or_stopped(place, place.run(), before)


def flip(number: int, place: Place) -> None:
    """With flipped bits, the manifest may be wrong about files, but the files never are."""
    random = random_of('flip', number)
    manifest = make(place, complete=number % 2 == 0)
    content = bytearray(manifest.read_bytes())
    header = number % 3 == 0
    for _ in range(random.choice((1, 8, 64))):
        place_of_flip = random.randrange(100 if header else len(content))
        content[place_of_flip] ^= 1 << random.randrange(8)
    manifest.write_bytes(content)
    before = dataset.snapshot(place.output)
    finished = place.run()
    if finished.code == 1:
        require('failed' in finished.log, f'gives no reason:\n{finished.log}')
        now = dataset.snapshot(place.output)
        wrong = [path for path in files_beside_manifest(before) if path not in now]
        require(not wrong, f'was removed: {wrong[:4]}')
    else:
        require(finished.code == 0, f'exits with {finished.code}:\n{finished.log}')
    # Dataset-wide files are made from the manifest's records, which may be wrong now.
    found = {path: file for path, file in dataset.snapshot(place.output).items() if path in before}
    place.half_written += dataset.half_written(found, place.reference)


BOTH = (True, False)


def no_manifests(_: int) -> List:
    kinds = (empty, text, folder, link_to_nowhere, link_to_itself, pipe)
    return [functools.partial(refuse, kind, complete, 'manifest.sqlite')
            for kind in kinds for complete in BOTH]


def versions(_: int) -> List:
    changes = ("UPDATE run SET value = '8' WHERE key = 'format_version'",
               "UPDATE run SET value = '2000' WHERE key = 'format_version'",
               "DELETE FROM run WHERE key = 'format_version'")
    return [functools.partial(refuse, sql(change), complete, 'version')
            for change in changes for complete in BOTH]


def parts_gone(percent: int) -> List:
    count = scaled(CUTS, percent)
    cuts = [functools.partial(refuse, cut_short((k + 0.5) / count), k % 2 == 0, 'manifest.sqlite')
            for k in range(count)]
    tables = [functools.partial(refuse, sql(f'DROP TABLE {table}'), False, 'manifest.sqlite')
              for table in ('run', 'scene', 'file', 'writer', 'setting', 'record')]
    return cuts + tables


def rows_gone(_: int) -> List:
    changes = (['DELETE FROM scene WHERE "index" = 3'], ['DELETE FROM scene'],
               ['DELETE FROM file WHERE scene = 3'],
               ['DELETE FROM file'], ['DELETE FROM setting'],
               ["DELETE FROM run WHERE key = 'state'"], ['DELETE FROM writer'])
    return [functools.partial(without_rows, change) for change in changes]


def flips(percent: int) -> List:
    return [functools.partial(flip, number) for number in range(scaled(FLIPS, percent))]


FAULTS = [
    Fault('no manifest', 'empty, a text, a folder, a link to nowhere or itself, a pipe in its '
          'place; nothing is touched', no_manifests),
    Fault('manifest of a newer version', 'nothing is touched', versions),
    Fault('manifest cut short', 'also tables that are gone; nothing is touched', parts_gone),
    Fault('manifest without some rows', 'of runs, scenes, files, settings, writers: made again, or '
          'an error; no other file is touched',
          rows_gone),
    Fault('bits flipped in the manifest', '1, 8 or 64, in its header or anywhere', flips),
]
