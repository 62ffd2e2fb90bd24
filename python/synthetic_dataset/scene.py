"""One scene of a dataset, and an object in it."""
import json
import math

import numpy as np

from synthetic_dataset import pictures, poses, truth
from synthetic_dataset.manifest import DatasetError


class SceneObject:
    """The measures of one object in one scene; None if no format asked for a measure.

    An object that is not in the scene (`is_there` is False) has no pose, boxes or pixels.

    Boxes are [left, top, right, bottom] in pixels, as in the manifest: pixel centres have whole
    coordinates, so a mask of only the pixel (0, 0) has the box [-0.5, -0.5, 0.5, 0.5].
    """

    def __init__(self, scene, row, description):
        self._scene = scene
        self.index, self.name, self.id, self.class_id, self.class_name = description
        self.is_there = _number(row['x']) is not None
        self.X_GO = poses.of_rows(row) if self.is_there else None  # in the global frame, 4 x 4
        self.distance = _number(row['distance'])  # from the camera's centre to its frame [m]
        self.in_view = bool(row['in_view'])
        self.dropped = bool(row['dropped'])  # too little of it is visible for a label
        self.loose_box = _box(row, 'loose')
        self.silhouette_box = _box(row, 'silhouette')
        self.visible_box = _box(row, 'visible')
        self.silhouette_pixels = _count(row['silhouette_pixels'])
        self.visible_pixels = _count(row['visible_pixels'])
        self.visibility = _number(row['visibility'])
        self.truncation = _number(row['truncation'])

    @property
    def X_CO(self):
        """Its pose in the camera's optical frame (x right, y down, z forward), 4 x 4, or None."""
        return poses.inverse(self._scene.X_GC) @ self.X_GO if self.is_there else None

    @property
    def alignment(self):
        """How well its outline matches the edges of a recorded picture, 0 to 1; None if this was
        not measured."""
        return self._scene.alignments.get(self.index)

    @property
    def unmeasured(self):
        """The share of its pixels in a recorded picture for which it is unknown whether something
        hides them, 0 to 1; None in drawn pictures, and for an object without pixels."""
        return self._scene.covers.get(self.index, (None, None))[0]

    @property
    def covered(self):
        """The share of its pixels in a recorded picture that are hidden by something that is not in
        the world, 0 to 1, or None."""
        return self._scene.covers.get(self.index, (None, None))[1]

    @property
    def is_labelled(self):
        """Whether most formats label it: at least one pixel is visible, and enough of it."""
        return bool(self.visible_pixels) and not self.dropped

    @property
    def mask(self):
        """The pixels in which it is visible: bool, height x width."""
        if self._scene.shapes is None:
            return self._scene.instances == self.index + 1
        return self._mask_of(self._shape.visible_mask, 'masks')

    @property
    def silhouette(self):
        """Its mask as if nothing were in front of it."""
        return self._mask_of(self._shape.silhouette, 'silhouettes')

    @property
    def cuboid(self):
        """The minimum and maximum x, y, z of its bounding box in its frame [m]: 2 x 3."""
        return self._shape.cuboid

    @property
    def keypoints(self):
        """Its keypoints in the image [px]: N x 2, NaN where they cannot be projected."""
        return self._shape.keypoints

    @property
    def keypoints_O(self):
        """Its keypoints in its frame [m]: N x 3."""
        return self._shape.keypoints_O

    @property
    def keypoint_states(self):
        """The keypoints' states: 'visible', 'hidden by another', 'hidden by itself' or 'outside';
        None if no format asked for it."""
        return self._shape.keypoint_states

    @property
    def _shape(self):
        if self._scene.shapes is None:
            raise DatasetError("what is known of objects' shapes is in manifests from version "
                               f'{truth.FIRST_VERSION} on')
        return self._scene.shapes[self.index]

    def _mask_of(self, content, what):
        if content is None:
            raise DatasetError(f'scene {self._scene.index}: no format of this dataset has asked '
                               f'for {what}')
        return truth.mask_of_bytes(content, self._scene.height, self._scene.width)

    def __repr__(self):
        return f'<SceneObject {self.name} ({self.class_name}) of scene {self._scene.index}>'


