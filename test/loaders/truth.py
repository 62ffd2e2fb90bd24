"""All that the software knows about a dataset, without any format: what test/Truth wrote.

Boxes and keypoints are in OpenCV's pixel coordinates: the first pixel's centre is (0, 0).
"""
import functools
import json
import pathlib

import cv2
import numpy as np


def read_picture(file):
    """The pixels as they are in the file; colours in the order blue, green, red."""
    picture = cv2.imread(str(file), cv2.IMREAD_UNCHANGED)
    if picture is None:
        raise FileNotFoundError(file)
    return picture


class Object:
    """One object in one scene; its attributes are the fields of the scene's JSON file."""

    def __init__(self, folder, scene_name, content):
        self._files = str(folder / scene_name)
        self.__dict__.update(content)
        self.X_GO = np.array(content['X_GO'])
        self.X_CO = np.array(content['X_CO'])
        self.keypoints_O = np.array(content['keypoints_O']).reshape(-1, 3)

    @functools.cached_property
    def silhouette(self):
        return read_picture(f'{self._files}.silhouette_{self.instance}.png') > 0

    @functools.cached_property
    def visible(self):
        return read_picture(f'{self._files}.visible_{self.instance}.png') > 0

    @property
    def visible_pixel_box(self):
        """The first and last columns and rows of the visible mask: left, top, right, bottom."""
        rows, columns = np.nonzero(self.visible)
        return columns.min(), rows.min(), columns.max(), rows.max()

    @property
    def cuboid_corners_C(self):
        """8 x 3 in the camera's frame; corner i has the high x if i & 4, y if i & 2, z if i & 1."""
        ends = np.array(self.cuboid_O)
        corners = [[ends[i >> 2 & 1][0], ends[i >> 1 & 1][1], ends[i & 1][2]] for i in range(8)]
        return self.to_camera(np.array(corners))

    def to_camera(self, points_O):
        return np.asarray(points_O) @ self.X_CO[:3, :3].T + self.X_CO[:3, 3]


class Cloud:
    """A lidar's measurements of a scene, point by point."""

    def __init__(self, content):
        self.X_GS = np.array(content['X_GS'])
        numbers = np.array(content['points'], float).reshape(-1, 9)
        self.points = numbers[:, :3]  # as if the scanner had stood still
        self.intensities = numbers[:, 3]
        self.rings, self.columns, self.instances, self.classes, self.world_classes = (
            numbers[:, 4:].astype(int).T)


class Scene:
    """One scene; its attributes are the fields of its JSON file."""

    def __init__(self, folder, name):
        self._files = str(folder / name)
        content = json.loads((folder / f'{name}.json').read_text(encoding='utf-8'))
        self.__dict__.update(content)
        self.objects = [Object(folder, name, each) for each in content['objects']]
        self.X_GC = np.array(content['X_GC'])
        self.K = np.array(self.camera['K'])
        self.width = self.camera['width']
        self.height = self.camera['height']

    @property
    def flat_name(self):
        return self.name.replace('/', '_')

    @property
    def split_or_train(self):
        return self.split or 'train'

    @property
    def labelled(self):
        return [each for each in self.objects if each.labelled]

    @functools.cached_property
    def image(self):
        return read_picture(f'{self._files}.image.png')

    @functools.cached_property
    def cloud(self):
        return Cloud(json.loads(pathlib.Path(f'{self._files}.cloud.json').read_text()))

    @functools.cached_property
    def instances(self):
        return read_picture(f'{self._files}.instances.png')

    @functools.cached_property
    def classes(self):
        return read_picture(f'{self._files}.classes.png')

    @functools.cached_property
    def depth(self):
        return read_picture(f'{self._files}.depth.tiff')

    def project(self, points_C):
        """N x 2 pixels of points in front of the camera, through its lens."""
        points = np.asarray(points_C, float)
        lens = np.array(self.camera['D'])
        return cv2.projectPoints(points, np.zeros(3), np.zeros(3), self.K, lens)[0][:, 0]


class Truth:
    """A whole dataset."""

    def __init__(self, folder):
        folder = pathlib.Path(folder)
        content = json.loads((folder / 'dataset.json').read_text(encoding='utf-8'))
        self.classes = content['classes']
        self.splits = [each['name'] for each in content['splits']] or ['train']
        self.objects = content['objects']
        self.cameras = content['cameras']
        self.class_names = {each['id']: each['name'] for each in self.classes}
        self.scenes = [Scene(folder, name) for name in content['scenes']]

    def of_split(self, split):
        return [scene for scene in self.scenes if scene.split_or_train == split]
