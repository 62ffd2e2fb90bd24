"""A running `setup_assistant`, and a browser that shows it."""
import os
import pathlib
import queue
import re
import signal
import subprocess
import threading

from selenium import webdriver
from selenium.common.exceptions import StaleElementReferenceException, TimeoutException
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

TIMEOUT = float(os.environ.get("SETUP_ASSISTANT_TIMEOUT", "60"))  # [s]
ADDRESS = re.compile(r'(http://\S+:(\d+)/)\?token=(\S+)')


class Assistant:
    """The program, which runs until `stop`."""

    def __init__(self, file, *arguments):
        # For example --page, for work on the page without building it in each time.
        more = os.environ.get('SETUP_ASSISTANT_ARGUMENTS', '').split()
        command = ['rosrun', 'synthetic_dataset', 'setup_assistant', str(file), *map(str, arguments), *more]
        # In its own process group, as rosrun is a shell script.
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        universal_newlines=True, preexec_fn=os.setsid)
        self.lines = []
        self.address, self.port, self.token = self._address()

    def _address(self):
        found = queue.Queue()

        def read():
            for line in self.process.stdout:
                self.lines.append(line)
                match = ADDRESS.search(line)
                if match:
                    found.put(match)
            found.put(None)

        self.reader = threading.Thread(target=read, daemon=True)
        self.reader.start()
        match = found.get(timeout=TIMEOUT)
        if match is None:
            raise RuntimeError('setup_assistant has ended: ' + ''.join(self.lines))
        return match.group(1), int(match.group(2)), match.group(3)

    @property
    def whole_address(self):
        return f'{self.address}?token={self.token}'

    def stop(self, how=signal.SIGTERM):
        if self.process.poll() is None:
            os.killpg(self.process.pid, how)
        self.process.wait(timeout=TIMEOUT)
        self.reader.join(TIMEOUT)
        self.process.stdout.close()


def chromium():
    options = webdriver.ChromeOptions()
    for argument in ['--headless', '--no-sandbox', '--disable-gpu', '--hide-scrollbars', '--disable-dev-shm-usage']:
        options.add_argument(argument)
    options.set_capability('goog:loggingPrefs', {'browser': 'ALL'})
    driver = webdriver.Chrome(service=Service('/usr/bin/chromedriver'), options=options)
    new_tab(driver)
    return driver


def new_tab(driver):
    """Closes all tabs, and opens an empty one in a fresh state."""
    before = driver.window_handles
    driver.switch_to.new_window('tab')
    opened = driver.current_window_handle
    for handle in before:
        driver.switch_to.window(handle)
        driver.close()
    driver.switch_to.window(opened)
    driver.execute_cdp_cmd('Network.clearBrowserCookies', {})
    driver.get_log('browser')  # clears the log
    # A window has a minimum width; this is what the page sees.
    driver.execute_cdp_cmd('Emulation.setDeviceMetricsOverride', {
        'width': 1280, 'height': 800, 'deviceScaleFactor': 1, 'mobile': False})
    driver.execute_cdp_cmd('Emulation.setEmulatedMedia', {
        'features': [{'name': 'prefers-color-scheme', 'value': 'light'}]})


