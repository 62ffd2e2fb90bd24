"""Bounding shapes: plain numbers, for which there is no loader."""
import unittest

import numpy as np

from loader_case import LoaderCase, read_picture


class BoundingShapeTest(LoaderCase):
    def test_lines_are_the_vertices_in_the_output_frame(self):
        for truth, folder in self.datasets('bounding_shape'):
            for scene in truth.scenes:
                lines = (folder / f'{scene.name}.txt').read_text(encoding='utf-8').splitlines()
                self.assertEqual(len(lines), len(scene.objects))
                for line, each in zip(lines, scene.objects):
                    identity, *numbers = line.split()
                    self.assertEqual(identity, each.id)
                    vertices = np.array(each.bounding_shape_O) @ each.X_GO[:3, :3].T
                    self.assert_close(np.array(numbers, float).reshape(-1, 3),
                                      vertices + each.X_GO[:3, 3], 5.1e-6, scene.name)

    def test_images_are_the_scenes(self):
        for truth, folder in self.datasets('bounding_shape'):
            for scene in truth.scenes:
                self.assert_same_pixels(read_picture(folder / f'{scene.name}.png'), scene.image)


if __name__ == '__main__':
    unittest.main()
