"""Shapes of objects and camera matrices, which manifests have from version 6 on."""
import numpy as np

FIRST_VERSION = 6


def mask_of_bytes(content, height, width):
    """Decodes a mask of the manifest (docs/manifest.md): bool, height x width."""
    numbers = []
    number, shift = 0, 0
    for byte in content:
        number |= (byte & 127) << shift
        shift += 7
        if byte < 128:
            numbers.append(number)
            number, shift = 0, 0
    left, top, box_width, box_height = numbers[:4]
    runs = np.array(numbers[4:], int)
    pixels = np.repeat(np.arange(len(runs)) % 2 == 1, runs)
    mask = np.zeros((height, width), bool)
    mask[top:top + box_height, left:left + box_width] = pixels.reshape(box_height, box_width)
    return mask


class Shape:
    """The shape of one object in one scene."""

    def __init__(self, row, keypoints):
        self.cuboid = np.array([[row[f'{end}_{axis}'] for axis in 'xyz'] for end in ('low', 'high')],
                               float)
        self.visible_mask, self.silhouette = (
            row[name] if isinstance(row[name], bytes) else None  # NaN if no format asked for it
            for name in ('visible_mask', 'silhouette'))
        self.keypoints_O = np.array([each[:3] for each in keypoints], float).reshape(-1, 3)
        self.keypoints = np.array([each[3:5] for each in keypoints], float).reshape(-1, 2)
        self.keypoint_states = [each[5] for each in keypoints]


def shapes_of(manifest, scene_index):
    """The shapes in a scene by object index; None if the manifest does not have them."""
    if int(manifest.run['format_version']) < FIRST_VERSION:
        return None
    keypoints = {}
    for number, *values in manifest.rows(
            'SELECT object, x, y, z, u, v, state FROM scene_keypoint WHERE scene = ? '
            'ORDER BY object, sequence', (scene_index,)):
        keypoints.setdefault(number, []).append(values)
    columns = manifest.columns('scene_shape', 'scene = ?', (scene_index,))
    rows = [{name: column[row] for name, column in columns.items()}
            for row in range(len(columns['object']))]
    return {int(row['object']): Shape(row, keypoints.get(int(row['object']), [])) for row in rows}


def camera_matrix(manifest, scene_index):
    """K of a scene, 3 x 3 [px], for pixel centres at whole coordinates; None for old manifests."""
    if int(manifest.run['format_version']) < FIRST_VERSION:
        return None
    (fx, fy, cx, cy), = manifest.rows(
        'SELECT fx, fy, cx, cy FROM scene_camera WHERE scene = ?', (scene_index,))
    return np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])
