#!/usr/bin/env python3
"""Scans worlds of the reference data with Gazebo 11, for compare.py.

usage: record.py REFERENCE_FOLDER [NAME...] [--chroot DIR]

Each world gets a file in test/reference/gazebo_scans: the ranges [mm] of a sensor of type `ray`, which sees collision shapes,
and of one of type `gpu_ray`, which sees visuals. NAME: as in scanner.py (default: all). DIR: a system with Gazebo 11, made by
the reference data's gazebo/setup.sh (default: ~/.cache/gazebo11). Needs root, as setup.sh does; a world takes 20 to 90 s.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys

import numpy as np

import scanner

HERE = pathlib.Path(__file__).resolve().parent
SCANS = HERE.parents[1] / 'test/reference/gazebo_scans'
LONGEST = 240  # [s] per world


def build_plugin(system):
    shutil.copy(HERE / 'scan_plugin.cc', f'{system}/tmp')
    subprocess.run(['chroot', system, 'bash', '-c', 'g++ -w -O1 -std=c++17 -fPIC -shared /tmp/scan_plugin.cc -o /usr/lib/'
                    'libscan_plugin.so $(pkg-config --cflags gazebo)'], check=True, stderr=subprocess.DEVNULL)


def commands(folder, world, models, packages):
    """The commands to run in the system, with its own X server, until both sensors have measured."""
    display, port = 100 + os.getpid() % 800, 12000 + os.getpid() % 5000
    return f'''cd {world.parent}; export HOME={folder} DISPLAY=:{display} LIBGL_ALWAYS_SOFTWARE=1 LANG=C.UTF-8
. /usr/share/gazebo/setup.sh
export GAZEBO_MODEL_DATABASE_URI= GAZEBO_IP=127.0.0.1 GAZEBO_MASTER_URI=http://127.0.0.1:{port}
export GAZEBO_PLUGIN_PATH=/usr/lib:$GAZEBO_PLUGIN_PATH GAZEBO_MODEL_PATH="{':'.join(models)}:$GAZEBO_MODEL_PATH"
export GAZEBO_RESOURCE_PATH="{':'.join(packages)}:$GAZEBO_RESOURCE_PATH"
Xvfb $DISPLAY -screen 0 800x600x24 -nolisten tcp & x=$!
sleep 1; gzserver {world} & gazebo=$!
for i in $(seq {LONGEST}); do
  sleep 1; kill -0 $gazebo || break; [ -s {folder}/ray.txt ] && [ -s {folder}/gpu_ray.txt ] && break
done
kill -9 $gazebo; kill $x; wait
'''


def record(name, reference, system, look):
    root = f'{reference}/worlds/{name.split("/")[0]}'
    file = pathlib.Path(scanner.world_file(f'{reference}/worlds', name))
    folder = f'/scan_{os.getpid()}'
    inside = pathlib.Path(system + folder)
    text = scanner.with_scanners(file.read_text(errors='replace'), scanner.PLACES[name],
                                 [scanner.sensor(kind, kind) for kind in scanner.KINDS],
                                 f'<plugin name="scan" filename="libscan_plugin.so"><path>{folder}</path></plugin>')
    beside = file.with_name(f'.{file.stem}_{os.getpid()}.world')  # in the folder in which the world's relative paths start
    mounted = pathlib.Path(system + root)
    inside.mkdir()
    mounted.mkdir(parents=True, exist_ok=True)
    subprocess.run(['mount', '--bind', root, str(mounted)], check=True)
    try:
        beside.write_text(text)
        (inside / 'run.sh').write_text(commands(folder, beside, *look.paths(root)))
        subprocess.run(['chroot', system, 'bash', f'{folder}/run.sh'], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        scans = {kind: scanner.whole_ranges(np.loadtxt(inside / f'{kind}.txt')) for kind in scanner.KINDS}
    finally:
        beside.unlink(missing_ok=True)
        subprocess.run(['umount', '-l', str(mounted)], check=True)
        shutil.rmtree(inside)
    SCANS.mkdir(exist_ok=True)
    np.savez_compressed(SCANS / f'{name.replace("/", "__")}.npz',
                        **{kind: np.round(1000 * ranges).astype(np.uint16) for kind, ranges in scans.items()})


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('reference')
    arguments.add_argument('names', nargs='*', default=list(scanner.PLACES))
    arguments.add_argument('--chroot', default=os.path.expanduser('~/.cache/gazebo11'))
    given = arguments.parse_args()
    reference = os.path.realpath(given.reference)
    sys.path.insert(0, f'{reference}/gazebo')
    import look  # from the reference data: finds the folders of models and packages

    build_plugin(given.chroot)
    failed = False
    for name in given.names:
        try:
            record(name, reference, given.chroot, look)
            print(f'scanned {name}', flush=True)
        except OSError as error:
            print(f'FAILED  {name}: {error}', flush=True)
            failed = True
    sys.exit(failed)


if __name__ == '__main__':
    main()
