"""PVNet's custom datasets, as clean-pvnet's handle_custom_dataset.py and its loader read them."""
import contextlib
import io
import os
import unittest

import numpy as np
from plyfile import PlyData
from pycocotools.coco import COCO

from loader_case import LoaderCase, named_folder, read_picture


def vertices_of(file):
    vertex = PlyData.read(str(file))['vertex']
    return np.stack([vertex['x'], vertex['y'], vertex['z']], 1).astype(float)


class PvNetTest(LoaderCase):
    def folders(self):
        """Yields the folder of each object and camera with its scenes, in the samples' order."""
        for truth, folder in self.datasets('pvnet'):
            for index, info in enumerate(truth.objects):
                for camera in truth.cameras:
                    place = named_folder(folder, info['name'])
                    if len(truth.cameras) > 1:
                        place = place / camera['name']
                    scenes = [scene for scene in truth.scenes
                              if scene.camera_name == camera['name']
                              and self.is_sample(scene.objects[index])]
                    yield place, index, info, scenes, truth

    @staticmethod
    def is_sample(each):
        """As far as the truth can tell; objects partly behind the camera are not samples."""
        return each.labelled and each.cuboid_corners_C[:, 2].min() > 0.05

    def samples(self):
        for place, index, _, scenes, _ in self.folders():
            for i, scene in enumerate(scenes):
                yield place, i, scene, scene.objects[index]

    def annotations(self):
        """Yields each annotation with its folder, object and scene."""
        for place, index, _, scenes, truth in self.folders():
            for split in truth.splits:
                with contextlib.redirect_stdout(io.StringIO()):
                    coco = COCO(str(place / f'{split}.json'))
                of_split = [scene for scene in scenes if scene.split_or_train == split]
                self.assertEqual(len(coco.anns), len(of_split))
                for number, scene in zip(sorted(coco.imgs), of_split):
                    annotation, = coco.loadAnns(coco.getAnnIds(imgIds=[number]))
                    yield place, annotation, scene.objects[index], scene, coco.imgs[number]

    def test_samples_are_numbered_from_0_without_gaps(self):
        for place, _, _, scenes, _ in self.folders():
            for kind, name in (('rgb', '{}.jpg'), ('mask', '{}.png'), ('pose', 'pose{}.npy')):
                found = os.listdir(place / kind) if scenes else []
                self.assertEqual(sorted(found),
                                 sorted(name.format(i) for i in range(len(scenes))), place)

    def test_images_are_the_scenes(self):
        for place, i, scene, _ in self.samples():
            difference = read_picture(place / f'rgb/{i}.jpg').astype(float) - scene.image
            self.assertLess(np.abs(difference).mean(), 4, f'{place} {i}')  # JPEG

    def test_masks_are_the_visible_ones(self):
        for place, i, _, each in self.samples():
            self.assert_same_pixels(read_picture(place / f'mask/{i}.png') != 0, each.visible, place)

    def test_poses_are_the_objects(self):
        for place, i, _, each in self.samples():
            pose = np.load(place / f'pose/pose{i}.npy')
            self.assertEqual((pose.shape, pose.dtype), ((3, 4), np.dtype('<f8')))
            self.assert_close(pose, each.X_CO[:3], 1e-12, place)

    def test_cameras_and_models_are_the_datasets(self):
        for place, _, info, scenes, truth in self.folders():
            camera = next(scene for scene in truth.scenes)
            self.assert_close(np.loadtxt(place / 'camera.txt'), camera.K, 1e-12)
            vertices = vertices_of(place / 'model.ply')
            self.assert_close(vertices, info['vertices'], 1e-6, place)
            self.assertAlmostEqual(float(np.loadtxt(place / 'diameter.txt')), info['diameter'],
                                   delta=1e-9)

    def test_farthest_points_are_eight_vertices(self):
        for place, _, _, _, _ in self.folders():
            points = np.loadtxt(place / 'fps.txt')
            self.assertEqual(points.shape, (8, 3))
            vertices = vertices_of(place / 'model.ply')
            distances = np.linalg.norm(points[:, None] - vertices[None], axis=2).min(1)
            self.assertLess(distances.max(), 1e-6, place)

    def test_annotations_name_files_that_are_there(self):
        for place, annotation, each, _, image in self.annotations():
            root = 'data/custom/'
            self.assertTrue(image['file_name'].startswith(root))
            self.assertTrue((place / image['file_name'][len(root):]).exists())
            mask = place / annotation['mask_path'][len(root):]
            self.assert_same_pixels(read_picture(mask) != 0, each.visible, place)

    def test_annotations_project_the_models_points(self):
        for place, annotation, each, scene, _ in self.annotations():
            K, pose = np.array(annotation['K']), np.array(annotation['pose'])
            self.assert_close(K, scene.K, 1e-12)
            self.assert_close(pose, each.X_CO[:3], 1e-12)
            for kind in ('fps', 'corner', 'center'):
                points = np.array(annotation[f'{kind}_3d']).reshape(-1, 3)
                pixels = np.array(annotation[f'{kind}_2d']).reshape(-1, 2)
                # Where the points are in the image, through the lens that `camera.txt` lacks.
                self.assert_close(pixels, scene.project(each.to_camera(points)), 1e-6, place)
            self.assert_close(annotation['fps_3d'], np.loadtxt(place / 'fps.txt'), 1e-12)
            self.assertEqual((annotation['cls'], annotation['type'], annotation['category_id']),
                             ('cat', 'real', 1))

    def test_corners_are_in_clean_pvnets_order(self):
        for place, annotation, _, _, _ in self.annotations():
            vertices = vertices_of(place / 'model.ply')
            ends = vertices.min(0), vertices.max(0)
            expected = [[ends[i >> 2 & 1][0], ends[i >> 1 & 1][1], ends[i & 1][2]]
                        for i in range(8)]
            self.assert_close(annotation['corner_3d'], expected, 1e-6, place)
            self.assert_close(annotation['center_3d'], (ends[0] + ends[1]) / 2, 1e-6, place)


if __name__ == '__main__':
    unittest.main()
