// Renames an object or a camera, wherever the settings name it. The frames that it follows and its looks stay.
import {keyOf} from './paths.js';
import {answer, change, effective, frameOf, objectNames, own, report, setText, store} from './store.js';
import {lineOf} from './yaml_lines.js';

let count = 0;

// The reason why an object has to keep its name; null if it can be renamed.
export function whyNamed(name) {
  const models = answer('api/world').value?.models ?? [];
  const isOfWorld = effective([name, 'pose']) === 'world' ||
      (effective([name, 'model']) === undefined && models.some((each) => each.name === name));
  return isOfWorld ? 'It is the world\u2019s model of this name.' : null;
}

const NAME = /^[A-Za-z]\w*$/;

function whyNoName(wanted) {
  return NAME.test(wanted) ? null : 'A name has letters, digits and underscores, and begins with a letter.';
}

export function whyNot(wanted) {
  const isTaken = objectNames().includes(wanted) || effective([wanted]) !== undefined;
  return whyNoName(wanted) ?? (isTaken ? `There is a ${wanted} already.` : null);
}

export function whyNotCamera(wanted) {
  return whyNoName(wanted) ??
      (effective(['cameras', wanted]) !== undefined ? `There is a camera ${wanted} already.` : null);
}

export function rename(name, wanted) {
  return renameGroup([name], wanted, changesFor(name, wanted));
}

// Renames one of several cameras: it keeps its place among them, which gives the order of the scenes.
export function renameCamera(name, wanted) {
  return renameGroup(['cameras', name], wanted, []);
}

// A group whose name begins a line is renamed in the text, where it keeps its comments and what else refers to it.
// Other groups are written anew.
async function renameGroup(path, wanted, more) {
  const step = `rename-${++count}`;
  const text = withNewKey(store.state.text, path, wanted);
  const there = [...path.slice(0, -1), wanted];
  const anew = text === null ? [[there, effective(path)]] : [];
  const gone = text === null && own(path) !== undefined ? [[path, undefined]] : [];
  try {
    if (text !== null) await setText(text, store.state.revision, step);
  } catch (error) {
    return report(error);
  }
  return change([...anew, ...more, ...gone], step);
}

const KEY = /^(\s*)(["']?)([^"':]+?)\2(\s*:.*)$/;

function withNewKey(text, path, wanted) {
  const lines = text.split('\n');
  const index = (lineOf(text, path) ?? 0) - 1;
  const [, indent, , key, rest] = KEY.exec(lines[index] ?? '') ?? [];
  if (key !== path.at(-1)) return null;
  lines[index] = indent + wanted + rest;
  return lines.join('\n');
}

function changesFor(name, wanted) {
  return [
    [['robot_list'], objectNames().map((each) => (each === name ? wanted : each))], ...followed(name, wanted),
    ...references(store.state.settings, [], name, wanted)
  ];
}

// Changes that keep the frames whose names came from the object's name.
function followed(name, wanted) {
  const isPlaced = effective(['motion']) === 'placement' || effective([name, 'pose']) !== undefined;
  if (isPlaced) return [];
  const links = effective([name, 'link_frames']) ?? '{object}/{link}';
  const changes = [];
  if (effective([name, 'frame']) === undefined) changes.push([[wanted, 'frame'], frameOf(name)]);
  if (own([name, 'frame_id']) !== undefined) changes.push([[wanted, 'frame_id'], undefined]);
  if (typeof links === 'string' && links.includes('{object}')) {
    changes.push([[wanted, 'link_frames'], links.replaceAll('{object}', name)]);
  }
  return changes;
}

const NAMING = ['look_at', 'mounted_on'];

// Changes to cameras that are on the object or look at it, and to what is random about it.
function references(value, path, name, wanted) {
  if (value === null || typeof value !== 'object') {
    return value === name && NAMING.includes(path.at(-1)) ? [[path, wanted]] : [];
  }
  const changes = Object.entries(value).flatMap(
      ([key, each]) => references(each, [...path, Array.isArray(value) ? Number(key) : key], name, wanted));
  if (keyOf(path) === 'randomize/objects' && value[name] !== undefined) {
    changes.push([[...path, wanted], value[name]], [[...path, name], undefined]);
  }
  return changes;
}
