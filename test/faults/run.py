#!/usr/bin/env python3
"""Makes faults happen to the program `generate`, and looks for what they cost.

    run.py PROGRAMS [--trials PERCENT] [--seed SEED] [--write-table FILE] [FAMILY...]

PROGRAMS is the folder with the package's programs. Without families, all.
"""
import argparse
import concurrent.futures
import importlib
import os
import pathlib
import queue
import re
import resource
import shutil
import signal
import sys
import tempfile
import time
import traceback
from typing import List, NamedTuple, Optional

import trial

FAMILIES = ('kills', 'exact_places', 'shards', 'stop_signals', 'full_disk', 'folders', 'limits',
            'surroundings', 'changes', 'power_cut', 'two_runs', 'manifests', 'clock', 'recordings',
            'parts', 'twin_parts', 'random_worlds', 'hostile')

LONGEST_LINE = 400
MEMORY = '/dev/shm'


class Row(NamedTuple):
    """The results of a fault."""

    fault: trial.Fault
    trials: int
    lost: List[str]
    half_written: List[str]
    failures: List[str]
    skipped: str  # the reason; empty if it was not skipped


class Outcome(NamedTuple):
    """The result of a trial."""

    lost: List[str]
    half_written: List[str]
    failure: str
    skipped: str


def one_trial(do: trial.Trial, places: 'queue.Queue[trial.Place]') -> Outcome:
    place = places.get()
    failure = skipped = ''
    try:
        place.clear()
        do(place)
    except trial.Skipped as reason:
        skipped = str(reason)
    except trial.Failed as error:
        failure = str(error)
    except Exception:  # an error of the test itself: this trial fails, the others go on
        failure = traceback.format_exc()
    outcome = Outcome(list(place.scene_lost), list(place.half_written), failure, skipped)
    places.put(place)
    return outcome


def do_all(fault: trial.Fault, percent: int, places: 'queue.Queue[trial.Place]') -> Row:
    trials = fault.trials(percent)
    with concurrent.futures.ThreadPoolExecutor(places.qsize()) as pool:
        outcomes = list(pool.map(lambda do: one_trial(do, places), trials))
    row = Row(fault, len(trials), [], [], [], next((o.skipped for o in outcomes if o.skipped), ''))
    for number, outcome in enumerate(outcomes):
        row.lost.extend(f'trial {number}: {each}' for each in outcome.lost)
        row.half_written.extend(f'trial {number}: {each}' for each in outcome.half_written)
        if outcome.failure:
            row.failures.append(f'trial {number}: {outcome.failure}')
    return row


def failed(row: Row) -> bool:
    return bool(row.failures or row.lost or row.half_written)


def shortened(text: str) -> str:
    lines = [line[:LONGEST_LINE] for line in text.strip().splitlines()]
    return '\n'.join(lines if len(lines) <= 8 else [lines[0], '...', *lines[-6:]])


def tell(row: Row, seconds: float) -> None:
    state = 'FAILED' if failed(row) else 'SKIPPED' if row.skipped else 'passed'
    print(f'{state:8}{row.fault.name}: {row.trials} trials, {seconds:.1f} s', flush=True)
    for problem in [*row.failures[:3], *row.lost[:3], *row.half_written[:3], row.skipped]:
        if problem:
            print('        ' + shortened(problem).replace('\n', '\n        '), flush=True)


def what_was_lost(row: Row) -> str:
    if row.skipped:
        return 'not tried: ' + row.skipped
    parts = [f'{len(what)} {name}' for what, name in
             ((row.lost, 'scenes'), (row.half_written, 'files half-written'),
              (row.failures, 'trials failed')) if what]
    return ', '.join(parts) or 'nothing'


def table(rows: List[Row]) -> str:
    lines = ['| fault | how it is made | trials | lost |', '| --- | --- | --- | --- |']
    lines += [f'| {row.fault.name} | {row.fault.how} | {row.trials} | {what_was_lost(row)} |'
              for row in rows]
    return '\n'.join(lines) + '\n'


def write_table(path: pathlib.Path, rows: List[Row]) -> None:
    """Writes the table between the page's two marks."""
    begin, end = '<!-- begin of the table -->\n', '<!-- end of the table -->\n'
    text = path.read_text(encoding='utf-8')
    changed, count = re.subn(f'(?s){begin}.*{end}', lambda _: begin + table(rows) + end, text)
    if count != 1:
        sys.exit(f'{path} should have the lines {begin!r} and {end!r} once')
    path.write_text(changed, encoding='utf-8')


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('programs', type=pathlib.Path)
    parser.add_argument('--trials', type=int, default=100, help='per cent of the usual number')
    parser.add_argument('--seed', default='', help='other moments and inputs')
    parser.add_argument('--write-table', type=pathlib.Path)
    parser.add_argument('families', nargs='*', metavar='FAMILY', help=', '.join(FAMILIES))
    return parser.parse_intermixed_args()


def in_memory() -> Optional[str]:
    """A disk in memory: on a real one, each run would also wait for what other programs write."""
    return MEMORY if os.access(MEMORY, os.W_OK) and 'TMPDIR' not in os.environ else None


def main() -> int:
    options = arguments()
    trial.use_seed(options.seed)
    # A background shell may ignore these signals, and programs inherit that.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)
    scratch = pathlib.Path(tempfile.mkdtemp(prefix='synthetic_dataset_faults_', dir=in_memory()))
    rows: List[Row] = []
    try:
        places: 'queue.Queue[trial.Place]' = queue.Queue()
        for number in range(os.cpu_count() or 1):
            place = trial.Place(scratch / f'place_{number}', options.programs)
            place.make_reference()
            places.put(place)
        for family in options.families or FAMILIES:
            for fault in importlib.import_module(family).FAULTS:
                begin = time.monotonic()
                rows.append(do_all(fault, options.trials, places))
                tell(rows[-1], time.monotonic() - begin)
                if options.write_table:
                    write_table(options.write_table, rows)
    finally:
        shutil.rmtree(scratch)
    failures = sum(map(failed, rows))
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f'{used.ru_utime + used.ru_stime:.0f} s of processor time')
    print(f'{len(rows) - failures} passed, {failures} failed')
    return 1 if failures else 0


if __name__ == '__main__':
    sys.exit(main())
