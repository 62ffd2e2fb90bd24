#!/usr/bin/env python3
"""Records robots drawn by PyBullet, lets `generate` label the pictures, and compares masks.

    foreign_pictures.py FOLDER

PyBullet's own segmentation is the truth. Exit code 1 where the median intersection over union of a
robot's masks is below LEAST.
"""
import math
import pathlib
import subprocess
import sys

import numpy as np
import pybullet
import pybullet_data
import rosbag
import rospy
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import CameraInfo, Image
from synthetic_dataset import Dataset
from tf2_msgs.msg import TFMessage

LEAST = 0.97
SCENES, PERIOD, START = 30, 0.1, 1000.0  # [s]
WIDTH, HEIGHT, FOCAL = 640, 480, 600.0  # [px]
NEAR, FAR = 0.05, 20.0  # [m]
# PyBullet's rasteriser samples at the pixels' lower left corners, and its picture is upside down.
CENTRE = (WIDTH / 2, HEIGHT / 2 - 1)
EYE, TARGET = np.array([-2.0, -0.9, 1.1]), np.array([0.0, 0.0, 0.3])
ROBOTS = {'husky': ('husky/husky.urdf', 0.15), 'arm': ('kuka_iiwa/model.urdf', 0.0),
          'quadruped': ('a1/a1.urdf', 0.4)}  # with the height of the base [m]


def optical_pose():
    """The pose of the camera's optical frame in the world: a rotation and a position."""
    ahead = (TARGET - EYE) / np.linalg.norm(TARGET - EYE)
    right = np.cross(ahead, [0, 0, 1])
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(ahead, right), ahead], axis=1), EYE


def quaternion_of(rotation):
    w = math.sqrt(max(0.0, 1 + np.trace(rotation))) / 2
    x, y, z = (rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0],
               rotation[1, 0] - rotation[0, 1])
    return np.array([x, y, z]) / (4 * w), w


def transform(stamp, parent, child, position, orientation):
    message = TransformStamped()
    message.header.stamp, message.header.frame_id, message.child_frame_id = stamp, parent, child
    (message.transform.translation.x, message.transform.translation.y,
     message.transform.translation.z) = position
    (message.transform.rotation.x, message.transform.rotation.y, message.transform.rotation.z,
     message.transform.rotation.w) = orientation
    return message


def place(robot, joints, height, seconds):
    """Moves the base on a circle while it turns, and each joint back and forth within its limits."""
    yaw = 0.8 * seconds
    position = [0.25 * math.cos(seconds), 0.25 * math.sin(seconds), height]
    orientation = pybullet.getQuaternionFromEuler([0.1 * math.sin(seconds), 0.05, yaw])
    local, turned = pybullet.getDynamicsInfo(robot, -1)[3:5]  # the inertial frame in the link
    pybullet.resetBasePositionAndOrientation(
        robot, *pybullet.multiplyTransforms(position, orientation, local, turned))
    for place_in_list, joint in enumerate(joints):
        low, high = pybullet.getJointInfo(robot, joint)[8:10]
        if low >= high:
            low, high = -1.0, 1.0
        share = 0.5 + 0.35 * math.sin(1.3 * seconds + place_in_list)
        pybullet.resetJointState(robot, joint, low + share * (high - low))
    return position, orientation


def picture(robot):
    rotation, eye = optical_pose()
    view = np.eye(4)
    view[:3, :3] = np.diag([1, -1, -1]) @ rotation.T
    view[:3, 3] = -view[:3, :3] @ eye
    projection = np.array([
        [2 * FOCAL / WIDTH, 0, 0, 0], [0, 2 * FOCAL / HEIGHT, 0, 0],
        [0, 0, -(FAR + NEAR) / (FAR - NEAR), -2 * FAR * NEAR / (FAR - NEAR)], [0, 0, -1, 0]])
    _, _, colours, _, ids = pybullet.getCameraImage(
        WIDTH, HEIGHT, list(view.T.ravel()), list(projection.T.ravel()),
        lightDirection=[-3, -2, 5], shadow=0, renderer=pybullet.ER_TINY_RENDERER)
    colours = np.reshape(colours, (HEIGHT, WIDTH, 4))[:, :, :3].astype(np.uint8)
    return colours, np.reshape(ids, (HEIGHT, WIDTH)) == robot


