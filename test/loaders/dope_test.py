"""DOPE, as CleanVisiiDopeLoader of its common/utils.py reads it."""
import json
import unittest

import numpy as np

from loader_case import LoaderCase, read_picture

# The order of add_cuboid in nvisii_data_gen/utils.py, in the truth's numbering of corners.
CORNERS = [0b101, 0b001, 0b011, 0b111, 0b100, 0b000, 0b010, 0b110]


def rotation_of(x, y, z, w):
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


class DopeTest(LoaderCase):
    def loaded(self):
        """Yields each scene with its file's content and its image's name."""
        for truth, folder in self.datasets('dope'):
            for scene in truth.scenes:
                place = folder / scene.split if scene.split else folder
                if len(truth.cameras) > 1:
                    place = place / scene.camera_name
                file = place / f'{scene.instant:08}.json'
                yield scene, json.loads(file.read_text(encoding='utf-8')), file.with_suffix('.png')

    def objects(self):
        for scene, content, _ in self.loaded():
            labelled = [each for each in scene.labelled
                        if each.cuboid_corners_C[:, 2].min() >= scene.camera['near']]
            self.assertEqual(len(content['objects']), len(labelled), scene.name)
            yield from ((scene, *pair) for pair in zip(labelled, content['objects']))

    def test_every_image_has_its_file(self):
        for truth, folder in self.datasets('dope'):
            images = sorted(folder.rglob('*.png'))
            self.assertEqual(len(images), len(truth.scenes))
            self.assertTrue(all(image.with_suffix('.json').exists() for image in images))

    def test_images_and_cameras_are_the_scenes(self):
        for scene, content, image in self.loaded():
            self.assert_same_pixels(read_picture(image), scene.image, scene.name)
            camera = content['camera_data']
            self.assertEqual((camera['width'], camera['height']), (scene.width, scene.height))
            self.assert_close([camera['intrinsics'][key] for key in ('fx', 'fy', 'cx', 'cy')],
                              scene.K[[0, 1, 0, 1], [0, 1, 2, 2]], 1e-12)
            self.assert_close(np.transpose(camera['camera_view_matrix']),
                              np.linalg.inv(scene.X_GC), 1e-9)

    def test_poses_are_the_objects(self):
        for scene, each, found in self.objects():
            self.assertEqual((found['class'], found['name']), (each.class_name, each.name))
            self.assert_close(found['location'], each.X_CO[:3, 3], 1e-9, scene.name)
            self.assert_close(rotation_of(*found['quaternion_xyzw']), each.X_CO[:3, :3], 1e-9,
                              scene.name)

    def test_cuboids_are_projected_in_dopes_order_with_the_centre_last(self):
        for scene, each, found in self.objects():
            corners = each.cuboid_corners_C[CORNERS]
            points = np.concatenate([corners, corners.mean(0, keepdims=True)])
            self.assert_close(found['projected_cuboid'], scene.project(points), 1e-6, scene.name)

    def test_visibility_and_counts_are_the_scenes(self):
        for scene, each, found in self.objects():
            self.assertAlmostEqual(found['visibility'], each.visibility, delta=1e-12)
            self.assertGreater(found['visibility'], 0)  # otherwise the reader drops its points
            self.assertEqual((found['px_count_all'], found['px_count_visib']),
                             (each.silhouette_pixels, each.visible_pixels))
            left, top, right, bottom = each.visible_pixel_box
            self.assertEqual(found['bounding_box_minx_maxx_miny_maxy'],
                             [left, right, top, bottom])

    def test_settings_name_every_class(self):
        for truth, folder in self.datasets('dope'):
            for file in folder.rglob('_object_settings.json'):
                settings = json.loads(file.read_text(encoding='utf-8'))
                self.assertEqual(sorted(settings['exported_object_classes']),
                                 sorted({each['class_name'] for each in truth.objects}))


if __name__ == '__main__':
    unittest.main()
