"""What FiftyOne's importers read from the formats that it knows."""
import functools
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from loader_case import LoaderCase, root

TIMEOUT = 120  # [s]


@functools.lru_cache(maxsize=None)
def read(name):
    """The output of fiftyone_reader.py for a dataset. FiftyOne starts its database at its import."""
    reader = pathlib.Path(__file__).with_name('fiftyone_reader.py')
    with tempfile.TemporaryDirectory() as scratch:
        environ = {**os.environ, 'HOME': scratch, 'FIFTYONE_DATABASE_DIR': f'{scratch}/database',
                   'FIFTYONE_DO_NOT_TRACK': 'true', 'FIFTYONE_DATABASE_VALIDATION': 'false'}
        ended = subprocess.run(
            [os.environ['SYNTHETIC_DATASET_FIFTYONE_PYTHON'], str(reader), str(root() / name)],
            env=environ, timeout=TIMEOUT, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            universal_newlines=True, check=False)
    if ended.returncode != 0:
        raise AssertionError(ended.stdout + ended.stderr)
    return json.loads(ended.stdout.splitlines()[-1])


class FiftyOneTest(LoaderCase):
    def assert_boxes(self, writer, tolerance, shift=(0, 0, 0, 0), of_name=None, spaces=True):
        """Compares the boxes of a format with the visible ones.

        @param tolerance: of an edge [px]
        @param shift: how the importer's convention differs from left, top, right, bottom edges
        @param of_name: the name of a scene's image
        @param spaces: whether the format's names may have spaces
        """
        for truth, _ in self.datasets(writer, ('hard',)):
            found = read('hard')[writer]
            self.assertEqual(len(found), len(truth.scenes))
            for scene in truth.scenes:
                labels = found[of_name(scene) if of_name else scene.name]
                names = [each.class_name if spaces else each.class_name.replace(' ', '_')
                         for each in scene.labelled]
                self.assertEqual([each[0] for each in labels], names, scene.name)
                for (_, box, _), each in zip(labels, scene.labelled):
                    left, top, right, bottom = each.visible_pixel_box
                    expected = [edge + more for edge, more
                                in zip((left, top, right + 1, bottom + 1), shift)]
                    edges = [box[0] * scene.width, box[1] * scene.height,
                             (box[0] + box[2]) * scene.width, (box[1] + box[3]) * scene.height]
                    self.assert_close(edges, expected, tolerance, scene.name)

    def test_coco(self):
        self.assert_boxes('coco', 1e-6)
        for truth, _ in self.datasets('coco', ('hard',)):
            for scene in truth.scenes:
                pixels = [each[2] for each in read('hard')['coco'][scene.name]]
                self.assertEqual(pixels, [each.visible_pixels for each in scene.labelled])

    def test_kitti(self):
        for truth, _ in self.datasets('kitti', ('hard',)):
            found = read('hard')['kitti']
            for scene in truth.scenes:  # KITTI also has regions that are not labelled
                name = f'{scene.instant:06}'
                found[name] = [each for each in found[name] if each[0] != 'DontCare']
        self.assert_boxes('kitti', 1e-4, of_name=lambda scene: f'{scene.instant:06}',
                          spaces=False)

    def test_pascal_voc(self):
        # The importer takes the numbers of pixels, which start at 1, for edges.
        self.assert_boxes('pascal_voc', 1e-6, (1, 1, 0, 0), lambda scene: scene.flat_name)

    def test_ultralytics(self):
        self.assert_boxes('ultralytics_detect', 1e-2, of_name=lambda scene: scene.flat_name)

    def test_darknets_lists(self):
        for truth, folder in self.datasets('yolo_numbers', ('hard',)):
            found = read('hard')['yolo_numbers']
            self.assertEqual(set(found), {scene.name for scene in truth.scenes})
            for scene in truth.scenes:
                lines = (folder / f'{scene.name}.txt').read_text().splitlines()
                names = [truth.class_names[int(line.split()[0])] for line in lines]
                self.assertEqual([each[0] for each in found[scene.name]], names)


if __name__ == '__main__':
    unittest.main()
