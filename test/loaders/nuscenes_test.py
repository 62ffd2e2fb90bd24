"""nuScenes by its devkit: tables, and boxes in images."""
import unittest

import numpy as np
from nuscenes.nuscenes import NuScenes
from nuscenes.utils.geometry_utils import BoxVisibility, view_points
from nuscenes.utils.splits import create_splits_scenes

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

    def test_two_dimensional_boxes_are_those_of_the_visible_pixels(self):
        for scene, database, record in self.loaded():
            boxes = [each['bbox_corners'] for each in database.image_annotations
                     if each['sample_data_token'] == record['token']]
            expected = [[left, top, right + 1, bottom + 1] for left, top, right, bottom
                        in (each.visible_pixel_box for each in scene.labelled)]
            self.assert_close(np.reshape(boxes, (-1, 4)), np.reshape(expected, (-1, 4)), 1e-6)


if __name__ == '__main__':
    unittest.main()
