import {h} from './dom.js';
import {choiceField, flowField, problemList, switchField, textField} from './fields.js';
import {freeName} from './paths.js';
import {problemsAt, problemsBelow} from './problems.js';
import {answer, change, effective} from './store.js';

export const formatsPane = {
  id: 'formats',
  title: 'Formats',
  text: 'Each format is written to a folder of its own, all from the same scenes.',
  paths: () => [['writers'], ...writers().map((each) => [String(each.name)])],
  summary: () => writers().map((each) => each.name).join(', '),
  draw,
};

function writers() {
  const list = effective(['writers']);
  return Array.isArray(list) ? list.filter((each) => each && typeof each === 'object') : [];
}

function draw() {
  const {value, error} = answer('api/formats');
  if (!value) return h('p', {class: 'empty'}, error ?? 'Reading the formats\u2026');
  const known = new Set(value.formats.map((each) => each.type));
  const strange = writers().filter((each) => !known.has(each.type));
  return [
    h('div', {class: 'field', 'data-path': 'writers'}, problemList(problemsAt(['writers']))),
    writers().length === 0 ?
        h('p', {class: 'hint'}, 'No list of formats is set: bounding_shape, yolo and stvnet are written.') :
        null,
    h('ul', {class: 'formats'},
      [
        ...strange.map(
            (each) =>
                h('li', {key: `strange ${each.name}`, class: 'format chosen'},
                  h('div', {class: 'format-head'}, h('strong', {}, String(each.type)),
                    h('span', {class: 'problems'}, 'is not a format of the installed plugins')))),
        ...value.formats.map(format),
      ]),
  ];
}

function format(each) {
  const used = writers().filter((writer) => writer.type === each.type);
  const [library, short] = each.type.includes('/') ? each.type.split('/') : ['', each.type];
  return h(
      'li', {key: each.type, class: used.length ? 'format chosen' : 'format'},
      h('div', {class: 'format-head'},
        h('label', {class: 'toggle plain'}, h('input', {
            type: 'checkbox',
            checked: used.length > 0,
            onchange: (event) => (event.target.checked ? add(each) : remove(each.type)),
          }),
          h('strong', {}, short)),
        h('span', {class: 'format-text'}, each.text ?? '', each.read_by ? `; for ${each.read_by}` : '',
          library === 'synthetic_dataset' ? '' : `; of ${library}`)),
      used.map((writer) => options(writer, each)));
}

function add({type, name: wanted}) {
  const name = freeName(wanted ?? type.split('/').pop().toLowerCase(), writers().map((each) => each.name));
  const writer = {name, type};
  const changes = [[['writers'], [...writers(), writer]]];
  const needed = {'synthetic_dataset/Yolo': {main_list: 'list.txt', class: 'number'}}[type];
  if (needed && effective([name]) === undefined) changes.push([[name], needed]);
  change(changes);
}

function remove(type) {
  const rest = writers().filter((each) => each.type !== type);
  const names = writers().filter((each) => each.type === type).map((each) => each.name);
  change([
    [['writers'], rest.length ? rest : undefined],
    ...names.filter((each) => effective([each]) !== undefined).map((each) => [[each], undefined])
  ]);
}

function options(writer, {options: list = []}) {
  const name = String(writer.name);
  const isSet = effective([name]) !== undefined;
  return h(
      'details', {key: name, class: 'options', opened: problemsBelow([name]).length > 0},
      h('summary', {}, 'Options',
        isSet ? h('span', {class: 'muted'},
                  ` ${Object.entries(effective([name])).map(([key, value]) => `${key}: ${value}`).join(', ')}`) :
                null),
      h('div', {class: 'field', 'data-path': name}, problemList(problemsAt([name])),
        list.map((each) => field(name, each)),
        list.length ? null : flowField([name], {label: 'Its settings', hint: 'docs/formats.md has them.'})));
}

function field(name, {name: option, default: fallback, choices, text}) {
  const path = [name, option];
  const options = {label: option, hint: text, fallback};
  if (choices) return choiceField(path, choices, options);
  return typeof fallback === 'boolean' ? switchField(path, options) : textField(path, options);
}
