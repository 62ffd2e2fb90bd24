"""Formats read by datumaro's importers that have no other loader: Darknet's and Cityscapes'."""
import unittest

import numpy as np
from datumaro.components.dataset import Dataset
from datumaro.components.annotation import AnnotationType

from loader_case import LoaderCase


class DatumaroTest(LoaderCase):
    def relative(self, folder):
        """A copy whose lists name files relative to it: datumaro reads only these, Darknet both."""
        copy = self.scratch_copy(folder)
        for file in [copy / 'obj.data', *copy.glob('*.txt')]:
            text = file.read_text(encoding='utf-8')
            file.write_text(text.replace(f'{folder.resolve()}/', '').replace(f'{folder}/', ''),
                            encoding='utf-8')
        return copy

    def test_darknets_files_name_one_another(self):
        for truth, folder in self.datasets('yolo_numbers', ('hard', 'many')):
            dataset = Dataset.import_from(str(self.relative(folder)), 'yolo')
            items = {item.id.split('/')[-1]: item for item in dataset}
            names = [each.name for each in dataset.categories()[AnnotationType.label]]
            self.assertLessEqual(set(truth.class_names.values()), set(names))
            self.assertEqual(set(items), {scene.name for scene in truth.scenes})
            for scene in truth.scenes:
                lines = (folder / f'{scene.name}.txt').read_text().splitlines()
                self.assertEqual([each.label for each in items[scene.name].annotations],
                                 [int(line.split()[0]) for line in lines])

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
