"""COCO, by pycocotools: its reader, its masks and its evaluation; panoptic by panopticapi's rules."""
import contextlib
import io
import json
import unittest

import numpy as np
from pycocotools import mask as masks
from pycocotools.coco import COCO
from pycocotools.cocoeval import COCOeval

from loader_case import LoaderCase, read_picture

KEYPOINT_FLAGS = {'outside': 0, 'hidden_by_another': 1, 'hidden_by_itself': 1, 'visible': 2}
FULL = ('hard', 'lens', 'many', 'cameras')


def quiet():
    return contextlib.redirect_stdout(io.StringIO())


def load(file):
    with quiet():
        return COCO(str(file))


class CocoTest(LoaderCase):
    def loaded(self, writer='coco', names=FULL + ('empty',)):
        """Yields each split's scenes with its COCO object."""
        for truth, folder in self.datasets(writer, names):
            for split in truth.splits:
                yield (truth.of_split(split),
                       load(folder / f'annotations/instances_{split}.json'), folder, split)

    def annotations(self, writer='coco'):
        """Yields each labelled object with its scene, annotation and the COCO object."""
        for scenes, coco, _, _ in self.loaded(writer):
            for scene in scenes:
                found = coco.loadAnns(coco.getAnnIds(imgIds=[scene.index + 1]))
                self.assertEqual(len(found), len(scene.labelled), scene.name)
                yield from ((scene, *pair, coco) for pair in zip(scene.labelled, found))

    def test_images_are_the_scenes(self):
        for scenes, coco, folder, split in self.loaded():
            self.assertEqual(sorted(coco.imgs), [scene.index + 1 for scene in scenes])
            for scene in scenes:
                entry = coco.imgs[scene.index + 1]
                self.assertEqual((entry['width'], entry['height']), (scene.width, scene.height))
                place = folder / 'images' / (split if self.dataset == 'cameras' else '')
                self.assert_same_pixels(read_picture(place / entry['file_name']), scene.image)

    def test_ids_are_unique_from_1_in_all_splits_together(self):
        ids = {}
        for _, coco, folder, _ in self.loaded():
            ids.setdefault(folder, []).extend(coco.anns)
        for each in ids.values():
            self.assertEqual(len(each), len(set(each)))
            self.assertTrue(all(number >= 1 for number in each))

    def test_categories_are_the_classes(self):
        for truth, folder in self.datasets('coco'):
            coco = load(folder / f'annotations/instances_{truth.splits[0]}.json')
            self.assertEqual({number: each['name'] for number, each in coco.cats.items()},
                             {number + 1: name for number, name in truth.class_names.items()})

    def test_masks_are_the_visible_ones(self):
        for scene, each, found, coco in self.annotations():
            self.assert_same_pixels(coco.annToMask(found) > 0, each.visible,
                                    f'{scene.name} {each.name}')
            self.assertEqual(found['area'], each.visible_pixels)
            self.assertEqual(found['iscrowd'], 0)
            self.assertEqual(found['category_id'], each.class_id + 1)

    def test_polygons_fill_the_visible_masks(self):
        for scene, each, found, coco in self.annotations('coco_polygons'):
            self.assert_same_pixels(coco.annToMask(found) > 0, each.visible,
                                    f'{scene.name} {each.name}')

    def test_boxes_are_those_of_the_masks(self):
        for scene, each, found, coco in self.annotations():
            self.assertEqual(found['bbox'], masks.toBbox(coco.annToRLE(found)).tolist())
            left, top, right, bottom = each.visible_pixel_box
            self.assertEqual(found['bbox'], [left, top, right + 1 - left, bottom + 1 - top])

    def test_keypoints_are_pixels_with_what_hides_them(self):
        for scene, each, found, coco in self.annotations():
            names = coco.cats[found['category_id']].get('keypoints', [])
            rows = np.array(found.get('keypoints', [])).reshape(-1, 3)
            self.assertGreaterEqual(len(names), len(each.keypoints))
            self.assertGreaterEqual(len(rows), len(each.keypoints))
            flags = [KEYPOINT_FLAGS[keypoint['state']] for keypoint in each.keypoints]
            expected = np.zeros_like(rows)
            for row, flag, keypoint in zip(expected, flags, each.keypoints):
                row[:] = (*keypoint['pixel'], flag) if flag else (0, 0, 0)
            self.assert_close(rows, expected, 1e-9, f'{scene.name} {each.name}')
            self.assertEqual(found['num_keypoints'], sum(flag > 0 for flag in flags))

    def evaluate(self, coco, kind, categories, keypoint_count=0):
        """Every precision that is defined, with the ground truth as detections of itself."""
        key = 'segmentation' if kind == 'segm' else kind
        # COCOeval ignores annotations without keypoints in the image, but not detections of them.
        results = [{'image_id': each['image_id'], 'category_id': each['category_id'],
                    'score': 1.0, key: each[key]}
                   for each in coco.anns.values() if each['category_id'] in categories
                   and (kind != 'keypoints' or each['num_keypoints'])]
        with quiet():
            evaluation = COCOeval(coco, coco.loadRes(results), kind)
            evaluation.params.maxDets = [1, 10, 1000]
            evaluation.params.catIds = categories
            if keypoint_count:
                evaluation.params.kpt_oks_sigmas = np.full(keypoint_count, 0.1)
                evaluation.params.maxDets = [1000]
            evaluation.evaluate()
            evaluation.accumulate()
        precision = evaluation.eval['precision'][..., 0, -1]
        return precision[precision > -1]

    def test_ground_truth_scores_fully_against_itself(self):
        for _, coco, _, _ in self.loaded(names=FULL):
            categories = sorted({each['category_id'] for each in coco.anns.values()})
            for kind in ('bbox', 'segm'):
                precision = self.evaluate(coco, kind, categories)
                self.assertGreater(precision.size, 0)
                self.assertEqual(precision.min(), 1.0, kind)

    def test_keypoints_score_fully_against_themselves(self):
        for _, coco, _, _ in self.loaded(names=FULL):
            for category in {each['category_id'] for each in coco.anns.values()
                             if each['num_keypoints']}:
                count = len(coco.cats[category]['keypoints'])
                precision = self.evaluate(coco, 'keypoints', [category], count)
                self.assertGreater(precision.size, 0)
                self.assertEqual(precision.min(), 1.0, coco.cats[category]['name'])

    def test_panoptic_pictures_and_segments_name_one_another(self):
        # The checks of panopticapi's evaluation.py, pq_compute_single_core.
        for truth, folder in self.datasets('coco'):
            for split in truth.splits:
                file = folder / f'annotations/panoptic_{split}.json'
                content = json.loads(file.read_text(encoding='utf-8'))
                categories = {each['id']: each for each in content['categories']}
                self.assertTrue(all({'isthing', 'color'} <= set(each)
                                    for each in categories.values()))
                colours = {tuple(each['color']) for each in categories.values()}
                self.assertEqual(len(colours), len(categories))
                scenes = truth.of_split(split)
                self.assertEqual(len(content['annotations']), len(scenes))
                for scene, entry in zip(scenes, content['annotations']):
                    self.assertEqual(entry['image_id'], scene.index + 1)
                    picture = read_picture(file.with_suffix('') / entry['file_name']).astype(int)
                    ids = picture[..., 2] + 256 * picture[..., 1] + 65536 * picture[..., 0]
                    segments = {each['id']: each for each in entry['segments_info']}
                    self.assertEqual(set(np.unique(ids)) - {0}, set(segments))
                    self.assertEqual(len(segments), len(scene.labelled))
                    for each, segment in zip(scene.labelled, entry['segments_info']):
                        self.assert_same_pixels(ids == segment['id'], each.visible, scene.name)
                        self.assertEqual(segment['area'], each.visible_pixels)
                        self.assertIn(segment['category_id'], categories)


if __name__ == '__main__':
    unittest.main()