class Scene:
    """One instant seen by one camera. Files are read on demand."""

    def __init__(self, dataset, row):
        self._dataset = dataset
        self._objects = None
        self._shapes = ()
        self.index = int(row['index'])
        self.instant = int(row['instant'])
        self.stamp_ns = int(row['stamp_ns'])
        self.camera = row['camera']
        self.width, self.height = int(row['width']), int(row['height'])
        self.split = row['split']  # 'train', 'val', 'test', or '' if there are no splits
        self.seed = int(row['seed'])
        self.X_GC = poses.of_rows(row)  # the pose of the optical frame in the global frame, 4 x 4

    @property
    def objects(self):
        """All objects, including those out of view, in the order of `robot_list`."""
        if self._objects is None:
            self._objects = self._dataset.objects_of(self)
        return self._objects

    @property
    def alignment(self):
        """How well all labels match the edges of a recorded picture, 0 to 1, or None."""
        return self._dataset.alignment_of(self)

    @property
    def alignments(self):
        """The alignment of each object that has one, by the object's index."""
        return self._dataset.alignments_of(self)

    @property
    def unmeasured(self):
        """The share of all objects' pixels in a recorded picture for which it is unknown whether
        something hides them, 0 to 1, or None."""
        return self._dataset.cover_of(self)[0]

    @property
    def covered(self):
        """The share of all objects' pixels in a recorded picture that are hidden by something that
        is not in the world, 0 to 1, or None."""
        return self._dataset.cover_of(self)[1]

    @property
    def covers(self):
        """Both shares for each object that has pixels, by the object's index."""
        return self._dataset.covers_of(self)

    @property
    def draws(self):
        """The values drawn at random for this scene: {'lights/sun/intensity': 0.7, ...}"""
        return {name: json.loads(value) for name, value in self._dataset.manifest.rows(
            'SELECT name, value FROM draw WHERE scene = ? ORDER BY name', (self.index,))}

    @property
    def files(self):
        """Its files: a list of (writer, path relative to the writer's folder, file)."""
        return self._dataset.files_of(self)

    @property
    def image_file(self):
        """The path of its image, from any format that has one, preferably as PNG."""
        found = pictures.image_file(self.files)
        if found is None:
            raise self._lacking('an image', 'Coco, ImageFolder and most others')
        return found

    @property
    def image(self):
        """8 bit RGB, height x width x 3."""
        return pictures.read(self.image_file)

    @property
    def depth(self):
        """z in the optical frame [m], 0 where there is nothing: 32 bit, height x width."""
        found = pictures.depth(self.files)
        if found is None:
            raise self._lacking('depth', 'ImageFolder with `depth: true`, RosBag and Bop')
        return found

    @property
    def K(self):
        """The camera matrix, 3 x 3 [px]; pixel centres have whole coordinates."""
        found = truth.camera_matrix(self._dataset.manifest, self.index)
        if found is None:
            raise DatasetError("scenes' cameras are in manifests from version "
                               f'{truth.FIRST_VERSION} on')
        return found

    @property
    def shapes(self):
        """Shapes by object index, with masks and keypoints; None for old manifests."""
        if self._shapes == ():
            self._shapes = truth.shapes_of(self._dataset.manifest, self.index)
        return self._shapes

    @property
    def instances(self):
        """Per pixel, the index + 1 of the object that it shows, or 0: 16 bit, height x width."""
        if self.shapes is not None:
            found = np.zeros((self.height, self.width), np.uint16)
            for each in self.objects:
                found[each.mask] = each.index + 1
            return found
        found = pictures.instances(self.files)
        if found is None:
            raise self._lacking('masks', 'ImageFolder and RosBag')
        return found

    def _lacking(self, what, formats):
        writers = ', '.join(f'{each.name} ({each.type})' for each in self._dataset.writers)
        return DatasetError(f'scene {self.index}: no writer of this dataset has {what} that can be '
                            f'read here: found {writers}; {formats} have')

    def __repr__(self):
        return f'<Scene {self.index} of camera {self.camera}>'


def _number(value):
    return None if value is None or math.isnan(value) else float(value)


def _count(value):
    return None if value is None or math.isnan(value) else int(value)


def _box(row, name):
    edges = [row[f'{name}_{edge}'] for edge in ('left', 'top', 'right', 'bottom')]
    return None if _number(edges[0]) is None else np.array(edges, float)
