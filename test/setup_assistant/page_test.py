"""The page of `setup_assistant` in Chromium: what a user sees and does, with the bundled example.

    page_test.py [FOLDER] [TEST...]

FOLDER gets a screenshot of each pane, narrow and wide, light and dark.
"""
import http.server
import math
import pathlib
import re
import shutil
import signal
import sys
import tempfile
import threading
import unittest
import urllib.error
import urllib.request

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

from assistant import Assistant, Page, chromium, new_tab

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = PACKAGE / 'config' / 'example.yaml'
PANES = ['recording', 'objects', 'world', 'cameras', 'randomisation', 'formats', 'output',
         'problems', 'run', 'result']


browser = None  # shared by all tests, each of which has a tab


def setUpModule():
    global browser
    browser = chromium()


def tearDownModule():
    browser.quit()


class WithPage(unittest.TestCase):
    """A copy of the bundled example in its own folder, with its page in a browser."""

    settings = EXAMPLE

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.file = self.folder / 'mine.yaml'
        text = self.settings.read_text('utf-8')
        self.file.write_text(re.sub(r'^output_folder:.*$', f'output_folder: {self.folder}/dataset', text, flags=re.M), 'utf-8')
        self.start()
        self.driver = browser
        self.addCleanup(new_tab, self.driver)
        self.page = Page(self.driver)
        self.page.open(self.assistant.whole_address)

    def start(self, *arguments):
        self.assistant = Assistant(self.file, '--folder', PACKAGE / 'worlds', *arguments)
        self.addCleanup(self.assistant.stop)

    def tearDown(self):
        self.assertEqual(self.page.complaints(), [])

    def press(self, *keys):
        chain = ActionChains(self.driver)
        for key in keys[:-1]:
            chain.key_down(key)
        chain.send_keys(keys[-1])
        for key in keys[:-1]:
            chain.key_up(key)
        chain.perform()


class SettingsFile(WithPage):

    def test_is_changed_by_a_click_where_the_setting_is(self):
        before = self.file.read_text('utf-8').splitlines()
        self.page.type('simulated_rate', '2.5')
        after = self.file.read_text('utf-8').splitlines()
        self.assertEqual([line for line in after if line not in before], ['simulated_rate: 2.5'])
        self.assertEqual(len(after), len(before))
        self.assertEqual(self.page.yaml(), self.file.read_text('utf-8'))

    def test_changes_the_form_when_it_is_typed(self):
        self.page.type_yaml(self.page.yaml().replace('simulated_rate: 5.0', 'simulated_rate: 2.0'))
        self.page.wait(lambda: self.page.input('simulated_rate').get_attribute('value') == '2', 'the field')
        self.assertIn('simulated_rate: 2.0\n', self.file.read_text('utf-8'))

    def test_is_not_written_while_it_is_no_yaml(self):
        before = self.file.read_text('utf-8')
        self.page.type_yaml('bag_file: [one, ')
        self.page.wait(lambda: 'invalid YAML' in self.page.text('#header'), 'the complaint')
        self.assertRegex(self.page.text('.yaml-state'), r'line \d+')
        self.assertEqual(self.file.read_text('utf-8'), before)
        self.page.type_yaml(before)
        self.page.wait(lambda: 'invalid YAML' not in self.page.text('#header'), 'the complaint to end')

    def test_is_undone_and_redone_by_keys(self):
        before = self.file.read_text('utf-8')
        self.page.type('simulated_rate', '2.5')
        self.page.click('#header h1')
        self.press(Keys.CONTROL, 'z')
        self.page.wait(lambda: self.file.read_text('utf-8') == before, 'undo')
        self.press(Keys.CONTROL, Keys.SHIFT, 'z')
        self.page.wait(lambda: 'simulated_rate: 2.5' in self.file.read_text('utf-8'), 'redo')

    def test_is_loaded_anew_after_a_question_when_another_program_changes_it(self):
        text = self.file.read_text('utf-8')
        self.file.write_text(text.replace('simulated_rate: 5.0', 'simulated_rate: 3.0'), 'utf-8')
        self.page.wait(lambda: 'Another program has changed' in self.page.text('#banners'), 'the question')
        self.assertEqual(self.page.input('simulated_rate').get_attribute('value'), '5')
        self.page.click('#banners button', 'Load its text')
        self.page.wait(lambda: self.page.input('simulated_rate').get_attribute('value') == '3', 'their value')
        self.assertEqual(self.page.text('#banners'), '')

    def test_is_kept_after_the_question_when_asked_to(self):
        text = self.file.read_text('utf-8')
        self.file.write_text('# nothing\n', 'utf-8')
        self.page.wait(lambda: 'Another program has changed' in self.page.text('#banners'), 'the question')
        self.page.click('#banners button', 'Keep this page\u2019s')
        self.page.wait(lambda: self.file.read_text('utf-8') == text, 'the text to be written back')

    def test_is_the_same_in_two_pages(self):
        first, address = self.driver.current_window_handle, self.driver.current_url
        self.driver.switch_to.new_window('tab')
        second = self.driver.current_window_handle
        self.page.open(address)
        self.page.type('simulated_rate', '2.5')
        self.driver.switch_to.window(first)
        self.page.wait(lambda: self.page.input('simulated_rate').get_attribute('value') == '2.5', 'the first page')
        self.page.type('global_frame', 'odom')
        self.driver.switch_to.window(second)
        self.page.wait(lambda: self.page.input('global_frame').get_attribute('value') == 'odom', 'the second page')

    def test_keeps_what_is_being_typed_when_another_page_changes_it(self):
        text = self.page.yaml()
        revision = self.page.revision()
        # The page sends typed text after a pause, which here lasts until the other page has sent its change.
        self.page.script('window.held = []; window.later = setTimeout; window.setTimeout = (work) => held.push(work);')
        self.page.type_yaml(text.replace('global_frame: map', 'global_frame: odom'))
        post(self.driver, 'api/set', '{"revision": %d, "changes": [{"path": ["seed"], "value": 7}]}' % revision)
        self.page.script('window.setTimeout = later; held.forEach((work) => work());')
        self.page.wait(lambda: 'changed elsewhere' in self.page.text('#yaml'), 'the question')
        self.assertIn('global_frame: odom', self.page.yaml())
        self.page.click('#yaml button', 'Take theirs')
        self.page.wait(lambda: 'seed: 7' in self.page.yaml() and 'global_frame: map' in self.page.yaml(), 'their text')


