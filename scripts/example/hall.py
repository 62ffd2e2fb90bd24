"""The hall's mesh: floor, walls, pillars, roof beams, door, windows, floor markings and lamps.

Origin: the middle of the floor. The hall is 10 m along x, 8 m along y and open above.
"""

from example.geometry import Vector, scaled, subtract, unit
from example.obj_file import Material, MeshFile
from example.shapes import (Shape, box, cylinder, inside_out, lathe, mapped, moved, rectangle,
                            tiled, tube)

HALF_X, HALF_Y, HEIGHT = 5.0, 4.0, 4.6
DADO = 1.15  # height of the walls' darker lower part
PILLARS = ((0.45, -2.45), (3.55, 2.05))
BEAMS_X = (-2.6, 0.4, 3.4)
ZONE = (0.55, -0.55, 2.45, 1.45)  # the marked part of the floor: x0, y0, x1, y1
LAMPS = ((1.5, 0.45), (3.9, 0.6))
LAMP_HEIGHT = 3.0

MATERIALS = {
    "floor": Material((0.93, 0.93, 0.93), roughness=0.55, texture="floor.png"),
    "wall": Material((0.90, 0.89, 0.86), roughness=0.9, texture="blocks.png"),
    "dado": Material((0.50, 0.56, 0.58), roughness=0.7, texture="blocks.png"),
    "trim": Material((0.30, 0.33, 0.35), roughness=0.6),
    "column": Material((0.74, 0.74, 0.72), roughness=0.8, texture="blocks.png"),
    "hazard": Material(roughness=0.6, texture="hazard.png"),
    "line": Material((0.84, 0.82, 0.76), roughness=0.6),
    "beam": Material((0.42, 0.45, 0.47), roughness=0.6),
    "door": Material((0.46, 0.52, 0.57), roughness=0.5),
    "frame": Material((0.28, 0.30, 0.32), roughness=0.5),
    "sky": Material((0.1, 0.1, 0.1), emissive=(0.80, 0.88, 0.94)),
    "shade": Material((0.20, 0.24, 0.24), roughness=0.4),
    "bulb": Material((0.9, 0.9, 0.8), emissive=(1.0, 0.95, 0.82)),
}


def hall() -> MeshFile:
    mesh = MeshFile(MATERIALS)
    mesh.add("floor", rectangle((-HALF_X, -HALF_Y, 0.0), (2 * HALF_X, 0.0, 0.0),
                                (0.0, 2 * HALF_Y, 0.0), (HALF_X, HALF_Y)))
    corners = [(-HALF_X, -HALF_Y), (HALF_X, -HALF_Y), (HALF_X, HALF_Y), (-HALF_X, HALF_Y)]
    for start, end in zip(corners, corners[1:] + corners[:1]):
        _add_wall(mesh, (*end, 0.0), (*start, 0.0))  # seen from inside
    _add_markings(mesh)
    _add_door(mesh)
    _add_windows(mesh)
    return mesh


def _strip(start: Vector, end: Vector, low: float, high: float, tile: float) -> Shape:
    along = subtract(end, start)
    width = abs(along[0]) + abs(along[1])
    return rectangle((start[0], start[1], low), along, (0.0, 0.0, high - low),
                     (width / tile, (high - low) / tile))


def _add_wall(mesh: MeshFile, start: Vector, end: Vector) -> None:
    mesh.add("dado", _strip(start, end, 0.0, DADO, 1.6))
    mesh.add("wall", _strip(start, end, DADO, HEIGHT, 1.6))
    for z, height in ((0.06, 0.12), (DADO, 0.05)):
        middle = scaled((start[0] + end[0], start[1] + end[1], 0.0), 0.5)
        inwards = unit(scaled(middle, -1.0))
        along = subtract(end, start)
        size = (abs(along[0]) or 0.03, abs(along[1]) or 0.03)
        mesh.add("trim", moved(box(*size, height), middle[0] + 0.015 * inwards[0],
                               middle[1] + 0.015 * inwards[1], z))


def _flat(x0: float, y0: float, x1: float, y1: float, z: float = 0.003) -> Shape:
    return rectangle((x0, y0, z), (x1 - x0, 0.0, 0.0), (0.0, y1 - y0, 0.0))


