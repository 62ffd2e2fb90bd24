// Shown for an empty settings file: the user chooses files, and all that `start` can tell from them is filled in.
import {post} from './api.js';
import {h} from './dom.js';
import {browse} from './file_dialog.js';
import {fileName} from './numbers.js';
import {chooseMotion} from './placement_fields.js';
import {changed, isEmpty, report, store, takeStateOf} from './store.js';

const chosen = {
  bags: [],
  world: null,
  models: [],
  isBusy: false,
  byHand: false
};

export function greets() {
  return isEmpty() && !chosen.byHand;
}

export function greeting() {
  return h(
      'div', {class: 'greeting'},
      h('section', {class: 'group'}, h('h2', {}, 'Start from a recording'),
        h('p', {class: 'hint'}, 'Choose what you have. Everything else is filled in, and can be changed afterwards.'),
        row('Recording', 'a bag of ROS 1 or ROS 2', chosen.bags, () => add('bag', 'recording', chosen.bags),
            remover(chosen.bags)),
        row('World', 'an SDF world; without one, a plain ground and the sun', chosen.world ? [chosen.world] : [],
            chooseWorld,
            () => {
              chosen.world = null;
              changed();
            }),
        row('Robots', 'their URDF, xacro or SDF files', chosen.models, () => add('model', 'robot', chosen.models),
            remover(chosen.models)),
        h('p', {class: 'buttons'},
          h('button',
            {type: 'button', class: 'primary', disabled: chosen.isBusy || !chosen.bags.length, onclick: start},
            chosen.isBusy ? 'Reading the files\u2026' : 'Fill in the settings'),
          chosen.bags.length ? null : h('span', {class: 'muted'}, 'This needs a recording.'),
          h('button', {
            type: 'button',
            class: 'quiet by-hand',
            onclick: () => {
              chosen.byHand = true;
              changed();
            }
          },
            'Step by step instead'))),
      h('section', {class: 'group'}, h('h2', {}, 'Without a recording'),
        h('p', {class: 'hint'}, 'Objects are placed at random: on the ground of a world, on a map, or in the air.'),
        h('p', {class: 'buttons'},
          h('button', {type: 'button', onclick: () => chooseMotion('placement')}, 'Place objects at random'))));
}

function row(label, what, files, choose, remove) {
  return h(
      'div', {class: 'field greeting-row', key: label}, h('span', {class: 'label'}, label),
      h('ul', {class: 'chips'},
        files.map(
            (file) =>
                h('li', {title: file}, fileName(file),
                  h('button',
                    {type: 'button', class: 'quiet', 'aria-label': `Remove ${file}`, onclick: () => remove(file)},
                    '\u00d7')))),
      h('button', {type: 'button', onclick: choose, 'aria-label': `Choose: ${label}`},
        files.length && label !== 'World' ? 'Add\u2026' : 'Choose\u2026'),
      h('span', {class: 'muted'}, what));
}

function remover(list) {
  return (file) => {
    list.splice(list.indexOf(file), 1);
    changed();
  };
}

async function add(kind, what, list) {
  const file = await browse(kind, what, list.at(-1));
  if (file && !list.includes(file)) list.push(file);
  changed();
}

async function chooseWorld() {
  chosen.world = await browse('world', 'world', chosen.world) ?? chosen.world;
  changed();
}

async function start() {
  chosen.isBusy = true;
  changed();
  try {
    takeStateOf(await post('api/start', {
      revision: store.state.revision,
      bags: chosen.bags,
      world: chosen.world,
      models: chosen.models,
    }));
  } catch (error) {
    report(error);
  }
  chosen.isBusy = false;
  changed();
}
