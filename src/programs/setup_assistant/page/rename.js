// Gives an object another name, wherever the settings name it. What it follows and looks like stays.
import {keyOf} from './paths.js';
import {answer, change, effective, frameOf, objectNames, own, report, setText, store} from './store.js';
import {lineOf} from './yaml_lines.js';

let count = 0;

// Why it keeps its name; null if it may have another.
export function whyNamed(name) {
  const models = answer('api/world').value?.models ?? [];
  const isOfWorld = effective([name, 'pose']) === 'world' ||
      (effective([name, 'model']) === undefined && models.some((each) => each.name === name));
  return isOfWorld ? 'It is the world\u2019s model of this name.' : null;
}

export function whyNot(wanted, name) {
  if (!/^[A-Za-z]\w*$/.test(wanted)) return 'A name has letters, digits and underscores, and begins with a letter.';
  const isTaken = wanted !== name && (objectNames().includes(wanted) || effective([wanted]) !== undefined);
  return isTaken ? `There is a ${wanted} already.` : null;
}

export async function rename(name, wanted) {
  const step = `rename-${++count}`;
  const changes = changesFor(name, wanted);
  // In the text, the group keeps its comments and what else refers to it.
  const line = lineOf(store.state.text, [name]);
  if (line) {
    const lines = store.state.text.split('\n');
    const end = lines[line - 1].indexOf(':', lines[line - 1].lastIndexOf(name));
    lines[line - 1] = wanted + lines[line - 1].slice(end);
    try {
      await setText(lines.join('\n'), store.state.revision, step);
    } catch (error) {
      return report(error);
    }
  } else {
    changes.unshift([[wanted], effective([name])]);
    if (own([name]) !== undefined) changes.push([[name], undefined]);
  }
  return change(changes, step);
}

function changesFor(name, wanted) {
  return [
    [['robot_list'], objectNames().map((each) => (each === name ? wanted : each))], ...followed(name, wanted),
    ...references(store.state.settings, [], name, wanted)
  ];
}

// Frames that were named by the object's name.
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

// Cameras on it or that look at it, and what is random about it.
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
