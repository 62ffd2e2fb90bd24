"""The example's bag: TF as robots publish it, with nested frames at different rates."""

from typing import List, NamedTuple, Sequence, Tuple

import genpy
import rosbag
from geometry_msgs.msg import TransformStamped
from tf2_msgs.msg import TFMessage

from example.geometry import Pose
from example.trajectories import (BASE_LINK_ON_FOOTPRINT, CAMERA_ON_MAST, DURATION, WHEELS, Drone,
                                  Motion, Rover, camera_mast)

START = 1650000000  # [s] since the epoch
NANOSECONDS = 10 ** 9


class Publisher(NamedTuple):
    """Sends several transforms together, each a (parent, child, motion)."""

    rate: float        # [Hz]
    first: float       # [s] after START
    latency: float     # [s] from a message's stamp to its recording
    transforms: Sequence[Tuple[str, str, Motion]]


def _publishers() -> List[Publisher]:
    drone = Drone()
    result = [
        Publisher(5.0, 0.0, 0.004, [("map", "camera/mast", camera_mast)]),
        # The drone starts late: scenes can only be made after its first pose.
        Publisher(30.0, 0.4, 0.006, [("map", "drone_1/base_link", drone.base_link)]),
    ]
    for k, name in enumerate(("rover_1", "rover_2")):
        rover = Rover(name, drift_phase=0.7 + 2.1 * k)
        phase = 0.003 + 0.004 * k  # no two clocks tick together
        wheels = [(f"{name}/base_link", f"{name}/{wheel}",
                   lambda t, rover=rover, wheel=wheel: rover.wheel(wheel, t)) for wheel in WHEELS]
        result += [
            Publisher(10.0, phase, 0.009, [("map", f"{name}/odom", rover.odom)]),
            Publisher(50.0, phase, 0.002, [(f"{name}/odom", f"{name}/base_footprint",
                                            rover.base_in_odom)]),
            Publisher(30.0, phase + 0.005, 0.003, wheels),
        ]
    return result


def _fixed_transforms() -> List[Tuple[str, str, Pose]]:
    fixed = [("camera/mast", "camera/optical_link", CAMERA_ON_MAST)]
    fixed += [(f"{name}/base_footprint", f"{name}/base_link", BASE_LINK_ON_FOOTPRINT)
              for name in ("rover_1", "rover_2")]
    return fixed


def _time(seconds: float) -> genpy.Time:
    return genpy.Time(START, 0) + genpy.Duration(0, int(round(seconds * NANOSECONDS)))


def _transform(parent: str, child: str, pose: Pose, stamp: genpy.Time) -> TransformStamped:
    message = TransformStamped()
    message.header.stamp = stamp
    message.header.frame_id = parent
    message.child_frame_id = child
    t, r = message.transform.translation, message.transform.rotation
    # Whole micrometres and nine decimals are far finer than what is visible, and compress well.
    t.x, t.y, t.z = (round(value, 6) + 0.0 for value in pose.translation)
    r.x, r.y, r.z, r.w = (round(value, 9) + 0.0 for value in pose.quaternion())
    return message


def _messages() -> List[Tuple[genpy.Time, str, TFMessage]]:
    """All messages, in the order of recording."""
    fixed = [_transform(*each, _time(0.0)) for each in _fixed_transforms()]
    result = [(_time(0.0), "/tf_static", TFMessage(fixed))]
    for publisher in _publishers():
        count = int((DURATION - publisher.first) * publisher.rate + 1e-9) + 1
        for k in range(count):
            t = publisher.first + k / publisher.rate
            transforms = [_transform(parent, child, motion(min(t, DURATION)), _time(t))
                          for parent, child, motion in publisher.transforms]
            result.append((_time(t + publisher.latency), "/tf", TFMessage(transforms)))
    return sorted(result, key=lambda entry: entry[0].to_nsec())


def write(path: str) -> None:
    with rosbag.Bag(path, "w", compression=rosbag.Compression.BZ2) as bag:
        for time, topic, message in _messages():
            bag.write(topic, message, time)
