"""ROS 2 bags that rosbags-convert makes from the example's: their datasets have the bytes of the ROS 1 bag's.

    conversions.py [--times] [FOLDER]

FOLDER keeps bags and datasets. --times also compares how long an hour of TF takes as a bag of each kind, and how much
memory.
"""
import filecmp
import os
import pathlib
import resource
import shutil
import sqlite3
import struct
import subprocess
import sys
import tempfile
import time

import geometry_msgs.msg
import rosbag
import rospy
import sensor_msgs.msg
import std_msgs.msg
import tf2_msgs.msg

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
CONVERT = pathlib.Path(sys.executable).parent / 'rosbags-convert'
KINDS = {
    'sqlite3': ['--dst-storage', 'sqlite3'],
    'mcap': ['--dst-storage', 'mcap'],
    'mcap_zstd': ['--dst-storage', 'mcap', '--compress', 'zstd', '--compress-mode', 'storage'],
    'sqlite3_file': ['--dst-storage', 'sqlite3', '--compress', 'zstd', '--compress-mode', 'file'],
    'mcap_file': ['--dst-storage', 'mcap', '--compress', 'zstd', '--compress-mode', 'file'],
    'sqlite3_message': ['--dst-storage', 'sqlite3', '--compress', 'zstd', '--compress-mode', 'message'],
    'mcap_message': ['--dst-storage', 'mcap', '--compress', 'zstd', '--compress-mode', 'message'],
}
RUNS = {
    'fixed_camera': 'include: {config}/example.yaml\nsimulated_rate: 1.0\n',
    'riding_camera': 'include: {config}/example.yaml\nsimulated_rate: 1.0\n'
                     'camera_frame_id: rover_2/base_link\n',
    'recorded_pictures': 'include: {config}/example_twin.yaml\n',
    'cloud': 'include: {config}/example.yaml\n'
             'camera: {{image_topic: /camera/color/image_raw/compressed, time_offset: -0.037}}\n'
             'twin: {{cloud_topic: /lidar/points}}\n',
}
# The rows that tell which files were read, and when.
INPUTS = {'input': None, 'setting': "name NOT LIKE 'bag_file%'", 'run': "key NOT LIKE '%digest%'"}


def convert(source, target, options):
    subprocess.run([CONVERT, '--src', source, '--dst', target, *options], check=True)


