"""The contents of a dataset's folder, read without the code under test."""
import hashlib
import os
import pathlib
import shutil
import sqlite3
import tempfile
from typing import Dict, List, NamedTuple, Set


class File(NamedTuple):
    """All of a file that two equal runs have in common."""

    digest: str
    mode: int
    links: int  # number of hard links


Snapshot = Dict[str, File]  # by path relative to the folder; folders have an empty digest


def read_file(path: pathlib.Path) -> File:
    status = path.lstat()
    digest = ''
    if path.is_symlink():
        digest = 'link to ' + os.readlink(path)
    elif path.is_file():
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
    return File(digest, status.st_mode, 0 if path.is_dir() else status.st_nlink)


def snapshot(folder: pathlib.Path) -> Snapshot:
    """Every file and folder below a folder, hidden ones too; empty if there is no such folder."""
    return {str(path.relative_to(folder)): read_file(path) for path in folder.rglob('*')}


def differences(found: Snapshot, expected: Snapshot) -> List[str]:
    result = [f'{path} is missing' for path in sorted(expected.keys() - found.keys())]
    result += [f'{path} is left over' for path in sorted(found.keys() - expected.keys())]
    for path in sorted(found.keys() & expected.keys()):
        if found[path].digest != expected[path].digest:
            result.append(f'{path} has other bytes')
        elif found[path] != expected[path]:
            result.append(f'{path}: {found[path]} instead of {expected[path]}')
    return result


def is_of_manifest(path: str) -> bool:
    return pathlib.PurePath(path).name.startswith(('manifest.', '.manifest.'))


def is_temporary(path: str) -> bool:
    name = pathlib.PurePath(path).name
    return name.startswith('.') and name.endswith('.tmp')


def half_written(found: Snapshot, expected: Snapshot) -> List[str]:
    """Files that have their final name, but not the bytes of an unbroken run."""
    return [path for path, file in sorted(found.items())
            if file.digest and not is_of_manifest(path) and not is_temporary(path) and
            (path not in expected or expected[path].digest != file.digest)]


class Listed(NamedTuple):
    """The scenes that count according to a manifest, and their files."""

    state: str                       # of the run
    files: Dict[int, Set[str]]       # by scene: paths relative to the manifest's folder
    complete: Set[int]               # scenes that are safe from a power cut


def listed_scenes(manifest: pathlib.Path) -> Listed:
    """Reads a copy: SQLite would tidy up what a killed run left beside the manifest itself."""
    with tempfile.TemporaryDirectory() as scratch:
        copy = pathlib.Path(scratch) / 'manifest.sqlite'
        for end in ('', '-wal'):
            part = manifest.with_name(manifest.name + end)
            if part.exists():
                shutil.copyfile(part, copy.with_name(copy.name + end))
        database = sqlite3.connect(copy)
        try:
            return _listed_scenes(database)
        finally:
            database.close()


def _listed_scenes(database: sqlite3.Connection) -> Listed:
    if database.execute('SELECT 1 FROM sqlite_master').fetchone() is None:
        return Listed('', {}, set())  # the manifest has no tables yet
    state = database.execute("SELECT value FROM run WHERE key = 'state'").fetchone()[0]
    scenes = database.execute('SELECT "index", state FROM scene').fetchall()
    files: Dict[int, Set[str]] = {
        index: set() for index, scene_state in scenes if scene_state in ('written', 'complete')}
    for scene, path in database.execute('SELECT scene, path FROM file WHERE scene NOT NULL'):
        if scene in files:
            files[scene].add(path)
    return Listed(state, files, {index for index, scene_state in scenes
                                 if scene_state == 'complete'})


def lost_scenes(listed: Listed, found: Snapshot, expected: Snapshot) -> List[int]:
    """Listed scenes with a file that is missing or differs from that of an unbroken run."""
    def is_whole(path: str) -> bool:
        return path in found and path in expected and found[path].digest == expected[path].digest
    return [scene for scene, paths in sorted(listed.files.items())
            if not paths or not all(map(is_whole, paths))]
