"""Inputs made to crash, fill up or hold up the program: each is refused, or does no harm, in little time."""
import functools
import json
import time
from typing import Callable, Dict, List, Tuple

from trial import Fault, Place, random_of, require, scaled

TRIALS = 48
LONGEST = 60.0  # [s]


def nested(random, left: str, right: str) -> str:
    depth = random.choice([450, 5000, 50000])
    return left * depth + random.choice(['', '1']) + right * random.choice([depth, 0])


def with_world(text: Callable) -> Callable:
    def spoil(place: Place, random) -> Dict[str, str]:
        path = place.folder / 'hostile.world'
        path.write_text(text(random), encoding='ascii')
        return {'world': str(path)}
    return spoil


def with_calibration(text: Callable) -> Callable:
    def spoil(place: Place, random) -> Dict[str, str]:
        path = place.folder / 'hostile.yaml'
        path.write_text(text(random), encoding='latin-1')
        return {'cameras/front/info_file': str(path)}
    return spoil


def with_setting(name: str, text: Callable) -> Callable:
    return lambda _, random: {name: text(random)}


def many_attributes(random) -> str:
    attributes = ' '.join(f'a{i}="1"' for i in range(random.choice([2000, 200000])))
    return f'<sdf version="1.6"><world name="w"><model {attributes} name="m"/></world></sdf>'


def many_names(random) -> str:
    return '{' + ', '.join(f'n{i}: 1' for i in range(random.choice([500, 8000]))) + '}'


def calibration(random) -> str:
    number = random.choice(['1.0e+300', '-1.0e+300', '1.0e+12', '.inf', '.nan', '-1'])
    focal = random.choice(['56.0', number])
    return ('image_width: 96\nimage_height: 64\ncamera_matrix: {rows: 3, cols: 3, '
            f'data: [{focal}, 0, 47.5, 0, {focal}, 31.5, 0, 0, 1]}}\n'
            f'distortion_model: {random.choice(["plumb_bob", "rational_polynomial", "equidistant"])}\n'
            f'distortion_coefficients: {{rows: 1, cols: 5, data: [{number}, 0, 0, 0, 0]}}\n')


KINDS: List[Tuple[str, Callable]] = [
    ('elements in elements', with_world(lambda random: nested(random, '<model>', '</model>'))),
    ('attributes of an element', with_world(many_attributes)),
    ('tags in a calibration', with_calibration(
        lambda random: '<?xml version="1.0"?>\n<opencv_storage>\n' + nested(random, '<a>', '</a>'))),
    ('brackets in a calibration', with_calibration(
        lambda random: '%YAML:1.0\n---\ncamera_matrix: ' + nested(random, '[', ']'))),
    ('numbers of a lens', with_calibration(calibration)),
    ('brackets in a setting', with_setting('alpha/keypoints', lambda random: '[' * 900)),
    ('names in a setting', with_setting('yolo/more', many_names)),
    ('a terminal\'s commands', with_calibration(
        lambda random: calibration(random).replace('plumb_bob', '"plumb\\e]0;x\\a_bob"'))),
]


def feed(number: int, place: Place) -> None:
    random = random_of('hostile', number)
    name, spoil = KINDS[number % len(KINDS)]
    begin = time.monotonic()
    finished = place.run(spoil(place, random))
    seconds = time.monotonic() - begin
    require(finished.code in (0, 1), f'{name}: exits with {finished.code}:\n{finished.log}')
    require(seconds < LONGEST, f'{name}: takes {seconds:.0f} s')
    require('\x1b]' not in finished.log, f'{name}: reaches the terminal: {json.dumps(finished.log)}')


FAULTS = [
    Fault('hostile inputs', f'{len(KINDS)} kinds: what nests, multiplies, or is no number',
          lambda percent: [functools.partial(feed, number)
                           for number in range(scaled(TRIALS, percent))]),
]
