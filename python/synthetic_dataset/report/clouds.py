"""Lidar point clouds: statistics, and pictures that `draw_labels` makes of some sweeps."""
import collections
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image

from synthetic_dataset import pages
from synthetic_dataset.report import charts

MOST_MEASURED, MOST_SHOWN = 24, 3  # sweeps of each lidar
FEW = 5  # points; with fewer, an object can hardly be detected

Lidar = collections.namedtuple('Lidar', 'name sweeps points share classes labelled pictures')


class Clouds:
    """The clouds' part of the page; false for a dataset without lidars."""

    def __init__(self, dataset, measures):
        self.points = _points_of_objects(dataset)
        self.problem, self.lidars = '', []
        if self.points is None:
            return
        try:
            self.lidars = _lidars(dataset)
        except (OSError, subprocess.CalledProcessError) as error:
            self.problem = f'draw_labels cannot be run: {getattr(error, "stderr", "") or error}'
        self.chart = self._chart(measures)

    def __bool__(self):
        return self.points is not None

    def _chart(self, measures):
        """A chart of how many points objects have, for those that have any."""
        classes = np.concatenate([measures.class_of_object] * len(self.points))
        counts = self.points.ravel()
        met = counts > 0
        if not met.any():
            return {'title': 'Points of an object', 'svg': '', 'note': 'No sweep hits an object.'}
        few = np.count_nonzero(counts[met] < FEW)
        note = (f'{np.count_nonzero(met):,} objects in sweeps, of which {100 * few / met.sum():.3g} % have '
                f'fewer than {FEW} points; the lidar does not hit {np.count_nonzero(~met):,}.')
        bins = np.geomspace(1, max(10.0, counts.max() * 1.01), 40)
        return {'title': 'Points of an object', 'note': note,
                'svg': charts.of_classes(measures, classes[met], counts[met], 'points in a sweep', 'objects', bins,
                                         log=True, marks=((FEW, f'{FEW}'),))}


def _points_of_objects(dataset):
    """The number of points of each object (columns) in each sweep (rows); None without lidars."""
    if 'scene_picture' not in dataset.manifest.tables():
        return None
    rows = dataset.manifest.rows(
        "SELECT picture, instant, min(scene), cells FROM scene_picture JOIN scene ON scene.\"index\" = scene "
        "WHERE picture LIKE 'cloud\\_%\\_labels' ESCAPE '\\' GROUP BY picture, instant ORDER BY picture, instant")
    if not rows:
        return None
    points = np.zeros((len(rows), len(dataset.objects)), int)
    for row, (_, _, _, cells) in enumerate(rows):
        counts = np.frombuffer(cells or b'', '<f4')
        points[row, :len(counts)] = counts
    return points


def _lidars(dataset):
    """Statistics of each lidar from its files, for some sweeps spread over the dataset."""
    first_camera = dataset.cameras[0]  # the clouds are in the scenes of the first camera
    scenes = [index for index, in dataset.manifest.rows(
        "SELECT \"index\" FROM scene WHERE camera = ? AND state IN ('written', 'complete') ORDER BY \"index\"",
        (first_camera,))]
    measured = _spread(scenes, MOST_MEASURED)
    by_lidar = collections.defaultdict(list)
    with tempfile.TemporaryDirectory() as folder:
        for sweep in _drawn(dataset, pathlib.Path(folder) / 'clouds', measured):
            by_lidar[sweep['lidar']].append(sweep)
        return [_lidar(name, sweeps, pathlib.Path(folder) / 'clouds')
                for name, sweeps in sorted(by_lidar.items())]


def _spread(values, most):
    """At most so many of the values, equally spaced, including the first and the last."""
    if len(values) <= most:
        return list(values)
    return [values[place] for place in np.linspace(0, len(values) - 1, most).round().astype(int)]


def _drawn(dataset, folder, scenes):
    """The output of `draw_labels` for each sweep of these scenes, which it draws into a folder."""
    ended = subprocess.run([_program(), '--clouds', dataset.folder, folder, *map(str, scenes)],
                           stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=True)
    return [json.loads(line) for line in ended.stdout.splitlines()]


def _program():
    """The path of `draw_labels`, usually beside `report`."""
    beside = pathlib.Path(sys.argv[0]).parent / 'draw_labels'
    if beside.exists():
        return beside
    found = subprocess.run(['catkin_find', '--first-only', '--libexec', 'synthetic_dataset', 'draw_labels'],
                           stdout=subprocess.PIPE, universal_newlines=True, check=True)
    return found.stdout.strip()


def _lidar(name, sweeps, folder):
    points = np.array([sweep['points'] for sweep in sweeps])
    shares = [sweep['points'] / sweep['rays'] for sweep in sweeps if sweep.get('rays')]
    classes = collections.Counter()
    labelled = [sweep for sweep in sweeps if sweep['labelled']]
    for sweep in labelled or sweeps:
        classes.update(sweep['classes'])
    total = max(1, sum(classes.values()))
    return Lidar(
        name or 'cloud', len(sweeps), (int(points.mean()), int(points.min()), int(points.max())),
        np.mean(shares) if shares else None,
        [{'name': each or 'of no class', 'points': count / len(labelled or sweeps), 'share': 100 * count / total}
         for each, count in classes.most_common()],
        bool(labelled),
        [{'scene': sweep['scene'], 'writer': sweep['writer'], 'image': _embedded(folder / sweep['picture'])}
         for sweep in _spread(labelled or sweeps, MOST_SHOWN)])


def _embedded(file):
    with Image.open(file) as picture:
        return pages.embedded(picture.convert('RGB'))
