"""The meshes of the moving objects: x forward, y left, z up."""

import math

from example.geometry import Pose, Vector, from_columns, roll_pitch_yaw
from example.obj_file import Material, MeshFile
from example.shapes import (box, cylinder, extrusion, lathe, mapped, moved, placed, sphere,
                            tiled, tube)
from example.textures import ROVER_TOP_ROWS

# Turns extrusions: z becomes y, y becomes z, for outlines that are given as seen from the side.
SIDEWAYS = from_columns((1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0))
AXLE = roll_pitch_yaw(roll=-0.5 * math.pi)  # z becomes y
FORWARD = roll_pitch_yaw(pitch=0.5 * math.pi)  # z becomes x

ROVER_MATERIALS = {
    "hull": Material(roughness=0.35, texture="hull.png"),
    "hazard": Material(roughness=0.5, texture="hazard.png"),
    "frame": Material((0.15, 0.15, 0.17), roughness=0.55),
    "steel": Material((0.72, 0.73, 0.75), roughness=0.35, metalness=0.9),
    "glass": Material((0.02, 0.03, 0.05), roughness=0.12),
    "white": Material((0.90, 0.90, 0.88), roughness=0.4),
    "stop": Material((0.80, 0.05, 0.05), roughness=0.35),
    "head_light": Material((0.9, 0.9, 0.85), emissive=(0.95, 0.93, 0.82)),
    "tail_light": Material((0.6, 0.05, 0.03), emissive=(0.75, 0.05, 0.03)),
    "status_light": Material((0.1, 0.5, 0.6), emissive=(0.1, 0.75, 0.85)),
}

WHEEL_RADIUS = 0.13
WHEEL_MATERIALS = {
    "rubber": Material((0.10, 0.10, 0.105), roughness=0.85, specular=0.3),
    "rim": Material((0.70, 0.71, 0.73), roughness=0.4, metalness=0.8),
    "hub": Material((0.86, 0.32, 0.08), roughness=0.4),
}


def _hull_mapping(position: Vector, normal: Vector):
    x, y, z = position
    side = 1.0 - ROVER_TOP_ROWS / 256.0
    u = (x + 0.35) / 0.70
    if abs(normal[2]) > 0.6:
        return (u, side + (1.0 - side) * (y + 0.28) / 0.56)
    v = side * min(max((z - 0.135) / 0.13, 0.02), 0.98)
    return (u, v) if abs(normal[1]) > 0.5 else ((y + 0.28) / 0.56 * 0.2 + 0.4, v)


def rover_body() -> MeshFile:
    """The rover without its wheels, in base_link: between the wheels, at the axles' height."""
    mesh = MeshFile(ROVER_MATERIALS)
    outline = [(-0.33, 0.15), (0.30, 0.15), (0.345, 0.185), (0.315, 0.225), (0.20, 0.262),
               (-0.29, 0.262), (-0.345, 0.22)]
    hull = placed(extrusion(outline, 0.55, bevel=0.018), Pose(rotation=SIDEWAYS))
    mesh.add("hull", mapped(hull, _hull_mapping))
    mesh.add("frame",
             moved(box(0.58, 0.37, 0.17, 0.015), z=0.065),
             moved(box(0.30, 0.26, 0.014, 0.004), x=0.02, z=0.268))
    for end in (-1.0, 1.0):
        bumper = moved(box(0.036, 0.46, 0.075, 0.01), x=0.362 * end, z=0.045)
        mesh.add("hazard", mapped(bumper, tiled(0.12)))
        mesh.add("frame", *(tube((0.28 * end, y, 0.04), (0.35 * end, y, 0.04), 0.014)
                            for y in (-0.12, 0.12)))
    _add_deck(mesh)
    _add_mast(mesh)
    for y in (-0.19, 0.19):
        lamp = placed(cylinder(0.022, 0.012, 14), Pose((0.332, y, 0.205), FORWARD))
        mesh.add("head_light", lamp)
        mesh.add("tail_light", moved(box(0.012, 0.07, 0.022), x=-0.342, y=y, z=0.2))
    return mesh


def _add_deck(mesh: MeshFile) -> None:
    """Rails, the lidar and the emergency stop."""
    for y in (-0.215, 0.215):
        posts = [tube((x, y, 0.25), (x, y, 0.30), 0.007, 8) for x in (-0.24, 0.0, 0.17)]
        mesh.add("steel", tube((-0.26, y, 0.30), (0.19, y, 0.30), 0.009), *posts)
    mesh.add("frame", moved(cylinder(0.046, 0.022, 24, 0.004), x=0.10, z=0.286))
    mesh.add("glass", moved(cylinder(0.044, 0.034, 24), x=0.10, z=0.314))
    mesh.add("frame", moved(cylinder(0.046, 0.022, 24, 0.006), x=0.10, z=0.342))
    mesh.add("white", moved(cylinder(0.024, 0.016, 16), x=-0.27, y=-0.13, z=0.268))
    mesh.add("stop", moved(cylinder(0.020, 0.022, 16, 0.005), x=-0.27, y=-0.13, z=0.287))
    mesh.add("frame", tube((-0.27, 0.15, 0.26), (-0.27, 0.15, 0.56), 0.005, 6),
             moved(cylinder(0.014, 0.03, 10), x=-0.27, y=0.15, z=0.275))


