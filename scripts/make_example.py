#!/usr/bin/env python3
"""Makes what the bundled example's files name: textures, meshes, the recording and the map.

Writes into worlds/ of this repository; run again after a change of a shape or of a path. The same
files come out each time. Needs ROS's rosbag and nothing else beside Python's standard library.
"""

import os

from example import floor_map, furniture, hall, recording, textures, vehicles

WORLDS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "worlds")


def write_textures(models_folder: str) -> None:
    for model, pictures in textures.ALL.items():
        folder = os.path.join(models_folder, model, "meshes")
        os.makedirs(folder, exist_ok=True)
        for name, draw in pictures.items():
            draw().write(os.path.join(folder, name))


def main() -> None:
    models_folder = os.path.join(WORLDS, "models")
    write_textures(models_folder)
    for part in (vehicles, hall, furniture):
        part.write_all(models_folder)
    recording.write(os.path.join(WORLDS, "example.bag"))
    floor_map.write(WORLDS)


if __name__ == "__main__":
    main()
