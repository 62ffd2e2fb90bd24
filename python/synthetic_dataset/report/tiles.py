"""Pictures of scenes with their labels for the page: an image, and the overlay on it."""
import numpy as np
from PIL import Image

from synthetic_dataset import pages
from synthetic_dataset.manifest import DatasetError
from synthetic_dataset.report import charts

WIDTH = 560  # of a picture in the page [px]
INSIDE, OUTLINE = 70, 230  # how opaque masks are, of 255


def tile(dataset, measures, row, reason=''):
    """The values of a scene for the template.

    @param row  of the scene in `measures`
    """
    scene = dataset.scene(measures.scene_index[row])
    labels = [_label(measures, scene, each) for each in np.flatnonzero(measures.scene == row)]
    for label in labels:
        label['points'] = _points(scene, label.pop('object'))
    found = {'index': scene.index, 'reason': reason, 'split': scene.split,
             'camera': scene.camera if len(dataset.cameras) > 1 else '', 'width': scene.width,
             'height': scene.height, 'labels': labels, 'image': '', 'masks': '', 'problem': ''}
    try:
        with Image.open(scene.image_file) as picture:
            found['image'] = _jpeg(picture)
        found['masks'] = _masks(scene, measures, row)
    except (DatasetError, OSError) as error:
        found['problem'] = str(error)
    return found


def _label(measures, scene, label):
    left, top, right, bottom = measures.box[label]
    facts = [measures.object_names[measures.object[label]]]
    if measures.visibility is not None:
        facts.append(f'{100 * measures.visibility[label]:.0f} % visible')
    if measures.visible_pixels is not None:
        facts.append(f'{measures.visible_pixels[label]:,.0f} px')
    facts.append(f'{measures.distance[label]:.3g} m away')
    # Keeps the name inside the image: above the box, or in it if there is no room.
    size = scene.width / 36
    above = top > 1.2 * size
    at_right = left > 0.85 * scene.width
    return {'object': measures.object[label], 'x': left, 'y': top, 'width': right - left, 'height': bottom - top,
            'name': charts.short(measures.class_names[measures.label_class[label]]),
            'colour': charts.colours_of(measures)[measures.label_class[label]],
            'facts': ', '.join(facts),
            'text_size': size, 'text_x': right if at_right else left,
            'anchor': 'end' if at_right else 'start', 'text_y': top - 0.3 * size if above
            else min(bottom, scene.height - 0.3 * size) - 0.3 * size}


def _points(scene, index):
    """Keypoints in the image, and whether each is visible; empty for old datasets."""
    if scene.shapes is None:
        return []
    shape = scene.shapes[index]
    return [(u, v, state == 'visible')
            for (u, v), state in zip(shape.keypoints, shape.keypoint_states)
            if 0 <= u < scene.width and 0 <= v < scene.height and state != 'outside']


def _jpeg(picture):
    picture = picture.convert('RGB')
    picture.thumbnail((WIDTH, WIDTH), Image.BICUBIC)
    return pages.embedded(picture)


def _masks(scene, measures, row):
    """The visible masks in the colours of their classes; empty if the dataset has no masks."""
    try:
        instances = scene.instances
    except DatasetError:
        return ''
    share = min(1.0, WIDTH / max(instances.shape))
    width, height = (max(1, int(round(side * share))) for side in (scene.width, scene.height))
    rows, columns = (np.arange(count) * side // count
                     for count, side in ((height, scene.height), (width, scene.width)))
    instances = instances[np.ix_(rows, columns)]
    pixels = np.zeros((height, width, 4), np.uint8)
    for label in np.flatnonzero(measures.scene == row):
        mask = instances == measures.object[label] + 1
        inside = mask.copy()
        for axis in (0, 1):
            for step in (-1, 1):
                inside &= np.roll(mask, step, axis)
        colour = charts.colours_of(measures)[measures.label_class[label]]
        pixels[mask, :3] = [int(colour[at:at + 2], 16) for at in (1, 3, 5)]
        pixels[mask, 3] = np.where(inside[mask], INSIDE, OUTLINE)
    return pages.embedded(Image.fromarray(pixels, 'RGBA').quantize(255, method=Image.FASTOCTREE), 'png')
