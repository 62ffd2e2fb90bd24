"""KITTI's object benchmark, by torchvision.datasets.Kitti."""
import unittest

import numpy as np
from torchvision.datasets import Kitti

from loader_case import LoaderCase


def folder_of(truth, folder, scene):
    return folder / scene.camera_name if len(truth.cameras) > 1 else folder


def corners_of(target):
    """The label's 3D box in the camera's frame, as in KITTI's devkit_object (computeBox3D.m)."""
    height, width, length = target['dimensions']
    turn = target['rotation_y']
    rotation = np.array([[np.cos(turn), 0, np.sin(turn)], [0, 1, 0],
                         [-np.sin(turn), 0, np.cos(turn)]])
    x = np.array([1, 1, -1, -1, 1, 1, -1, -1]) * length / 2
    y = np.array([0, 0, 0, 0, -1, -1, -1, -1]) * height
    z = np.array([1, -1, -1, 1, 1, -1, -1, 1]) * width / 2
    return np.stack([x, y, z], 1) @ rotation.T + target['location']


def by_value(points):
    return np.array(sorted(np.round(points, 4).tolist()))


class KittiTest(LoaderCase):
    def loaded(self):
        """Yields each scene with torchvision's image and target."""
        for truth, folder in self.datasets('kitti'):
            loaders = {}
            for scene in truth.scenes:
                if scene.camera_name not in loaders:
                    place = self.scratch_folder() / 'Kitti'
                    place.mkdir()
                    (place / 'raw').symlink_to(folder_of(truth, folder, scene))
                    loaders[scene.camera_name] = Kitti(str(place.parent), train=True)
                loader = loaders[scene.camera_name]
                names = [file.split('/')[-1] for file in loader.images]
                yield scene, *loader[names.index(f'{scene.instant:06}.png')]

    def labelled(self):
        """Yields each labelled object with its scene and target."""
        for scene, _, targets in self.loaded():
            targets = [each for each in targets if each['type'] != 'DontCare']
            self.assertEqual(len(targets), len(scene.labelled), scene.name)
            yield from ((scene, *pair) for pair in zip(scene.labelled, targets))

    def test_every_scene_is_there_with_its_image(self):
        for scene, image, _ in self.loaded():
            self.assert_same_pixels(np.array(image)[..., ::-1], scene.image, scene.name)

    def test_types_are_the_classes(self):
        for _, each, target in self.labelled():
            self.assertEqual(target['type'], each.class_name.replace(' ', '_'))

    def test_boxes_are_those_of_the_visible_pixels(self):
        for scene, each, target in self.labelled():
            left, top, right, bottom = each.visible_pixel_box
            self.assert_close(target['bbox'], [left, top, right + 1, bottom + 1], 1e-5, scene.name)

    def test_truncation_and_occlusion(self):
        for _, each, target in self.labelled():
            self.assertAlmostEqual(target['truncated'], each.truncation, delta=1e-5)
            seen = each.visible_pixels / max(each.silhouette_pixels_in_image, 1)
            self.assertEqual(target['occluded'], 0 if seen >= 0.9 else 1 if seen >= 0.5 else 2)

    def test_boxes_stand_on_the_middle_of_the_cuboids_bottom(self):
        for scene, each, target in self.labelled():
            low, high = np.array(each.cuboid_O)
            bottom_O = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]]
            self.assert_close([target['location']], each.to_camera([bottom_O]), 2e-6, scene.name)
            self.assert_close(target['dimensions'], (high - low)[[2, 1, 0]], 2e-6, scene.name)

    def test_upright_objects_have_their_cuboids_corners(self):
        count = 0
        for scene, each, target in self.labelled():
            if each.X_CO[1, 2] > -1 + 1e-9:  # the object's z axis is the image's upward one
                continue
            count += 1
            self.assert_close(by_value(corners_of(target)), by_value(each.cuboid_corners_C), 2e-4,
                              scene.name)
        self.assertGreater(count, 0)

    def test_alpha_is_the_yaw_against_the_ray(self):
        for _, each, target in self.labelled():
            x, _, z = target['location']
            difference = target['alpha'] - (target['rotation_y'] - np.arctan2(x, z))
            self.assertAlmostEqual(np.remainder(difference + 1, 2 * np.pi), 1, delta=1e-5)
            self.assertLessEqual(abs(target['alpha']), np.pi + 1e-6)
            self.assertLessEqual(abs(target['rotation_y']), np.pi + 1e-6)

    def test_calibration_projects_cuboids_as_the_camera_does(self):
        for truth, folder in self.datasets('kitti'):
            for scene in truth.scenes:
                file = folder_of(truth, folder, scene) / f'training/calib/{scene.instant:06}.txt'
                rows = dict(line.split(':') for line in file.read_text().splitlines() if line)
                numbers = {key: np.array(row.split(), float) for key, row in rows.items()}
                self.assertEqual(set(numbers), {'P0', 'P1', 'P2', 'P3', 'R0_rect',
                                                'Tr_velo_to_cam', 'Tr_imu_to_velo'})
                projection = numbers['P2'].reshape(3, 4)
                self.assert_close(projection[:, :3], scene.K, 1e-6)
                self.assert_close(projection[:, 3], [0, 0, 0], 0)
                self.assert_close(numbers['R0_rect'].reshape(3, 3), np.eye(3), 0)
                rotation = numbers['Tr_velo_to_cam'].reshape(3, 4)[:, :3]
                self.assertAlmostEqual(np.linalg.det(rotation), 1)

    def test_image_sets_name_the_splits_scenes(self):
        for truth, folder in self.datasets('kitti'):
            for split in truth.splits:
                for camera in {scene.camera_name for scene in truth.scenes}:
                    scenes = [scene for scene in truth.of_split(split)
                              if scene.camera_name == camera]
                    if not scenes:
                        continue
                    file = folder_of(truth, folder, scenes[0]) / f'ImageSets/{split}.txt'
                    self.assertEqual(file.read_text().split(),
                                     [f'{scene.instant:06}' for scene in scenes
                                      if scene.labelled])  # OpenPCDet needs a label in each


if __name__ == '__main__':
    unittest.main()
