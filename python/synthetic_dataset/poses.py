"""Poses as 4 x 4 matrices: X_AB is the pose of B in A, p_A = X_AB @ p_B."""
import numpy as np


def matrices(x, y, z, qx, qy, qz, qw):
    """Poses (N, 4, 4) from positions and unit quaternions, each an array of N numbers."""
    x, y, z, qx, qy, qz, qw = (np.asarray(each, float) for each in (x, y, z, qx, qy, qz, qw))
    poses = np.zeros(x.shape + (4, 4))
    poses[..., 0, 0] = 1 - 2 * (qy * qy + qz * qz)
    poses[..., 0, 1] = 2 * (qx * qy - qz * qw)
    poses[..., 0, 2] = 2 * (qx * qz + qy * qw)
    poses[..., 1, 0] = 2 * (qx * qy + qz * qw)
    poses[..., 1, 1] = 1 - 2 * (qx * qx + qz * qz)
    poses[..., 1, 2] = 2 * (qy * qz - qx * qw)
    poses[..., 2, 0] = 2 * (qx * qz - qy * qw)
    poses[..., 2, 1] = 2 * (qy * qz + qx * qw)
    poses[..., 2, 2] = 1 - 2 * (qx * qx + qy * qy)
    poses[..., 0, 3], poses[..., 1, 3], poses[..., 2, 3], poses[..., 3, 3] = x, y, z, 1
    return poses


def inverse(X_AB):
    """X_BA; (..., 4, 4)."""
    X_BA = np.zeros_like(X_AB)
    R_BA = np.swapaxes(X_AB[..., :3, :3], -1, -2)
    X_BA[..., :3, :3] = R_BA
    X_BA[..., :3, 3] = -np.einsum('...ij,...j->...i', R_BA, X_AB[..., :3, 3])
    X_BA[..., 3, 3] = 1
    return X_BA


def of_rows(columns):
    """The poses in the columns of a manifest table."""
    return matrices(*(columns[name] for name in ('x', 'y', 'z', 'qx', 'qy', 'qz', 'qw')))
