"""COCO, its panoptic files and Pascal VOC, by mmdet's datasets."""
import contextlib
import io
import pathlib
import unittest

import open_mmlab  # noqa: F401  before mmdet
from loader_case import LoaderCase

import numpy as np
from mmdet.datasets import CocoDataset, CocoPanopticDataset, XMLDataset
from pycocotools import mask as masks


class MmdetTest(LoaderCase):
    def made(self, kind, **settings):
        with contextlib.redirect_stdout(io.StringIO()):
            return kind(pipeline=[], test_mode=True, **settings)

    def loaded(self, kind, truth, **settings):
        """Yields each scene with the dataset's data about its image."""
        infos = list(self.made(kind, **settings))
        self.assertEqual(len(infos), len(truth.scenes))
        by_name = {pathlib.Path(each['img_path']).stem: each for each in infos}
        for scene in truth.scenes:
            yield scene, by_name[scene.flat_name]

    def assert_instances(self, scene, instances, names, shift=(0, 0, 0, 0)):
        """Compares boxes with the visible ones.

        @param shift: how the loader's convention differs from left, top, right, bottom edges
        """
        expected = [np.add([left, top, right + 1, bottom + 1], shift) for left, top, right, bottom
                    in (each.visible_pixel_box for each in scene.labelled)]
        self.assert_close(np.reshape([each['bbox'] for each in instances], (-1, 4)),
                          np.reshape(expected, (-1, 4)), 1e-6, scene.name)
        self.assertEqual([names[each['bbox_label']] for each in instances],
                         [each.class_name for each in scene.labelled], scene.name)

    def test_coco(self):
        for truth, folder in self.datasets('coco', ('hard', 'many')):
            names = tuple(truth.class_names.values())
            for scene, info in self.loaded(
                    CocoDataset, truth, metainfo={'classes': names},
                    ann_file=str(folder / 'annotations/instances_train.json'),
                    data_prefix={'img': str(folder / 'images')}):
                self.assertTrue(pathlib.Path(info['img_path']).is_file())
                self.assert_instances(scene, info['instances'], names)
                for found, each in zip(info['instances'], scene.labelled):
                    self.assert_same_pixels(masks.decode(found['mask']) > 0, each.visible)

    def test_coco_panoptic(self):
        for truth, folder in self.datasets('coco', ('hard', 'many')):
            names = tuple(truth.class_names.values())
            for scene, info in self.loaded(
                    CocoPanopticDataset, truth, metainfo={
                        'classes': names, 'thing_classes': names, 'stuff_classes': ()},
                    ann_file=str(folder / 'annotations/panoptic_train.json'),
                    data_prefix={'img': str(folder / 'images'),
                                 'seg': str(folder / 'annotations/panoptic_train')}):
                self.assertTrue(pathlib.Path(info['seg_map_path']).is_file())
                self.assert_instances(scene, info['instances'], names)
                self.assertEqual([each['id'] for each in info['segments_info']],
                                 [each.instance for each in scene.labelled])

    def test_pascal_voc(self):
        for truth, folder in self.datasets('pascal_voc', ('hard',)):
            names = tuple(truth.class_names.values())
            for scene, info in self.loaded(
                    XMLDataset, truth, metainfo={'classes': names},
                    ann_file=str(folder / 'ImageSets/Main/train.txt'),
                    data_prefix={'sub_data_root': str(folder)}):
                # It subtracts 1 from all four, which makes the last pixel's number its left edge.
                self.assert_instances(scene, info['instances'], names, (0, 0, -1, -1))


if __name__ == '__main__':
    unittest.main()
