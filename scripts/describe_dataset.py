#!/usr/bin/env python3
"""usage: describe_dataset.py FOLDER

Prints what is in a dataset, according to its manifest. FOLDER is the folder with the manifest.

  --help  prints this

  describe_dataset.py datasets/example

Exit codes: 0 the dataset is complete, 1 it is not complete or cannot be read, 2 wrong usage.
"""
import collections
import itertools
import json
import operator
import os
import pathlib
import sqlite3
import statistics
import sys
import urllib.parse

MOST_TEXTS = 5  # the most frequent ones of an entry are printed


def summary(numbers):
    return f'{min(numbers):.4g} to {max(numbers):.4g}, mean {statistics.fmean(numbers):.4g}'


def describe_draws(values):
    """Describes the values drawn for one entry: numbers, lists of numbers or texts."""
    if all(isinstance(value, (int, float)) for value in values):
        return summary(values)
    if all(isinstance(value, list) for value in values):
        return '; '.join(summary(component) for component in zip(*values))
    counts = collections.Counter(map(str, values))
    texts = [f"{count} x '{text}'" for text, count in counts.most_common(MOST_TEXTS)]
    more = len(counts) - len(texts)
    return ', '.join(texts) + (f' and {more} more' if more else '')


def print_draws(database):
    rows = database.execute('SELECT name, value FROM draw ORDER BY name')
    for name, draws in itertools.groupby(rows, key=operator.itemgetter(0)):
        values = [json.loads(value) for _, value in draws]
        print(f'  {name}, drawn for {len(values)} scenes: {describe_draws(values)}')


def print_motions(database):
    """Prints which scenes belong to which motion, if there are several."""
    motions = database.execute(
        'SELECT name, (SELECT count(*) FROM scene'
        ' WHERE instant >= first_instant AND instant < first_instant + instant_count),'
        ' first_instant, first_instant + instant_count - 1 FROM motion ORDER BY "index"').fetchall()
    if len(motions) < 2:
        return
    for name, scenes, first, last in motions:
        print(f"  motion '{name}': {scenes} scenes, numbers {first} to {last}")


def print_credits(database):
    """Prints whose work is in the pictures; manifests of older versions do not say."""
    if not database.execute("SELECT 1 FROM sqlite_master WHERE name = 'credit'").fetchone():
        return
    named = {path: (author, license_text) for path, author, license_text in database.execute(
        'SELECT path, author, license FROM credit')}
    inputs = [path for path, in database.execute('SELECT path FROM input')]
    models = [os.path.dirname(path) + '/' for path in inputs if path.endswith('/model.config')]
    # A model's description and material libraries count as the work of the author of its meshes.
    credited = tuple(model for model in models if any(path.startswith(model) for path in named))
    counts = collections.Counter(named.get(path, ('', '')) for path in inputs
                                 if path in named or not path.startswith(credited))
    for (author, license_text), count in sorted(counts.items(), key=lambda each: (-each[1], each)):
        print(f"  {count} input files: author {author or 'not named'}, licence "
              f"{license_text or 'not named'}")


def opened(manifest):
    """Opens a manifest, even where nothing can be written: there SQLite needs an immutable file."""
    name = urllib.parse.quote(str(manifest))
    try:
        database = sqlite3.connect(f'file:{name}?mode=ro', uri=True)
        database.execute('SELECT 1 FROM sqlite_master')
        return database
    except sqlite3.OperationalError:
        if manifest.with_name(manifest.name + '-wal').exists():
            raise
        return sqlite3.connect(f'file:{name}?immutable=1', uri=True)


def main():
    if sys.argv[1:] in (['--help'], ['-h']):
        print(__doc__.strip())
        return 0
    if len(sys.argv) != 2:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    folder = pathlib.Path(sys.argv[1])
    manifest = folder / 'manifest.sqlite'
    if not folder.is_dir():
        sys.exit(f'{folder}: no such folder')
    if not manifest.is_file() and any(folder.glob('manifest.shard-*.sqlite')):
        sys.exit(f'{folder}: holds shards, of which `merge` makes one dataset')
    if not manifest.is_file():
        sys.exit(f'{manifest}: no such file; the run did not get as far as its first scene')
    database = opened(manifest)
    state = database.execute("SELECT value FROM run WHERE key = 'state'").fetchone()[0]
    scenes = database.execute('SELECT count(*) FROM scene').fetchone()[0]
    print(f'Dataset in {folder}: {scenes} scenes, {state}')
    for name, kind, output_folder, files in database.execute(
            'SELECT name, type, output_folder,'
            ' (SELECT count(*) FROM file WHERE file.writer = writer."index")'
            ' FROM writer ORDER BY "index"'):
        print(f'  {name} ({kind}): {files} files in {(folder / output_folder).resolve()}')
    print_motions(database)
    print_credits(database)
    print_draws(database)
    return 0 if state == 'complete' else 1


if __name__ == '__main__':
    try:
        code = main()
        sys.stdout.flush()
        sys.exit(code)
    except BrokenPipeError:  # the reader of the pipe has seen enough
        os._exit(1)
    except sqlite3.Error as error:
        sys.exit(f'{sys.argv[1]}: the manifest cannot be read: {error}')
