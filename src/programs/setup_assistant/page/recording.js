// What the recording says of objects.
import {answer, effective, frameOf, objectNames} from './store.js';

// Undefined with placement, and until it is read.
export function recording() {
  return effective(['motion']) === 'placement' ? undefined : answer('/api/recording').value;
}

export function frames() {
  return (recording()?.frames ?? []).map((each) => each.name);
}

// By the objects' names; of a recording whose objects are not chosen yet, of what looks like robots.
export function waysOfObjects() {
  const {ways = {}, robots = []} = recording() ?? {};
  const named = objectNames().map((name) => [name, ways[frameOf(name)]]).filter(([, way]) => way);
  if (named.length) return Object.fromEntries(named);
  return Object.fromEntries(robots.map(({name, frame}) => [name, ways[frame]]).filter(([, way]) => way));
}

// What looks like robots and is no object yet.
export function candidates() {
  const {robots = [], frames: all = []} = recording() ?? {};
  const names = objectNames();
  const used = new Set(names.map(frameOf));
  return robots.filter(({frame}) => !used.has(frame) && !names.some((name) => frame.startsWith(`${name}/`)))
      .map((robot) => ({...robot, moved: all.find((each) => each.name === robot.frame)?.moved}));
}
