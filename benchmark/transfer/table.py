"""The table of results, as Markdown."""
import math
import statistics

HEAD = ('| row | what | pictures | ms a picture | even, one seed | odd, mean | odd, lowest to highest | seeds | odd, full |',
        '| --- | --- | --- | --- | --- | --- | --- | --- | --- |')
NOT_RUN = 'not run'


def table(rows, results, train, failures=()):
    """@param failures  (row, what went wrong)"""
    lines = list(HEAD)
    run = [row for row in rows if any(results.trainings(row.name, part, full, train)
                                      for part in ('even', 'odd') for full in (False, True))]
    lines += [_line(row, results, train) for row in run]
    lines += ['', _spread(rows, results, train), '']
    not_run = [row.name for row in rows if row not in run and row.name not in dict(failures)]
    if not_run:
        lines += [f"Not run: {', '.join(not_run)}.", '']
    for row, text in failures:
        lines += [f'Failed: {row}: {text}', '']
    return '\n'.join(lines).rstrip() + '\n'


def _line(row, results, train):
    dataset = results.dataset(row.name)
    even = results.trainings(row.name, 'even', False, train).get(0)
    odd = list(results.trainings(row.name, 'odd', False, train).values())
    full = list(results.trainings(row.name, 'odd', True, train).values())
    return ' | '.join([
        f'| {row.name}', row.what, f"{dataset['pictures']:,}", f"{dataset['milliseconds']:.0f}", _number(even),
        _number(statistics.fmean(odd) if odd else None), f'{min(odd):.3f} to {max(odd):.3f}' if len(odd) > 1 else '',
        f'{len(odd)}' if odd else '', _number(statistics.fmean(full) if full else None)]) + ' |'


def _number(value):
    return NOT_RUN if value is None else f'{value:.3f}'


def _spread(rows, results, train):
    """A sentence on the spread over seeds of a row: smaller differences between rows may be chance."""
    groups = [list(results.trainings(row.name, 'odd', False, train).values()) for row in rows]
    groups = [values for values in groups if len(values) > 1]
    if not groups:
        return 'Spread: unknown, as no row has more than one seed.'
    degrees = sum(len(values) - 1 for values in groups)
    squares = sum(statistics.variance(values) * (len(values) - 1) for values in groups)
    return f'Spread: the standard deviation of a seed is {math.sqrt(squares / degrees):.3f} (rows with several: {len(groups)}).'
