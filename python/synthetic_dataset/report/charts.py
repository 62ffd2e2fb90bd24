"""The page's charts, each as SVG text."""
import functools
import html
import io
import re

import matplotlib

matplotlib.use('Agg')  # before pyplot is imported, which would look for a display
from matplotlib import colors, pyplot, ticker  # noqa: E402
import numpy as np  # noqa: E402

INK, FAINT, ACCENT = '#1d2733', '#8794a3', '#2f6f9f'
# Okabe and Ito's colours, which colour-blind people can tell apart, darkest first.
PALETTE = ('#0072b2', '#d55e00', '#009e73', '#cc79a7', '#b8860b', '#56b4e9', '#7a5195', '#6b7280')
SPLIT_COLOURS = {'train': '#2f6f9f', 'val': '#e39b3a', 'test': '#5aa469', '': '#2f6f9f'}
HEAT = colors.LinearSegmentedColormap.from_list(
    'heat', ['#f4f7fa', '#b9d4e6', '#5b9cc4', '#235f8c', '#0d2b45'])
MOST_LETTERS = 22
MOST_BARS = 12  # classes in a chart of bars

STYLE = {
    'font.size': 8.5, 'font.family': 'DejaVu Sans', 'axes.edgecolor': FAINT, 'axes.linewidth': 0.7,
    'axes.labelcolor': INK, 'axes.spines.top': False, 'axes.spines.right': False,
    'axes.grid': True, 'axes.axisbelow': True, 'grid.color': '#e3e8ee', 'grid.linewidth': 0.7,
    'xtick.color': INK, 'ytick.color': INK, 'text.color': INK, 'xtick.major.width': 0.7,
    'ytick.major.width': 0.7, 'legend.frameon': False, 'legend.fontsize': 8,
    'svg.hashsalt': 'synthetic_dataset', 'svg.fonttype': 'path',
}


def colours_of(measures):
    """A colour for each class; of many classes, those with the fewest labels share one."""
    if len(measures.class_names) <= len(PALETTE):
        return list(PALETTE[:len(measures.class_names)])
    colours = [FAINT] * len(measures.class_names)
    for colour, each in zip(PALETTE, sorted(by_frequency(measures)[:len(PALETTE)])):
        colours[each] = colour
    return colours


def by_frequency(measures):
    """The indices of classes, sorted by number of labels, most first."""
    counts = np.bincount(measures.label_class, minlength=len(measures.class_names))
    return np.argsort(-counts, kind='stable')


def short(name, letters=MOST_LETTERS):
    """The name, shortened to leave room for the chart."""
    return name if len(name) <= letters else name[:letters - 1] + '…'


def _styled(draw):
    """Applies the style while a chart is drawn: matplotlib reads it for each part it creates."""
    @functools.wraps(draw)
    def drawn(*arguments, **options):
        with matplotlib.rc_context(STYLE):
            return draw(*arguments, **options)
    return drawn


def _figure(width=4.5, height=2.7):
    return pyplot.subplots(figsize=(width, height), constrained_layout=True)


def _svg(figure, description):
    """The figure as SVG without a fixed size, so that it fills its place in the page."""
    text = io.StringIO()
    # No date, so that equal datasets give equal pages.
    figure.savefig(text, format='svg', transparent=True, metadata={'Date': None})
    pyplot.close(figure)
    svg = text.getvalue()
    svg = svg[svg.index('<svg'):]
    # A style element would apply to the whole page.
    svg = re.sub(r'<metadata>.*?</metadata>|<style.*?</style>', '', svg, flags=re.DOTALL)
    svg = re.sub(r' (width|height)="[\d.]+pt"', '', svg, count=2)
    # Without a prefix, identifiers would be the same in all charts of a page.
    prefix = re.sub(r'\W', '', description)
    svg = re.sub(r'(id="|href="#|url\(#)', lambda found: f'{found.group(1)}{prefix}_', svg)
    return svg.replace('<svg ', f'<svg role="img" aria-label="{html.escape(description)}" '
                       'stroke-linejoin="round" ', 1)


def _series(measures, values, of_labels=True):
    """Yields each class's name, colour and values; the remaining classes form one series."""
    yield from _series_of(measures, measures.label_class, values, of_labels)


