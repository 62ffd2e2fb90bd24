#!/usr/bin/env python3
"""benchmark/transfer: its rows, its table, and that nothing is made twice. The programs are fakes."""
import json
import pathlib
import sys
import tempfile
import types
import unittest

import rosunit

from example_dataset import REPOSITORY

sys.path.insert(0, str(REPOSITORY / 'benchmark' / 'transfer'))
import settings  # noqa: E402
import transfer  # noqa: E402
from results import Results  # noqa: E402
from rows import ROWS, Row  # noqa: E402
from table import table  # noqa: E402

# Makes a manifest with what it was given, and logs the call. The model 'broken' fails.
GENERATE = '''
import hashlib, json, os, sqlite3, sys
given = json.load(open(sys.argv[2]))
open({log!r}, 'a').write('generate ' + os.path.basename(os.path.dirname(sys.argv[2])) + ' ' + sys.argv[3] + chr(10))
if given['object_1']['model'] == 'broken':
    sys.exit(chr(27) + '[31mno such model')
folder = given['output_folder']
if folder.endswith('/preset') and given['scenes'] < 9:
    sys.exit('motions/1/weight: less than one scene')
os.makedirs(folder, exist_ok=True)
if os.path.exists(folder + '/manifest.sqlite'):
    if sys.argv[3].endswith('resume'):
        sys.exit(0)
    os.remove(folder + '/manifest.sqlite')
database = sqlite3.connect(folder + '/manifest.sqlite')
database.execute('CREATE TABLE run (key, value)')
database.execute('CREATE TABLE scene ("index", state)')
database.execute('CREATE TABLE setting (name, value, is_default)')
database.execute('INSERT INTO run VALUES (?, ?)', ('settings_digest', hashlib.sha256(json.dumps(given).encode()).hexdigest()))
database.executemany('INSERT INTO scene VALUES (?, ?)', [(at, 'written') for at in range(given['scenes'])])
motions = [{{'name': name}} for name in ('pasted', 'fallen', 'open_ground', 'room')]
database.executemany('INSERT INTO setting VALUES (?, ?, ?)', [
    ('motions', json.dumps(motions), 0), ('object_1/model', '"model://crate"', 0), ('randomize/variety', '"same_class"', 0), ('near', '0.05', 1)])
database.commit()
'''

# AP50 depends on row and seed, and is best for `better`; a full training finds more.
TRAIN = '''
import json, sys
row = sys.argv[1].split('/')[-3]
part, seed = sys.argv[sys.argv.index('--part') + 1], int(sys.argv[sys.argv.index('--seed') + 1])
full = '--full' in sys.argv
open({log!r}, 'a').write(' '.join(['train', row, part, str(seed)] + ['full'] * full) + chr(10))
print('step 1')
value = {{'better': 0.5, 'worse': 0.25}}.get(row, 0.375) + 0.0625 * seed + 0.25 * full
print(json.dumps({{'real': {{'ap50': value, 'ap': 0}}, 'own': {{'ap50': 1}}}}))
'''

FEW = [Row('worse', 'one', 'plain'), Row('better', 'another', 'transfer'), Row('third', 'a third', 'plain')]


