#!/usr/bin/env python3
"""`draw_labels` for one scene, for all scenes, and as a video."""
import subprocess
import unittest

import numpy as np
from PIL import Image
import rosunit

from example_dataset import DatasetCase, SCENES, run


def size_and_pixels(file):
    with Image.open(file) as picture:
        return picture.size, np.array(picture.convert('RGB'), int)


class DrawLabels(DatasetCase):

    WRITERS = ('writers:\n  - {name: coco, type: synthetic_dataset/Coco}\n'
               '  - {name: yolo, type: synthetic_dataset/Yolo}\nyolo: {main_list: list.txt}\n')

    def draw(self, *arguments):
        code, text = run('draw_labels', *arguments)
        self.assertEqual(code, 0, text)
        return text

    def fail_to_draw(self, *arguments):
        code, text = run('draw_labels', *arguments)
        self.assertEqual(code, 1, text)
        return text

    def test_draws_all_scenes_as_it_draws_one(self):
        folder = self.scratch / 'all'
        self.assertEqual(self.draw('--all', self.folder, folder),
                         f'{SCENES} of {SCENES} scenes drawn\n')
        self.assertEqual(sorted(file.name for file in folder.iterdir()),
                         [f'{scene:08}.png' for scene in range(SCENES)])
        one = self.scratch / 'one.png'
        self.draw(self.folder, one, 3)
        self.assertEqual(one.read_bytes(), (folder / '00000003.png').read_bytes())

    def test_draws_one_format(self):
        folder = self.scratch / 'coco'
        self.draw('--all', self.folder, folder, 'coco')
        size, pixels = size_and_pixels(folder / '00000003.png')
        self.assertEqual(size, (640, 480))
        _, plain = size_and_pixels(self.folder / 'coco/images/00000003.png')
        changed = np.count_nonzero((pixels != plain).any(axis=2))
        self.assertGreater(changed, 1000)
        self.assertLess(changed, pixels.shape[0] * pixels.shape[1] / 2)

    def test_makes_a_film(self):
        film = self.scratch / 'run.mp4'
        self.draw('--video', film, '--rate', 5, self.folder, 'coco')
        found = subprocess.run(
            ['ffprobe', '-v', 'error', '-count_frames', '-show_entries',
             'stream=width,height,r_frame_rate,nb_read_frames', '-of', 'csv=p=0', str(film)],
            stdout=subprocess.PIPE, universal_newlines=True, check=True)
        self.assertEqual(found.stdout.strip(), f'640,480,5/1,{SCENES}')

    def test_touches_nothing_of_others(self):
        mine = self.scratch / 'mine'
        mine.mkdir()
        (mine / '00000000.png').write_text('precious')
        self.assertIn('is not empty', self.fail_to_draw('--all', self.folder, mine))
        self.assertEqual((mine / '00000000.png').read_text(), 'precious')
        inside = self.folder / 'coco' / 'new'
        self.assertIn('lies in the folder of a writer',
                      self.fail_to_draw('--all', self.folder, inside))
        self.assertFalse(inside.exists())
        self.assertIn('is a file of the dataset', self.fail_to_draw(
            self.folder, self.folder / 'coco/images/00000003.png'))

    def test_says_what_is_wrong(self):
        self.assertIn("WRITER: found 'cocoa'; the dataset has coco, yolo",
                      self.fail_to_draw('--all', self.folder, self.scratch / 'x', 'cocoa'))
        self.assertIn('it should end in .mp4',
                      self.fail_to_draw('--video', 'run.avi', self.folder))
        self.assertIn('--rate: it should be a number above 0',
                      self.fail_to_draw('--video', 'run.mp4', '--rate', 'fast', self.folder))

    def test_explains_itself(self):
        code, text = run('draw_labels', '--help')
        self.assertEqual(code, 0)
        for option in ('--all', '--video', '--rate', 'draw_labels --video run.mp4'):
            self.assertIn(option, text)
        for wrong in ([], ['--al', 'a', 'b'], ['a'], ['--all', 'a']):
            code, text = run('draw_labels', *wrong)
            self.assertEqual(code, 2, wrong)
            self.assertIn('usage: draw_labels', text)


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'draw_labels', '__main__')