def _series_of(measures, classes, values, of_values=True):
    """_series for values that do not belong to labels. @param classes  the class of each value"""
    colours = colours_of(measures)
    shown = [each for each, colour in enumerate(colours) if colour != FAINT]
    letters = MOST_LETTERS if len(colours) <= 3 else MOST_LETTERS // 2
    for each in shown:
        of_class = values[(classes == each) & of_values]
        if len(of_class):
            yield short(measures.class_names[each], letters), colours[each], of_class
    rest = values[~np.isin(classes, shown) & of_values]
    if len(rest):
        yield 'others', FAINT, rest


def histogram(measures, values, label, bins, log=False, marks=(), of_labels=True):
    """A histogram of a value of the labels, by class."""
    series = _series(measures, np.clip(values, bins[0], bins[-1]), of_labels)
    return _stacked(list(series), label, 'labels', bins, log, marks)


def of_classes(measures, classes, values, label, of_what, bins, log=False, marks=()):
    """A histogram of values that are not those of labels. @param classes  the class of each"""
    series = _series_of(measures, classes, np.clip(values, bins[0], bins[-1]))
    return _stacked(list(series), label, of_what, bins, log, marks)


@_styled
def _stacked(series, label, of_what, bins, log, marks):
    figure, axes = _figure()
    axes.hist([each[2] for each in series], bins=bins, stacked=True,
              color=[each[1] for each in series], label=[each[0] for each in series],
              edgecolor='white', linewidth=0.4)
    if log:
        axes.set_xscale('log')
        axes.xaxis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f'{value:,.0f}'))
    for position, text in marks:
        axes.axvline(position, color=INK, linewidth=0.8, linestyle=(0, (4, 3)))
        axes.annotate(text, (position, 1.0), xycoords=('data', 'axes fraction'), xytext=(3, -8),
                      textcoords='offset points', fontsize=7.5, color=INK,
                      bbox={'facecolor': 'white', 'edgecolor': 'none', 'pad': 0.8})
    return _finished(figure, axes, label, of_what, len(series) > 1, label)


@_styled
def plain_histogram(values, label, of_what, bins, description=''):
    figure, axes = _figure()
    axes.xaxis.set_major_locator(ticker.MaxNLocator(8, integer=True))
    axes.hist(values, bins=bins, color=ACCENT, edgecolor='white', linewidth=0.4)
    return _finished(figure, axes, label, of_what, False, description or label)


def _finished(figure, axes, label, of_what, has_legend, description):
    axes.grid(axis='x', visible=False)
    axes.set_xlabel(label)
    axes.set_ylabel(of_what)
    axes.yaxis.set_major_locator(ticker.MaxNLocator(5, integer=True))
    axes.yaxis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f'{value:,.0f}'))
    if has_legend:
        _legend(axes)
    return _svg(figure, description)


def _legend(axes, **options):
    axes.legend(loc='lower left', bbox_to_anchor=(0.0, 1.0), ncol=4, handlelength=1.0,
                handletextpad=0.4, columnspacing=1.2, borderaxespad=0.1, **options)


@_styled
def class_counts(measures, splits, counts):
    """Labels of each class, by split; only the classes with the most labels if there are many."""
    shown = sorted(by_frequency(measures)[:MOST_BARS])
    names, counts = [short(measures.class_names[each]) for each in shown], counts[shown]
    figure, axes = _figure()
    rows = np.arange(len(names))
    left = np.zeros(len(rows))
    for column, split in enumerate(splits):
        axes.barh(rows, counts[:, column], left=left, height=0.62,
                  color=SPLIT_COLOURS.get(split, FAINT), label=split or 'all',
                  edgecolor='white', linewidth=0.4)
        left += counts[:, column]
    axes.set_yticks(rows)
    axes.set_yticklabels(names)
    axes.invert_yaxis()
    axes.grid(axis='y', visible=False)
    axes.set_xlabel('labels')
    axes.xaxis.set_major_locator(ticker.MaxNLocator(5, integer=True))
    axes.xaxis.set_major_formatter(ticker.FuncFormatter(lambda value, _: f'{value:,.0f}'))
    if len(splits) > 1:
        _legend(axes)
    return _svg(figure, 'labels by class and split')


