// Moves the camera by hand: drag orbits, with Shift or the right button pans, the wheel zooms; keys do the same.
import {cameraPath, orbitOfSettings, poseOfOrbit, wayOf} from './camera_pose.js';
import {orbited, panned, zoomed} from './pose_math.js';
import {scene} from './scene_loader.js';
import {changed, effective, set} from './store.js';
import {view} from './view_state.js';

const RADIANS_A_PICTURE = 2.5;

const hand = {
  orbit: null,
  isPanned: false,
  before: null,
  count: 0,
  isSending: false,
  isWaiting: false,
  last: null,
  end: 0
};

export function dragHint() {
  if (view.pane !== 'cameras' || !['pose', 'mounted_on'].includes(wayOf(cameraPath()))) return null;
  return 'Drag: orbit. Shift and drag: pan. Wheel: zoom. Arrow keys, + and \u2212 do the same.';
}

function begin() {
  if (hand.orbit) return;
  const path = cameraPath();
  hand.before = effective([...path, 'pose']) ?? {};
  hand.orbit = orbitOfSettings(path);
  hand.isPanned = false;
  ++hand.count;
}

function end() {
  hand.orbit = null;
  changed();
}

// As fast as the server takes them; the last one always.
async function send() {
  if (hand.isSending) {
    hand.isWaiting = true;
    return;
  }
  hand.isSending = true;
  do {
    hand.isWaiting = false;
    const path = [...cameraPath(), 'pose'];
    await set(path, poseOfOrbit(hand.orbit, hand.before, hand.isPanned), `camera-${hand.count}`);
  } while (hand.isWaiting && hand.orbit);
  hand.isSending = false;
}

function move(change, isPan = false) {
  begin();
  hand.orbit = change(hand.orbit);
  hand.isPanned ||= isPan;
  send();
}

function onpointerdown(event) {
  event.currentTarget.setPointerCapture(event.pointerId);
  event.currentTarget.focus();
  begin();
  hand.last = [event.clientX, event.clientY];
  event.preventDefault();
}

function onpointermove(event) {
  if (!hand.last) return;
  const width = event.currentTarget.clientWidth;
  const [right, down] = [event.clientX - hand.last[0], event.clientY - hand.last[1]];
  if (!right && !down) return;
  hand.last = [event.clientX, event.clientY];
  if (event.shiftKey || event.buttons & 6) {
    const {width: pixels = 640, intrinsics: [fx] = [640]} = scene.value?.camera ?? {};
    move((orbit) => {
      const metres = orbit.length * pixels / fx / width;
      return panned(orbit, right * metres, down * metres);
    }, true);
  } else {
    const angle = RADIANS_A_PICTURE / width;
    move((orbit) => orbited(orbit, right * angle, down * angle));
  }
}

function onpointerup() {
  hand.last = null;
  end();
}

// A turn of the wheel is many events, and one step of undo.
function endSoon() {
  clearTimeout(hand.end);
  hand.end = setTimeout(() => {
    if (!hand.last) end();
  }, 400);
}

function onwheel(event) {
  event.preventDefault();
  move((orbit) => zoomed(orbit, Math.exp(Math.sign(event.deltaY) * 0.08)));
  endSoon();
}

const KEYS = {
  ArrowLeft: [1, 0],
  ArrowRight: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1]
};

function onkeydown(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const zoom = {'+': 1 / 1.08, '=': 1 / 1.08, '-': 1.08}[event.key];
  const direction = KEYS[event.key];
  if (!zoom && !direction) return;
  event.preventDefault();
  if (zoom)
    move((orbit) => zoomed(orbit, zoom));
  else if (event.shiftKey)
    move((orbit) => panned(orbit, direction[0] * orbit.length * 0.03, direction[1] * orbit.length * 0.03), true);
  else
    move((orbit) => orbited(orbit, direction[0] * 0.05, direction[1] * 0.05));
  endSoon();
}

export const cameraDrag = {
  onpointerdown,
  onpointermove,
  onpointerup,
  onpointercancel: onpointerup,
  onwheel,
  onkeydown,
  oncontextmenu: (event) => event.preventDefault(),
};
