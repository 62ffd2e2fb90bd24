#!/usr/bin/env python3
"""`generate --config`, which has no ROS master, and what signals do to it."""
import hashlib
import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import unittest

import rosunit

from dataset_reading import Manifest
import ros_programs

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = REPOSITORY / 'config' / 'example.yaml'
FEW_SCENES = 0.3  # [Hz] of the example's recording: 2 scenes, at 1 s and at 4.333 s


class Case(unittest.TestCase):
    """A temporary folder, and runs with neither a master nor a home in their environment."""

    @classmethod
    def setUpClass(cls):
        cls.program = ros_programs.path_of('generate')
        cls.environ = {name: value for name, value in os.environ.items()
                       if name not in ('ROS_MASTER_URI', 'HOME', 'ROS_HOME', 'ROS_LOG_DIR')}

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        self.addCleanup(scratch.cleanup)
        self.scratch = pathlib.Path(scratch.name)
        self.dataset = self.scratch / 'dataset'

    def start(self, *arguments, ignored=()):
        """`ignored` are the signals that it ignores, whichever this test itself ignores."""
        def set_signals():
            for number in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM):
                signal.signal(number, signal.SIG_IGN if number in ignored else signal.SIG_DFL)

        node = subprocess.Popen([self.program, *map(str, arguments)], env=self.environ,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, universal_newlines=True,
                                cwd=self.scratch, preexec_fn=set_signals)
        self.addCleanup(node.stdout.close)
        self.addCleanup(node.wait)
        self.addCleanup(node.kill)
        return node

    def start_example(self, rate, *arguments, **options):
        return self.start('--config', EXAMPLE, f'output_folder:={self.dataset}',
                          f'simulated_rate:={rate}', 'if_exists:=overwrite', *arguments, **options)

    def finish(self, node):
        log, _ = node.communicate(timeout=ros_programs.TIMEOUT)
        return node.returncode, log

    def wait_for(self, node, text):
        log = ''
        for line in node.stdout:
            log += line
            if text in line:
                return
        self.fail(f"'{text}' did not come:\n{log}")


class WithoutMaster(Case):

    def files(self):
        return {path.relative_to(self.dataset): hashlib.sha256(path.read_bytes()).hexdigest()
                for path in self.dataset.rglob('*')
                if path.is_file() and path.name != 'manifest.sqlite'}

    def test_makes_the_dataset_that_roslaunch_makes(self):
        code, log = self.finish(self.start_example(FEW_SCENES))
        self.assertEqual(code, 0, log)
        self.assertEqual(Manifest(self.dataset).state, 'complete')
        self.assertRegex(log, r'\bdone\b')
        ours = self.files()
        environ = ros_programs.environment(str(self.scratch))
        log = ros_programs.output_of(
            ros_programs.launch_command(f'config:={EXAMPLE}', f'output_folder:={self.dataset}',
                                        f'rate:={FEW_SCENES}', 'if_exists:=overwrite'), environ)
        self.assertRegex(log, r'\bdone\b')
        self.assertGreater(len(ours), 10)
        self.assertEqual(self.files(), ours)

    def test_goes_on_with_the_second_dataset_of_a_twin_in_processes(self):
        """The first one, which is complete, is opened again, and the second one forks."""
        twin = ['--config', REPOSITORY / 'config' / 'example_twin.yaml', 'twin/output:=both',
                f'output_folder:={self.dataset}', 'simulated_rate:=0.5', 'processes:=2']
        code, log = self.finish(self.start(*twin))
        self.assertEqual(code, 0, log)
        whole = self.files()
        shutil.rmtree(self.dataset / 'synthetic')
        node = self.start(*twin)
        code, log = self.finish(node)
        self.assertEqual(code, 0, log)
        self.assertIn('complete already', log)
        self.assertEqual(self.files(), whole)
        shutil.rmtree(self.dataset / 'synthetic')
        node = self.start(*twin)
        self.wait_for(node, 'scene 1 of')
        node.send_signal(signal.SIGINT)
        code, log = self.finish(node)
        self.assertEqual(code, 130, log)

    def test_leaves_no_files_of_ros(self):
        self.finish(self.start('--config', 'no_such.yaml'))
        self.assertEqual(list(self.scratch.iterdir()), [])

    def test_ends_with_a_line_for_scripts(self):
        node = self.start_example(1, '--json', 'only_scenes:=[0]')
        code, log = self.finish(node)
        end = json.loads(log.splitlines()[-1])
        self.assertEqual((code, end['result'], end['scenes']), (0, 'done', 1))
        self.assertTrue(end['manifest'].endswith('manifest.sqlite'))
        code, log = self.finish(self.start_example(1, '--json', 'world:=/no/such.world'))
        end = json.loads(log.splitlines()[-1])
        self.assertEqual((code, end['result']), (1, 'failed'))
        self.assertIn('/no/such.world', ' '.join(end['errors']))

    def test_tells_all_errors(self):
        config = self.scratch / 'my.yaml'
        config.write_text(EXAMPLE.read_text(encoding='utf-8') +
                          '\nrover_1/model: "param:/robot_description"\n', encoding='utf-8')
        code, log = self.finish(self.start('--config', 'my.yaml', 'yolo/main_lst:=x',
                                           'bag_file:=$(dirname)/x.bag', 'simulated_rate:=fast'))
        self.assertEqual(code, 1, log)
        self.assertIn("yolo/main_lst: unknown parameter; did you mean 'main_list'", log)
        self.assertIn('simulated_rate: found fast (a text)', log)
        self.assertIn("rover_1/model: found 'param:/robot_description'", log)
        self.assertIn('without a ROS master, name a file', log)

    def test_tells_usage(self):
        code, log = self.finish(self.start('--help'))
        self.assertEqual(code, 0)
        self.assertIn('usage: generate --config FILE', log)
        for arguments in (['--confg', 'x'], ['--config'], ['x.yaml'], ['--config', 'x', 'rate:=']):
            code, log = self.finish(self.start(*arguments))
            self.assertEqual(code, 1, log)
            self.assertIn('usage: generate --config FILE', log)


