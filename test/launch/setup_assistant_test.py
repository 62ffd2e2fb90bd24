#!/usr/bin/env python3
"""The server of setup_assistant: who has access, and how runs stop and resume."""
import hashlib
import http.client
import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import rosunit

import ros_programs

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = REPOSITORY / 'config' / 'example.yaml'


class Server:
    """A setup assistant and a client that has its token."""

    def __init__(self, *arguments):
        program = ros_programs.path_of('setup_assistant')
        self.process = subprocess.Popen([program, *map(str, arguments)], stdout=subprocess.PIPE,
                                        universal_newlines=True)
        self.address = self.process.stdout.readline().strip()
        host, self.token = self.address.split('//')[1].split('/?token=')
        self.port = int(host.split(':')[1])
        self.page, self.cookie = self._visit()

    def _visit(self):
        """The page's folder, and the cookie that a browser would get."""
        connection = http.client.HTTPConnection('127.0.0.1', self.port,
                                                timeout=ros_programs.TIMEOUT)
        connection.request('GET', f'/?token={self.token}')
        answer = connection.getresponse()
        connection.close()
        return answer.getheader('Location').rstrip('/'), answer.getheader('Set-Cookie').split(';')[0]

    def ask(self, path, body=None, headers=None):
        """Status and text of the answer."""
        connection = http.client.HTTPConnection('127.0.0.1', self.port,
                                                timeout=ros_programs.TIMEOUT)
        cookie = {'Cookie': self.cookie}
        connection.request('GET' if body is None else 'POST', self.page + path,
                           body=None if body is None else json.dumps(body),
                           headers=cookie if headers is None else headers)
        answer = connection.getresponse()
        text = answer.read()
        connection.close()
        return answer.status, text

    def get(self, path):
        return json.loads(self.ask(path)[1])

    def wait_for_run(self, is_there):
        """The run's first state of this kind; polls as often as a page that receives no events."""
        end = time.monotonic() + ros_programs.TIMEOUT
        while time.monotonic() < end:
            state = self.get('/api/run')
            if is_there(state):
                return state
            time.sleep(0.05)
        raise AssertionError(state)

    def stop(self, how=signal.SIGINT):
        self.process.send_signal(how)
        code = self.process.wait(ros_programs.TIMEOUT)
        self.process.stdout.close()
        return code


