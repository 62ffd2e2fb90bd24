"""Vectors, rotations and poses. SI units, radians; X_AB is the pose of frame B in frame A."""

import math
from typing import NamedTuple, Tuple

Vector = Tuple[float, float, float]
Matrix = Tuple[Vector, Vector, Vector]  # rows


def add(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scaled(a: Vector, factor: float) -> Vector:
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a: Vector) -> float:
    return math.sqrt(dot(a, a))


def unit(a: Vector) -> Vector:
    return scaled(a, 1.0 / length(a))


def rotated(rotation: Matrix, a: Vector) -> Vector:
    return (dot(rotation[0], a), dot(rotation[1], a), dot(rotation[2], a))


def product(a: Matrix, b: Matrix) -> Matrix:
    columns = transposed(b)
    return tuple(tuple(dot(row, column) for column in columns) for row in a)


def transposed(a: Matrix) -> Matrix:
    return tuple(zip(*a))


def from_columns(x: Vector, y: Vector, z: Vector) -> Matrix:
    return transposed((x, y, z))


def roll_pitch_yaw(roll: float = 0.0, pitch: float = 0.0, yaw: float = 0.0) -> Matrix:
    """Rotates about the fixed axes x, then y, then z, as in SDF, URDF and tf."""
    cr, sr = math.cos(roll), math.sin(roll)
    cp, sp = math.cos(pitch), math.sin(pitch)
    cy, sy = math.cos(yaw), math.sin(yaw)
    return ((cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
            (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
            (-sp, cp * sr, cp * cr))


def z_axis_along(direction: Vector) -> Matrix:
    """A rotation whose z axis is `direction`; x and y are any that fit."""
    z = unit(direction)
    helper = (1.0, 0.0, 0.0) if abs(z[0]) < 0.9 else (0.0, 1.0, 0.0)
    x = unit(cross(helper, z))
    return from_columns(x, cross(z, x), z)


IDENTITY: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class Pose(NamedTuple):
    translation: Vector = (0.0, 0.0, 0.0)
    rotation: Matrix = IDENTITY

    def __matmul__(self, other: "Pose") -> "Pose":
        """X_AC = X_AB @ X_BC"""
        return Pose(self.apply(other.translation), product(self.rotation, other.rotation))

    def apply(self, point: Vector) -> Vector:
        return add(rotated(self.rotation, point), self.translation)

    def inverse(self) -> "Pose":
        back = transposed(self.rotation)
        return Pose(scaled(rotated(back, self.translation), -1.0), back)

    def quaternion(self) -> Tuple[float, float, float, float]:
        """x, y, z, w of unit length with w >= 0 (Shepperd 1978)."""
        m = self.rotation
        trace = m[0][0] + m[1][1] + m[2][2]
        diagonal = (m[0][0], m[1][1], m[2][2])
        largest = max(range(3), key=lambda i: diagonal[i])
        if trace >= diagonal[largest]:
            w = 0.5 * math.sqrt(1.0 + trace)
            q = [(m[2][1] - m[1][2]) / (4.0 * w), (m[0][2] - m[2][0]) / (4.0 * w),
                 (m[1][0] - m[0][1]) / (4.0 * w), w]
        else:
            i, j, k = largest, (largest + 1) % 3, (largest + 2) % 3
            q = [0.0, 0.0, 0.0, 0.0]
            q[i] = 0.5 * math.sqrt(1.0 + m[i][i] - m[j][j] - m[k][k])
            q[j] = (m[i][j] + m[j][i]) / (4.0 * q[i])
            q[k] = (m[i][k] + m[k][i]) / (4.0 * q[i])
            q[3] = (m[k][j] - m[j][k]) / (4.0 * q[i])
        sign = -1.0 if q[3] < 0.0 else 1.0
        return tuple(sign * component for component in q)
