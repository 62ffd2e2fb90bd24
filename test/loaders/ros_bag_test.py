"""The ROS bag, read with rosbag and by the meaning of its messages."""
import unittest

import numpy as np
import rosbag

from loader_case import LoaderCase

TYPES = {'bgr8': (np.uint8, 3), 'mono16': (np.uint16, 1), '32FC1': (np.float32, 1)}


def pixels_of(message):
    kind, channels = TYPES[message.encoding]
    shape = (message.height, message.width, channels)
    pixels = np.frombuffer(message.data, kind).reshape(shape)
    return pixels if channels > 1 else pixels[..., 0]


def matrix_of(p, q):
    x, y, z, w = q.x, q.y, q.z, q.w
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), p.x],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), p.y],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), p.z],
                     [0, 0, 0, 1]])


class RosBagTest(LoaderCase):
    def loaded(self):
        """Yields each scene with its messages by topic, without the camera's name."""
        for truth, folder in self.datasets('ros_bag'):
            messages = {}
            with rosbag.Bag(str(folder / 'dataset.bag')) as bag:
                for topic, message, time in bag.read_messages():
                    messages.setdefault((topic, time.to_nsec()), []).append(message)
            count = len(messages)
            for scene in truth.scenes:
                start = f'/{scene.camera_name}/'
                own = {topic[len(start):]: content[0] for (topic, stamp), content in
                       messages.items() if topic.startswith(start) and stamp == scene.stamp_ns}
                count -= len(own)
                own['/tf'] = [transform for message in messages['/tf', scene.stamp_ns]
                              for transform in message.transforms]
                yield scene, own
            instants = {scene.stamp_ns for scene in truth.scenes}
            self.assertEqual(count, len(instants))  # only /tf is left

    def test_images_are_the_scenes(self):
        for scene, messages in self.loaded():
            self.assert_same_pixels(pixels_of(messages['image_raw']), scene.image, scene.name)
            self.assert_same_pixels(pixels_of(messages['instances']), scene.instances, scene.name)

    def test_depth_is_that_of_the_scene_bit_by_bit(self):
        for scene, messages in self.loaded():
            expected = scene.depth.copy()
            expected[expected == 0] = np.nan
            name = 'image_raw' if any(scene.camera['D']) else 'image_rect_raw'
            found = pixels_of(messages[f'depth/{name}'])
            self.assert_same_pixels(found.view(np.uint32)[~np.isnan(found)],
                                    expected.view(np.uint32)[~np.isnan(expected)], scene.name)
            self.assert_same_pixels(np.isnan(found), np.isnan(expected), scene.name)

    def test_headers_have_the_scenes_stamp_and_frame(self):
        for scene, messages in self.loaded():
            headers = [message.header for topic, message in messages.items()
                       if topic not in ('/tf', 'objects')]
            self.assertEqual({header.stamp.to_nsec() for header in headers}, {scene.stamp_ns})
            self.assertEqual(len({header.frame_id for header in headers}), 1)

    def test_camera_info_is_the_camera(self):
        for scene, messages in self.loaded():
            for topic in ('camera_info', 'depth/camera_info'):
                info = messages[topic]
                self.assertEqual((info.width, info.height), (scene.width, scene.height))
                self.assert_close(info.K, scene.K.ravel(), 0)
                self.assertEqual(info.distortion_model, 'plumb_bob')
                self.assert_close(info.D, scene.camera['D'][:5], 0)
                self.assert_close(np.reshape(info.P, (3, 4))[:, :3], scene.K, 0)

    def test_transforms_are_the_poses_of_objects_and_camera(self):
        for scene, messages in self.loaded():
            poses = {each.child_frame_id: matrix_of(each.transform.translation,
                                                    each.transform.rotation)
                     for each in messages['/tf']}
            camera = messages['image_raw'].header.frame_id
            self.assert_close(poses[camera], scene.X_GC, 1e-9, scene.name)
            for each in scene.objects:
                self.assert_close(poses[f'synthetic/{each.name}'], each.X_GO, 1e-9, scene.name)

    def test_cubes_are_the_cuboids_of_the_labelled_objects(self):
        for scene, messages in self.loaded():
            cubes = [each for each in messages['objects'].markers if each.type == each.CUBE
                     and each.action == each.ADD]
            self.assertEqual([each.id for each in cubes],
                             [each.instance for each in scene.labelled])
            for each, cube in zip(scene.labelled, cubes):
                low, high = np.array(each.cuboid_O)
                centre = each.X_GO @ [*(low + high) / 2, 1]
                pose = matrix_of(cube.pose.position, cube.pose.orientation)
                self.assert_close(pose[:, 3], centre, 1e-9, scene.name)
                self.assert_close(pose[:3, :3], each.X_GO[:3, :3], 1e-9, scene.name)
                self.assert_close([cube.scale.x, cube.scale.y, cube.scale.z], high - low, 1e-12)


if __name__ == '__main__':
    unittest.main()
