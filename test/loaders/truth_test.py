"""The datasets contain the cases that they promise; else the other tests would prove little."""
import pathlib
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np
import yaml

from loader_case import LoaderCase, truth_of

HERE = pathlib.Path(__file__).resolve().parent


class TruthTest(LoaderCase):
    def objects(self, dataset):
        return [each for scene in truth_of(dataset).scenes for each in scene.objects]

    def test_every_format_of_the_package_is_made(self):
        made = {each['type'] for each in yaml.safe_load((HERE / 'writers.yaml').read_text())}
        plugins = ElementTree.parse(HERE.parents[1] / 'plugins.xml').iter('class')
        self.assertEqual(made - {'test/Truth'}, {each.get('name') for each in plugins})

    def test_points_lie_on_the_objects_that_they_are_labelled_as(self):
        counts = {1: 0, 2: 0, 3: 0}
        for scene in truth_of('lidar').scenes:
            cloud = scene.cloud
            p_G = cloud.points @ cloud.X_GS[:3, :3].T + cloud.X_GS[:3, 3]
            for each in scene.objects:
                p_O = (p_G - each.X_GO[:3, 3]) @ each.X_GO[:3, :3]
                low, high = np.array(each.cuboid_O)
                # The distance outside of the cuboid; negative inside.
                outside = np.maximum(low - p_O, p_O - high).max(axis=1)
                own = cloud.instances == each.instance
                self.assertLess(outside[own].max(), 1e-4, each.name)
                if each.class_name == 'rover':  # its shape is the cuboid
                    self.assert_close(outside[own], np.zeros(own.sum()), 1e-4)
                    self.assertGreater(outside[~own].min(), 1e-3)
                counts[each.instance] += own.sum()
        self.assertGreater(min(counts.values()), 100)
        self.assertFalse(any(each.labelled for scene in truth_of('lidar').scenes
                             for each in scene.objects if each.name == 'bravo'))

    def test_visible_masks_are_the_parts_of_the_instance_map(self):
        for truth, _ in self.datasets('truth'):
            for scene in truth.scenes:
                parts = np.zeros_like(scene.instances)
                for each in scene.objects:
                    parts[each.visible] = each.instance
                    self.assertEqual(np.count_nonzero(each.visible), each.visible_pixels)
                    self.assertFalse(np.any(each.visible & ~each.silhouette), scene.name)
                self.assert_same_pixels(parts, scene.instances, scene.name)

    def test_objects_leave_the_image_on_each_side(self):
        boxes = [each.silhouette_box for each in self.objects('hard')
                 if each.visible_pixels and 0 < each.truncation < 1]
        self.assertTrue(any(box[0] < -0.5 for box in boxes))
        self.assertTrue(any(box[1] < -0.5 for box in boxes))
        self.assertTrue(any(box[2] > 319.5 for box in boxes))
        self.assertTrue(any(box[3] > 239.5 for box in boxes))

    def test_an_object_is_wholly_hidden_in_the_image(self):
        self.assertTrue(any(each.silhouette_pixels_in_image > 100 and each.visible_pixels == 0
                            for each in self.objects('hard')))

    def test_an_object_is_one_pixel_large(self):
        self.assertTrue(any(each.visible_pixels == 1 for each in self.objects('hard')))

    def test_an_object_is_round_the_camera(self):
        self.assertTrue(any(each.visible_pixels > 40000 for each in self.objects('hard')))

    def test_keypoints_have_all_states(self):
        states = {keypoint['state'] for each in self.objects('hard') for keypoint in each.keypoints}
        self.assertEqual(states,
                         {'outside', 'hidden_by_another', 'hidden_by_itself', 'visible'})

    def test_there_are_objects_past_255(self):
        self.assertGreater(sum(each.labelled for each in truth_of('many').scenes[0].objects), 290)
        self.assertGreater(truth_of('many').scenes[0].instances.max(), 290)

    def test_nothing_is_in_view_of_the_empty_dataset(self):
        self.assertFalse(any(each.silhouette_pixels_in_image for each in self.objects('empty')))

    def test_every_split_has_scenes_of_both_cameras(self):
        truth = truth_of('cameras')
        for split in ('train', 'val', 'test'):
            self.assertEqual({scene.camera_name for scene in truth.of_split(split)},
                             {'front', 'rear'})


if __name__ == '__main__':
    unittest.main()
