"""Assembles the page about a dataset."""
import json
import pathlib

import numpy as np

from synthetic_dataset import pages
from synthetic_dataset.manifest import DatasetError
from synthetic_dataset.report import charts, tiles
from synthetic_dataset.report.brightness import Brightness
from synthetic_dataset.report.choice import choose
from synthetic_dataset.report.clouds import Clouds
from synthetic_dataset.report.draws import drawn_values
from synthetic_dataset.report.findings import findings
from synthetic_dataset.report.measures import Measures
from synthetic_dataset.report.neighbours import Neighbours
from synthetic_dataset.report.stages import stages_in
from synthetic_dataset.report.variety import Variety

MOST_CAMERAS, MOST_ANGLES, SHOWN_PAIRS = 4, 6, 3  # cameras and classes with a chart, pairs shown


def size_text(count):
    """A number of bytes in readable form."""
    for unit in ('B', 'kB', 'MB', 'GB', 'TB'):
        if count < 1000 or unit == 'TB':
            return f'{count:.3g} {unit}' if count < 1000 else f'{count:,.0f} {unit}'
        count /= 1000
    return ''


def page_of(dataset, log=None):
    """The page as HTML, including its pictures, charts and style.

    @param log  a file with the output of the run
    """
    if len(dataset) == 0:
        raise DatasetError(f"'{dataset.folder}': the dataset has no scenes")
    measures = Measures(dataset)
    brightness = Brightness(dataset, measures)
    neighbours = Neighbours(measures)
    variety = Variety(dataset, brightness)
    splits = dataset.splits
    counts = measures.counts(splits)
    return pages.rendered(
        pathlib.Path(__file__).parent,
        name=dataset.folder.name, is_complete=dataset.is_complete,
        facts=_facts(dataset, measures),
        findings=findings(dataset, measures, splits, counts, brightness, neighbours, variety),
        variety=variety, warnings=_warnings(dataset),
        tiles=[tiles.tile(dataset, measures, each.row, each.reason)
               for each in choose(measures, brightness)],
        classes=_classes(measures, counts), splits=_splits(measures, splits),
        charts=_charts(measures, splits, counts), angles=_angles(measures),
        brightness=_brightness(brightness, len(dataset)), clouds=Clouds(dataset, measures),
        neighbours=_pairs(dataset, measures, neighbours),
        draws=drawn_values(dataset), stages=stages_in(log) if log else [], **_tables(dataset))


def write(dataset, file, log=None):
    """Writes the page. The file appears only when complete; it must not be one of the dataset's.

    @throws DatasetError if it cannot be written
    """
    file = pathlib.Path(file)
    target = file.resolve()
    for path, in dataset.manifest.rows('SELECT path FROM file'):
        if (dataset.folder / path).name == target.name and (dataset.folder / path) == target:
            raise DatasetError(f"'{file}': is a file of the dataset; choose another name")
    pages.write(page_of(dataset, log), file)


def _facts(dataset, measures):
    size, files = dataset.manifest.rows(
        'SELECT coalesce(sum(CASE WHEN linked_to IS NULL THEN bytes END), 0), count(*) FROM file')[0]
    times = len(set(dataset.manifest.columns('scene')['instant']))
    facts = [(f'{len(dataset):,}', 'images'), (f'{measures.count:,}', 'labels'),
             (f'{len(measures.class_names):,}', 'classes'),
             (f'{len(dataset.objects):,}', 'objects')]
    if len(dataset.cameras) > 1:
        facts += [(f'{len(dataset.cameras):,}', 'cameras'), (f'{times:,}', 'instants')]
    return facts + [(f'{len(dataset.writers):,}', 'formats'), (f'{files:,}', 'files'),
                    (size_text(size), 'on disk')]


def _warnings(dataset):
    """The run's warnings, the most frequent first, each with one of its details."""
    return dataset.manifest.rows(
        'SELECT kind, sum(count), max(detail), min(CASE WHEN scene >= 0 THEN scene END) '
        'FROM warning GROUP BY kind ORDER BY sum(count) DESC, kind')


def _classes(measures, counts):
    total = max(1, int(counts.sum()))
    images = [len(set(measures.scene[measures.label_class == each]))
              for each in range(len(measures.class_names))]
    colours = charts.colours_of(measures)
    return [{'name': name, 'colour': colours[row], 'labels': [int(n) for n in counts[row]],
             'total': int(counts[row].sum()), 'share': 100 * counts[row].sum() / total,
             'images': images[row]} for row, name in enumerate(measures.class_names)]


def _splits(measures, splits):
    return [{'name': split or 'all',
             'images': int(np.count_nonzero(measures.scene_split == split))} for split in splits]


