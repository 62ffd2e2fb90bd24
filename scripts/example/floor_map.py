"""The occupancy map of the example's hall, in map_server's format: white is free, black is not."""

import math
import os
from typing import List, NamedTuple

from .png_file import Picture

RESOLUTION = 0.05  # [m/cell]
LEFT, RIGHT, BOTTOM, TOP = -5.2, 5.2, -4.2, 4.2  # [m]

FREE = (254, 254, 254)
OCCUPIED = (0, 0, 0)


class Footprint(NamedTuple):
    """A box as seen from above: its middle [m], sizes [m] and heading [rad]."""
    x: float
    y: float
    length: float
    width: float
    heading: float = 0.0

    def covers(self, x: float, y: float, margin: float) -> bool:
        cosine, sine = math.cos(self.heading), math.sin(self.heading)
        along = cosine * (x - self.x) + sine * (y - self.y)
        across = -sine * (x - self.x) + cosine * (y - self.y)
        return abs(along) <= self.length / 2 + margin and abs(across) <= self.width / 2 + margin


# The things that stand on the floor in worlds/example.sdf and models/hall.
STANDING: List[Footprint] = [
    Footprint(5.1, 0.0, 0.2, 8.4), Footprint(-5.1, 0.0, 0.2, 8.4),  # walls
    Footprint(0.0, 4.1, 10.0, 0.2), Footprint(0.0, -4.1, 10.0, 0.2),
    Footprint(0.45, -2.45, 0.6, 0.6), Footprint(3.55, 2.05, 0.6, 0.6),  # pillars, their feet
    Footprint(1.60, 3.50, 2.70, 0.80),  # rack
    Footprint(-0.95, 3.40, 1.22, 0.84, 0.06), Footprint(4.30, -0.40, 1.22, 0.84, 1.62),  # pallets
    Footprint(4.55, 1.30, 0.80, 1.90),  # workbench
    Footprint(4.45, 3.45, 0.58, 0.58), Footprint(3.80, 3.52, 0.58, 0.58),  # barrels
    Footprint(4.42, 2.80, 0.58, 0.58),
]


def write(folder: str) -> None:
    width = round((RIGHT - LEFT) / RESOLUTION)
    height = round((TOP - BOTTOM) / RESOLUTION)
    picture = Picture(width, height, FREE)
    for row in range(height):
        for column in range(width):
            x = LEFT + (column + 0.5) * RESOLUTION
            y = TOP - (row + 0.5) * RESOLUTION  # the first row is on top
            if any(each.covers(x, y, RESOLUTION / 2) for each in STANDING):
                picture[column, row] = OCCUPIED
    picture.write(os.path.join(folder, "example_map.png"))
    with open(os.path.join(folder, "example_map.yaml"), "w", encoding="utf-8") as file:
        file.write(f"""# The example's hall as map_server describes maps. Made by scripts/make_example.py.
image: example_map.png
resolution: {RESOLUTION}
origin: [{LEFT}, {BOTTOM}, 0.0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
""")