def _add_markings(mesh: MeshFile) -> None:
    """The drop zone's border and the edges of a driving lane."""
    x0, y0, x1, y1 = ZONE
    w = 0.11
    for strip in ((x0, y0, x1, y0 + w), (x0, y1 - w, x1, y1),
                  (x0, y0 + w, x0 + w, y1 - w), (x1 - w, y0 + w, x1, y1 - w)):
        mesh.add("hazard", mapped(_flat(*strip), tiled(0.3)))
    for y in (-3.2, -1.0):
        mesh.add("line", _flat(3.1, y - 0.04, 4.97, y + 0.04))
    mesh.add("line", _flat(-0.3, 2.78, 3.3, 2.86))


def _add_door(mesh: MeshFile) -> None:
    """A roller door in the wall at +x."""
    low, high, top = -3.2, -1.0, 2.5
    count = 20
    slat = top / count
    for k in range(count):
        mesh.add("door", moved(box(0.04, high - low, slat - 0.012, 0.012), HALF_X - 0.02,
                               0.5 * (low + high), (k + 0.5) * slat))
    for y in (low - 0.05, high + 0.05):
        mesh.add("frame", moved(box(0.09, 0.1, top + 0.1), HALF_X - 0.045, y, 0.5 * top + 0.05))
    mesh.add("frame", moved(box(0.16, high - low + 0.2, 0.22, 0.02), HALF_X - 0.08,
                            0.5 * (low + high), top + 0.1))


def _add_windows(mesh: MeshFile) -> None:
    """Panes in the walls at +x and +y; bright, as if the sky were behind them."""
    bottom, top = 2.85, 3.85
    for k in range(4):
        x = -2.6 + 2.1 * k
        _add_window(mesh, (x, HALF_Y - 0.02, bottom), (1.7, 0.0, 0.0), top - bottom)
    for y in (-0.3, 1.7):
        _add_window(mesh, (HALF_X - 0.02, y + 1.7, bottom), (0.0, -1.7, 0.0), top - bottom)


def _add_window(mesh: MeshFile, origin: Vector, along: Vector, height: float) -> None:
    mesh.add("sky", rectangle(origin, along, (0.0, 0.0, height)))
    middle = (origin[0] + 0.5 * along[0], origin[1] + 0.5 * along[1])
    bar = 0.07
    flat = tuple(bar if abs(a) < 1e-9 else abs(a) + bar for a in along[:2])
    for z in (0.0, 0.5 * height, height):
        mesh.add("frame", moved(box(*flat, bar if z != 0.5 * height else 0.04), *middle,
                                origin[2] + z))
    for k in range(4):
        x, y = (origin[i] + along[i] * k / 3.0 for i in (0, 1))
        mesh.add("frame", moved(box(bar, bar, height), x, y, origin[2] + 0.5 * height))


def structure() -> MeshFile:
    """Pillars, beams and ceiling lights: the parts that cast shadows."""
    mesh = MeshFile(MATERIALS)
    for x, y in PILLARS:
        column = moved(box(0.32, 0.32, HEIGHT, 0.02), x, y, 0.5 * HEIGHT)
        mesh.add("column", mapped(column, tiled(1.6)))
        guard = moved(box(0.36, 0.36, 0.9, 0.012), x, y, 0.45)
        mesh.add("hazard", mapped(guard, tiled(0.42)))
        mesh.add("trim", moved(box(0.5, 0.5, 0.03), x, y, 0.015))
    reach = 2 * HALF_Y + 5.0  # beyond the walls, or their shadows would end on the floor
    for x in BEAMS_X:
        mesh.add("beam", moved(box(0.20, reach, 0.03), x, 0.0, 4.30),
                 moved(box(0.20, reach, 0.03), x, 0.0, 3.97),
                 moved(box(0.04, reach, 0.32), x, 0.0, 4.135))
    for x, y in LAMPS:
        _add_lamp(mesh, x, y)
    return mesh


def _add_lamp(mesh: MeshFile, x: float, y: float) -> None:
    shade = lathe([(0.20, 0.0), (0.21, 0.01), (0.10, 0.16), (0.04, 0.20), (0.0, 0.20)], 28)
    mesh.add("shade", moved(shade, x, y, LAMP_HEIGHT))
    inside = lathe([(0.0, 0.08), (0.15, 0.06), (0.20, 0.0)], 28)
    mesh.add("bulb", moved(inside_out(inside), x, y, LAMP_HEIGHT))
    mesh.add("shade", tube((x, y, LAMP_HEIGHT + 0.2), (x, y, HEIGHT), 0.01, 8))
    mesh.add("shade", moved(cylinder(0.03, 0.06, 14), x, y, LAMP_HEIGHT + 0.22))


def write_all(models_folder: str) -> None:
    hall().write(models_folder + "/hall/meshes", "hall")
    structure().write(models_folder + "/hall/meshes", "structure")
