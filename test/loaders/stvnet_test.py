"""stvNet, read as its data.py does: folders listed, sorted, and zipped."""
import os
import unittest

import numpy as np

from loader_case import LoaderCase, read_picture


class StvNetTest(LoaderCase):
    def samples(self):
        """Yields scene, object, and the names of image, mask and label."""
        for truth, folder in self.datasets('stvnet'):
            for index, info in enumerate(truth.objects):
                place = folder / info['name']
                scenes = {scene.name: scene for scene in truth.scenes
                          if self.has_sample(scene.objects[index])}
                if not scenes:
                    self.assertFalse(place.exists())
                    continue
                lists = [self.names(place / kind) for kind in ('JPEGImages', 'mask', 'labels')]
                self.assertEqual(lists[0], sorted(scenes))
                self.assertEqual(lists, [lists[0]] * 3)
                for name in lists[0]:
                    yield scenes[name], scenes[name].objects[index], place

    @staticmethod
    def has_sample(each):
        return each.in_view and not each.dropped and all(
            keypoint['pixel'] for keypoint in each.keypoints)

    @staticmethod
    def names(folder):
        return sorted(os.path.splitext(os.path.relpath(os.path.join(place, file), folder))[0]
                      for place, _, files in os.walk(folder) for file in files)

    def test_images_are_the_scenes(self):
        for scene, _, place in self.samples():
            self.assert_same_pixels(read_picture(place / f'JPEGImages/{scene.name}.png'),
                                    scene.image, scene.name)

    def test_masks_are_255_on_the_whole_object(self):
        for scene, each, place in self.samples():
            mask = read_picture(place / f'mask/{scene.name}.png')
            self.assert_same_pixels(mask == 255, each.silhouette, f'{scene.name} {each.name}')
            self.assertLessEqual(set(np.unique(mask)), {0, 255})

    def test_labels_are_the_id_and_the_projected_keypoints(self):
        for scene, each, place in self.samples():
            words = (place / f'labels/{scene.name}.txt').read_text(encoding='utf-8').split()
            self.assertEqual(words[0], each.id)
            if not each.keypoints:
                self.assertEqual(len(words), 1)
                continue
            expected = scene.project(each.to_camera(each.keypoints_O))
            found = np.array(words[1:], float).reshape(-1, 2)
            self.assert_close(found, expected / (scene.width, scene.height), 5.1e-6, scene.name)


if __name__ == '__main__':
    unittest.main()
