"""Solids as lists of convex polygons, counter-clockwise from outside, with a normal per corner."""

import math
from typing import Callable, List, NamedTuple, Sequence, Tuple

from example.geometry import (Pose, Vector, add, cross, dot, length, rotated, scaled, subtract,
                              unit, z_axis_along)


class Corner(NamedTuple):
    position: Vector
    normal: Vector
    coordinates: Tuple[float, float] = (0.0, 0.0)  # in the texture; (0, 0) is its lower left corner


Polygon = List[Corner]
Shape = List[Polygon]
Mapping = Callable[[Vector, Vector], Tuple[float, float]]  # (position, face normal) to coordinates


def placed(shape: Shape, pose: Pose) -> Shape:
    return [[Corner(pose.apply(c.position), rotated(pose.rotation, c.normal), c.coordinates)
             for c in polygon] for polygon in shape]


def moved(shape: Shape, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Shape:
    return placed(shape, Pose((x, y, z)))


def inside_out(shape: Shape) -> Shape:
    """The shape as it is seen from inside."""
    return [[c._replace(normal=scaled(c.normal, -1.0)) for c in reversed(polygon)]
            for polygon in shape]


def face_normal(polygon: Polygon) -> Vector:
    """Newell's method, for any planar polygon; not normalised: its length is twice the area."""
    total = (0.0, 0.0, 0.0)
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        total = add(total, cross(a.position, b.position))
    return total


def mapped(shape: Shape, mapping: Mapping) -> Shape:
    """The shape with other texture coordinates."""
    result = []
    for polygon in shape:
        normal = unit(face_normal(polygon))
        result.append([c._replace(coordinates=mapping(c.position, normal)) for c in polygon])
    return result


def tiled(size: float) -> Mapping:
    """Projects a texture that is `size` metres wide along each face's main axis."""

    def mapping(position: Vector, normal: Vector) -> Tuple[float, float]:
        axis = max(range(3), key=lambda i: abs(normal[i]))
        u, v = {0: (1, 2), 1: (0, 2), 2: (0, 1)}[axis]
        return (position[u] / size, position[v] / size)

    return mapping


def in_region(shape: Shape, low: Tuple[float, float], high: Tuple[float, float]) -> Shape:
    """Squeezes texture coordinates of 0..1 into a part of the texture."""
    return [[c._replace(coordinates=(low[0] + c.coordinates[0] * (high[0] - low[0]),
                                     low[1] + c.coordinates[1] * (high[1] - low[1])))
             for c in polygon] for polygon in shape]


def _facing(polygon: Polygon, direction: Vector) -> Polygon:
    return polygon if dot(face_normal(polygon), direction) > 0.0 else polygon[::-1]


def rectangle(origin: Vector, along: Vector, up: Vector, repeat=(1.0, 1.0)) -> Shape:
    """One-sided, facing along x up; the texture is repeated `repeat` times."""
    normal = unit(cross(along, up))
    u, v = repeat
    return [[Corner(origin, normal, (0.0, 0.0)),
             Corner(add(origin, along), normal, (u, 0.0)),
             Corner(add(add(origin, along), up), normal, (u, v)),
             Corner(add(origin, up), normal, (0.0, v))]]


def box(x: float, y: float, z: float, bevel: float = 0.0) -> Shape:
    """A centred box. Bevels are shaded as if round: each corner has the normal of its face."""
    half = (0.5 * x, 0.5 * y, 0.5 * z)

    def corner(axis: int, signs: Sequence[int]) -> Corner:
        position = tuple(signs[i] * (half[i] - (0.0 if i == axis else bevel)) for i in range(3))
        normal = tuple(float(signs[i]) if i == axis else 0.0 for i in range(3))
        sideways = signs[1] * signs[0] if axis == 0 else -signs[0] * signs[1]
        u = {0: sideways, 1: sideways, 2: signs[0]}[axis]
        v = signs[1] if axis == 2 else signs[2]
        return Corner(position, normal, (0.5 + 0.5 * u, 0.5 + 0.5 * v))

    octants = [(sx, sy, sz) for sx in (-1, 1) for sy in (-1, 1) for sz in (-1, 1)]
    shape = []
    for axis in range(3):
        a, b = (axis + 1) % 3, (axis + 2) % 3
        for sign in (-1, 1):
            ring = []
            for sa, sb in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                signs = [0, 0, 0]
                signs[axis], signs[a], signs[b] = sign, sa, sb
                ring.append(corner(axis, signs))
            shape.append(_facing(ring, ring[0].normal))
    if bevel <= 0.0:
        return shape
    for along in range(3):
        a, b = (along + 1) % 3, (along + 2) % 3
        for signs in (s for s in octants if s[along] < 0):
            other = tuple(1 if i == along else signs[i] for i in range(3))
            ring = [corner(a, signs), corner(a, other), corner(b, other), corner(b, signs)]
            shape.append(_facing(ring, add(ring[0].normal, ring[2].normal)))
    for signs in octants:
        shape.append(_facing([corner(axis, signs) for axis in range(3)], signs))
    return shape


def lathe(profile: Sequence[Tuple[float, float]], segments: int, crease: float = 0.7) -> Shape:
    """Revolves a profile of (radius, z), given upwards along the outside, about z.

    Edges sharper than `crease` [rad] stay sharp. A profile that ends where it starts is a ring.
    """
    bands = list(zip(profile, profile[1:]))
    normals = []
    spans = []
    for (r0, z0), (r1, z1) in bands:
        span = math.hypot(r1 - r0, z1 - z0)
        spans.append(span)
        normals.append(((z1 - z0) / span, -(r1 - r0) / span))
    closed = profile[0] == profile[-1]

    def blended(i: int, j: int) -> Tuple[float, float]:
        if not closed and not 0 <= j < len(bands):
            return normals[i]
        a, b = normals[i], normals[j % len(bands)]
        if a[0] * b[0] + a[1] * b[1] < math.cos(crease):
            return a
        norm = math.hypot(a[0] + b[0], a[1] + b[1])
        return ((a[0] + b[0]) / norm, (a[1] + b[1]) / norm)

    shape = []
    total = sum(spans)
    done = 0.0
    for i, ((r0, z0), (r1, z1)) in enumerate(bands):
        start, end = blended(i, i - 1), blended(i, i + 1)
        v0, v1 = done / total, (done + spans[i]) / total
        done += spans[i]
        for k in range(segments):
            ring = []
            for step, radius, z, normal, v in ((k, r0, z0, start, v0), (k + 1, r0, z0, start, v0),
                                               (k + 1, r1, z1, end, v1), (k, r1, z1, end, v1)):
                if radius == 0.0 and ring and ring[-1].position == (0.0, 0.0, z):
                    continue
                angle = 2.0 * math.pi * (step % segments) / segments
                c, s = math.cos(angle), math.sin(angle)
                position = (radius * c, radius * s, z) if radius > 0.0 else (0.0, 0.0, z)
                ring.append(Corner(position, (normal[0] * c, normal[0] * s, normal[1]),
                                   (step / segments, v)))
            shape.append(ring)
    return shape


def cylinder(radius: float, height: float, segments: int, bevel: float = 0.0) -> Shape:
    """A centred cylinder about z. A bevel is shaded as a facet."""
    h = 0.5 * height
    if bevel <= 0.0:
        return lathe([(0.0, -h), (radius, -h), (radius, h), (0.0, h)], segments)
    return lathe([(0.0, -h), (radius - bevel, -h), (radius, -h + bevel), (radius, h - bevel),
                  (radius - bevel, h), (0.0, h)], segments, crease=0.9)


def sphere(radius: float, segments: int, rings: int) -> Shape:
    profile = [(radius * math.sin(math.pi * i / rings), -radius * math.cos(math.pi * i / rings))
               for i in range(rings + 1)]
    profile[0], profile[-1] = (0.0, -radius), (0.0, radius)
    return lathe(profile, segments, crease=2.0)


def tube(start: Vector, end: Vector, radius: float, segments: int = 10) -> Shape:
    """A round bar between two points."""
    way = subtract(end, start)
    middle = scaled(add(start, end), 0.5)
    return placed(cylinder(radius, length(way), segments), Pose(middle, z_axis_along(way)))


def _inset(outline: Sequence[Tuple[float, float]], distance: float) -> List[Tuple[float, float]]:
    """A convex, counter-clockwise outline with each edge moved inwards."""
    count = len(outline)
    lines = []
    for i in range(count):
        (x0, y0), (x1, y1) = outline[i], outline[(i + 1) % count]
        norm = math.hypot(x1 - x0, y1 - y0)
        nx, ny = (y1 - y0) / norm, -(x1 - x0) / norm
        lines.append((nx, ny, nx * x0 + ny * y0 - distance))
    result = []
    for i in range(count):
        (a, b, c), (d, e, f) = lines[i - 1], lines[i]
        determinant = a * e - b * d
        result.append(((c * e - b * f) / determinant, (a * f - c * d) / determinant))
    return result


def extrusion(outline: Sequence[Tuple[float, float]], height: float, bevel: float = 0.0) -> Shape:
    """A convex, counter-clockwise outline in x and y, drawn out along z, centred in z."""
    count = len(outline)
    half = 0.5 * height
    inner = _inset(outline, bevel) if bevel > 0.0 else list(outline)
    shape = []
    for sign in (-1.0, 1.0):
        cap = [Corner((x, y, sign * half), (0.0, 0.0, sign)) for x, y in inner]
        shape.append(_facing(cap, (0.0, 0.0, sign)))
    rim = half - bevel
    for i in range(count):
        j = (i + 1) % count
        a, b = outline[i], outline[j]
        normal = unit((b[1] - a[1], a[0] - b[0], 0.0))
        shape.append([Corner((*a, -rim), normal), Corner((*b, -rim), normal),
                      Corner((*b, rim), normal), Corner((*a, rim), normal)])
        for sign in (-1.0, 1.0) if bevel > 0.0 else ():
            cap_normal = (0.0, 0.0, sign)
            ring = [Corner((*a, sign * rim), normal), Corner((*b, sign * rim), normal),
                    Corner((*inner[j], sign * half), cap_normal),
                    Corner((*inner[i], sign * half), cap_normal)]
            shape.append(_facing(ring, add(normal, cap_normal)))
    return shape
