#!/usr/bin/env python3
"""`try_training` without the network: what it reads, how it judges, what its page says. No test needs torch."""
import contextlib
import io
import os
import pathlib
import subprocess
import tempfile
import types
import unittest

import numpy as np
from PIL import Image
import rosunit

from example_dataset import DatasetCase, SCENES, run
from report_test import Page
from synthetic_dataset import Dataset, DatasetError
from synthetic_dataset.trial import boxes, choice, photographs, pictures, samples, trial
from synthetic_dataset.trial.precision import (Found, average_precision, best_threshold, matches,
                                               mean_average_precision)

CLASSES = {0: 'rover', 3: 'drone'}


def found(rows):
    """Detections from rows of [class, left, top, right, bottom, score]."""
    rows = np.reshape(np.array(rows, float), (-1, 6))
    return Found(rows[:, 1:5], rows[:, 5], rows[:, 0].astype(int))


class Precision(unittest.TestCase):

    TRUTH = np.array([[0, 0.0, 0.0, 0.2, 0.2], [0, 0.5, 0.5, 0.7, 0.7]])

    def test_gives_a_label_to_the_surest_alone(self):
        several = found([[0, 0.0, 0.0, 0.2, 0.2, 0.5], [0, 0.0, 0.01, 0.2, 0.2, 0.9], [0, 0.8, 0.8, 0.9, 0.9, 0.7]])
        self.assertEqual(list(matches(several, self.TRUTH)), [-1, 0, -1])

    def test_knows_half_an_overlap_from_less(self):
        truth = self.TRUTH[:1]
        self.assertEqual(list(matches(found([[0, 0.0, 0.0, 0.2, 0.1001, 0.5]]), truth)), [0])
        self.assertEqual(list(matches(found([[0, 0.0, 0.0, 0.2, 0.0999, 0.5]]), truth)), [-1])

    def test_asks_for_the_same_class(self):
        self.assertEqual(list(matches(found([[3, 0.0, 0.0, 0.2, 0.2, 0.5]]), self.TRUTH)), [-1])

    def test_is_what_hands_find_out(self):
        self.assertEqual(average_precision([0.9, 0.8], [True, True], 2), 1.0)
        self.assertEqual(average_precision([], [], 2), 0.0)
        self.assertEqual(average_precision([0.9], [False], 1), 0.0)
        # Precisions of 1, 1/2 and 2/3; one of two objects is found first, the other at 2/3.
        self.assertAlmostEqual(average_precision([0.9, 0.8, 0.7], [True, False, True], 2), (51 + 50 * 2 / 3) / 101)
        # Half of the objects: 51 of 101 recalls, from 0 to 0.5.
        self.assertAlmostEqual(average_precision([0.9], [True], 2), 51 / 101)

    def test_is_what_every_threshold_gives(self):
        """Of random pictures: precision and recall at each threshold by itself."""
        random = np.random.RandomState(3)
        founds, truths = [], []
        for _ in range(12):
            corners = random.uniform(0, 0.7, (random.randint(0, 5), 2))
            truth = np.column_stack((np.zeros(len(corners)), corners, corners + 0.25))
            near = np.repeat(truth, 2, axis=0)
            near[:, 1:] += random.uniform(-0.08, 0.08, (len(near), 4))
            founds.append(found(np.column_stack((near, random.uniform(0, 1, len(near))))))
            truths.append(truth)
        count = sum(map(len, truths))
        points = []
        for threshold in np.concatenate([each.scores for each in founds]):
            kept = [Found(*(column[each.scores >= threshold] for column in each)) for each in founds]
            right = sum(int((matches(each, truth) >= 0).sum()) for each, truth in zip(kept, truths))
            points.append((right / count, right / sum(len(each.scores) for each in kept)))
        expected = np.mean([max([precision for recall, precision in points if recall >= at - 1e-12], default=0.0)
                            for at in np.arange(101) / 100])
        value = mean_average_precision(founds, truths)
        self.assertAlmostEqual(value, expected)
        self.assertTrue(0.1 < value < 0.9, value)

    def test_is_the_mean_of_classes_that_are_there(self):
        truths = [np.array([[0, 0.0, 0.0, 0.2, 0.2], [3, 0.5, 0.5, 0.7, 0.7]])]
        self.assertEqual(mean_average_precision([found([[0, 0.0, 0.0, 0.2, 0.2, 0.9]])], truths), 0.5)
        self.assertIsNone(mean_average_precision([found([[0, 0.0, 0.0, 0.2, 0.2, 0.9]])], [boxes.NONE]))

    def test_counts_from_where_both_are_best(self):
        self.assertEqual(best_threshold([found([[0, 0.0, 0.0, 0.2, 0.2, 0.9], [0, 0.5, 0.5, 0.7, 0.7, 0.4],
                                                [0, 0.8, 0.8, 0.9, 0.9, 0.3]])], [self.TRUTH]), 0.4)
        self.assertIsNone(best_threshold([found([])], [self.TRUTH]))


