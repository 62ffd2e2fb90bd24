// What this page shows, which is not part of any file: the pane, the instant, the camera, the labels.
import {recording} from './recording.js';
import {changed, store} from './store.js';

export const view = {
  pane: 'recording',
  instant: 0,
  camera: null,
  object: null,
  shown: {boxes: true, masks: false, keypoints: true, cuboids: false, names: true},
  layer: 'picture',  // or depth, instances
  angles: 'rad',     // or deg: the unit in which angles without deg() are shown
  isYamlOpen: true,
};

export function show(changes) {
  Object.assign(view, changes);
  changed();
}

export function cameraNames() {
  const names = store.setup?.cameras ?? [];
  return names.length ? names : ['camera'];
}

export function currentCamera() {
  return cameraNames().includes(view.camera) ? view.camera : cameraNames()[0];
}

export function instantCount() {
  return store.setup?.instants ?? 0;
}

export function currentInstant() {
  return Math.max(0, Math.min(view.instant, instantCount() - 1));
}

// The time of an instant since the recording's start; undefined with placement, and until it is known.
export function secondsOf(instant) {
  const start = recording()?.start;
  const stamp = store.setup?.stamps?.[instant];
  return start === undefined || stamp === undefined ? undefined : stamp - start;
}
