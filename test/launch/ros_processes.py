"""Runs ROS's programs as a user does, for tests: each with its own master, each ended in time."""
import os
import pathlib
import socket
import subprocess
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
TIME_LIMIT = 200  # [s]: a run that takes longer has hung


def free_port():
    """A port for a master of one's own."""
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]


def run(command, **kwargs):
    """Runs a command to its end. Returns its exit code and what it printed."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          timeout=TIME_LIMIT, check=False, **kwargs)
    return done.returncode, done.stdout


def roslaunch_generate(env=None, **arguments):
    """roslaunch of generate.launch with launch arguments. Returns what it printed."""
    command = ['roslaunch', '-p', str(free_port()), 'synthetic_dataset', 'generate.launch']
    command += [f'{name}:={value}' for name, value in arguments.items()]
    return run(command, env=env)[1]


class Master:
    """A roscore of one's own, for programs that need one."""

    def __enter__(self):
        port = free_port()
        self.env = dict(os.environ, ROS_MASTER_URI=f'http://localhost:{port}')
        self.process = subprocess.Popen(['roscore', '-p', str(port)], env=self.env,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        deadline = time.monotonic() + TIME_LIMIT
        while run(['rosparam', 'list'], env=self.env)[0] != 0:
            if time.monotonic() > deadline:
                raise RuntimeError('roscore does not answer')
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()

    def load(self, file):
        """Replaces generate's parameters by a file's."""
        run(['rosparam', 'delete', '/generate'], env=self.env)
        code, text = run(['rosparam', 'load', str(file), '/generate'], env=self.env)
        if code != 0:
            raise RuntimeError(text)


def example_settings(file, **changes):
    """Writes the example's settings, with lines added or replaced, for programs without roslaunch."""
    text = (REPOSITORY / 'config' / 'example.yaml').read_text()
    text = text.replace('$(find synthetic_dataset)', str(REPOSITORY))
    lines = [line for line in text.splitlines() if line.split(':')[0] not in changes]
    lines += [f'{name}: {value}' for name, value in changes.items()]
    pathlib.Path(file).write_text('\n'.join(lines) + '\n')
    return file
