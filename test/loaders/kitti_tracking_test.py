"""KITTI's tracking benchmark, read like its devkit's loadData (evaluate_tracking.py), and by TrackEval."""
import shutil
import unittest

import numpy as np
from trackeval import Evaluator
from trackeval.datasets import Kitti2DBox
from trackeval.metrics import HOTA
from trackeval.utils import TrackEvalException

from loader_case import LoaderCase, read_picture


class KittiTrackingTest(LoaderCase):
    def sequences(self):
        """Yields the scenes of each sequence of the devkit's map, with its lines and its number."""
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

    def evaluated(self, folder, to_types):
        """TrackEval's HOTA of the labels, with themselves as a tracker's result."""
        scratch = self.scratch_folder()
        gt, tracker = scratch / 'gt', scratch / 'trackers' / 'truth' / 'data'
        shutil.copytree(folder / 'training' / 'label_02', gt / 'label_02')
        for file in (gt / 'label_02').iterdir():
            rows = [line.split() for line in file.read_text(encoding='utf-8').splitlines()]
            for row in rows:
                row[2] = to_types(row[2])
            file.write_text(''.join(' '.join(row) + '\n' for row in rows), encoding='utf-8')
        lines = (folder / 'evaluate_tracking.seqmap.train').read_text(encoding='utf-8')
        (gt / 'evaluate_tracking.seqmap.training').write_text(lines, encoding='utf-8')
        tracker.mkdir(parents=True)
        for file in (gt / 'label_02').iterdir():
            text = ''.join(f'{line} 1.0\n' for line in file.read_text(encoding='utf-8').splitlines()
                           if ' DontCare ' not in line)
            (tracker / file.name).write_text(text, encoding='utf-8')
        quiet = {'PRINT_CONFIG': False}
        evaluator = Evaluator({**quiet, 'PRINT_RESULTS': False, 'OUTPUT_SUMMARY': False, 'TIME_PROGRESS': False,
                               'OUTPUT_DETAILED': False, 'PLOT_CURVES': False, 'BREAK_ON_ERROR': True,
                               'RETURN_ON_ERROR': False, 'LOG_ON_ERROR': None})
        dataset = Kitti2DBox({**quiet, 'GT_FOLDER': str(gt), 'TRACKERS_FOLDER': str(scratch / 'trackers'),
                              'CLASSES_TO_EVAL': ['car']})
        results, _ = evaluator.evaluate([dataset], [HOTA(quiet)])
        return results['Kitti2DBox']['truth']['COMBINED_SEQ']['car']['HOTA']['HOTA']

    def test_trackeval_refuses_the_classes_own_names_of_which_a_run_warns(self):
        for _, folder in self.datasets('kitti_tracking', ('many',)):
            with self.assertRaises(TrackEvalException):
                self.evaluated(folder, lambda name: name)

    def test_trackeval_takes_types_that_it_knows(self):
        """What `class_names: {rover: Car, ...}` writes: the truth is perfect."""
        for _, folder in self.datasets('kitti_tracking', ('many',)):
            hota = self.evaluated(folder, lambda name: name if name == 'DontCare' else 'Car')
            self.assertAlmostEqual(float(np.min(hota)), 1.0, delta=1e-6)


if __name__ == '__main__':
    unittest.main()
