#!/usr/bin/env python3
"""`report`: its page against the manifest, and that it needs nothing else."""
import html.parser
import json
import re
import shutil
import sqlite3
import types
import unittest

import numpy as np
from PIL import Image
import rosunit

from example_dataset import DatasetCase, REPOSITORY, SCENES, run
from synthetic_dataset import Dataset
from synthetic_dataset.report.brightness import Brightness, detail
from synthetic_dataset.report.choice import choose
from synthetic_dataset.report.findings import cure_of_neighbours
from synthetic_dataset.report.measures import Measures
from synthetic_dataset.report.neighbours import Neighbours
from synthetic_dataset.report.page import page_of
from synthetic_dataset.report.variety import Variety


class Page(html.parser.HTMLParser):
    """A page's tags with their attributes, and its text; checks that each opened tag is closed."""

    EMPTY = {'img', 'meta', 'input', 'br', 'link', 'hr'}

    def __init__(self, text):
        super().__init__()
        self.tags, self.words, self._open = [], [], []
        self.feed(text)
        self.close()
        assert not self._open, self._open

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        if tag not in self.EMPTY:
            self._open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self._open and self._open.pop() == tag, tag

    def handle_data(self, data):
        if 'style' not in self._open:
            self.words.append(data)

    @property
    def text(self):
        return re.sub(r'\s+', ' ', ' '.join(self.words))


class Report(DatasetCase):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.file = cls.folder / 'report.html'
        code, text = run('report', cls.folder)
        if code != 0:
            raise AssertionError(text)

    def setUp(self):
        self.page = Page(self.file.read_text('utf-8'))

    def test_says_what_the_manifest_says(self):
        page = self.page
        database = sqlite3.connect(self.folder / 'manifest.sqlite')
        self.addCleanup(database.close)
        for name, count in database.execute(
                'SELECT class.name, count(*) FROM scene_object JOIN object ON object."index" = '
                'object JOIN class ON class.id = class WHERE visible_pixels > 0 GROUP BY 1'):
            self.assertRegex(page.text, rf'{name} [\d ]*{count} ')
        self.assertIn(f'images {SCENES} labels', page.text)
        for title in ('Visibility', 'Truncation', 'Distance', 'Positions in the image',
                      'View angles', 'Brightness of images', 'Settings', 'Splits'):
            self.assertIn(title, page.text)
        self.assertIn('sensor/exposure', page.text)

    def test_says_whose_work_is_in_the_pictures(self):
        self.assertRegex(self.page.text, r'Authors and licences .* synthetic_dataset maintainers '
                         r'.*BSD-3-Clause')
        code, text = run('describe_dataset.py', self.folder)
        self.assertEqual(code, 0, text)
        self.assertIn('author synthetic_dataset maintainers, licence BSD-3-Clause', text)

    def test_needs_no_other_file_and_no_network(self):
        self.assertGreater(len(self.page.tags), 500)
        for tag, attributes in self.page.tags:
            self.assertNotIn(tag, ('script', 'link', 'iframe', 'object'))
            for name in ('src', 'href', 'xlink:href', 'srcset', 'action'):
                value = attributes.get(name, '#')
                self.assertTrue(value.startswith(('#', 'data:image/')), f'{tag} {value[:80]}')
        self.assertFalse(re.findall(r'url\((?!["\']?#)|@import', self.file.read_text('utf-8')))

    def test_has_different_names_for_what_is_named(self):
        ids = [attributes['id'] for _, attributes in self.page.tags if 'id' in attributes]
        self.assertGreater(len(ids), 50)
        self.assertEqual(len(ids), len(set(ids)))

    def test_is_the_same_of_the_same_dataset(self):
        again = self.scratch / 'again.html'
        self.assertEqual(run('report', self.folder, again), (0, f'{again}\n'))
        self.assertEqual(again.read_bytes(), self.file.read_bytes())

    def test_is_left_alone_by_verify_and_by_the_run(self):
        before = self.file.read_bytes()
        code, text = run('verify', self.folder)
        self.assertEqual(code, 0, text)
        (self.folder / 'coco/images/train/00000002.png').unlink()  # the run makes it again
        code, text = self.generate()
        self.assertEqual(code, 0, text)
        self.assertEqual(self.file.read_bytes(), before)
        code, text = run('verify', self.folder)
        self.assertEqual(code, 0, text)

    def test_shows_the_times_in_the_runs_log(self):
        log = self.scratch / 'run.log'
        code, text = self.generate(f'output_folder:={self.scratch}/again')
        self.assertEqual(code, 0, text)
        log.write_text('an older run: time: set-up 9.0 s; side by side drawing 9.0 s, labels 9.0 s, '
                       'writing 9.0 s; files of the whole dataset 9.0 s\n' + text, 'utf-8')
        page = self.scratch / 'timed.html'
        code, text = run('report', self.scratch / 'again', page, '--log', log)
        self.assertEqual(code, 0, text)
        self.assertRegex(Page(page.read_text('utf-8')).text,
                         r'Time by stage set-up [0-8]\.\d s drawing [\d.]+ s labels [\d.]+ s writing '
                         r'[\d.]+ s files of the whole dataset [\d.]+ s')
        log.write_text('nothing of it', 'utf-8')
        code, text = run('report', self.scratch / 'again', page, '--log', log)
        self.assertEqual(code, 1)
        self.assertIn("run.log': has no line with the times of a run", text)

    def test_is_never_in_place_of_the_datasets_files(self):
        image = self.folder / 'coco/images/train/00000003.png'
        before = image.read_bytes()
        code, text = run('report', self.folder, image)
        self.assertEqual((code, image.read_bytes()), (1, before))
        self.assertIn('is a file of the dataset; choose another name', text)
        code, text = run('report', self.folder, self.scratch / 'no_such' / 'page.html')
        self.assertEqual(code, 1)
        self.assertIn('cannot be written: No such file or directory', text)

    def test_of_a_dataset_with_lost_images_says_so(self):
        copy = self.scratch / 'copy'
        shutil.copytree(self.folder, copy)
        self.addCleanup(shutil.rmtree, copy)
        for name in ('00000001.png', '000001.png'):
            for file in copy.rglob(name):
                file.unlink()
        self.assertEqual(run('report', copy)[0], 0)
        page = Page((copy / 'report.html').read_text('utf-8'))
        self.assertIn('Images that cannot be read: 1', page.text)

    def test_of_nothing_says_so(self):
        code, text = run('report', self.scratch / 'nothing')
        self.assertEqual(code, 1)
        self.assertIn("nothing': no such folder", text)
        self.assertEqual(run('report', '--help')[0], 0)