def split(source, target):
    """Splits a rosbag2 database by time into three files."""
    (database,) = source.glob('*.db3')
    target.mkdir()
    names = []
    for part in range(3):
        names.append(f'{target.name}_{part}.db3')
        shutil.copy(database, target / names[-1])
        with sqlite3.connect(target / names[-1]) as copy:
            first, last = copy.execute('SELECT min(timestamp), max(timestamp) FROM messages').fetchone()
            bounds = [first + (last + 1 - first) * i // 3 for i in (part, part + 1)]
            copy.execute('DELETE FROM messages WHERE timestamp < ? OR timestamp >= ?', bounds)
    text = (source / 'metadata.yaml').read_text('utf-8')
    paths = ''.join(f'\n  - {name}' for name in names)
    text = text.replace(f'relative_file_paths:\n  - {database.name}', 'relative_file_paths:' + paths)
    (target / 'metadata.yaml').write_text(text, 'utf-8')


def write_cloud(path, pictures):
    """Writes the pictures' bag with a cloud for each picture: a wall 2 m in front of the camera's left half."""
    with rosbag.Bag(str(path), 'w') as bag:
        for topic, message, recorded in rosbag.Bag(str(pictures)).read_messages():
            bag.write(topic, message, recorded)
            if topic != '/camera/color/camera_info':
                continue
            points = [(0.02 * column, 0.02 * row, 2.0) for row in range(-80, 80) for column in range(-80, 0)]
            fields = [sensor_msgs.msg.PointField(name, 4 * i, 7, 1) for i, name in enumerate('xyz')]
            bag.write('/lidar/points', sensor_msgs.msg.PointCloud2(
                header=message.header, height=1, width=len(points), fields=fields, point_step=12,
                row_step=12 * len(points), is_dense=True,
                data=b''.join(struct.pack('<fff', *point) for point in points)), recorded)


def program(name):
    return subprocess.run(['catkin_find', '--first-only', '--libexec', 'synthetic_dataset', name],
                          capture_output=True, text=True, check=True).stdout.strip()


def generate(folder, settings, bags):
    folder.mkdir(parents=True)
    text = settings.format(config=REPOSITORY / 'config')
    text += 'bag_file: [' + ', '.join(f'"{bag}"' for bag in bags) + ']\n'
    # The same folder for all, as Darknet's lists name files by their full paths.
    made = folder.parents[1] / 'made'
    text += f'output_folder: {made}\n'
    (folder / 'settings.yaml').write_text(text, 'utf-8')
    subprocess.run([program('generate'), '--config', folder / 'settings.yaml'], check=True,
                   stdout=subprocess.DEVNULL)
    made.rename(folder / 'dataset')
    return folder / 'dataset'


def rows_of(manifest, bags):
    """The rows of all tables except those that name inputs."""
    rows = {}
    with sqlite3.connect(manifest) as database:
        for (table,) in database.execute("SELECT name FROM sqlite_master WHERE type = 'table'").fetchall():
            if table in INPUTS and INPUTS[table] is None:
                continue
            where = f' WHERE {INPUTS[table]}' if table in INPUTS else ''
            text = repr(database.execute(f'SELECT * FROM {table}{where}').fetchall())
            for bag in bags:
                text = text.replace(str(bag), pathlib.Path(bag).name.split('.')[0])
            rows[table] = text
    return rows


def differences(first, other, bags, other_bags):
    files = [{path.relative_to(root) for path in root.rglob('*') if path.is_file()} for root in (first, other)]
    found = [f'only in one: {path}' for path in files[0] ^ files[1]]
    for path in files[0] & files[1]:
        if path.name == 'manifest.sqlite':
            rows, other_rows = rows_of(first / path, bags), rows_of(other / path, other_bags)
            found += [f'table {table}' for table in rows if rows[table] != other_rows.get(table)]
        elif not filecmp.cmp(first / path, other / path, shallow=False):
            found.append(str(path))
    return found, len(files[0])


def check_datasets(folder):
    worlds = REPOSITORY / 'worlds'
    # Copied, as a dataset contains the credits found beside its inputs.
    sources = {name: folder / f'{name}.bag' for name in ('example', 'example_pictures')}
    for name, copy in sources.items():
        shutil.copy(worlds / f'{name}.bag', copy)
    sources['clouds'] = folder / 'clouds.bag'
    write_cloud(sources['clouds'], sources['example_pictures'])
    bags = {kind: {} for kind in [*KINDS, 'split']}
    for name, source in sources.items():
        for kind, options in KINDS.items():
            bags[kind][name] = folder / 'bags' / f'{kind}_{name}'
            convert(source, bags[kind][name], options)
        bags['split'][name] = folder / 'bags' / f'split_{name}'
        split(bags['sqlite3'][name], bags['split'][name])
    failed = False
    for run, settings in RUNS.items():
        names = {'recorded_pictures': ['example', 'example_pictures'], 'cloud': ['example', 'clouds']}.get(
            run, ['example'])
        own = [sources[name] for name in names]
        first = generate(folder / run / 'ros1', settings, own)
        for kind, converted in bags.items():
            others = [converted[name] for name in names]
            other = generate(folder / run / kind, settings, others)
            found, count = differences(first, other, own, others)
            print(f'{run}, {kind}: {count} files, ' + (f'{len(found)} differ: {found[:5]}' if found else 'all equal'),
                  flush=True)
            failed = failed or bool(found)
    return failed


def write_hour(path):
    """Writes 1.2 million transforms: 100 messages per second, of 3 or 4 frames each."""
    with rosbag.Bag(str(path), 'w') as bag:
        for i in range(360000):
            now = rospy.Time(1000 + i // 100, i % 100 * 10000000)
            transforms = []
            for frame in range(4 if i % 3 == 0 else 3):
                transforms.append(geometry_msgs.msg.TransformStamped(
                    header=std_msgs.msg.Header(stamp=now, frame_id='map'), child_frame_id=f'robot_{frame}/base_link'))
                transforms[-1].transform.translation.x = 0.001 * i
                transforms[-1].transform.rotation.w = 1.0
            bag.write('/tf', tf2_msgs.msg.TFMessage(transforms), now)


def inspected(bag):
    """Processor time [s] and memory [MiB] of reading a bag."""
    pid = os.fork()
    if pid == 0:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        os.execv(program('inspect'), ['inspect', '--json', str(bag)])
    _, status, usage = os.wait4(pid, 0)
    if status != 0:
        sys.exit(f'inspect {bag} ends with {status}')
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def check_times(folder):
    write_hour(folder / 'hour.bag')
    seconds, memory = inspected(folder / 'hour.bag')
    print(f'an hour of TF as a bag of ROS 1: {seconds:.1f} s, {memory:.0f} MiB')
    failed = False
    for kind, options in KINDS.items():
        convert(folder / 'hour.bag', folder / f'hour_{kind}', options)
        taken, used = inspected(folder / f'hour_{kind}')
        is_slow = taken > 2.0 * seconds or used > 1.25 * memory
        failed = failed or is_slow
        print(f'{kind}: {taken:.1f} s, {used:.0f} MiB' + (': TOO MUCH' if is_slow else ''), flush=True)
        shutil.rmtree(folder / f'hour_{kind}')
    return failed


def main():
    arguments = [each for each in sys.argv[1:] if each != '--times']
    with tempfile.TemporaryDirectory(prefix='synthetic_dataset_') as scratch:
        folder = pathlib.Path(arguments[0] if arguments else scratch).resolve()
        folder.mkdir(exist_ok=True)
        failed = check_datasets(folder)
        if '--times' in sys.argv:
            failed = check_times(folder) or failed
        left = list(pathlib.Path(tempfile.gettempdir()).glob('synthetic_dataset_??????'))
        left = [path for path in left if path.is_file()]
        if left:
            print(f'temporary files are left: {left}')
    sys.exit(1 if failed or left else 0)


if __name__ == '__main__':
    main()
