"""The poses in the example's recording, as smooth functions of time [s]. M is the map."""

import bisect
import math
from typing import Callable, List, Sequence, Tuple

from example.geometry import Pose, cross, from_columns, roll_pitch_yaw, unit
from example.vehicles import WHEEL_RADIUS

DURATION = 8.0  # [s]

AXLE_HEIGHT = 0.13
TRACK = 0.50       # between the centres of a left and a right wheel [m]
HALF_BASE = 0.23   # from base_link to an axle [m]
WHEELS = {"wheel_front_left": (HALF_BASE, 0.5 * TRACK),
          "wheel_front_right": (HALF_BASE, -0.5 * TRACK),
          "wheel_rear_left": (-HALF_BASE, 0.5 * TRACK),
          "wheel_rear_right": (-HALF_BASE, -0.5 * TRACK)}

# t, x, y on the floor. Each rover keeps clear of everything that stands there, and of the other.
ROVER_WAYPOINTS = {
    "rover_1": [(0.0, 2.75, -2.30), (1.2, 1.50, -1.95), (2.5, 0.05, -1.78), (3.3, -0.85, -1.75),
                (4.2, -1.85, -1.45), (5.0, -2.30, -0.75), (5.9, -2.45, 0.25), (6.8, -2.30, 1.20),
                (8.0, -1.65, 2.25)],
    "rover_2": [(0.0, -1.20, 2.35), (1.2, -0.85, 1.30), (2.3, -0.45, 0.30), (3.3, 0.10, -0.55),
                (4.4, 1.20, -1.30), (5.4, 2.30, -1.25), (6.3, 2.85, -0.60), (7.2, 2.95, 0.30),
                (8.0, 2.80, 1.10)],
}
# t, x, y, z, yaw
DRONE_WAYPOINTS = [(0.0, 3.20, 1.20, 2.00, -2.80), (0.8, 2.75, 1.30, 1.95, -2.80),
                   (2.0, 1.60, 1.05, 1.80, -2.70), (3.5, -0.30, 0.40, 1.55, -2.50),
                   (4.8, -1.45, -0.35, 1.32, -2.20), (5.8, -1.85, -1.30, 1.08, -1.50),
                   (6.8, -1.05, -1.95, 1.12, -0.50), (8.0, 0.20, -1.40, 1.50, 0.30)]

CAMERA_POSITION = (-4.0, -2.9, 1.35)
CAMERA_YAW = math.radians(33.0)
CAMERA_TILT = math.radians(9.0)  # downwards
CAMERA_STARTS, CAMERA_STOPS = 3.4, 7.6  # [s]; the camera stands still before and after
CAMERA_DOLLY = (0.22, -0.30, 0.10)  # [m]
CAMERA_PAN = math.radians(5.0)

OPTICAL = roll_pitch_yaw(roll=-0.5 * math.pi, yaw=-0.5 * math.pi)  # REP 103: z forward, y down
GRAVITY = 9.81  # [m/s^2]


def smooth_step(x: float) -> float:
    """0 to 1 with no speed and no acceleration at either end (Perlin 2002)."""
    x = min(max(x, 0.0), 1.0)
    return x * x * x * (x * (6.0 * x - 15.0) + 10.0)


class CubicSpline:
    """Natural cubic spline: continuous up to its second derivative."""

    def __init__(self, points: Sequence[Tuple[float, float]]):
        self._x = [x for x, _ in points]
        self._y = [y for _, y in points]
        self._m = self._second_derivatives()

    def _second_derivatives(self) -> List[float]:
        """Thomas' algorithm on the tridiagonal system of the knots' second derivatives."""
        x, y, count = self._x, self._y, len(self._x)
        upper, right = [0.0] * count, [0.0] * count
        for i in range(1, count - 1):
            h0, h1 = x[i] - x[i - 1], x[i + 1] - x[i]
            pivot = 2.0 * (h0 + h1) - h0 * upper[i - 1]
            upper[i] = h1 / pivot
            slope = (y[i + 1] - y[i]) / h1 - (y[i] - y[i - 1]) / h0
            right[i] = (6.0 * slope - h0 * right[i - 1]) / pivot
        m = [0.0] * count
        for i in range(count - 2, 0, -1):
            m[i] = right[i] - upper[i] * m[i + 1]
        return m

    def __call__(self, t: float, derivative: int = 0) -> float:
        i = min(max(bisect.bisect_right(self._x, t) - 1, 0), len(self._x) - 2)
        h = self._x[i + 1] - self._x[i]
        a, b = (self._x[i + 1] - t) / h, (t - self._x[i]) / h
        y0, y1, m0, m1 = self._y[i], self._y[i + 1], self._m[i], self._m[i + 1]
        if derivative == 0:
            return a * y0 + b * y1 + ((a ** 3 - a) * m0 + (b ** 3 - b) * m1) * h * h / 6.0
        if derivative == 1:
            return (y1 - y0) / h + ((1.0 - 3.0 * a * a) * m0 + (3.0 * b * b - 1.0) * m1) * h / 6.0
        return a * m0 + b * m1


