"""From a recording and a world to a finished dataset, only by clicks.

    whole_way_test.py [FOLDER]

FOLDER gets a screenshot of each step.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from assistant import Assistant, Page, chromium

PACKAGE = pathlib.Path(__file__).resolve().parents[2]


class WholeWay(unittest.TestCase):

    screenshots = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / 'dataset').mkdir()
        self.file = self.folder / 'new.yaml'
        self.assistant = Assistant(self.file, '--folder', PACKAGE / 'worlds')
        self.addCleanup(self.assistant.stop)
        self.driver = chromium()
        self.addCleanup(self.driver.quit)
        self.page = Page(self.driver)
        self.page.open(self.assistant.whole_address)

    def test_leads_to_a_finished_dataset_by_clicks_alone(self):
        self.record()
        self.surround()
        self.choose_objects()
        self.aim()
        self.choose_formats()
        self.choose_output()
        self.mend()
        self.run_it()
        self.look()
        self.compare_with_generate()
        self.change_and_replace()
        self.assertEqual(self.page.complaints(), [])

    def choose(self, button, *names):
        """Opens the file dialog and clicks from the readable folders through others, each named by the end of its path,
        to a file, or to a folder that is then chosen."""
        before = self.page.revision()
        self.page.click(button)
        while self.read_folder() != 'Folders that may be read':
            self.enter('up')
        for name in names:
            self.enter(name)
        if self.page.all('dialog[open]'):
            self.page.click('#dialog button.primary')
        self.page.wait(lambda: self.page.revision() > before, 'the file to be taken')

    def read_folder(self):
        """The dialog's folder, once its entries are there."""
        self.page.wait(lambda: self.page.listed() or 'Nothing' in self.page.text('#dialog'), 'the entries')
        return self.page.text('#dialog .folder')

    def enter(self, name):
        before = self.read_folder()
        self.page.click_found(lambda: next((each for each in self.page.all('#dialog .listing .name')
                                            if each.text.rstrip('/').endswith(name)), None),
                              f'{name} among {self.page.listed()}')
        self.page.wait(lambda: not self.page.all('dialog[open]') or self.page.text('#dialog .folder') != before, f'{name} to open')

    def step(self, pane, name):
        self.page.go(pane)
        self.page.save(self.screenshots, f'way_{name}')

    def record(self):
        self.step('recording', 'recording')
        self.page.click('.greeting .by-hand')
        self.choose('[data-path="bag_file"] .file-list > button', 'worlds', 'example.bag')
        self.page.wait(lambda: self.page.all('.timeline-row'), 'the frames of the recording')

    def surround(self):
        self.step('world', 'world')
        field = '[data-path="world/file"], [data-path="world"]'
        self.choose(', '.join(f'{each} .with-button button' for each in field.split(', ')), 'worlds', 'example.sdf')
        self.choose('[data-path="world/model_folders"] .file-list > button', 'worlds', 'models')

    def choose_objects(self):
        self.step('objects', 'objects')
        self.page.wait(lambda: len(self.page.all('.candidates button')) == 3, 'the frames of three robots')
        for left in [2, 1, 0]:
            self.page.click_and_wait('.candidates button', 'Add')
            self.page.wait(lambda: len(self.page.all('.candidates button')) == left, f'{left} more')
        self.page.wait(lambda: len(self.page.all('.tabs .tab')) == 4, 'three objects')

    def aim(self):
        self.step('cameras', 'cameras')
        self.choose('[data-path="camera/info_file"] .with-button button', 'worlds', 'example_camera.yaml')
        self.page.click_and_wait('#pane .segment', 'Random')

    def choose_formats(self):
        self.step('formats', 'formats')
        for name in ['Coco', 'PascalVoc']:
            before = self.page.revision()
            self.page.click_found(lambda: next((each.find_element('css selector', 'input[type="checkbox"]')
                                                for each in self.page.all('.format') if each.text.startswith(name)), None), name)
            self.page.wait(lambda: self.page.revision() > before, name)

    def choose_output(self):
        self.step('output', 'output')
        self.choose('[data-path="output_folder"] .with-button button', self.folder.name, 'dataset')
        self.page.click_and_wait('#pane button', 'Divide them')
        self.page.go('recording')
        self.page.type('simulated_rate', '2')
        self.assertIn('simulated_rate: 2\n', self.page.yaml())

    def mend(self):
        self.page.wait(lambda: 'error' not in self.page.text('#header .verdict') and
                       'reading' not in self.page.text('#header .verdict'), 'all problems to be mended')
        self.step('problems', 'problems')
        self.page.wait_for_picture()
        self.page.click('#pane button', 'Check with nine scenes')
        self.page.wait(lambda: self.page.text('#pane').find('Checking') < 0, 'the check', timeout=300)
        self.page.go('output')
        self.page.wait(lambda: re.search(r'Takes\s+about', self.page.text('#pane')), 'how long it takes')

    def run_it(self):
        self.step('run', 'run')
        self.page.wait(lambda: re.search(r'0 of \d+ scenes', self.page.text('.progress-box')), 'how many scenes it will make')
        self.page.click('#pane button', 'Start')
        self.page.wait(lambda: 'done' in self.page.text('.progress-box'), 'the run to be done', timeout=300)
        self.page.wait(lambda: self.page.script('const log = document.querySelector(".log"); '
                                                'return log.scrollTop + log.clientHeight >= log.scrollHeight - 4'),
                       'the end of the log')
        self.page.save(self.screenshots, 'way_done')

    def look(self):
        self.page.click('#pane a.button', 'Open the result')
        self.page.wait(lambda: len(self.page.all('.scenes img')) >= 8, 'the scenes')
        self.page.wait(lambda: self.page.script('''return [...document.querySelectorAll(".scenes img")].slice(0, 4)
            .every(each => each.complete && each.naturalWidth > 0)'''), 'their pictures')
        self.page.click('#pane button', 'Verify its files')
        self.page.wait(lambda: self.page.all('.verdict-line.fine'), 'the files to be as they should be')
        self.page.save(self.screenshots, 'way_result')
        self.filter()
        self.enlarge()
        self.report()

    def chosen(self):
        """The numbers of scenes and labels that are shown."""
        return [int(each) for each in re.findall(r'\d+', self.page.text('.chosen'))]

    def choose_of(self, label, value):
        before = self.chosen()
        self.page.script('''const [label, value] = arguments;
            const select = [...document.querySelectorAll(".filters label")].find(each => each.innerText.startsWith(label)).querySelector("select");
            select.value = value; select.dispatchEvent(new Event("change"));''', label, value)
        self.page.wait(lambda: self.chosen() != before, f'{label} {value}')

    def filter(self):
        scenes, labels = self.chosen()
        shown = dict(re.findall(r'(rover|drone)\s+(\d+)', self.page.text('.charts')))
        self.assertEqual(sum(map(int, shown.values())), labels)
        self.choose_of('Class', 'drone')
        of_drones = self.chosen()
        self.assertEqual(of_drones[1], int(shown['drone']))
        self.assertLessEqual(of_drones[0], scenes)
        self.choose_of('Split', 'train')
        self.assertLess(self.chosen()[0], of_drones[0])
        self.page.wait(lambda: len(self.page.all('.scenes img')) == min(self.chosen()[0], 24), 'the scenes of drones for training')
        self.page.save(self.screenshots, 'way_result_filtered')
        self.page.click('.chosen button', 'Show all')
        self.page.wait(lambda: self.chosen() == [scenes, labels], 'all scenes')
        self.choose_of('Size', 'small')
        self.assertLess(self.chosen()[1], labels)
        self.page.click('.chosen button', 'Show all')
        self.page.wait(lambda: self.chosen() == [scenes, labels], 'all scenes')
        self.choose_of('Hidden', 'none')
        self.assertLess(self.chosen()[1], labels)
        self.page.click('.chosen button', 'Show all')
        self.page.wait(lambda: self.chosen() == [scenes, labels], 'all scenes')

    def enlarge(self):
        self.page.click('.scenes .tile')
        large = '.enlarged img'
        self.page.wait(lambda: self.page.script('const large = document.querySelector(".enlarged img"); '
                                                'return large?.complete && large.naturalWidth === 640'), 'the whole picture')
        first = self.page.one(large).get_attribute('src')
        self.page.save(self.screenshots, 'way_result_enlarged')
        self.page.click('.enlarged button', 'Next scene')
        self.page.wait(lambda: self.page.one(large).get_attribute('src') != first, 'the next scene')
        self.page.click('.enlarged button', 'Make it small again')
        self.page.wait(lambda: not self.page.all(large), 'the small ones')

    def report(self):
        self.page.click('#pane button', 'Make the report')
        link = self.page.wait(lambda: next((each for each in self.page.all('#pane a.button') if each.text == 'Open the report'), None),
                              'the report', timeout=120)
        self.assertTrue((self.folder / 'dataset' / 'report.html').exists())
        text = self.page.script('return fetch(arguments[0]).then(answer => answer.text())', link.get_attribute('href'))
        self.assertIn('<html', text)

    def compare_with_generate(self):
        """The settings file that the page has written gives the same dataset on the command line."""
        other = self.folder / 'by_hand'
        subprocess.run(['rosrun', 'synthetic_dataset', 'generate', '--config', str(self.file), f'output_folder:={other}'],
                       check=True, stdout=subprocess.DEVNULL)
        names = sorted(each.relative_to(other) for each in other.rglob('*') if each.is_file() and each.name != 'manifest.sqlite')
        self.assertGreater(len(names), 20)
        made = self.folder / 'dataset'
        for name in names:
            self.assertEqual((made / name).read_bytes(), (other / name).read_bytes(), name)

    def change_and_replace(self):
        """After a change of the settings, the page asks before it replaces the dataset."""
        manifest = self.folder / 'dataset' / 'manifest.sqlite'
        first = manifest.read_bytes()
        self.page.go('recording')
        self.page.type('simulated_rate', '1')
        self.page.go('problems')
        self.page.wait(lambda: 'of other settings' in self.page.text('#pane'), 'the dataset of other settings')
        self.page.go('run')
        self.page.wait(lambda: 'simulated_rate: then 2, now 1' in self.page.text('#pane'), 'what differs')
        self.page.save(self.screenshots, 'way_other_settings')
        self.page.click('#pane button', 'Replace it\u2026')
        self.page.save(self.screenshots, 'way_replace')
        self.page.click('#pane button', 'Keep them')
        self.assertEqual(manifest.read_bytes(), first)
        self.page.click('#pane button', 'Replace it\u2026')
        self.ask_again_elsewhere()
        self.page.click('#pane button', 'Replace it\u2026')
        self.page.click('#pane button', 'Remove and start')
        self.page.wait(lambda: 'Made:' in self.page.text('#pane'), 'the new dataset', timeout=300)
        self.assertNotEqual(manifest.read_bytes(), first)
        self.page.go('problems')
        self.assertNotIn('of other settings', self.page.text('#pane'))

    def ask_again_elsewhere(self):
        """A confirmation for one folder does not count for another."""
        here, there = str(self.folder / 'dataset'), str(self.folder / 'other')
        subprocess.run(['rosrun', 'synthetic_dataset', 'generate', '--config', str(self.file), f'output_folder:={there}',
                        'simulated_rate:=3'], check=True, stdout=subprocess.DEVNULL)
        self.output_to(there)
        self.page.wait(lambda: f'{there} holds a dataset' in self.page.text('#pane'), 'the other dataset to be named')
        self.assertNotIn('Remove and start', self.page.text('#pane'))
        answer = self.page.script('''return fetch("api/run/start", {method: "POST",
            headers: {"Content-Type": "application/json"}, body: JSON.stringify({replace: arguments[0]})})
            .then(answer => answer.json())''', here)
        self.assertIn('the output folder has changed', answer['error'])
        self.output_to(here)
        self.page.wait(lambda: f'{here} holds a dataset' in self.page.text('#pane'), 'the first dataset')

    def output_to(self, folder):
        self.page.go('output')
        self.page.type('output_folder', folder)
        self.page.go('run')


if __name__ == '__main__':
    arguments = sys.argv[1:]
    if arguments and pathlib.Path(arguments[0]).is_dir():
        WholeWay.screenshots = arguments.pop(0)
    unittest.main(argv=[sys.argv[0], *arguments], verbosity=2)
