#!/usr/bin/env python3
"""The documentation: each page says whom it is for, and its links have targets."""
import pathlib
import re
import unittest

import rosunit

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
DOCS = REPOSITORY / 'docs'
LINK = re.compile(r'\]\(([^)\s]+)\)')


def pages():
    return sorted([*DOCS.glob('*.md'), *(DOCS / 'decisions').glob('*.md'),
                   REPOSITORY / 'README.md', REPOSITORY / 'CONTRIBUTING.md'])


def text_of(page):
    """The page without blocks of code, in which brackets are not links."""
    return re.sub(r'^```.*?^```', '', page.read_text('utf-8'), flags=re.DOTALL | re.MULTILINE)


def anchors_of(page):
    """The anchors that GitHub makes from headings."""
    return {re.sub(r'[^\w\- ]', '', heading.strip().lower()).replace(' ', '-')
            for heading in re.findall(r'^#+ (.*)$', text_of(page), flags=re.MULTILINE)}


class Docs(unittest.TestCase):

    def test_say_first_for_whom_they_are(self):
        for page in sorted(DOCS.glob('*.md')):
            with self.subTest(page=page.name):
                lines = page.read_text('utf-8').splitlines()
                self.assertTrue(lines[0].startswith('# '))
                self.assertEqual(lines[1], '')
                self.assertRegex(lines[2], '^For (whoever|everybody)')

    def test_are_all_in_the_list(self):
        listed = set(LINK.findall((DOCS / 'README.md').read_text('utf-8')))
        self.assertEqual({page.name for page in DOCS.glob('*.md')} - {'README.md'} - listed, set())

    def test_link_to_what_there_is(self):
        count = 0
        for page in pages():
            for link in LINK.findall(text_of(page)):
                if re.match(r'[a-z]+:', link):
                    continue
                count += 1
                with self.subTest(page=page.name, link=link):
                    path, _, anchor = link.partition('#')
                    target = (page.parent / path).resolve() if path else page
                    self.assertTrue(target.exists())
                    if anchor:
                        self.assertIn(anchor, anchors_of(target))
        self.assertGreater(count, 100)


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'docs', '__main__')
