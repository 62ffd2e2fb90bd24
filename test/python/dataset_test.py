#!/usr/bin/env python3
"""`from synthetic_dataset import Dataset`, against the files and the manifest itself."""
import concurrent.futures
import contextlib
import json
import multiprocessing
import os
import shutil
import sqlite3
import tempfile
import unittest

import numpy as np
from PIL import Image
import rosunit

from example_dataset import DatasetCase, REPOSITORY, SCENES
from synthetic_dataset import Dataset, DatasetError
from synthetic_dataset.truth import mask_of_bytes


def sum_of_image(scene):
    return scene.image.sum()


class Scenes(DatasetCase):

    def setUp(self):
        self.dataset = Dataset(self.folder)
        database = sqlite3.connect(self.folder / 'manifest.sqlite')
        self.addCleanup(database.close)
        self.query = database.execute

    def seen(self):
        for scene in self.dataset:
            for each in scene.objects:
                if each.is_labelled:
                    yield scene, each

    def test_are_a_sequence(self):
        self.assertEqual(len(self.dataset), SCENES)
        self.assertEqual([scene.index for scene in self.dataset], list(range(SCENES)))
        self.assertEqual(self.dataset[-1].index, SCENES - 1)
        self.assertEqual([scene.index for scene in self.dataset[2:4]], [2, 3])
        self.assertTrue(self.dataset.is_complete)
        with self.assertRaises(IndexError):
            self.dataset[SCENES]
        with self.assertRaisesRegex(DatasetError, f'no scene 99; found {SCENES} scenes, 0 to 7'):
            self.dataset.scene(99)

    def test_are_divided_into_splits(self):
        self.assertEqual(self.dataset.splits, ['train', 'val'])
        indices = [scene.index for split in ('train', 'val') for scene in self.dataset.split(split)]
        self.assertEqual(indices, list(range(SCENES)))
        self.assertTrue(all(scene.split == 'val' for scene in self.dataset.split('val')))
        with self.assertRaisesRegex(DatasetError, "no split 'test'; found 'train', 'val'"):
            self.dataset.split('test')

    def test_have_objects_that_are_not_in_them(self):
        columns = ['x', 'y', 'z', 'qx', 'qy', 'qz', 'qw', 'distance'] + [
            f'{kind}_{edge}' for kind in ('loose', 'silhouette', 'visible')
            for edge in ('left', 'top', 'right', 'bottom')]
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(self.folder / 'manifest.sqlite', folder)
            with contextlib.closing(sqlite3.connect(f'{folder}/manifest.sqlite')) as database:
                database.execute(
                    'UPDATE scene_object SET ' + ', '.join(f'{each} = NULL' for each in columns)
                    + ', in_view = 0, dropped = 1, silhouette_pixels = 0, visible_pixels = 0, '
                    'visibility = 0 WHERE scene = 1 AND object = 2')
                database.commit()
            rover, _, drone = Dataset(folder)[1].objects
            self.assertTrue(rover.is_there)
            self.assertEqual(rover.X_CO.shape, (4, 4))
            self.assertFalse(drone.is_there or drone.is_labelled)
            self.assertEqual([drone.X_GO, drone.X_CO, drone.distance], [None, None, None])

    def test_have_classes_and_objects(self):
        self.assertEqual(sorted(self.dataset.classes.values()), ['drone', 'rover'])
        self.assertEqual([each.name for each in self.dataset[0].objects],
                         ['rover_1', 'rover_2', 'drone_1'])
        self.assertEqual([each.class_name for each in self.dataset[0].objects],
                         ['rover', 'rover', 'drone'])

    def test_have_the_image_of_each_format(self):
        for scene in self.dataset:
            with Image.open(self.folder / 'bop' / scene.split
                            / f'000000/rgb/{scene.index:06}.png') as picture:
                np.testing.assert_array_equal(scene.image, np.array(picture))
            self.assertEqual(scene.image.shape, (scene.height, scene.width, 3))

    def test_have_masks_of_their_objects(self):
        count = 0
        for scene, each in self.seen():
            mask = each.mask
            self.assertEqual(np.count_nonzero(mask), each.visible_pixels)
            rows, columns = np.nonzero(mask)
            np.testing.assert_array_equal(
                each.visible_box, [columns.min() - 0.5, rows.min() - 0.5,
                                   columns.max() + 0.5, rows.max() + 0.5])
            count += 1
        self.assertGreater(count, SCENES)

    def test_have_depth_where_objects_are(self):
        for scene, each in self.seen():
            depth = scene.depth[each.mask]
            self.assertEqual(depth.dtype, np.float32)
            self.assertLess(abs(np.median(depth) - each.X_CO[2, 3]), 1.0)  # [m], its size

    def test_have_the_depth_that_bop_rounds(self):
        for scene in self.dataset:
            file = self.folder / 'bop' / scene.split / f'000000/depth/{scene.index:06}.png'
            with Image.open(file) as picture:
                steps = np.array(picture).astype(float)
            scale = json.loads((file.parents[1] / 'scene_camera.json').read_text())
            scale = scale[str(scene.index)]['depth_scale'] / 1000
            np.testing.assert_allclose(steps * scale, scene.depth, atol=0.51 * scale + 1e-6)

    def test_have_poses_as_formats_write_them(self):
        found = 0
        for line in (self.folder / 'folder/train/metadata.jsonl').read_text('utf-8').splitlines():
            entry = json.loads(line)
            scene = self.dataset[entry['instant']]
            np.testing.assert_allclose(scene.X_GC.ravel(), entry['camera']['X_GC'], atol=1e-12)
            by_name = {each.name: each for each in scene.objects}
            for name, X_CO in zip(entry['objects']['names'], entry['objects']['X_CO']):
                np.testing.assert_allclose(by_name[name].X_CO.ravel(), X_CO, atol=1e-9)
                found += 1
        self.assertGreater(found, 0)

    def test_have_keypoints_and_cameras_as_formats_write_them(self):
        states = {'outside': 0, 'hidden by another': 1, 'hidden by itself': 1, 'visible': 2}
        found = 0
        for line in (self.folder / 'folder/train/metadata.jsonl').read_text('utf-8').splitlines():
            entry = json.loads(line)
            scene = self.dataset[entry['instant']]
            np.testing.assert_allclose(scene.K.ravel(), entry['camera']['K'])
            objects = entry['objects']
            by_name = {each.name: each for each in scene.objects}
            for row, each in enumerate(by_name[name] for name in objects['names']):
                np.testing.assert_allclose(each.keypoints, objects['keypoints'][row], atol=1e-9)
                self.assertEqual([states[state] for state in each.keypoint_states],
                                 objects['keypoint_visibility'][row])
                np.testing.assert_allclose(each.cuboid.ravel(), objects['cuboid'][row])
                points = np.c_[each.keypoints_O, np.ones(len(each.keypoints_O))] @ each.X_CO.T
                pixels = points[:, :3] @ scene.K.T
                np.testing.assert_allclose(pixels[:, :2] / pixels[:, 2:], each.keypoints, atol=1e-6)
                found += 1
        self.assertGreater(found, 0)

    def test_have_silhouettes_that_contain_masks(self):
        for _, each in self.seen():
            self.assertFalse(np.any(each.mask & ~each.silhouette))
        self.assertTrue(any(each.silhouette.sum() > each.mask.sum() for _, each in self.seen()))

    def test_have_what_was_drawn(self):
        rows = self.query("SELECT scene, value FROM draw WHERE name = 'sensor/exposure'").fetchall()
        self.assertEqual({scene.index: scene.draws['sensor/exposure'] for scene in self.dataset},
                         {scene: json.loads(value) for scene, value in rows})

    def test_have_tables(self):
        table = self.dataset.table('scene_object')
        self.assertEqual(list(table['visible_pixels']), [value for value, in self.query(
            'SELECT visible_pixels FROM scene_object ORDER BY scene, object')])
        with self.assertRaisesRegex(DatasetError, "no table 'scenes'; it has .*scene_object"):
            self.dataset.table('scenes')
        self.assertEqual(self.dataset.settings['camera_frame_id'], 'camera/optical_link')

    def test_can_be_read_by_the_workers_of_loaders(self):
        expected = [scene.image.sum() for scene in self.dataset]
        scenes = list(self.dataset)
        for method in ('fork', 'spawn'):
            with multiprocessing.get_context(method).Pool(2) as workers:
                self.assertEqual(workers.map(sum_of_image, scenes), expected)
        with concurrent.futures.ThreadPoolExecutor(2) as workers:
            self.assertEqual(list(workers.map(sum_of_image, scenes)), expected)

    def test_have_frames_of_pandas_where_it_is_installed(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest('pandas is not installed')
        frame = self.dataset.frame('scene_object')
        self.assertEqual(len(frame), 3 * SCENES)
        self.assertEqual(frame.groupby('scene')['in_view'].sum().max(), 3)


class OfCocoAlone(DatasetCase):

    WRITERS = 'writers: [{name: coco, type: synthetic_dataset/Coco}]\n'

    def test_masks_come_from_the_manifest(self):
        for scene in Dataset(self.folder):
            for each in scene.objects:
                self.assertEqual(np.count_nonzero(each.mask), each.visible_pixels)

    def test_what_no_format_has_is_an_error(self):
        with self.assertRaisesRegex(DatasetError, 'scene 0: no writer of this dataset has depth '
                                    r'.*found coco \(synthetic_dataset/Coco\); ImageFolder with'):
            _ = Dataset(self.folder)[0].depth

    def test_moves_with_its_folder(self):
        moved = self.scratch / 'moved'
        os.rename(self.folder, moved)
        self.addCleanup(os.rename, moved, self.folder)
        self.assertEqual(Dataset(moved)[0].image.shape, (480, 640, 3))


class OfBoxesAlone(DatasetCase):
    """A format that needs no masks: what was not measured is None."""

    WRITERS = ('writers: [{name: yolo, type: synthetic_dataset/Yolo}]\n'
               'yolo: {main_list: list.txt}\n')

    def test_what_was_not_measured_is_none(self):
        for scene in Dataset(self.folder):
            for each in scene.objects:
                self.assertIsNone(each.visible_pixels)
                self.assertIsNone(each.visible_box)
                self.assertEqual(each.loose_box.shape, (4,))

    def test_images_are_found(self):
        self.assertEqual(Dataset(self.folder)[0].image.shape, (480, 640, 3))


class Faults(unittest.TestCase):

    def test_name_the_folder(self):
        with self.assertRaisesRegex(DatasetError, "'/no/such': no such folder"):
            Dataset('/no/such')
        with self.assertRaisesRegex(DatasetError, 'no dataset is there'):
            Dataset(os.path.dirname(__file__))

    def test_masks_of_the_manifest_are_read(self):
        expected = np.zeros((4, 300), bool)
        expected[1, 41:300] = expected[2, 40:200] = True
        # A box of 260 x 2 at (40, 1): 1 off, 419 on, 100 off; seven bits per byte, lowest first.
        np.testing.assert_array_equal(
            mask_of_bytes(bytes([40, 1, 132, 2, 2, 1, 163, 3, 100]), 4, 300), expected)


class FormatOfOnesOwn(DatasetCase):

    def test_is_written_by_the_thirty_lines_of_the_documentation(self):
        page = (REPOSITORY / 'docs' / 'python.md').read_text('utf-8')
        program = page.split("## Your own format", 1)[1]
        program = program.split('```python\n', 1)[1].split('```', 1)[0]
        self.assertLessEqual(len(program.splitlines()), 30)
        with tempfile.TemporaryDirectory() as place:
            os.mkdir(os.path.join(place, 'datasets'))
            os.symlink(self.folder, os.path.join(place, 'datasets', 'example'))
            before = os.getcwd()
            os.chdir(place)
            try:
                exec(compile(program, 'python.md', 'exec'), {})  # pylint: disable=exec-used
            finally:
                os.chdir(before)
            made = os.path.join(place, 'datasets', 'my_format')
            scene = Dataset(self.folder)[SCENES - 1]
            with open(os.path.join(made, 'labels', f'{scene.index:06}.json'), 'rb') as file:
                labels = json.load(file)['objects']
            seen = [each for each in scene.objects if each.is_labelled]
            self.assertEqual([each['class'] for each in labels],
                             [each.class_name for each in seen])
            for label, each in zip(labels, seen):
                with Image.open(os.path.join(made, label['mask'])) as mask:
                    self.assertTrue(np.array_equal(np.asarray(mask) > 0, each.mask))


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'python_dataset', '__main__')
