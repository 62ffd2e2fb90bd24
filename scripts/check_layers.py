#!/usr/bin/env python3
"""Holds the includes of include/, src/ and plugins/ against the table of docs/architecture.md.

    ./scripts/check_layers.py [REPOSITORY]

Exit code 1 when a folder includes what it may not, with a line for each such include.
"""
import pathlib
import re
import sys

API = 'synthetic_dataset'

# What a folder may include of this repository, by the first part of the path between the quotes.
MAY_INCLUDE = {
    'include': {API},
    'src/api': {API, 'api'},
    'src/base': {API, 'base'},
    'src/random': {API, 'random'},
    'src/config': {API, 'base', 'config', 'random'},  # and the options of all folders
    'src/motion': {API, 'motion'},
    'src/world': {API, 'world'},
    'src/appearance': {API, 'base', 'appearance', 'placement', 'random', 'world'},
    'src/placement': {API, 'base', 'placement', 'random', 'motion', 'world'},
    'src/sensor': {API, 'sensor', 'random'},
    'src/render': {API, 'render', 'sensor', 'world'},
    'src/annotate': {API, 'annotate'},
    'src/output': {API, 'output'},
    'src/ros_messages': {API, 'ros_messages'},
    'src/writers': {API, 'writers', 'output'},
    'src/verification': {API, 'base', 'verification', 'output', 'plugins'},
    'src/scene': {API, 'base', 'scene', 'random', 'motion', 'placement', 'appearance', 'world',
                  'sensor', 'render', 'annotate', 'output'},
    'src/setup': {API, 'base', 'setup', 'scene', 'config', 'motion', 'placement', 'appearance',
                  'world', 'render', 'random', 'output', 'writers'},
    'src/run': {API, 'base', 'run', 'setup', 'scene', 'config', 'random', 'render', 'output',
                'writers'},
    'src/gallery': {API, 'gallery', 'world', 'render'},
    'src/console': {API, 'console', 'config', 'motion', 'placement', 'output', 'run'},
    'src': {API, 'config', 'console', 'gallery', 'output', 'plugins', 'run', 'setup',
            'verification', 'world'},
    'plugins': {API, 'plugins', 'ros_messages'},
}

# Folders within a folder, each of which may include those before it, and what lies beside them all.
INNER_ORDER = {
    'src/world': ('files', 'material', 'physics', 'mesh', 'shape', 'sdf', 'urdf'),
    'src/render': ('pixels', 'gl', 'parts', 'geometry', 'shadows', 'light', 'overlay', 'edges',
                   'lens', 'labels', 'picture'),
    'src/output': ('files', 'image', 'manifest'),
}

# Libraries that only some folders may know, by how the path of the include begins.
CONFINED = [
    ('OpenGL', re.compile(r'GL/'), {'src/render'}),
    ('Bullet', re.compile(r'(bullet/)?(bt[A-Z]|LinearMath/|BulletCollision/|BulletDynamics/)'),
     {'src/world'}),
    ('libsdformat', re.compile(r'sdf/'), {'src/world'}),
    ('urdfdom', re.compile(r'urdf_(model|parser|world)/'), {'src/world'}),
    ('assimp', re.compile(r'assimp/'), {'src/world'}),
    ('FreeImage', re.compile(r'FreeImage\.h$'), {'src/world'}),
    ('rosbag', re.compile(r'rosbag/'), {'src/motion', 'plugins'}),
    ('tf2', re.compile(r'tf2(_\w+)?/'), {'src/motion', 'src/ros_messages', 'plugins'}),
    ('yaml-cpp', re.compile(r'yaml-cpp/'), {'src/base'}),
    ('JSON for Modern C++', re.compile(r'nlohmann/'), {'plugins'}),
    ('OpenSSL', re.compile(r'openssl/'), {'src/output'}),
    ('SQLite', re.compile(r'sqlite3\.h$'), {'src/output'}),
    ('pluginlib', re.compile(r'pluginlib/'), {'src/writers', 'plugins'}),
    ("ROS's time", re.compile(r'ros/(time|duration)\.h$'),
     {'src/motion', 'src/console', 'src/ros_messages', 'plugins'}),
    ("ROS's serialization", re.compile(r'ros/(serialization|message_traits)\.h$'),
     {'src/motion', 'plugins'}),
    ('roscpp', re.compile(r'ros/(?!(time|duration|serialization|message_traits)\.h$)'),
     {'src/console', 'src'}),
]

# Each folder defines its options beside the code that they configure, in headers that `config` fills
# and that are light: they include API, distributions and other options.
OPTIONS = re.compile(r'_options\.h$')

SOURCES = {'.h', '.hpp', '.cpp'}
INCLUDE = re.compile(r'\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')


def folder_of(file):
    """The row of the table that a file, relative to the repository, belongs to."""
    if file.parts[0] != 'src':
        return file.parts[0]
    return 'src' if len(file.parts) == 2 else f'src/{file.parts[1]}'


def inner_arrow(file, included):
    """The folder within the file's own folder that it reaches for and may not, or None."""
    folder = folder_of(file)
    order = INNER_ORDER.get(folder)
    if order is None or len(file.parts) < 4:
        return None  # what lies beside them may include them all
    target = pathlib.PurePath('src', included)
    if folder_of(target) != folder or len(target.parts) < 4:
        return None
    inner, wanted = file.parts[2], target.parts[2]
    if inner in order and wanted in order and order.index(wanted) <= order.index(inner):
        return None
    return wanted


def includes_of(path):
    """Line number, path and whether it is in quotes, of each include."""
    for number, line in enumerate(path.read_text(encoding='utf-8').splitlines(), start=1):
        match = INCLUDE.match(line)
        if match:
            yield number, match[1] or match[2], match[1] is not None


def forbidden(file, included, quoted):
    """What a file, relative to the repository, reaches for and may not, or None."""
    folder = folder_of(file)
    for library, beginning, folders in CONFINED:
        if beginning.match(included):
            return None if folder in folders else library
    first, slash, _ = included.partition('/')
    if not quoted and first not in MAY_INCLUDE['src']:
        return None  # somebody else's
    target = first if slash else 'src'  # without a folder: a file at the top of src/
    if OPTIONS.search(file.name) and target not in {API, 'random'}:
        return None if OPTIONS.search(included) else f'{target} (from options)'
    if folder == 'src/config' and OPTIONS.search(included):
        return None
    return None if target in MAY_INCLUDE.get(folder, set()) else target


def main():
    if len(sys.argv) > 2:
        sys.exit(__doc__.strip())
    default = pathlib.Path(__file__).resolve().parent.parent
    repository = pathlib.Path(sys.argv[1]) if len(sys.argv) == 2 else default
    files = sorted(path for top in ('include', 'src', 'plugins')
                   for path in (repository / top).rglob('*') if path.suffix in SOURCES)
    include_count = 0
    arrows = []
    for path in files:
        file = path.relative_to(repository)
        folder = folder_of(file)
        for number, included, quoted in includes_of(path):
            include_count += 1
            target = forbidden(file, included, quoted) or inner_arrow(file, included)
            if target is not None:
                arrows.append(f'{file}:{number}: {folder} -> {target} ({included})')
    for arrow in arrows:
        print(arrow)
    print(f'layers: {len(files)} files, {include_count} includes, {len(arrows)} forbidden')
    return 1 if arrows or not files else 0


if __name__ == '__main__':
    sys.exit(main())
