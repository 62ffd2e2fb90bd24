"""The programs in docs/python.md, run unchanged on a dataset of the bundled example."""
import ast
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / 'test' / 'python'))
from example_dataset import run, settings  # noqa: E402

TIMEOUT = 900.0  # [s]
# Threads of torch sometimes abort Python at its exit, after all work is done.
LEAVE = '\nimport os, sys\nsys.stdout.flush()\nos._exit(0)\n'
WRITERS = '''
writers:
  - {name: coco, type: synthetic_dataset/Coco}
  - {name: detect, type: synthetic_dataset/UltralyticsYolo}
detect: {task: detect}
split: {train: 0.5, val: 0.5}
'''


def programs():
    """The blocks of Python by their headings."""
    text = (REPOSITORY / 'docs' / 'python.md').read_text('utf-8')
    found = {}
    for section in re.split(r'^#+ (?=[A-Z])', text, flags=re.MULTILINE)[1:]:
        found[section.split('\n', 1)[0]] = re.findall(r'```python\n(.*?)```', section, re.DOTALL)
    return found


class PythonDocs(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = pathlib.Path(scratch.name)
        config = cls.scratch / 'settings.yaml'
        config.write_text(settings(WRITERS), 'utf-8')
        dataset = cls.scratch / 'datasets' / 'example'
        code, log = run('generate', '--config', config, f'output_folder:={dataset}',
                        'simulated_rate:=2.0')
        if code != 0:
            raise AssertionError(log)
        cls.labels = {split: json.loads(
            (dataset / f'coco/annotations/instances_{split}.json').read_text('utf-8'))
            for split in ('train', 'val')}

    def output(self, section, block=0, python=sys.executable, end=''):
        file = self.scratch / 'program.py'
        file.write_text(programs()[section][block] + end, 'utf-8')
        environ = {**os.environ, 'HOME': str(self.scratch), 'YOLO_CONFIG_DIR': str(self.scratch),
                   'FIFTYONE_DATABASE_DIR': str(self.scratch / 'fiftyone'),
                   'FIFTYONE_DO_NOT_TRACK': 'true', 'FIFTYONE_DATABASE_VALIDATION': 'false'}
        ended = subprocess.run([python, str(file)], cwd=self.scratch, env=environ, timeout=TIMEOUT,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               universal_newlines=True, check=False)
        self.assertEqual(ended.returncode, 0, ended.stdout + ended.stderr)
        return ended.stdout

    def count_of(self, split, name=None):
        labels = self.labels[split]
        names = {each['id']: each['name'] for each in labels['categories']}
        return sum(name in (None, names[each['category_id']]) for each in labels['annotations'])

    def test_scenes(self):
        lines = self.output('Datasets in Python').splitlines()
        self.assertEqual(len(lines), self.count_of('train') + self.count_of('val'))
        self.assertRegex(lines[0], r'^0 rover \[[\d. ]+\] \d')

    def test_tables(self):
        text = self.output('What it reads')
        rovers, drones = (self.count_of('train', name) + self.count_of('val', name)
                          for name in ('rover', 'drone'))
        self.assertRegex(text, rf'visibility +count +{drones}\.0+ +{rovers}\.0+')

    def test_pytorch(self):
        losses = ast.literal_eval(self.output('PyTorch'))
        self.assertEqual(len(losses), 5)
        self.assertTrue(all(0.0 <= loss < 1000.0 for loss in losses.values()), losses)

    def test_fiftyone(self):
        text = self.output('FiftyOne', python=os.environ['SYNTHETIC_DATASET_FIFTYONE_PYTHON'])
        counts = ast.literal_eval(text.strip().splitlines()[-1])
        self.assertEqual(counts, {name: self.count_of('train', name)
                                  for name in ('rover', 'drone')})

    def test_ultralytics(self):
        text = self.output('Ultralytics', end=LEAVE)
        self.assertTrue(0.0 <= float(text.strip().splitlines()[-1]) <= 1.0)
        self.assertTrue((self.scratch / 'runs/detect/train/weights/best.pt').is_file())

    def test_evaluation(self):
        text = self.output('Evaluation as in COCO')
        found = re.search(r'Average Precision  \(AP\) @\[ IoU=0.50      \| area=   all \| '
                          r'maxDets=100 \] = (\d\.\d+)', text)
        # Boxes of these sizes that are shifted by two pixels still overlap by more than half.
        self.assertEqual(float(found.group(1)), 1.0, text)
        found = re.search(r'IoU=0.50:0.95 \| area=   all \| maxDets=100 \] = (\d\.\d+)', text)
        self.assertLess(float(found.group(1)), 1.0, text)

    def test_every_program_is_run(self):
        # test/python/dataset_test.py runs the program for a format of your own.
        self.assertEqual({name: len(blocks) for name, blocks in programs().items() if blocks},
                         {'Datasets in Python': 1, 'What it reads': 1, 'PyTorch': 1, 'FiftyOne': 1,
                          'Ultralytics': 1, 'Evaluation as in COCO': 1,
                          "Your own format": 1})


if __name__ == '__main__':
    unittest.main()