def post(driver, path, body):
    """Sends a request as another page of the same browser would."""
    cookie = next(each for each in driver.get_cookies() if each['name'].startswith('synthetic_dataset_'))
    request = urllib.request.Request(driver.current_url.split('#')[0] + path, body.encode(), {
        'Content-Type': 'application/json', 'Cookie': f'{cookie["name"]}={cookie["value"]}'})
    return urllib.request.urlopen(request)


class Token(WithPage):

    def test_is_asked_for_by_everything(self):
        for path in ['', 'api/state', 'page/main.js', 'api/events', 'api/files', '?token=' + 32 * '0']:
            with self.subTest(path=path):
                with self.assertRaises(urllib.error.HTTPError) as refused:
                    urllib.request.urlopen(self.assistant.address + path)
                self.assertEqual(refused.exception.code, 403)
                self.assertEqual(refused.exception.read(), b'')

    def test_does_not_stay_in_the_address(self):
        self.assertNotIn('token', self.driver.current_url)
        self.assertNotIn(self.assistant.token, self.driver.current_url)
        self.page.open(self.driver.current_url)

    def test_is_not_for_other_ports(self):
        """Another user's server on this machine, whose page the browser opens."""
        class Other(http.server.BaseHTTPRequestHandler):
            cookies = []

            def do_GET(self):
                self.cookies.append(self.headers.get('Cookie', ''))
                self.send_response(200)
                self.end_headers()

            def log_message(self, *_):
                pass

        with http.server.HTTPServer(('127.0.0.1', 0), Other) as server:
            threading.Thread(target=server.serve_forever, daemon=True).start()
            self.driver.get(f'http://127.0.0.1:{server.server_port}/')
            server.shutdown()
        self.assertEqual({''}, set(Other.cookies))


class Server(WithPage):

    def test_may_be_killed_and_started_again(self):
        self.page.type('simulated_rate', '2.5')
        self.assistant.stop(signal.SIGKILL)
        self.page.server_was_killed = True
        self.page.wait(lambda: 'No answer' in self.page.text('#banners'), 'the page to say so')
        self.start('--port', str(self.assistant.port))
        self.page.wait(lambda: 'new token' in self.page.text('#banners'), 'the page to say so')
        self.page.open(self.assistant.whole_address)
        self.page.wait(lambda: self.page.input('simulated_rate').get_attribute('value') == '2.5', 'the field')
        self.page.wait_for_picture()


