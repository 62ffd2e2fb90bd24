// The world from above: x to the right, y up; paths of objects, the camera and what it sees, boxes.
import {h} from './dom.js';
import {colourOf} from './overlay.js';
import {bodyOfOptical, matrixOfQuaternion} from './pose_math.js';
import {scene} from './scene_loader.js';

// `ways`: {name: [[x, y], ...]}; `boxes`: [{low, high, label}].
export function map({picture, extent, ways = {}, boxes = [], label}) {
  const view = viewOf(label, extent, Object.values(ways).flat(), boxes);
  if (!view) return h('p', {class: 'empty'}, 'Nothing to draw yet.');
  const [x0, y0, x1, y1] = view;
  const size = Math.max(x1 - x0, y1 - y0);
  return h(
      'figure', {class: 'map'},
      h('svg', {
        viewBox: `${x0} ${- y1} ${x1 - x0} ${y1 - y0}`,
        role: 'img',
        'aria-label': label,
        style: {'--unit': `${size / 400}px`, '--ratio': (x1 - x0) / (y1 - y0)}
      },
        picture && extent ? h('image', {
          href: picture,
          x: extent[0],
          y: -extent[3],
          width: extent[2] - extent[0],
          height: extent[3] - extent[1],
          preserveAspectRatio: 'none',
        }) :
                            null,
        h('g', {}, boxes.map((box) => h('rect', {
                               class: 'volume',
                               x: box.low[0],
                               y: -box.high[1],
                               width: Math.max(box.high[0] - box.low[0], 0),
                               height: Math.max(box.high[1] - box.low[1], 0),
                             }))),
        h('g', {}, Object.entries(ways).map(([name, points], index) => way(name, points, index, size))),
        cameraWedge(size)),
      h('figcaption', {},
        h('span', {class: 'legend'},
          Object.keys(ways).map(
              (name, index) => h('span', {}, h('i', {class: 'swatch', style: {'--label': colourOf(index)}}), name))),
        h('span', {class: 'scale'}, `${(x1 - x0).toFixed(1)} \u00d7 ${(y1 - y0).toFixed(1)} m`)));
}

const LEAST = 4;  // [m], the smallest extent of a map
const MARGIN = 0.15;

const MUCH_LARGER = 3;

const kept = new Map();  // the areas that maps show, by their labels

// The area in which something happens, with a margin; if nothing does, all of the picture. The area that was shown
// before stays while it still fits, so that the map stands still while the camera moves.
function viewOf(label, extent, points, boxes) {
  const happens = [...points, ...boxes.flatMap((each) => [each.low, each.high])];
  if (!happens.length && extent) return extent;
  const all = [...happens, ...cameraPoints()];
  if (!all.length) return null;
  const wanted = within(all);
  const wide = withMargin(wanted);
  const before = kept.get(label);
  if (before && holds(before, wanted) && longSide(before) < MUCH_LARGER * longSide(wide)) return before;
  kept.set(label, wide);
  return wide;
}

function cameraPoints() {
  const pose = scene.value?.camera?.pose;
  return pose ? [pose.slice(0, 2)] : [];
}

function within(points) {
  const [xs, ys] = [points.map((each) => each[0]), points.map((each) => each[1])];
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

function longSide([x0, y0, x1, y1]) {
  return Math.max(x1 - x0, y1 - y0);
}

function holds([x0, y0, x1, y1], [low_x, low_y, high_x, high_y]) {
  return x0 <= low_x && y0 <= low_y && high_x <= x1 && high_y <= y1;
}

function withMargin([x0, y0, x1, y1]) {
  const margin = MARGIN * Math.max(longSide([x0, y0, x1, y1]), LEAST);
  const around = (low, high) => {
    const more = Math.max(margin, (LEAST - (high - low)) / 2);
    return [low - more, high + more];
  };
  const [left, right] = around(x0, x1);
  const [bottom, top] = around(y0, y1);
  return [left, bottom, right, top];
}

function way(name, points, index, size) {
  if (!points.length) return null;
  const text = points.map(([x, y]) => `${x},${- y}`).join(' ');
  const [x, y] = points[0];
  return h(
      'g', {class: 'way', style: {'--label': colourOf(index)}}, h('polyline', {points: text}),
      h('circle', {cx: x, cy: -y, r: size / 90}));
}

function cameraWedge(size) {
  const {pose, width, intrinsics} = scene.value?.camera ?? {};
  const fx = intrinsics?.[0];
  if (!pose) return null;
  const body = bodyOfOptical(matrixOfQuaternion(pose.slice(3)));
  const yaw = Math.atan2(body[1][0], body[0][0]);
  const half = fx > 0 ? Math.min(Math.atan(width / 2 / fx), 1.5) : 0.5;
  const length = size / 7;
  const corner = (angle) => `${pose[0] + length * Math.cos(angle)},${- (pose[1] + length * Math.sin(angle))}`;
  return h(
      'g', {class: 'camera-mark'},
      h('polygon', {points: `${pose[0]},${- pose[1]} ${corner(yaw + half)} ${corner(yaw - half)}`}),
      h('circle', {cx: pose[0], cy: -pose[1], r: size / 90}));
}
