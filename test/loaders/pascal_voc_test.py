"""Pascal VOC, by torchvision.datasets.VOCDetection and VOCSegmentation."""
import unittest

import numpy as np
from PIL import Image
from torchvision.datasets import VOCDetection, VOCSegmentation

from loader_case import LoaderCase

# torchvision knows the list `test` only for 2007.
YEARS = {'train': '2012', 'val': '2012', 'test': '2007'}


class PascalVocTest(LoaderCase):
    def loaded(self, loader):
        """Yields each scene with the loader's image and target, and the writer's folder."""
        for truth, folder in self.datasets('pascal_voc'):
            for split in truth.splits:
                place = self.scratch_folder()
                (place / 'VOCdevkit').mkdir()
                (place / 'VOCdevkit' / f'VOC{YEARS[split]}').symlink_to(folder)
                dataset = loader(str(place), year=YEARS[split], image_set=split)
                scenes = truth.of_split(split)
                self.assertEqual(len(dataset), len(scenes))
                for scene, (image, target) in zip(scenes, dataset):
                    yield scene, image, target, folder

    def annotations(self):
        for scene, _, target, _ in self.loaded(VOCDetection):
            yield scene, target['annotation']

    def test_images_are_the_scenes(self):
        for scene, image, _, _ in self.loaded(VOCDetection):
            difference = np.array(image)[..., ::-1].astype(float) - scene.image
            self.assertLess(np.abs(difference).mean(), 4, scene.name)  # JPEG

    def test_annotations_name_their_image_and_its_size(self):
        for scene, annotation in self.annotations():
            self.assertEqual(annotation['filename'], f'{scene.flat_name}.jpg')
            self.assertEqual(annotation['size'], {'width': str(scene.width),
                                                  'height': str(scene.height), 'depth': '3'})

    def test_objects_are_the_labelled_ones(self):
        for scene, annotation in self.annotations():
            self.assertEqual([each['name'] for each in annotation.get('object', [])],
                             [each.class_name for each in scene.labelled], scene.name)

    def test_boxes_are_those_of_the_visible_pixels_counted_from_1(self):
        for scene, annotation in self.annotations():
            for each, found in zip(scene.labelled, annotation.get('object', [])):
                box = [int(found['bndbox'][key]) for key in ('xmin', 'ymin', 'xmax', 'ymax')]
                self.assertEqual(box, [edge + 1 for edge in each.visible_pixel_box], scene.name)

    def test_flags_tell_what_is_cut_hidden_and_hardly_visible(self):
        for scene, annotation in self.annotations():
            for each, found in zip(scene.labelled, annotation.get('object', [])):
                hidden = 1 - each.visible_pixels / each.silhouette_pixels_in_image
                flags = [found['truncated'], found['occluded'], found['difficult']]
                self.assertEqual(flags, [str(int(flag)) for flag in (
                    each.truncation > 0.05, hidden > 0.05, each.visibility < 0.2)], scene.name)

    def test_segmentation_is_the_visible_classes(self):
        for scene, _, picture, folder in self.loaded(VOCSegmentation):
            names = [line.split(':')[0] for line in
                     (folder / 'labelmap.txt').read_text(encoding='utf-8').splitlines()
                     if not line.startswith('#')]
            self.assertEqual(picture.mode, 'P')
            found = np.array(picture)
            for each in scene.labelled:
                values = set(found[each.visible])
                self.assertEqual(len(values), 1)
                self.assertTrue(names[values.pop()].startswith(each.class_name.split(':')[0]))
            labelled = np.isin(scene.instances, [each.instance for each in scene.labelled])
            self.assert_same_pixels(found > 0, labelled, scene.name)

    def test_object_pictures_number_the_labelled_objects(self):
        for scene, _, _, folder in self.loaded(VOCSegmentation):
            found = np.array(Image.open(folder / f'SegmentationObject/{scene.flat_name}.png'))
            for number, each in enumerate(scene.labelled, 1):
                self.assertEqual(set(found[each.visible]), {min(number, 255)}, scene.name)

    def test_class_lists_tell_which_images_show_a_class(self):
        for truth, folder in self.datasets('pascal_voc'):
            for split in truth.splits:
                expected = {scene.flat_name: scene for scene in truth.of_split(split)}
                for file in (folder / 'ImageSets/Main').glob(f'rover_{split}.txt'):
                    for line in file.read_text().splitlines():
                        name, sign = line.split()
                        shown = any(each.class_name == 'rover'
                                    for each in expected.pop(name).labelled)
                        self.assertEqual(sign != '-1', shown, name)
                    self.assertEqual(expected, {})


if __name__ == '__main__':
    unittest.main()