class Page:
    """What a user does with the page."""

    def __init__(self, driver):
        self.driver = driver
        self.server_was_killed = False

    def open(self, address):
        self.driver.get(address)
        self.wait(lambda: self.all('#nav a') and self.all('.pane-body'), 'the page to be drawn')

    def wait(self, condition, what, timeout=TIMEOUT):
        def holds(_):
            try:
                return condition()
            except StaleElementReferenceException:
                return False
        try:
            return WebDriverWait(self.driver, timeout, poll_frequency=0.05).until(holds)
        except TimeoutException:
            raise AssertionError(f'waited for {what}; the page says: {self.said()}') from None

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def one(self, selector):
        return self.wait(lambda: (self.all(selector) or [None])[0], selector)

    def text(self, selector):
        return self.driver.execute_script(
            'return document.querySelector(arguments[0])?.innerText ?? ""', selector)

    def said(self):
        return ' | '.join(self.text(each) for each in ['#header', '#banners', '#pane', '.yaml-state', '#dialog'])[:1500]

    def script(self, text, *arguments):
        return self.driver.execute_script(text, *arguments)

    def go(self, pane):
        self.click(f'#nav a[href="#{pane}"]')
        self.wait(lambda: self.all(f'body[data-pane="{pane}"]'), f'the pane {pane}')

    def field(self, path):
        return self.one(f'#pane [data-path="{path}"]')

    def input(self, path):
        return self.one(f'#pane [data-path="{path}"] .control input, #pane [data-path="{path}"] .control select')

    def type(self, path, text):
        """Types a value into a field and leaves it, and waits for the server to have it."""
        before = self.revision()

        def typed():
            element = self.input(path)
            self.script('arguments[0].focus()', element)
            element.send_keys(Keys.CONTROL, 'a')
            element.send_keys(text, Keys.TAB)
            return True
        self.wait(typed, f'{path} to be typed')
        self.wait(lambda: self.revision() > before, f'{path} to be taken')

    def click(self, selector, label=None):
        """Clicks on an element that the selector finds, with this text if it is given."""
        def find():
            for each in self.all(selector):
                if each.is_displayed() and (label is None or each.text.strip() == label or
                                            each.get_attribute('aria-label') == label):
                    return each
            return None
        self.click_found(find, f'{selector} {label or ""}')

    def click_found(self, find, what):
        """Clicks on the element that is found once nothing covers it. The page is redrawn and moves as answers
        arrive, so hit test and click are one script: WebDriver's click may hit what has moved there since."""
        def clicked():
            element = find()
            return element and self.script('''const element = arguments[0];
                element.scrollIntoView({block: "center"});
                const box = element.getClientRects()[0];
                const hit = box && document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
                if (!element.contains(hit)) return false;
                const focused = hit.closest("a, button, input, select, summary, textarea");
                focused ? focused.focus({preventScroll: true}) : document.activeElement.blur();
                hit.click();
                return true;''', element)
        self.wait(clicked, what)

    def click_and_wait(self, selector, label=None):
        before = self.revision()
        self.click(selector, label)
        self.wait(lambda: self.revision() > before, f'{selector} {label or ""} to change the settings')

    def listed(self):
        return [each.text for each in self.all('#dialog .listing .name')]

    def revision(self):
        found = re.search(r'revision (\d+)', self.script(
            'return document.querySelector(".yaml-state")?.textContent ?? ""'))
        return int(found.group(1)) if found else -1

    def yaml(self):
        return self.script('return document.getElementById("yaml-input").value')

    def type_yaml(self, text):
        """Replaces the text of the settings file, as pasting does."""
        self.script('''const input = document.getElementById("yaml-input");
            input.focus(); input.select(); document.execCommand("insertText", false, arguments[0]);''', text)

    def wait_for_picture(self):
        """Waits until the picture is that of the current settings."""
        self.wait(lambda: self.script(
            'return document.querySelector("#stage canvas").dataset.revision') == str(self.revision()),
            'the picture of these settings')

    def picture_sum(self):
        """A checksum of the picture's pixels."""
        return self.script('''const canvas = document.querySelector("#stage canvas");
            const {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
            let sum = 0;
            for (let i = 0; i < data.length; i += 4) sum = (sum * 31 + data[i] + 7 * data[i + 1] + 13 * data[i + 2]) % 1000003;
            return sum;''')

    def complaints(self):
        """Errors in the browser's console except for refused requests, which the page shows."""
        shown = ['status of 4', 'ERR_CONNECTION_REFUSED', 'ERR_INCOMPLETE']
        if self.server_was_killed:  # requests are lost, and how a connection ends depends on timing
            shown += ['net::ERR_']
        return [each['message'] for each in self.driver.get_log('browser')
                if each['level'] == 'SEVERE' and not any(words in each['message'] for words in shown)]

    def save(self, folder, name):
        if folder is not None:
            self.driver.save_screenshot(str(pathlib.Path(folder) / f'{name}.png'))