def _add_mast(mesh: MeshFile) -> None:
    """The stereo camera's mast."""
    mesh.add("frame", moved(box(0.09, 0.09, 0.03, 0.006), x=-0.11, z=0.285))
    mesh.add("steel", tube((-0.11, 0.0, 0.29), (-0.11, 0.0, 0.56), 0.018, 14))
    mesh.add("white", moved(box(0.085, 0.24, 0.075, 0.014), x=-0.10, z=0.59))
    mesh.add("glass", moved(box(0.008, 0.20, 0.05, 0.003), x=-0.058, z=0.59))
    for y in (-0.062, 0.062):
        lens = lathe([(0.0, 0.0), (0.024, 0.0), (0.024, 0.014), (0.018, 0.014), (0.0, 0.018)], 16)
        mesh.add("frame", placed(lens, Pose((-0.056, y, 0.59), FORWARD)))
    mesh.add("status_light", moved(box(0.05, 0.10, 0.006), x=-0.105, z=0.629))


def wheel() -> MeshFile:
    """A wheel about y, its outer side towards +y."""
    mesh = MeshFile(WHEEL_MATERIALS)
    tyre = lathe([(0.085, -0.042), (0.112, -0.045), (0.123, -0.036), (0.126, 0.0), (0.123, 0.036),
                  (0.112, 0.045), (0.085, 0.042), (0.080, 0.02), (0.080, -0.02),
                  (0.085, -0.042)], 32, crease=0.9)
    mesh.add("rubber", placed(tyre, Pose(rotation=AXLE)))
    for k in range(18):
        angle = 2.0 * math.pi * k / 18
        for side in (-1.0, 1.0):
            turned = angle + (0.0 if side < 0.0 else math.pi / 18)
            lug = placed(box(0.02, 0.034, 0.012),
                         Pose((0.0, 0.022 * side, WHEEL_RADIUS - 0.0066)))
            mesh.add("rubber", placed(lug, Pose(rotation=roll_pitch_yaw(pitch=turned))))
    disc = lathe([(0.0, -0.024), (0.082, -0.024), (0.084, 0.03), (0.074, 0.03), (0.070, 0.006),
                  (0.034, 0.014), (0.0, 0.014)], 32)
    mesh.add("rim", placed(disc, Pose(rotation=AXLE)))
    for k in range(5):
        spoke = placed(box(0.018, 0.012, 0.075, 0.003), Pose((0.0, 0.02, 0.04)))
        mesh.add("rim", placed(spoke, Pose(rotation=roll_pitch_yaw(pitch=0.4 * math.pi * k))))
    cap = moved(cylinder(0.026, 0.036, 20, 0.006), z=0.02)
    mesh.add("hub", placed(cap, Pose(rotation=AXLE)))
    return mesh


DRONE_MATERIALS = {
    "shell": Material(roughness=0.3, texture="shell.png"),
    "carbon": Material((0.13, 0.135, 0.15), roughness=0.45),
    "front_arm": Material((0.92, 0.92, 0.92), roughness=0.4),
    "motor": Material((0.70, 0.72, 0.75), roughness=0.3, metalness=0.9),
    "blade": Material((0.20, 0.21, 0.23), roughness=0.4),
    "blade_tip": Material((0.96, 0.80, 0.12), roughness=0.4),
    "lens": Material((0.02, 0.03, 0.05), roughness=0.1),
    "gimbal": Material((0.80, 0.81, 0.83), roughness=0.35),
    "front_light": Material((0.1, 0.7, 0.2), emissive=(0.1, 0.85, 0.25)),
    "rear_light": Material((0.7, 0.1, 0.1), emissive=(0.9, 0.12, 0.08)),
}
ARM_LENGTH = 0.34
ROTOR_RADIUS = 0.15
ROTOR_ANGLES = (0.3, 1.9, 0.9, 2.6, 1.4, 0.1)  # of the blades against their arms [rad]


