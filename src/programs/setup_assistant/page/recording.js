// What the recording says about objects.
import {answer, effective, frameOf, objectNames} from './store.js';

// Undefined with placement, and until the recording is read.
export function recording() {
  return effective(['motion']) === 'placement' ? undefined : answer('api/recording').value;
}

export function frames() {
  return (recording()?.frames ?? []).map((each) => each.name);
}

// The paths of objects, by name; if no object with a path is chosen yet, those of what looks like robots.
export function waysOfObjects() {
  const {robots = []} = recording() ?? {};
  const named = objectNames().map((name) => [name, wayOf(frameOf(name))]).filter(([, way]) => way);
  if (named.length) return Object.fromEntries(named);
  return Object.fromEntries(robots.map(({name, frame}) => [name, wayOf(frame)]).filter(([, way]) => way));
}

// A frame that is fixed to another one, as a base_link to a base_footprint, has the other's path.
function wayOf(frame) {
  const {ways = {}, frames: all = []} = recording() ?? {};
  const known = new Map(all.map((each) => [each.name, each]));
  for (let at = frame, steps = 0; at && steps < all.length + 1; at = known.get(at).parent, ++steps) {
    if (ways[at]) return ways[at];
    if (!known.get(at)?.is_static) return undefined;
  }
  return undefined;
}

// Frames that look like a robot and are not an object yet.
export function candidates() {
  const {robots = [], frames: all = []} = recording() ?? {};
  const names = objectNames();
  const used = new Set(names.map(frameOf));
  return robots.filter(({frame}) => !used.has(frame) && !names.some((name) => frame.startsWith(`${name}/`)))
      .map((robot) => ({...robot, moved: all.find((each) => each.name === robot.frame)?.moved}));
}
