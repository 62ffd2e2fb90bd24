#!/usr/bin/env python3
"""From files to a dataset as in docs/first_hour.md, and the programs' exit codes."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest
import xmlrpc.client

import rosunit

from dataset_reading import Manifest
import ros_programs

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = REPOSITORY / 'config' / 'example.yaml'
BAG = REPOSITORY / 'worlds' / 'example.bag'
ROVER = REPOSITORY / 'worlds' / 'models' / 'rover' / 'model.sdf'
PROGRAMS = ('generate', 'check', 'inspect', 'start', 'merge', 'verify', 'contact_sheet',
            'draw_labels', 'report', 'describe_dataset.py', 'align')


class FirstHour(unittest.TestCase):

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        self.addCleanup(scratch.cleanup)
        self.scratch = pathlib.Path(scratch.name)

    def run_program(self, program, *arguments, with_master=False):
        """Exit code, standard output and standard error; without a master and a terminal."""
        environ = {name: value for name, value in os.environ.items()
                   if with_master or name != 'ROS_MASTER_URI'}
        done = subprocess.run([ros_programs.path_of(program), *map(str, arguments)], env=environ,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True, cwd=self.scratch,
                              timeout=ros_programs.TIMEOUT, check=False)
        return done.returncode, done.stdout, done.stderr

    def test_every_program_says_how_it_is_used(self):
        for program in PROGRAMS:
            for option in ('--help', '-h'):
                code, out, _ = self.run_program(program, option)
                self.assertEqual(code, 0, program)
                self.assertIn(f'usage: {program}', out)
                self.assertIn('--help', out, program)
                self.assertIn(f'\n  {program} ', out, 'an example')
                self.assertIn('Exit codes: 0', out, program)

    def test_from_a_recording_to_a_dataset(self):
        code, out, err = self.run_program('inspect', BAG)
        self.assertEqual(code, 0, err)
        self.assertIn("robot: rover_1, whose frame is 'rover_1/base_link'", out)
        code, out, err = self.run_program('inspect', '--json', BAG)
        frames = {frame['name']: frame for frame in json.loads(out)['frames']}
        self.assertEqual(frames['rover_1/base_footprint']['root'], 'map')
        self.assertGreater(frames['rover_1/base_footprint']['extent'][0], 1.0)

        code, out, err = self.run_program('start', BAG, '--model', f'rover_1={ROVER}', '-o',
                                          'my.yaml')
        self.assertEqual((code, out), (0, ''), err)
        self.assertIn('start: TODO: a pinhole of 640 x 480 stands in', err)
        settings = (self.scratch / 'my.yaml').read_text(encoding='utf-8')
        code, _, err = self.run_program('start', BAG, '-o', 'my.yaml')
        self.assertEqual(code, 1)
        self.assertIn("'my.yaml' already exists", err)
        self.assertEqual((self.scratch / 'my.yaml').read_text(encoding='utf-8'), settings)

        code, out, err = self.run_program('check', 'my.yaml', '--out', 'look')
        self.assertEqual(code, 0, out + err)
        self.assertIn('9 scenes were made to look at: nothing is odd', out)
        for picture in ('check.png', 'map.png'):
            self.assertGreater((self.scratch / 'look' / picture).stat().st_size, 10000)
        self.assertFalse((self.scratch / 'dataset').exists())

        code, out, err = self.run_program('generate', '--config', 'my.yaml', 'simulated_rate:=0.5')
        self.assertEqual(code, 0, out + err)
        self.assertRegex(out, r'done(\x1b\[0m)?\n$')
        self.assertEqual(Manifest(self.scratch / 'dataset').state, 'complete')

    def labels_of(self, dataset):
        """The names of the classes that have labels in each split of a COCO dataset."""
        found = {}
        for split in ('train', 'val'):
            file = dataset / 'coco' / 'annotations' / f'instances_{split}.json'
            content = json.loads(file.read_text(encoding='utf-8'))
            names = {each['id']: each['name'] for each in content['categories']}
            found[split] = {names[each['category_id']] for each in content['annotations']}
        return found

    def test_three_commands_make_a_dataset_with_labels_in_each_split(self):
        world = REPOSITORY / 'worlds' / 'example.sdf'
        code, _, err = self.run_program('start', BAG, '--world', world, '--model',
                                        f'rover_1={ROVER}', '-o', 'my.yaml')
        self.assertEqual(code, 0, err)
        code, out, err = self.run_program('check', 'my.yaml')
        self.assertIn(code, (0, 3), out + err)
        self.assertTrue((self.scratch / 'check.png').exists(), 'beside the settings')
        # A quarter of the scenes, to save time.
        code, out, err = self.run_program('generate', '--config', 'my.yaml', 'simulated_rate:=5')
        self.assertEqual(code, 0, out + err)
        code, out, err = self.run_program('verify', 'dataset')
        self.assertEqual(code, 0, out + err)
        self.assertEqual(self.labels_of(self.scratch / 'dataset'),
                         {'train': {'rover_1'}, 'val': {'rover_1'}})

    def test_one_more_line_labels_what_a_riding_camera_passes(self):
        (self.scratch / 'ride.yaml').write_text(f"""