def _splines(waypoints) -> List[CubicSpline]:
    return [CubicSpline([(point[0], point[k]) for point in waypoints])
            for k in range(1, len(waypoints[0]))]


class Rover:
    """Drives forwards along its waypoints."""

    def __init__(self, name: str, drift_phase: float):
        self._x, self._y = _splines(ROVER_WAYPOINTS[name])
        self._drift_phase = drift_phase
        self._start = self.base_footprint(0.0)
        self._distance = self._wheel_distances()

    def base_footprint(self, t: float) -> Pose:
        """X_MB"""
        yaw = math.atan2(self._y(t, 1), self._x(t, 1))
        return Pose((self._x(t), self._y(t), 0.0), roll_pitch_yaw(yaw=yaw))

    def odom(self, t: float) -> Pose:
        """X_MO: the rover's first pose, plus the error of its odometry since then.

        The odometry drifts, and the localisation corrects it now and then.
        """
        corrected = 0.6 * smooth_step((t - 2.6) / 0.4) + 0.8 * smooth_step((t - 5.7) / 0.4)
        error = t / DURATION - 0.5 * corrected
        side = math.sin(self._drift_phase)
        slip = Pose((0.06 * error, 0.05 * side * error, 0.0),
                    roll_pitch_yaw(yaw=0.03 * math.cos(self._drift_phase) * error))
        return self._start @ slip

    def base_in_odom(self, t: float) -> Pose:
        """X_OB"""
        return self.odom(t).inverse() @ self.base_footprint(t)

    def wheel(self, wheel: str, t: float) -> Pose:
        """The pose of a wheel in base_link; its angle is that of rolling without slip."""
        x, y = WHEELS[wheel]
        distance = self._distance[0 if y > 0.0 else 1]
        step = DURATION / (len(distance) - 1)
        i = min(int(t / step), len(distance) - 2)
        along = distance[i] + (distance[i + 1] - distance[i]) * (t / step - i)
        return Pose((x, y, 0.0), roll_pitch_yaw(pitch=along / WHEEL_RADIUS))

    def _wheel_distances(self, steps: int = 1600) -> Tuple[List[float], List[float]]:
        """Distances that the left and the right wheels have rolled [m], by the midpoint rule."""
        left, right = [0.0], [0.0]
        dt = DURATION / steps
        for k in range(steps):
            t = (k + 0.5) * dt
            vx, vy, ax, ay = self._x(t, 1), self._y(t, 1), self._x(t, 2), self._y(t, 2)
            speed = math.hypot(vx, vy)
            turn = (vx * ay - vy * ax) / (speed * speed)
            left.append(left[-1] + (speed - 0.5 * TRACK * turn) * dt)
            right.append(right[-1] + (speed + 0.5 * TRACK * turn) * dt)
        return left, right


class Drone:
    """Flies along its waypoints and tilts as its accelerations require."""

    def __init__(self):
        self._x, self._y, self._z, self._yaw = _splines(DRONE_WAYPOINTS)

    def base_link(self, t: float) -> Pose:
        thrust = unit((self._x(t, 2), self._y(t, 2), self._z(t, 2) + GRAVITY))
        yaw = self._yaw(t)
        left = unit(cross(thrust, (math.cos(yaw), math.sin(yaw), 0.0)))
        sway = 0.012 * math.sin(5.1 * t)
        return Pose((self._x(t), self._y(t) + sway, self._z(t) + 0.5 * sway),
                    from_columns(cross(left, thrust), left, thrust))


def camera_mast(t: float) -> Pose:
    """The mast's pose: x forward, z up. It stands, then glides and turns."""
    share = smooth_step((t - CAMERA_STARTS) / (CAMERA_STOPS - CAMERA_STARTS))
    position = tuple(p + share * d for p, d in zip(CAMERA_POSITION, CAMERA_DOLLY))
    return Pose(position, roll_pitch_yaw(yaw=CAMERA_YAW + share * CAMERA_PAN))


CAMERA_ON_MAST = Pose((0.0, 0.0, 0.0), roll_pitch_yaw(pitch=CAMERA_TILT)) @ Pose(rotation=OPTICAL)
BASE_LINK_ON_FOOTPRINT = Pose((0.0, 0.0, AXLE_HEIGHT))

Motion = Callable[[float], Pose]