class FolderCase(unittest.TestCase):

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def photograph(self, name, label=None, label_name=None):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        Image.new('RGB', (40, 20), (90, 120, 60)).save(file)
        if label is not None:
            text = self.folder / label_name if label_name else file.with_suffix('.txt')
            text.parent.mkdir(parents=True, exist_ok=True)
            text.write_text(label, 'utf-8')

    def read(self, class_names=None, folder=None):
        return photographs.read(folder or self.folder, class_names or CLASSES)


class Photographs(FolderCase):

    def test_have_labels_beside_them(self):
        self.photograph('a.jpg', '0 0.5 0.5 0.2 0.4\n\n3 0.25 0.25 0.5 0.5\n')
        self.photograph('more/b.PNG')
        read = self.read()
        self.assertEqual([each.file.name for each in read.all], ['a.jpg', 'b.PNG'])
        np.testing.assert_allclose(read.all[0].truth, [[0, 0.4, 0.3, 0.6, 0.7], [3, 0, 0, 0.5, 0.5]])
        self.assertEqual(read.all[1].truth.shape, (0, 5))
        self.assertEqual((read.is_labelled, read.has_classes, read.without_file), (True, True, 1))

    def test_have_labels_in_a_folder_of_their_own(self):
        self.photograph('images/train/a.webp', '0 0.5 0.5 1 1', 'labels/train/a.txt')
        self.photograph('cellar/images/b.jpg', '3 0.5 0.5 1 1', 'cellar/labels/b.txt')
        self.assertEqual([each.truth[0, 0] for each in self.read().all], [3, 0])
        self.assertEqual(self.read(folder=self.folder / 'images').all[0].truth[0, 0], 0)

    def test_have_labels_as_polygons(self):
        self.photograph('a.jpg', '0 0.1 0.2 0.5 0.2 0.3 0.8')
        np.testing.assert_allclose(self.read().all[0].truth, [[0, 0.1, 0.2, 0.5, 0.8]])

    def test_have_labels_in_an_index(self):
        self.photograph('a.jpg')
        (self.folder / 'index.json').write_text('[["a.jpg", [[0.5, 0.5, 0.2, 0.4]]], ["b.jpg", []]]')
        read = self.read({3: 'drone'})
        np.testing.assert_allclose(read.all[0].truth, [[3, 0.4, 0.3, 0.6, 0.7]])
        self.assertTrue(read.has_classes)
        self.assertFalse(self.read().has_classes, 'of several classes it says none')
        (self.folder / 'index.json').write_text('{"a.jpg": []}')
        with self.assertRaisesRegex(DatasetError, r'index.json.: should be \[\[file'):
            self.read()

    def test_need_no_labels(self):
        self.photograph('a.jpg')
        self.assertFalse(self.read().is_labelled)

    def test_of_one_class_may_number_it_as_they_like(self):
        self.photograph('a.jpg', '7 0.5 0.5 1 1')
        self.assertEqual(self.read({3: 'drone'}).all[0].truth[0, 0], 3)
        with self.assertRaisesRegex(DatasetError, 'class 7, and the dataset.s classes are 0 rover, 3 drone'):
            self.read()

    def test_may_name_their_classes(self):
        self.photograph('a.jpg', '0 0.5 0.5 1 1\n1 0.5 0.5 1 1\n')
        (self.folder / 'classes.txt').write_text('person\ndrone\n')
        np.testing.assert_allclose(self.read().all[0].truth, [[3, 0, 0, 1, 1]])

    def test_are_refused_with_the_place(self):
        self.photograph('a.jpg', '0 0.5 0.5 1 1\n0 0.5 0.5 1\n')
        with self.assertRaisesRegex(DatasetError, r"a.txt', line 2: found 4 numbers; it should be"):
            self.read()
        with self.assertRaisesRegex(DatasetError, 'no such folder'):
            self.read(folder=self.folder / 'nothing')
        (self.folder / 'empty').mkdir()
        with self.assertRaisesRegex(DatasetError, 'no photographs are there'):
            self.read(folder=self.folder / 'empty')


