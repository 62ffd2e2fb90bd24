#!/usr/bin/env python3
"""Scans worlds of the reference data, and compares each ray with Gazebo 11's (test/reference/gazebo_scans, see record.py).

usage: compare.py REFERENCE_FOLDER OUT [NAME...]

A ray agrees within 2 cm. The rays of `gpu_ray` are read from pictures of 2048 columns: they also agree if a range within
half a pixel does; the share that agrees without this is in brackets. With `ray`, Gazebo's rays hit collision shapes and
ours visuals: this share is only shown, except for worlds in which both are the same. Source a workspace first. OUT gets the
runs and table.txt. Exit code 0 if at least 99 % of the rays agree in each world (exceptions: ENOUGH_IN).
"""
import os
import pathlib
import shutil
import subprocess
import sys

import numpy as np
import rosbag
from sensor_msgs import point_cloud2

import scanner

SCANS = pathlib.Path(__file__).resolve().parents[2] / 'test/reference/gazebo_scans'
NEAR = 0.02  # [m]
ENOUGH = 0.99
# In this world, Gazebo 11 halves the steps of the heightmap's picture and splits the cells along their other diagonal.
ENOUGH_IN = {'rotors_simulator/outdoor': 0.975}
# Three pictures of 2048 pixels each cover the turn (GpuRaySensor.cc): this is half of a pixel in the middle of one [rad].
HALF_PIXEL = np.tan((scanner.AZIMUTHS[1] - scanner.AZIMUTHS[0]) / 6) / 2048
# Worlds whose collision shapes equal the visuals around the scanner.
SAME_SHAPES = ('pal_gazebo_worlds/pal_office', 'pal_gazebo_worlds/simple_office_with_people', 'pal_gazebo_worlds/factory',
               'pal_gazebo_worlds/home', 'pal_gazebo_worlds/hospital', 'rotors_simulator/powerplant',
               'rotors_simulator/test_city')
AROUND = [(turn, tilt) for turn in (0, -HALF_PIXEL, HALF_PIXEL) for tilt in (0, -HALF_PIXEL, HALF_PIXEL)]

CAMERA = '''image_width: 64
image_height: 48
distortion_model: plumb_bob
camera_matrix: {rows: 3, cols: 3, data: [40, 0, 32, 0, 40, 24, 0, 0, 1]}
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
'''
MARKER = ('<sdf version="1.6"><model name="m"><link name="l"><visual name="v"><geometry><box><size>0.01 0.01 0.01</size></box>'
          '</geometry></visual></link></model></sdf>')


def settings(out, world, lidars):
    """A scene with nothing but the world: the camera and the object that a run needs are far above it."""
    return f'''motion: placement
placement: {{mode: volume, orientation: upright, volume: {{min: [-1, -1, 900], max: [1, 1, 901]}}}}
scenes: 1
seed: 1
simulated_rate: 5.0
world: {{file: "{world}", on_missing_asset: warn}}
camera: {{info_file: "{out}/camera.yaml", pose: [0, 0, 1000, 0, 0, 0, 1]}}
labels: {{glass: solid}}
robot_list: [marker]
marker: {{class: marker, id: 1, model: "{out}/marker.sdf"}}
lidars: {{{", ".join(f'{name}: {{sensor: "scanner::link::{name}", noise: 0.0}}' for name in lidars)}}}
writers: [{{name: ros_bag, type: synthetic_dataset/RosBag}}]
output_folder: "{out}/dataset"
if_exists: overwrite
'''


def scan(name, reference, out, look):
    """The ranges of each of our scanners by name: `ray`, and gpu_ray0, ... around the directions of gpu_ray."""
    sensors = {'ray': scanner.sensor('ray', 'ray')}
    for i, directions in enumerate(AROUND):
        sensors[f'gpu_ray{i}'] = scanner.sensor('gpu_ray', f'gpu_ray{i}', *directions)
    file = pathlib.Path(scanner.world_file(f'{reference}/worlds', name))
    root = f'{reference}/worlds/{name.split("/")[0]}'
    models, packages = look.paths(root)
    out.mkdir(parents=True)
    # The relative paths of the world start in its own folder, where nothing is written.
    world = out / 'scene.world'
    world.write_text(scanner.with_scanners(file.read_text(errors='replace'), scanner.PLACES[name], sensors.values()))
    (out / 'camera.yaml').write_text(CAMERA)
    (out / 'marker.sdf').write_text(MARKER)
    (out / 'settings.yaml').write_text(settings(out, world, sensors))
    environment = dict(os.environ, GAZEBO_MODEL_PATH=':'.join(models), SDF_PATH=':'.join(models),
                       GAZEBO_RESOURCE_PATH=':'.join([*packages, str(file.parent)]))
    with open(out / 'log.txt', 'w') as log:
        subprocess.run(['rosrun', 'synthetic_dataset', 'generate', '--config', str(out / 'settings.yaml')], check=True,
                       stdout=log, stderr=log, env=environment)
    with rosbag.Bag(str(out / 'dataset/ros_bag/dataset.bag')) as bag:
        clouds = {topic.split('/')[1]: list(point_cloud2.read_points(message, field_names=('x', 'y', 'z')))
                  for topic, message, _ in bag.read_messages() if topic.endswith('/points')}
    return {each: scanner.whole_ranges(np.linalg.norm(points, axis=1)) for each, points in clouds.items()}


def compare(name, ours):
    """Shares of rays that agree: for `ray`, for `gpu_ray`, and for `gpu_ray` without the half pixel."""
    theirs = np.load(SCANS / f'{name.replace("/", "__")}.npz')
    ray, gpu_ray = theirs['ray'] / 1000, theirs['gpu_ray'] / 1000
    around = np.stack([ours[f'gpu_ray{i}'] for i in range(len(AROUND))])
    within = (gpu_ray > around.min(axis=0) - NEAR) & (gpu_ray < around.max(axis=0) + NEAR)
    return (np.mean(np.abs(ours['ray'] - ray) < NEAR), np.mean(within), np.mean(np.abs(around[0] - gpu_ray) < NEAR))


def main():
    reference = os.path.realpath(sys.argv[1])
    out = pathlib.Path(sys.argv[2]).resolve()
    sys.path.insert(0, f'{reference}/gazebo')
    import look  # from the reference data: finds the folders of models and packages

    lines, agreeing = [], 0
    names = sys.argv[3:] or list(scanner.PLACES)
    for name in names:
        shutil.rmtree(out / name, ignore_errors=True)
        ray, gpu_ray, direct = compare(name, scan(name, reference, out / name, look))
        agrees = gpu_ray >= ENOUGH_IN.get(name, ENOUGH) and (ray >= ENOUGH or name not in SAME_SHAPES)
        agreeing += agrees
        lines.append(f'{"agrees " if agrees else "DIFFERS"} {name:46} gpu_ray {100 * gpu_ray:6.2f} % '
                     f'({100 * direct:6.2f} %)  ray {100 * ray:6.2f} %')
        print(lines[-1], flush=True)
    lines.append(f'{agreeing} of {len(names)} worlds agree')
    print(lines[-1])
    (out / 'table.txt').write_text('\n'.join(lines) + '\n')
    sys.exit(0 if agreeing == len(names) else 1)


if __name__ == '__main__':
    main()
