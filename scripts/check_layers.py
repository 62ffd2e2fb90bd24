#!/usr/bin/env python3
"""Checks the includes of include/, src/ and plugins/ against the table of docs/architecture.md.

    ./scripts/check_layers.py [--arrows] [REPOSITORY]

Prints the number of rooms, and of arrows between them; with --arrows, each arrow with its number of
includes. Exit code 1 if a room includes something that it may not, with a line for each such
include.
"""
import collections
import pathlib
import re
import sys

API = 'synthetic_dataset'

# Which parts of this repository a room may include, by the first part of the path between the quotes.
# The order is that of the figure in docs/architecture.md: a room knows only rooms above it.
MAY_INCLUDE = {
    'include': {API},
    'src/api': {API, 'api'},
    'src/base': {API, 'base'},
    'plugins': {API, 'plugins', 'base'},  # from base, the conversion to ROS messages
    'src/motion': {API, 'motion', 'base'},
    'src/world': {API, 'world', 'base'},
    'src/randomize': {API, 'randomize', 'base', 'motion', 'world'},
    'src/render': {API, 'render', 'base', 'world'},
    'src/label': {API, 'label', 'base', 'world', 'render'},
    'src/lidar': {API, 'lidar', 'base', 'motion', 'world', 'render'},
    'src/output': {API, 'output', 'base', 'plugins'},  # from plugins, the readers for verify
    'src/scene': {API, 'scene', 'base', 'motion', 'world', 'randomize', 'render', 'label'},
    'src/config': {API, 'config', 'base'},  # and the options of all rooms
    # from plugins, masks as polygons and colours of numbers
    'src/run': {API, 'run', 'base', 'motion', 'world', 'randomize', 'render', 'label', 'lidar', 'scene',
                'output', 'config', 'plugins'},
    'src/programs': {API, 'programs', 'base', 'motion', 'world', 'randomize', 'render', 'output',
                     'config', 'run', 'plugins'},
}

# Folders within a room; each may include those before it, and the files directly in the room.
INNER_ORDER = {
    'src/motion': ('ros2', 'bag', 'tf', 'recorded'),
    'src/world': ('files', 'material', 'physics', 'mesh', 'shape', 'sdf', 'urdf'),
    'src/render': ('pixels', 'sensor', 'weather', 'gl', 'parts', 'geometry', 'shadows', 'light', 'overlay',
                   'edges', 'lens', 'labels', 'picture'),
    'src/output': ('files', 'manifest', 'writers', 'verify'),
    'src/randomize': ('placement', 'appearance'),
    'src/scene': ('calibration', 'measured'),
}

# Libraries that only some rooms may use, by the beginning of the include's path.
CONFINED = [
    ('OpenGL', re.compile(r'GL/'), {'src/render'}),
    ('Bullet', re.compile(r'(bullet/)?(bt[A-Z]|LinearMath/|BulletCollision/|BulletDynamics/)'),
     {'src/world'}),
    ('Embree', re.compile(r'embree[34]/'), {'src/lidar'}),
    ('assimp', re.compile(r'assimp/'), {'src/world'}),
    ('FreeImage', re.compile(r'FreeImage\.h$'), {'src/base'}),
    ('rosbag', re.compile(r'rosbag/'), {'src/motion', 'plugins'}),
    ('tf2', re.compile(r'tf2(_(?!msgs)\w+)?/'), {'src/motion', 'src/base', 'plugins'}),
    ('yaml-cpp', re.compile(r'yaml-cpp/'), {'src/base'}),
    ('JSON for Modern C++', re.compile(r'nlohmann/'), {'plugins', 'src/base'}),
    ('libmicrohttpd', re.compile(r'microhttpd\.h$'), {'src/programs'}),
    ('OpenSSL', re.compile(r'openssl/'), {'src/output'}),
    ('SQLite', re.compile(r'sqlite3\.h$'), {'src/base'}),
    ('Zstandard and LZ4', re.compile(r'(zstd|lz4frame)\.h$'), {'src/motion'}),
    ('pluginlib', re.compile(r'pluginlib/'), {'src/output', 'plugins'}),
    ("ROS's time", re.compile(r'ros/(time|duration)\.h$'),
     {'src/motion', 'src/programs', 'src/base', 'plugins'}),
    ("ROS's serialization", re.compile(r'ros/(serialization|message_traits)\.h$'),
     {'src/motion', 'plugins'}),
    ('roscpp', re.compile(r'ros/(?!(time|duration|serialization|message_traits)\.h$)'),
     {'src/programs'}),
]

