#!/usr/bin/env python3
"""Sums up a folder of JUnit result files; exit code 0 only if there are tests and all pass.

A test program that died leaves no result or one that says so: both count as failures.
"""
import pathlib
import sys
import xml.etree.ElementTree as ElementTree


def outcome(case):
    """'passed', 'failed' or 'skipped' of one test case."""
    if case.find('failure') is not None or case.find('error') is not None:
        return 'failed'
    if case.find('skipped') is not None or case.get('status') == 'notrun':
        return 'skipped'
    return 'passed'


def main():
    counts = {'passed': 0, 'failed': 0, 'skipped': 0}
    for file in sorted(pathlib.Path(sys.argv[1]).rglob('*.xml')):
        try:
            root = ElementTree.parse(file).getroot()
        except ElementTree.ParseError as error:
            print(f'FAILED {file.name}: unreadable result: {error}')
            counts['failed'] += 1
            continue
        cases = list(root.iter('testcase'))
        for case in cases:
            result = outcome(case)
            counts[result] += 1
            if result == 'failed':
                print(f"FAILED {file.stem}: {case.get('classname')}.{case.get('name')}")
        # Parts of a test (Python's subTest) that fail are counted in the head alone.
        counted = int(root.get('failures', 0)) + int(root.get('errors', 0))
        if counted > sum(outcome(case) == 'failed' for case in cases):
            print(f'FAILED {file.stem}: {counted} by its own count')
            counts['failed'] += 1
    print('{passed} passed, {failed} failed, {skipped} skipped'.format(**counts))
    return 0 if counts['failed'] == 0 and counts['passed'] > 0 else 1


if __name__ == '__main__':
    sys.exit(main())
