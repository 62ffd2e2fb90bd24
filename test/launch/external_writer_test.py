#!/usr/bin/env python3
"""A writer of another package, built in a workspace over an install space and loaded by its name.

    external_writer_test.py BUILD_FOLDER INSTALL_PREFIX

The package is examples/box_table_writer, copied as docs/writers.md says, which shows its files.
"""
import csv
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

import rosunit

from dataset_reading import Manifest, yolo_boxes
import ros_programs

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = REPOSITORY / 'examples' / 'box_table_writer'
BUILD_FOLDER, INSTALL_PREFIX = sys.argv[1:3]

WIDTH, HEIGHT = 640, 480  # [px], of the example's camera


def install(staging):
    """Installs the workspace below `staging`, and returns the prefix there.

    catkin writes the configured prefix into the workspace's files, where it is replaced.
    """
    subprocess.run(['cmake', '--install', BUILD_FOLDER], env={**os.environ, 'DESTDIR': str(staging)},
                   stdout=subprocess.DEVNULL, check=True)
    prefix = pathlib.Path(f'{staging}{INSTALL_PREFIX}')
    generated = [*prefix.glob('*setup*'), *prefix.rglob('share/*/cmake/*.cmake'),
                 *prefix.rglob('*.pc')]
    for file in generated:
        text = file.read_text(encoding='utf-8')
        file.write_text(text.replace(INSTALL_PREFIX, str(prefix)), encoding='utf-8')
    return prefix


