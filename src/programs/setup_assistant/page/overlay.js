// Labels over the picture, in its pixels: the centre of the first pixel is (0, 0).
import {h} from './dom.js';

// Corner i of a cuboid has the high x if i & 4, the high y if i & 2, the high z if i & 1.
const EDGES = [0, 1, 2, 3, 4, 5, 6, 7].flatMap(
    (from) => [1, 2, 4].filter((bit) => !(from & bit)).map((bit) => [from, from | bit]));

const COLOURS = ['#e69f00', '#56b4e9', '#2fbf8f', '#f0e442', '#e8743b', '#cc79a7', '#8c7ae6', '#a3d977'];

export function colourOf(index) {
  return COLOURS[index % COLOURS.length];
}

export function overlay(scene, shown) {
  const {width, height} = scene.camera;
  const objects = scene.labels?.objects ?? [];
  return h(
      'svg', {
        class: 'overlay',
        viewBox: `-0.5 -0.5 ${width} ${height}`,
        'aria-hidden': 'true',
        preserveAspectRatio: 'xMidYMid meet',
      },
      objects.map(
          (object, index) =>
              h('g', {
                key: object.name,
                class: 'labels',
                style: {'--label': colourOf(object.index ?? index)},
              },
                labelsOf(object, shown, width / 640))));
}

function labelsOf(object, shown, scale) {
  const {box} = object;
  return [
    shown.masks &&
        h('path', {class: 'mask', 'fill-rule': 'evenodd', d: (object.polygons ?? []).map(ringText).join(' ')}),
    shown.boxes && box &&
        h('rect', {class: 'box', x: box[0], y: box[1], width: Math.max(box[2], 0), height: Math.max(box[3], 0)}),
    shown.cuboids && isCuboid(object.cuboid) && h('g', {}, EDGES.map(([from, to]) => h('line', {
                                                                       class: 'edge',
                                                                       x1: object.cuboid[from][0],
                                                                       y1: object.cuboid[from][1],
                                                                       x2: object.cuboid[to][0],
                                                                       y2: object.cuboid[to][1],
                                                                     }))),
    shown.keypoints &&
        h('g', {}, (object.keypoints ?? []).map((point) => point && h('circle', {
                                                             class: point[2] ? 'keypoint' : 'keypoint unseen',
                                                             cx: point[0],
                                                             cy: point[1],
                                                             r: 3.2 * scale,
                                                           }))),
    shown.names && box &&
        h('text', {x: box[0], y: Math.max(box[1] - 5 * scale, 12 * scale), 'font-size': 13 * scale}, object.name),
  ];
}

function isCuboid(corners) {
  return Array.isArray(corners) && corners.length === 8 && corners.every(Boolean);
}

function ringText(points) {
  return `M${points.map(([x, y]) => `${x},${y}`).join('L')}Z`;
}
