"""KITTI as MMDetection3D and OpenPCDet prepare it before training.

MMDetection3D's preparation (tools/dataset_converters/kitti_data_utils.py) is in its wheel. OpenPCDet is not on PyPI: what
it opens is listed here (pcdet/datasets/kitti/kitti_dataset.py), and how it counts the points in a box
(pcdet/utils/box_utils.py, in_hull). Its own preparation runs where OPENPCDET names a clone of it.
"""
import importlib
import os
import pathlib
import sys
import types
import unittest

import cv2
import numpy as np
from scipy.spatial import Delaunay

import open_mmlab
from kitti_test import corners_of, folder_of
from loader_case import LoaderCase

OPENPCDET = os.environ.get('OPENPCDET')


def openpcdet(clone):
    """OpenPCDet's module for KITTI, without the parts that need a GPU's compiler, which are not called."""
    def stand_in(name, **members):
        sys.modules[name] = types.ModuleType(name)
        sys.modules[name].__dict__.update(members)
        sys.modules[name].__path__ = [str(clone / name.replace('.', '/'))]

    stand_in('skimage.transform')
    stand_in('skimage', transform=sys.modules['skimage.transform'],
             io=types.SimpleNamespace(imread=lambda file: cv2.imread(str(file))))
    for name in ('pcdet', 'pcdet.datasets', 'pcdet.datasets.kitti', 'pcdet.datasets.augmentor',
                 'pcdet.datasets.processor', 'pcdet.ops', 'pcdet.ops.roiaware_pool3d', 'pcdet.ops.iou3d_nms',
                 'pcdet.datasets.kitti.kitti_object_eval_python', 'SharedArray', 'spconv'):
        stand_in(name)
    for operators in ('pcdet.ops.roiaware_pool3d.roiaware_pool3d', 'pcdet.ops.iou3d_nms.iou3d_nms',
                      'pcdet.ops.iou3d_nms'):
        stand_in(f'{operators}_utils')
        stand_in(f'{operators}_cuda')
    sys.path.insert(0, str(clone))
    return importlib.import_module('pcdet.datasets.kitti.kitti_dataset')


def listed(folder, name):
    """The numbers in a list, which both preparations open without checking that it exists."""
    return [int(line) for line in (folder / f'ImageSets/{name}.txt').read_text().split()]


