"""The example's textures, drawn pixel by pixel with seeded noise: the same bytes each time."""

import math
import random
from typing import Callable

from example.png_file import Picture, Pixel


class Noise:
    """Smooth noise of 0..1 that repeats every `size` pixels: octaves of interpolated lattices."""

    def __init__(self, seed: int, size: int, cells: int, octaves: int = 3):
        source = random.Random(seed)
        self._size = size
        self._lattices = [[[source.random() for _ in range(cells << k)] for _ in range(cells << k)]
                          for k in range(octaves)]

    def __call__(self, x: float, y: float) -> float:
        total, weight = 0.0, 0.0
        for k, lattice in enumerate(self._lattices):
            share = 0.5 ** k
            total += share * self._interpolated(lattice, x, y)
            weight += share
        return total / weight

    def _interpolated(self, lattice, x: float, y: float) -> float:
        count = len(lattice)
        gx, gy = x * count / self._size, y * count / self._size
        i, j = int(gx), int(gy)
        fx, fy = gx - i, gy - j
        fx, fy = fx * fx * (3.0 - 2.0 * fx), fy * fy * (3.0 - 2.0 * fy)
        upper, lower = lattice[j % count], lattice[(j + 1) % count]
        a, b = upper[i % count], upper[(i + 1) % count]
        c, d = lower[i % count], lower[(i + 1) % count]
        return (a + (b - a) * fx) * (1.0 - fy) + (c + (d - c) * fx) * fy


def _grey(level: float, tint=(1.0, 1.0, 1.0), step: int = 4) -> Pixel:
    """A tinted grey. Coarse steps keep the files small; filtering hides them."""
    level = min(max(int(level / step + 0.5) * step, 0), 255)
    return tuple(min(int(level * channel + 0.5), 255) for channel in tint)


def _shaded(colour: Pixel, factor: float) -> Pixel:
    factor = round(factor * 24.0) / 24.0
    return tuple(min(int(channel * factor + 0.5), 255) for channel in colour)


def _painted(width: int, height: int, colour_at: Callable[[int, int], Pixel]) -> Picture:
    picture = Picture(width, height)
    picture.pixels = [colour_at(x, y) for y in range(height) for x in range(width)]
    return picture


def _shade_all(picture: Picture, factor_at: Callable[[int, int], float]) -> Picture:
    return _painted(picture.width, picture.height,
                    lambda x, y: _shaded(picture[x, y], factor_at(x, y)))


