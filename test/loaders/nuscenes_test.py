"""nuScenes by its devkit: tables, and boxes in images."""
import pathlib
import unittest

import numpy as np
from nuscenes.nuscenes import NuScenes
from nuscenes.utils.data_classes import LidarPointCloud
from nuscenes.utils.data_io import load_bin_file
from nuscenes.utils.geometry_utils import BoxVisibility, points_in_box, view_points
from nuscenes.utils.splits import create_splits_scenes
from pyquaternion import Quaternion

from loader_case import LoaderCase, read_picture

NAMES = ('hard', 'many', 'cameras', 'empty')


def by_value(points):
    return np.array(sorted(np.round(points, 5).tolist()))


class NuScenesTest(LoaderCase):
    def loaded(self):
        """Yields each scene with the devkit's database and the record of its image."""
        for truth, folder in self.datasets('nuscenes', NAMES):
            database = NuScenes('v1.0-trainval', str(folder), verbose=False)
            self.assertEqual(len(database.sample_data), len(truth.scenes))
            by_time = {(each['timestamp'], each['channel']): each for each in database.sample_data}
            for scene in truth.scenes:
                one = len(truth.cameras) == 1
                channel = 'CAM_FRONT' if one else f'CAM_{scene.camera_name.upper()}'
                yield scene, database, by_time[scene.stamp_ns // 1000, channel]

    def test_images_are_the_scenes(self):
        for scene, database, record in self.loaded():
            picture = read_picture(database.get_sample_data_path(record['token']))
            self.assertEqual(picture.shape, scene.image.shape)
            self.assertLess(np.abs(picture.astype(int) - scene.image).mean(), 4.0)

    def test_boxes_stand_where_the_objects_do(self):
        for scene, database, record in self.loaded():
            _, boxes, intrinsic = database.get_sample_data(record['token'],
                                                           box_vis_level=BoxVisibility.NONE)
            self.assert_close(intrinsic, scene.K, 1e-9)
            found = {database.get('sample_annotation', box.token)['instance_token']: box
                     for box in boxes}
            for each in scene.labelled:
                box = next(box for token, box in found.items()
                           if int(token[-14:], 16) == each.instance - 1)
                self.assertEqual(box.name, each.class_name)
                self.assert_close(by_value(box.corners().T), by_value(each.cuboid_corners_C), 1e-4,
                                  f'{scene.name} {each.name}')
                corners = each.cuboid_corners_C
                if corners[:, 2].min() > 0.1 and not any(scene.camera['D']):
                    seen = view_points(box.corners(), intrinsic, normalize=True)[:2].T
                    self.assert_close(by_value(np.round(seen, 2)),
                                      by_value(np.round(scene.project(corners), 2)), 0.02)

    def test_scenes_are_of_the_devkits_splits(self):
        of_split = create_splits_scenes()
        self.assertEqual({'train', 'val', 'test'} - set(of_split), set())
        found = set()
        for _, folder in self.datasets('nuscenes', NAMES):
            for scene in NuScenes('v1.0-trainval', str(folder), verbose=False).scene:
                split = scene['description'].split(',')[0]
                self.assertIn(scene['name'], of_split[split])
                found.add(split)
        self.assertGreater(len(found), 1)

    def test_tracks_are_the_objects(self):
        for truth, folder in self.datasets('nuscenes', NAMES):
            database = NuScenes('v1.0-trainval', str(folder), verbose=False)
            for instance in database.instance:
                token, count = instance['first_annotation_token'], 0
                while token:
                    annotation = database.get('sample_annotation', token)
                    self.assertEqual(annotation['instance_token'], instance['token'])
                    token, count = annotation['next'], count + 1
                self.assertEqual(count, instance['nbr_annotations'])
            expected = {(scene.instant, each.instance) for scene in truth.scenes
                        for each in scene.labelled}
            self.assertEqual(len(database.sample_annotation), len(expected))

    def lidar(self):
        """Yields each scene with the devkit's database and the record of its cloud."""
        for truth, folder in self.datasets('nuscenes_lidar', ['lidar']):
            database = NuScenes('v1.0-trainval', str(folder), verbose=False,
                                colormap={name: (9, 9, 9) for name in ('noise', 'rover', 'frame')})
            for scene in truth.scenes:
                sample = next(each for each in database.sample if each['timestamp'] == scene.stamp_ns // 1000)
                yield scene, database, sample['data']['LIDAR_TOP']

    def test_lidars_points_are_where_the_objects_are(self):
        for scene, database, token in self.lidar():
            file, boxes, _ = database.get_sample_data(token, box_vis_level=BoxVisibility.NONE)
            cloud = LidarPointCloud.from_file(file)
            self.assertEqual(cloud.points.shape[1], len(scene.cloud.points))
            self.assert_close(np.fromfile(file, '<f4').reshape(-1, 5)[:, 4], scene.cloud.rings, 0)
            expected = {each.instance for each in scene.objects} & set(scene.cloud.instances)
            self.assertEqual(len(boxes), len(expected))
            for box in boxes:
                annotation = database.get('sample_annotation', box.token)
                own = scene.cloud.instances == int(annotation['instance_token'][-14:], 16) + 1
                box.wlh += 2e-4
                inside = points_in_box(box, cloud.points[:3])
                self.assertTrue(np.all(inside[own]))
                self.assertEqual(annotation['num_lidar_pts'], np.count_nonzero(own))

    def test_lidarseg_has_the_category_of_each_point(self):
        for scene, database, token in self.lidar():
            record = database.get('lidarseg', token)
            found = load_bin_file(str(pathlib.Path(database.dataroot) / record['filename']))
            of_object = {each.instance: each.class_name for each in scene.objects}
            names = [database.lidarseg_idx2name_mapping[each] for each in found.tolist()]
            self.assertEqual(names, [of_object.get(each, 'noise') for each in scene.cloud.instances])

    def test_lidars_points_fall_on_the_pixels_of_their_objects(self):
        for scene, database, token in self.lidar():
            sample = database.get('sample', database.get('sample_data', token)['sample_token'])
            points, _, _ = database.explorer.map_pointcloud_to_image(token, sample['data']['CAM_FRONT'],
                                                                     min_dist=0.1, render_intensity=True)
            u, v = np.round(points[:2]).astype(int)
            near = [scene.instances[b - 2:b + 3, a - 2:a + 3].any() for a, b in zip(u, v)
                    if 3 < a < scene.width - 3 and 3 < b < scene.height - 3]
            self.assertGreater(np.mean(near), 0.8)

    def sweeps(self):
        """The database of a scanner that moves through a tunnel, with a sweep between samples."""
        (_, folder), = self.datasets('nuscenes_sweeps', ['moving_lidar'])
        return NuScenes('v1.0-trainval', str(folder), verbose=False,
                        colormap={name: (9, 9, 9) for name in ('noise', 'rover', 'tunnel')})

    def test_sweeps_between_samples_show_the_same_walls(self):
        database = self.sweeps()
        self.assertEqual(len(database.sample), 5)
        self.assertEqual(len(database.sample_data), 2 * 9)  # the first sweep begins before the recording
        sample = database.sample[-1]
        cloud, lags = LidarPointCloud.from_file_multisweep(
            database, sample, 'LIDAR_TOP', 'LIDAR_TOP', nsweeps=5, min_distance=0.0)
        self.assert_close(np.unique(lags.round(6)), [0.0, 0.25, 0.5, 0.75, 1.0], 1e-9)
        data = database.get('sample_data', sample['data']['LIDAR_TOP'])
        for table, token in (('calibrated_sensor', 'calibrated_sensor_token'), ('ego_pose', 'ego_pose_token')):
            pose = database.get(table, data[token])
            cloud.rotate(Quaternion(pose['rotation']).rotation_matrix)
            cloud.translate(np.array(pose['translation']))
        walls = np.abs(np.abs(cloud.points[:2]) - 0.95).min(axis=0)  # those of the tunnel, from inside
        self.assertGreater(walls.size, 5 * 1000)
        self.assertLess(walls.max(), 0.01)

    def test_velocities_are_those_between_samples(self):
        database = self.sweeps()
        found = [database.box_velocity(each['token']) for each in database.sample_annotation
                 if each['category_name'] == 'rover']
        self.assertEqual(len(found), 5)
        for velocity in found:
            self.assert_close(velocity, [0.0, 0.0, 0.8], 0.05)

    def test_two_dimensional_boxes_are_those_of_the_visible_pixels(self):
        for scene, database, record in self.loaded():
            boxes = [each['bbox_corners'] for each in database.image_annotations
                     if each['sample_data_token'] == record['token']]
            expected = [[left, top, right + 1, bottom + 1] for left, top, right, bottom
                        in (each.visible_pixel_box for each in scene.labelled)]
            self.assert_close(np.reshape(boxes, (-1, 4)), np.reshape(expected, (-1, 4)), 1e-6)


if __name__ == '__main__':
    unittest.main()