class InstallSpace(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = pathlib.Path(scratch.name)
        cls.dataset = cls.scratch / 'dataset'
        cls.prefix = install(cls.scratch / 'staging')
        cls.setup = cls.prefix / 'setup.bash'
        cls.build_external_package()
        cls.make_dataset()

    @classmethod
    def run_installed(cls, *command, folder=None):
        """Exit code and output of a command in a shell that knows only the last workspace."""
        environ = {'HOME': str(cls.scratch), 'ROS_LOG_DIR': str(cls.scratch),
                   'PATH': '/usr/bin:/bin'}
        script = f'source {shlex.quote(str(cls.setup))}; exec "$@"'
        done = subprocess.run(['bash', '-c', script, 'bash', *map(str, command)], env=environ,
                              cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True, timeout=ros_programs.TIMEOUT, check=False)
        return done.returncode, done.stdout

    @classmethod
    def build_external_package(cls):
        workspace = cls.workspace = cls.scratch / 'workspace'
        shutil.copytree(PACKAGE, workspace / 'src' / PACKAGE.name)
        code, log = cls.run_installed(
            'catkin_make', '-DPYTHON_EXECUTABLE=/usr/bin/python3',
            '-DPython3_EXECUTABLE=/usr/bin/python3', folder=workspace)
        if code != 0:
            raise RuntimeError(f'the external package does not build:\n{log}')
        cls.setup = workspace / 'devel' / 'setup.bash'

    @classmethod
    def make_dataset(cls):
        example = cls.prefix / 'share/synthetic_dataset/config/example.yaml'
        config = cls.scratch / 'config.yaml'
        config.write_text(example.read_text(encoding='utf-8') +
                          (PACKAGE / 'settings.yaml').read_text(encoding='utf-8'),
                          encoding='utf-8')
        _, cls.log = cls.run_installed(*ros_programs.launch_command(
            f'config:={config}', f'output_folder:={cls.dataset}', 'rate:=1'))

    def table(self):
        with open(self.dataset / 'boxes' / 'boxes.csv', encoding='utf-8', newline='') as file:
            return list(csv.DictReader(file))

    def test_its_own_tests_pass(self):
        code, text = self.run_installed('catkin_make', 'run_tests_box_table_writer', folder=self.workspace)
        self.assertEqual(code, 0, text)
        code, text = self.run_installed('catkin_test_results', 'build/test_results/box_table_writer', folder=self.workspace)
        self.assertEqual(code, 0, text)
        self.assertRegex(text, 'Summary: [1-9][0-9]* tests, 0 errors, 0 failures')

    def test_dataset_is_complete(self):
        self.assertTrue((self.dataset / 'manifest.sqlite').exists(), self.log)
        self.assertEqual(Manifest(self.dataset).state, 'complete', self.log)

    def test_ros_finds_the_installed_package(self):
        _, folder = self.run_installed('rospack', 'find', 'synthetic_dataset')
        self.assertEqual(folder.strip(), str(self.prefix / 'share/synthetic_dataset'))

    def test_programs_use_installed_libraries(self):
        for program in ('generate', 'draw_labels'):
            _, libraries = self.run_installed(
                'ldd', self.prefix / 'lib/synthetic_dataset' / program)
            self.assertIn(f'libsynthetic_dataset.so => {self.prefix}/lib/', libraries)

    def test_installed_script_describes_the_dataset(self):
        code, text = self.run_installed('rosrun', 'synthetic_dataset', 'describe_dataset.py',
                                        self.dataset)
        self.assertEqual(code, 0, text)
        self.assertIn('boxes (box_table_writer/BoxTable)', text)

    def test_verify_runs_the_writer(self):
        code, text = self.run_installed('rosrun', 'synthetic_dataset', 'verify', self.dataset)
        self.assertEqual(code, 0, text)
        self.assertNotIn('note:', text)

    def test_table_has_rows_of_known_objects_and_images(self):
        rows = self.table()
        self.assertGreater(len(rows), 0)
        for row in rows:
            self.assertTrue((self.dataset / 'boxes' / row['image']).is_file(), row)
            self.assertIn(row['object'], ('rover_1', 'rover_2', 'drone_1'))
            self.assertEqual(row['class'], row['object'][:-2])

    def test_boxes_lie_within_those_of_yolo(self):
        """Yolo's are loose, in fractions that count from the first pixel's centre."""
        loose = {}
        names = (self.dataset / 'yolo' / 'obj.names').read_text(encoding='utf-8').splitlines()
        for file, boxes in self.yolo_labels():
            for number, x, y, width, height in boxes:
                loose.setdefault((f'images/{file.stem}.png', names[int(number)]), []).append(
                    ((x - width / 2) * WIDTH, (y - height / 2) * HEIGHT,
                     (x + width / 2) * WIDTH, (y + height / 2) * HEIGHT))
        for row in self.table():
            left, top, right, bottom = (float(row[edge])
                                        for edge in ('left', 'top', 'right', 'bottom'))
            self.assertTrue(-0.5 <= left < right <= WIDTH - 0.5, row)
            self.assertTrue(-0.5 <= top < bottom <= HEIGHT - 0.5, row)
            # A pixel counts when its centre is covered: its edges lie half a pixel farther out.
            self.assertTrue(
                any(left >= box[0] - 0.51 and top >= box[1] - 0.51 and
                    right <= box[2] + 0.51 and bottom <= box[3] + 0.51
                    for box in loose.get((row['image'], row['class']), [])), row)

    def yolo_labels(self):
        for file in sorted((self.dataset / 'yolo').glob('*[0-9].txt')):
            yield file, yolo_boxes(file)


class Documentation(unittest.TestCase):

    def test_shows_the_package_that_is_built_here(self):
        text = (REPOSITORY / 'docs' / 'writers.md').read_text(encoding='utf-8')
        shown = {title: code for title, code in
                 re.findall(r'^### (\S+)\n(?:(?!###? |```)[^\n]*\n)*?```\w+\n(.*?)^```$', text,
                            re.MULTILINE | re.DOTALL)}
        files = [path for path in PACKAGE.rglob('*') if path.is_file()]
        self.assertEqual(len(files), 6)
        for path in files:
            name = str(path.relative_to(PACKAGE))
            with self.subTest(name):
                self.assertEqual(shown.get(name), path.read_text(encoding='utf-8'))


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'external_writer', '__main__')
