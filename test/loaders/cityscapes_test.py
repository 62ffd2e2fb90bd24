"""Cityscapes, by the evaluation and preparation scripts of cityscapesscripts."""
import contextlib
import io
import json
import unittest
from collections import namedtuple

import cv2
import numpy as np
from cityscapesscripts.evaluation import evalInstanceLevelSemanticLabeling as instance_level
from cityscapesscripts.evaluation import evalPixelLevelSemanticLabeling as pixel_level
from cityscapesscripts.evaluation.instances2dict import instances2dict
from cityscapesscripts.helpers import labels as label_table
from cityscapesscripts.helpers.annotation import Annotation
from cityscapesscripts.helpers.csHelpers import getCsFileInfo
from cityscapesscripts.preparation.json2instanceImg import createInstanceImage

from loader_case import LoaderCase, read_picture


FULL = ('hard', 'lens', 'many', 'cameras')


def use_labels(file):
    """Replaces Cityscapes' classes by the dataset's own in all scripts."""
    names = label_table.Label._fields
    label = namedtuple('Label', names)
    entries = [label(**{**entry, 'color': tuple(entry['color'])})
               for entry in json.loads(file.read_text(encoding='utf-8'))]
    label_table.labels[:] = entries
    for table, key in ((label_table.name2label, 'name'), (label_table.id2label, 'id'),
                       (label_table.trainId2label, 'trainId')):
        table.clear()
        table.update({getattr(entry, key): entry for entry in reversed(entries)})
    label_table.category2labels.clear()
    for entry in entries:
        label_table.category2labels.setdefault(entry.category, []).append(entry)


def quiet():
    return contextlib.redirect_stdout(io.StringIO())


class CityscapesTest(LoaderCase):
    def loaded(self, kind):
        """Yields each scene with a file of its labels."""
        for truth, folder in self.datasets('cityscapes'):
            use_labels(folder / 'labels.json')
            for scene in truth.scenes:
                yield scene, self.file_of(folder, scene, kind)

    @staticmethod
    def file_of(folder, scene, kind):
        city = scene.camera_name
        return (folder / 'gtFine' / scene.split_or_train / city /
                f'{city}_{scene.instant:06}_000019_gtFine_{kind}')

    def test_file_names_are_read_as_cities_and_sequences(self):
        for scene, file in self.loaded('instanceIds.png'):
            info = getCsFileInfo(str(file))
            self.assertEqual((info.city, int(info.sequenceNb)), (scene.camera_name, scene.instant))

    def test_images_are_the_scenes(self):
        for scene, file in self.loaded('image'):
            image = str(file).replace('gtFine/', 'leftImg8bit/').replace('gtFine_image',
                                                                         'leftImg8bit.png')
            self.assert_same_pixels(read_picture(image), scene.image, scene.name)

    def test_label_pictures_are_the_visible_classes(self):
        for scene, file in self.loaded('labelIds.png'):
            expected = np.zeros_like(scene.instances, np.uint8)
            for each in scene.labelled:
                expected[each.visible] = label_table.name2label[each.class_name].id
            self.assert_same_pixels(read_picture(file), expected, scene.name)

    def test_instances_are_the_labelled_objects_with_their_pixels(self):
        for scene, file in self.loaded('instanceIds.png'):
            found = list(instances2dict([str(file)]).values())[0]
            for name, instances in found.items():
                if not label_table.name2label[name].hasInstances:
                    continue
                expected = [each.visible_pixels for each in scene.labelled
                            if each.class_name == name]
                instances = sorted(instances, key=lambda each: each['instID'])
                self.assertEqual([each['pixelCount'] for each in instances], expected, scene.name)

    def test_polygons_fill_the_visible_masks(self):
        for scene, file in self.loaded('polygons.json'):
            annotation = Annotation()
            annotation.fromJsonFile(str(file))
            self.assertEqual((annotation.imgWidth, annotation.imgHeight),
                             (scene.width, scene.height))
            masks = []
            for entry in annotation.objects:
                mask = np.zeros((scene.height, scene.width), np.uint8)
                cv2.fillPoly(mask, [np.array(entry.polygon, np.int32)], 1)
                masks.append((entry.label, mask > 0))
            self.assertEqual([label for label, _ in masks],
                             [each.class_name for each in scene.labelled])
            for each, (_, mask) in zip(scene.labelled, masks):
                self.assert_mask_of_one_ring(mask, each.visible, f'{scene.name} {each.name}')
            self.assertEqual(np.array(createInstanceImage(annotation, 'ids')).shape,
                             (scene.height, scene.width))

    def test_labels_score_fully_against_themselves(self):
        for truth, folder in self.datasets('cityscapes', FULL):
            use_labels(folder / 'labels.json')
            files = [str(self.file_of(folder, scene, 'labelIds.png')) for scene in truth.scenes]
            pixel_level.args.evalInstLevelScore = False
            pixel_level.args.JSONOutput = False
            pixel_level.args.quiet = True
            with quiet():
                scores = pixel_level.evaluateImgLists(files, files, pixel_level.args)
            shown = {each.class_name for scene in truth.scenes for each in scene.labelled}
            self.assertEqual({name for name, score in scores['classScores'].items()
                              if score == 1.0}, shown)

    def test_visible_masks_as_predictions_find_every_instance(self):
        for truth, folder in self.datasets('cityscapes', FULL):
            use_labels(folder / 'labels.json')
            place = self.scratch_folder()
            predictions = [self.predict(place, i, scene) for i, scene in enumerate(truth.scenes)]
            arguments = instance_level.args
            arguments.quiet = True
            arguments.JSONOutput = False
            arguments.predictionPath = str(place)
            arguments.gtInstancesFile = str(place / 'instances.json')
            arguments.minRegionSizes = np.array([1, 1, 1])
            with quiet():
                instance_level.setInstanceLabels(arguments)
                files = [str(self.file_of(folder, scene, 'instanceIds.png'))
                         for scene in truth.scenes]
                result = instance_level.evaluateImgLists(predictions, files, arguments)
            shown = {each.class_name for scene in truth.scenes for each in scene.labelled}
            for name in shown:
                self.assertEqual(result['averages']['classes'][name]['ap'], 1.0, name)

    @staticmethod
    def predict(place, number, scene):
        """Writes the truth's masks in the form in which the evaluation reads predictions."""
        lines = []
        for i, each in enumerate(scene.labelled):
            mask = f'{number}_{i}.png'
            cv2.imwrite(str(place / mask), each.visible.astype(np.uint8) * 255)
            lines.append(f'{mask} {label_table.name2label[each.class_name].id} 1.0\n')
        file = place / f'{number}.txt'
        file.write_text(''.join(lines))
        return str(file)

    def test_cameras_have_the_scenes_intrinsics(self):
        for scene, file in self.loaded('camera'):
            file = str(file).replace('gtFine/', 'camera/').replace('gtFine_camera', 'camera.json')
            with open(file, encoding='utf-8') as text:
                found = json.load(text)['intrinsic']
            self.assert_close([found['fx'], found['fy'], found['u0'], found['v0']],
                              scene.K[[0, 1, 0, 1], [0, 1, 2, 2]], 1e-9)


if __name__ == '__main__':
    unittest.main()