class KittiPreparationTest(LoaderCase):
    def folders(self):
        for truth, folder in self.datasets('kitti_scan'):
            for camera in {scene.camera_name: scene for scene in truth.scenes}.values():
                yield truth, folder_of(truth, folder, camera), camera.camera_name

    def test_mmdetection3d_finds_all_files_of_all_lists(self):
        utils = open_mmlab.preparation('kitti_data_utils')
        tested = 0
        for truth, folder, camera in self.folders():
            for name in ('train', 'val', 'test'):
                numbers = listed(folder, name)
                of_test = name == 'test'
                infos = utils.get_kitti_image_info(
                    str(folder), training=not of_test, label_info=not of_test, velodyne=True,
                    calib=True, with_plane=False, image_ids=numbers, num_worker=1)
                self.assertEqual([info['image']['image_idx'] for info in infos], numbers)
                expected = [scene.instant for scene in truth.of_split(name)
                            if scene.camera_name == camera and scene.labelled]
                self.assertEqual(numbers, expected)
                tested += of_test and len(numbers)
        self.assertGreater(tested, 0)

    def test_openpcdet_finds_all_files_of_all_lists(self):
        for _, folder, _ in self.folders():
            for name in ('train', 'val', 'test'):
                root = folder / ('testing' if name == 'test' else 'training')
                for number in listed(folder, name):
                    for file in (f'velodyne/{number:06}.bin', f'image_2/{number:06}.png',
                                 f'calib/{number:06}.txt'):
                        self.assertTrue((root / file).exists(), root / file)
                    points = np.fromfile(root / f'velodyne/{number:06}.bin', np.float32)
                    self.assertEqual(points.size % 4, 0)

    @unittest.skipUnless(OPENPCDET, 'OPENPCDET names no clone')
    def test_openpcdet_prepares_it(self):
        module = openpcdet(pathlib.Path(OPENPCDET))
        settings = types.SimpleNamespace(DATA_SPLIT={'test': 'val'}, INFO_PATH={'test': []})
        points = 0
        for truth, folder, camera in self.folders():
            reader = module.KittiDataset(settings, None, training=False, root_path=folder)
            for name in ('train', 'val', 'test'):
                reader.set_split(name)
                infos = reader.get_infos(num_workers=1, has_label=name != 'test')
                self.assertEqual([int(info['image']['image_idx']) for info in infos], listed(folder, name))
                for info in infos if name != 'test' else []:
                    scene = next(each for each in truth.scenes if each.camera_name == camera
                                 and each.instant == int(info['image']['image_idx']))
                    self.assertEqual(len(info['annos']['name']), len(scene.labelled))
                    points += sum(info['annos']['num_points_in_gt'])
        self.assertGreater(points, 10000)

    @unittest.skipUnless(OPENPCDET, 'OPENPCDET names no clone')
    def test_openpcdet_prepares_a_lidars_clouds(self):
        """It counts an object's points in the box as it is: some of those on a face are outside by rounding."""
        module = openpcdet(pathlib.Path(OPENPCDET))
        settings = types.SimpleNamespace(DATA_SPLIT={'test': 'val'}, INFO_PATH={'test': []})
        for truth, folder in self.datasets('kitti_lidar', ['lidar']):
            reader = module.KittiDataset(settings, None, training=False, root_path=folder)
            for split in ('train', 'val'):
                reader.set_split(split)
                infos = reader.get_infos(num_workers=1)
                self.assertEqual([int(each['image']['image_idx']) for each in infos], listed(folder, split))
                for info, scene in zip(infos, truth.of_split(split)):
                    self.assertEqual(len(info['annos']['name']), len(scene.labelled))
                    for count, each in zip(info['annos']['num_points_in_gt'], scene.labelled):
                        own = np.count_nonzero(scene.cloud.instances == each.instance)
                        self.assertTrue(0.8 * own <= count <= own, f'{count} of {own}')

    def test_mmdetection3d_finds_a_lidars_points_in_their_boxes(self):
        utils = open_mmlab.preparation('kitti_data_utils')
        for truth, folder in self.datasets('kitti_lidar', ['lidar']):
            for split in ('train', 'val'):
                infos = utils.get_kitti_image_info(str(folder), training=True, velodyne=True, calib=True,
                                                   image_ids=listed(folder, split), num_worker=1)
                self.assertEqual(len(infos), len(truth.of_split(split)))
                for info, scene in zip(infos, truth.of_split(split)):
                    points = np.fromfile(folder / info['point_cloud']['velodyne_path'], np.float32).reshape(-1, 4)
                    transform = info['calib']['R0_rect'] @ info['calib']['Tr_velo_to_cam']
                    in_camera = (np.c_[points[:, :3], np.ones(len(points))] @ transform.T)[:, :3]
                    for i, each in enumerate(scene.labelled):
                        length, height, width = info['annos']['dimensions'][i]
                        box = corners_of({'dimensions': np.array([height, width, length]) + 1e-3,
                                          'location': info['annos']['location'][i] + [0, 5e-4, 0],
                                          'rotation_y': info['annos']['rotation_y'][i]})
                        own = in_camera[scene.cloud.instances == each.instance]
                        self.assertGreater(len(own), 50)
                        self.assertTrue(np.all(Delaunay(box).find_simplex(own) >= 0), each.name)

    def test_points_of_an_object_are_in_its_box(self):
        """As OpenPCDet counts them, of objects that stand upright; but for single ones of faces that are seen along
        themselves, where a millimetre farther away is not a millimetre farther in."""
        utils = open_mmlab.preparation('kitti_data_utils')
        count = 0
        for truth, folder in self.datasets('kitti_scan'):
            for scene in truth.scenes:
                training = folder_of(truth, folder, scene) / 'training'
                annotations = utils.get_label_anno(str(training / f'label_2/{scene.instant:06}.txt'))
                points = np.fromfile(training / f'velodyne/{scene.instant:06}.bin', np.float32).reshape(-1, 4)
                instances = scene.instances[scene.depth != 0]
                self.assertEqual(len(points), len(instances))
                for i, each in enumerate(scene.labelled):
                    if each.X_CO[1, 2] > -1 + 1e-9:
                        continue
                    length, height, width = annotations['dimensions'][i]
                    box = corners_of({'dimensions': [height, width, length],
                                      'location': annotations['location'][i],
                                      'rotation_y': annotations['rotation_y'][i]})
                    own = points[instances == each.instance]
                    in_camera = np.stack([-own[:, 1], -own[:, 2], own[:, 0]], 1)
                    inside = Delaunay(box).find_simplex(in_camera) >= 0
                    self.assertGreaterEqual(np.count_nonzero(inside), 0.996 * len(own), f'{scene.name} {each.name}')
                    count += len(own)
        self.assertGreater(count, 100)


if __name__ == '__main__':
    unittest.main()