def record(urdf, height, bag):
    """@return the robot's mask in each picture"""
    pybullet.resetSimulation()
    robot = pybullet.loadURDF(urdf)
    infos = [pybullet.getJointInfo(robot, joint) for joint in range(pybullet.getNumJoints(robot))]
    joints = [info[0] for info in infos if info[2] != pybullet.JOINT_FIXED]
    base = pybullet.getBodyInfo(robot)[0].decode()
    masks = []
    calibration = CameraInfo()
    calibration.width, calibration.height = WIDTH, HEIGHT
    calibration.K = [FOCAL, 0, CENTRE[0], 0, FOCAL, CENTRE[1], 0, 0, 1]
    calibration.P = [FOCAL, 0, CENTRE[0], 0, 0, FOCAL, CENTRE[1], 0, 0, 0, 1, 0]
    calibration.R = list(np.eye(3).ravel())
    calibration.distortion_model, calibration.D = 'plumb_bob', [0.0] * 5
    calibration.header.frame_id = 'eye'
    bag.write('/camera_info', calibration, rospy.Time.from_sec(START))
    # TF continues for one more instant, as scenes end where TF ends.
    for scene in range(SCENES + 1):
        stamp = rospy.Time.from_sec(START + scene * PERIOD)
        frames = [transform(stamp, 'map', f'robot/{base}', *place(robot, joints, height, scene * PERIOD))]
        for info in infos:
            state = pybullet.getLinkState(robot, info[0], computeForwardKinematics=True)
            frames.append(transform(stamp, 'map', f'robot/{info[12].decode()}', state[4], state[5]))
        rotation, eye = optical_pose()
        vector, w = quaternion_of(rotation)
        frames.append(transform(stamp, 'map', 'eye', eye, [*vector, w]))
        bag.write('/tf', TFMessage(frames), stamp)
        if scene == SCENES:
            break
        colours, mask = picture(robot)
        masks.append(mask)
        image = Image()
        image.header.stamp, image.width, image.height = stamp, WIDTH, HEIGHT
        image.encoding, image.step, image.data = 'rgb8', 3 * WIDTH, colours.tobytes()
        bag.write('/camera/image_raw', image, stamp)
    return base, masks


def settings(folder, urdf, base):
    repository = pathlib.Path(__file__).resolve().parents[2]
    return f'''
bag_file: {folder}/robot.bag
world: {repository}/worlds/ground.sdf
camera: {{info_topic: /camera_info, image_topic: /camera/image_raw}}
robot_list: [robot]
robot: {{class: robot, id: robot, frame_id: {base}, model: {urdf}}}
max_tf_gap: .inf
output_folder: {folder}/dataset
if_exists: overwrite
writers: [{{name: images, type: synthetic_dataset/ImageFolder}}]
'''


def overlap(a, b):
    return np.count_nonzero(a & b) / max(1, np.count_nonzero(a | b))


def main(folder):
    pybullet.connect(pybullet.DIRECT)
    pybullet.setAdditionalSearchPath(pybullet_data.getDataPath())
    failed = False
    for name, (urdf, height) in ROBOTS.items():
        urdf = pathlib.Path(pybullet_data.getDataPath()) / urdf
        below = pathlib.Path(folder).resolve() / name
        below.mkdir(parents=True, exist_ok=True)
        with rosbag.Bag(str(below / 'robot.bag'), 'w') as bag:
            base, masks = record(str(urdf), height, bag)
        (below / 'settings.yaml').write_text(settings(below, urdf, base), encoding='utf-8')
        with open(below / 'log', 'w', encoding='utf-8') as log:
            subprocess.run(['rosrun', 'synthetic_dataset', 'generate', '--config',
                            str(below / 'settings.yaml')], check=True, stdout=log, stderr=log)
        scenes = list(Dataset(below / 'dataset'))
        found = [overlap(scene.objects[0].mask, masks[scene.index]) for scene in scenes]
        alignment = np.median([scene.alignment for scene in scenes])
        print(f'{name}: {len(found)} pictures, intersection over union {np.median(found):.4f} '
              f'(median), {min(found):.4f} (least); alignment {alignment:.3f}')
        failed |= len(found) != SCENES or np.median(found) < LEAST
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
