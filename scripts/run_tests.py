#!/usr/bin/env python3
"""Runs built tests in parallel and sums up their results; exit code 0 only if there are some and all pass.

    run_tests.py WORKSPACE [--all] [--repeat N] [PART...]

Without --all, long tests are left out: those in test/long_tests.txt. PART names what to run: a test
program ("test_run"), or a test of launch files ("generate"); all by default. Each runs in a process of its
own, with its own folders for temporary files and for ROS. Programs with many tests are run in parts.
A part that crashes leaves no result, or one that says so: both count as failures.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree

REPOSITORY = pathlib.Path(__file__).resolve().parents[1]
TESTS_IN_A_PART = 40  # enough for the program's start not to matter
TIMEOUT = 1800.0  # [s], in case a part hangs


class Part:
    """Tests that run in one process."""

    def __init__(self, name, command, results, folder):
        self.name = name
        self.command = command
        self.results = results  # the JUnit file that it writes, or a folder of them
        self.folder = folder  # its working directory
        self.seconds = 0.0

    def run(self, environment, log):
        """Runs the part and returns whether it succeeded. `count` reads its results."""
        start = time.monotonic()
        with tempfile.TemporaryDirectory(prefix='synthetic_dataset_tests_') as scratch:
            own = {**environment, 'TMPDIR': scratch, 'ROS_HOME': scratch + '/ros'}
            with open(log, 'wb') as file:
                try:
                    code = subprocess.run(self.command, cwd=self.folder, env=own, stdin=subprocess.DEVNULL, stdout=file,
                                          stderr=subprocess.STDOUT, timeout=TIMEOUT, check=False).returncode
                except subprocess.TimeoutExpired:
                    code = -1
        self.seconds = time.monotonic() - start
        return code == 0


def long_tests():
    """(patterns of gtest names, names of launch tests) of the long tests."""
    lines = (REPOSITORY / 'test/long_tests.txt').read_text(encoding='utf-8').splitlines()
    names = [line.split('#')[0].strip() for line in lines]
    names = [name for name in names if name]
    patterns = [name for name in names if '.' in name or '*' in name]
    return patterns, set(names) - set(patterns)


def count_of(program, tests, environment):
    """How many tests of a program pass a filter."""
    listed = subprocess.run([program, '--gtest_list_tests', f'--gtest_filter={tests}'], env=environment,
                            stdout=subprocess.PIPE, universal_newlines=True, check=True)
    return sum(line.startswith('  ') for line in listed.stdout.splitlines())


def parts_of_program(program, tests, environment, results):
    """Yields a gtest program's parts: several if it has many tests."""
    count = count_of(program, tests, environment)
    parts = -(-count // TESTS_IN_A_PART)
    room = REPOSITORY / 'test' / program.name.replace('test_', '', 1)
    for index in range(parts):
        name = program.name if parts == 1 else f'{program.name}-{index + 1}-of-{parts}'
        file = results / f'{name}.xml'
        command = ['env', f'GTEST_TOTAL_SHARDS={parts}', f'GTEST_SHARD_INDEX={index}', str(program),
                   f'--gtest_output=xml:{file}', f'--gtest_filter={tests}']
        yield Part(name, command, file, room)


def part_of_launch_file(file, results):
    """A file of tests that rostest starts."""
    folder = results / file.stem
    # The file may have been made by CMake, in the workspace.
    command = ['rostest', f'--pkgdir={REPOSITORY}', '--package=synthetic_dataset',
               f'--results-base-dir={folder}', f'--results-filename={file.stem}.xml', str(file)]
    return Part(file.stem, command, folder, file.parent)


def all_parts(workspace, chosen, with_long, environment, results):
    """All parts to run, the longest first."""
    patterns, launch_tests = ([], set()) if with_long else long_tests()
    tests = '-' + ':'.join(patterns) if patterns else '*'
    parts = []
    for file in [*REPOSITORY.glob('test/*/*.test'),
                 *workspace.glob('build/synthetic_dataset/test/*/*.test')]:
        if file.stem in chosen or (not chosen and file.stem not in launch_tests):
            parts.append(part_of_launch_file(file, results))
    programs = [workspace / 'devel/lib/synthetic_dataset_tests' / f'test_{room.parent.name}'
                for room in REPOSITORY.glob('test/*/CMakeLists.txt')
                if 'synthetic_dataset_test(' in room.read_text(encoding='utf-8')]
    order = ['test_run', 'test_output', 'test_render', 'test_world']
    programs.sort(key=lambda each: (order.index(each.name) if each.name in order else len(order), each.name))
    for program in programs:
        if not program.exists():
            sys.exit(f'{program} is not built: cmake --build {workspace}/build --target tests')
        if not chosen or program.name in chosen:
            parts += parts_of_program(program, tests, environment, results)
    return parts


def outcome(case):
    """'passed', 'failed' or 'skipped' of one test case."""
    if case.find('failure') is not None or case.find('error') is not None:
        return 'failed'
    if case.find('skipped') is not None or case.get('status') == 'notrun':
        return 'skipped'
    return 'passed'


def count(part, ended_well):
    """({outcome: how many tests}, lines that say what failed)."""
    counts = {'passed': 0, 'failed': 0, 'skipped': 0}
    lines = []
    files = sorted(part.results.rglob('*.xml')) if part.results.is_dir() else [part.results]
    for file in files:
        try:
            root = ElementTree.parse(file).getroot()
        except (OSError, ElementTree.ParseError) as error:
            lines.append(f'no result: {error}')
            continue
        cases = list(root.iter('testcase'))
        outcomes = [outcome(case) for case in cases]
        for result in outcomes:
            counts[result] += 1
        lines += [f"{case.get('classname')}.{case.get('name')}"
                  for case, result in zip(cases, outcomes) if result == 'failed']
        # Failed parts of a test (Python's subTest) are only counted in the root element.
        counted = int(root.get('failures', 0)) + int(root.get('errors', 0))
        if counted > outcomes.count('failed'):
            lines.append(f'{counted} by its own count')
            counts['failed'] += 1
    if not ended_well and not lines:
        lines.append('it ended with an error, or did not end')
    if lines and counts['failed'] == 0:
        counts['failed'] = 1
    return counts, lines


def main():
    """The program."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('workspace', type=pathlib.Path)
    parser.add_argument('parts', nargs='*', metavar='PART')
    parser.add_argument('--all', action='store_true', help='also what takes long')
    parser.add_argument('--repeat', type=int, default=1, metavar='N', help='run all of it N times')
    arguments = parser.parse_intermixed_args()
    # If a shell runs this in the background, SIGINT is ignored, which tests send to programs.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    results = arguments.workspace / 'build/test_results'
    shutil.rmtree(results, ignore_errors=True)
    results.mkdir(parents=True)
    # Programs run in parallel, so each gets only one thread to draw with.
    environment = {**os.environ, 'LP_NUM_THREADS': '1', 'OMP_NUM_THREADS': '1'}
    sums = {'passed': 0, 'failed': 0, 'skipped': 0}
    everything = results
    for number in range(1, arguments.repeat + 1):
        if arguments.repeat > 1:
            results = everything / f'run_{number}'
            results.mkdir()
        parts = all_parts(arguments.workspace, set(arguments.parts), arguments.all, environment, results)
        unknown = set(arguments.parts) - {re.sub(r'-\d+-of-\d+$', '', part.name) for part in parts}
        if unknown:
            parser.error(f"no test is called {', '.join(sorted(unknown))}")
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            logs = {part: results / f'{part.name}.log' for part in parts}
            running = {pool.submit(part.run, environment, logs[part]): part for part in parts}
            for ended in concurrent.futures.as_completed(running):
                part = running[ended]
                counts, lines = count(part, ended.result())
                print(f"{part.name:28}{counts['passed']:5} passed{counts['failed']:4} failed{part.seconds:7.1f} s",
                      flush=True)
                for line in lines:
                    print(f'FAILED {part.name}: {line}')
                if lines:
                    print(f'  see {logs[part]}')
                for name in sums:
                    sums[name] += counts[name]
    print('{passed} passed, {failed} failed, {skipped} skipped'.format(**sums))
    return 0 if sums['failed'] == 0 and sums['passed'] > 0 else 1


if __name__ == '__main__':
    sys.exit(main())
