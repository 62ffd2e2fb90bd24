// Coarse pictures while the camera is moved by hand. There is one request at a time: after each answer, a picture from
// the camera's current pose is requested, so that the picture follows the hand as fast as the server draws.
import {getPicture} from './api.js';
import {changed} from './store.js';
import {currentCamera, currentInstant} from './view_state.js';

export const glance = {
  bitmap: null,  // from where the camera is being held; null while it stands
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
      // The request for the full picture, once the camera stands, shows what is wrong.
    }
  }
  hand.isAsking = false;
}

// To be called when the camera stands. The last glance stays until the full picture is there: forgetGlance().
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
