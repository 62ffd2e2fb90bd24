"""A few scenes of the bundled example in several formats, and the programs that read them."""
import pathlib
import subprocess
import tempfile
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
TIMEOUT = 300.0  # [s], for a program that hangs

# Formats and splits for the example's world, objects and recording.
WRITERS = '''
writers:
  - {name: coco, type: synthetic_dataset/Coco}
  - {name: folder, type: synthetic_dataset/ImageFolder}
  - {name: bop, type: synthetic_dataset/Bop}
  - {name: vertices, type: synthetic_dataset/BoundingShape}
folder: {depth: true}
vertices: {output_frame: camera/optical_link}
split: {train: 0.5, val: 0.5}
randomize: {sensor: {exposure: {normal: [0, 0.2]}}}
'''
SCENES = 8
RATE = 2.0  # [Hz], from 0.4 s on, when all objects are known


def run(program, *arguments):
    """The exit code of a program of the package, and what it prints."""
    found = subprocess.run(['catkin_find', '--first-only', '--libexec', 'synthetic_dataset',
                            program], stdout=subprocess.PIPE, universal_newlines=True, check=True)
    ended = subprocess.run([found.stdout.strip(), *map(str, arguments)], timeout=TIMEOUT,
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                           universal_newlines=True, check=False)
    return ended.returncode, ended.stdout


def settings(writers=WRITERS):
    """The example's settings file with other formats."""
    text = (REPOSITORY / 'config' / 'example.yaml').read_text('utf-8')
    head, rest = text.split('# The formats', 1)
    return head + writers + '# The objects' + rest.split('# The objects', 1)[1]


class DatasetCase(unittest.TestCase):
    """A dataset that all tests of a class share and do not change."""

    WRITERS = WRITERS

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = pathlib.Path(scratch.name)
        cls.folder = cls.scratch / 'dataset'
        cls.config = cls.scratch / 'settings.yaml'
        cls.config.write_text(settings(cls.WRITERS), 'utf-8')
        code, log = cls.generate()
        if code != 0:
            raise AssertionError(log)

    @classmethod
    def generate(cls, *arguments):
        return run('generate', '--config', cls.config, f'output_folder:={cls.folder}',
                   f'simulated_rate:={RATE}', f'duration:={0.5 + SCENES / RATE}', *arguments)
