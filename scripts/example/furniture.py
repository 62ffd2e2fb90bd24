"""The meshes of the things that stand in the hall, and of those that fall at the start.

Things that stand have their origin in the middle of the foot, things that fall in their middle.
"""

from typing import Tuple

from example.geometry import Pose, roll_pitch_yaw
from example.obj_file import Material, MeshFile
from example.shapes import (Shape, box, cylinder, in_region, lathe, mapped, moved, placed, sphere,
                            tiled, tube)

RACK = {
    "upright": Material((0.25, 0.36, 0.46), roughness=0.5),
    "rail": Material((0.66, 0.42, 0.26), roughness=0.5),
    "wood": Material(roughness=0.8, texture="wood.png"),
    "carton": Material(roughness=0.9, texture="carton.png"),
    "carton_dark": Material((0.82, 0.80, 0.78), roughness=0.9, texture="carton.png"),
    "bin": Material((0.36, 0.46, 0.48), roughness=0.5),
    "bin_light": Material((0.62, 0.60, 0.52), roughness=0.5),
}
RACK_LEVELS = (0.25, 1.05, 1.85)

PALLET = {
    "wood": Material((0.92, 0.90, 0.88), roughness=0.85, texture="wood.png"),
    "carton": Material(roughness=0.9, texture="carton.png"),
}

WORKBENCH = {
    "wood": Material(roughness=0.5, texture="wood.png"),
    "steel": Material((0.38, 0.42, 0.45), roughness=0.5),
    "drawer": Material((0.45, 0.50, 0.52), roughness=0.45),
    "board": Material(roughness=0.9, texture="pegboard.png"),
    "screen": Material((0.02, 0.03, 0.04), roughness=0.3, emissive=(0.16, 0.30, 0.36)),
    "black": Material((0.10, 0.10, 0.11), roughness=0.5),
    "toolbox": Material((0.48, 0.18, 0.15), roughness=0.4),
    "metal": Material((0.60, 0.61, 0.63), roughness=0.4, metalness=0.8),
}

DRUM = {
    "mantle": Material((0.33, 0.46, 0.50), roughness=0.45, texture="drum.png"),
    "lid": Material((0.28, 0.38, 0.42), roughness=0.45),
    "cap": Material((0.62, 0.60, 0.55), roughness=0.4, metalness=0.6),
}
KEG = {
    "mantle": Material((0.98, 0.78, 0.08), roughness=0.4, texture="drum.png"),
    "lid": Material((0.90, 0.68, 0.05), roughness=0.4),
    "cap": Material((0.20, 0.20, 0.22), roughness=0.4),
}
CRATE = {"planks": Material((1.0, 0.96, 0.90), roughness=0.8, texture="crate.png")}
CARTON = {"carton": Material((1.0, 1.0, 1.0), roughness=0.9, texture="carton.png")}
BALL = {"ball": Material(roughness=0.35, texture="ball.png")}
TOTE = {
    "plastic": Material((0.05, 0.55, 0.42), roughness=0.4),
    "inside": Material((0.03, 0.36, 0.28), roughness=0.6),
}


def carton_box(x: float, y: float, z: float) -> Shape:
    """A cardboard box, centred; its sides and its lid each use their half of the texture."""
    shape = []
    for polygon in box(x, y, z, 0.006):
        upright = abs(polygon[0].normal[2]) > 0.5
        low, high = ((0.5, 0.0), (1.0, 1.0)) if upright else ((0.0, 0.0), (0.5, 1.0))
        shape += in_region([polygon], low, high)
    return shape


def _standing(size: Tuple[float, float, float], x: float, y: float, z: float,
              yaw: float = 0.0) -> Shape:
    return placed(carton_box(*size), Pose((x, y, z + 0.5 * size[2]), roll_pitch_yaw(yaw=yaw)))


def rack() -> MeshFile:
    """2.7 m along x, 0.8 m deep, its front towards -y."""
    mesh = MeshFile(RACK)
    for x in (-1.32, 0.0, 1.32):
        for y in (-0.37, 0.37):
            mesh.add("upright", moved(box(0.06, 0.06, 2.6, 0.004), x, y, 1.3))
        for z in (0.35, 0.95, 1.55, 2.15):
            mesh.add("upright", tube((x, -0.34, z), (x, 0.34, z + 0.45), 0.012, 6))
    for level in RACK_LEVELS:
        for y in (-0.37, 0.37):
            mesh.add("rail", moved(box(2.58, 0.045, 0.10, 0.006), 0.0, y, level - 0.05))
        shelf = moved(box(2.58, 0.70, 0.03), 0.0, 0.0, level + 0.0)
        mesh.add("wood", mapped(shelf, tiled(0.7)))
    _load_rack(mesh, [level + 0.016 for level in RACK_LEVELS])
    return mesh