class Problems(WithPage):

    # A setting, a wrong value for it, and the pane that has its field.
    WRONG = [
        ('simulated_rate', -1, 'recording'),
        ('bag_file', 'none.bag', 'recording'),
        ('start_offset', -2, 'recording'),
        ('world/file', 'none.world', 'world'),
        ('physics/step', 0, 'world'),
        ('camera/info_file', 'none.yaml', 'cameras'),
        ('camera/near', -1, 'cameras'),
        ('camera/pose', 'here', 'cameras'),
        ('rover_1/model', 'none.urdf', 'objects'),
        ('rover_1/frame_id', 'no_such_frame', 'objects'),
        ('rover_1/keypoints', [[1, 2]], 'objects'),
        ('randomize/sensor/blur', {'uniform': [3, 1]}, 'randomisation'),
        ('split', {'train': 0.5}, 'output'),
        ('image/jpeg_quality', 500, 'output'),
        ('yolo/class', 'colour', 'formats'),
    ]

    def test_are_shown_at_their_fields(self):
        for key, value, pane in self.WRONG:
            with self.subTest(key=key):
                right = self.page.yaml()
                self.set(key.split('/'), value)
                try:
                    self.follow(key, pane)
                finally:
                    self.page.click_and_wait('#header button', 'Undo')
                    self.page.wait(lambda: self.page.yaml() == right, 'the text from before')
                    self.page.wait(lambda: 'error' not in self.page.text('#header .verdict'), 'no error')

    def follow(self, key, pane):
        """Follows the link from the list of all problems to the field."""
        self.page.wait(lambda: 'error' in self.page.text('#header .verdict'), 'the error')
        self.page.go('problems')
        self.page.click_found(lambda: self.link_to(pane), f'a link to {pane}')
        self.page.wait(lambda: self.page.all(f'body[data-pane="{pane}"]'), f'the pane {pane}')
        self.page.wait(lambda: self.problem_at(key), f'a problem at the field {key}')

    def set(self, path, value):
        before = self.page.revision()
        self.page.script('const [path, value] = arguments; import("./page/store.js").then(({set}) => set(path, value))', path, value)
        self.page.wait(lambda: self.page.revision() > before, 'the change')

    def link_to(self, pane):
        return next((each for each in self.page.all('#pane .error a') if f'#{pane}:' in each.get_attribute('href')), None)

    def test_name_folders_as_the_file_does_and_lead_to_the_field_wherever_they_are_clicked(self):
        self.set(['world', 'file'], '$(find synthetic_dataset)/worlds/none.world')
        self.page.wait(lambda: 'error' in self.page.text('#header .verdict'), 'the error')
        self.page.go('problems')
        self.page.wait(lambda: '$(find synthetic_dataset)/worlds/none.world' in self.page.text('#pane'), 'the problem')
        self.assertNotIn(f'{PACKAGE}/worlds/none.world', self.page.text('#pane'))
        texts = [each.text for each in self.page.all('#pane .entry')]
        self.assertEqual(len(texts), len(set(texts)))
        self.page.click_found(lambda: next((each.find_element('css selector', '.what') for each in self.page.all('#pane a.entry')
                                            if 'none.world' in each.text), None), 'the problem')
        self.page.wait(lambda: self.page.all('body[data-pane="world"]'), 'the world')
        self.page.wait(lambda: self.page.script('return document.activeElement.closest("[data-path]")?.dataset.path') == 'world/file',
                       'the field to have the focus')

    def problem_at(self, key):
        parts = key.split('/')
        groups = ['/'.join(parts[:length]) for length in range(len(parts), 0, -1)]
        return any(self.page.all(f'#pane [data-path="{each}"] .problems .error') for each in groups)


class Randomisation(WithPage):

    def test_is_the_presets_by_one_click(self):
        self.page.go('randomisation')
        switch = '#pane [data-path="randomize/preset"] .switch'
        self.page.click(switch)
        self.page.wait(lambda: 'randomize:\n  preset: transfer\n' in self.page.yaml(), 'the preset')
        self.page.click(switch)
        self.page.wait(lambda: 'preset' not in self.page.yaml(), 'no preset')