def _charts(measures, splits, counts):
    if measures.count == 0:
        return []
    areas = np.sqrt(np.maximum(measures.box_size.prod(axis=1), 1.0))
    few = len(measures.class_names) <= charts.MOST_BARS
    found = [('Labels by class', charts.class_counts(measures, splits, counts),
              '' if few else f'The {charts.MOST_BARS} classes with most labels.'),
             ('Labels in an image', charts.plain_histogram(
                 measures.labels_by_scene(), 'labels', 'images',
                 np.arange(measures.labels_by_scene().max() + 2) - 0.5, 'labels in an image'), ''),
             ('Sizes of boxes', charts.box_sizes(measures),
              "The lines are COCO's limits of small, medium and large.")]
    for camera in list(dict.fromkeys(measures.scene_camera))[:MOST_CAMERAS]:
        of_camera = measures.scene_camera[measures.scene] == camera
        sizes = measures.scene_size[measures.scene_camera == camera]
        name = f', {camera}' if len(set(measures.scene_camera)) > 1 else ''
        found.append((f'Positions in the image{name}',
                      charts.positions(measures.box[of_camera], sizes[0], camera), ''))
    if measures.visible_pixels is not None:
        found.append(('Pixels of an object', charts.histogram(
            measures, np.maximum(measures.visible_pixels, 1), 'visible pixels',
            np.geomspace(1, max(10.0, measures.visible_pixels.max() * 1.01), 40), log=True), ''))
    found.append(('Size of a box', charts.histogram(
        measures, areas, 'square root of the area [px]',
        np.linspace(0, areas.max() * 1.001, 41), marks=((32, '32'), (96, '96'))), ''))
    found += _share_chart(measures, measures.visibility, 'Visibility', 1.0, 'wholly visible',
                          'visible share of the silhouette [%]')
    found += _share_chart(measures, measures.truncation, 'Truncation', 0.0, 'wholly in the image',
                          "share past the image's edge [%]")
    found.append(('Distance', charts.histogram(
        measures, measures.distance, 'distance from the camera [m]',
        np.linspace(0, measures.distance.max() * 1.001, 41)), ''))
    if len(measures.alignment):
        found.append(('Alignment with recorded pictures', charts.plain_histogram(
            100 * measures.alignment, 'alignment [%]', 'images', np.linspace(0, 100, 41)),
            'How well the outlines of labels meet the edges of the pictures.'))
    if len(measures.unmeasured):
        found.append(('What may hide objects in recorded pictures', charts.plain_histogram(
            100 * measures.unmeasured, "share of the objects' pixels at which nothing was measured "
            '[%]', 'images', np.linspace(0, 100, 41)), _cover_note(measures)))
    return [{'title': title, 'svg': svg, 'note': note} for title, svg, note in found]


def _cover_note(measures):
    if (measures.unmeasured == 1.0).all():
        return ('Nothing was measured with the pictures: all pixels of objects are labelled as if '
                'nothing stood in front of them that the world does not have.')
    return (f'Something that the world does not have hides {100 * measures.covered.mean():.3g} % of '
            f"the objects' pixels; nothing was measured at {100 * measures.unmeasured.mean():.3g} %, "
            'which are labelled as if nothing hid them (mean of the images).')


def _share_chart(measures, shares, title, usual, usual_text, label):
    """A chart without the value that most labels have, which would dwarf all the others."""
    if shares is None:
        return []
    bins = np.linspace(0, 100, 41)
    other = shares != usual
    note = f'{100 * np.count_nonzero(~other) / measures.count:.3g} % of the labels are {usual_text}'
    if not other.any():
        return [(title, '', note + '.')]
    return [(title, charts.histogram(measures, 100 * shares, label, bins, of_labels=other),
             note + ' and not in the chart.')]


def _angles(measures):
    found = []
    for each in sorted(charts.by_frequency(measures)[:MOST_ANGLES]):
        of_class = measures.label_class == each
        if of_class.any():
            name = measures.class_names[each]
            found.append({'title': name, 'note': '', 'svg': charts.view_angles(
                measures.azimuth[of_class], measures.elevation[of_class], name)})
    return found


def _brightness(brightness, scene_count):
    values = brightness.values[~np.isnan(brightness.values)]
    read = len(values)
    return {'title': 'Brightness of images', 'note': '' if read == scene_count else
            f'{read:,} of {scene_count:,} images were read, spread over all.',
            'svg': charts.plain_histogram(values, 'mean brightness, 0 to 255', 'images',
                                          np.linspace(0, 255, 41), 'brightness of images')}


def _pairs(dataset, measures, neighbours):
    return {'by_split': neighbours.by_split, 'has_splits': len(neighbours.by_split) > 1,
            'pairs': [(tiles.tile(dataset, measures, first), tiles.tile(dataset, measures, second))
                      for _, first, second in neighbours.pairs[:SHOWN_PAIRS]]}


def _tables(dataset):
    """The manifest's tables on how the dataset was made."""
    rows = dataset.manifest.rows
    credits = {}
    if 'credit' in dataset.manifest.tables():  # manifests of older versions have none
        credits = {path: (author, license_text) for path, author, license_text in rows(
            'SELECT path, author, license FROM credit')}
    return {
        'settings': [(name, _setting_text(value), is_default) for name, value, is_default in rows(
            'SELECT name, value, is_default FROM setting ORDER BY is_default, name')],
        'software': rows('SELECT name, version FROM software ORDER BY name'),
        'inputs': [(path, size_text(size), digest[:12], *credits.get(path, ('', '')))
                   for path, size, digest in rows(
                       'SELECT path, bytes, digest FROM input ORDER BY path')],
        'credits': _credits(dataset),
        'writers': [(name, kind, folder, files) for name, kind, folder, files in rows(
            'SELECT name, type, output_folder, (SELECT count(*) FROM file WHERE '
            'file.writer = writer."index") FROM writer ORDER BY "index"')],
        'motions': rows('SELECT name, first_instant, instant_count FROM motion ORDER BY "index"'),
        'digest': dataset.manifest.run.get('settings_digest', ''),
    }


def _credits(dataset):
    """The authors of the input files: a row for each author and licence."""
    if 'credit' not in dataset.manifest.tables():
        return []
    return dataset.manifest.rows(
        'SELECT author, license, max(author_in, license_in), count(*), min(input.path) '
        "FROM input LEFT JOIN credit ON credit.path = input.path GROUP BY coalesce(author, ''), "
        "coalesce(license, '') ORDER BY count(*) DESC, 1, 2")


def _setting_text(value):
    text = json.loads(value)
    return text if isinstance(text, str) else value