bag_file: "{BAG}"
simulated_rate: 1
world:
  file: "{REPOSITORY / 'worlds' / 'example.sdf'}"
  model_folders: ["{REPOSITORY / 'worlds' / 'models'}"]
camera:
  info_file: "{REPOSITORY / 'worlds' / 'example_camera.yaml'}"
  mounted_on: rover_1/base_footprint
  pose: {{position: [0.3, 0, 0.8], rpy: [0, 0, -1.57]}}  # to the right
output_folder: "$(dirname)/ride"
split: {{train: 0.8, val: 0.2, by: balanced_blocks}}
writers: [{{name: coco, type: synthetic_dataset/Coco}}]
world_objects: [{{class: barrel, models: "barrel_*"}}, {{class: crate, models: "crate_*"}}]
""", encoding='utf-8')
        code, out, err = self.run_program('check', 'ride.yaml')
        self.assertIn(code, (0, 3), out + err)
        self.assertIn('labels, counting boxes that reach into the picture: train', out)
        code, out, err = self.run_program('generate', '--config', 'ride.yaml')
        self.assertEqual(code, 0, out + err)
        code, out, err = self.run_program('verify', 'ride')
        self.assertEqual(code, 0, out + err)
        labels = self.labels_of(self.scratch / 'ride')
        self.assertTrue(labels['train'], 'what the rover passes')
        self.assertLessEqual(labels['train'], {'barrel', 'crate'})

    def test_models_on_the_parameter_server_are_named(self):
        master = xmlrpc.client.ServerProxy(os.environ['ROS_MASTER_URI'])
        master.setParam('/first_hour', '/husky/robot_description', '<robot name="husky"/>')
        code, out, err = self.run_program('inspect', BAG, with_master=True)
        self.assertEqual(code, 0, err)
        self.assertIn("model on the parameter server: /husky/robot_description is a URDF of 'husky'",
                      out)
        code, out, err = self.run_program('inspect', BAG)
        self.assertEqual(code, 0, err)
        self.assertNotIn('parameter server', out)
        code, out, err = self.run_program('inspect', '--urdf', BAG)
        self.assertEqual((code, out), (1, ''))
        self.assertIn('no URDF on a topic robot_description', err)

    def test_exit_codes_tell_odd_from_wrong(self):
        config = self.scratch / 'my.yaml'
        config.write_text(f'include: "{EXAMPLE}"\noutput_folder: "$(dirname)/dataset"\n'
                          'camera: {pose: {position: [0, 0, 2], look_at: [0, 0, 9]}}\n'
                          'simulated_rate: 0.5\n', encoding='utf-8')
        code, out, err = self.run_program('generate', '--config', config, '--check')
        self.assertEqual(code, 3, out + err)
        self.assertIn('odd: rover_1: seen in none of', out)
        self.assertFalse((self.scratch / 'dataset').exists())
        # A run without any labels still succeeds, and says so.
        code, out, err = self.run_program('generate', '--config', config)
        self.assertEqual(code, 0, out + err)
        self.assertIn('done, but NOTHING is labelled', out)
        for program, arguments in (('check', ['no.yaml']), ('generate', ['--config', 'no.yaml']),
                                   ('generate', ['--config', config, 'simulated_rate:=-1']),
                                   ('inspect', ['no.bag']), ('inspect', ['no.world']),
                                   ('start', ['no.bag']), ('start', [BAG, '--world', 'no'])):
            code, out, err = self.run_program(program, *arguments)
            self.assertEqual(code, 1, f'{program} {arguments}: {out}{err}')

    def test_all_settings_are_listed_for_people_and_editors(self):
        code, out, _ = self.run_program('generate', '--settings')
        self.assertEqual(code, 0)
        self.assertEqual(out, (REPOSITORY / 'config' / 'params.yaml').read_text(encoding='utf-8'))
        code, out, _ = self.run_program('generate', '--settings', '--json')
        self.assertEqual(code, 0)
        schema = json.loads(out)
        self.assertEqual(schema['properties']['camera']['properties']['near']['default'], 0.05)


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'first_hour', '__main__')
