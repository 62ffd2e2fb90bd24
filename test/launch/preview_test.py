#!/usr/bin/env python3
"""What nodes publish: `preview` the output of `generate` at requested instants; `generate` its
progress."""
import json
import os
import pathlib
import pty
import queue
import runpy
import subprocess
import tempfile
import unittest

import numpy
import PIL.Image
import rospy
import rosunit
import yaml
from diagnostic_msgs.msg import DiagnosticArray
from sensor_msgs.msg import CameraInfo, Image
from std_msgs.msg import Float64, Int64, String
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

import ros_programs

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = REPOSITORY / 'config' / 'example.yaml'
LAST = 20


class Listener:
    """The messages of a topic as they arrive."""

    def __init__(self, topic, kind):
        self.messages = queue.Queue()
        self.subscriber = rospy.Subscriber(topic, kind, self.messages.put)

    def next(self, fits=lambda message: True):
        while True:
            message = self.messages.get(timeout=60.0)
            if fits(message):
                return message

    def forget(self):
        while not self.messages.empty():
            self.messages.get()

    def close(self):
        self.subscriber.unregister()


def shows(instant):
    def fits(message):
        status = json.loads(message.data)
        return status['state'] in ('standing', 'playing') and status.get('instant') == instant
    return fits


def pixels_of(message):
    channels = {'bgr8': 3, 'mono16': 1, '32FC1': 1}[message.encoding]
    kind = {'bgr8': numpy.uint8, 'mono16': numpy.uint16, '32FC1': numpy.float32}[message.encoding]
    pixels = numpy.frombuffer(message.data, kind)
    return pixels.reshape((message.height, message.width, channels) if channels > 1 else
                          (message.height, message.width))


