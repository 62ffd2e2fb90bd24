"""Ultralytics YOLO's four tasks, by ultralytics.data, which loads such folders for training."""
import os
import pathlib
import tempfile
import unittest

os.environ.update(YOLO_OFFLINE='1', YOLO_VERBOSE='false')
os.environ['YOLO_CONFIG_DIR'] = tempfile.mkdtemp()  # settings.json goes there

import cv2  # noqa: E402
import numpy as np  # noqa: E402
from ultralytics.data import utils  # noqa: E402
from ultralytics.data.dataset import YOLODataset  # noqa: E402
from ultralytics.utils import LOGGER  # noqa: E402

from loader_case import LoaderCase, read_picture  # noqa: E402

LOGGER.setLevel('ERROR')
utils.check_font = lambda *_: None  # would download a font for names that are not ASCII

KEYPOINT_FLAGS = {'outside': 0, 'hidden_by_another': 1, 'hidden_by_itself': 1, 'visible': 2}


def hull_of(mask):
    """The convex hull of a mask's pixels, each with its whole area."""
    rows, columns = np.nonzero(mask)
    corners = [np.stack([columns + dx, rows + dy], 1) for dx in (0, 1) for dy in (0, 1)]
    return cv2.convexHull(np.concatenate(corners).astype(np.float32))[:, 0]


def overlap(a, b):
    """Intersection over union of two convex polygons."""
    common = cv2.intersectConvexConvex(a, b)[0]
    return common / (cv2.contourArea(a) + cv2.contourArea(b) - common)


class UltralyticsTest(LoaderCase):
    def loaded(self, task):
        """Yields each scene with the loader's label of its image."""
        for truth, folder in self.datasets(f'ultralytics_{task}'):
            folder = self.scratch_copy(folder)  # the loader writes caches
            data = utils.check_det_dataset(str(folder / 'data.yaml'), autodownload=False)
            for split in truth.splits:
                images = YOLODataset(img_path=data[split], data=data, task=task, augment=False,
                                     imgsz=320)
                cache = utils.load_dataset_cache_file(folder / f'labels/{split}.cache')
                self.assertEqual(cache['msgs'], [])
                labels = {pathlib.Path(each['im_file']).stem: each for each in images.labels}
                scenes = truth.of_split(split)
                self.assertEqual(sorted(labels), sorted(scene.flat_name for scene in scenes))
                yield from ((scene, labels[scene.flat_name]) for scene in scenes)

    def test_names_are_the_classes_at_their_numbers(self):
        for task in ('detect', 'segment', 'pose', 'obb'):
            for truth, folder in self.datasets(f'ultralytics_{task}'):
                data = utils.check_det_dataset(str(folder / 'data.yaml'), autodownload=False)
                self.assertEqual(list(data['names']), list(range(len(data['names']))))
                for number, name in truth.class_names.items():
                    self.assertEqual(data['names'][number], name)

    def test_every_scene_has_its_image(self):
        for scene, label in self.loaded('detect'):
            self.assert_same_pixels(read_picture(label['im_file']), scene.image, scene.name)
            self.assertEqual(tuple(label['shape']), (scene.height, scene.width))

    def test_classes_are_those_of_the_labelled_objects(self):
        for task in ('detect', 'segment', 'pose', 'obb'):
            for scene, label in self.loaded(task):
                self.assertEqual(label['cls'][:, 0].astype(int).tolist(),
                                 [each.class_id for each in scene.labelled], scene.name)

    def test_boxes_are_those_of_the_visible_pixels(self):
        for task in ('detect', 'pose'):
            for scene, label in self.loaded(task):
                self.check_boxes(scene, label, 1e-3)

    def test_segments_have_the_boxes_of_the_visible_pixels(self):
        for scene, label in self.loaded('segment'):
            self.check_boxes(scene, label, 0.03)  # points lie a little inside of pixels' edges

    def check_boxes(self, scene, label, tolerance):
        size = np.array([scene.width, scene.height] * 2)
        for each, found in zip(scene.labelled, label['bboxes']):
            left, top, right, bottom = each.visible_pixel_box
            expected = [(left + right + 1) / 2, (top + bottom + 1) / 2, right + 1 - left,
                        bottom + 1 - top]
            self.assert_close(found * size, expected, tolerance, f'{scene.name} {each.name}')

    def test_segments_are_the_visible_masks(self):
        for scene, label in self.loaded('segment'):
            self.assertEqual(len(label['segments']), len(scene.labelled))
            for each, segment in zip(scene.labelled, label['segments']):
                polygon = segment * (scene.width, scene.height)
                mask = utils.polygon2mask((scene.height, scene.width), [polygon.reshape(-1)])
                self.assert_mask_of_one_ring(mask > 0, each.visible,
                                             f'{scene.name} {each.name}')

    def test_keypoints_are_where_they_are_and_how_they_are_seen(self):
        for scene, label in self.loaded('pose'):
            for each, found in zip(scene.labelled, label['keypoints'] if scene.labelled else []):
                expected = np.zeros_like(found)
                for row, keypoint in zip(expected, each.keypoints):
                    flag = KEYPOINT_FLAGS[keypoint['state']]
                    if flag:
                        row[:] = *(np.array(keypoint['pixel']) + 0.5), flag
                found = found * (scene.width, scene.height, 1)
                self.assert_close(found, expected, 1e-3, f'{scene.name} {each.name}')

    def test_turned_boxes_are_the_least_ones_round_the_visible_pixels(self):
        count = 0
        for scene, label in self.loaded('obb'):
            for each, corners in zip(scene.labelled, label['segments']):
                size = np.array([scene.width, scene.height], np.float32)
                corners = np.asarray(corners, np.float32) * size
                hull = hull_of(each.visible)
                least = cv2.minAreaRect(hull)
                points = cv2.boxPoints(least)
                if points.min() < 0 or (points > size).any():  # cut back: labels stay in the image
                    self.assertGreater(overlap(corners, hull), 0.4, f'{scene.name} {each.name}')
                    continue
                count += 1
                inside = min(cv2.pointPolygonTest(corners, tuple(map(float, p)), True)
                             for p in hull)
                self.assertGreater(inside, -0.01, f'{scene.name} {each.name}')
                self.assertLess(cv2.contourArea(corners), least[1][0] * least[1][1] * 1.001 + 0.01,
                                f'{scene.name} {each.name}')
        self.assertGreater(count, 300)


if __name__ == '__main__':
    unittest.main()
