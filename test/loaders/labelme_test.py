"""LabelMe, its polygons filled as labelme's utils.shape_to_mask does."""
import json
import unittest

import numpy as np
import PIL.Image
import PIL.ImageDraw

from loader_case import LoaderCase, read_picture


def shape_to_mask(size, points):
    mask = PIL.Image.new('L', size, 0)
    draw = PIL.ImageDraw.Draw(mask)
    draw.polygon(xy=[tuple(point) for point in points], outline=1, fill=1)
    return np.array(mask, dtype=bool)


class LabelMeTest(LoaderCase):
    def scenes(self):
        for truth, folder in self.datasets('labelme'):
            for scene in truth.scenes:
                file = folder / scene.split_or_train / f'{scene.name}.json'
                yield scene, file, json.loads(file.read_text(encoding='utf-8'))

    def test_images_stand_beside_their_files(self):
        for scene, file, content in self.scenes():
            self.assert_same_pixels(read_picture(file.parent / content['imagePath']), scene.image)
            self.assertEqual((content['imageWidth'], content['imageHeight']),
                             (scene.width, scene.height))

    def test_polygons_are_the_visible_masks(self):
        for scene, _, content in self.scenes():
            self.assertEqual(len(content['shapes']), len(scene.labelled))
            for each, shape in zip(scene.labelled, content['shapes']):
                self.assertEqual(shape['label'], each.class_name)
                self.assertEqual(shape['group_id'], each.instance)
                mask = shape_to_mask((scene.width, scene.height), shape['points'])
                self.assert_mask_of_one_ring(mask, each.visible, f'{scene.name} {each.name}')


if __name__ == '__main__':
    unittest.main()