def _load_rack(mesh: MeshFile, levels) -> None:
    low, middle, high = levels
    mesh.add("carton",
             _standing((0.50, 0.50, 0.46), -0.95, -0.05, low, 0.05),
             _standing((0.42, 0.46, 0.34), 0.35, -0.06, low, -0.08),
             _standing((0.36, 0.40, 0.28), 0.33, -0.06, low + 0.341, 0.15),
             _standing((0.52, 0.44, 0.40), 0.42, 0.0, middle, 0.04),
             _standing((0.40, 0.44, 0.50), -0.35, -0.05, high, -0.06),
             _standing((0.44, 0.46, 0.36), 0.98, -0.04, high, 0.1))
    mesh.add("carton_dark",
             _standing((0.38, 0.48, 0.40), -0.40, -0.04, low, -0.06),
             _standing((0.46, 0.50, 0.52), 0.95, -0.02, low, 0.06),
             _standing((0.50, 0.50, 0.30), -0.92, -0.03, middle, -0.03),
             _standing((0.42, 0.42, 0.24), -0.94, -0.05, middle + 0.301, 0.2),
             _standing((0.56, 0.44, 0.32), 0.38, 0.0, high, 0.02))
    for x, material in ((-0.42, "bin"), (-0.18, "bin_light"), (0.88, "bin"), (1.13, "bin_light")):
        mesh.add(material, moved(box(0.21, 0.40, 0.20, 0.015), x, -0.12, middle + 0.10))
    for x, material in ((-1.08, "bin_light"), (-0.80, "bin")):
        mesh.add(material, moved(box(0.23, 0.42, 0.24, 0.015), x, -0.10, high + 0.12))


def _one_pallet(z: float) -> Shape:
    boards = []
    for y in (-0.34, 0.0, 0.34):
        boards.append(moved(box(1.2, 0.12, 0.022), 0.0, y, z + 0.011))
        boards += [moved(box(0.14, 0.12, 0.08), x, y, z + 0.062) for x in (-0.53, 0.0, 0.53)]
    boards += [moved(box(0.12, 0.80, 0.02), x, 0.0, z + 0.112) for x in (-0.54, 0.0, 0.54)]
    boards += [moved(box(1.2, 0.11, 0.022), 0.0, y, z + 0.133)
               for y in (-0.345, -0.172, 0.0, 0.172, 0.345)]
    return mapped([polygon for board in boards for polygon in board], tiled(0.6))


def pallet_stack() -> MeshFile:
    """Three pallets, 1.2 m along x, with cartons on top."""
    mesh = MeshFile(PALLET)
    for k, yaw in enumerate((0.0, 0.03, -0.02)):
        mesh.add("wood", placed(_one_pallet(0.0), Pose((0.0, 0.0, 0.145 * k),
                                                       roll_pitch_yaw(yaw=yaw))))
    top = 0.436
    mesh.add("carton", _standing((0.54, 0.50, 0.42), -0.28, 0.05, top, 0.08),
             _standing((0.44, 0.56, 0.32), 0.28, -0.02, top, -0.05),
             _standing((0.40, 0.40, 0.30), -0.24, 0.04, top + 0.421, 0.5))
    return mesh


def workbench() -> MeshFile:
    """1.9 m along y, 0.75 m deep, its front towards -x, a tool wall behind it."""
    mesh = MeshFile(WORKBENCH)
    mesh.add("wood", mapped(moved(box(0.75, 1.9, 0.05, 0.006), z=0.875), tiled(0.6)))
    for y in (-0.88, 0.88):
        for x in (-0.31, 0.31):
            mesh.add("steel", moved(box(0.06, 0.06, 0.85), x, y, 0.425))
        mesh.add("steel", moved(box(0.56, 0.04, 0.05), 0.0, y, 0.20))
    mesh.add("steel", moved(box(0.04, 1.72, 0.05), 0.29, 0.0, 0.20))
    mesh.add("steel", moved(box(0.60, 0.50, 0.55, 0.008), 0.02, 0.55, 0.57))
    for z in (0.40, 0.57, 0.74):
        mesh.add("drawer", moved(box(0.02, 0.46, 0.15, 0.006), -0.285, 0.55, z))
        mesh.add("metal", tube((-0.31, 0.43, z + 0.03), (-0.31, 0.67, z + 0.03), 0.008, 8))
    board = moved(box(0.03, 1.8, 0.9), 0.35, 0.0, 1.50)
    mesh.add("board", board)
    _add_screen(mesh)
    mesh.add("toolbox", moved(box(0.24, 0.44, 0.20, 0.012), 0.02, 0.58, 1.0))
    mesh.add("metal", tube((0.02, 0.48, 1.13), (0.02, 0.68, 1.13), 0.01, 8))
    mesh.add("metal", moved(box(0.16, 0.10, 0.10, 0.01), -0.26, -0.60, 0.95),
             moved(box(0.05, 0.14, 0.07, 0.006), -0.31, -0.60, 1.02),
             tube((-0.40, -0.60, 0.95), (-0.20, -0.60, 0.95), 0.012, 8))
    return mesh


