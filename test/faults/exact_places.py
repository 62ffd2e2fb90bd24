"""Kills and failing disks at exact places: at the n-th system call that writes.

strace stops the program at the call, and kills it there or makes the call fail."""
import functools
import shutil
import subprocess
import threading
from typing import Dict, List, Sequence, Tuple

from trial import Failed, Fault, Finished, Place, Skipped, require, scaled

# Calls that change files, and the usual number of places that are tried for each.
WRITING = {'pwrite64': 18, 'rename': 8, 'link': 3, 'unlink': 10, 'write': 6, 'mkdir': 4,
           'fdatasync': 6, 'fsync': 2, 'syncfs': 3, 'ftruncate': 3, 'flock': 1, 'close': 6}
FAILING = {'pwrite64': ('EIO', 'ENOSPC'), 'write': ('ENOSPC', 'EIO', 'EDQUOT'),
           'rename': ('EIO', 'EDQUOT'), 'link': ('EMLINK', 'EPERM'), 'fdatasync': ('EIO',),
           'syncfs': ('EIO',), 'openat': ('EMFILE', 'ENOMEM'), 'ftruncate': ('EIO',),
           'mkdir': ('ENOSPC', 'EDQUOT'), 'close': ('EIO', 'EDQUOT')}
# A call whose failure does no harm: links become copies.
HARMLESS = ('link',)
PLACES_OF_A_FAILURE = 4
NOT_LOADED = 127  # the dynamic loader cannot open a library

_counts: Dict[str, int] = {}
_counting = threading.Lock()


@functools.lru_cache(maxsize=None)
def strace_works() -> bool:
    return shutil.which('strace') is not None and subprocess.run(
        ['strace', '-o', '/dev/null', 'true'], check=False).returncode == 0


def strace(place: Place, *options: str) -> List[str]:
    if not strace_works():
        raise Skipped('strace is not installed, or may not trace')
    return ['strace', '-f', '-qq', '-o', str(place.folder / 'trace'), *options]


def count_calls(place: Place) -> Dict[str, int]:
    """The number of times that an unbroken run makes each call."""
    with _counting:
        if not _counts:
            names = sorted({*WRITING, *FAILING})
            finished = place.run(before=strace(place, '-e', 'trace=' + ','.join(names)))
            require(finished.code == 0, finished.log)
            trace = (place.folder / 'trace').read_text(errors='replace')
            _counts.update({name: trace.count(f' {name}(') for name in names})
            place.clear()
    return _counts


def places(count: int, wanted: int) -> List[int]:
    """The first and the last calls, where a run begins and ends, and some in between."""
    if count <= wanted:
        return list(range(1, count + 1))
    edge = wanted // 3
    middle = wanted - 2 * edge
    between = [edge + 1 + (count - 2 * edge) * k // (middle + 1) for k in range(1, middle + 1)]
    return [*range(1, edge + 1), *between, *range(count - edge + 1, count + 1)]


def nth(place: Place, call: str, number: int, wanted: int) -> int:
    """The place for the trial `number`; there may be fewer places than are wanted."""
    found = places(count_calls(place)[call], wanted)
    if not found:
        raise Skipped(f'{call} is never called')
    return found[number % len(found)]


def kill_at(call: str, number: int, wanted: int, place: Place) -> None:
    at = nth(place, call, number, wanted)
    before = strace(place, '-e', f'trace={call}', '-e', f'inject={call}:signal=SIGKILL:when={at}')
    finished = place.run(before=before)
    # With threads, counts differ by a few, so the last place may be past the end.
    require(finished.code == 0 or finished.died, f'exits with {finished.code}:\n{finished.log}')
    try:
        place.look_for_losses()
        place.resume()
    except Failed as error:
        raise Failed(f'killed at {call} number {at}: {error}') from None


def fail_at(call: str, error: str, number: int, ever_after: bool, place: Place) -> None:
    at = nth(place, call, number, PLACES_OF_A_FAILURE)
    when = f'{at}+' if ever_after else str(at)
    before = strace(place, '-e', f'trace={call}', '-e', f'inject={call}:error={error}:when={when}')
    finished = place.run(before=before)
    try:
        # If all later writes fail, messages cannot be written either.
        check_failure(place, call, finished, says_so=not (call == 'write' and ever_after))
    except Failed as failure:
        raise Failed(f'{call} number {when} fails with {error}: {failure}') from None


def check_failure(place: Place, call: str, finished: Finished, says_so: bool) -> None:
    if finished.code == 0:
        # A harmless failure: the dataset is right at once. Links that failed became copies.
        if call not in HARMLESS:
            place.require_right()
        return
    if finished.code != NOT_LOADED:
        place.require_refusal(finished, *(['failed'] if says_so else []))
    place.look_for_losses()
    place.resume()


def kills(percent: int) -> List:
    return [functools.partial(kill_at, call, number, scaled(wanted, percent))
            for call, wanted in WRITING.items() for number in range(scaled(wanted, percent))]


def failures(percent: int) -> List:
    trials: Sequence[Tuple] = [
        (call, error, number, number % 2 == 1) for call, errors in FAILING.items()
        for error in errors for number in range(PLACES_OF_A_FAILURE)]
    step = max(1, round(100 / percent))
    return [functools.partial(fail_at, *each) for each in trials[::step]]


FAULTS = [
    Fault('kill -9 at an exact place',
          'strace kills at the first, the last and other calls of ' + ', '.join(WRITING), kills),
    Fault('a disk that fails',
          'strace lets one call, or all from then on, fail with EIO, ENOSPC, EDQUOT and others',
          failures),
]
