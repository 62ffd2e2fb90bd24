// Orientations of cameras. A body looks along its x, z is up, as in SDF and URDF: rpy are about the fixed axes
// x, y and z in this order. The optical frame has x right, y down, z ahead. Matrices are lists of rows.

export function matrixOfRpy([roll, pitch, yaw]) {
  const [cr, sr, cp, sp, cy, sy] = [
    Math.cos(roll),
    Math.sin(roll),
    Math.cos(pitch),
    Math.sin(pitch),
    Math.cos(yaw),
    Math.sin(yaw),
  ];
  return [
    [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
    [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
    [-sp, cp * sr, cp * cr],
  ];
}

export function rpyOfMatrix(m) {
  const pitch = Math.atan2(-m[2][0], Math.hypot(m[0][0], m[1][0]));
  // When it looks straight up or down, roll and yaw turn about the same axis: all of it is counted as yaw.
  if (Math.abs(Math.cos(pitch)) < 1e-6) return [0, pitch, Math.atan2(-m[0][1], m[1][1])];
  return [Math.atan2(m[2][1], m[2][2]), pitch, Math.atan2(m[1][0], m[0][0])];
}

export function matrixOfQuaternion([x, y, z, w]) {
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
  ];
}

export function quaternionOfMatrix(m) {
  const candidates = [
    [1 + m[0][0] - m[1][1] - m[2][2], m[0][1] + m[1][0], m[0][2] + m[2][0], m[2][1] - m[1][2]],
    [m[0][1] + m[1][0], 1 - m[0][0] + m[1][1] - m[2][2], m[1][2] + m[2][1], m[0][2] - m[2][0]],
    [m[0][2] + m[2][0], m[1][2] + m[2][1], 1 - m[0][0] - m[1][1] + m[2][2], m[1][0] - m[0][1]],
    [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1], 1 + m[0][0] + m[1][1] + m[2][2]],
  ];
  // The row with the largest diagonal element avoids division by a small number.
  const best = [0, 1, 2, 3].reduce((a, b) => (candidates[b][b] > candidates[a][a] ? b : a));
  const length = Math.hypot(...candidates[best]);
  return candidates[best].map((each) => each / length);
}

function columns(a, b, c) {
  return [0, 1, 2].map((row) => [a[row], b[row], c[row]]);
}

function column(m, index) {
  return m.map((row) => row[index]);
}

const negated = (v) => v.map((each) => -each);

export function bodyOfOptical(m) {
  return columns(column(m, 2), negated(column(m, 0)), negated(column(m, 1)));
}

export function opticalOfBody(m) {
  return columns(negated(column(m, 1)), negated(column(m, 2)), column(m, 0));
}

export const add = (a, b, factor = 1) => a.map((each, index) => each + factor * b[index]);
const dot = (a, b) => a.reduce((sum, each, index) => sum + each * b[index], 0);
export const distance = (a, b) => Math.hypot(...add(a, b, -1));

function times(m, v) {
  return m.map((row) => dot(row, v));
}

function transposed(m) {
  return [0, 1, 2].map((index) => column(m, index));
}

// A point in the frame whose pose is [x, y, z, qx, qy, qz, qw].
export function inFrame(pose, point) {
  return times(transposed(matrixOfQuaternion(pose.slice(3))), add(point, pose.slice(0, 3), -1));
}

// The view of a camera at `position`, as an orbit around a point `length` ahead of it.
export function orbitOf(position, rpy, length) {
  return {centre: add(position, forward(rpy), length), rpy, length};
}

export function forward([, pitch, yaw]) {
  return [Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), -Math.sin(pitch)];
}

export function positionOf({centre, rpy, length}) {
  return add(centre, forward(rpy), -length);
}

const STEEPEST = Math.PI / 2 - 0.01;

export function orbited({centre, rpy: [roll, pitch, yaw], length}, right, down) {
  const wrapped = Math.atan2(Math.sin(yaw - right), Math.cos(yaw - right));
  return {centre, rpy: [roll, Math.max(-STEEPEST, Math.min(STEEPEST, pitch + down)), wrapped], length};
}

// `right` and `down` in metres at the centre's distance: the picture follows the hand.
export function panned({centre, rpy, length}, right, down) {
  const body = matrixOfRpy(rpy);
  const shifted = add(add(centre, column(body, 1), right), column(body, 2), down);
  return {centre: shifted, rpy, length};
}

const NEAREST = 0.3;  // [m] to the centre

// Moves along the view by a share of the distance to the centre. Near the centre, the centre is moved ahead, so that
// each step moves the camera; `isHeld`: the centre stays, and with it the camera.
export function zoomed({centre, rpy, length}, factor, isHeld = false) {
  if (isHeld) return {centre, rpy, length: Math.max(NEAREST, length * factor)};
  const left = length - Math.max(length, NEAREST) * (1 - factor);
  if (left >= NEAREST || factor >= 1) return {centre, rpy, length: left};
  return {centre: add(centre, forward(rpy), NEAREST - left), rpy, length: NEAREST};
}
