#!/usr/bin/env python3
"""generate.launch and the node `generate` on the bundled example."""
import os
import pathlib
import signal
import subprocess
import tempfile
import unittest
import xmlrpc.client

import rosunit
import yaml

from dataset_reading import Manifest, yolo_boxes
import ros_programs

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = REPOSITORY / 'config' / 'example.yaml'

# At 1, 2, ... 7 s of the recording: its drone is known from 0.4 s on, its rovers until 7.9 s.
SCENES_AT_ONE_HERTZ = 7

MISTAKES = {'worlds/example.bag': 'worlds/no_such.bag', 'var_threshold:': 'var_treshold:'}


def with_mistakes(text):
    for right, wrong in MISTAKES.items():
        assert right in text
        text = text.replace(right, wrong)
    return text


class ScratchTest(unittest.TestCase):
    """A temporary folder for a whole test case."""

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = pathlib.Path(scratch.name)
        cls.environ = ros_programs.environment(scratch.name)
        cls.dataset = cls.scratch / 'dataset'

    @classmethod
    def launch(cls, config, *arguments):
        return ros_programs.output_of(
            ros_programs.launch_command(f'config:={config}', f'output_folder:={cls.dataset}',
                                        'rate:=1', 'if_exists:=overwrite', *arguments), cls.environ)


class LaunchedExample(ScratchTest):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.log = cls.launch(EXAMPLE)
        cls.manifest = Manifest(cls.dataset)

    def test_log_ends_with_summary(self):
        self.assertIn(f'{SCENES_AT_ONE_HERTZ} of {SCENES_AT_ONE_HERTZ} scenes in ', self.log)
        self.assertRegex(self.log, r'\bdone\b')

    def test_manifest_is_complete(self):
        self.assertEqual(self.manifest.state, 'complete')
        self.assertEqual(self.manifest.scenes, SCENES_AT_ONE_HERTZ)

    def test_manifest_lists_exactly_the_files_that_are_there(self):
        there = {path: path.stat().st_size for path in self.dataset.rglob('*') if path.is_file()}
        del there[self.dataset / 'manifest.sqlite']
        self.assertEqual(self.manifest.sizes, there)

    def test_yolo_labels_are_fractions_of_the_image(self):
        labels = sorted((self.dataset / 'yolo').glob('*[0-9].txt'))
        self.assertEqual(len(labels), SCENES_AT_ONE_HERTZ)
        boxes = [box for label in labels for box in yolo_boxes(label)]
        self.assertGreater(len(boxes), SCENES_AT_ONE_HERTZ)
        for class_name, *numbers in boxes:
            self.assertIn(class_name, ('0', '1'))
            self.assertEqual(len(numbers), 4)
            self.assertTrue(all(0.0 <= number <= 1.0 for number in numbers), numbers)

    def test_yolo_list_names_every_image(self):
        listed = (self.dataset / 'yolo' / 'list.txt').read_text(encoding='utf-8').splitlines()
        self.assertEqual(listed, [str(path) for path in sorted(self.dataset.glob('yolo/*.png'))])
        self.assertEqual(len(listed), SCENES_AT_ONE_HERTZ)

    def test_stvnet_has_image_and_mask_for_each_label(self):
        for object_name in ('rover_1', 'rover_2', 'drone_1'):
            folder = self.dataset / 'stvnet' / object_name
            labels = {path.stem for path in folder.glob('labels/*.txt')}
            self.assertTrue(labels, object_name)
            self.assertEqual({path.stem for path in folder.glob('mask/*.png')}, labels)
            self.assertEqual({path.stem for path in folder.glob('JPEGImages/*.png')}, labels)


class LaunchedInProcesses(ScratchTest):

    def files(self):
        return {path: path.read_bytes() for path in self.dataset.rglob('*') if path.is_file()}

    def test_make_the_bytes_of_one_process(self):
        self.launch(EXAMPLE)
        of_one = self.files()
        log = self.launch(EXAMPLE, 'processes:=3')  # overwrites the dataset that is there
        self.assertIn('3 processes make a shard each', log)
        self.assertRegex(log, r'\bdone\b')
        of_three = self.files()
        self.assertEqual(of_three.keys(), of_one.keys())
        self.assertEqual([path for path in of_one if of_one[path] != of_three[path]], [])


