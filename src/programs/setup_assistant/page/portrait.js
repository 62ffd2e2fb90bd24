// A picture of an object's model that is turned by hand; a click on it picks a keypoint.
import {get, post} from './api.js';
import {h} from './dom.js';
import {rounded} from './fields.js';
import {changed, effective, report, set, store} from './store.js';

const WIDTH = 480;
const portraits = new Map();

function stateOf(name) {
  if (!portraits.has(name)) {
    portraits.set(name, {
      yaw: 0.6,
      pitch: 0.35,
      value: null,
      error: null,
      key: null,
      asked: null,
      isPicking: false,
      last: null,
      moved: 0
    });
  }
  return portraits.get(name);
}

// What the server last said about an object's model.
export function modelOf(name) {
  return stateOf(name).value;
}

export function portrait(name) {
  const state = stateOf(name);
  load(name, state);
  const {value, error, isPicking} = state;
  return h(
      'div', {class: 'portrait', key: `portrait ${name}`},
      h('div', {
        class: isPicking ? 'turntable picking' : 'turntable',
        tabindex: '0',
        role: 'application',
        'aria-label': `Model of ${name}. Drag or arrow keys turn it.${isPicking ? ' A click adds a keypoint.' : ''}`,
        onpointerdown: (event) => grab(event, state),
        onpointermove: (event) => drag(event, name, state),
        onpointerup: (event) => drop(event, name, state),
        onkeydown: (event) => turnByKey(event, state),
      },
        value ? h('img', {src: value.picture, alt: `Model of ${name}`, draggable: 'false'}) : null,
        value ? points(value) : null,
        error || !value ? h('p', {class: 'message'}, error ?? 'Drawing the model\u2026') : null),
      h('label', {class: 'toggle'}, h('input', {
          type: 'checkbox',
          checked: isPicking,
          onchange: (event) => {
            state.isPicking = event.target.checked;
            changed();
          },
        }),
        h('span', {}, 'Pick keypoints')));
}

function points({width = WIDTH, height = 360, keypoints = []}) {
  return h(
      'svg', {class: 'overlay', viewBox: `-0.5 -0.5 ${width} ${height}`, 'aria-hidden': 'true'},
      keypoints.map(
          (point, index) => point &&
              h('g', {class: point[2] ? 'pin' : 'pin unseen'}, h('circle', {cx: point[0], cy: point[1], r: width / 55}),
                h('text', {x: point[0] + width / 60, y: point[1] - width / 80, 'font-size': width / 32}, index))));
}

async function load(name, state) {
  const key = [store.setup?.revision, state.yaw, state.pitch].join(' ');
  if (state.asked || key === state.key) return;
  state.asked = key;
  try {
    const {yaw, pitch} = state;
    state.value = {
      ...await get('api/model', {object: name, yaw: rounded(yaw, 3), pitch: rounded(pitch, 3), width: WIDTH}),
      yaw,
      pitch
    };
    state.error = null;
  } catch (error) {
    state.error = error.message;
  }
  state.key = key;
  state.asked = null;
  changed();
}

function turn(state, right, down) {
  state.yaw = Math.atan2(Math.sin(state.yaw - right), Math.cos(state.yaw - right));
  state.pitch = Math.max(-1.5, Math.min(1.5, state.pitch + down));
  changed();
}

function grab(event, state) {
  event.currentTarget.setPointerCapture(event.pointerId);
  Object.assign(state, {last: [event.clientX, event.clientY], moved: 0});
}

function drag(event, name, state) {
  if (!state.last) return;
  const [right, down] = [event.clientX - state.last[0], event.clientY - state.last[1]];
  state.moved += Math.hypot(right, down);
  // A clicking hand is not quite still.
  if (state.moved < 4) return;
  state.last = [event.clientX, event.clientY];
  turn(state, right * 0.01, down * 0.01);
}

function drop(event, name, state) {
  if (state.last && state.moved < 4 && state.isPicking && state.value) pick(event, name, state);
  state.last = null;
}

async function pick(event, name, state) {
  const box = event.currentTarget.getBoundingClientRect();
  const {width = WIDTH, height = 360, yaw, pitch} = state.value;
  const body = {
    object: name,
    yaw: rounded(yaw, 3),
    pitch: rounded(pitch, 3),
    width,
    x: (event.clientX - box.left) / box.width * width - 0.5,
    y: (event.clientY - box.top) / box.height * height - 0.5,
  };
  try {
    const {link, p} = await post('api/pick', body);
    if (!link || !p) return report(new Error('There is nothing of the model at that point; click on the model.'));
    const path = [name, 'keypoints'];
    const list = effective(path);
    return set(path, [...(Array.isArray(list) ? list : []), p.map((each) => rounded(each, 4))]);
  } catch (error) {
    return report(error);
  }
}

const KEYS = {
  ArrowLeft: [-0.1, 0],
  ArrowRight: [0.1, 0],
  ArrowUp: [0, -0.1],
  ArrowDown: [0, 0.1]
};

function turnByKey(event, state) {
  const direction = KEYS[event.key];
  if (!direction) return;
  event.preventDefault();
  turn(state, ...direction);
}
