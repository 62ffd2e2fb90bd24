#!/usr/bin/env python3
"""Says what is in a dataset, from its manifest; exit code 1 when the dataset is not complete.

    rosrun synthetic_dataset describe_dataset.py FOLDER
"""
import pathlib
import sqlite3
import sys


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    folder = pathlib.Path(sys.argv[1])
    manifest = folder / 'manifest.sqlite'
    if not manifest.is_file():
        sys.exit(f'{manifest}: no such file; the run did not get as far as its first scene')
    database = sqlite3.connect(f'file:{manifest}?mode=ro', uri=True)
    state = database.execute("SELECT value FROM run WHERE key = 'state'").fetchone()[0]
    scenes = database.execute('SELECT count(*) FROM scene').fetchone()[0]
    print(f'Dataset in {folder}: {scenes} scenes, {state}')
    for name, kind, output_folder, files in database.execute(
            'SELECT name, type, output_folder,'
            ' (SELECT count(*) FROM file WHERE file.writer = writer."index")'
            ' FROM writer ORDER BY "index"'):
        print(f'  {name} ({kind}): {files} files in {(folder / output_folder).resolve()}')
    return 0 if state == 'complete' else 1


if __name__ == '__main__':
    sys.exit(main())
