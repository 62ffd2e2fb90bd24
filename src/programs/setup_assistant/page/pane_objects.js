import {h} from './dom.js';
import {choiceField, flowField, more, numberField, problemList, section, textField, vectorField} from './fields.js';
import {fileField} from './file_fields.js';
import {renaming} from './name_field.js';
import {fixed} from './numbers.js';
import {freeName} from './paths.js';
import {modelOf, portrait} from './portrait.js';
import {count as countOf, problemsAt, problemsBelow} from './problems.js';
import {candidates, frames} from './recording.js';
import {rename, whyNamed, whyNot} from './rename.js';
import {answer, change, changed, effective, objectNames, own, parameter, set} from './store.js';
import {show, view} from './view_state.js';

export const objectsPane = {
  id: 'objects',
  title: 'Objects',
  text: 'What TF or placement moves, and what gets labels: its frame, its model, its class, its keypoints.',
  paths: () => [['robot_list'], ['classes'], ['world_classes'], ['labels'], ...objectNames().map((each) => [each])],
  summary: () => objectNames().join(', '),
  draw,
};

function current() {
  const names = objectNames();
  return names.includes(view.object) ? view.object : names[0];
}

function draw() {
  const name = current();
  return [
    h('div', {'data-path': 'robot_list', class: 'field'}, tabs(name), problemList(problemsAt(['robot_list']))),
    found(),
    name ? h('div', {key: name, class: 'object'}, object(name)) :
           h('p', {class: 'empty'}, 'No object yet: add one of the frames above, or one by its name.'),
    classes(),
  ];
}

function tabs(current) {
  return h(
      'div', {class: 'tabs', role: 'group', 'aria-label': 'Objects'}, objectNames().map((name) => {
        const {error} = countOf(problemsBelow([name]));
        return h(
            'button', {
              key: name,
              type: 'button',
              class: error ? 'tab wrong' : 'tab',
              'aria-pressed': String(name === current),
              onclick: () => show({object: name}),
            },
            name);
      }),
      h('button', {
        key: ' add',
        type: 'button',
        class: 'tab add',
        'aria-expanded': String(adding.isOn),
        onclick: () => {
          adding.isOn = !adding.isOn;
          changed();
        }
      },
        '+ Add'),
      adding.isOn ? nameForm() : null);
}

const adding = {
  isOn: false
};

// Asks for a new object's name, and offers those of the recording's robots and the world's models.
function nameForm() {
  const models = (answer('api/world').value?.models ?? []).map((each) => each.name);
  const offered = [...new Set([...candidates().map((each) => each.name), ...models])].filter(
      (each) => !objectNames().includes(each));
  return h(
      'form', {
        key: ' form',
        class: 'with-button',
        onsubmit: (event) => {
          event.preventDefault();
          const name = event.target.elements[0].value.trim() || freeName('object', objectNames());
          adding.isOn = false;
          const known = candidates().find((each) => each.name === name);
          addObject({name, frame: known?.frame, stands: !known && models.includes(name)});
        }
      },
      h('input',
        {type: 'text', list: 'offered-objects', placeholder: 'its name', 'aria-label': 'Name of the new object'}),
      h('datalist', {id: 'offered-objects'}, offered.map((each) => h('option', {value: each}))),
      h('button', {type: 'submit', class: 'primary'}, 'Add'));
}

// `frame`: the whole name of a TF frame; `stands`: it stands where the world has its model of this name.
function addObject({name, frame, stands}) {
  const changes = [[['robot_list'], [...objectNames(), name]]];
  const settings = {class: name.replace(/[_-]?\d+$/, ''), id: name};
  if (frame) {
    if (frame.startsWith(`${name}/`))
      settings.frame_id = frame.slice(name.length + 1);
    else
      settings.frame = frame;
  }
  if (stands) settings.pose = 'world';
  if (effective([name]) === undefined) changes.push([[name], settings]);
  change(changes);
  show({object: name});
}

function removeObject(name) {
  const changes = [[['robot_list'], objectNames().filter((each) => each !== name)]];
  if (own([name]) !== undefined) changes.push([[name], undefined]);
  change(changes);
}

// Frames that look like robots and are not objects yet.
function found() {
  const free = candidates();
  if (!free.length) return null;
  return section(
      'Frames that look like robots',
      h('ul', {class: 'candidates'},
        free.map(
            ({name, frame, moved}) =>
                h('li', {key: frame}, h('code', {}, frame),
                  h('span', {class: 'muted'}, moved > 0.001 ? `moves ${fixed(moved, 1)} m` : 'stands'),
                  h('button', {
                    type: 'button',
                    'aria-label': `Add ${frame}`,
                    onclick: () => addObject({name: freeName(name, objectNames()), frame})
                  },
                    'Add')))));
}