class Signals(Case):

    def test_finish_the_scene_and_say_how_to_go_on(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            with self.subTest(number=number):
                node = self.start_example(50.0)
                self.wait_for(node, 'scene 1 of')
                node.send_signal(number)
                answer, log = self.finish(node)
                self.assertEqual(answer, code, log)
                self.assertIn(f'stopped by {number.name}', log)
                self.assertIn('run the same command again to go on', log)
                manifest = Manifest(self.dataset)
                self.assertEqual(manifest.state, 'running')
                self.assertGreaterEqual(manifest.scenes, 1)
                for path, size in manifest.sizes.items():
                    self.assertEqual(path.stat().st_size, size, path)

    def test_stop_at_once_when_there_are_two(self):
        node = self.start_example(50.0)
        self.wait_for(node, 'scene 1 of')
        # Both arrive when it continues, before it can finish a scene; threads may race for them.
        for number in (signal.SIGSTOP, signal.SIGINT, signal.SIGTERM, signal.SIGCONT):
            node.send_signal(number)
        code, log = self.finish(node)
        self.assertIn(code, (130, 143), log)
        self.assertIn('stopped at once; run the same command again to go on', log)
        self.assertNotIn('stopped by', log)

    def test_stop_at_once_before_the_first_scene(self):
        # A program that expands a model and never ends keeps the run from its first scene.
        xacro = self.scratch / 'xacro'
        xacro.write_text('#!/bin/sh\nexec cat "$PIPE"\n', encoding='utf-8')
        xacro.chmod(0o755)
        path = f'{self.scratch}:{self.environ["PATH"]}'
        model = self.scratch / 'robot.urdf.xacro'
        model.write_text('<robot/>', encoding='utf-8')
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            with self.subTest(number=number):
                # A new pipe each time, as the earlier reader may not have ended yet.
                pipe = self.scratch / f'pipe_{number}'
                os.mkfifo(pipe)
                self.environ = {**self.environ, 'PATH': path, 'PIPE': str(pipe)}
                node = self.start_example(1.0, f'rover_1/model:={model}')
                with open(pipe, 'w', encoding='utf-8'):  # which waits for the reader
                    node.send_signal(number)
                    answer, log = self.finish(node)
                self.assertEqual(answer, code, log)
                self.assertIn('stopped before the first scene', log)

    def test_stop_many_processes_which_go_on(self):
        node = self.start_example(20.0, 'processes:=2')
        self.wait_for(node, 'scene 1 of')
        node.send_signal(signal.SIGINT)
        code, log = self.finish(node)
        self.assertEqual(code, 130, log)
        self.assertIn('stopped by SIGINT', log)
        self.assertEqual(log.count('the next signal stops at once'), 1)
        self.assertFalse((self.dataset / 'manifest.sqlite').exists())
        code, log = self.finish(self.start_example(20.0, 'processes:=2', 'if_exists:=resume'))
        self.assertEqual(code, 0, log)
        manifest = Manifest(self.dataset)
        self.assertEqual(manifest.state, 'complete')
        self.assertEqual(manifest.scenes, 150)

    def test_that_are_ignored_stay_ignored(self):
        """As nohup and shells' background jobs need it."""
        node = self.start_example(FEW_SCENES, ignored=[signal.SIGHUP])
        self.wait_for(node, 'scene 1 of')
        node.send_signal(signal.SIGHUP)
        code, log = self.finish(node)
        self.assertEqual(code, 0, log)

    def test_of_a_closed_pipe_do_not_end_a_run(self):
        """As in `generate ... | head -1`."""
        node = self.start_example(FEW_SCENES)
        self.wait_for(node, 'INFO')
        node.stdout.close()
        self.assertEqual(node.wait(timeout=ros_programs.TIMEOUT), 0)
        self.assertEqual(Manifest(self.dataset).state, 'complete')


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'without_master', '__main__')
