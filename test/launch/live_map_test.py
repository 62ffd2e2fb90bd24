#!/usr/bin/env python3
"""The node `generate` with the map of a running system."""
import os
import pathlib
import sqlite3
import subprocess
import tempfile
import unittest
import xmlrpc.client

import rosunit
import yaml

from dataset_reading import Manifest
import ros_programs

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = REPOSITORY / 'config' / 'example.yaml'
SCENES = 2


def start_publisher(environ, *arguments):
    return subprocess.Popen([ros_programs.path_of_test_program('publish_map'), *arguments],
                            env=environ)


def start_generate(environ, dataset, node='generate', **settings):
    text = EXAMPLE.read_text(encoding='utf-8')
    parameters = yaml.safe_load(text.replace('$(find synthetic_dataset)', str(REPOSITORY)))
    del parameters['bag_file']
    parameters.update(output_folder=str(dataset), motion='placement', scenes=SCENES,
                      placement={'map_topic': 'hall_map'})
    parameters['camera']['sample'] = {'look_at': 'all', 'distance': 4.0, 'elevation': 0.6}
    parameters.update(settings)
    master = xmlrpc.client.ServerProxy(os.environ['ROS_MASTER_URI'])
    master.deleteParam('/live_map_test', '/' + node)
    master.setParam('/live_map_test', '/' + node, parameters)
    return subprocess.Popen(['rosrun', 'synthetic_dataset', 'generate', '__name:=' + node],
                            env=environ, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            universal_newlines=True)


def end_of(process):
    log, _ = process.communicate(timeout=ros_programs.TIMEOUT)
    return process.returncode, log


class LiveMap(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        """Waits for a map that never comes while the other tests run."""
        cls.scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        environ = ros_programs.environment(cls.scratch.name)
        cls.never_made = pathlib.Path(cls.scratch.name) / 'dataset'
        cls.attic = start_publisher(environ, '/attic_maps', 'map', '__name:=attic')
        cls.waiting = start_generate(environ, cls.never_made, 'waiting',
                                     placement={'map_topic': 'attic_map'})

    @classmethod
    def tearDownClass(cls):
        for process in (cls.waiting, cls.attic):
            process.terminate()
            process.wait()
        cls.scratch.cleanup()

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        self.addCleanup(scratch.cleanup)
        self.environ = ros_programs.environment(scratch.name)
        self.dataset = pathlib.Path(scratch.name) / 'dataset'

    def publish(self, *arguments):
        node = start_publisher(self.environ, *arguments)
        self.addCleanup(node.wait)
        self.addCleanup(node.terminate)

    def generate(self, **settings):
        return end_of(start_generate(self.environ, self.dataset, **settings))

    def query(self, sql):
        with sqlite3.connect(self.dataset / 'manifest.sqlite') as manifest:
            return manifest.execute(sql).fetchall()

    def test_places_objects_on_the_free_part(self):
        self.publish('/hall_map')
        code, log = self.generate()
        self.assertEqual(code, 0, log)
        self.assertEqual(Manifest(self.dataset).state, 'complete')
        places = self.query('SELECT x, y FROM scene_object')
        self.assertEqual(len(places), SCENES * 3)
        for x, y in places:
            self.assertTrue(-2.0 < x < 2.0 and -1.9 < y < 2.0, (x, y))

    def test_is_kept_in_the_manifest(self):
        self.publish('/hall_map')
        self.assertEqual(self.generate()[0], 0)
        cells = self.query("SELECT value FROM setting WHERE name = 'placement/received_map/cells'")
        self.assertEqual(cells, [('"100x160 0x6240"',)])
        code, log = self.generate()
        self.assertEqual(code, 0, log)
        self.assertIn('complete already', log)

    def test_of_another_frame_is_an_error(self):
        self.publish('/hall_map', 'odom')
        code, log = self.generate()
        self.assertEqual(code, 1, log)
        self.assertIn("a map in the frame 'odom'", log)

    def test_that_does_not_come_is_an_error_that_says_what_there_is(self):
        code, log = end_of(self.waiting)
        self.assertEqual(code, 1, log)
        self.assertIn("placement/map_topic: found '/attic_map', on which no map came within 10 s",
                      log)
        self.assertIn("did you mean '/attic_maps'?", log)
        self.assertFalse(self.never_made.exists())

    def test_topic_of_another_type_is_an_error_at_once(self):
        code, log = self.generate(placement={'map_topic': '/rosout'})  # its own messages
        self.assertEqual(code, 1, log)
        self.assertRegex(log, "'/rosout', which .*/generate.* publishes as rosgraph_msgs/Log; it "
                              'should be nav_msgs/OccupancyGrid')


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'live_map', '__main__')