class Running(unittest.TestCase):

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.log = self.folder / 'log'
        for name, text in (('generate.py', GENERATE), ('train.py', TRAIN)):
            (self.folder / name).write_text(text.format(log=str(self.log)))
        self.train = f'{sys.executable} {self.folder}/train.py'

    def run_(self, rows, confirm=2, seeds=2, full=False, scenes=5, model='model://crate'):
        """(results, the benchmark, the log of its calls)"""
        self.log.write_text('')
        arguments = types.SimpleNamespace(work=str(self.folder / 'work'), model=model, real='photographs', train=self.train,
                                          scenes=scenes, confirm=confirm, seeds=seeds, full=full)
        (self.folder / 'work').mkdir(exist_ok=True)
        results = Results(str(self.folder / 'work' / 'results.json'))
        benchmark = transfer.Benchmark(arguments, results, (sys.executable, f'{self.folder}/generate.py'))
        benchmark.run(rows, lambda: None)
        return results, benchmark, self.log.read_text().splitlines()

    def test_chooses_on_even_and_reports_on_odd(self):
        _, _, calls = self.run_(FEW)
        self.assertEqual([call for call in calls if call.startswith('train')], [
            'train worse even 0', 'train better even 0', 'train third even 0',
            'train better odd 0', 'train better odd 1', 'train third odd 0', 'train third odd 1'])

    def test_does_nothing_twice(self):
        self.run_(FEW)
        results, _, calls = self.run_(FEW)
        self.assertEqual([call for call in calls if call.startswith('train')], [])
        self.assertEqual({call.split()[-1] for call in calls}, {'if_exists:=resume'})
        self.assertEqual(results.dataset('better')['pictures'], 5)
        _, _, calls = self.run_(FEW, seeds=3)
        self.assertEqual([call for call in calls if call.startswith('train')], ['train better odd 2', 'train third odd 2'])

    def test_trains_again_on_other_pictures(self):
        self.run_(FEW)
        results, _, calls = self.run_(FEW[:1], confirm=0, scenes=6)
        self.assertEqual(calls, ['generate worse if_exists:=overwrite', 'train worse even 0'])
        self.assertEqual(results.dataset('worse')['pictures'], 6)
        self.assertEqual(results.trainings('worse', 'odd', False, self.train), {})

    def test_goes_on_after_a_row_that_fails(self):
        broken = Row('broken', 'fails', 'plain', {'object_1': {'model': 'broken'}})
        results, benchmark, _ = self.run_([broken, FEW[1]], confirm=1, seeds=1)
        self.assertEqual([row for row, _ in benchmark.failures], ['broken'])
        self.assertIn('no such model', benchmark.failures[0][1])
        self.assertNotIn('\x1b', benchmark.failures[0][1])
        self.assertEqual(results.trainings('better', 'odd', False, self.train), {0: 0.5})

    def test_says_what_a_training_should_print(self):
        (self.folder / 'train.py').write_text('print("0.5")')
        _, benchmark, _ = self.run_(FEW[:1])
        self.assertIn('should be JSON with real/ap50', benchmark.failures[0][1])

    def test_writes_out_motions_of_which_some_are_kept(self):
        _, benchmark, _ = self.run_([Row('some', 'some', 'transfer', motions=('room',))], confirm=0)
        self.assertEqual(benchmark.failures, [])
        made = json.loads((self.folder / 'work' / 'some' / 'settings.yaml').read_text())
        self.assertEqual(made['motions'], [{'name': 'room'}])
        self.assertEqual((made['scenes'], made['randomize']), (5, {'variety': 'same_class'}))
        _, benchmark, _ = self.run_([Row('none', 'none', 'transfer', motions=('hall',))], confirm=0)
        self.assertIn('the preset has no motions hall', benchmark.failures[0][1])

    def test_makes_a_table_of_all_rows(self):
        results, _, _ = self.run_(FEW, confirm=1, seeds=2, full=True)
        lines = table([*FEW, Row('other', 'not asked for', 'plain')], results, self.train, [('other2', 'no such file')]).splitlines()
        cells = {line.split(' | ')[0].strip('| '): line.strip('| ').split(' | ') for line in lines if line.startswith('| ')}
        self.assertEqual(cells['better'][4:], ['0.500', '0.531', '0.500 to 0.562', '2', '0.781'])
        self.assertEqual(cells['worse'][4:], ['0.250', 'not run', '', '', 'not run'])
        self.assertIn('Spread: the standard deviation of a seed is 0.044 (rows with several: 1).', lines)
        self.assertIn('Not run: other.', lines)
        self.assertIn('Failed: other2: no such file', lines)
        self.assertEqual({line.count('|') - line.count('\\|') for line in lines if line.startswith('|')}, {10})

    def test_of_one_seed_knows_no_spread(self):
        results, _, _ = self.run_(FEW, seeds=1)
        self.assertIn('Spread: unknown', table(FEW, results, self.train))


class Rows(unittest.TestCase):

    def test_have_names_of_their_own(self):
        self.assertEqual(len({row.name for row in ROWS}), len(ROWS))
        for row in ROWS:
            self.assertIn(row.start, ('plain', 'transfer'))
            json.dumps(settings.of(row, 'model://crate', 10))

    def test_are_chosen_by_name(self):
        self.assertEqual([row.name for row in transfer.chosen('transfer,plain')], ['plain', 'transfer'])
        with self.assertRaisesRegex(ValueError, 'no row is called plan; there are plain, '):
            transfer.chosen('plan')

    def test_put_settings_over_others(self):
        row = Row('a', '', 'plain', {'camera': {'sample': {'distance': {'normal': [2, 1]}}}, 'placement': {'mode': 'volume'}})
        made = settings.of(row, 'model://crate', 10)
        self.assertEqual(made['camera']['sample']['distance'], {'normal': [2, 1]})
        self.assertEqual(made['camera']['sample']['look_at'], 'any')
        self.assertEqual((made['placement']['mode'], made['placement']['orientation']), ('volume', 'upright'))
        self.assertEqual(made['scenes'], 10)
        self.assertEqual(settings.of(Row('b', '', 'plain'), 'model://crate', 10)['placement']['mode'], 'drop',
                         'a row changes no other')

    def test_name_the_folder_of_a_models_own_files(self):
        model = REPOSITORY / 'worlds' / 'models' / 'rover'
        made = settings.of(ROWS[0], str(model), 10)
        self.assertEqual(made['world']['model_folders'], [str(model.parent)])
        self.assertNotIn('model_folders', settings.of(ROWS[0], 'model://rover', 10)['world'])


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'transfer_benchmark', '__main__')
