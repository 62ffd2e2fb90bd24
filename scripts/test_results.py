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
            cases = list(ElementTree.parse(file).iter('testcase'))
        except ElementTree.ParseError as error:
            cases = []
            print(f'FAILED {file.name}: unreadable result: {error}')
            counts['failed'] += 1
        for case in cases:
            result = outcome(case)
            counts[result] += 1
            if result == 'failed':
                print(f"FAILED {file.stem}: {case.get('classname')}.{case.get('name')}")
    print('{passed} passed, {failed} failed, {skipped} skipped'.format(**counts))
    return 0 if counts['failed'] == 0 and counts['passed'] > 0 else 1


if __name__ == '__main__':
    sys.exit(main())