class Samples(FolderCase):

    def drawn(self, size=64):
        """Samples of a grey picture with a red rectangle, which is its label."""
        pixels = np.full((80, 100, 3), 60, np.uint8)
        pixels[20:60, 30:60] = (220, 30, 30)
        Image.fromarray(pixels).save(self.folder / 'a.png')
        truth = np.array([[3, 0.3, 0.25, 0.6, 0.75]])
        return samples.Samples([pictures.Picture(self.folder / 'a.png', truth, '')], size)

    def test_have_their_boxes_around_what_is_in_them(self):
        drawn = self.drawn(128)
        count = 0
        for number in range(60):
            pixels, rows = drawn.sample(number)
            self.assertEqual(pixels.shape, (128, 128, 3))
            is_red = pixels[..., 0].astype(int) - pixels[..., 1] > 40
            for number_of_class, left, top, right, bottom in rows:
                self.assertEqual(number_of_class, 3)
                self.assertTrue(0 <= left < right <= 128 and 0 <= top < bottom <= 128)
                inside = is_red[int(top) + 2:int(bottom) - 1, int(left) + 2:int(right) - 1]
                self.assertGreater(inside.mean() if inside.size else 1.0, 0.95)
                is_red[max(0, int(top) - 2):int(bottom) + 3, max(0, int(left) - 2):int(right) + 3] = False
                count += 1
            # Red that is left is cut off too much to have a label: a fifth in each of four pictures.
            self.assertLess(is_red.sum(), 4 * 0.25 * 0.15 * 128 * 128)
        self.assertGreater(count, 60)

    def test_follow_from_their_numbers(self):
        one, other = self.drawn(), self.drawn()
        for number in (5, 1, 9):
            np.testing.assert_array_equal(one.sample(number)[0], other.sample(number)[0])
        self.assertFalse(np.array_equal(one.sample(1)[0], one.sample(2)[0]))


class Progress(unittest.TestCase):

    def said(self, is_terminal):
        out = io.StringIO()
        out.isatty = lambda: is_terminal
        times = iter(range(0, 1000, 20))
        progress = trial.Progress(out, lambda: next(times))
        for step in range(1, 6):
            progress(f'step {step}')
        progress.end()
        return out.getvalue()

    def test_is_one_line_of_a_terminal(self):
        self.assertEqual(self.said(True), ''.join(f'\rstep {step}\033[K' for step in range(1, 6)) + '\n')

    def test_is_the_first_and_the_last_line_and_some_between_elsewhere(self):
        lines = self.said(False).splitlines()
        self.assertEqual((lines[0], lines[-1]), ('step 1', 'step 5'))
        self.assertLess(len(lines), 5)


class FakeNetwork:
    """Immediately finds what a function returns for each file."""

    size, device = 256, 'nothing'

    def __init__(self, find, classes):
        self._find, self.classes = find, classes
        self.learnt, self.stopped = None, False

    def train(self, learnt, seconds, is_stopped, progress):
        self.learnt = learnt
        for step in range(1, 4):
            if is_stopped():
                break
            progress(step, seconds * step / 3, 1.0)
        return step

    def find(self, files, progress):
        progress(len(files))
        return iter([self._find(file) for file in files])


