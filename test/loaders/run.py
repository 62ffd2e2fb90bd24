#!/usr/bin/env python3
"""Runs the tests of loaders; a line for each format and a total.

    run.py FOLDER [FORMAT...]

FOLDER is what make_loader_datasets wrote. Exit code 0 only if there are tests and all pass.
"""
import importlib
import io
import os
import pathlib
import sys
import tempfile
import unittest


def run(module):
    """The result of one file's tests, and their output."""
    suite = unittest.defaultTestLoader.loadTestsFromModule(importlib.import_module(module))
    stream = io.StringIO()
    result = unittest.TextTestRunner(stream=stream, verbosity=0).run(suite)
    return result, stream.getvalue()


def main():
    here = pathlib.Path(__file__).resolve().parent
    os.environ['SYNTHETIC_DATASET_LOADER_DATASETS'] = str(pathlib.Path(sys.argv[1]).resolve())
    sys.path.insert(0, str(here))
    chosen = sys.argv[2:] or sorted(file.name[:-len('_test.py')]
                                    for file in here.glob('*_test.py'))
    with tempfile.TemporaryDirectory() as scratch:
        os.chdir(scratch)  # cityscapesscripts leaves files in the current folder
        return run_all(chosen)


def run_all(names):
    total, bad = 0, 0
    for name in names:
        result, text = run(f'{name}_test')
        failed = len(result.failures) + len(result.errors)
        total += result.testsRun
        bad += failed
        print(f'{name:16} {result.testsRun - failed:3} passed, {failed} failed', flush=True)
        if failed:
            print(text)
    print(f'{"total":16} {total - bad:3} passed, {bad} failed')
    return 0 if total > 0 and bad == 0 else 1


if __name__ == '__main__':
    sys.exit(main())
