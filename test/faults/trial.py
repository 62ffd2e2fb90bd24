"""A place in which faults happen to a job, and what their trials have in common."""
import os
import pathlib
import random
import shutil
import subprocess
import time
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Set

import dataset
import job

TIMEOUT = 120.0  # [s], for a program that hangs
POLL = 0.0005    # [s]


class Failed(Exception):
    """A trial in which something was not as it should be."""


class Skipped(Exception):
    """A trial that this machine does not allow."""


class Finished(NamedTuple):
    """A program that has ended."""

    code: int   # exit code; negative: the signal that killed it
    log: str    # all that it printed

    @property
    def died(self) -> bool:
        """Whether a signal killed it, also as reported by shells and wrappers."""
        return self.code < 0 or self.code > 128


class Fault(NamedTuple):
    """A row of the table."""

    name: str
    how: str                                    # how the fault is made
    trials: Callable[[int], Sequence['Trial']]  # for a number of per cent of the usual count


Trial = Callable[['Place'], None]


def scaled(count: int, percent: int) -> int:
    return max(1, round(count * percent / 100))


def require(condition: bool, message: str) -> None:
    if not condition:
        raise Failed(message)


class Place:
    """A folder with a job's inputs, and the dataset that is made from them again and again.

    Some labels name absolute paths, so datasets that are compared have to be in the same folder;
    trials that run side by side have places of their own.
    """

    def __init__(self, folder: pathlib.Path, programs: pathlib.Path) -> None:
        self.folder = folder
        self.programs = programs
        self.inputs = folder / 'inputs'
        self.output = folder / 'dataset'
        self.config = job.write_inputs(self.inputs)
        self.environment = {**os.environ, 'LP_NUM_THREADS': '1', 'ROS_LOG_DIR': str(folder / 'log'),
                            'ROS_HOME': str(folder / 'log')}
        self.reference: dataset.Snapshot = {}
        self.scene_lost: List[str] = []
        self.half_written: List[str] = []
        self.seconds = 0.0  # duration of an unbroken run
        self.clear()

    def make_reference(self) -> None:
        """Makes the unbroken run with which all others are compared."""
        self.clear()
        begin = time.monotonic()
        finished = self.run()
        require(finished.code == 0, f'an unbroken run fails:\n{finished.log}')
        self.seconds = time.monotonic() - begin
        self.reference = dataset.snapshot(self.output)

    def clear(self) -> None:
        """Removes all but the inputs, and forgets all losses."""
        if self.output.is_symlink() or self.output.is_file():
            self.output.unlink()
        elif self.output.exists():
            shutil.rmtree(self.output)
        self.scene_lost.clear()
        self.half_written.clear()

    def command(self, settings: Dict[str, Any]) -> List[str]:
        chosen = {'output_folder': self.output, **settings}
        return [str(self.programs / 'generate'), '--config', str(self.config),
                *(f'{name}:={value}' for name, value in chosen.items())]

    def start(self, settings: Optional[Dict[str, Any]] = None, before: Sequence[str] = (),
              environment: Optional[Dict[str, str]] = None,
              program: Optional[List[str]] = None) -> 'subprocess.Popen[str]':
        """
        :param before: a program with arguments that starts ours
        :param program: a program with arguments in place of `generate`
        """
        command = program or self.command(settings or {})
        return subprocess.Popen([*before, *command], env=environment or self.environment,
                                cwd=self.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True, errors='replace')

    def end(self, process: 'subprocess.Popen[str]') -> Finished:
        try:
            log, _ = process.communicate(timeout=TIMEOUT)
        except subprocess.TimeoutExpired:
            process.kill()
            log, _ = process.communicate()
            raise Failed(f'hangs; it printed:\n{log}') from None
        return Finished(process.returncode, log)

    def run(self, settings: Optional[Dict[str, Any]] = None, before: Sequence[str] = (),
            environment: Optional[Dict[str, str]] = None,
            program: Optional[List[str]] = None) -> Finished:
        return self.end(self.start(settings, before, environment, program))

    def has_scene(self, instant: int) -> bool:
        """Whether the labels of the last camera's scene of this time are there."""
        return (self.output / f'yolo/high/{instant:08}.txt').exists()

    def kill_in_the_middle(self, instant: int, settings: Optional[Dict[str, Any]] = None) -> None:
        """Leaves an unfinished dataset with scenes up to a time."""
        process = self.start(settings)
        wait_for(lambda: self.has_scene(instant), process)
        process.kill()
        finished = self.end(process)
        require(finished.code == -9, f'the run ended before it was killed:\n{finished.log}')

    def manifests(self) -> List[pathlib.Path]:
        return sorted(self.output.glob('manifest*.sqlite'))

    def listed(self) -> Dict[int, Set[str]]:
        """The files of all scenes that are listed in any manifest."""
        files: Dict[int, Set[str]] = {}
        for manifest in self.manifests():
            files.update(dataset.listed_scenes(manifest).files)
        return files

    def look_for_losses(self) -> None:
        """After a fault, checks that all is whole that has its final name or is listed."""
        found = dataset.snapshot(self.output)
        self.half_written += dataset.half_written(found, self.reference)
        for manifest in self.manifests():
            lost = dataset.lost_scenes(dataset.listed_scenes(manifest), found, self.reference)
            self.scene_lost += [f'{manifest.name}: scene {scene}' for scene in lost]

    def require_right(self) -> None:
        """Requires the bytes of an unbroken run's dataset, and no other files."""
        wrong = dataset.differences(dataset.snapshot(self.output), self.reference)
        require(not wrong, 'the dataset differs from an unbroken run\'s: ' + '; '.join(wrong[:8]))

    def resume(self, settings: Optional[Dict[str, Any]] = None) -> None:
        """Repeats the command: listed files stay, and the dataset becomes right."""
        before = {path: (self.output / path).lstat().st_ino
                  for paths in self.listed().values() for path in paths}
        finished = self.run(settings)
        require(finished.code == 0, f'resuming exits with {finished.code}:\n{finished.log}')
        self.require_right()
        again = [path for path, inode in before.items()
                 if (self.output / path).lstat().st_ino != inode]
        require(not again, f'made again although it was whole: {again[:4]}')

    def require_refusal(self, finished: Finished, *words: str) -> None:
        """Requires an exit code of 1, and a message with all of these words."""
        require(finished.code == 1, f'exits with {finished.code} instead of 1:\n{finished.log}')
        for word in words:
            require(word in finished.log, f'does not say "{word}":\n{finished.log}')


_seed: List[str] = []


def use_seed(seed: str) -> None:
    """Makes all trials draw other numbers; an empty seed changes nothing."""
    _seed[:] = [seed] if seed else []


def random_of(*names: Any) -> random.Random:
    """Random numbers that are always the same for the same trial and seed."""
    return random.Random('/'.join(map(str, [*_seed, *names])))


def wait_for(condition: Callable[[], bool], process: 'subprocess.Popen[str]') -> None:
    """Waits until the condition holds or the process has ended."""
    deadline = time.monotonic() + TIMEOUT
    while not condition() and process.poll() is None:
        if time.monotonic() > deadline:
            raise TimeoutError(f'what was waited for did not happen within {TIMEOUT} s')
        time.sleep(POLL)
