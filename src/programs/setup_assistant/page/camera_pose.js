// The camera's pose in the settings: which form it has, and how an orbit is written back in that form.
import {convertedAngles, inDegrees, radiansOf} from './angles.js';
import {rounded} from './fields.js';
import {add, bodyOfOptical, distance, forward, inFrame, matrixOfQuaternion, matrixOfRpy, opticalOfBody, orbitOf, positionOf, quaternionOfMatrix, rpyOfMatrix,} from './pose_math.js';
import {scene} from './scene_loader.js';
import {effective, objectNames} from './store.js';
import {currentCamera} from './view_state.js';

export function cameraPath(name = currentCamera()) {
  return effective(['cameras']) === undefined ? ['camera'] : ['cameras', name];
}

// In the order of docs/cameras.md: the first that is given counts.
export function wayOf(path) {
  const has = (key) => effective([...path, key]) !== undefined;
  if (has('sample')) return 'sample';
  if (has('mounted_on')) return 'mounted_on';
  if (has('pose')) return 'pose';
  return has('sensor') && !frameOf(path) ? 'sensor' : 'frame';
}

export function framePath(path) {
  return path[0] === 'camera' && effective([...path, 'frame_id']) === undefined ? ['camera_frame_id'] :
                                                                                  [...path, 'frame_id'];
}

function frameOf(path) {
  return effective([...path, 'frame_id']) ?? (path[0] === 'camera' ? effective(['camera_frame_id']) : undefined);
}

export function formOf(pose) {
  if (Array.isArray(pose)) return 'optical';
  if (pose?.look_at !== undefined) return Array.isArray(pose.look_at) ? 'point' : 'object';
  return 'rpy';
}

function numberOf(value) {
  const number = radiansOf(value) ?? Number(value);
  return Number.isFinite(number) ? number : 0;
}

const numbers = (list, count) => Array.from({length: count}, (unused, index) => numberOf(list?.[index]));

// The pose of the picture that is shown, in the frame in which the settings give it, as position and rpy.
export function shownPose(path) {
  return poseOn(path, wayOf(path) === 'mounted_on' ? String(effective([...path, 'mounted_on'])) : null);
}

// The same in the global frame, or in that of an object (`carrier`); null if it is not known.
export function poseOn(path, carrier = null) {
  const {camera} = scene.value ?? {};
  if (!camera?.pose || (path[0] === 'cameras' && camera.name !== path[1])) return null;
  const body = bodyOfOptical(matrixOfQuaternion(camera.pose.slice(3)));
  const position = camera.pose.slice(0, 3);
  if (carrier === null) return {position, rpy: rpyOfMatrix(body)};
  const parent = poseOfObject(carrier);
  if (!parent) return null;
  const rows = matrixOfQuaternion(parent.slice(3));
  const turned =
      [0, 1, 2].map((row) => [0, 1, 2].map((at) => rows.reduce((sum, each, k) => sum + each[row] * body[k][at], 0)));
  return {position: inFrame(parent, position), rpy: rpyOfMatrix(turned)};
}

// An object's pose in the scene that is shown.
function poseOfObject(name) {
  return scene.value?.labels?.objects?.find((each) => each.name === name)?.pose ?? null;
}

// A pose as it is written; angles are in the unit of the pose that was there before.
export function roundedPose({position, rpy}, before = undefined) {
  const angles = rpy.map((each) => rounded(each, 4));
  return {
    position: position.map((each) => rounded(each, 3)),
    rpy: inDegrees(before?.rpy) ? convertedAngles(rpy, true) : angles
  };
}

// The orbit on which the camera is dragged: around what it looks at, else around what is in the picture's middle.
export function orbitOfSettings(path) {
  const pose = effective([...path, 'pose']);
  const form = formOf(pose);
  const seen = shownPose(path);
  if (form === 'optical' && Array.isArray(pose)) {
    const body = bodyOfOptical(matrixOfQuaternion(numbers(pose.slice(3), 4)));
    const position = numbers(pose, 3);
    const rpy = rpyOfMatrix(body);
    return orbitOf(position, rpy, lengthAhead(path, position, rpy));
  }
  const position = pose?.position ? numbers(pose.position, 3) : seen?.position ?? [0, 0, 0];
  const rpy = pose?.rpy ? numbers(pose.rpy, 3) : seen?.rpy ?? [0, 0, 0];
  if (form === 'rpy') return orbitOf(position, rpy, lengthAhead(path, position, rpy));
  if (form === 'point') return lookingFrom(position, numbers(pose.look_at, 3));
  return orbitOf(position, rpy, distanceTo(pose.look_at) ?? lengthAhead(path, position, rpy));
}

function lookingFrom(position, point) {
  const ahead = add(point, position, -1);
  const rpy = [0, Math.atan2(-ahead[2], Math.hypot(ahead[0], ahead[1])), Math.atan2(ahead[1], ahead[0])];
  return {centre: point, rpy, length: Math.max(distance(point, position), 0.05)};
}

function distanceTo(name) {
  return scene.value?.labels?.objects?.find((each) => each.name === name)?.distance;
}

// The pose of an orbit's optical frame in the global frame; null if that of the object that carries the camera is not
// known.
export function globalPose(path, orbit) {
  let body = matrixOfRpy(orbit.rpy);
  let position = positionOf(orbit);
  if (wayOf(path) === 'mounted_on') {
    const carrier = poseOfObject(String(effective([...path, 'mounted_on'])));
    if (!carrier) return null;
    const rows = matrixOfQuaternion(carrier.slice(3));
    const turned = (vector) => rows.map((row) => row.reduce((sum, each, k) => sum + each * vector[k], 0));
    const columns = [0, 1, 2].map((index) => turned(body.map((row) => row[index])));
    body = [0, 1, 2].map((row) => columns.map((each) => each[row]));
    position = add(turned(position), carrier.slice(0, 3));
  }
  return [...position, ...quaternionOfMatrix(opticalOfBody(body))];
}

// The distance to the object in the picture's middle.
function lengthAhead(path, position, rpy) {
  const {camera, labels} = scene.value ?? {};
  const [u, v] = [(camera?.width - 1) / 2, (camera?.height - 1) / 2];
  const inMiddle =
      (labels?.objects ??
       []).filter(({box}) => box && box[0] <= u && u <= box[0] + box[2] && box[1] <= v && v <= box[1] + box[3]);
  if (inMiddle.length) return Math.min(...inMiddle.map((each) => each.distance));
  // Else to the ground, if the camera looks down on it.
  const ahead = forward(rpy);
  const toGround = wayOf(path) === 'mounted_on' ? Infinity : -position[2] / ahead[2];
  return toGround > 0.2 && toGround < 20 ? toGround : 4;
}

// `isPanned`: the camera no longer looks at the object at which it looked.
export function poseOfOrbit(orbit, before, isPanned = false) {
  const {position, rpy} = roundedPose({position: positionOf(orbit), rpy: orbit.rpy}, before);
  const form = formOf(before);
  if (form === 'optical') {
    const quaternion = quaternionOfMatrix(opticalOfBody(matrixOfRpy(orbit.rpy)));
    return [...position, ...quaternion.map((each) => rounded(each, 6))];
  }
  if (form === 'rpy') return {position, rpy};
  const isObject = form === 'object' && objectNames().includes(String(before.look_at));
  const look_at = isObject && !isPanned ? before.look_at : orbit.centre.map((each) => rounded(each, 3));
  return {position, look_at};
}
