// Coarse pictures while the camera is moved by hand. One request at a time: where the camera is when it is answered is
// asked for next, so that the picture follows the hand as fast as the server draws.
import {getPicture} from './api.js';
import {changed} from './store.js';
import {currentCamera, currentInstant} from './view_state.js';

export const glance = {
  bitmap: null,  // from where the camera is held; null while it stands
  count: 0
};

const hand = {
  isMoving: false,
  isAsking: false,
  pose: null
};

// `pose`: of the optical frame in the global one, [x, y, z, qx, qy, qz, qw].
export async function glanceFrom(pose) {
  Object.assign(hand, {isMoving: true, pose});
  if (hand.isAsking) return;
  hand.isAsking = true;
  while (hand.pose) {
    const [x, y, z, qx, qy, qz, qw] = hand.pose;
    hand.pose = null;
    try {
      const query = {instant: currentInstant(), camera: currentCamera(), x, y, z, qx, qy, qz, qw};
      const bitmap = await createImageBitmap(await getPicture('api/glance', query));
      if (hand.isMoving) take(bitmap);
    } catch {
      // The whole picture, once the camera stands, says what is wrong.
    }
  }
  hand.isAsking = false;
}

// The camera stands. The last glance stays until the whole picture is there: forgetGlance().
export function endGlances() {
  Object.assign(hand, {isMoving: false, pose: null});
}

export function forgetGlance() {
  if (!hand.isMoving && glance.bitmap) take(null);
}

function take(bitmap) {
  glance.bitmap?.close();
  glance.bitmap = bitmap;
  ++glance.count;
  changed();
}
