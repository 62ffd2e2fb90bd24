import {h} from './dom.js';
import {choiceField, more, numberField, section} from './fields.js';
import {map} from './figure_map.js';
import {fileField, fileListField} from './file_fields.js';
import {count, fileName, fixed, grouped} from './numbers.js';
import {answer, effective, objectNames, set} from './store.js';

export const worldPane = {
  id: 'world',
  title: 'World',
  text: 'The surroundings of the objects: an SDF world, as Gazebo uses it.',
  paths: () => [['world'], ['world_file'], ['world_objects'], ['physics'], ['rendering']],
  summary: () => fileName(
      effective(['world_file']) ?? effective(['world', 'file']) ??
      (typeof effective(['world']) === 'string' ? effective(['world']) : '')),
  draw,
};

function draw() {
  const isGroup = typeof effective(['world']) !== 'string';
  return [
    section(
        'File', fileField(isGroup ? ['world', 'file'] : ['world'], 'world', {label: 'World'}),
        effective(['world_file']) === undefined ? null : fileField(['world_file'], 'world', {label: 'instead of it'}),
        isGroup ?
            [
              fileListField(['world', 'model_folders'], 'folder', {label: 'Folders with models', isList: true}),
              choiceField(
                  ['world', 'on_missing_asset'], [['error', 'Is an error'], ['warn', 'Is left out']],
                  {label: 'What is missing'}),
              choiceField(
                  ['world', 'simulator'], [['auto', 'auto'], ['classic', 'Gazebo Classic'], ['gz', 'gz-sim']],
                  {label: 'Colours and lights as in'}),
            ] :
            h('p', {},
              h('button', {type: 'button', onclick: () => set(['world'], {file: effective(['world'])})},
                'More settings'))),
    contents(),
    more(
        'Physics', ['step', 'contact_tolerance', 'settle'].map((each) => ['physics', each]),
        numberField(['physics', 'step'], {label: 'Step', step: 0.001}),
        numberField(['physics', 'contact_tolerance'], {label: 'Overlap that is reported', step: 0.005}),
        numberField(['physics', 'settle'], {label: 'Time to come to rest', step: 0.5, fallback: 0})),
    more(
        'Picture', ['light', 'samples', 'shadow_map_size', 'shadow_distance'].map((each) => ['rendering', each]),
        choiceField(['rendering', 'light'], null, {label: 'Light'}),
        choiceField(['rendering', 'samples'], [[1, '1'], [4, '4']], {label: 'Samples at an edge'}),
        numberField(['rendering', 'shadow_map_size'], {label: 'Shadow map', step: 256}),
        numberField(['rendering', 'shadow_distance'], {label: 'Sun\u2019s shadows up to', range: [1, 200], step: 1})),
  ];
}

function contents() {
  const {value: world, error} = answer('api/world');
  if (error) return section('What is in it', h('p', {class: 'empty'}, error));
  if (!world) return section('What is in it', h('div', {class: 'placeholder'}, 'Reading the world\u2026'));
  const triangles = world.models.reduce((sum, each) => sum + (each.triangles ?? 0), 0);
  return section(
      'What is in it',
      h('p', {class: 'facts'},
        [
          count(world.models.length, 'model'),
          triangles ? `${grouped(triangles)} triangles` : null,
          lights(world.lights),
        ].filter(Boolean)
            .join(', ')),
      missing(world.missing ?? []), map({picture: world.map, extent: world.map_extent, label: 'The world from above'}),
      h('div', {class: 'table', tabindex: '0', role: 'region', 'aria-label': 'Models of the world'},
        h('table', {},
          h('thead', {},
            h('tr', {},
              ['model', 'links', 'triangles', 'x', 'y', 'z'].map(
                  (each, index) => h('th', {scope: 'col', class: index ? 'figure' : ''}, each)),
              h('th', {scope: 'col'}, 'label'))),
          h('tbody', {},
            world.models.map(
                (each) =>
                    h('tr', {key: each.name},
                      h('th', {scope: 'row'}, each.name,
                        each.static === false ? h('span', {class: 'muted'}, ' moves') : null),
                      h('td', {class: 'figure'}, each.links),
                      h('td', {class: 'figure'}, each.triangles === undefined ? '' : grouped(each.triangles)),
                      [0, 1, 2].map((axis) => h('td', {class: 'figure'}, fixed(each.X?.[axis]))),
                      h('td', {}, labelOf(each.name))))))));
}

// The class with which a model is labelled, or a button to label it: an entry of world_objects.
function labelOf(model) {
  if (objectNames().includes(model)) return h('span', {class: 'muted'}, 'an object');
  const entry = entries().find((each) => isMeant(model, each));
  if (!entry) {
    return h('button', {type: 'button', onclick: () => label(model), 'aria-label': `Label ${model}`}, 'Label this');
  }
  const isNamed = [].concat(entry.models).includes(model);
  return [
    String(entry.class ?? '?'),
    isNamed ? h('button',
                {type: 'button', class: 'quiet', 'aria-label': `Do not label ${model}`, onclick: () => unlabel(model)},
                '\u00d7') :
              null,
  ];
}

function entries() {
  const list = effective(['world_objects']);
  return Array.isArray(list) ? list : [];
}

// `*` and `?` match any text and any single character.
function isMeant(model, entry) {
  return [].concat(entry?.models ?? []).some((pattern) => {
    const escaped = String(pattern).replace(/[.+^${}()|[\]\\]/g, '\\$&').replace(/\*/g, '.*').replace(/\?/g, '.');
    return new RegExp(`^${escaped}$`).test(model);
  });
}

function label(model) {
  const name = model.replace(/[_-]?\d+$/, '') || model;
  const all = entries();
  const index = all.findIndex((each) => each?.class === name);
  set(['world_objects'],
      index < 0 ? [...all, {class: name, models: [model]}] :
                  all.map((each, at) => (at === index ? {...each, models: [].concat(each.models, model)} : each)));
}

function unlabel(model) {
  const left = entries()
                   .map((each) => ({...each, models: [].concat(each.models).filter((name) => name !== model)}))
                   .filter((each) => each.models.length);
  set(['world_objects'], left.length ? left : undefined);
}

function lights(all) {
  if (!Array.isArray(all)) return typeof all === 'number' ? count(all, 'light') : null;
  return `${count(all.length, 'light')}${all.length ? ` (${all.map((each) => each.name ?? each).join(', ')})` : ''}`;
}

function missing(all) {
  if (!all.length) return null;
  const isGroup = typeof effective(['world']) !== 'string';
  return [
    h('p', {class: 'problems'},
      isGroup ? 'If they are in other folders, name these above, as Folders with models.' :
                'If they are in other folders, these can be named: ',
      isGroup ? null :
                h('button', {type: 'button', onclick: () => set(['world'], {file: effective(['world'])})},
                  'Folders with models')),
    h('ul', {class: 'problems'},
      all.map(
          (each) =>
              h('li', {class: 'warning'}, h('span', {class: 'severity'}, 'missing'), ' ',
                typeof each === 'string' ? each : each.what ?? JSON.stringify(each)))),
  ];
}