class SetupAssistant(unittest.TestCase):

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix='synthetic_dataset_')
        self.addCleanup(scratch.cleanup)
        self.scratch = pathlib.Path(scratch.name).resolve()

    def settings(self, name):
        """The example's settings, in their own folder, into which the dataset goes too."""
        folder = self.scratch / name
        folder.mkdir()
        text = EXAMPLE.read_text(encoding='utf-8')
        text = text.replace('"$(optenv HOME /tmp)/synthetic_dataset_example"',
                            '"$(dirname)/dataset"')
        (folder / 'settings.yaml').write_text(text, encoding='utf-8')
        return folder / 'settings.yaml'

    def serve(self, *arguments):
        server = Server(*arguments)
        self.addCleanup(lambda: server.process.poll() is None and server.stop(signal.SIGKILL))
        return server

    def digests(self, folder):
        """The digests of all files but the manifest, which contains the time of the run."""
        return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
                for path in sorted(folder.rglob('*'))
                if path.is_file() and 'manifest' not in path.name}

    def test_answers_nobody_without_the_token(self):
        begin = time.monotonic()
        server = self.serve(self.settings('token'))
        self.assertLess(time.monotonic() - begin, 5.0)
        folder = server.page
        for server.page in (folder, ''):
            for path in ('/', '/api/state', '/page/main.js', '/no/such/path', '/api/events'):
                self.assertEqual(server.ask(path, headers={}), (403, b''))
        self.assertEqual(server.ask('/api/state')[0], 403)  # outside of the cookie's folder
        server.page = folder
        self.assertEqual(server.ask('/api/set', body={}, headers={})[0], 403)
        wrong = {'Cookie': f'synthetic_dataset_{server.port}=0'}
        self.assertEqual(server.ask('/api/state', headers=wrong)[0], 403)
        self.assertEqual(server.ask('/api/state')[0], 200)
        listening = pathlib.Path('/proc/net/tcp').read_text(encoding='ascii')
        self.assertIn(f'0100007F:{server.port:04X} 00000000:0000 0A', listening)  # 127.0.0.1 only
        self.assertEqual(server.stop(), 0)
        again = self.serve(self.scratch / 'token' / 'settings.yaml')
        self.assertNotEqual(again.token, server.token)

    def test_reads_nothing_elsewhere(self):
        server = self.serve(self.settings('paths'))
        (self.scratch / 'paths' / 'way_out').symlink_to('/etc')
        for folder in ('/etc', '../..', 'way_out', f'{self.scratch}/paths/../../../etc'):
            self.assertEqual(server.ask(f'/api/files?folder={folder}')[0], 403, folder)
        self.assertEqual(server.ask('/page/../../settings.yaml')[0], 404)
        self.assertEqual(server.ask('/page/%2e%2e/settings.yaml')[0], 404)

    def test_a_run_stops_with_its_server_and_goes_on_with_the_next(self):
        settings = self.settings('broken')
        dataset = settings.parent / 'dataset'
        subprocess.run([ros_programs.path_of('generate'), '--config', settings], check=True,
                       stdout=subprocess.DEVNULL)
        whole = self.digests(dataset)
        shutil.rmtree(dataset)  # the same folder again, since lists of images name it

        server = self.serve(settings)
        self.assertEqual(server.ask('/api/run/start', body={})[0], 200)
        server.wait_for_run(lambda state: state['scenes_done'] > 2)
        self.assertEqual(server.ask('/api/run/start', body={})[0], 409)
        server.stop(signal.SIGKILL)

        server = self.serve(settings)
        state = server.wait_for_run(lambda state: not state['elsewhere'])  # it ends after its scene
        self.assertEqual(state['state'], 'idle')
        before = self.digests(dataset)
        self.assertLess(len(before), len(whole))
        self.assertEqual(self.digests(dataset), before)

        self.assertEqual(server.ask('/api/run/start', body={})[0], 200)
        state = server.wait_for_run(lambda state: state['state'] not in ('running', 'idle'))
        self.assertEqual((state['state'], state['exit_code']), ('done', 0), state)
        self.assertEqual(self.digests(dataset), whole)

        result = server.get('/api/result')
        self.assertEqual(result['scene_count'], 38)
        self.assertEqual(server.ask('/' + result['scenes'][0]['overlay'])[1][:2], b'\xff\xd8')
        self.assertEqual(json.loads(server.ask('/api/verify', body={})[1])['ok'], True)
        self.assertEqual(server.stop(), 0)

    def test_stops_and_goes_on(self):
        server = self.serve(self.settings('stopped'))
        server.ask('/api/run/start', body={})
        server.wait_for_run(lambda state: state['scenes_done'] > 2)
        server.ask('/api/run/stop', body={})
        state = server.wait_for_run(lambda state: state['state'] != 'running')
        self.assertEqual((state['state'], state['exit_code']), ('stopped', 130))
        server.ask('/api/run/start', body={})
        state = server.wait_for_run(lambda state: state['state'] not in ('running', 'idle'))
        self.assertEqual(state['state'], 'done', state)

    def test_starts_a_file_for_bags(self):
        bag = REPOSITORY / 'worlds' / 'example.bag'
        server = self.serve(self.scratch / 'new.yaml', bag)
        self.assertIn(str(bag), (self.scratch / 'new.yaml').read_text(encoding='utf-8'))
        self.assertEqual(server.get('/api/state')['settings']['bag_file'], str(bag))
        self.assertEqual(os.listdir(self.scratch), ['new.yaml'])


if __name__ == '__main__':
    rosunit.unitrun('synthetic_dataset', 'setup_assistant', SetupAssistant)
