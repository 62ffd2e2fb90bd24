"""COCO, Ultralytics' YOLO and Pascal VOC by supervision.DetectionDataset."""
import pathlib
import unittest

import cv2
import numpy as np
import supervision as sv

from loader_case import LoaderCase


class SupervisionTest(LoaderCase):
    def assert_boxes(self, dataset, scenes, tolerance, of_name, shift=(0, 0, 0, 0)):
        """Compares a dataset's boxes with the visible ones.

        @param of_name: the name of a scene's image
        @param shift: how the loader's convention differs from left, top, right, bottom edges
        """
        found = {pathlib.Path(path).stem: detections for path, _, detections in dataset}
        self.assertEqual(len(found), len(scenes))
        for scene in scenes:
            detections = found[of_name(scene)]
            expected = []
            for each in scene.labelled:
                left, top, right, bottom = each.visible_pixel_box
                expected.append(np.add([left, top, right + 1, bottom + 1], shift))
            self.assert_close(detections.xyxy, np.reshape(expected, (-1, 4)), tolerance, scene.name)
            names = [dataset.classes[number] for number in detections.class_id]
            self.assertEqual(names, [each.class_name for each in scene.labelled])

    def test_coco(self):
        for truth, folder in self.datasets('coco', ('hard', 'many')):
            dataset = sv.DetectionDataset.from_coco(
                str(folder / 'images'), str(folder / 'annotations/instances_train.json'))
            self.assert_boxes(dataset, truth.scenes, 1e-3, lambda scene: scene.name)

    def test_ultralytics(self):
        for truth, folder in self.datasets('ultralytics_detect', ('hard', 'many')):
            dataset = sv.DetectionDataset.from_yolo(str(folder / 'images/train'),
                                                    str(folder / 'labels/train'),
                                                    str(folder / 'data.yaml'))
            self.assert_boxes(dataset, truth.scenes, 1e-3, lambda scene: scene.flat_name)

    def test_ultralytics_masks(self):
        """Those of one part, as parts are joined by lines, and of so many pixels that single ones do not count."""
        found = 0
        for truth, folder in self.datasets('ultralytics_segment', ('hard', 'many')):
            dataset = sv.DetectionDataset.from_yolo(str(folder / 'images/train'), str(folder / 'labels/train'),
                                                    str(folder / 'data.yaml'), force_masks=True)
            masks = {pathlib.Path(path).stem: detections.mask for path, _, detections in dataset}
            for scene in truth.scenes:
                found_masks = masks[scene.flat_name]
                if found_masks is None:
                    self.assertEqual(scene.labelled, [], scene.name)
                    continue
                for each, mask in zip(scene.labelled, found_masks):
                    parts, _ = cv2.connectedComponents(each.visible.astype(np.uint8))
                    if parts != 2 or np.count_nonzero(each.visible) < 300:
                        continue
                    both = np.count_nonzero(mask & each.visible)
                    share = both / np.count_nonzero(mask | each.visible)
                    self.assertGreaterEqual(share, 0.99, f'{scene.name} {each.name}')
                    found += 1
        self.assertGreater(found, 5)

    def test_ultralytics_by_the_name_that_fiftyone_looks_for(self):
        for truth, folder in self.datasets('ultralytics_detect', ('hard',)):
            dataset = sv.DetectionDataset.from_yolo(str(folder / 'images/train'),
                                                    str(folder / 'labels/train'),
                                                    str(folder / 'dataset.yaml'))
            self.assertEqual(len(dataset), len(truth.scenes))
            names = (folder / 'classes.txt').read_text(encoding='utf-8').splitlines()
            self.assertEqual(dataset.classes, names)

    def test_pascal_voc(self):
        for truth, folder in self.datasets('pascal_voc', ('hard',)):
            dataset = sv.DetectionDataset.from_pascal_voc(str(folder / 'JPEGImages'),
                                                          str(folder / 'Annotations'))
            # It subtracts 1 from all four, which makes the last pixel's number its left edge.
            self.assert_boxes(dataset, truth.scenes, 1e-3, lambda scene: scene.flat_name,
                              (0, 0, -1, -1))


if __name__ == '__main__':
    unittest.main()