class OfBoxesAlone(DatasetCase):

    WRITERS = ('writers: [{name: yolo, type: synthetic_dataset/Yolo}]\n'
               'yolo: {main_list: list.txt}\n')

    def test_leaves_out_what_was_not_measured(self):
        code, text = run('report', self.folder)
        self.assertEqual(code, 0, text)
        page = Page((self.folder / 'report.html').read_text('utf-8'))
        self.assertIn('Distance', page.text)
        self.assertNotIn('Visibility', page.text)
        self.assertIn('not divided into splits', page.text)


class OfLidars(DatasetCase):

    WRITERS = ('writers: [{name: nuscenes, type: synthetic_dataset/NuScenes}]\n'
               'nuscenes: {keyframe_every: 3}\n'
               'lidars: {top: {model: VLP-16, mounted_on: rover_1, pose: [0.0, 0.0, 1.2, 0, 0, 0, 1]}}\n')

    @classmethod
    def generate(cls, *arguments):
        code, text = super().generate(*arguments)
        if 'libembree' in text:
            raise unittest.SkipTest('lidars need Embree')
        return code, text

    def points_in_files(self):
        """The number of points of each sweep, in the order of scenes."""
        files = sorted(self.folder.rglob('*.pcd.bin'), key=lambda file: file.name)
        return [file.stat().st_size // 20 for file in files]

    def test_shows_sweeps_and_their_numbers(self):
        code, text = run('report', self.folder)
        self.assertEqual(code, 0, text)
        page = Page((self.folder / 'report.html').read_text('utf-8'))
        points = self.points_in_files()
        self.assertEqual(len(points), SCENES)
        self.assertIn(f'points a sweep {int(np.mean(points)):,} {min(points):,} to {max(points):,}', page.text)
        self.assertIn('rays with a return', page.text)
        self.assertIn('Points of an object', page.text)
        shown = [each['alt'] for tag, each in page.tags if tag == 'img' and 'sweep of' in each['alt']]
        self.assertEqual(shown[0], 'sweep of top in scene 0', 'the first key frame')

    def test_draws_each_sweep_alone(self):
        folder = self.scratch / 'clouds'
        code, text = run('draw_labels', '--clouds', self.folder, folder, 0, 1)
        self.assertEqual(code, 0, text)
        sweeps = [json.loads(line) for line in text.splitlines()]
        self.assertEqual([each['points'] for each in sweeps], self.points_in_files()[:2])
        self.assertEqual([each['labelled'] for each in sweeps], [True, False], 'scene 1 is no key frame')
        self.assertEqual(sum(sweeps[0]['classes'].values()), sweeps[0]['points'])
        for each in sweeps:
            self.assertEqual(each['rays'], 16 * 1808, '16 rings, a column each 55.296 us of a tenth of a second')
            with Image.open(folder / each['picture']) as picture:
                self.assertGreater(picture.width, 1000)

    def test_verify_knows_sweeps(self):
        code, text = run('verify', self.folder)
        self.assertEqual(code, 0, text)


class OfRecordedPictures(DatasetCase):
    """The example's pictures, with a visitor who is missing in the world."""

    @classmethod
    def generate(cls, *arguments):
        return run('generate', '--config', REPOSITORY / 'config' / 'example_twin.yaml',
                   f'output_folder:={cls.folder}', *arguments)

    def test_say_what_hides_objects(self):
        scenes = list(Dataset(self.folder))
        self.assertEqual(len(scenes), 5)
        for scene in scenes:
            self.assertGreater(scene.alignment, 0.6)
            self.assertLess(scene.unmeasured, 0.01)
        covered = [each.covered for scene in scenes for each in scene.objects
                   if each.covered is not None]
        self.assertGreater(max(covered), 0.1, 'the visitor stands before a rover')
        self.assertEqual(min(covered), 0.0)
        code, text = run('report', self.folder)
        self.assertEqual(code, 0, text)
        page = Page((self.folder / 'report.html').read_text('utf-8'))
        self.assertIn('What may hide objects in recorded pictures', page.text)
        self.assertIn('Something that the world does not have hides', page.text)


class Choices(DatasetCase):

    def test_are_what_their_reasons_say(self):
        dataset = Dataset(self.folder)
        measures = Measures(dataset)
        brightness = Brightness(dataset, measures)
        chosen = choose(measures, brightness)
        self.assertEqual(len({each.row for each in chosen}), len(chosen))
        by_reason = {}
        for each in chosen:
            by_reason.setdefault(each.reason, []).append(each.row)
        self.assertEqual(by_reason['first'], [0])
        self.assertEqual(len(by_reason['random']), 4)
        means = [np.array(Image.fromarray(scene.image).convert('L')).mean() for scene in dataset]
        np.testing.assert_allclose(brightness.values, means)

    def test_look_for_the_rarest_the_hidden_the_dark_and_the_small(self):
        count = 40
        measures = types.SimpleNamespace(
            scene_index=np.arange(count), class_names=['many', 'none', 'few'],
            scene=np.arange(count), label_class=np.where(np.arange(count) < 37, 0, 2),
            box_size=np.full((count, 2), 50.0), visibility=np.ones(count))
        measures.box_size[38] = 60.0
        measures.box_size[21] = 2.0
        measures.visibility[[11, 12]] = 0.1, 0.05
        brightness = Brightness.__new__(Brightness)
        brightness.rows, brightness.values = np.arange(count), np.full(count, 100.0)
        brightness.values[[15, 16]] = 30.0, 20.0
        reasons = {}
        for each in choose(measures, brightness):
            reasons.setdefault(each.reason, []).append(each.row)
        taken = set(reasons['random'])
        self.assertFalse(taken & {38, 37, 12, 11, 16, 15, 21}, 'choose other scenes for this test')
        self.assertEqual(reasons['rarest class: few'], [38, 37])
        self.assertEqual(reasons['least visible'], [12, 11])
        self.assertEqual(reasons['darkest'], [16, 15])
        self.assertEqual(reasons['smallest label'], [21])


class LearntByHeart(DatasetCase):

    def test_is_what_surrounds_labels_alone(self):
        striped = np.full((480, 640), 90, np.uint8)
        for x in range(0, 320, 40):
            striped[:, x:x + 20] = 160
        striped = Image.fromarray(striped)
        # The image shrinks to 64 columns. Half of the 32 striped ones have another tone at their right.
        self.assertAlmostEqual(detail(striped, np.zeros((0, 4))), 16 / 63, delta=0.02)
        self.assertEqual(detail(striped, np.array([[0, 0, 0.5, 0.75]])), 0)
        self.assertTrue(np.isnan(detail(striped, np.array([[0, 0, 1, 0.75]]))))
        noise = np.random.RandomState(0).normal(120, 8, (480, 640)).astype(np.uint8)
        self.assertEqual(detail(Image.fromarray(noise), np.zeros((0, 4))), 0)

    def test_is_one_look_on_a_plain_ground(self):
        dataset = Dataset(self.folder)
        self.assertEqual(Variety(dataset, types.SimpleNamespace(detail=0.03)).looks, {'rover': 2, 'drone': 1},
                         'two models of the world, and one')
        for share, looks, is_plain in ((0.03, 1, True), (0.28, 1, False), (0.03, 12, False), (None, 1, False)):
            variety = Variety(dataset, types.SimpleNamespace(detail=share))
            variety.looks = {'rover': looks, 'drone': 1}
            self.assertEqual(variety.is_plain, is_plain)
        page = Page(page_of(dataset)).text
        self.assertIn('of what surrounds the labels is not plain', page)
        self.assertNotIn('preset: transfer', page)


class NearEqualScenes(unittest.TestCase):
    """One object in images of 100 x 100, seen by one camera."""

    def neighbours(self, lefts, splits, camera_x=None):
        count = len(lefts)
        X_GC = np.tile(np.eye(4), (count, 1, 1))
        X_GC[:, 0, 3] = np.zeros(count) if camera_x is None else camera_x
        boxes = np.array([[left, 10.0, left + 20.0, 40.0] for left in lefts])
        return Neighbours(types.SimpleNamespace(
            scene_index=np.arange(count), object_names=['a'], scene=np.arange(count),
            object=np.zeros(count, int), box=boxes, scene_size=np.full((count, 2), 100.0),
            scene_camera=np.array(['camera'] * count, object), scene_X_GC=X_GC,
            scene_split=np.array(splits, object)))

    def test_are_found_across_splits(self):
        found = self.neighbours([10.0, 50.0, 10.6, 80.0], ['train', 'train', 'val', 'val'])
        self.assertEqual(found.by_split, {'train': 1, 'val': 1})
        self.assertEqual([pair[1:] for pair in found.pairs], [(0, 2)])
        self.assertAlmostEqual(found.pairs[0][0], 0.6)

    def test_may_be_of_one_split(self):
        found = self.neighbours([10.0, 10.1, 50.0], ['train', 'train', 'val'])
        self.assertEqual(found.pairs, [])
        self.assertEqual(found.by_split, {'train': 0, 'val': 0})

    def test_are_not_those_whose_camera_has_moved(self):
        self.assertEqual(self.neighbours([10.0, 10.0], ['train', 'val'], [0.0, 0.03]).pairs, [])
        self.assertEqual(len(self.neighbours([10.0, 10.0], ['train', 'val'], [0.0, 0.01]).pairs), 1)

    def test_are_mended_by_a_setting_that_is_not_as_it_should_be(self):
        self.assertIn('Leave `split/by: scenes` out', cure_of_neighbours({'split/by': 'scenes'}))
        for settings in ({}, {'split/by': 'blocks', 'split/gap': 0.0}):
            cure = cure_of_neighbours(settings)
            self.assertIn('`split/gap: 2.0`', cure)
            self.assertNotIn('split/by', cure)
        self.assertIn('more than 3 s', cure_of_neighbours({'split/gap': 3}))

    def test_are_found_among_many(self):
        random = np.random.RandomState(1)
        lefts = random.uniform(0.0, 80.0, 300)
        splits = np.where(np.arange(300) < 240, 'train', 'val')
        found = self.neighbours(lefts, splits)
        expected = {(first, second) for first in range(240) for second in range(240, 300)
                    if abs(lefts[first] - lefts[second]) <= 1.0}
        self.assertEqual({tuple(sorted(pair[1:])) for pair in found.pairs}, expected)
        self.assertGreater(len(expected), 100)


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'python_report', '__main__')
