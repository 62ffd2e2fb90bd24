"""The manifest's measures of a dataset's labels, as arrays with an entry for each label."""
import numpy as np

from synthetic_dataset import poses
from synthetic_dataset.dataset import IS_THERE

EDGES = ('left', 'top', 'right', 'bottom')


class Measures:
    """Scenes, and labels: the objects in scenes for which most formats have a label.

    Arrays named `scene_...` have an entry for each scene, all others one for each label.
    """

    def __init__(self, dataset):
        scenes = dataset.manifest.columns('scene', IS_THERE)
        rows = dataset.manifest.columns(
            'scene_object', f'scene IN (SELECT "index" FROM scene WHERE {IS_THERE})')
        self.class_names = [dataset.classes[each] for each in sorted(dataset.classes)]
        self.object_names = [each.name for each in dataset.objects]
        self.scene_index = scenes['index'].astype(int)
        self.scene_split = scenes['split']
        self.scene_camera = scenes['camera']
        self.scene_size = np.stack([scenes['width'], scenes['height']], axis=1).astype(float)
        self.scene_X_GC = poses.of_rows(scenes)
        row_of_scene = {index: row for row, index in enumerate(self.scene_index)}
        all_scenes = np.array([row_of_scene[each] for each in rows['scene']], int)

        self.alignment = _of_scenes(dataset, 'scene_alignment', 'alignment', self.scene_index)
        self.unmeasured = _of_scenes(dataset, 'scene_cover', 'unmeasured', self.scene_index)
        self.covered = _of_scenes(dataset, 'scene_cover', 'covered', self.scene_index)
        self.has_pixels = _is_known(rows['visible_pixels'])
        seen = rows['visible_pixels'] > 0 if self.has_pixels else rows['in_view'] == 1
        self.dropped = int(np.count_nonzero(seen & (rows['dropped'] == 1)))
        chosen = np.flatnonzero(seen & (rows['dropped'] == 0))
        rows = {name: column[chosen] for name, column in rows.items()}
        self.count = len(chosen)
        self.scene = all_scenes[chosen]  # the row of each label's scene in arrays named scene_...
        self.object = rows['object'].astype(int)
        order = {number: index for index, number in enumerate(sorted(dataset.classes))}
        class_of = np.array([order[each.class_id] for each in dataset.objects], int)
        self.class_of_object = class_of  # for each object of the dataset, the row of its class
        self.label_class = class_of[self.object] if self.count else np.zeros(0, int)
        self.split = self.scene_split[self.scene]
        self.box, self.box_kind = _boxes(rows, self.scene_size[self.scene])
        self.visible_pixels = _known(rows['visible_pixels'])
        self.visibility = _known(rows['visibility'])
        self.truncation = _known(rows['truncation'])
        self.distance = rows['distance']
        self.azimuth, self.elevation = _view_angles(rows, self.scene_X_GC[self.scene])

    @property
    def box_size(self):
        """Width and height of each box [px]."""
        return self.box[:, 2:] - self.box[:, :2]

    def labels_by_scene(self):
        """The number of labels in each scene."""
        return np.bincount(self.scene, minlength=len(self.scene_index))

    def counts(self, splits):
        """Labels of each class (rows) in each split (columns)."""
        table = np.zeros((len(self.class_names), len(splits)), int)
        for column, split in enumerate(splits):
            of_split = self.label_class[self.split == split]
            table[:, column] = np.bincount(of_split, minlength=len(self.class_names))
        return table


def _of_scenes(dataset, table, column, scenes):
    """A measure of recorded pictures, for those of the scenes that have it."""
    if table not in dataset.manifest.tables():
        return np.zeros(0)
    found = dataset.manifest.columns(table)
    return found[column].astype(float)[np.isin(found['scene'], scenes)]


def _is_known(column):
    return column.dtype.kind in 'iu' or bool(np.any(~np.isnan(column.astype(float))))


def _known(column):
    """The column as numbers; None if no format asked for it, so that nothing was measured."""
    return column.astype(float) if len(column) and _is_known(column) else None


def _boxes(rows, sizes):
    """The tightest kind of boxes measured, clipped to the image, which spans 0 to width [px]."""
    for kind in ('visible', 'silhouette', 'loose'):
        box = np.stack([rows[f'{kind}_{edge}'].astype(float) for edge in EDGES], axis=1)
        if len(box) and not np.any(np.isnan(box)):
            break
    box = np.nan_to_num(box) + 0.5  # in the manifest, pixel centres have whole coordinates
    return np.clip(box, 0.0, np.tile(sizes, 2)), kind


def _view_angles(rows, X_GC):
    """Where each object is seen from [deg]: azimuth 0 along its x axis, 90 along its y axis."""
    X_GO = poses.of_rows(rows)
    p_OC = np.einsum('nij,nj->ni', poses.inverse(X_GO)[:, :3, :3], X_GC[:, :3, 3] - X_GO[:, :3, 3])
    length = np.maximum(np.linalg.norm(p_OC, axis=1), 1e-12)
    return (np.degrees(np.arctan2(p_OC[:, 1], p_OC[:, 0])),
            np.degrees(np.arcsin(np.clip(p_OC[:, 2] / length, -1.0, 1.0))))
