"""Twin datasets, of recorded and of drawn pictures, that are made by one command and interrupted."""
import functools
import pathlib
import signal
import subprocess
import time
from typing import Any, List

import genpy
import rosbag
import yaml
from sensor_msgs.msg import Image

import dataset
import job
from trial import Fault, Place, random_of, require, scaled

TRIALS = 8
TOPIC = '/front/image'
ENDED = (0, 130, -signal.SIGINT, -signal.SIGKILL)


def write_pictures(path: pathlib.Path) -> None:
    """Writes a camera's recorded pictures, one for each scene: a ramp that moves."""
    with rosbag.Bag(str(path), 'w') as bag:
        for instant in range(job.SMALL.instants):
            picture = Image()
            offset = genpy.Duration(0, round(instant * job.NANOSECONDS / job.SMALL.rate))
            picture.header.stamp = genpy.Time(job.START) + offset
            picture.header.frame_id = 'front'
            picture.width, picture.height = job.SMALL.width, job.SMALL.height
            picture.encoding, picture.step = 'mono8', job.SMALL.width
            picture.data = bytes((column + 7 * instant + row) % 256 for row in range(job.SMALL.height)
                                 for column in range(job.SMALL.width))
            bag.write(TOPIC, picture, picture.header.stamp)


class Twins:
    """The command that makes both datasets in a place."""

    def __init__(self, place: Place) -> None:
        self.place = place
        pictures = place.inputs / 'pictures.bag'
        write_pictures(pictures)
        settings = yaml.safe_load(place.config.read_text(encoding='ascii'))
        camera = settings['cameras'].pop('front')
        del camera['effects']
        settings['cameras'] = {'front': {**camera, 'image_topic': TOPIC}}
        settings['bag_file'] = [settings['bag_file'], str(pictures)]
        settings['twin'] = {'output': 'both'}
        del settings['simulated_rate']
        self.config = place.inputs / 'twins.yaml'
        self.config.write_text(yaml.safe_dump(settings), encoding='ascii')
        begin = time.monotonic()
        self.run()
        self.seconds = time.monotonic() - begin
        self.right = dataset.snapshot(place.output)
        require('real/manifest.sqlite' in self.right and 'synthetic/manifest.sqlite' in self.right,
                'makes no twins')
        place.clear()

    def start(self, **settings: Any) -> 'subprocess.Popen[str]':
        command = self.place.command({'processes': 2, **settings})
        command[command.index('--config') + 1] = str(self.config)
        return self.place.start(program=command)

    def run(self, **settings: Any) -> None:
        finished = self.place.end(self.start(**settings))
        require(finished.code == 0, f'exits with {finished.code}:\n{finished.log}')

    def run_one(self, name: str, **settings: Any) -> None:
        self.run(**{'twin/output': name, 'output_folder': self.place.output / name, **settings})

    def finish(self) -> None:
        """The same command makes what is missing."""
        self.run()
        wrong = dataset.differences(dataset.snapshot(self.place.output), self.right)
        require(not wrong, 'the twins differ from those of an unbroken run: ' + '; '.join(wrong[:8]))


def break_off(number: int, place: Place) -> None:
    """Interrupts runs by kill -9 or Ctrl-C at random moments."""
    random = random_of('twins', number)
    twins = Twins(place)
    for _ in range(2):
        process = twins.start()
        time.sleep(random.uniform(0.1, 1.0) * twins.seconds)
        process.send_signal(random.choice([signal.SIGKILL, signal.SIGINT]))
        finished = place.end(process)
        require(finished.code in ENDED, f'exits with {finished.code}:\n{finished.log}')
    twins.finish()


def one_is_whole(number: int, place: Place) -> None:
    """One twin is complete; the other has some scenes, or is missing."""
    random = random_of('half of twins', number)
    twins = Twins(place)
    whole, other = random.sample(['real', 'synthetic'], 2)
    twins.run_one(whole)
    if number % 2 == 0:
        twins.run_one(other, only_scenes=sorted(random.sample(range(job.SMALL.instants), 3)))
    twins.finish()


def numbered(what):
    return lambda percent: [functools.partial(what, number)
                            for number in range(scaled(TRIALS, percent))]


FAULTS: List[Fault] = [
    Fault('twins that are broken off', 'kill -9 and Ctrl-C at random moments, twice; then again',
          numbered(break_off)),
    Fault('twins of which one is whole', 'the other has some scenes, or none', numbered(one_is_whole)),
]
