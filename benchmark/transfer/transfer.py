#!/usr/bin/env python3
"""Measures what networks trained only on our pictures find in photographs: a row for each way to make the pictures.

  transfer.py WORK --model MODEL --real PHOTOGRAPHS --train COMMAND
              [--rows a,b] [--scenes 3000] [--confirm 5] [--seeds 3] [--full]

MODEL is a model's folder or URI. WORK gets the datasets, results.json and table.md; whatever exists is not made again.
COMMAND is called as `COMMAND DATASET --real PHOTOGRAPHS --part even|odd --seed N [--full]` and prints a line of JSON
with {"real": {"ap50": ...}}. Rows are compared on the photographs with even indices, with seed 0. The --confirm best
rows are then measured on those with odd indices, with --seeds seeds, and with --full also by long trainings, which need
a GPU to be practical. See docs/transfer.md.
"""
import argparse
import json
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import time

import settings
from results import Results
from rows import ROWS
from table import table

GENERATE = ('rosrun', 'synthetic_dataset', 'generate')
FEW = 20  # pictures, enough for the rarest of the preset's motions to have one


class Failure(Exception):
    """A program has failed."""


def output_of(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        lines = re.sub(r'\x1b\[[\d;]*m', '', done.stdout).strip().splitlines()  # without colours
        raise Failure(f"{shlex.join(command)} has ended with {done.returncode}: " + ' / '.join(lines[-3:]))
    return done.stdout


class Benchmark:
    """Makes datasets and trains on them, unless this has been done before."""

    def __init__(self, arguments, results, generate=GENERATE):
        self._arguments, self._results, self._generate = arguments, results, generate
        self.failures = []

    def run(self, rows, after_each):
        """@param after_each  is called after each result"""
        compared = []
        for row in rows:
            value = self._try(row, 'even', 0, False)
            compared += [(value, row)] if value is not None else []
            after_each()
        compared.sort(key=lambda each: each[0], reverse=True)  # the sort is stable for equal values
        for _, row in compared[:self._arguments.confirm]:
            for full in (False, True) if self._arguments.full else (False,):
                for seed in range(self._arguments.seeds):
                    self._try(row, 'odd', seed, full)
                    after_each()

    def _try(self, row, part, seed, full):
        """AP50, or None if the row fails, which does not stop the others."""
        if row.name in dict(self.failures):
            return None
        try:
            folder = self._dataset(row)
            return self._training(row, folder, part, seed, full)
        except (Failure, ValueError) as error:
            print(f'{row.name}: {error}', file=sys.stderr, flush=True)
            self.failures.append((row.name, str(error)))
            return None

    def _dataset(self, row):
        """Makes a row's dataset, or continues one that was stopped, and returns the row's folder."""
        folder = os.path.join(self._arguments.work, row.name)
        os.makedirs(folder, exist_ok=True)
        pathlib.Path(folder, 'camera.yaml').write_text(settings.camera(), 'utf-8')
        made = wanted = settings.of(row, self._arguments.model, self._arguments.scenes)
        if row.motions:
            self._generated(f'{folder}/preset.yaml', {**wanted, 'scenes': FEW}, f'{folder}/preset')
            made = settings.with_motions(wanted, settings.spelled_out_in(f'{folder}/preset'), row.motions)
        began = time.monotonic()
        new = self._generated(f'{folder}/settings.yaml', made, f'{folder}/dataset')
        if new or not self._results.dataset(row.name):
            pictures = settings.pictures_in(f'{folder}/dataset')
            print(f'{row.name}: {pictures:,} pictures', file=sys.stderr, flush=True)
            self._results.keep_dataset(
                row.name, digest=settings.digest_in(f'{folder}/dataset'), pictures=pictures,
                milliseconds=round(1000 * (time.monotonic() - began) / max(new, 1), 1))
        return folder

    def _generated(self, file, content, folder):
        """Makes a dataset, or what is missing of it, and returns the number of new pictures."""
        text = json.dumps({**content, 'output_folder': folder}, indent=1)
        is_known = os.path.exists(file) and pathlib.Path(file).read_text('utf-8') == text
        before = settings.pictures_in(folder) if is_known else 0
        pathlib.Path(file).write_text(text, 'utf-8')
        try:
            output_of([*self._generate, '--config', file, f"if_exists:={'resume' if is_known else 'overwrite'}"])
        except Failure as error:
            raise Failure(f'{error} (if the program has changed since: remove {os.path.dirname(file)})') from error
        return settings.pictures_in(folder) - before

    def _training(self, row, folder, part, seed, full):
        train = self._arguments.train
        known = self._results.training(row.name, part, seed, full, train)
        if known is not None:
            return known
        command = [*shlex.split(train), f'{folder}/dataset/{settings.FORMAT}', '--real', self._arguments.real, '--part', part,
                   '--seed', str(seed), *(['--full'] if full else [])]
        began = time.monotonic()
        try:
            ap50 = float(json.loads(output_of(command).strip().splitlines()[-1])['real']['ap50'])
        except (KeyError, TypeError, IndexError, json.JSONDecodeError) as error:
            raise Failure(f'{shlex.join(command)}: its last line should be JSON with real/ap50: {error!r}') from error
        print(f"{row.name}: {ap50:.3f} ({part}, seed {seed}{', full' if full else ''})", file=sys.stderr, flush=True)
        self._results.keep_training(row.name, part, seed, full, train, ap50, time.monotonic() - began)
        return ap50


def chosen(names):
    """The rows with these names, separated by commas; all if empty. @throws ValueError for an unknown name"""
    if not names:
        return ROWS
    wanted = names.split(',')
    unknown = [name for name in wanted if name not in {row.name for row in ROWS}]
    if unknown:
        raise ValueError(f"no row is called {', '.join(unknown)}; there are {', '.join(row.name for row in ROWS)}")
    return [row for row in ROWS if row.name in wanted]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('work')
    parser.add_argument('--model', required=True)
    parser.add_argument('--real', required=True)
    parser.add_argument('--train', required=True)
    parser.add_argument('--rows')
    parser.add_argument('--scenes', type=int, default=3000)
    parser.add_argument('--confirm', type=int, default=5)
    parser.add_argument('--seeds', type=int, default=3)
    parser.add_argument('--full', action='store_true')
    arguments = parser.parse_args()
    arguments.work = os.path.abspath(arguments.work)
    try:
        rows = chosen(arguments.rows)
    except ValueError as error:
        parser.error(str(error))
    os.makedirs(arguments.work, exist_ok=True)
    results = Results(f'{arguments.work}/results.json')
    benchmark = Benchmark(arguments, results)
    made = pathlib.Path(arguments.work, 'table.md')

    def write_table():
        made.write_text(table(ROWS, results, arguments.train, benchmark.failures), 'utf-8')

    try:
        benchmark.run(rows, write_table)
    except KeyboardInterrupt:
        print('stopped; the same command goes on', file=sys.stderr)
        return 128 + signal.SIGINT
    finally:
        write_table()
    print(made.read_text('utf-8'), end='')
    return 1 if benchmark.failures else 0


if __name__ == '__main__':
    sys.exit(main())
