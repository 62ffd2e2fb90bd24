#!/usr/bin/env python3
"""Compares the files of two datasets with the same settings, made on different systems.

    ./scripts/compare_datasets.py [--rounding SHARE] FOLDER OTHER

All files must have the same bytes, except for the manifest, which names the libraries' versions.
With --rounding, colour pictures may be rounded differently: up to that share of a picture's pixels may
differ by 1 of 255. Exit code 1 if anything else differs.
"""
import argparse
import pathlib
import struct
import sys
import zlib

TRUE_COLOUR = 2


def files_of(folder):
    return {path.relative_to(folder) for path in folder.rglob('*')
            if path.is_file() and path.name not in {'manifest.sqlite', 'overview.png'}}


def unfiltered(filter_type, row, above, pixel_bytes):
    """Undoes a row's filter (ISO/IEC 15948, clause 9): none, sub or up."""
    if filter_type == 0:
        return row
    if filter_type == 2:
        return bytearray((here + up) & 255 for here, up in zip(row, above))
    if filter_type != 1:
        raise ValueError(f'filter {filter_type} is none that this program writes')
    for i in range(pixel_bytes, len(row)):
        row[i] = (row[i] + row[i - pixel_bytes]) & 255
    return row


class Png:
    """A PNG file: its header and its inflated bytes."""

    def __init__(self, data):
        chunks = {}
        at = 8
        while at < len(data):
            size, name = struct.unpack_from('>I4s', data, at)
            chunks[name] = chunks.get(name, b'') + data[at + 8:at + 8 + size]
            at += size + 12
        self.width, self.height, self.depth, self.colour = struct.unpack('>IIBB', chunks[b'IHDR'][:10])
        self.rest = {name: chunk for name, chunk in chunks.items() if name != b'IDAT'}
        self.filtered = zlib.decompress(chunks[b'IDAT'])

    def pixels(self):
        """The pixels of a colour picture, three bytes each."""
        step = 3 * self.width + 1
        above = bytearray(step - 1)
        rows = []
        for row in range(self.height):
            line = self.filtered[row * step:(row + 1) * step]
            above = unfiltered(line[0], bytearray(line[1:]), above, 3)
            rows.append(bytes(above))
        return b''.join(rows)


def difference(picture, other):
    """The greatest difference in a channel, and the share of pixels that differ; None unless both
    are colour pictures of the same size."""
    if picture.rest != other.rest or picture.colour != TRUE_COLOUR:
        return None
    a, b = picture.pixels(), other.pixels()
    differing = [at for at in range(0, len(a), 3) if a[at:at + 3] != b[at:at + 3]]
    greatest = max((abs(a[at + i] - b[at + i]) for at in differing for i in range(3)), default=0)
    return greatest, len(differing) / (picture.width * picture.height)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split('\n', maxsplit=1)[0])
    parser.add_argument('--rounding', type=float, default=0.0)
    parser.add_argument('folder', type=pathlib.Path)
    parser.add_argument('other', type=pathlib.Path)
    arguments = parser.parse_args()
    names, others = files_of(arguments.folder), files_of(arguments.other)
    wrong = [f'{name}: only in one of them' for name in sorted(names ^ others)]
    same, shares = 0, []
    for name in sorted(names & others):
        data, other = ((folder / name).read_bytes() for folder in (arguments.folder, arguments.other))
        if data == other:
            same += 1
            continue
        found = difference(Png(data), Png(other)) if name.suffix == '.png' else None
        if found is None:
            wrong.append(f'{name}: differs')
        elif found[0] > 1 or found[1] >= arguments.rounding:
            wrong.append(f'{name}: {100 * found[1]:.4f} % of its pixels differ, by up to {found[0]}')
        else:
            shares.append(found[1])
    print(f'{len(names | others)} files: {same} with the same bytes', end='')
    print(f'; in {len(shares)} pictures, up to {100 * max(shares):.4f} % of the pixels differ by 1'
          if shares else '')
    for line in wrong[:20]:
        print('  ' + line)
    if len(wrong) > 20:
        print(f'  and {len(wrong) - 20} more')
    if not names:
        print('  there is no file')
    return 1 if wrong or not names else 0


if __name__ == '__main__':
    sys.exit(main())