def concrete_floor(size: int = 512) -> Picture:
    """Four slabs with joints; 2 m wide in the hall."""
    clouds, grain = Noise(11, size, 4, 4), Noise(12, size, 96, 1)
    slab_levels = (0.0, -7.0, -4.0, 5.0)
    slab = size // 2

    def colour_at(x: int, y: int) -> Pixel:
        level = 158.0 + slab_levels[(x // slab) + 2 * (y // slab)]
        level += 44.0 * (clouds(x, y) - 0.5) + 16.0 * (grain(x, y) - 0.5)
        from_joint = min(x % slab, slab - 1 - x % slab, y % slab, slab - 1 - y % slab)
        if from_joint < 2:
            level -= 62.0
        elif from_joint < 5:
            level -= 14.0
        return _grey(level, (1.0, 0.985, 0.955))

    return _painted(size, size, colour_at)


def block_wall(size: int = 256) -> Picture:
    """Painted blocks in stretcher bond, four by eight; nearly white, to be tinted."""
    clouds, levels = Noise(21, size, 8, 3), random.Random(22)
    width, height = size // 4, size // 8
    block_level = [[levels.uniform(-6.0, 6.0) for _ in range(4)] for _ in range(8)]

    def colour_at(x: int, y: int) -> Pixel:
        row = y // height
        along = (x + (width // 2 if row % 2 else 0)) % size
        level = 228.0 + block_level[row][along // width] + 26.0 * (clouds(x, y) - 0.5)
        if along % width < 2 or y % height < 2:
            level -= 30.0
        elif y % height == 2:
            level += 8.0
        return _grey(level)

    return _painted(size, size, colour_at)


def wood(seed: int, planks: int, size: int = 128) -> Picture:
    """Boards along x with a grain."""
    clouds, levels = Noise(seed, size, 4, 3), random.Random(seed + 1)
    board = size // planks
    board_level = [levels.uniform(0.86, 1.08) for _ in range(planks)]
    phase = [levels.uniform(0.0, 9.0) for _ in range(planks)]

    def colour_at(x: int, y: int) -> Pixel:
        k = min(y // board, planks - 1)
        rings = math.sin(0.42 * (y + 22.0 * clouds(x * 0.5, y) + 11.0 * phase[k]))
        factor = board_level[k] * (1.0 + 0.09 * rings + 0.22 * (clouds(x, y) - 0.5))
        if y % board < 1:
            factor *= 0.55
        return _shaded((196, 158, 108), factor)

    return _painted(size, size, colour_at)


def crate_face(size: int = 128) -> Picture:
    """A wooden crate's side: boards, a frame and a brace."""
    picture = wood(31, 5, size)
    upright = wood(33, 5, size)
    rim = size // 8

    def part_at(x: int, y: int) -> str:
        from_edge = min(x, y, size - 1 - x, size - 1 - y)
        if from_edge < rim:
            return "frame"
        return "brace" if abs(x - (size - 1 - y)) < rim * 0.8 else "boards"

    def colour_at(x: int, y: int) -> Pixel:
        part = part_at(x, y)
        if part == "boards":
            # Frame and brace, in front of the boards, cast a shadow on them.
            shaded = part_at(max(x - 3, 0), max(y - 3, 0)) != "boards"
            return _shaded(picture[x, y], 0.5 if shaded else 0.76)
        on_upright = part == "frame" and min(x, size - 1 - x) < min(y, size - 1 - y)
        pixel = upright[y, x] if on_upright else upright[x, (y * 3 // 4) % size]
        return _shaded(pixel, 1.06 if part == "frame" else 0.98)

    return _painted(size, size, colour_at)


def carton(size: int = 128) -> Picture:
    """Left half: a cardboard box's side with label and arrows. Right half: its taped lid."""
    picture = Picture(2 * size, size, (176, 134, 88))
    picture.fill(size // 10, size // 2, size // 2, size - size // 8, (226, 222, 212))
    bars = random.Random(41)
    x = size // 10 + 6
    while x < size // 2 - 8:
        width = bars.choice((1, 2, 3))
        picture.fill(x, size // 2 + 8, x + width, size - size // 8 - 16, (42, 40, 38))
        x += width + bars.choice((1, 2, 2, 3))
    picture.fill(size // 10 + 6, size - size // 8 - 10, size // 2 - 20, size - size // 8 - 6,
                 (90, 86, 82))
    for middle in (size * 11 // 16, size * 14 // 16):
        for row in range(14):
            half = row * 8 // 13
            picture.fill(middle - half, 70 + row, middle + half + 1, 71 + row, (70, 48, 30))
        picture.fill(middle - 3, 84, middle + 4, 104, (70, 48, 30))
    picture.fill(0, 0, size, 3, (140, 104, 66))
    picture.fill(size, size * 7 // 16, 2 * size, size * 9 // 16, (206, 176, 122))
    picture.fill(size, size // 2 - 1, 2 * size, size // 2, (120, 88, 54))
    clouds = Noise(42, size, 6, 3)
    return _shade_all(picture, lambda x, y: 0.88 + 0.24 * clouds(x % size, y))


def hazard_stripes(size: int = 64) -> Picture:
    """Diagonal yellow and black; repeats in both directions."""
    worn = Noise(51, size, 8, 2)

    def colour_at(x: int, y: int) -> Pixel:
        yellow = (x + y) % size < size // 2
        return _shaded((232, 184, 24) if yellow else (38, 37, 36), 0.9 + 0.18 * worn(x, y))

    return _painted(size, size, colour_at)


ROVER_TOP_ROWS = 200  # of 256; the strip for the sides is below


def rover_hull(size: int = 256) -> Picture:
    """The rover's hull, nose to the right. Upper part: the deck; lower part: a side."""
    orange, white, seam, dark = (226, 84, 22), (238, 234, 226), (128, 44, 12), (44, 44, 48)
    picture = Picture(size, size, orange)
    for top in (34, 150):
        picture.fill(0, top, size, top + 16, white)
    for x in (62, 190):
        picture.fill(x, 0, x + 2, size, seam)
    for y in range(76, 126, 8):
        picture.fill(12, y, 50, y + 4, dark)
    picture.fill(206, 84, 240, 116, dark)
    picture.fill(0, ROVER_TOP_ROWS, size, size, orange)
    picture.fill(0, ROVER_TOP_ROWS + 34, size, size, dark)
    picture.fill(70, ROVER_TOP_ROWS + 14, 184, ROVER_TOP_ROWS + 22, white)
    for x in range(196, 236, 12):
        for y in range(ROVER_TOP_ROWS + 8, ROVER_TOP_ROWS + 28):
            slant = x + (y - ROVER_TOP_ROWS) // 3
            picture.fill(slant, y, slant + 5, y + 1, white)
    scuffs = Noise(61, size, 10, 3)
    return _shade_all(picture, lambda x, y: 0.9 + 0.2 * scuffs(x, y))


def drone_shell(width: int = 128, height: int = 64) -> Picture:
    """The drone's shell: u runs around it from the nose, v from its belly to its top."""
    blue, white, dark = (18, 112, 214), (236, 238, 240), (40, 44, 52)
    picture = Picture(width, height, blue)
    picture.fill(0, height - 22, width, height, dark)
    picture.fill(0, height - 25, width, height - 22, white)
    for edge in (0, width - 9):
        picture.fill(edge, 0, edge + 9, 30, white)
    for x in range(width // 12, width, width // 6):
        picture.fill(x, 8, x + 1, height - 25, (10, 62, 120))
    picture.fill(0, 8, width, 9, (10, 62, 120))
    return picture


def drum(size: int = 128) -> Picture:
    """A steel drum's mantle, nearly white, to be tinted; with a label."""
    picture = Picture(size, size, (236, 236, 236))
    for y in (size // 3, 2 * size // 3):
        picture.fill(0, y - 2, size, y + 2, (190, 190, 190))
    picture.fill(14, 50, 44, 78, (255, 255, 255))
    for row in range(24):
        half = 11 - abs(row - 12)
        if half >= 0:
            picture.fill(29 - half, 52 + row, 29 + half + 1, 53 + row, (60, 56, 50))
    rust = Noise(71, size, 6, 4)
    return _shade_all(picture, lambda x, y: 0.82 + 0.3 * rust(x, y))


def ball(width: int = 96, height: int = 48) -> Picture:
    """Six sectors and two caps."""

    def colour_at(x: int, y: int) -> Pixel:
        if y < height // 10 or y >= height - height // 10:
            return (240, 238, 230)
        return ((214, 30, 44), (240, 238, 230))[x * 6 // width % 2]

    return _painted(width, height, colour_at)


def pegboard(width: int = 256, height: int = 128) -> Picture:
    """A tool wall: holes, and the outlines of hanging tools."""
    picture = Picture(width, height, (176, 170, 156))
    for y in range(8, height, 16):
        for x in range(8, width, 16):
            picture.fill(x, y, x + 2, y + 2, (96, 92, 84))
    steel, red = (110, 114, 120), (142, 50, 44)
    for x, reach in ((24, 58), (46, 66), (68, 50), (90, 62)):
        picture.fill(x, 22, x + 6, 22 + reach, steel)
        picture.fill(x - 3, 14, x + 9, 26, steel)
        picture.fill(x - 1, 22 + reach, x + 7, 34 + reach, red)
    picture.fill(124, 24, 186, 44, steel)
    picture.fill(150, 44, 160, 92, (150, 112, 70))
    picture.fill(204, 20, 240, 100, (82, 98, 112))
    picture.fill(210, 28, 234, 60, (150, 160, 168))
    return picture


ALL = {
    "hall": {"floor.png": concrete_floor, "blocks.png": block_wall, "hazard.png": hazard_stripes},
    "rack": {"wood.png": lambda: wood(81, 4), "carton.png": carton},
    "pallet": {"wood.png": lambda: wood(83, 2), "carton.png": carton},
    "workbench": {"wood.png": lambda: wood(85, 3), "pegboard.png": pegboard},
    "barrel": {"drum.png": drum},
    "keg": {"drum.png": drum},
    "crate": {"crate.png": crate_face},
    "carton": {"carton.png": carton},
    "ball": {"ball.png": ball},
    "rover": {"hull.png": rover_hull, "hazard.png": hazard_stripes},
    "drone": {"shell.png": drone_shell},
}
