#!/usr/bin/env python3
"""Makes the files of the bundled example: textures, meshes, the recording and the map.

Writes into worlds/ of this repository; run it again after changing a shape or a trajectory. It makes
the same files each time. Needs only ROS's rosbag and Python's standard library.
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
