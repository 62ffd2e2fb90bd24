#!/usr/bin/env python3
"""Measures the time to the first scene: a run of one scene for each public world and model of a reference folder.

usage: first_scene_times.py REFERENCE_FOLDER [--least S] [--only PART] [--table FILE]

--least  lists the files that take at least so many seconds of processor time (default 2)
--only   only files with this text in their path
--table  writes all times to this file, one line per file

Prints the median, the 90th percentile and the maximum of the wall-clock time, and of the processor time of the run with
all its threads and processes, which is more meaningful on a busy machine. Missing assets are left out
(`on_missing_asset: warn`); files without a world are skipped. Source a workspace first. Needs only Python.
"""
import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

MODEL = ('<sdf version="1.6"><world name="one"><include><uri>model://sun</uri></include>'
         '<include><uri>model://{}</uri><static>1</static></include></world></sdf>')
CAMERA = '''image_width: 640
image_height: 480
camera_name: c0
distortion_model: plumb_bob
camera_matrix: {rows: 3, cols: 3, data: [467.7, 0, 319.5, 0, 467.7, 239.5, 0, 0, 1]}
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
'''
MARKER = ('<sdf version="1.6"><model name="m"><link name="l"><visual name="v"><geometry><box><size>0.1 0.1 0.1</size></box>'
          '</geometry></visual></link></model></sdf>')
SETTINGS = '''motion: placement
placement: {{mode: volume, orientation: upright, volume: {{min: [-1, -1, 150], max: [1, 1, 151]}}}}
scenes: 1
world: {{file: "{world}", on_missing_asset: warn}}
camera: {{info_file: "{folder}/camera.yaml", pose: [-4, -4, 4, -0.598, 0.247, -0.291, 0.705]}}
robot_list: [zz_marker]
zz_marker: {{class: marker, id: 1, model: "{folder}/marker.sdf"}}
writers: [{{name: coco, type: synthetic_dataset/Coco}}]
output_folder: "{folder}/out"
if_exists: overwrite
'''


def program() -> str:
    for prefix in os.environ.get('CMAKE_PREFIX_PATH', '').split(':'):
        path = os.path.join(prefix, 'lib/synthetic_dataset/generate')
        if os.access(path, os.X_OK):
            return path
    sys.exit('no program generate in CMAKE_PREFIX_PATH; source a workspace first')


def model_paths(root: Path) -> list:
    """The folders that contain models, and those of packages, as a set-up of the packages would name them."""
    folders = set()
    for folder, _, files in os.walk(root):
        if 'model.config' in files:
            folders.add(os.path.dirname(folder))
        if 'package.xml' in files:
            folders.update((os.path.dirname(folder), os.path.join(folder, 'models')))
    return sorted(folders)


def things(reference: Path, scratch: Path) -> list:
    """(name, world file, root of its models) for each world and model."""
    found = []
    for repository in sorted((reference / 'worlds').iterdir()):
        if not repository.is_dir():
            continue
        for file in sorted(repository.rglob('*')):
            if file.suffix in ('.world', '.sdf') and '<world' in file.read_text(errors='replace'):
                found.append((str(file.relative_to(reference)), file, repository))
    models = reference / 'models' / 'gazebo'
    for config in sorted(models.glob('*/model.config')):
        world = scratch / f'{config.parent.name}.world'
        world.write_text(MODEL.format(config.parent.name))
        found.append((str(config.parent.relative_to(reference)), world, models))
    return found


def run(generate: str, settings: Path, environment: dict) -> tuple:
    """Exit code, wall-clock time and processor time [s]."""
    begin = time.monotonic()
    process = subprocess.Popen([generate, '--config', str(settings)], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, env=environment)
    _, status, usage = os.wait4(process.pid, 0)
    return os.WEXITSTATUS(status), time.monotonic() - begin, usage.ru_utime + usage.ru_stime


def summary(what: str, times: list) -> str:
    times = sorted(times)
    at = lambda share: times[min(len(times) - 1, int(share * len(times)))]
    return f'{what}: median {at(0.5):.2f} s, 90 % within {at(0.9):.2f} s, worst {times[-1]:.2f} s'


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('reference', type=Path)
    parser.add_argument('--least', type=float, default=2.0)
    parser.add_argument('--only', default='')
    parser.add_argument('--table', type=Path)
    options = parser.parse_args()
    generate = program()
    rows = []
    refused = []
    with tempfile.TemporaryDirectory() as name:
        scratch = Path(name)
        (scratch / 'camera.yaml').write_text(CAMERA)
        (scratch / 'marker.sdf').write_text(MARKER)
        paths = {}
        for thing, world, root in things(options.reference.resolve(), scratch):
            if options.only not in thing:
                continue
            if root not in paths:
                paths[root] = ':'.join(model_paths(root))
            settings = scratch / 'settings.yaml'
            settings.write_text(SETTINGS.format(world=world, folder=scratch))
            environment = dict(os.environ, GAZEBO_MODEL_PATH=paths[root])
            code, clock, processor = run(generate, settings, environment)
            if code == 0:
                rows.append((processor, clock, thing))
            else:
                refused.append(thing)
    rows.sort(reverse=True)
    for processor, clock, thing in rows:
        if processor >= options.least:
            print(f'{processor:6.2f} s of processor time, {clock:6.2f} s  {thing}')
    for thing in refused:
        print(f'refused: {thing}')
    if options.table:
        options.table.write_text(''.join(f'{p:.3f} {c:.3f} {t}\n' for p, c, t in rows))
    if rows:
        print(summary(f'clock, {len(rows)} files', [row[1] for row in rows]))
        print(summary('processor', [row[0] for row in rows]))


if __name__ == '__main__':
    main()
