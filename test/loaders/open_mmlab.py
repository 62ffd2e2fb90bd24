"""MMDetection and MMDetection3D without their compiled operators, which no package index has for every Python.

Importing this module before theirs puts stand-ins in the place of what is not installed. What datasets and a small
detector call is implemented here: the voxel that a point falls into, and the overlap of rotated rectangles, which
MMDetection3D has only for GPUs. Everything else raises.
"""
import importlib
import importlib.metadata
import importlib.util
import sys
import types

import cv2
import numpy as np
import shapely

TOOLS = 'mmdet3d/.mim'


class StandIn(types.ModuleType):
    """A module that has every name, and nothing behind it."""

    def __getattr__(self, name):
        if name.startswith('__'):
            raise AttributeError(name)

        def missing(*_arguments, **_named):
            raise NotImplementedError(name)
        return missing


def hard_voxelize_forward(points, voxel_size, coors_range, voxels, coors, num_points_per_voxel, voxel_num, max_points,
                          max_voxels, **_named):
    """mmcv's operator (mmcv/ops/csrc/pytorch/cpu/voxelization.cpp): voxels in the order of their first points, and
    the first points of each."""
    low, high = coors_range[:3].numpy(), coors_range[3:].numpy()
    size = voxel_size.numpy()
    grid = np.round((high - low) / size).astype(int)
    cells = np.floor((points[:, :3].numpy() - low) / size).astype(int)
    number_of = {}
    counts = num_points_per_voxel.numpy()
    for i in np.flatnonzero(np.all((cells >= 0) & (cells < grid), axis=1)):
        cell = tuple(cells[i])
        if cell not in number_of:
            if len(number_of) == max_voxels:
                continue
            number_of[cell] = len(number_of)
        number = number_of[cell]
        if counts[number] < max_points:
            voxels[number, counts[number]] = points[i]
            counts[number] += 1
    if number_of:
        coors.numpy()[:len(number_of)] = np.array(list(number_of))[:, ::-1]  # z, y, x
    voxel_num.fill_(len(number_of))


def rectangles(boxes):
    """The rectangles of rows x, y, width, height, angle: clockwise, as KITTI's rotation is seen from above."""
    x, y, width, height, angle = np.asarray(boxes, float).T[..., None]
    across = np.array([-1, 1, 1, -1]) * width / 2
    along = np.array([-1, -1, 1, 1]) * height / 2
    corners = [x + across * np.cos(angle) + along * np.sin(angle), y - across * np.sin(angle) + along * np.cos(angle)]
    return shapely.polygons(np.stack(corners, -1))


def rotate_iou_gpu_eval(boxes, query_boxes, criterion=-1, device_id=0):
    """mmdet3d/evaluation/functional/kitti_utils/rotate_iou.py: the intersection over union of all pairs, or with
    criterion 2 the intersection."""
    first, second = rectangles(boxes)[:, None], rectangles(query_boxes)[None]
    common = shapely.area(shapely.intersection(first, second))
    if criterion == 2:
        return common
    assert criterion == -1
    return common / (shapely.area(first) + shapely.area(second) - common)


def stand_in(name, **members):
    module = StandIn(name)
    module.__dict__.update(members)
    module.__path__ = []
    sys.modules[name] = module
    return module


def preparation(name):
    """A module of MMDetection3D's data preparation, which is in its wheel beside the package."""
    folder = str(importlib.metadata.distribution('mmdet3d').locate_file(TOOLS))
    if folder not in sys.path:
        sys.path.insert(0, folder)
    return importlib.import_module(f'tools.dataset_converters.{name}')


np.long = np.int64  # they use the name, which NumPy lacks from 1.24 on
stand_in('mmcv._ext', hard_voxelize_forward=hard_voxelize_forward)
stand_in('skimage', io=types.SimpleNamespace(imread=lambda file: cv2.imread(str(file))))
for part in ('', '.lyftdataset', '.utils', '.utils.data_classes', '.eval', '.eval.detection',
             '.eval.detection.mAP_evaluation'):
    stand_in(f'lyft_dataset_sdk{part}')
stand_in('mmdet3d.evaluation.functional.kitti_utils.rotate_iou', rotate_iou_gpu_eval=rotate_iou_gpu_eval)