class Preview(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        folder = pathlib.Path(cls.scratch.name)
        environ = ros_programs.environment(cls.scratch.name)
        settings = yaml.safe_load(EXAMPLE.read_text(encoding='utf-8').replace(
            '$(find synthetic_dataset)', str(REPOSITORY)))
        settings.update(output_folder=str(folder / 'dataset'), if_exists='overwrite')
        cls.settings_file = folder / 'settings.yaml'
        cls.write(settings)
        cls.settings = settings
        subprocess.run([str(ros_programs.path_of('generate')), '--config', str(cls.settings_file),
                        'only_scenes:=[0, 1, %d]' % LAST], env=environ, check=True,
                       stdout=subprocess.DEVNULL, timeout=ros_programs.TIMEOUT)
        cls.images = {int(path.stem): path for path in folder.glob('dataset/coco/images/*.png')}
        rospy.init_node('preview_test')
        cls.jumps = rospy.Publisher('/preview/jump_to_instant', Int64, queue_size=4, latch=True)
        rospy.set_param('/preview/settings_file', str(cls.settings_file))
        cls.preview = subprocess.Popen([str(ros_programs.path_of('preview')), '__name:=preview'],
                                       env=environ)
        cls.status = Listener('/preview/status', String)
        cls.status.next(shows(0))

    @classmethod
    def tearDownClass(cls):
        cls.preview.terminate()
        cls.preview.wait(timeout=ros_programs.TIMEOUT)
        cls.scratch.cleanup()

    @classmethod
    def write(cls, settings):
        cls.settings_file.write_text(yaml.safe_dump(settings), encoding='utf-8')

    def call(self, service):
        rospy.wait_for_service('/preview/' + service, timeout=ros_programs.TIMEOUT)
        self.assertTrue(rospy.ServiceProxy('/preview/' + service, Trigger)().success)

    def jump(self, instant):
        self.status.forget()
        self.jumps.publish(instant)
        self.status.next(shows(instant))

    def expect_written_image(self, listener, instant):
        written = numpy.asarray(PIL.Image.open(self.images[instant]).convert('RGB'))[:, :, ::-1]
        shown = listener.next(lambda message: numpy.array_equal(pixels_of(message), written))
        self.assertEqual(shown.header.frame_id[:8], 'preview/')

    def test_images_are_those_that_are_written(self):
        self.jump(0)
        image = Listener('/preview/camera/image_raw', Image)
        self.expect_written_image(image, 0)
        self.call('step')
        self.expect_written_image(image, 1)
        self.jump(LAST)
        self.expect_written_image(image, LAST)
        self.jump(1)
        self.call('step_back')
        self.expect_written_image(image, 0)
        image.close()

    def test_labels_are_made_once_somebody_listens(self):
        self.jump(LAST)
        instances = Listener('/preview/camera/instances', Image)
        seen = numpy.unique(pixels_of(instances.next()))
        self.assertGreater(len(seen), 1)
        markers = Listener('/preview/labels', MarkerArray).next()
        names = {marker.text for marker in markers.markers if marker.text}
        self.assertEqual(len(names), len(seen) - 1)
        depth = Listener('/preview/camera/depth/image_raw', Image)
        metres = pixels_of(depth.next())
        self.assertGreater(numpy.nanmax(metres), 1.0)
        labelled = pixels_of(Listener('/preview/camera/image_labels', Image).next())
        plain = pixels_of(Listener('/preview/camera/image_raw', Image).next())
        self.assertFalse(numpy.array_equal(labelled, plain))

    def test_rviz_gets_frames_views_and_ways(self):
        self.jump(0)
        frames = Listener('/tf', TFMessage)
        self.jump(LAST)
        names = {each.child_frame_id for each in frames.next().transforms}
        for name in self.settings['robot_list']:
            self.assertIn('preview/' + name, names)
        self.assertEqual(len(Listener('/preview/views', MarkerArray).next().markers), 1)
        ways = Listener('/preview/ways', MarkerArray).next().markers[1:]
        self.assertTrue(all(len(way.points) > 10 for way in ways) and ways)
        info = Listener('/preview/camera/camera_info', CameraInfo).next()
        self.assertEqual((info.width, info.height), (640, 480))

    def test_rviz_is_told_where_to_look(self):
        self.jump(0)
        world = Listener('/preview/world', MarkerArray).next().markers[1:]
        self.assertTrue(any(marker.ns == 'world' and len(marker.points) == len(marker.colors) > 100 for marker in world))
        self.assertEqual({marker.header.frame_id for marker in world}, {'map'})
        self.jump(LAST)
        self.status.forget()
        self.call('pause')
        status = json.loads(self.status.next().data)
        self.assertEqual((status['frame'], status['cameras']), ('map', ['camera']))
        config = REPOSITORY / 'launch' / 'preview.rviz'
        fitted = runpy.run_path(str(REPOSITORY / 'scripts' / 'preview_rviz'))['fitted'](
            yaml.safe_load(config.read_text(encoding='utf-8')), status)
        view = fitted['Visualization Manager']['Views']['Current']
        self.assertEqual(list(view['Focal Point'].values()), status['middle'])
        self.assertGreater(view['Distance'], status['reach'])

    def test_keys_in_a_terminal_steer_it(self):
        self.jump(0)
        terminal, its_end = pty.openpty()
        with subprocess.Popen([str(ros_programs.path_of('preview_keys'))], stdin=its_end,
                              stdout=subprocess.PIPE, env=dict(os.environ, PYTHONUNBUFFERED='1')) as keys:
            while b'standing' not in keys.stdout.read1():
                pass  # from then on it knows the state
            for key, instant in ((b'n', 1), (b'\x1b[C', 2), (b'p', 1)):
                self.status.forget()
                os.write(terminal, key)
                self.status.next(shows(instant))
            os.write(terminal, b' ')
            self.status.next(lambda message: json.loads(message.data)['state'] == 'playing')
            os.write(terminal, b'q')
            keys.stdout.read()
            self.assertEqual(keys.wait(timeout=ros_programs.TIMEOUT), 0)
        self.call('pause')

    def test_it_plays_at_a_rate(self):
        self.jump(0)
        rate = rospy.Publisher('/preview/rate', Float64, queue_size=1, latch=True)
        rate.publish(100.0)
        self.call('play')
        self.status.next(shows(3))
        self.call('pause')

    def test_settings_are_read_anew(self):
        self.jump(0)
        self.write({**self.settings, 'world': str(REPOSITORY / 'no.world')})
        self.status.forget()
        self.call('reload')
        error = self.status.next(lambda message: json.loads(message.data)['state'] == 'error')
        self.assertIn('no.world', json.loads(error.data)['error'])
        self.write(self.settings)
        self.status.forget()
        self.call('reload')
        self.status.next(shows(0))


class Progress(unittest.TestCase):

    def test_of_a_run_is_published(self):
        with tempfile.TemporaryDirectory(prefix='synthetic_dataset_') as scratch:
            rospy.set_param('/generate/settings_file', str(EXAMPLE))
            rospy.set_param('/generate/output_folder', scratch + '/dataset')
            rospy.set_param('/generate/simulated_rate', 1.0)
            status = Listener('/generate/status', String)
            diagnostics = Listener('/diagnostics', DiagnosticArray)
            with subprocess.Popen([str(ros_programs.path_of('generate')), '__name:=generate'],
                                  env=ros_programs.environment(scratch),
                                  stdout=subprocess.DEVNULL) as node:
                done = json.loads(status.next().data)
                self.assertLessEqual(done['scenes_done'], done['scenes'])
                self.assertEqual(done['scenes'], 7)
                first = diagnostics.next().status[0]
                self.assertEqual(first.name, 'generate: dataset')
                self.assertIn('of 7 scenes', first.message)
                self.assertEqual(node.wait(timeout=ros_programs.TIMEOUT), 0)


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'preview_test', Preview)
    rosunit.unitrun('synthetic_dataset', 'progress_test', Progress)
