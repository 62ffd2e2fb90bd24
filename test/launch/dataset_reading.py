"""Reads a dataset as its users do: manifest and files, without this package's code."""
import pathlib
import sqlite3


class Manifest:
    """The tables of a dataset's manifest.sqlite."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        database = sqlite3.connect(f'file:{self.folder}/manifest.sqlite?mode=ro', uri=True)
        self.state = database.execute("SELECT value FROM run WHERE key = 'state'").fetchone()[0]
        self.scenes = database.execute('SELECT count(*) FROM scene').fetchone()[0]
        self.sizes = {self.folder / path: size
                      for path, size in database.execute('SELECT path, bytes FROM file')}
        database.close()


def yolo_boxes(label_file):
    """Class, centre x and y, width and height of each line, the last four as fractions."""
    boxes = []
    for line in label_file.read_text(encoding='ascii').splitlines():
        class_name, *numbers = line.split(' ')
        boxes.append((class_name, *map(float, numbers)))
    return boxes
