"""What datumaro's importers read of formats that have no other loader: Darknet's, Cityscapes'."""
import unittest

import numpy as np
from datumaro.components.dataset import Dataset
from datumaro.components.annotation import AnnotationType

from loader_case import LoaderCase


class DatumaroTest(LoaderCase):
    def test_darknets_files_name_one_another(self):
        for truth, folder in self.datasets('yolo_numbers', ('hard', 'cameras')):
            dataset = Dataset.import_from(str(folder), 'yolo')
            items = {item.id.split('/')[-1]: item for item in dataset}
            names = [each.name for each in dataset.categories()[AnnotationType.label]]
            self.assertLessEqual(set(truth.class_names.values()), set(names))
            count = 0
            for scene in truth.of_split(truth.splits[0]):
                boxes = [each for each in scene.objects if each.in_view and not each.dropped]
                item = items.get(scene.name.split('/')[-1])
                if item is None:
                    continue
                count += len(item.annotations)
                self.assertLessEqual(len(item.annotations), len(boxes))
            self.assertGreater(count, 0)

    def test_cityscapes_train_ids_are_the_classes(self):
        for truth, folder in self.datasets('cityscapes', ('hard',)):
            dataset = Dataset.import_from(str(folder), 'cityscapes')
            names = [each.name for each in dataset.categories()[AnnotationType.label]]
            first = truth.classes[0]['name'].replace(' ', '_')
            self.assertEqual(names.index(first), 0)  # datumaro takes 0 for the background
            self.assertEqual(len(list(dataset)), len(truth.scenes))
            for item in dataset:
                number = int(item.id.split('_')[-2])
                scene = next(each for each in truth.scenes if each.instant == number)
                expected = {each.class_name for each in scene.labelled} - {truth.classes[0]['name']}
                found = {each.label for each in item.annotations if np.any(each.image)}
                self.assertEqual(len(found), len(expected), scene.name)


if __name__ == '__main__':
    unittest.main()