def _add_screen(mesh: MeshFile) -> None:
    mesh.add("black", moved(box(0.18, 0.26, 0.02), 0.12, -0.12, 0.91),
             moved(box(0.03, 0.05, 0.22), 0.15, -0.12, 1.02),
             moved(box(0.035, 0.56, 0.35, 0.008), 0.12, -0.12, 1.25),
             moved(box(0.16, 0.42, 0.02), -0.16, -0.12, 0.91))
    mesh.add("screen", moved(box(0.004, 0.52, 0.31), 0.101, -0.12, 1.25))


def drum(materials, radius: float, height: float) -> MeshFile:
    """A steel drum about z, centred."""
    mesh = MeshFile(materials)
    h, r = 0.5 * height, 0.965 * radius
    rib, rim = 0.02 * height, 0.012 * height
    outline = [(r, -h + rim)]
    for z in (-height / 6.0, height / 6.0):
        outline += [(r, z - rib), (radius, z), (r, z + rib)]
    outline.append((r, h - rim))
    mesh.add("mantle", lathe(outline, 36, crease=0.3))
    mesh.add("lid", lathe([(0.0, -h), (radius, -h), (radius, -h + rim), (r, -h + rim)], 36),
             lathe([(r, h - rim), (radius, h - rim), (radius, h), (0.95 * r, h),
                    (0.95 * r, h - rim), (0.0, h - rim)], 36))
    mesh.add("cap", moved(cylinder(0.13 * radius, 2.0 * rim, 14), 0.55 * radius, 0.0, h - rim))
    return mesh


def crate(size: float = 0.40) -> MeshFile:
    mesh = MeshFile(CRATE)
    mesh.add("planks", box(size, size, size, 0.01))
    return mesh


def carton() -> MeshFile:
    mesh = MeshFile(CARTON)
    mesh.add("carton", carton_box(0.36, 0.30, 0.26))
    return mesh


def ball(radius: float = 0.15) -> MeshFile:
    mesh = MeshFile(BALL)
    turned = roll_pitch_yaw(roll=0.6, pitch=0.3)
    mesh.add("ball", placed(sphere(radius, 30, 16), Pose(rotation=turned)))
    return mesh


def tote() -> MeshFile:
    """An open plastic box of 0.40 x 0.30 x 0.22 m."""
    mesh = MeshFile(TOTE)
    x, y, z, wall = 0.40, 0.30, 0.22, 0.012
    mesh.add("plastic", moved(box(x - 0.02, wall, z), y=0.5 * (y - wall) - 0.01),
             moved(box(x - 0.02, wall, z), y=-0.5 * (y - wall) + 0.01),
             moved(box(wall, y - 0.02, z), x=0.5 * (x - wall) - 0.01),
             moved(box(wall, y - 0.02, z), x=-0.5 * (x - wall) + 0.01))
    mesh.add("inside", moved(box(x - 0.02, y - 0.02, 0.015), z=-0.5 * z + 0.0075))
    rim = 0.03
    for side in (-1.0, 1.0):
        mesh.add("plastic",
                 moved(box(x, 0.022, rim, 0.006), y=side * 0.5 * (y - 0.022), z=0.5 * (z - rim)),
                 moved(box(0.022, y, rim, 0.006), x=side * 0.5 * (x - 0.022), z=0.5 * (z - rim)))
        mesh.add("plastic", *(moved(box(0.014, 0.014, z - 0.03), u, side * 0.5 * (y - 0.018))
                              for u in (-0.12, 0.0, 0.12)))
    return mesh


def write_all(models_folder: str) -> None:
    meshes = {"rack": rack(), "pallet": pallet_stack(), "workbench": workbench(),
              "barrel": drum(DRUM, 0.29, 0.88), "keg": drum(KEG, 0.15, 0.40), "crate": crate(),
              "carton": carton(), "ball": ball(), "tote": tote()}
    for name, mesh in meshes.items():
        mesh.write(f"{models_folder}/{name}/meshes", name)
