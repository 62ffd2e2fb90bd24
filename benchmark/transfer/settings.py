"""The settings of a row, as the content of a file."""
import contextlib
import copy
import json
import math
import os
import sqlite3

from rows import PLAIN, TRANSFER

OBJECTS = 3
WIDTH, HEIGHT, FIELD_OF_VIEW = 416, 312, math.radians(60)
FORMAT = 'detect'


def overlay(settings, over):
    """Overrides settings, as with `include`: groups are merged, everything else is replaced."""
    for name, value in over.items():
        if isinstance(value, dict) and isinstance(settings.get(name), dict) and not _is_distribution(settings[name]):
            overlay(settings[name], value)
        else:
            settings[name] = copy.deepcopy(value)
    return settings


def _is_distribution(group):
    return bool({'uniform', 'log_uniform', 'normal', 'choice'} & group.keys())


def of(row, model, scenes, seed=1):
    """A row's settings without the output_folder. @param model  a path or URI of the object's model"""
    names = [f'object_{number}' for number in range(1, OBJECTS + 1)]
    found = {
        'motion': 'placement', 'scenes': row.scenes or scenes, 'seed': seed,
        'camera': {'info_file': '$(dirname)/camera.yaml'},
        'robot_list': names,
        'writers': [{'name': FORMAT, 'type': 'synthetic_dataset/UltralyticsYolo'}],
        FORMAT: {'task': 'detect', 'image_format': 'jpg'},
        **{name: {'class': 'object', 'id': number, 'model': model} for number, name in enumerate(names, 1)},
    }
    if not model.startswith('model://') and os.path.isdir(model):
        overlay(found, {'world': {'model_folders': [os.path.dirname(os.path.abspath(model))]}})
    overlay(found, PLAIN if row.start == 'plain' else TRANSFER)
    return overlay(found, row.over)


def with_motions(settings, spelled_out, names):
    """Settings with a preset's motions written out, but only some of them.

    @param spelled_out  the settings that the run expanded these to
    """
    found = copy.deepcopy(spelled_out)
    found['motions'] = [each for each in found['motions'] if each['name'] in names]
    if len(found['motions']) != len(names):
        raise ValueError(f"the preset has no motions {', '.join(names)}")
    # Paths of files stay as in the settings, relative to their folder.
    return overlay(found, {name: settings[name] for name in ('camera', 'scenes', 'seed')})


def spelled_out_in(folder):
    """The expanded settings of a run, without the defaults."""
    found = {}
    for name, value in _rows(folder, 'SELECT name, value FROM setting WHERE NOT is_default'):
        *groups, last = name.split('/')
        group = found
        for each in groups:
            group = group.setdefault(each, {})
        group[last] = json.loads(value)
    return found


def digest_in(folder):
    """The digest of the settings and files from which a dataset was made."""
    return _rows(folder, "SELECT value FROM run WHERE key = 'settings_digest'")[0][0]


def pictures_in(folder):
    """The number of complete pictures; 0 if there is no dataset."""
    if not os.path.exists(f'{folder}/manifest.sqlite'):
        return 0
    return _rows(folder, "SELECT count(*) FROM scene WHERE state IN ('written', 'complete')")[0][0]


def _rows(folder, sql):
    """The rows of a query to a dataset's manifest."""
    with contextlib.closing(sqlite3.connect(f'file:{folder}/manifest.sqlite?mode=ro', uri=True)) as database:
        return database.execute(sql).fetchall()


def camera():
    """A calibration file without distortion."""
    focal = WIDTH / 2 / math.tan(FIELD_OF_VIEW / 2)
    matrix = [focal, 0.0, (WIDTH - 1) / 2, 0.0, focal, (HEIGHT - 1) / 2, 0.0, 0.0, 1.0]
    return json.dumps({
        'image_width': WIDTH, 'image_height': HEIGHT, 'camera_name': 'pinhole',
        'camera_matrix': {'rows': 3, 'cols': 3, 'data': matrix}, 'distortion_model': 'plumb_bob',
        'distortion_coefficients': {'rows': 1, 'cols': 5, 'data': [0.0] * 5}})
