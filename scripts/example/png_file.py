"""Pictures in the PNG format (ISO/IEC 15948)."""

import struct
import zlib
from typing import List, Tuple

Pixel = Tuple[int, int, int]


class Picture:
    """Red, green and blue from 0 to 255; the first row is the top one."""

    def __init__(self, width: int, height: int, colour: Pixel = (0, 0, 0)):
        self.width = width
        self.height = height
        self.pixels: List[Pixel] = [colour] * (width * height)

    def __getitem__(self, place: Tuple[int, int]) -> Pixel:
        return self.pixels[place[1] * self.width + place[0]]

    def __setitem__(self, place: Tuple[int, int], colour: Pixel) -> None:
        self.pixels[place[1] * self.width + place[0]] = colour

    def fill(self, left: int, top: int, right: int, bottom: int, colour: Pixel) -> None:
        """Fills a rectangle, excluding its right and bottom border."""
        for y in range(top, bottom):
            start = y * self.width
            self.pixels[start + left:start + right] = [colour] * (right - left)

    def write(self, path: str) -> None:
        """Writes the picture, with a palette if 256 colours are enough."""
        colours = sorted(set(self.pixels))
        if len(colours) <= 256:
            numbers = {colour: index for index, colour in enumerate(colours)}
            samples = bytes(numbers[pixel] for pixel in self.pixels)
            palette = b"".join(bytes(colour) for colour in colours)
            _write(path, self.width, self.height, samples, 1, palette)
        else:
            samples = bytes(channel for pixel in self.pixels for channel in pixel)
            _write(path, self.width, self.height, samples, 3, b"")


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def _write(path: str, width: int, height: int, samples: bytes, channels: int,
           palette: bytes) -> None:
    indexed_colour, true_colour, no_filter = 3, 2, b"\0"
    kind = indexed_colour if palette else true_colour
    stride = width * channels
    rows = b"".join(no_filter + samples[y * stride:(y + 1) * stride] for y in range(height))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        file.write(_chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)))
        if palette:
            file.write(_chunk(b"PLTE", palette))
        file.write(_chunk(b"IDAT", zlib.compress(rows, 9)))
        file.write(_chunk(b"IEND", b""))