class Trial(DatasetCase):

    WRITERS = '''
writers:
  - {name: detect, type: synthetic_dataset/UltralyticsYolo}
  - {name: coco, type: synthetic_dataset/Coco}
detect: {task: detect}
coco: {annotation_file: people}
split: {train: 0.5, val: 0.5}
'''

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.dataset = Dataset(cls.folder)
        cls.pictures = pictures.read(cls.dataset)
        cls.truth = {each.file: each.truth for each in cls.pictures}

    def perfect(self, file):
        truth = self.truth[file]
        return found(np.column_stack((truth, np.full(len(truth), 0.9))))

    def try_(self, find, real=None, is_stopped=lambda: False, **more):
        """(its output, the page, the network)"""
        file = self.scratch / 'page.html'
        arguments = types.SimpleNamespace(dataset=str(self.folder), file=str(file), weights=None, minutes=1.0,
                                          real=str(real or self.folder / 'detect' / 'images' / 'val'), **more)
        made = []

        def make(classes, weights):
            self.assertIsNone(weights)
            made.append(FakeNetwork(find, classes))
            return made[0]

        out, log = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(log):
            trial.run(arguments, make, is_stopped, trial.Progress(log))
        return out.getvalue(), file.read_text('utf-8'), made[0]

    def test_learns_from_the_format_for_detectors(self):
        self.assertEqual(len(self.pictures), SCENES)
        for picture, scene in zip(self.pictures, self.dataset):
            seen = np.array([each.visible_box for each in scene.objects if each.is_labelled]) + 0.5
            np.testing.assert_allclose(picture.truth[:, 1:] * np.tile([scene.width, scene.height], 2), seen, atol=0.51)
        learnt, tested = pictures.divided(self.pictures)
        self.assertEqual([len(learnt), len(tested)], [SCENES // 2, SCENES // 2])
        self.assertEqual({each.split for each in learnt}, {'train'})

    def test_reads_the_same_of_coco(self):
        writer = next(each for each in self.dataset.writers if each.name == 'coco')
        images = [self.folder / 'coco' / 'images' / each.split / each.file.name for each in self.pictures]
        for picture, truth in zip(self.pictures, pictures._of_coco(writer, 'people', images)):
            np.testing.assert_allclose(picture.truth, truth, atol=1e-6)

    def test_keeps_every_twentieth_back_where_there_are_no_splits(self):
        some = [pictures.Picture(number, boxes.NONE, 'train') for number in range(60)]
        learnt, tested = pictures.divided(some)
        self.assertEqual([each.file for each in tested], [0, 20, 40])
        self.assertEqual(len(learnt), 57)

    def test_says_one_where_all_is_found(self):
        """Photographs without labels, and the same ones with them."""
        out, page, network = self.try_(self.perfect)
        self.assertRegex(out, r'4 photographs, AP50 unknown: they have no labels; in pictures of the dataset 1.000\n.*page.html\n$')
        self.assertEqual(len(network.learnt), SCENES // 2)
        text = Page(page).text
        self.assertIn('no labels, so it is not known what is right', text)
        self.assertIn('started untrained', text)
        self.assertIn('Most confident', text)
        out, page, _ = self.try_(self.perfect, self.folder / 'detect')
        labels = sum(len(each.truth) for each in self.pictures)
        self.assertIn(f'AP50 in {SCENES} photographs with {labels} labels: 1.000', out)
        self.assertIn('1.00', Page(page).text)

    def test_says_less_where_less_is_found(self):
        def first_alone(file):
            everything = self.perfect(file)
            return Found(*(column[:1] for column in everything))

        out, page, _ = self.try_(first_alone, self.folder / 'detect')
        value = float(out.split('labels: ')[1].split(';')[0])
        self.assertTrue(0.0 < value < 1.0, value)
        self.assertRegex(Page(page).text, r'1 of [23] found')

    def test_makes_a_page_that_needs_no_other_file(self):
        _, text, _ = self.try_(self.perfect, self.folder / 'detect')
        page = Page(text)
        pictures_in_it = [attributes for tag, attributes in page.tags if tag == 'img']
        self.assertEqual(len(pictures_in_it), SCENES)
        for tag, attributes in page.tags:
            self.assertNotIn(tag, ('script', 'link', 'iframe', 'object'))
            for name in ('src', 'href'):
                self.assertTrue(attributes.get(name, 'data:image/').startswith('data:image/'))

    def test_keeps_what_there_is_when_it_is_stopped(self):
        _, page, _ = self.try_(self.perfect, is_stopped=lambda: True)
        self.assertIn('was stopped after', Page(page).text)

    def test_leaves_out_what_cannot_be_read(self):
        broken = sorted(self.truth)[-1]
        _, page, _ = self.try_(lambda file: None if file == broken else self.perfect(file), self.folder / 'detect')
        self.assertIn(f'cannot be read, and are left out: 1, such as {broken.name}', Page(page).text)

    def test_refuses_weights_that_are_not_there(self):
        with self.assertRaisesRegex(DatasetError, 'no such file; weights are not fetched'):
            trial.run(types.SimpleNamespace(dataset=str(self.folder), file=str(self.scratch / 'x.html'), minutes=1.0,
                                            real=str(self.folder / 'detect'), weights='no.pt'), None, None, None)

    def test_leaves_the_dataset_alone(self):
        with self.assertRaisesRegex(DatasetError, "in the dataset's folder"):
            trial.run(types.SimpleNamespace(dataset=str(self.folder), file=str(self.folder / 'x.html')), None, None, None)

    def test_says_what_to_install(self):
        stub = self.scratch / 'without'
        stub.mkdir()
        (stub / 'ultralytics.py').write_text("raise ImportError(\"No module named 'ultralytics'\")\n")
        environment = {name: value for name, value in os.environ.items() if name != 'VIRTUAL_ENV'}
        environment['PYTHONPATH'] = f"{stub}:{environment.get('PYTHONPATH', '')}"
        program = subprocess.run(['catkin_find', '--first-only', '--libexec', 'synthetic_dataset', 'try_training'],
                                 stdout=subprocess.PIPE, universal_newlines=True, check=True).stdout.strip()
        ended = subprocess.run([program, str(self.folder), '--real', str(self.folder)], env=environment, check=False,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        self.assertEqual(ended.returncode, 1)
        self.assertIn('pip install ultralytics', ended.stdout)
        self.assertIn('AGPL-3.0', ended.stdout)
        self.assertEqual(run('try_training', '--help')[0], 0)
        self.assertEqual(run('try_training', self.folder)[0], 2)


class OfOtherFormats(DatasetCase):

    WRITERS = 'writers: [{name: yolo, type: synthetic_dataset/Yolo}]\nyolo: {main_list: list.txt}\n'

    def test_says_what_to_add(self):
        with self.assertRaisesRegex(DatasetError, r'its formats are synthetic_dataset/Yolo\. Add .*UltralyticsYolo'):
            pictures.read(Dataset(self.folder))


class Choice(unittest.TestCase):

    def results(self, scores, truths=None):
        founds = [found([[0, 0.0, 0.0, 0.2, 0.2, score] for score in each]) for each in scores]
        names = [pathlib.Path(f'{number}.jpg') for number in range(len(scores))]
        return choice.results_of(names, founds, truths or [None] * len(scores))

    def names_by_title(self, results, threshold):
        return {section.title: [each.file.stem for each in section.results]
                for section in choice.sections_of(results, threshold)}

    def test_shows_the_surest_then_those_near_the_threshold(self):
        scores = [[0.5 + 0.01 * number] for number in range(12)] + [[0.26], [0.05], [0.31, 0.02], []]
        named = self.names_by_title(self.results(scores), choice.USUAL_THRESHOLD)
        self.assertEqual(named['Most confident'], [str(number) for number in range(11, -1, -1)])
        self.assertEqual(named['Most doubtful'], ['12', '14'])
        self.assertEqual(named['Nothing found'], ['13', '15'])

    def test_shows_errors_where_labels_tell(self):
        label = np.array([[0, 0.0, 0.0, 0.2, 0.2]])
        far = np.array([[0, 0.7, 0.7, 0.9, 0.9]])
        count = 2 * choice.MOST_SHOWN
        results = self.results([[0.9]] * count + [[0.89], []], [label] * count + [boxes.NONE, far])
        named = self.names_by_title(results, 0.5)
        self.assertNotIn('Nothing found', named)
        self.assertEqual(named['Most confident'], [str(number) for number in range(choice.MOST_SHOWN)])
        shown = sum(named.values(), [])
        self.assertEqual(len(shown), len(set(shown)))
        self.assertIn(str(count), shown)
        self.assertIn(str(count + 1), shown)


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'python_trial', '__main__')