class LaunchedMistakes(ScratchTest):

    def test_are_all_reported_and_no_dataset_is_made(self):
        config = self.scratch / 'mistakes.yaml'
        config.write_text(with_mistakes(EXAMPLE.read_text(encoding='utf-8')), encoding='utf-8')
        log = self.launch(config)
        self.assertRegex(log, r'no_such\.bag: no such file')
        self.assertRegex(log, r"var_treshold: unknown parameter; did you mean '\S*var_threshold'")
        self.assertIn('failed: 2 errors', log)
        self.assertFalse(self.dataset.exists())

    def test_are_found_in_a_file_named_from_the_current_folder(self):
        (self.scratch / 'here.yaml').write_text('bag_file: $(dirname)/no_such.bag\n',
                                                encoding='utf-8')
        environ = {**self.environ, 'PWD': str(self.scratch)}
        log = ros_programs.output_of(ros_programs.launch_command('config:=here.yaml'), environ)
        self.assertIn(f'{self.scratch}/no_such.bag: no such file', log)

    def test_in_parameters_over_the_file_are_reported(self):
        log = ros_programs.output_of(
            ros_programs.launch_command(f'config:={EXAMPLE}', 'shard_index:=5', 'shard_count:=2',
                                        'sync:=never'), self.environ)
        self.assertIn('shard', log)
        self.assertIn('sync: ', log)
        self.assertIn('failed: ', log)

    def test_are_told_once_by_many_processes(self):
        config = self.scratch / 'mistakes.yaml'
        config.write_text(with_mistakes(EXAMPLE.read_text(encoding='utf-8')), encoding='utf-8')
        log = self.launch(config, 'processes:=3')
        self.assertEqual(log.count('no_such.bag: no such file'), 1)
        self.assertIn('failed: 2 errors', log)


class ExitCode(ScratchTest):
    """The node's own exit code, as roslaunch does not pass it on."""

    def start(self, rate, change=lambda text: text):
        text = change(EXAMPLE.read_text(encoding='utf-8'))
        parameters = yaml.safe_load(text.replace('$(find synthetic_dataset)', str(REPOSITORY)))
        parameters.update(output_folder=str(self.dataset), simulated_rate=rate,
                          if_exists='overwrite')
        master = xmlrpc.client.ServerProxy(os.environ['ROS_MASTER_URI'])
        master.setParam('/generate_test', '/generate', parameters)
        node = subprocess.Popen(['rosrun', 'synthetic_dataset', 'generate'], env=self.environ,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                universal_newlines=True)
        self.addCleanup(node.kill)
        return node

    def test_is_0_when_done(self):
        node = self.start(rate=1.0)
        log, _ = node.communicate(timeout=ros_programs.TIMEOUT)
        self.assertEqual(node.returncode, 0, log)
        self.assertEqual(Manifest(self.dataset).state, 'complete')

    def test_is_1_on_errors(self):
        node = self.start(rate=1.0, change=with_mistakes)
        log, _ = node.communicate(timeout=ros_programs.TIMEOUT)
        self.assertEqual(node.returncode, 1, log)

    def test_is_130_when_interrupted(self):
        node = self.start(rate=50.0)
        log = ''
        for line in node.stdout:
            log += line
            if 'scene 1 of' in line:
                node.send_signal(signal.SIGINT)
                break
        rest, _ = node.communicate(timeout=ros_programs.TIMEOUT)
        self.assertEqual(node.returncode, 130, log + rest)
        self.assertIn('stopped', rest)
        manifest = Manifest(self.dataset)
        self.assertEqual(manifest.state, 'running')
        self.assertGreaterEqual(manifest.scenes, 1)
        for path, size in manifest.sizes.items():
            self.assertEqual(path.stat().st_size, size, path)


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'generate', '__main__')
