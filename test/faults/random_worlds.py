"""Worlds of random things, some of which fall or are in each other's way: the bytes are equal however they are made."""
import functools
import math
import pathlib
import subprocess
from typing import List

import yaml

import dataset
import job
from trial import Fault, Place, random_of, require, scaled

TRIALS = 40
PROCESSES = 2


def shape(random) -> str:
    kind = random.choice(['box', 'sphere', 'cylinder', 'ellipsoid', 'capsule', 'plane'])
    # Things of 20 m inside round meshes cost Bullet seconds per scene, and test nothing that small ones do not.
    largest = 20.0 if kind == 'plane' else 2.0
    size = [random.choice([0.05, 0.2, 0.5, 1e-4, largest]) * random.uniform(0.5, 1.5) for _ in range(3)]
    if kind == 'box':
        return f'<box><size>{size[0]} {size[1]} {size[2]}</size></box>'
    if kind == 'sphere':
        return f'<sphere><radius>{size[0]}</radius></sphere>'
    if kind == 'ellipsoid':
        return f'<ellipsoid><radii>{size[0]} {size[1]} {size[2]}</radii></ellipsoid>'
    if kind == 'plane':
        return f'<plane><normal>0 0 1</normal><size>{size[0]} {size[1]}</size></plane>'
    return f'<{kind}><radius>{size[0]}</radius><length>{size[1]}</length></{kind}>'


def pose(random, reach: float) -> str:
    place = [random.uniform(-reach, reach) for _ in range(3)]
    turn = [random.choice([0.0, random.uniform(-math.pi, math.pi)]) for _ in range(3)]
    return '<pose>' + ' '.join(f'{value:.4f}' for value in place + turn) + '</pose>'


def link(random, name: str) -> str:
    colour = ' '.join(f'{random.random():.2f}' for _ in range(3))
    parts = [f'<link name="{name}">', pose(random, 0.2)]
    if random.random() < 0.7:
        mass = random.choice([0.1, 1.0, 1e-6, 1e6])
        parts.append(f'<inertial><mass>{mass}</mass></inertial>')
    for number in range(random.choice([0, 1, 1, 3])):
        parts.append(f'<collision name="c{number}"><geometry>{shape(random)}</geometry></collision>')
    for number in range(random.choice([0, 1, 2])):
        alpha = random.choice([1.0, 1.0, 0.5, 0.0])
        parts.append(f'<visual name="v{number}">{pose(random, 0.3)}<transparency>{1.0 - alpha}</transparency>'
                     f'<geometry>{shape(random)}</geometry><material><diffuse>{colour} 1</diffuse></material></visual>')
    return ''.join(parts) + '</link>'


def model(random, name: str, depth: int) -> str:
    """A prop that stands, falls, or hangs from what it is joined to."""
    links = [f'link{number}' for number in range(random.choice([1, 1, 2, 3]))]
    parts = [f'<model name="{name}">', pose(random, 3.0)]
    if random.random() < 0.3:
        parts.append('<static>true</static>')
    parts += [link(random, each) for each in links]
    for parent, child in zip(links, links[1:]):
        kind = random.choice(['fixed', 'revolute', 'prismatic'])
        axis = '' if kind == 'fixed' else '<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper></limit></axis>'
        parts.append(f'<joint name="{parent}_{child}" type="{kind}"><parent>{parent}</parent>'
                     f'<child>{child}</child>{axis}</joint>')
    if depth < 2 and random.random() < 0.2:
        parts.append(model(random, 'inner', depth + 1))
    return ''.join(parts) + '</model>'


def light(random, number: int) -> str:
    kind = random.choice(['point', 'spot', 'directional'])
    return (f'<light name="l{number}" type="{kind}">{pose(random, 4.0)}'
            f'<cast_shadows>{random.choice(["true", "false"])}</cast_shadows><diffuse>0.5 0.5 0.5 1</diffuse>'
            f'<attenuation><range>{random.choice([0.5, 10.0])}</range></attenuation>'
            '<direction>0.2 0.1 -1</direction></light>')


def write_world(place: Place, random) -> pathlib.Path:
    things = [model(random, f'thing{number}', 0) for number in range(random.randrange(1, 9))]
    things += [light(random, number) for number in range(random.randrange(0, 4))]
    random.shuffle(things)
    text = job.world_text()
    end = text.rindex('</world>')
    settings = yaml.safe_load(place.config.read_text(encoding='ascii'))
    settings['world'] = str(place.inputs / 'random.world')
    pathlib.Path(settings['world']).write_text(text[:end] + ''.join(things) + text[end:], encoding='ascii')
    settings['randomize'] = random.choice([{}, {'lights': {'every': {'intensity': {'uniform': [0.5, 1.5]}}}}])
    config = place.inputs / 'random.yaml'
    config.write_text(yaml.safe_dump(settings), encoding='ascii')
    return config


def make(place: Place, config: pathlib.Path, **settings) -> None:
    command = place.command(settings)
    command[command.index('--config') + 1] = str(config)
    finished = place.run(program=command)
    require(finished.code == 0, f'exits with {finished.code}:\n{finished.log}\n{config.read_text("ascii")}')


def make_in_all_ways(number: int, place: Place) -> None:
    random = random_of('world', number)
    config = write_world(place, random)
    make(place, config)
    right = dataset.snapshot(place.output)
    verified = subprocess.run([str(place.programs / 'verify'), str(place.output)], env=place.environment,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    require(verified.returncode == 0, f'verify finds:\n{verified.stdout}')
    for way in ('processes', 'some first'):
        place.clear()
        if way == 'some first':
            make(place, config, only_scenes=sorted(random.sample(range(job.SMALL.instants), 2)))
        make(place, config, processes=PROCESSES if way == 'processes' else 1)
        wrong = dataset.differences(dataset.snapshot(place.output), right)
        require(not wrong, f'{way}: ' + '; '.join(wrong[:8]))


FAULTS: List[Fault] = [
    Fault('none: random worlds', 'by one process, by two, and some scenes first; `verify` finds nothing',
          lambda percent: [functools.partial(make_in_all_ways, number)
                           for number in range(scaled(TRIALS, percent))]),
]
