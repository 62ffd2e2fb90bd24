#!/usr/bin/env python3
"""A long run of small scenes: memory and open descriptors should stay what they are.

    soak.py PROGRAMS SCENES

Compares the resident memory [VmRSS] after the first 1,000 scenes with that of every later time,
the finishing of the dataset included."""
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from typing import Any, Dict, List, NamedTuple

import yaml

import job

SETTLED = 1000       # scenes, after which a run has allocated all that it needs
GROWTH = 1.05        # of memory, above which the test fails
RATE = 100.0         # scenes a second of the recording
MEASURED = 0.9       # least share of the run
POLL = 0.05          # [s]
WINDOW = 20          # measures: their minimum has no descriptors that are open only briefly
TOLD = 10            # printed measures between the first scenes and the last
SIZE = job.Size(instants=0, rate=RATE, width=32, height=32)


class Measure(NamedTuple):
    """The state of a process at a time."""

    scenes: int       # made so far
    kilobytes: int    # resident
    descriptors: int  # open

    def text(self) -> str:
        return f'{self.kilobytes / 1024:.1f} MiB, {self.descriptors} descriptors'


def settings(inputs: pathlib.Path) -> Dict[str, Any]:
    """One object, one camera, two formats, and everything as cheap as possible."""
    result = job.settings(inputs, SIZE)
    camera = result.pop('cameras')['front']
    del camera['effects'], result['bravo'], result['split']
    result.update(camera=camera, robot_list=['alpha'],
                  rendering={'samples': 1, 'shadow_map_size': 64, 'shadow_distance': 8.0},
                  physics={'step': 0.01},
                  sync='off',  # waits for a shared disk are not to be measured
                  writers=[{'name': 'yolo', 'type': 'synthetic_dataset/Yolo'},
                           {'name': 'coco', 'type': 'synthetic_dataset/Coco'}])
    return {name: value for name, value in result.items() if name not in ('pvnet', 'bag')}


def write_inputs(inputs: pathlib.Path, scenes: int) -> pathlib.Path:
    inputs.mkdir()
    (inputs / 'tiny.world').write_text(job.world_text(['alpha']), encoding='ascii')
    (inputs / 'camera.yaml').write_text(job.camera_text(SIZE), encoding='ascii')
    job.write_recording(inputs / 'recording.bag', seconds=scenes / RATE, rate=10.0, chunk=65536)
    config = inputs / 'settings.yaml'
    config.write_text(yaml.safe_dump(settings(inputs)), encoding='ascii')
    return config


def measure(process: subprocess.Popen, scenes: int) -> Measure:
    of_process = pathlib.Path(f'/proc/{process.pid}')
    status = (of_process / 'status').read_text(encoding='ascii', errors='replace')
    resident = next(int(line.split()[1]) for line in status.splitlines() if 'VmRSS' in line)
    return Measure(scenes, resident, len(list((of_process / 'fd').iterdir())))


def scenes_made(output: pathlib.Path, known: int) -> int:
    """The number of scenes that are there, at least as many as `known`."""
    while (output / f'yolo/{known:08}.txt').exists():
        known += 1
    return known


def watch(process: subprocess.Popen, output: pathlib.Path, scenes: int) -> List[Measure]:
    """Measures the run from the first 1,000 scenes until it ends."""
    measures: List[Measure] = []
    made = 0
    while process.poll() is None:
        made = scenes_made(output, made)
        try:
            if made >= SETTLED:
                measures.append(measure(process, made))
                tell(measures, scenes)
        except (FileNotFoundError, ProcessLookupError, StopIteration):
            break  # the run has just ended
        time.sleep(POLL)
    return measures


def tell(measures: List[Measure], scenes: int) -> None:
    now, before = measures[-1], measures[-2].scenes if len(measures) > 1 else 0
    step = max(1, scenes // TOLD)
    if before < SETTLED or now.scenes // step != before // step:
        print(f'after {now.scenes} scenes: {now.text()}', flush=True)


def problems(measures: List[Measure], scenes: int) -> List[str]:
    if not measures or measures[-1].scenes < MEASURED * scenes:
        return ['the run was too quick to be measured']
    first = measures[0]
    most = max(measures, key=lambda each: each.kilobytes)
    before, after = (min(each.descriptors for each in part)
                     for part in (measures[:WINDOW], measures[-WINDOW:]))
    result = []
    if most.kilobytes >= GROWTH * first.kilobytes:
        result.append(f'memory grew by {100 * (most.kilobytes / first.kilobytes - 1):.1f} %: '
                      f'{most.text()} after {most.scenes} scenes')
    if after > before:
        result.append(f'open descriptors grew from {before} to {after}')
    return result


def soak(programs: pathlib.Path, scenes: int, scratch: pathlib.Path) -> List[str]:
    config = write_inputs(scratch / 'inputs', scenes)
    output = scratch / 'dataset'
    log = scratch / 'log'
    begin = time.monotonic()
    with open(log, 'w', encoding='utf-8') as messages:
        process = subprocess.Popen([str(programs / 'generate'), '--config', str(config),
                                    f'output_folder:={output}'], stdout=messages, stderr=messages)
        measures = watch(process, output, scenes)
    seconds = time.monotonic() - begin
    print(''.join(log.read_text(encoding='utf-8').splitlines(keepends=True)[-6:]), end='')
    if process.wait() != 0:
        return [f'the run exits with {process.returncode}']
    made = scenes_made(output, 0)
    finishing = [each for each in measures if each.scenes >= made]
    if finishing:
        print('while finishing, at most: '
              + max(finishing, key=lambda each: each.kilobytes).text())
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    busy = used.ru_utime + used.ru_stime
    print(f'{made} scenes in {seconds:.0f} s, {made / seconds:.0f} scenes/s; '
          f'{1000 * busy / made:.2f} ms of processor time each')
    return problems(measures, made)


def main() -> int:
    programs, scenes = pathlib.Path(sys.argv[1]), int(sys.argv[2])
    if scenes < 2 * SETTLED:
        sys.exit(f'at least {2 * SETTLED} scenes are needed, found {scenes}')
    scratch = pathlib.Path(tempfile.mkdtemp(prefix='synthetic_dataset_soak_'))
    try:
        found = soak(programs, scenes, scratch)
    finally:
        shutil.rmtree(scratch)
    for problem in found:
        print('FAILED: ' + problem)
    if not found:
        print('passed')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
