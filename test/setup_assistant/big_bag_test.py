"""A recording of 100,000 transforms of 200 frames: the page stays quick."""
import pathlib
import shutil
import sys
import tempfile
import time
import unittest

import geometry_msgs.msg
import rosbag
import rospy
import tf2_msgs.msg
from selenium.webdriver.common.keys import Keys

from assistant import Assistant, Page, chromium

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
FRAMES = 200
INSTANTS = 500
LONGEST = 2.0  # [s] from a click until the page has changed


def write(path):
    with rosbag.Bag(str(path), 'w') as bag:
        for instant in range(INSTANTS):
            now = rospy.Time(1000 + instant // 10, instant % 10 * 100000000)
            message = tf2_msgs.msg.TFMessage()
            for frame in range(FRAMES):
                transform = geometry_msgs.msg.TransformStamped()
                transform.header.stamp = now
                transform.header.frame_id = 'map'
                transform.child_frame_id = f'robot_{frame}/base_link'
                transform.transform.translation.x = 0.01 * instant
                transform.transform.translation.y = float(frame)
                transform.transform.rotation.w = 1.0
                message.transforms.append(transform)
            bag.write('/tf', message, now)


class BigBag(unittest.TestCase):

    def test_does_not_slow_the_page_down(self):
        folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, folder)
        write(folder / 'big.bag')
        file = folder / 'mine.yaml'
        file.write_text(f'bag_file: {folder}/big.bag\noutput_folder: {folder}/dataset\n', 'utf-8')
        assistant = Assistant(file, '--folder', PACKAGE / 'worlds')
        self.addCleanup(assistant.stop)
        driver = chromium()
        self.addCleanup(driver.quit)
        page = Page(driver)
        page.open(assistant.whole_address)
        page.wait(lambda: len(page.all('.timeline-row')) == FRAMES + 1, 'all frames')
        page.go('objects')
        page.wait(lambda: len(page.all('.candidates li')) == FRAMES, 'all candidates')
        for pane in ['recording', 'objects', 'output', 'recording']:
            begin = time.monotonic()
            page.go(pane)
            self.assertLess(time.monotonic() - begin, LONGEST, pane)
        begin = time.monotonic()
        page.type('simulated_rate', '2')
        self.assertLess(time.monotonic() - begin, LONGEST)
        page.input('simulated_rate').send_keys(Keys.ESCAPE)
        self.assertEqual(page.complaints(), [])


if __name__ == '__main__':
    unittest.main(argv=sys.argv[:1], verbosity=2)
