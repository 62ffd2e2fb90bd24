"""SemanticKITTI, as semantic-kitti-api reads it (auxiliary/laserscan.py, remap_semantic_labels.py): float32 x, y, z
and remission of each point; uint32 labels, the class in the lower half and the object in the upper one."""
import unittest

import cv2
import numpy as np
import yaml

from loader_case import LoaderCase


class SemanticKittiTest(LoaderCase):
    def sequences(self):
        """Yields the scenes of each split, its sequence's folder and the configuration."""
        for truth, folder in self.datasets('semantic_kitti', ['lidar']):
            config = yaml.safe_load((folder / 'semantic-kitti.yaml').read_text())
            for split, name in (('train', 'train'), ('val', 'valid')):
                number, = config['split'][name]
                yield truth.of_split(split), folder / f'sequences/{number:02}', config

    def scans(self):
        for scenes, folder, config in self.sequences():
            self.assertEqual(len(list((folder / 'velodyne').iterdir())), len(scenes))
            for i, scene in enumerate(scenes):
                points = np.fromfile(folder / f'velodyne/{i:06}.bin', '<f4').reshape(-1, 4)
                labels = np.fromfile(folder / f'labels/{i:06}.label', '<u4')
                self.assertEqual(len(points), len(labels))
                yield scene, points, labels, config

    def test_points_are_the_scanners(self):
        for scene, points, _, _ in self.scans():
            self.assert_close(points[:, :3], scene.cloud.points, 1e-6)
            self.assert_close(points[:, 3], scene.cloud.intensities, 1e-6)
            self.assertGreater(points[:, 3].max(), 0)

    def test_labels_are_objects_and_their_classes(self):
        for scene, _, labels, config in self.scans():
            self.assert_same_pixels(labels >> 16, scene.cloud.instances)
            names = [config['labels'][number] for number in (labels & 0xffff).tolist()]
            of_object = {each.instance: each.class_name for each in scene.objects}
            self.assertEqual(names, [of_object.get(each, 'unlabeled') for each in scene.cloud.instances])

    def test_the_configuration_maps_each_label_there_and_back(self):
        for _, _, config in self.sequences():
            self.assertEqual(set(config['learning_map']), set(config['labels']))
            self.assertEqual(set(config['color_map']), set(config['labels']))
            for number, learnt in config['learning_map'].items():
                self.assertEqual(config['learning_map_inv'][learnt], number)
            self.assertEqual(config['learning_ignore'][0], True)
            self.assertAlmostEqual(sum(config['content'].values()), 1.0, places=6)

    def test_poses_and_calibration_put_points_where_the_camera_sees_them(self):
        for scenes, folder, _ in self.sequences():
            lines = (folder / 'calib.txt').read_text().split('\n')
            rows = {line.split(':')[0]: np.array(line.split(':')[1].split(), float).reshape(3, 4)
                    for line in lines if line}
            poses = np.loadtxt(folder / 'poses.txt').reshape(-1, 3, 4)
            self.assertEqual(len(poses), len(scenes))
            self.assert_close(poses, np.broadcast_to(np.eye(3, 4), poses.shape), 1e-9)  # nothing moves
            for i, scene in enumerate(scenes):
                points = np.fromfile(folder / f'velodyne/{i:06}.bin', '<f4').reshape(-1, 4)[:, :3]
                in_camera = points @ rows['Tr'][:, :3].T + rows['Tr'][:, 3]
                pixels = in_camera @ rows['P2'][:, :3].T
                pixels = np.round(pixels[:, :2] / pixels[:, 2:]).astype(int)
                inside = np.all((pixels >= 2) & (pixels < [scene.width - 2, scene.height - 2]), axis=1)
                u, v = pixels[inside].T
                seen = np.where(scene.depth > 0, scene.depth, np.inf)
                nearest = cv2.erode(seen, np.ones((3, 3)))[v, u]
                z = in_camera[inside][:, 2]
                is_seen = np.abs(z - seen[v, u]) < 0.02
                # The scanner is beside the camera: some of its points are hidden from the camera, and none is in
                # front of what the camera sees.
                self.assertGreater(np.mean(is_seen), 0.5)
                self.assertTrue(np.all(z > nearest - 0.02))
                same = scene.instances[v, u] == scene.cloud.instances[inside]
                self.assertGreater(np.mean(same[is_seen]), 0.98)


if __name__ == '__main__':
    unittest.main()