class Picture(WithPage):

    def test_is_that_of_the_instant_under_the_slider(self):
        self.page.wait_for_picture()
        first = self.page.picture_sum()
        self.page.one('#time').send_keys(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
        self.page.wait(lambda: self.page.one('#stage canvas').get_attribute('data-instant') == '2', 'the third scene')
        self.assertNotEqual(self.page.picture_sum(), first)
        self.page.one('#time').send_keys(Keys.HOME)
        self.page.wait(lambda: self.page.picture_sum() == first, 'the same picture')

    def test_has_labels_that_can_be_switched(self):
        self.page.wait_for_picture()
        for label, selector, count in [('Boxes', '.box', 3), ('Masks', '.mask', 3), ('Keypoints', '.keypoint', 27),
                                       ('Cuboids', '.edge', 36), ('Names', 'text', 3)]:
            with self.subTest(label=label):
                shown = f'#stage .overlay {selector}'
                if not self.page.all(shown):
                    self.page.click('#stage .toggle', label)
                self.page.wait(lambda: len(self.page.all(shown)) >= count, label)
                self.page.click('#stage .toggle', label)
                self.page.wait(lambda: not self.page.all(shown), f'no {label}')

    def test_follows_the_hand_that_drags_the_camera(self):
        self.page.go('cameras')
        self.page.wait_for_picture()
        first = self.page.picture_sum()
        self.page.click_and_wait('#pane button', 'Fix it here, to drag it')
        self.page.wait_for_picture()
        fixed = self.file.read_text('utf-8')
        self.assertRegex(fixed, r'position: \[-4(\.0*)?, -2\.9(0*)?, 1\.35(0*)?\]')
        picture = self.page.one('.picture')
        ActionChains(self.driver).move_to_element(picture).click_and_hold().move_by_offset(-50, 5) \
            .move_by_offset(-50, 5).release().perform()
        self.page.wait(lambda: self.file.read_text('utf-8') != fixed, 'the pose')
        self.page.wait_for_picture()
        self.assertNotEqual(self.page.picture_sum(), first)
        # A whole drag is one undo step.
        self.page.click_and_wait('#header button', 'Undo')
        self.page.wait(lambda: self.file.read_text('utf-8') == fixed, 'the pose from before')

    def test_moves_the_camera_by_keys(self):
        self.page.go('cameras')
        self.page.wait_for_picture()
        self.page.click_and_wait('#pane button', 'Fix it here, to drag it')
        for keys in [[Keys.ARROW_LEFT], ['+'], [Keys.SHIFT, Keys.ARROW_UP]]:
            before = self.page.revision()
            self.page.one('.picture').send_keys(*keys)
            self.page.wait(lambda: self.page.revision() > before, f'{keys} to move it')

    def test_of_the_fixed_camera_is_that_of_the_recorded_one(self):
        self.page.go('cameras')
        self.page.wait_for_picture()
        corner = self.page.script('return document.querySelector(".labels .box").getAttribute("x")')
        self.page.click_and_wait('#pane button', 'Fix it here, to drag it')
        for form in ['Optical frame', 'Angles']:
            self.page.click_and_wait('#pane .segment', form)
            self.page.wait_for_picture()
            moved = self.page.script('return document.querySelector(".labels .box").getAttribute("x")')
            self.assertAlmostEqual(float(moved), float(corner), delta=1.01)


class Camera(WithPage):

    def setUp(self):
        super().setUp()
        self.page.go('cameras')
        self.page.wait_for_picture()

    def fix_it(self):
        self.page.click_and_wait('#pane button', 'Fix it here, to drag it')
        self.page.wait_for_picture()

    def pose(self):
        return [[float(each) for each in re.search(name + r': \[([^\]]*)\]', self.page.yaml()).group(1).split(',')]
                for name in ['position', 'rpy']]

    def test_moves_along_its_view_with_the_first_notch_of_the_wheel(self):
        self.fix_it()
        (position, rpy), revision = self.pose(), self.page.revision()
        self.page.script('''document.querySelector(".picture").dispatchEvent(
            new WheelEvent("wheel", {deltaY: -100, bubbles: true, cancelable: true}))''')
        self.page.wait(lambda: self.page.revision() > revision, 'the camera to move')
        nearer, rpy_after = self.pose()
        self.assertEqual(rpy_after, rpy)
        moved = [after - before for after, before in zip(nearer, position)]
        ahead = [math.cos(rpy[1]) * math.cos(rpy[2]), math.cos(rpy[1]) * math.sin(rpy[2]), -math.sin(rpy[1])]
        length = math.hypot(*moved)
        self.assertGreater(length, 0.05)
        for step, along in zip(moved, ahead):
            self.assertAlmostEqual(step / length, along, delta=0.02)

    def test_shows_coarse_pictures_while_it_is_dragged(self):
        self.fix_it()
        before = self.page.revision()
        picture, canvas = self.page.one('.picture'), self.page.one('#stage canvas')
        hand = ActionChains(self.driver, duration=0)
        hand.move_to_element(picture).click_and_hold().move_by_offset(-30, 5).perform()
        self.page.wait(lambda: canvas.get_attribute('width') == '320', 'a coarse picture')
        sums = {self.page.picture_sum()}
        for _ in range(3):
            glances = int(canvas.get_attribute('data-glances'))
            ActionChains(self.driver, duration=0).move_by_offset(-20, 0).perform()
            self.page.wait(lambda: int(canvas.get_attribute('data-glances')) > glances, 'the next coarse picture')
            sums.add(self.page.picture_sum())
        self.assertEqual(len(sums), 4, 'each from where the hand is')
        self.assertEqual(self.page.revision(), before)
        self.assertEqual(self.page.all('#stage .overlay'), [])
        ActionChains(self.driver, duration=0).release().perform()
        self.page.wait(lambda: self.page.revision() > before, 'the pose')
        self.page.wait_for_picture()
        self.assertEqual(canvas.get_attribute('width'), '640')
        self.assertTrue(self.page.all('#stage .overlay .box'))

    def test_keeps_the_view_that_is_shown_when_it_is_fixed(self):
        self.page.click_and_wait('#pane .segment', 'Random')
        self.page.wait_for_picture()
        boxes = self.boxes()
        self.page.click_and_wait('#pane .segment', 'Fixed')
        self.page.wait_for_picture()
        self.assertEqual(len(self.boxes()), len(boxes))
        for before, after in zip(boxes, self.boxes()):
            self.assertAlmostEqual(before, after, delta=1.01)

    def boxes(self):
        return [float(each) for each in self.page.script(
            'return [...document.querySelectorAll(".labels .box")].map(each => each.getAttribute("x"))')]

    def test_has_angles_in_degrees_by_choice_and_where_the_file_has(self):
        self.fix_it()
        self.assertNotIn('deg(', self.page.yaml())
        shown = self.yaw()
        self.page.click_and_wait('[data-path="camera/pose/rpy"] .unit')
        self.assertRegex(self.page.yaml(), r'rpy: \[.*deg\(')
        self.page.wait(lambda: self.yaw() != shown, 'degrees')
        self.assertAlmostEqual(self.yaw(), math.degrees(shown), delta=0.01)
        # Typed and dragged values are written alike.
        before = self.page.revision()
        self.page.all('[data-path="camera/pose/rpy"] input')[1].send_keys(Keys.CONTROL, 'a')
        self.page.all('[data-path="camera/pose/rpy"] input')[1].send_keys('20', Keys.TAB)
        self.page.wait(lambda: self.page.revision() > before, 'the pitch')
        self.assertIn('deg(20)', self.page.yaml())
        before, shown = self.page.revision(), self.yaw()
        self.page.one('.picture').send_keys(Keys.ARROW_LEFT)
        self.page.wait(lambda: self.page.revision() > before and self.yaw() != shown, 'the camera to turn')
        self.assertRegex(self.page.yaml(), r'rpy: \[.*deg\([^)]*\), deg\(')
        self.page.click_and_wait('[data-path="camera/pose/rpy"] .unit')
        self.assertNotIn('deg(', self.page.yaml())

    def yaw(self):
        return float(self.page.all('[data-path="camera/pose/rpy"] input')[2].get_attribute('value'))

    def test_is_drawn_within_angles_in_degrees_where_the_file_has(self):
        self.page.type_yaml(self.page.yaml().replace('camera:\n', 'camera:\n  sample: {elevation: {uniform: [deg(10), deg(40)]}}\n', 1))
        elevation = '[data-path="camera/sample/elevation"]'
        boxes = self.page.wait(lambda: self.page.all(f'{elevation} input.number'), 'the elevation')
        self.assertEqual([each.get_attribute('value') for each in boxes], ['10', '40'])
        self.page.wait(lambda: self.page.all(f'{elevation} .unit')[0].text == '[deg]', 'degrees')
        before = self.page.revision()
        boxes[1].send_keys(Keys.CONTROL, 'a')
        boxes[1].send_keys('50', Keys.TAB)
        self.page.wait(lambda: self.page.revision() > before, 'the new limit')
        self.assertIn('uniform: [deg(10), deg(50)]', self.page.yaml())

    def test_is_renamed_where_it_stands(self):
        self.page.click_and_wait('#pane button', '+ Add')
        name = self.page.wait(lambda: next((each for each in self.page.all('#camera-name')
                                            if each.get_attribute('value') == 'camera_2'), None), 'its name')
        name.send_keys(Keys.CONTROL, 'a')
        name.send_keys('camera', Keys.TAB)  # the first camera has this name
        self.assertNotEqual(self.page.script('return document.getElementById("camera-name").validationMessage'), '')
        before = self.page.revision()
        name.send_keys(Keys.CONTROL, 'a')
        name.send_keys('rear', Keys.TAB)
        self.page.wait(lambda: self.page.revision() > before, 'the new name')
        self.page.wait(lambda: [each.text for each in self.page.all('.tabs .tab')][:2] == ['camera', 'rear'], 'its tab')
        self.assertNotIn('camera_2', self.page.yaml())

    def test_leaves_the_map_where_it_is(self):
        self.fix_it()
        before = self.page.one('#pane .map svg').get_attribute('viewBox')
        revision = self.page.revision()
        self.page.one('.picture').send_keys(Keys.ARROW_LEFT)
        self.page.wait(lambda: self.page.revision() > revision, 'the camera to move')
        self.page.wait_for_picture()
        self.assertEqual(self.page.one('#pane .map svg').get_attribute('viewBox'), before)


class Recording(WithPage):

    def test_says_how_long_ways_are(self):
        self.page.wait(lambda: self.page.all('.timeline-row.used'), 'the frames')
        row = next(each.text for each in self.page.all('.timeline-row.used') if 'rover_1' in each.text)
        # The way's bounding box is 6.81 m from corner to corner, and the way bends.
        self.assertAlmostEqual(float(re.search(r'([\d.]+) m', row).group(1)), 8.66, delta=0.05)

    def test_is_done_without_where_it_is_chosen(self):
        self.page.click_and_wait('#pane .segment', 'Place at random')
        self.assertRegex(self.page.yaml(), r'\nmotion: placement\n')
        self.page.wait(lambda: self.page.all('[data-path="placement/mode"]'), 'where objects are put')
        self.assertIn('none: on the ground, 100 scenes', self.page.text('#nav a[href="#recording"]'))
        self.page.wait(lambda: 'reading' not in self.page.text('#header .verdict'), 'the settings to be read')
        self.page.click_and_wait('#pane .segment', 'In a box')
        self.page.click_and_wait('#pane button', 'Set a box')
        self.assertRegex(self.page.yaml(), r'volume:')
        self.page.click_and_wait('#pane .segment', 'Follow a recording')
        self.page.wait(lambda: self.page.all('.timeline-row'), 'the frames')

    def test_may_lack_objects_for_a_while(self):
        self.page.click('#pane summary', 'Gaps, stretches, other topics')
        self.page.click_and_wait('[data-path="when_unknown"] .segment', 'Scenes without it')
        self.assertIn('when_unknown: absent', self.page.yaml())


class Objects(WithPage):

    def test_are_renamed_wherever_they_are_named(self):
        text = self.page.yaml().replace('rover_1:\n', 'rover_1:\n  model: "$(find synthetic_dataset)/worlds/models/rover"\n')
        text = text.replace('camera_frame_id: camera/optical_link', '').replace(
            'camera:\n', 'camera:\n  pose: {position: [-4, -2.9, 1.35], look_at: rover_1}\n')
        self.page.type_yaml(text)
        self.page.wait(lambda: 'look_at: rover_1' in self.file.read_text('utf-8'), 'the model and the camera')
        self.page.go('objects')
        name = self.page.wait(lambda: next((each for each in self.page.all('#object-name') if each.is_enabled()), None), 'the name')
        name.send_keys(Keys.CONTROL, 'a')
        name.send_keys('husky', Keys.TAB)
        self.page.wait(lambda: 'look_at: husky' in self.page.yaml(), 'the new name')
        for line in ['robot_list: [husky, rover_2, drone_1]', '\nhusky:\n', 'frame: rover_1/base_footprint',
                     '# Its class, which a network learns to recognise: a number or a text.']:
            self.assertIn(line, self.page.yaml())
        self.assertNotIn('\nrover_1:', self.page.yaml())
        self.page.wait(lambda: 'reading' not in self.page.text('#header .verdict'), 'the settings to be read')
        self.assertNotIn('error', self.page.text('#header .verdict'), self.page.text('#pane'))
        self.page.click_and_wait('#header button', 'Undo')
        self.page.wait(lambda: self.page.yaml() == text, 'all of it to be undone')


class Help(WithPage):

    LONGEST = 150  # of a setting's help [characters]; that of formats comes from a table

    def test_is_short_and_whole(self):
        for pane in PANES:
            self.page.go(pane)
            self.page.script('document.querySelectorAll("#pane details").forEach(each => { each.open = true; })')
            with self.subTest(pane=pane):
                hints = self.page.script('''return [...document.querySelectorAll("#pane .hint")].map(each =>
                    [each.innerText, each.scrollHeight > each.clientHeight + 1])''')
                self.assertEqual([text for text, is_cut in hints if is_cut], [])
                self.assertEqual([text for text, _ in hints if re.search(r'\bsee\b.*\bbelow\b|docs/', text)], [])
                if pane != 'formats':
                    self.assertEqual([text for text, _ in hints if len(text) > self.LONGEST], [])

    def test_leads_to_the_documentation(self):
        self.page.click('[data-path="simulated_rate"] .more')
        self.page.wait(lambda: 'docs/recordings.md' in self.page.text('#dialog') and
                       self.page.all('#dialog .document h2'), 'the section')
        self.assertEqual(self.page.text('#dialog .document h2'), 'Times')
        self.page.click('#dialog button', 'Close')
        self.page.wait(lambda: not self.page.all('dialog[open]'), 'the form')

    def test_has_the_sections_that_it_leads_to(self):
        missing = self.driver.execute_async_script('''const done = arguments[0];
            Promise.all([import("./page/help.js"), import("./page/doc_dialog.js")]).then(async ([{helpOf, helpedPaths}, {sectionOf}]) => {
              const missing = [];
              for (const path of helpedPaths()) {
                const {document, section} = helpOf(path);
                const answer = await fetch(`page/${document}.md`);
                const text = answer.ok ? await answer.text() : "";
                if (!text || (section && sectionOf(text, section) === text)) missing.push(path);
              }
              done(missing);
            }).catch((error) => done(String(error)));''')
        self.assertEqual(missing, [])


class Phone(WithPage):

    # The label of a checkbox or switch takes clicks, too, and so does what is laid around small elements.
    SMALL = '''return [...document.querySelectorAll("button, a, select, summary, input")].filter(each => {
        const box = each.getBoundingClientRect();
        if (!box.width || each.disabled || each.matches(".skip")) return false;
        const labels = ["checkbox", "radio"].includes(each.type) ? [...each.labels] : [];
        const shown = [box, ...labels.map(label => label.getBoundingClientRect())];
        const around = ["::before", "::after"].map(name => getComputedStyle(each, name))
            .filter(style => style.content !== "none" && style.position === "absolute");
        const size = (name) => Math.max(...shown.map(each => each[name]), ...around.map(each => parseFloat(each[name]) || 0));
        return size("width") < 43.5 || size("height") < 43.5;
      }).map(each => each.outerHTML.slice(0, 120))'''

    def setUp(self):
        super().setUp()
        self.driver.execute_cdp_cmd('Emulation.setDeviceMetricsOverride', {
            'width': 390, 'height': 844, 'deviceScaleFactor': 1, 'mobile': True})
        self.driver.execute_cdp_cmd('Emulation.setTouchEmulationEnabled', {'enabled': True, 'maxTouchPoints': 2})

    def test_is_used_with_fingers(self):
        for pane in PANES:
            self.show(pane)
            self.page.script('document.querySelectorAll("#pane details").forEach(each => { each.open = true; })')
            with self.subTest(pane=pane):
                self.assertEqual(self.page.script(self.SMALL), [])

    def show(self, pane):
        self.page.script('location.hash = arguments[0]', pane)
        self.page.wait(lambda: self.page.all(f'body[data-pane="{pane}"]'), pane)

    def test_shows_the_step_that_it_is_at(self):
        for pane in ['result', 'recording', 'problems']:
            self.show(pane)
            left, right = self.page.script('''const box = document.querySelector("#nav [aria-current]").getBoundingClientRect();
                return [box.left, box.right]''')
            self.assertGreaterEqual(left, 0)
            self.assertLessEqual(right, 390)

    def test_moves_the_camera_with_two_fingers(self):
        self.show('cameras')
        self.page.wait_for_picture()
        self.page.click_and_wait('#pane button', 'Fix it here, to drag it')
        self.page.wait_for_picture()
        self.assertIn('Two fingers', self.page.text('.drag-hint'))
        before, revision = self.page.yaml(), self.page.revision()
        self.page.script('document.querySelector(".picture").scrollIntoView({block: "center"})')
        x, y = self.page.script('''const box = document.querySelector(".picture").getBoundingClientRect();
            return [box.left + box.width / 2, box.top + box.height / 2]''')
        for kind, apart in [('touchStart', 20), ('touchMove', 40), ('touchMove', 60)]:
            self.driver.execute_cdp_cmd('Input.dispatchTouchEvent', {'type': kind, 'touchPoints': [
                {'x': x - apart, 'y': y, 'id': 0}, {'x': x + apart, 'y': y, 'id': 1}]})
        self.driver.execute_cdp_cmd('Input.dispatchTouchEvent', {'type': 'touchEnd', 'touchPoints': []})
        self.page.wait(lambda: self.page.revision() > revision and self.page.yaml() != before, 'the camera to move')


class Keypoints(WithPage):

    def test_are_picked_on_the_model_by_a_click(self):
        self.page.go('objects')
        self.page.wait(lambda: self.page.all('.turntable img'), 'the model')
        self.page.click('.portrait .toggle', 'Pick keypoints')
        before = self.page.revision()
        ActionChains(self.driver).move_to_element(self.page.one('.turntable')).click().perform()
        self.page.wait(lambda: self.page.revision() > before, 'the keypoint')
        self.assertEqual(len(self.page.all('.point')), 10)
        picked = [float(each.get_attribute('value')) for each in self.page.all('.point:last-child input')]
        # On the rover, whose box is in the example's settings.
        for value, low, high in zip(picked, [-0.385, -0.305, 0.0], [0.385, 0.305, 0.77]):
            self.assertTrue(low <= value <= high, picked)


class Names(WithPage):

    def test_are_shown_as_text(self):
        name = '<img src=x onerror=alert(1)>'
        shutil.copy(PACKAGE / 'worlds' / 'example.bag', self.folder / f'{name}.bag')
        self.page.click('#pane .file-list > button')
        folder = self.folder.name
        self.page.click_found(lambda: next((each for each in self.page.all('#dialog .listing button') if folder in each.text), None),
                              folder)
        self.page.wait(lambda: f'{name}.bag' in self.page.listed(), 'the file')
        self.press(Keys.ESCAPE)
        text = self.page.yaml().replace('rover_1', name.replace(' ', '_'))
        self.page.type_yaml(text.replace(f'[{name.replace(" ", "_")},', f'["{name.replace(" ", "_")}",'))
        self.page.go('objects')
        self.page.wait(lambda: '<img_src' in self.page.text('#pane'), 'the name')
        self.assertEqual(self.page.all('img[src="x"]'), [])


class Modules(WithPage):

    def evaluate(self, module, expression):
        return self.driver.execute_async_script(
            'const [module, expression, done] = arguments;'
            'import(`./page/${module}`).then((names) => done(Object.getOwnPropertyDescriptor(names, expression[0])'
            '.value(...expression[1])), (error) => done(String(error)));', module, expression)

    def test_read_and_write_values_in_one_line(self):
        for text, value in [('[1, 2.5, -3e2]', [1, 2.5, -300]), ('{uniform: [0, 1], min: 0.5}', {'uniform': [0, 1], 'min': 0.5}),
                            ('deg(20)', 'deg(20)'), ('[deg(20), "a, b"]', ['deg(20)', 'a, b']), ('{a: {b: []}}', {'a': {'b': []}}),
                            ('$(find pkg)/x.yaml', '$(find pkg)/x.yaml'), ('true', True), ('"7"', '7')]:
            with self.subTest(text=text):
                self.assertEqual(self.evaluate('flow.js', ['parseFlow', [text]]), value)
                printed = self.evaluate('flow.js', ['printFlow', [value]])
                self.assertEqual(self.evaluate('flow.js', ['parseFlow', [printed]]), value)

    def test_keep_the_focus_when_something_before_it_goes(self):
        focused, value = self.driver.execute_async_script('''const done = arguments[0];
            import("./page/dom.js").then(({h, patch}) => {
              const parent = document.body.appendChild(document.createElement("div"));
              const draw = (keys) => patch(parent, keys.map((key) => h("p", {key}, h("input", {id: key, value: ""}))));
              draw(["gone", "first", "too", "typed"]);
              document.getElementById("typed").focus();
              document.execCommand("insertText", false, "half a wo");
              draw(["first", "typed"]);
              document.execCommand("insertText", false, "rd");
              done([document.activeElement.id, document.getElementById("typed").value]);
            });''')
        self.assertEqual([focused, value], ['typed', 'half a word'])

    def test_turn_cameras_as_sdf_does(self):
        for rpy in [[0, 0, 0], [0.1, -0.4, 2.0], [-1.0, 1.2, -3.0]]:
            with self.subTest(rpy=rpy):
                matrix = self.evaluate('pose_math.js', ['matrixOfRpy', [rpy]])
                again = self.evaluate('pose_math.js', ['rpyOfMatrix', [matrix]])
                for value, expected in zip(again, rpy):
                    self.assertAlmostEqual(value, expected, places=9)
                quaternion = self.evaluate('pose_math.js', ['quaternionOfMatrix', [matrix]])
                half = [math.sin(each / 2) for each in rpy], [math.cos(each / 2) for each in rpy]
                # SDF's formula: w of the rotations about x, y and z, one after another.
                w = half[1][0] * half[1][1] * half[1][2] + half[0][0] * half[0][1] * half[0][2]
                self.assertAlmostEqual(abs(quaternion[3]), abs(w), places=9)
        # Looking along x, the optical frame's z is x and its x is -y.
        optical = self.evaluate('pose_math.js', ['opticalOfBody', [[[1, 0, 0], [0, 1, 0], [0, 0, 1]]]])
        self.assertEqual([[0 + each for each in row] for row in optical], [[0, 0, 1], [-1, 0, 0], [0, -1, 0]])

    def test_find_the_line_of_a_setting(self):
        text = self.page.yaml()
        for path, line in [(['simulated_rate'], 'simulated_rate: 5.0'), (['rover_2', 'class'], '  class: rover'),
                           (['yolo', 'class'], '  class: number'), (['rover_1', 'keypoints', '2'], '  keypoints: &rover_keypoints')]:
            number = self.evaluate('yaml_lines.js', ['lineOf', [text, path]])
            self.assertEqual(text.splitlines()[number - 1], line)
        self.assertIsNone(self.evaluate('yaml_lines.js', ['lineOf', [text, ['nothing']]]))


class Panes(WithPage):

    screenshots = None

    def test_fit_their_window(self):
        self.page.wait_for_picture()
        for scheme in ['light', 'dark']:
            for width in [1280, 390]:
                self.driver.execute_cdp_cmd('Emulation.setEmulatedMedia', {'features': [{'name': 'prefers-color-scheme', 'value': scheme}]})
                self.driver.execute_cdp_cmd('Emulation.setDeviceMetricsOverride', {
                    'width': width, 'height': 800 if width > 800 else 844, 'deviceScaleFactor': 1, 'mobile': False})
                for pane in PANES:
                    with self.subTest(scheme=scheme, width=width, pane=pane):
                        self.page.go(pane)
                        self.settle()
                        self.assertEqual(self.page.script('return document.documentElement.scrollWidth'), width)
                        self.assertEqual(self.outside(), [])
                        self.assertEqual(self.unnamed(), [])
                        self.page.save(self.screenshots, f'{pane}_{width}_{scheme}')

    def settle(self):
        """Waits until nothing is loading any more."""
        self.page.wait(lambda: not any(each in self.page.text('#pane') for each in ['Reading', 'Drawing', 'drawing'])
                       and self.page.script('return document.querySelector("#stage .loading")?.hidden ?? true'), 'all answers')

    def outside(self):
        return self.page.script('''const wide = document.documentElement.clientWidth;
            return [...document.querySelectorAll("#pane *, #header *, #stage *")].filter(each =>
              !each.closest(".table, .scenes, svg, pre, .skip") && each.getClientRects().length &&
              getComputedStyle(each).position !== "absolute" &&
              each.getBoundingClientRect().right > wide + 0.5).map(each => each.outerHTML.slice(0, 120));''')

    def unnamed(self):
        """Controls that a screen reader could not name."""
        return self.page.script('''return [...document.querySelectorAll("button, input, select, textarea, a, [role=application]")].filter(each =>
              each.getClientRects().length && !each.getAttribute("aria-label") && !each.labels?.length && !each.textContent.trim())
              .map(each => each.outerHTML.slice(0, 120));''')

    def test_do_not_jump_while_a_value_changes(self):
        where = 'return [...document.querySelectorAll("#pane .field, #stage, #yaml")].map(each => each.getBoundingClientRect().top)'
        self.page.wait_for_picture()
        self.settle()
        before = self.page.script(where)
        self.page.type('simulated_rate', '2.5')
        self.page.wait_for_picture()
        self.settle()
        self.page.script('document.getElementById("pane").scrollTop = 0')
        self.assertEqual(self.page.script(where), before)

    def test_are_reached_by_keys(self):
        self.driver.execute_script('document.activeElement.blur()')
        seen = set()
        for _ in range(60):
            self.press(Keys.TAB)
            seen.add(self.page.script('return document.activeElement.getAttribute("href") ?? document.activeElement.id'))
        self.assertLessEqual({f'#{each}' for each in PANES}, seen)
        self.assertIn('field-simulated_rate', seen)


if __name__ == '__main__':
    arguments = sys.argv[1:]
    if arguments and pathlib.Path(arguments[0]).is_dir():
        Panes.screenshots = arguments.pop(0)
    unittest.main(argv=[sys.argv[0], *arguments], verbosity=2)
