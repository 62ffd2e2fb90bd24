"""A dataset's manifest as numpy columns; docs/manifest.md describes its tables."""
import os
import pathlib
import sqlite3
import threading
import urllib.parse

import numpy as np

OLDEST_VERSION = 4


class DatasetError(Exception):
    """A dataset cannot be read, or lacks what was asked for."""


def _connected(file):
    """Opens a manifest, even where nothing can be written: there SQLite needs an immutable file."""
    name = urllib.parse.quote(str(file))
    try:
        database = sqlite3.connect(f'file:{name}?mode=ro', uri=True)
        database.execute('SELECT 1 FROM sqlite_master')
        return database
    except sqlite3.OperationalError:
        if file.with_name(file.name + '-wal').exists():
            raise
        return sqlite3.connect(f'file:{name}?immutable=1', uri=True)


def _file_in(folder):
    if not folder.is_dir():
        raise DatasetError(f"'{folder}': no such folder")
    file = folder / 'manifest.sqlite'
    if file.is_file():
        return file
    if any(folder.glob('manifest.shard-*.sqlite')):
        raise DatasetError(f"'{folder}': holds shards, of which `rosrun synthetic_dataset merge "
                           f'{folder}` makes one dataset')
    raise DatasetError(f"'{folder}': no dataset is there (a run leaves its manifest.sqlite in its "
                       'output_folder)')


def _array(values):
    """An array; numbers with None become floating point with NaN, other values stay as they are."""
    if all(value is None or isinstance(value, (int, float)) for value in values):
        if any(value is None for value in values):
            return np.array([np.nan if value is None else value for value in values], float)
        return np.array(values) if values else np.zeros(0)
    return np.array(values, object)


class Manifest:
    """A manifest. Each thread and each process that uses it opens the file for itself.

    The workers of data loaders may therefore use it, whether they are forked or receive it pickled.
    """

    def __init__(self, folder):
        self.folder = pathlib.Path(folder).resolve()
        self.file = _file_in(self.folder)
        self._opened = threading.local()
        try:
            self.run = dict(self._database.execute('SELECT key, value FROM run'))
            version = int(self.run['format_version'])
        except (sqlite3.Error, KeyError, ValueError) as error:
            raise DatasetError(f"'{self.file}': the manifest cannot be read: {error}") from error
        if version < OLDEST_VERSION:
            raise DatasetError(f"'{self.file}': its format version is {version}; versions from "
                               f'{OLDEST_VERSION} on can be read')

    @property
    def _database(self):
        if getattr(self._opened, 'process', None) != os.getpid():
            self._opened.database = _connected(self.file)
            self._opened.process = os.getpid()
        return self._opened.database

    def __getstate__(self):
        return {name: value for name, value in self.__dict__.items() if name != '_opened'}

    def __setstate__(self, state):
        self.__dict__.update(state)
        self._opened = threading.local()

    def rows(self, sql, values=()):
        """All rows of a query, as tuples."""
        try:
            return self._database.execute(sql, values).fetchall()
        except sqlite3.Error as error:
            raise DatasetError(f"'{self.file}': the manifest cannot be read: {error}") from error

    def tables(self):
        """The names of all tables."""
        return [name for name, in self.rows(
            "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name")]

    def columns(self, table, where='', values=()):
        """A table as {column: array}, in the order of its key.

        @param where  an SQL condition that selects rows, with a ? for each of `values`
        """
        if table not in self.tables():
            raise DatasetError(f"'{self.file}': has no table '{table}'; it has "
                               + ', '.join(self.tables()))
        layout = self.rows(f'PRAGMA table_info("{table}")')
        names = [row[1] for row in layout]
        key = [f'"{row[1]}"' for row in sorted(layout, key=lambda row: row[5]) if row[5]]
        rows = self.rows(f'SELECT * FROM "{table}"' + (f' WHERE {where}' if where else '')
                         + (' ORDER BY ' + ', '.join(key) if key else ''), values)
        columns = zip(*rows) if rows else ([] for _ in names)
        return {name: _array(list(column)) for name, column in zip(names, columns)}
