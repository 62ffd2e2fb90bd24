#!/usr/bin/env python3
"""Finds functions and variables that two files of a build both define under one name.

    ./scripts/check_symbols.py BUILD_FOLDER

C++ allows only one definition of a name, but no tool has to report a second one: if a header of the
tests has an inline function and the library another function of the same name, the linker takes
either, depending on the order of files. Tests then run different code than they show. The check reads
the build's object files; exit code 1 if a name has two definitions and not all of them are inline.
"""
import os
import pathlib
import subprocess
import sys

STRONG = set('TDBRSG')  # nm's letters for definitions that only one file may have
WEAK = set('WVu')       # ... and for those that many may have, if they are the same
OFTEN = {'main'}        # each program has its own


REPOSITORY = pathlib.Path(__file__).resolve().parent.parent


def source_of(path, build):
    """The source of an object file, relative to the repository; None if it no longer exists."""
    folder, _, rest = str(path.relative_to(build)).partition('CMakeFiles/')
    inside = rest.partition('.dir/')[2].replace('__/', '../')[:-len('.o')]
    source = pathlib.PurePath(os.path.normpath(os.path.join(folder, inside)))
    # catkin_make's build folder has an additional level, the package's folder.
    for place in (source, pathlib.PurePath(*source.parts[1:])):
        if (REPOSITORY / place).is_file():
            return str(place)
    return None


def definitions(objects):
    """Yields (object file, letter, name) for each symbol that other files can see."""
    table = subprocess.run(['nm', '--defined-only', '--extern-only', '--print-file-name',
                            '--format=posix', *objects],
                           check=True, capture_output=True, text=True).stdout
    for line in table.splitlines():
        file, _, symbol = line.partition(': ')
        name, letter = symbol.split()[:2]
        yield file, letter, name


def readable(name):
    return subprocess.run(['c++filt', name], check=True, capture_output=True,
                          text=True).stdout.strip()


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    build = pathlib.Path(sys.argv[1])
    # A source that several targets compile counts once.
    objects = {source_of(path, build): str(path) for path in sorted(build.rglob('*.cpp.o'))}
    objects.pop(None, None)
    if not objects:
        sys.exit(f'{build}: no object files')
    sources = {path: source for source, path in objects.items()}
    strong, weak = {}, {}
    for file, letter, name in definitions(sorted(sources)):
        if letter in STRONG:
            strong.setdefault(name, []).append(sources[file])
        elif letter in WEAK:
            weak.setdefault(name, []).append(sources[file])
    doubles = {name: files + weak.get(name, [])[:1] for name, files in sorted(strong.items())
               if len(files) + len(weak.get(name, [])) > 1 and name not in OFTEN}
    for name, files in doubles.items():
        print(f'{readable(name)}: defined in {" and ".join(files)}')
    print(f'symbols: {len(sources)} object files, {len(strong)} names, {len(doubles)} defined twice')
    return 1 if doubles else 0


if __name__ == '__main__':
    sys.exit(main())
