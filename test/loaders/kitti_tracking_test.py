"""KITTI's tracking benchmark, read as its devkit's tracker does (evaluate_tracking.py, loadData)."""
import unittest

from loader_case import LoaderCase, read_picture


class KittiTrackingTest(LoaderCase):
    def sequences(self):
        """Yields the scenes of each sequence with its lines and its number, by the devkit's map."""
        for truth, folder in self.datasets('kitti_tracking'):
            for split in truth.splits:
                lines = (folder / f'evaluate_tracking.seqmap.{split}').read_text().splitlines()
                cameras = [camera['name'] for camera in truth.cameras]
                self.assertEqual(len(lines), len(cameras))
                for line, camera in zip(lines, cameras):
                    name, _, first, count = line.split()
                    scenes = [scene for scene in truth.of_split(split)
                              if scene.camera_name == camera]
                    self.assertEqual((int(first), int(count)), (0, len(scenes)))
                    yield scenes, folder / 'training', name

    def test_frames_are_the_scenes_in_their_order(self):
        for scenes, folder, name in self.sequences():
            for frame, scene in enumerate(scenes):
                self.assert_same_pixels(read_picture(folder / f'image_02/{name}/{frame:06}.png'),
                                        scene.image)

    def test_tracks_are_those_of_the_objects(self):
        for scenes, folder, name in self.sequences():
            rows = [line.split() for line in
                    (folder / f'label_02/{name}.txt').read_text(encoding='utf-8').splitlines()]
            self.assertTrue(all(len(row) == 17 for row in rows))
            for frame, scene in enumerate(scenes):
                found = [row for row in rows if int(row[0]) == frame]
                self.assertEqual(len(found), len(scene.labelled))
                for each, row in zip(scene.labelled, found):
                    self.assertEqual(int(row[1]), each.instance - 1)
                    self.assertEqual(row[2], each.class_name.replace(' ', '_'))
                    self.assertIn(int(row[3]), (0, 1, 2))
                    left, top, right, bottom = each.visible_pixel_box
                    self.assert_close([float(number) for number in row[6:10]],
                                      [left, top, right + 1, bottom + 1], 1e-5)


if __name__ == '__main__':
    unittest.main()
