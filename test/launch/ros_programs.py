"""Starts ROS's programs for tests."""
import contextlib
import os
import pathlib
import socket
import subprocess

TIMEOUT = 300.0  # [s], for a program that hangs


def free_port():
    with contextlib.closing(socket.socket()) as probe:
        probe.bind(('', 0))
        return probe.getsockname()[1]


def path_of(program):
    """The path of a program that rosrun offers, as rosrun itself needs more of the environment."""
    found = subprocess.run(['catkin_find', '--first-only', '--libexec', 'synthetic_dataset',
                            program], stdout=subprocess.PIPE, universal_newlines=True, check=True)
    return pathlib.Path(found.stdout.strip())


def path_of_test_program(program):
    """The path of a program of the tests, which rosrun does not offer."""
    return path_of('generate').parents[1] / 'synthetic_dataset_tests' / program


def environment(scratch):
    """This process' environment, with ROS's own files in the folder `scratch`."""
    return {**os.environ, 'ROS_HOME': scratch, 'ROS_LOG_DIR': scratch,
            'ROSCONSOLE_STDOUT_LINE_BUFFERED': '1'}


def output_of(command, environ):
    """All that a program printed, whatever its exit code."""
    return subprocess.run(command, env=environ, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          universal_newlines=True, timeout=TIMEOUT, check=False).stdout


def launch_command(*arguments):
    """The command for generate.launch with its own master, beside that of the test."""
    return ['roslaunch', '-p', str(free_port()), 'synthetic_dataset', 'generate.launch', *arguments]
