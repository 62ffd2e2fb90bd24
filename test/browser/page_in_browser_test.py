"""The page of `report` in Chromium, as wide as a desk's screen and as a telephone's.

    page_in_browser_test.py PAGE FOLDER

FOLDER gets a screenshot for each width.
"""
import json
import pathlib
import re
import subprocess
import sys
import unittest

from PIL import Image

WIDTHS = {'desk': 1280, 'telephone': 390}
TIMEOUT = 120.0  # [s]

# Runs in a copy of the page, as the page itself allows no scripts.
MEASURE = '''<script>addEventListener("load", () => {
  const wide = document.documentElement.clientWidth;
  const box = each => each.getBoundingClientRect();
  const inScroller = each => each.closest(".table, nav, svg, .picture") !== null;
  const found = {
    width: wide,
    scroll: document.documentElement.scrollWidth,
    broken: [...document.images].filter(each => each.complete && !each.naturalWidth).length,
    images: document.images.length,
    charts: [...document.querySelectorAll(".charts .card > svg")].map(
      each => [box(each).width, box(each).height]),
    outside: [...document.querySelectorAll("main *")].filter(
      each => !inScroller(each) && box(each).width && box(each).right > wide + 0.5).map(
      each => each.tagName + " " + each.className),
    empty: [...document.querySelectorAll("h2")].filter(
      each => !each.nextElementSibling || box(each.nextElementSibling).height < 8).length,
    tiles: [...document.querySelectorAll("#scenes + .tiles figure")].length,
    hidden: 0,
  };
  document.getElementById("labels_off").click();
  found.hidden = [...document.querySelectorAll(".tiles .overlay")].filter(
    each => box(each).width).length;
  document.body.innerHTML = "<pre id=found></pre>";
  document.getElementById("found").textContent = JSON.stringify(found);
});</script>'''


def chromium(page, width, *options):
    command = ['chromium', '--headless', '--no-sandbox', '--disable-gpu', '--hide-scrollbars',
               '--enable-logging=stderr', '--virtual-time-budget=5000',
               f'--window-size={width},1600', *options, page.resolve().as_uri()]
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=TIMEOUT,
                          universal_newlines=True, check=True)


class PageInBrowser(unittest.TestCase):

    page = folder = None

    def measured(self, width):
        """Measures of the page in a frame of this width, as windows have a minimum width."""
        text = self.page.read_text('utf-8')
        text = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', '', text)
        inner = self.folder / 'measured_inner.html'
        inner.write_text(text.replace('</body>', MEASURE + '</body>'), 'utf-8')
        outer = self.folder / 'measured.html'
        outer.write_text(
            f'<iframe id="page" src="{inner.name}" style="width: {width}px; height: 1500px">'
            '</iframe><script>addEventListener("load", () => { document.body.textContent = '
            'document.getElementById("page").contentDocument.getElementById("found").textContent;'
            '});</script>', 'utf-8')
        dom = chromium(outer, max(width, 800), '--dump-dom', '--allow-file-access-from-files')
        found = re.search(r'\{"width".*\}', dom.stdout)
        self.assertIsNotNone(found, dom.stdout[:2000] + dom.stderr[-2000:])
        return json.loads(found.group(0))

    def test_fits_its_window(self):
        for name, width in WIDTHS.items():
            with self.subTest(name=name):
                found = self.measured(width)
                self.assertLessEqual(abs(found['width'] - width), 20)
                self.assertLessEqual(found['scroll'], found['width'])
                self.assertEqual(found['outside'], [])

    def test_shows_all_pictures_and_charts(self):
        for name, width in WIDTHS.items():
            with self.subTest(name=name):
                found = self.measured(width)
                self.assertEqual(found['broken'], 0)
                self.assertGreaterEqual(found['images'], found['tiles'])
                self.assertGreaterEqual(found['tiles'], 8)
                self.assertGreaterEqual(len(found['charts']), 8)
                for chart in found['charts']:
                    self.assertGreater(min(chart), 150, chart)
                self.assertEqual(found['empty'], 0)

    def test_hides_labels_when_asked_to(self):
        self.assertEqual(self.measured(WIDTHS['desk'])['hidden'], 0)

    def test_reports_no_error_and_asks_for_nothing(self):
        for name, width in WIDTHS.items():
            with self.subTest(name=name):
                picture = self.folder / f'{name}.png'
                log = chromium(self.page, width, f'--screenshot={picture}').stderr
                self.assertEqual([line for line in log.splitlines() if 'CONSOLE' in line], [])
                with Image.open(picture) as shot:
                    self.assertEqual(shot.width, width)
                    # Header, text, tiles: a page that has not been drawn has only a few colours.
                    self.assertGreater(len(shot.convert('RGB').getcolors(1 << 24)), 5000)


if __name__ == '__main__':
    PageInBrowser.page = pathlib.Path(sys.argv[1])
    PageInBrowser.folder = pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
