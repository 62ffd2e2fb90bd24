"""Environments in which programs stumble: no home, no room for temporary files, no output."""
from typing import Dict, List

from folders import closed, without_privileges
from full_disk import disk
from trial import Fault, Place, require


def require_success(place: Place, **start) -> None:
    finished = place.run(**start)
    require(finished.code == 0, f'exits with {finished.code}:\n{finished.log}')
    place.require_right()


def read_only_inputs(place: Place) -> None:
    files = list(place.inputs.iterdir())
    for file in files:
        file.chmod(0o444)
    try:
        with closed(place.inputs):
            require_success(place, before=without_privileges())
    finally:
        for file in files:
            file.chmod(0o644)


def unreadable_input(name: str):
    def trial(place: Place) -> None:
        (place.inputs / name).chmod(0o000)
        try:
            finished = place.run(before=without_privileges())
            place.require_refusal(finished, name)
            require(not place.output.exists(), 'something was made')
        finally:
            (place.inputs / name).chmod(0o644)
    return trial


def without(place: Place, *names: str, **more: str) -> Dict[str, str]:
    environment = {name: value for name, value in place.environment.items() if name not in names}
    return {**environment, **more}


def no_home(place: Place) -> None:
    require_success(place, environment=without(place, 'HOME', 'ROS_HOME', 'ROS_LOG_DIR'))


def home_that_is_not_there(place: Place) -> None:
    require_success(place, environment=without(place, 'ROS_HOME', 'ROS_LOG_DIR',
                                               HOME='/no/such/folder'))


def read_only_home(place: Place) -> None:
    home = place.folder / 'home'
    home.mkdir(exist_ok=True)
    with closed(home):
        require_success(place, environment=without(place, 'ROS_HOME', 'ROS_LOG_DIR',
                                                   HOME=str(home)),
                        before=without_privileges())


def read_only_tmp(place: Place) -> None:
    folder = place.folder / 'tmp'
    folder.mkdir(exist_ok=True)
    with closed(folder):
        require_success(place, environment=without(place, TMPDIR=str(folder)),
                        before=without_privileges())


def no_space_in_tmp(place: Place) -> None:
    folder = place.folder / 'full_tmp'
    with disk(place, '4k,nr_inodes=1', folder):
        require_success(place, environment=without(place, TMPDIR=str(folder)))


def redirected(how: str):
    """The messages are lost; the dataset is not."""
    def trial(place: Place) -> None:
        finished = place.run(before=['sh', '-c', f'exec "$@" {how}', 'sh'])
        require(finished.code == 0, f'exits with {finished.code}:\n{finished.log}')
        place.require_right()
    return trial


def reader_goes(place: Place) -> None:
    """The reader of the messages, such as `head`, has exited."""
    process = place.start()
    assert process.stdout is not None
    process.stdout.readline()
    process.stdout.close()
    code = process.wait()
    require(code == 0, f'exits with {code} when nobody reads its messages')
    place.require_right()


def other_language(place: Place) -> None:
    require_success(place, environment=without(place, LC_ALL='de_DE.UTF-8', TZ='Asia/Tokyo'))


def from_nowhere(place: Place) -> None:
    """The current folder has been removed."""
    script = 'mkdir gone && cd gone && rmdir ../gone && exec "$@"'
    require_success(place, before=['sh', '-c', script, 'sh'])


HOMES: List = [no_home, home_that_is_not_there, read_only_home]
MESSAGES: List = [redirected('> /dev/full 2>&1'), redirected('>&- 2>&-'),
                  redirected('<&- >&- 2>&-'), reader_goes]
INPUTS = ('recording.bag', 'tiny.world', 'camera.yaml', 'settings.yaml')

FAULTS = [
    Fault('read-only inputs', 'files and folder without permission to write',
          lambda _: [read_only_inputs]),
    Fault('unreadable inputs', ', '.join(INPUTS), lambda _: list(map(unreadable_input, INPUTS))),
    Fault('no home', 'HOME unset, missing, read-only', lambda _: HOMES),
    Fault('`TMPDIR` read-only or full', 'no temporary files are needed',
          lambda _: [read_only_tmp, no_space_in_tmp]),
    Fault('messages that nobody takes', 'closed or full output, a pipe whose reader goes',
          lambda _: MESSAGES),
    Fault('other surroundings', 'another language and time zone; a working folder that is gone',
          lambda _: [other_language, from_nowhere]),
]