@_styled
def positions(boxes, size, name):
    """The share of the labels' boxes that covers each place in the image."""
    columns = 64
    rows = max(1, int(round(columns * size[1] / size[0])))
    change = np.zeros((rows + 1, columns + 1))
    scaled = boxes / np.tile(size, 2) * (columns, rows, columns, rows)
    first = np.clip(np.floor(scaled[:, :2]).astype(int), 0, (columns - 1, rows - 1))
    last = np.clip(np.ceil(scaled[:, 2:]).astype(int), first + 1, (columns, rows))
    for x, y, sign in ((first[:, 0], first[:, 1], 1), (last[:, 0], first[:, 1], -1),
                       (first[:, 0], last[:, 1], -1), (last[:, 0], last[:, 1], 1)):
        np.add.at(change, (y, x), sign)
    covered = change.cumsum(axis=0).cumsum(axis=1)[:rows, :columns] / max(1, len(boxes))
    figure, axes = _figure()
    picture = axes.imshow(100 * covered, cmap=HEAT, extent=(0, size[0], size[1], 0), vmin=0,
                          interpolation='nearest')
    axes.grid(visible=False)
    axes.set_xlabel('x [px]')
    axes.set_ylabel('y [px]')
    bar = figure.colorbar(picture, ax=axes, shrink=0.8, pad=0.02)
    bar.set_label('labels whose box covers it [%]')
    bar.outline.set_visible(False)
    return _svg(figure, f'positions of boxes, camera {name}')


@_styled
def box_sizes(measures):
    """Widths and heights of boxes by class, as points on logarithmic axes."""
    figure, axes = _figure()
    most = 4000  # points in one SVG
    step = max(1, measures.count // most)
    order = np.arange(0, measures.count, step)
    sizes = np.maximum(measures.box_size, 1.0)
    for name, colour, rows in _series(measures, np.arange(measures.count)):
        rows = np.intersect1d(rows, order)
        axes.scatter(sizes[rows, 0], sizes[rows, 1], s=7, color=colour, alpha=0.55, linewidths=0,
                     label=name, rasterized=True)
    limit = sizes.max(initial=10.0) * 1.3
    lowest = max(1.0, sizes.min(initial=limit) / 1.3)
    for side, text in ((32, '32² px'), (96, '96² px')):
        line = np.geomspace(lowest, limit, 50)
        axes.plot(line, side * side / line, color=INK, linewidth=0.7, linestyle=(0, (4, 3)))
        if lowest < side < limit:  # where the line enters from the left
            start = max(lowest, side * side / limit)
            axes.annotate(text, (start, side * side / start), xytext=(14, -2), fontsize=7.5,
                          textcoords='offset points', va='top')
    axes.set_xscale('log')
    axes.set_yscale('log')
    axes.set_xlim(lowest, limit)
    axes.set_ylim(lowest, limit)
    plain = ticker.FuncFormatter(lambda value, _: f'{value:g}')
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(ticker.LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(plain)
        axis.set_minor_formatter(ticker.NullFormatter())
    axes.set_xlabel('width [px]')
    axes.set_ylabel('height [px]')
    _legend(axes, markerscale=2)
    return _svg(figure, 'sizes of boxes')


@_styled
def view_angles(azimuth, elevation, name):
    """The directions from which objects of a class are seen."""
    figure, axes = _figure()
    table, x_edges, y_edges = np.histogram2d(azimuth, elevation, bins=(36, 18),
                                             range=((-180, 180), (-90, 90)))
    picture = axes.pcolormesh(x_edges, y_edges, table.T, cmap=HEAT, vmin=0, rasterized=True)
    axes.set_xticks((-180, -90, 0, 90, 180))
    axes.set_xticklabels(('behind', 'right', 'ahead', 'left', 'behind'))
    axes.set_yticks((-90, -45, 0, 45, 90))
    axes.set_yticklabels(('below', '-45°', '0°', '45°', 'above'))
    axes.grid(color='white', linewidth=0.4)
    axes.set_axisbelow(False)
    bar = figure.colorbar(picture, ax=axes, pad=0.02)
    bar.set_label('labels')
    bar.locator = ticker.MaxNLocator(4, integer=True)
    bar.update_ticks()
    bar.outline.set_visible(False)
    return _svg(figure, f'directions from which {name} is seen')
