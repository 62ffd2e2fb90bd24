"""The tiny job that faults happen to: a recording, a world, cameras and a settings file."""
import pathlib
from typing import Any, Dict, NamedTuple, Sequence

import genpy
import rosbag
import yaml
from geometry_msgs.msg import TransformStamped
from tf2_msgs.msg import TFMessage

START = 1000  # [s] since the epoch
NANOSECONDS = 10 ** 9
CHUNK = 2048  # [bytes]: small, so that a short recording has many

# Things are in each other's way: `alpha` pushes the ball and topples the post, so a scene's
# picture depends on all times before it; nothing holds `stray`, and scenes warn that it falls.
WORLD = '''<sdf version="1.6"><world name="tiny">
<light name="sun" type="directional"><cast_shadows>true</cast_shadows>
  <direction>0.3 0.4 -1</direction><diffuse>0.8 0.8 0.8 1</diffuse></light>
<model name="floor"><static>true</static><link name="body"><pose>0 0 -0.1 0 0 0</pose>
  <collision name="slab"><geometry><box><size>8 8 0.2</size></box></geometry></collision>
  <visual name="slab"><geometry><box><size>8 8 0.2</size></box></geometry>
    <material><diffuse>0.6 0.6 0.6 1</diffuse></material></visual></link></model>
<model name="ball"><pose>0.05 -0.2 0.1 0 0 0</pose><link name="body">
  <inertial><mass>0.2</mass>
    <inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz></inertia></inertial>
  <collision name="skin"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>
  <visual name="skin"><geometry><sphere><radius>0.1</radius></sphere></geometry></visual>
</link></model>
<model name="post"><pose>-0.1 0.35 0.3 0 0 0</pose><link name="body">
  <inertial><mass>0.3</mass>
    <inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.001</izz></inertia></inertial>
  <collision name="box"><geometry><box><size>0.1 0.1 0.6</size></box></geometry></collision>
  <visual name="box"><geometry><box><size>0.1 0.1 0.6</size></box></geometry>
    <material><diffuse>0.2 0.7 0.2 1</diffuse></material></visual></link></model>
<model name="stray"><pose>30 30 0.5 0 0 0</pose><link name="body">
  <inertial><mass>0.2</mass>
    <inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz></inertia></inertial>
  <visual name="skin"><geometry><sphere><radius>0.1</radius></sphere></geometry></visual>
  <collision name="skin"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>
</link></model>
%s</world></sdf>
'''

# The box spans the bounding shape: 0.4 m wide, from the ground up.
MODEL = '''<model name="%s"><link name="body"><pose>0 0 0.2 0 0 0</pose>
  <collision name="c"><geometry><box><size>0.4 0.4 0.4</size></box></geometry></collision>
  <visual name="v"><geometry><box><size>0.4 0.4 0.4</size></box></geometry>
    <material><diffuse>%s 1</diffuse></material></visual></link></model>
'''

COLOURS = {'alpha': '0.9 0.2 0.1', 'bravo': '0.1 0.3 0.9'}


class Size(NamedTuple):
    """The size of a job."""

    instants: int        # times for which scenes are made
    rate: float          # of these [Hz]
    width: int           # of a picture [px]
    height: int          # [px]


SMALL = Size(instants=12, rate=8.0, width=96, height=64)


def camera_text(size: Size) -> str:
    focal = 0.875 * size.width
    matrix = [focal, 0, (size.width - 1) / 2, 0, focal, (size.height - 1) / 2, 0, 0, 1]
    return yaml.safe_dump({
        'image_width': size.width, 'image_height': size.height,
        'camera_matrix': {'rows': 3, 'cols': 3, 'data': matrix},
        'distortion_model': 'plumb_bob',
        'distortion_coefficients': {'rows': 1, 'cols': 5, 'data': [0, 0, 0, 0, 0]}})


def _transform(child: str, nanoseconds: int, x: float, y: float) -> TransformStamped:
    message = TransformStamped()
    message.header.stamp = genpy.Time(START) + genpy.Duration(0, nanoseconds)
    message.header.frame_id = 'map'
    message.child_frame_id = child
    message.transform.translation.x = x
    message.transform.translation.y = y
    message.transform.rotation.w = 1.0
    return message


def write_recording(path: pathlib.Path, seconds: float, rate: float, way: float = 1.2,
                    chunk: int = CHUNK) -> None:
    """`bravo` stands; `alpha` drives `way` metres, at the rate [Hz] of its transforms."""
    with rosbag.Bag(str(path), 'w', chunk_threshold=chunk) as bag:
        stands = _transform('bravo/base_link', 0, 0.3, 0.9)
        bag.write('/tf_static', TFMessage([stands]), stands.header.stamp)
        count = round(seconds * rate)
        for k in range(count + 1):
            moves = _transform('alpha/base_link', round(k * NANOSECONDS / rate), 0.0,
                               -0.6 + way * k / count)
            bag.write('/tf', TFMessage([moves]), moves.header.stamp)


def object_settings(name: str) -> Dict[str, Any]:
    corners = [[x, y, z] for x in (-0.2, 0.2) for y in (-0.2, 0.2) for z in (0.0, 0.4)]
    return {'class': 'box', 'id': name, 'bounding_shape': corners,
            'keypoints': {'farthest_points': 4}}


def settings(inputs: pathlib.Path, size: Size) -> Dict[str, Any]:
    """Noise, splits and physics: all that depends on the seed or on earlier times."""
    # In front of the objects and above the ground, looking along the global +x.
    upright = [-0.5, 0.5, -0.5, 0.5]
    camera = {'info_file': str(inputs / 'camera.yaml'),
              'effects': {'noise_stddev': 0.01, 'full_well': 10000}}
    return {
        'bag_file': str(inputs / 'recording.bag'),
        'simulated_rate': size.rate,
        'world': str(inputs / 'tiny.world'),
        'cameras': {'front': {**camera, 'pose': [-2.5, 0.1, 0.5, *upright]},
                    'high': {**camera, 'pose': [-2.0, 0.3, 0.9, *upright]}},
        'robot_list': ['alpha', 'bravo'],
        'alpha': object_settings('alpha'),
        'bravo': object_settings('bravo'),
        'physics': {'settle': 0.5},
        'rendering': {'samples': 1, 'shadow_map_size': 128, 'shadow_distance': 8.0},
        'split': {'train': 0.7, 'val': 0.3, 'by': 'scenes'},
        'seed': 7,
        'writers': [{'name': name, 'type': f'synthetic_dataset/{kind}'} for name, kind in (
            ('coco', 'Coco'), ('yolo', 'Yolo'), ('pvnet', 'PvNet'), ('bag', 'RosBag'))],
        'yolo': {'main_list': 'list.txt'},
    }


def world_text(names: Sequence[str] = tuple(COLOURS)) -> str:
    return WORLD % ''.join(MODEL % (name, COLOURS[name]) for name in names)


def write_inputs(inputs: pathlib.Path, size: Size = SMALL) -> pathlib.Path:
    """Makes all files of the job in a folder; returns the settings file."""
    inputs.mkdir(parents=True, exist_ok=True)
    (inputs / 'tiny.world').write_text(world_text(), encoding='ascii')
    (inputs / 'camera.yaml').write_text(camera_text(size), encoding='ascii')
    write_recording(inputs / 'recording.bag', seconds=size.instants / size.rate, rate=40.0)
    config = inputs / 'settings.yaml'
    config.write_text(yaml.safe_dump(settings(inputs, size)), encoding='ascii')
    return config
