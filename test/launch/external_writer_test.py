#!/usr/bin/env python3
"""A writer of another package, built against an install space and loaded by its name.

    external_writer_test.py BUILD_FOLDER INSTALL_PREFIX

The package is the one that docs/writers.md shows.
"""
import csv
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

import rosunit

from dataset_reading import Manifest, yolo_boxes
import ros_programs

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = REPOSITORY / 'test' / 'external_writer_package'
BUILD_FOLDER, INSTALL_PREFIX = sys.argv[1:3]

WIDTH, HEIGHT = 640, 480  # [px], of the example's camera

SETTINGS = """
writers:
  - {name: bounding_shape, type: synthetic_dataset/BoundingShape}
  - {name: yolo, type: synthetic_dataset/Yolo}
  - {name: stvnet, type: synthetic_dataset/StvNet}
  - {name: boxes, type: box_table/Csv}
boxes:
  table: boxes.csv
"""


def install(staging):
    """Installs the workspace below `staging`, and answers the prefix there.

    catkin writes the prefix that the workspace is configured for into its files: it is replaced.
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
        cls.build_external_package()
        cls.make_dataset()

    @classmethod
    def run_installed(cls, *command):
        """Exit code and output of a command in a shell that knows the install space alone."""
        environ = {'HOME': str(cls.scratch), 'ROS_LOG_DIR': str(cls.scratch),
                   'PATH': '/usr/bin:/bin'}
        script = f'source {shlex.quote(str(cls.prefix))}/setup.bash; exec "$@"'
        done = subprocess.run(['bash', '-c', script, 'bash', *map(str, command)], env=environ,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True, timeout=ros_programs.TIMEOUT, check=False)
        return done.returncode, done.stdout

    @classmethod
    def build_external_package(cls):
        build = cls.scratch / 'external_build'
        for command in (['-S', PACKAGE, '-B', build, f'-DCMAKE_INSTALL_PREFIX={cls.prefix}',
                         '-DPYTHON_EXECUTABLE=/usr/bin/python3',
                         '-DPython3_EXECUTABLE=/usr/bin/python3'],
                        ['--build', build], ['--install', build]):
            code, log = cls.run_installed('cmake', *command)
            if code != 0:
                raise RuntimeError(f'the external package does not build:\n{log}')

    @classmethod
    def make_dataset(cls):
        example = cls.prefix / 'share/synthetic_dataset/config/example.yaml'
        config = cls.scratch / 'config.yaml'
        config.write_text(example.read_text(encoding='utf-8') + SETTINGS, encoding='utf-8')
        _, cls.log = cls.run_installed(*ros_programs.launch_command(
            f'config:={config}', f'output_folder:={cls.dataset}', 'rate:=1'))

    def table(self):
        with open(self.dataset / 'boxes' / 'boxes.csv', encoding='utf-8', newline='') as file:
            return list(csv.DictReader(file))

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
        self.assertIn('boxes (box_table/Csv)', text)

    def test_table_has_a_row_for_each_box(self):
        rows = self.table()
        self.assertEqual(len(rows), sum(len(boxes) for _, boxes in self.yolo_labels()))
        for row in rows:
            self.assertTrue((self.dataset / 'boxes' / row['image']).is_file(), row)
            self.assertIn(row['object'], ('rover_1', 'rover_2', 'drone_1'))

    def test_boxes_are_those_of_yolo(self):
        rows = self.table()
        expected = [box for _, boxes in self.yolo_labels() for box in boxes]
        compared = 0
        for row, (_, x, y, width, height) in zip(rows, expected):
            left, top, right, bottom = (float(row[edge])
                                        for edge in ('left', 'top', 'right', 'bottom'))
            if left <= 0 or top <= 0 or right >= WIDTH - 1 or bottom >= HEIGHT - 1:
                continue  # the formats cut at different edges
            # Five decimals of a fraction are coarser than two of a pixel.
            self.assertAlmostEqual((left + right) / 2, x * WIDTH, delta=0.02)
            self.assertAlmostEqual((top + bottom) / 2, y * HEIGHT, delta=0.02)
            self.assertAlmostEqual(right - left, width * WIDTH, delta=0.02)
            self.assertAlmostEqual(bottom - top, height * HEIGHT, delta=0.02)
            compared += 1
        self.assertGreater(compared, 0)

    def yolo_labels(self):
        for file in sorted((self.dataset / 'yolo').glob('*[0-9].txt')):
            yield file, yolo_boxes(file)


class Documentation(unittest.TestCase):

    def test_shows_the_package_that_is_built_here(self):
        text = (REPOSITORY / 'docs' / 'writers.md').read_text(encoding='utf-8')
        shown = {title: code for title, code in
                 re.findall(r'^## (\S+)\n(?:(?!## |```)[^\n]*\n)*?```\w+\n(.*?)^```$', text,
                            re.MULTILINE | re.DOTALL)}
        for name in ('package.xml', 'plugins.xml', 'CMakeLists.txt', 'src/box_table_writer.cpp'):
            with self.subTest(name):
                self.assertEqual(shown.get(name), (PACKAGE / name).read_text(encoding='utf-8'))


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'external_writer', '__main__')