# Each room defines its options beside the code that they configure. `config` fills them in. Their
# headers are light: they only include the API, `base` and other options.
OPTIONS = re.compile(r'_options\.h$')

SOURCES = {'.h', '.hpp', '.cpp'}
INCLUDE = re.compile(r'\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')


def folder_of(file):
    """The row of the table to which a file belongs; its path is relative to the repository."""
    if file.parts[0] != 'src':
        return file.parts[0]
    return f'src/{file.parts[1]}'


def inner_arrow(file, included):
    """The folder within the file's own room that it includes but may not, or None."""
    folder = folder_of(file)
    order = INNER_ORDER.get(folder)
    if order is None or len(file.parts) < 4:
        return None  # files directly in the room may include all of its folders
    target = pathlib.PurePath('src', included)
    if folder_of(target) != folder or len(target.parts) < 4:
        return None
    inner, wanted = file.parts[2], target.parts[2]
    if inner in order and wanted in order and order.index(wanted) <= order.index(inner):
        return None
    return wanted


def includes_of(path):
    """Yields the line number and path of each include, and whether the path is in quotes."""
    for number, line in enumerate(path.read_text(encoding='utf-8').splitlines(), start=1):
        match = INCLUDE.match(line)
        if match:
            yield number, match[1] or match[2], match[1] is not None


def forbidden(file, included, quoted):
    """What a file includes but may not, or None; its path is relative to the repository."""
    folder = folder_of(file)
    for library, beginning, folders in CONFINED:
        if beginning.match(included):
            return None if folder in folders else library
    first, slash, _ = included.partition('/')
    if not quoted:
        return None  # a library's
    target = first if slash else '(no folder)'
    if folder != 'plugins' and OPTIONS.search(file.name) and target not in {API, 'base'}:
        return None if OPTIONS.search(included) else f'{target} (from options)'
    if folder == 'src/config' and OPTIONS.search(included):
        return None
    return None if target in MAY_INCLUDE.get(folder, set()) else target


def main():
    arguments = [each for each in sys.argv[1:] if each != '--arrows']
    if len(arguments) > 1:
        sys.exit(__doc__.strip())
    default = pathlib.Path(__file__).resolve().parent.parent
    repository = pathlib.Path(arguments[0]) if arguments else default
    files = sorted(path for top in ('include', 'src', 'plugins')
                   for path in (repository / top).rglob('*') if path.suffix in SOURCES)
    rooms = {API: 'include', 'plugins': 'plugins'}
    rooms.update({room[4:]: room[4:] for room in MAY_INCLUDE if room.startswith('src/') and room != 'src/api'})
    arrows = collections.Counter()
    include_count = 0
    problems = []
    for path in files:
        file = path.relative_to(repository)
        room = folder_of(file)
        for number, included, quoted in includes_of(path):
            include_count += 1
            target = forbidden(file, included, quoted) or inner_arrow(file, included)
            if target is not None:
                problems.append(f'{file}:{number}: {room} -> {target} ({included})')
            known = rooms.get(included.partition('/')[0]) if quoted else None
            own = rooms[API] if room == 'src/api' else room.replace('src/', '')
            if known and known != own:
                arrows[own, known] += 1
    if '--arrows' in sys.argv:
        for (room, target), count in sorted(arrows.items()):
            print(f'{room} -> {target}: {count}')
    for problem in problems:
        print(problem)
    print(f'layers: {len(rooms)} rooms, {len(arrows)} arrows, {len(files)} files, '
          f'{include_count} includes, {len(problems)} forbidden')
    return 1 if problems or not files else 0


if __name__ == '__main__':
    sys.exit(main())
