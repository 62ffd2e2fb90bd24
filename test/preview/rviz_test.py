#!/usr/bin/env python3
"""What a user of preview.launch sees: RViz, on a display in memory, shows the picture of the scene, and another one
after a jump.

  rviz_test.py FOLDER      FOLDER gets the screenshots
"""
import contextlib
import json
import os
import pathlib
import queue
import subprocess
import sys
import time
import unittest

import cv2
import numpy
import rosgraph
import rospy
from sensor_msgs.msg import Image
from std_msgs.msg import Int64, String

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
PICTURE = '/preview/camera/image_labels'  # as in preview.rviz
FOLDER = pathlib.Path(sys.argv.pop() if len(sys.argv) > 1 else '.')
PATIENCE = 120.0  # [s] until RViz has started and drawn
ALIKE = 0.8  # correlation of a picture with its place on the screen, in a small panel without smoothing


@contextlib.contextmanager
def program(*command, **options):
    with subprocess.Popen([str(each) for each in command], **options) as started:
        try:
            yield started
        finally:
            started.terminate()
            try:
                started.wait(timeout=20)
            except subprocess.TimeoutExpired:
                started.kill()


def screen(file):
    subprocess.run(['import', '-window', 'root', str(file)], check=True)
    return cv2.imread(str(file))


def likeness(picture, shown):
    """The best correlation of a picture, in any size that a panel may have, with a part of the screen."""
    best = -1.0
    shown = shown[:, :600]  # the panels at the left
    for width in range(400, 600, 2):
        height = round(width * picture.shape[0] / picture.shape[1])
        if height > shown.shape[0] or width > shown.shape[1]:
            break
        small = cv2.resize(picture, (width, height), interpolation=cv2.INTER_AREA)
        best = max(best, cv2.matchTemplate(shown, small, cv2.TM_CCOEFF_NORMED).max())
    return best


def awaited(topic, kind, fits):
    found = queue.Queue()
    subscriber = rospy.Subscriber(topic, kind, found.put)
    try:
        while True:
            message = found.get(timeout=PATIENCE)
            if fits(message):
                return message
    finally:
        subscriber.unregister()


def picture_of(message):
    pixels = numpy.frombuffer(message.data, numpy.uint8)
    return pixels.reshape(message.height, message.step)[:, :3 * message.width].reshape(
        message.height, message.width, 3)


class RViz(unittest.TestCase):
    def shows(self, picture, name):
        """RViz draws when it has time, so the screen is polled until it shows the picture."""
        end = time.monotonic() + PATIENCE
        best = 0.0
        while best < ALIKE and time.monotonic() < end:
            self.assertIsNone(self.launch.poll(), 'roslaunch has ended')
            best = likeness(picture, screen(FOLDER / f'{name}.png'))
        self.assertGreater(best, ALIKE, f'{name}.png does not show the picture')
        return best

    def test_shows_the_scene_and_the_one_that_is_jumped_to(self):
        with program('roslaunch', 'synthetic_dataset', 'preview.launch',
                     f'config:={REPOSITORY}/config/example.yaml') as self.launch:
            deadline = time.monotonic() + PATIENCE
            while not rosgraph.is_master_online():
                self.assertIsNone(self.launch.poll(), 'roslaunch has ended')
                self.assertLess(time.monotonic(), deadline, 'no ROS master')
            rospy.init_node('rviz_test', disable_signals=True)
            first = picture_of(awaited(PICTURE, Image, lambda message: True))
            self.shows(first, 'first')

            jump = rospy.Publisher('/preview/jump_to_instant', Int64, queue_size=1, latch=True)
            jump.publish(20)
            awaited('/preview/status', String,
                    lambda message: json.loads(message.data).get('instant') == 20)
            later = picture_of(awaited(
                PICTURE, Image, lambda message: not numpy.array_equal(picture_of(message), first)))
            after = self.shows(later, 'later')
            # Two scenes of one hall are similar; the screen has to be more like the current one.
            self.assertGreater(after, likeness(first, cv2.imread(str(FOLDER / 'later.png'))))


if __name__ == '__main__':
    read, write = os.pipe()
    server = ['Xvfb', '-displayfd', str(write), '-screen', '0', '1600x1000x24', '-nolisten', 'tcp']
    with program(*server, pass_fds=[write], stderr=subprocess.DEVNULL):
        os.close(write)
        with os.fdopen(read) as number:
            os.environ['DISPLAY'] = ':' + number.readline().strip()
        os.environ['LIBGL_ALWAYS_SOFTWARE'] = '1'
        unittest.main(verbosity=2)
