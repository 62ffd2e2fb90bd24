"""Datasets from ROS 2 bags, written by rosbags with the message types of ROS 2 Humble."""
import pathlib
import sqlite3
import subprocess
import tempfile
import unittest

import numpy
from rosbags.rosbag2 import Writer
from rosbags.rosbag2.enums import StoragePlugin
from rosbags.typesys import Stores, get_typestore

STORE = get_typestore(Stores.ROS2_HUMBLE)
START_NS = 100 * 10**9
PERIOD_NS = 10**8
COUNT = 21

WORLD = """<sdf version="1.6"><world name="w"><light name="sun" type="directional">
<direction>0.3 0.4 -1</direction></light><model name="cup"><link name="body"><visual name="v">
<geometry>
<box><size>0.4 0.4 0.4</size></box></geometry></visual></link></model></world></sdf>"""
SETTINGS = """bag_file: {bag}
simulated_rate: 2
global_frame: map
world: {folder}/w.world
camera: {{info_topic: /camera_info, pose: [0, 0, 0, -0.5, 0.5, -0.5, 0.5]}}
robot_list: [cup]
cup: {{class: cup, id: 1, frame: cup}}
writers: [{{name: coco, type: synthetic_dataset/Coco}}]
output_folder: {folder}/out
"""


def message(kind, **fields):
    """A ROS 2 message of a type such as "geometry_msgs/Pose"."""
    package, name = kind.split('/')
    return STORE.types[f'{package}/msg/{name}'](**fields)


def header(stamp_ns, frame):
    stamp = message('builtin_interfaces/Time', sec=stamp_ns // 10**9, nanosec=stamp_ns % 10**9)
    return message('std_msgs/Header', stamp=stamp, frame_id=frame)


def x_at(stamp_ns):
    return 3.0 + (stamp_ns - START_NS) * 1e-9


def tf_at(stamp_ns):
    transform = message(
        'geometry_msgs/Transform',
        translation=message('geometry_msgs/Vector3', x=x_at(stamp_ns), y=0.0, z=0.0),
        rotation=message('geometry_msgs/Quaternion', x=0.0, y=0.0, z=0.0, w=1.0))
    stamped = message('geometry_msgs/TransformStamped', header=header(stamp_ns, 'map'),
                      child_frame_id='cup', transform=transform)
    return message('tf2_msgs/TFMessage', transforms=[stamped])


def odometry_at(stamp_ns):
    """The pose of tf_at as odometry."""
    zero = message('geometry_msgs/Vector3', x=0.0, y=0.0, z=0.0)
    pose = message('geometry_msgs/Pose',
                   position=message('geometry_msgs/Point', x=x_at(stamp_ns), y=0.0, z=0.0),
                   orientation=message('geometry_msgs/Quaternion', x=0.0, y=0.0, z=0.0, w=1.0))
    twist = message('geometry_msgs/Twist', linear=zero, angular=zero)
    return message(
        'nav_msgs/Odometry', header=header(stamp_ns, 'map'), child_frame_id='cup',
        pose=message('geometry_msgs/PoseWithCovariance', pose=pose, covariance=numpy.zeros(36)),
        twist=message('geometry_msgs/TwistWithCovariance', twist=twist,
                      covariance=numpy.zeros(36)))


def camera_at(stamp_ns):
    k = [140.0, 0, 79.5, 0, 140.0, 59.5, 0, 0, 1]
    roi = message('sensor_msgs/RegionOfInterest', x_offset=0, y_offset=0, height=0, width=0,
                  do_rectify=False)
    return message('sensor_msgs/CameraInfo', header=header(stamp_ns, 'camera'), height=120,
                   width=160, distortion_model='plumb_bob', d=numpy.zeros(5), k=numpy.array(k),
                   r=numpy.eye(3).ravel(), p=numpy.zeros(12), binning_x=0, binning_y=0, roi=roi)


def write_bag(folder, plugin, moving):
    """A bag in which a cup moves away from the camera by 1 m/s."""
    kinds = {'/camera_info': ('sensor_msgs/msg/CameraInfo', camera_at), '/tf':
             ('tf2_msgs/msg/TFMessage', tf_at), '/odom': ('nav_msgs/msg/Odometry', odometry_at)}
    with Writer(folder, version=9, storage_plugin=plugin) as writer:
        for topic in ('/camera_info', moving):
            kind, make = kinds[topic]
            connection = writer.add_connection(topic, kind, typestore=STORE)
            for i in range(COUNT):
                stamp = START_NS + i * PERIOD_NS
                writer.write(connection, stamp, STORE.serialize_cdr(make(stamp), kind))


class Ros2BagTest(unittest.TestCase):
    def generate(self, bag):
        settings = self.folder / 'settings.yaml'
        settings.write_text(SETTINGS.format(bag=bag, folder=self.folder))
        return subprocess.run(['rosrun', 'synthetic_dataset', 'generate', '--config', settings],
                              capture_output=True, text=True, check=False)

    def check(self, plugin, moving, of_file):
        with tempfile.TemporaryDirectory() as name:
            self.folder = pathlib.Path(name)
            (self.folder / 'w.world').write_text(WORLD)
            bag = self.folder / 'walk'
            write_bag(bag, plugin, moving)
            if of_file:
                bag = next(file for file in bag.iterdir() if file.suffix in ('.db3', '.mcap'))
            done = self.generate(bag)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            manifest = sqlite3.connect(self.folder / 'out' / 'manifest.sqlite')
            poses = manifest.execute('SELECT stamp_ns, scene_object.x FROM scene JOIN scene_object '
                                     'ON scene."index" = scene').fetchall()
            self.assertEqual(len(poses), 4)
            for stamp, x in poses:
                self.assertAlmostEqual(x, x_at(stamp), places=6)
            manifest.close()

    def test_a_database_becomes_a_dataset(self):
        self.check(StoragePlugin.SQLITE3, '/tf', of_file=True)

    def test_a_folder_becomes_a_dataset(self):
        self.check(StoragePlugin.SQLITE3, '/odom', of_file=False)

    def test_mcap_becomes_a_dataset(self):
        self.check(StoragePlugin.MCAP, '/tf', of_file=True)