def drone() -> MeshFile:
    """A hexacopter; base_link is in the middle of its shell."""
    mesh = MeshFile(DRONE_MATERIALS)
    mesh.add("shell", lathe([(0.0, -0.045), (0.085, -0.045), (0.125, -0.02), (0.135, 0.005),
                             (0.118, 0.035), (0.085, 0.058), (0.045, 0.070), (0.0, 0.074)],
                            36, crease=1.0))
    for k in range(6):
        angle = math.pi / 6.0 + k * math.pi / 3.0
        front = k in (0, 5)
        arm = _drone_arm(ROTOR_ANGLES[k], front)
        turn = Pose(rotation=roll_pitch_yaw(yaw=angle))
        for material, shape in arm:
            mesh.add(material, placed(shape, turn))
    _add_gimbal(mesh)
    _add_skids(mesh)
    mesh.add("carbon", tube((-0.05, 0.0, 0.06), (-0.05, 0.0, 0.12), 0.005, 8))
    mesh.add("gimbal", moved(cylinder(0.026, 0.016, 18, 0.005), x=-0.05, z=0.126))
    return mesh


def _drone_arm(blade_angle: float, front: bool):
    """An arm along x with its motor and rotor, as pairs of material and shape."""
    tip = (ARM_LENGTH, 0.0, 0.012)
    yield ("front_arm" if front else "carbon"), tube((0.10, 0.0, 0.0), tip, 0.013, 10)
    yield "carbon", moved(cylinder(0.026, 0.022, 18, 0.004), x=ARM_LENGTH, z=0.012)
    yield "motor", moved(cylinder(0.023, 0.026, 18, 0.004), x=ARM_LENGTH, z=0.035)
    yield ("front_light" if front else "rear_light"), moved(sphere(0.013, 10, 6), x=ARM_LENGTH,
                                                            z=-0.004)
    spin = Pose((ARM_LENGTH, 0.0, 0.055), roll_pitch_yaw(yaw=blade_angle))
    yield "motor", placed(cylinder(0.009, 0.014, 12), spin)
    for half_turn in (0.0, math.pi):
        twist = spin @ Pose(rotation=roll_pitch_yaw(yaw=half_turn)) @ Pose(
            rotation=roll_pitch_yaw(roll=0.22))
        blade = extrusion([(0.0, -0.007), (0.05, -0.016), (0.118, -0.011), (0.118, 0.010),
                           (0.05, 0.012), (0.0, 0.007)], 0.003)
        end = extrusion([(0.118, -0.011), (ROTOR_RADIUS - 0.004, -0.006), (ROTOR_RADIUS, 0.0),
                         (ROTOR_RADIUS - 0.004, 0.005), (0.118, 0.010)], 0.003)
        yield "blade", placed(blade, twist)
        yield "blade_tip", placed(end, twist)


def _add_gimbal(mesh: MeshFile) -> None:
    mesh.add("carbon", tube((0.06, 0.0, -0.04), (0.06, 0.0, -0.075), 0.01, 10))
    for y in (-0.052, 0.052):
        mesh.add("gimbal", moved(box(0.022, 0.008, 0.06, 0.003), x=0.06, y=y, z=-0.095))
    mesh.add("gimbal", moved(box(0.03, 0.11, 0.01, 0.003), x=0.06, z=-0.07))
    mesh.add("carbon", moved(sphere(0.044, 20, 12), x=0.06, z=-0.108))
    facing = Pose((0.06, 0.0, -0.108)) @ Pose(rotation=roll_pitch_yaw(pitch=0.35)) @ Pose(
        rotation=FORWARD)
    mesh.add("gimbal", placed(moved(cylinder(0.026, 0.02, 18), z=0.04), facing))
    mesh.add("lens", placed(moved(cylinder(0.021, 0.006, 18), z=0.05), facing))


def _add_skids(mesh: MeshFile) -> None:
    for side in (-1.0, 1.0):
        foot = 0.17 * side
        for x in (-0.075, 0.075):
            mesh.add("carbon", tube((x, 0.07 * side, -0.03), (x * 1.2, foot, -0.19), 0.008, 10))
        mesh.add("carbon", tube((-0.16, foot, -0.19), (0.16, foot, -0.19), 0.01, 10))


def write_all(models_folder: str) -> None:
    """Parts to which the models' SDF files give a material of their own are separate files."""
    rover_folder, drone_folder = models_folder + "/rover/meshes", models_folder + "/drone/meshes"
    body, rolling, flying = rover_body(), wheel(), drone()
    body.only("hull").write(rover_folder, "hull")
    body.only("steel").write(rover_folder, "steel")
    body.only("glass").write(rover_folder, "glass")
    body.without("hull", "steel", "glass").write(rover_folder, "fittings")
    rolling.only("rim").write(rover_folder, "rim")
    rolling.without("rim").write(rover_folder, "tyre")
    flying.only("shell").write(drone_folder, "shell")
    flying.only("motor").write(drone_folder, "motors")
    flying.without("shell", "motor").write(drone_folder, "frame")
