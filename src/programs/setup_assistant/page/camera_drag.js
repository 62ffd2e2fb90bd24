// Moves the camera by hand: dragging orbits, dragging with Shift or the right button pans, the wheel zooms; on a touch
// screen two fingers pan and zoom; keys do the same. Coarse pictures follow the hand; the pose at which it lets go is
// written to the settings.
import {cameraPath, formOf, globalPose, orbitOfSettings, poseOfOrbit, wayOf} from './camera_pose.js';
import {endGlances, forgetGlance, glanceFrom} from './glance.js';
import {orbited, panned, zoomed} from './pose_math.js';
import {scene} from './scene_loader.js';
import {changed, effective, objectNames, set, store} from './store.js';
import {view} from './view_state.js';

const RADIANS_A_PICTURE = 2.5;
const WHEEL_PAUSE = 400;  // [ms] without an event, after which a turn of the wheel is over

const hand = {
  orbit: null,
  isMoved: false,
  isPanned: false,
  before: null,
  isOver: false,
  pointers: new Map(),  // the last positions of those that are down
  end: 0
};

export function dragHint() {
  if (view.pane !== 'cameras' || !['pose', 'mounted_on'].includes(wayOf(cameraPath()))) return null;
  return matchMedia('(pointer: coarse)').matches ?
      'One finger: orbit. Two fingers: pan and zoom.' :
      'Drag: orbit. Shift and drag: pan. Wheel: zoom. Arrow keys, + and \u2212 do the same.';
}

function begin() {
  hand.isOver = false;
  if (hand.orbit) return;
  const path = cameraPath();
  hand.before = effective([...path, 'pose']) ?? {};
  hand.orbit = orbitOfSettings(path);
  hand.isMoved = hand.isPanned = false;
}

// Writes the camera's pose. If the user takes hold of it again meanwhile, the movement goes on from there.
async function end() {
  hand.isOver = true;
  if (hand.isMoved) {
    hand.isMoved = false;
    await set([...cameraPath(), 'pose'], poseOfOrbit(hand.orbit, hand.before, hand.isPanned));
  }
  if (!hand.isOver) return;
  hand.orbit = null;
  endGlances();
  if (scene.value?.revision >= store.state.revision) forgetGlance();
  changed();
}

function move(change, isPan = false) {
  begin();
  hand.orbit = change(hand.orbit);
  hand.isMoved = true;
  hand.isPanned ||= isPan;
  const pose = view.layer === 'picture' ? globalPose(cameraPath(), hand.orbit) : null;
  if (pose) glanceFrom(pose);
}

function pan(right, down, width) {
  const {width: pixels = 640, intrinsics: [fx] = [640]} = scene.value?.camera ?? {};
  move((orbit) => {
    const metres = orbit.length * pixels / fx / width;
    return panned(orbit, right * metres, down * metres);
  }, true);
}

function orbit(right, down, width) {
  const angle = RADIANS_A_PICTURE / width;
  move((each) => orbited(each, right * angle, down * angle));
}

// A camera that looks at an object cannot go past it.
function zoom(factor) {
  begin();
  const isHeld = formOf(hand.before) === 'object' && objectNames().includes(String(hand.before.look_at));
  move((each) => zoomed(each, factor, isHeld));
}

function onpointerdown(event) {
  event.currentTarget.setPointerCapture(event.pointerId);
  event.currentTarget.focus();
  begin();
  hand.pointers.set(event.pointerId, [event.clientX, event.clientY]);
  event.preventDefault();
}

function onpointermove(event) {
  const last = hand.pointers.get(event.pointerId);
  if (!last) return;
  const width = event.currentTarget.clientWidth;
  const now = [event.clientX, event.clientY];
  const [right, down] = [now[0] - last[0], now[1] - last[1]];
  if (!right && !down) return;
  hand.pointers.set(event.pointerId, now);
  const others = [...hand.pointers].filter(([id]) => id !== event.pointerId);
  if (others.length) {
    const [, still] = others[0];
    const apart = (point) => Math.max(Math.hypot(point[0] - still[0], point[1] - still[1]), 1);
    pan(right / 2, down / 2, width);  // by the movement of the fingers' middle
    zoom(apart(last) / apart(now));
  } else if (event.shiftKey || event.buttons & 6) {
    pan(right, down, width);
  } else {
    orbit(right, down, width);
  }
}

function onpointerup(event) {
  hand.pointers.delete(event.pointerId);
  if (!hand.pointers.size) end();
}

// A turn of the wheel is many events, but one undo step.
function endSoon() {
  clearTimeout(hand.end);
  hand.end = setTimeout(() => {
    if (!hand.pointers.size) end();
  }, WHEEL_PAUSE);
}

function onwheel(event) {
  event.preventDefault();
  if (!event.deltaY) return;
  zoom(Math.exp(Math.sign(event.deltaY) * 0.08));
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
  const factor = {'+': 1 / 1.08, '=': 1 / 1.08, '-': 1.08}[event.key];
  const direction = KEYS[event.key];
  if (!factor && !direction) return;
  event.preventDefault();
  if (factor)
    zoom(factor);
  else if (event.shiftKey)
    move((each) => panned(each, direction[0] * each.length * 0.03, direction[1] * each.length * 0.03), true);
  else
    move((each) => orbited(each, direction[0] * 0.05, direction[1] * 0.05));
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
