"""Starts ROS's programs for tests."""
import contextlib
import os
import socket
import subprocess

TIMEOUT = 300.0  # [s], for a program that hangs


def free_port():
    with contextlib.closing(socket.socket()) as probe:
        probe.bind(('', 0))
        return probe.getsockname()[1]


def environment(scratch):
    """This process' environment, with ROS's own files in the folder `scratch`."""
    return {**os.environ, 'ROS_HOME': scratch, 'ROS_LOG_DIR': scratch,
            'ROSCONSOLE_STDOUT_LINE_BUFFERED': '1'}


def output_of(command, environ):
    """All that a program printed, whatever its exit code."""
    return subprocess.run(command, env=environ, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          universal_newlines=True, timeout=TIMEOUT, check=False).stdout


def launch_command(*arguments):
    """generate.launch on a master of its own, beside the one of the test."""
    return ['roslaunch', '-p', str(free_port()), 'synthetic_dataset', 'generate.launch', *arguments]
