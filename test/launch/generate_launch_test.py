#!/usr/bin/env python3
"""generate.launch on the bundled example: the dataset is whole, mistakes are told, exit codes hold."""
import pathlib
import signal
import sqlite3
import subprocess
import sys
import tempfile
import unittest

import rosunit

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from ros_processes import REPOSITORY, Master, example_settings, roslaunch_generate, run  # noqa: E402

EXAMPLE = REPOSITORY / 'config' / 'example.yaml'


class GenerateLaunch(unittest.TestCase):
    """One run, looked at from all sides."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name) / 'dataset'
        cls.log = roslaunch_generate(config=EXAMPLE, output_folder=cls.folder, rate=1)
        cls.manifest = sqlite3.connect(cls.folder / 'manifest.sqlite')

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def scenes(self):
        return self.manifest.execute('SELECT count(*) FROM scene').fetchone()[0]

    def test_the_run_is_complete(self):
        state = self.manifest.execute("SELECT value FROM run WHERE key = 'state'").fetchone()[0]
        self.assertEqual(state, 'complete', self.log)
        self.assertEqual(self.scenes(), 8)
        self.assertIn('done', self.log)
        self.assertIn('8 of 8 scenes', self.log)

    def test_every_listed_file_is_there(self):
        files = self.manifest.execute('SELECT path, bytes FROM file').fetchall()
        self.assertGreater(len(files), 8 * 10)
        for path, size in files:
            self.assertEqual((self.folder / path).stat().st_size, size, path)

    def test_boxes_are_fractions_of_the_image(self):
        for number in range(self.scenes()):
            lines = (self.folder / 'yolo' / f'{number:08}.txt').read_text().splitlines()
            self.assertTrue(lines)
            for line in lines:
                name, *box = line.split(' ')
                self.assertIn(name, ('rover', 'drone'))
                self.assertEqual(len(box), 4)
                for value in box:
                    self.assertGreater(float(value), 0.0)
                    self.assertLessEqual(float(value), 1.0)

    def test_the_list_names_every_image(self):
        images = (self.folder / 'yolo' / 'list.txt').read_text().splitlines()
        self.assertEqual(len(images), self.scenes())
        for image in images:
            self.assertTrue(pathlib.Path(image).is_file(), image)

    def test_each_label_has_its_image_and_mask(self):
        labels = list((self.folder / 'stvnet').glob('*/labels/*.txt'))
        self.assertGreater(len(labels), 8)
        for label in labels:
            for kind in ('JPEGImages', 'mask'):
                self.assertTrue((label.parent.parent / kind / f'{label.stem}.png').is_file(), label)

    def test_a_dataset_that_is_there_is_left_alone(self):
        before = (self.folder / 'manifest.sqlite').read_bytes()
        log = roslaunch_generate(config=EXAMPLE, output_folder=self.folder, rate=1)
        self.assertIn('overwrite', log)
        self.assertEqual((self.folder / 'manifest.sqlite').read_bytes(), before)


class Mistakes(unittest.TestCase):

    def test_all_are_told_at_once_and_nothing_is_made(self):
        with tempfile.TemporaryDirectory() as temporary:
            settings = example_settings(pathlib.Path(temporary) / 'settings.yaml',
                                        bag_file='/nowhere/a.bag', simulated_rte='3')
            folder = pathlib.Path(temporary) / 'dataset'
            log = roslaunch_generate(config=settings, output_folder=folder)
            self.assertIn('/nowhere/a.bag', log)
            self.assertIn("did you mean 'simulated_rate'?", log)
            self.assertIn('failed: 2 errors', log)
            self.assertFalse(folder.exists())


class ExitCodes(unittest.TestCase):
    """Of the node started by rosrun, which passes them on."""

    def test_say_what_happened(self):
        with tempfile.TemporaryDirectory() as temporary, Master() as master:
            folder = pathlib.Path(temporary)
            generate = ['rosrun', 'synthetic_dataset', 'generate']

            master.load(example_settings(folder / 'good.yaml', output_folder=folder / 'good',
                                         simulated_rate=0.5))
            code, log = run(generate, env=master.env)
            self.assertEqual(code, 0, log)

            master.load(example_settings(folder / 'bad.yaml', output_folder=folder / 'bad',
                                         simulated_rate=0))
            code, log = run(generate, env=master.env)
            self.assertEqual(code, 1, log)

            master.load(example_settings(folder / 'long.yaml', output_folder=folder / 'long',
                                         simulated_rate=30.0))
            process = subprocess.Popen(generate, env=master.env, stdout=subprocess.PIPE,
                                       stderr=subprocess.STDOUT, text=True)
            for line in process.stdout:
                if ' of ' in line and 'scene' in line:  # the first progress: in the middle of it
                    break
            # rosrun has become the node: exec keeps its process.
            process.send_signal(signal.SIGINT)
            rest = process.communicate(timeout=60)[0]
            self.assertEqual(process.returncode, 130, rest)
            self.assertIn('stopped', rest)


def suite():
    """All cases of this file."""
    loader = unittest.TestLoader()
    return unittest.TestSuite(loader.loadTestsFromTestCase(case)
                              for case in (GenerateLaunch, Mistakes, ExitCodes))


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'generate_launch', 'generate_launch_test.suite')
