"""MOTChallenge, read by datumaro's mot_seq."""
import configparser
import unittest

from datumaro.plugins.data_formats.mot import MotSeqBase

from loader_case import LoaderCase, read_picture


class MotTest(LoaderCase):
    def sequences(self):
        """Yields the scenes of each sequence with its folder."""
        for truth, folder in self.datasets('mot'):
            for split in truth.splits:
                for camera in sorted({scene.camera_name for scene in truth.scenes}):
                    scenes = [scene for scene in truth.of_split(split)
                              if scene.camera_name == camera]
                    yield scenes, folder / split / camera

    def items(self):
        """Yields each scene with what datumaro reads for its frame."""
        for scenes, folder in self.sequences():
            items = list(MotSeqBase(str(folder / 'gt/gt.txt')))
            self.assertEqual(len(items), len(scenes))
            yield from zip(scenes, items)

    def test_frames_are_the_scenes_in_their_order(self):
        for scenes, folder in self.sequences():
            info = configparser.ConfigParser()
            info.read(folder / 'seqinfo.ini')
            self.assertEqual(int(info['Sequence']['seqLength']), len(scenes))
            self.assertEqual(int(info['Sequence']['imWidth']), scenes[0].width)
            self.assertEqual(sorted(file.name for file in (folder / 'img1').iterdir()),
                             [f'{frame:06}.png' for frame in range(1, len(scenes) + 1)])
            for frame, scene in enumerate(scenes, 1):
                self.assert_same_pixels(read_picture(folder / f'img1/{frame:06}.png'), scene.image)

    def test_boxes_tracks_and_visibility_are_those_of_the_objects(self):
        for scene, item in self.items():
            self.assertEqual(len(item.annotations), len(scene.labelled), scene.name)
            for each, found in zip(scene.labelled, item.annotations):
                left, top, right, bottom = each.visible_pixel_box
                self.assert_close(found.get_bbox(),  # pixels count from 1
                                  [left + 1, top + 1, right + 1 - left, bottom + 1 - top], 1e-3)
                self.assertEqual(found.attributes['track_id'], each.instance)
                self.assertFalse(found.attributes['ignored'])
                self.assertAlmostEqual(found.attributes['visibility'], each.visibility, delta=6e-4)

    def test_classes_have_their_names(self):
        for truth, folder in self.datasets('mot', ('hard',)):
            base = MotSeqBase(str(folder / f'train/{truth.cameras[0]["name"]}/gt/gt.txt'))
            labels = next(iter(base.categories().values()))
            for scene, item in zip(truth.scenes, base):
                self.assertEqual([labels[found.label].name for found in item.annotations],
                                 [each.class_name for each in scene.labelled])


if __name__ == '__main__':
    unittest.main()
