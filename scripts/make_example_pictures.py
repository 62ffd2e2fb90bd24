#!/usr/bin/env python3
"""Makes worlds/example_pictures.bag: the recording of a camera in the bundled example's hall.

`generate` draws the pictures and depth images, from the example's world and recording. The camera's clock is
37 ms late, the camera is turned by one degree from its pose in TF, and the hall has a visitor who is not in the
example's world; config/example_twin.yaml labels the pictures nevertheless. Run it again after changing the
example; needs a built workspace that has been sourced, and otherwise only ROS's rosbag and sensor_msgs.
"""
import math
import pathlib
import sqlite3
import subprocess
import tempfile

import genpy
import rosbag
from sensor_msgs.msg import CameraInfo, CompressedImage

REPOSITORY = pathlib.Path(__file__).resolve().parents[1]
LATE = genpy.Duration(0, 37000000)
TURN = math.radians(1.0)  # about the camera's y axis
COLOUR = (640, 480, 474.0)  # width, height [px], focal length [px]
DEPTH = (320, 240, 237.0)
RATE = 0.8  # [Hz]

VISITOR = '''
<model name="visitor"><static>true</static><pose>1.35 -1.35 0 0 0 0.5</pose><link name="body">
  <visual name="legs"><pose>0 0 0.42 0 0 0</pose><geometry><box><size>0.18 0.30 0.84</size></box></geometry>
    <material><ambient>0.10 0.12 0.20 1</ambient><diffuse>0.15 0.18 0.30 1</diffuse></material></visual>
  <visual name="coat"><pose>0 0 1.10 0 0 0</pose><geometry><box><size>0.24 0.44 0.60</size></box></geometry>
    <material><ambient>0.45 0.20 0.10 1</ambient><diffuse>0.60 0.27 0.12 1</diffuse></material></visual>
  <visual name="head"><pose>0 0 1.55 0 0 0</pose><geometry><sphere><radius>0.12</radius></sphere></geometry>
    <material><ambient>0.55 0.42 0.34 1</ambient><diffuse>0.70 0.54 0.44 1</diffuse></material></visual>
</link></model>
'''

SETTINGS = '''
include: "{repository}/config/example.yaml"
world: {{file: "{world}", model_folders: ["{repository}/worlds/models"]}}
camera:
  info_file: "{calibration}"
  correction: [0, 0, 0, 0, {sine}, 0, {cosine}]
  effects: {effects}
simulated_rate: {rate}
output_folder: "{folder}"
{writer}
image: {{jpeg_quality: 65}}
'''

YOLO = '''writers: [{name: pictures, type: synthetic_dataset/UltralyticsYolo}]
pictures: {task: detect, image_format: jpg}'''
BOP = 'writers: [{name: depths, type: synthetic_dataset/Bop}]'

CALIBRATION = '''
image_width: {width}
image_height: {height}
camera_matrix: {{rows: 3, cols: 3, data: [{f}, 0, {cx}, 0, {f}, {cy}, 0, 0, 1]}}
distortion_model: plumb_bob
distortion_coefficients: {{rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}}
'''


def generate(scratch, name, camera, writer, effects):
    """Makes a dataset with a camera, and returns its folder."""
    width, height, focal = camera
    world = (REPOSITORY / 'worlds' / 'example.sdf').read_text('utf-8')
    (scratch / 'visited.sdf').write_text(world.replace('</world>', VISITOR + '</world>'), 'utf-8')
    calibration = scratch / f'{name}_camera.yaml'
    calibration.write_text(CALIBRATION.format(
        width=width, height=height, f=focal, cx=(width - 1) / 2, cy=(height - 1) / 2), 'utf-8')
    settings = scratch / f'{name}.yaml'
    settings.write_text(SETTINGS.format(
        repository=REPOSITORY, world=scratch / 'visited.sdf', calibration=calibration,
        sine=math.sin(TURN / 2), cosine=math.cos(TURN / 2), effects=effects, rate=RATE,
        folder=scratch / name, writer=writer), 'utf-8')
    program = subprocess.run(['catkin_find', '--first-only', '--libexec', 'synthetic_dataset',
                              'generate'], stdout=subprocess.PIPE, universal_newlines=True,
                             check=True).stdout.strip()
    subprocess.run([program, '--config', str(settings)], check=True)
    return scratch / name


def camera_info(camera, stamp):
    width, height, focal = camera
    info = CameraInfo(width=width, height=height, distortion_model='plumb_bob', D=[0.0] * 5)
    cx, cy = (width - 1) / 2, (height - 1) / 2
    info.K = [focal, 0, cx, 0, focal, cy, 0, 0, 1]
    info.R = [1, 0, 0, 0, 1, 0, 0, 0, 1]
    info.P = [focal, 0, cx, 0, 0, focal, cy, 0, 0, 0, 1, 0]
    return stamped(info, stamp)


def stamps_of(dataset):
    with sqlite3.connect(str(dataset / 'manifest.sqlite')) as manifest:
        return [genpy.Time(0, nanoseconds) for nanoseconds, in manifest.execute(
            'SELECT stamp_ns FROM scene ORDER BY "index"')]


def stamped(message, stamp):
    message.header.stamp = stamp
    message.header.frame_id = 'camera/optical_link'
    return message


def main():
    with tempfile.TemporaryDirectory(prefix='synthetic_dataset_') as folder:
        scratch = pathlib.Path(folder)
        colour = generate(scratch, 'colour', COLOUR, YOLO,
                          '{blur: 0.6, noise_stddev: 0.01, exposure: 0.3}')
        depth = generate(scratch, 'depth', DEPTH, BOP, '{}')
        pictures = sorted(colour.glob('**/*.jpg'))
        depths = sorted(depth.glob('**/depth/*.png'))
        stamps = stamps_of(colour)
        assert len(pictures) == len(depths) == len(stamps), (pictures, depths)
        with rosbag.Bag(str(REPOSITORY / 'worlds' / 'example_pictures.bag'), 'w') as bag:
            for taken, picture, metres in zip(stamps, pictures, depths):
                stamp = taken + LATE

                def write(topic, message, stamp=stamp):
                    bag.write('/camera/' + topic, stamped(message, stamp), stamp)

                write('color/camera_info', camera_info(COLOUR, stamp))
                write('color/image_raw/compressed', CompressedImage(
                    format='bgr8; jpeg compressed bgr8', data=picture.read_bytes()))
                write('depth/camera_info', camera_info(DEPTH, stamp))
                write('depth/image_raw/compressedDepth', CompressedImage(
                    format='16UC1; compressedDepth png', data=bytes(12) + metres.read_bytes()))


if __name__ == '__main__':
    main()