function object(name) {
  const isPlaced = effective(['motion']) === 'placement';
  const known = modelOf(name);
  return [
    h('div', {class: 'object-top'}, portrait(name),
      h('div', {class: 'field', 'data-path': name}, problemList(problemsAt([name])), nameField(name),
        h('div', {class: 'pair'}, textField([name, 'class'], {label: 'Class', suggestions: classNames()}),
          textField([name, 'id'], {label: 'Id'})),
        isPlaced ?
            numberField(
                [name, 'safety_radius'],
                {label: 'Distance that others keep', range: [0, 3], step: 0.05, fallback: known ? 'by its size' : ''}) :
            effective([name, 'pose']) !== undefined ?
            flowField([name, 'pose'], {label: 'Where it stands'}) :
            h('div', {class: 'pair'}, textField([name, 'frame_id'], {
                label: `Frame, after ${name}/`,
                suggestions: framesBelow(name),
                class: effective([name, 'frame']) === undefined ? '' : 'overruled'
              }),
              textField([name, 'frame'], {label: 'or its whole name', suggestions: frames()})),
        known ? h('p', {class: 'facts'}, size(known)) : null)),
    fileField([name, 'model'], 'model', {label: 'Model', placeholder: 'the world\u2019s model of its name'}),
    h('section', {class: 'group'}, h('h2', {}, 'Keypoints'), keypoints(name)),
    h('section', {class: 'group'}, h('h2', {}, 'Bounding shape'), shape(name, known)),
    more(
        'Links, parts, names of keypoints',
        ['link_frames', 'parts', 'keypoint_names', 'skeleton', 'model_arguments', 'when_unknown'].map(
            (each) => [name, each]),
        flowField([name, 'keypoint_names'], {label: 'Names of the keypoints'}),
        flowField([name, 'skeleton'], {label: 'Lines between keypoints'}),
        flowField([name, 'link_frames'], {label: 'TF frames of its links'}),
        flowField([name, 'parts'], {label: 'Parts with labels of their own'}),
        flowField([name, 'model_arguments'], {label: 'Arguments of a xacro file'}),
        isPlaced || effective([name, 'pose']) !== undefined ?
            null :
            choiceField([name, 'when_unknown'], [['skip_scene', 'No scenes'], ['absent', 'Scenes without it']], {
              label: 'While its frame is not known',
              fallback: effective(['when_unknown']) ?? parameter(['when_unknown'])?.default
            })),
    h('p', {}, h('button', {type: 'button', class: 'danger', onclick: () => removeObject(name)}, `Remove ${name}`)),
  ];
}

function nameField(name) {
  return renaming('object-name', name, {
    why: whyNamed(name),
    whyNot,
    rename: (wanted) => rename(name, wanted).then(() => show({object: wanted})),
  });
}

function size({low, high}) {
  if (!low || !high) return '';
  const sides = high.map((each, index) => fixed(each - low[index])).join(' \u00d7 ');
  return `Its model is ${sides} m.`;
}

function classNames() {
  return [...new Set(
      objectNames().map((each) => effective([each, 'class'])).filter((each) => each !== undefined).map(String))];
}

function framesBelow(name) {
  return frames().filter((each) => each.startsWith(`${name}/`)).map((each) => each.slice(name.length + 1));
}

function keypoints(name) {
  const path = [name, 'keypoints'];
  const points = effective(path);
  if (points !== undefined && !Array.isArray(points)) return [flowField(path, {label: 'Chosen by a rule'})];
  const list = points ?? [];
  const names = effective([name, 'keypoint_names']) ?? [];
  return [
    h('div', {class: 'field', 'data-path': path.join('/')},
      h('p', {class: 'hint'},
        'Turn on \u201cPick\u201d beside the model and click on it to add a point, or let points be chosen on its surface.'),
      problemList(problemsAt(path)),
      h('div', {class: 'points'},
        list.map(
            (point, index) =>
                h('div', {key: index, class: 'point'}, h('span', {class: 'point-name'}, names[index] ?? index),
                  vectorField(
                      [...path, index], ['x', 'y', 'z'],
                      {label: `Keypoint ${names[index] ?? index}`, hint: '', step: 0.01, class: 'bare'}),
                  h('button', {
                    type: 'button',
                    class: 'quiet',
                    'aria-label': `Remove keypoint ${names[index] ?? index}`,
                    onclick: () => removePoint(path, list, index)
                  },
                    '\u00d7')))),
      h('p', {class: 'buttons'},
        h('button', {type: 'button', onclick: () => addPoint(path, list, [0, 0, 0])}, 'Add at the origin'),
        h('button', {type: 'button', onclick: () => set(path, {farthest_points: 9})}, 'Choose 9 on its surface'))),
  ];
}

function addPoint(path, list, point) {
  set(path, [...list, point]);
}

function removePoint(path, list, index) {
  if (list.length === 1) return set(path, undefined);
  return own(path) === undefined ? set(path, list.filter((each, at) => at !== index)) :
                                   set([...path, index], undefined);
}

const CORNERS = [[1, 1, 0], [1, 0, 0], [0, 0, 0], [0, 1, 0], [1, 1, 1], [1, 0, 1], [0, 0, 1], [0, 1, 1]];

function shape(name, known) {
  const path = [name, 'bounding_shape'];
  const value = effective(path);
  const corners = known?.low &&
      CORNERS.map((corner) => corner.map((isHigh, axis) => Number((isHigh ? known.high : known.low)[axis].toFixed(3))));
  return [
    flowField(path, {label: 'Points around it, or model_box', unit: 'm', fallback: 'model_box'}),
    h('p', {class: 'buttons'},
      h('button',
        {type: 'button', disabled: value === undefined || value === 'model_box', onclick: () => set(path, undefined)},
        'The model\u2019s box'),
      h('button', {type: 'button', disabled: !corners, onclick: () => set(path, corners)},
        'Write the box\u2019s corners')),
  ];
}

function classes() {
  return more(
      'Classes, and which objects get labels', [['classes'], ['world_classes'], ['labels']],
      flowField(['classes'], {label: 'Order of the classes'}),
      flowField(['world_classes'], {label: 'Classes of the world'}),
      numberField(['labels', 'min_visibility'], {label: 'Least visible share', slider: true, step: 0.01, fallback: 0}),
      numberField(
          ['labels', 'min_pixels'],
          {label: 'Fewest visible pixels', range: [0, 400], step: 1, fallback: 'one, mostly'}),
      numberField(['labels', 'keypoint_tolerance'], {label: 'Keypoints behind a surface count up to', step: 0.005}),
      choiceField(
          ['labels', 'glass'], [['objects', 'of objects'], ['solid', 'all'], ['clear', 'none']],
          {label: 'Glass that hides what is behind it'}));
}
