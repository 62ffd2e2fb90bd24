import {h} from './dom.js';
import {choiceField, more, numberField, section, textField, vectorField} from './fields.js';
import {map} from './figure_map.js';
import {fileField} from './file_fields.js';
import {count} from './numbers.js';
import {answer, change, effective, set} from './store.js';

// Settings of objects that are placed at random, which the step Recording shows if there is no recording.
export const PLACEMENT_PATHS = [['motion'], ['placement'], ['scenes']];

export function isPlaced() {
  return effective(['motion']) === 'placement';
}

export function placementSummary() {
  const scenes = effective(['scenes']);
  return `none: ${NAMES[effective(['placement', 'mode']) ?? 'map']}${scenes ? `, ${count(scenes, 'scene')}` : ''}`;
}

const NAMES = {
  ground: 'on the ground',
  map: 'on a map',
  volume: 'in a box',
  drop: 'dropped'
};

// Adds the settings that placement cannot do without, if the file lacks them.
export function chooseMotion(motion) {
  const changes = [[['motion'], motion]];
  if (motion === 'placement' && effective(['scenes']) === undefined) changes.push([['scenes'], 100]);
  if (motion === 'placement' && effective(['placement']) === undefined) {
    changes.push([['placement', 'mode'], 'ground']);
  }
  return change(changes);
}

export function placementFields() {
  const mode = effective(['placement', 'mode']) ?? 'map';
  return [
    numberField(['scenes'], {label: 'Scenes of each camera', step: 10}),
    section(
        'Where',
        choiceField(
            ['placement', 'mode'],
            [['ground', 'On the ground'], ['map', 'On a map'], ['volume', 'In a box'], ['drop', 'Dropped']],
            {label: 'Objects are put'}),
        mode === 'map'        ? onMap() :
            mode === 'ground' ? onGround() :
                                inBox(mode),
        from(mode)),
    more(
        'How hard it is tried', [['placement', 'tries']],
        numberField(['placement', 'tries'], {label: 'Positions tried for each object', step: 100})),
  ];
}

function onMap() {
  const surface = effective(['placement', 'surface']) ?? 'below';
  return [
    fileField(['placement', 'map'], 'yaml,map,any', {label: 'Map of map_server'}),
    textField(['placement', 'map_topic'], {label: 'or a topic', hint: 'Of type nav_msgs/OccupancyGrid, in the bags.'}),
    choiceField(
        ['placement', 'surface'], [['below', 'On what is below'], ['none', 'At a height']], {label: 'They stand'}),
    surface === 'none' ? numberField(['placement', 'height'], {label: 'Height', range: [0, 5], step: 0.1}) : standing(),
  ];
}

function onGround() {
  const area = effective(['placement', 'area']);
  return [
    area === undefined ?
        h('p', {class: 'buttons'}, h('span', {class: 'muted'}, 'All of the ground.'),
          h('button', {type: 'button', onclick: () => set(['placement', 'area'], {min: [-5, -5], max: [5, 5]})},
            'Set a rectangle')) :
        [
          h('div', {class: 'pair'},
            vectorField(['placement', 'area', 'min'], ['x', 'y'], {label: 'From', unit: 'm', step: 0.1, hint: ''}),
            vectorField(['placement', 'area', 'max'], ['x', 'y'], {label: 'to', unit: 'm', step: 0.1, hint: ''})),
          h('p', {class: 'buttons'},
            h('button', {type: 'button', onclick: () => set(['placement', 'area'], undefined)}, 'All of the ground')),
        ],
    ...standing(),
  ];
}

function standing() {
  return [
    numberField(['placement', 'highest_surface'], {label: 'Not on what is higher', range: [0, 5], step: 0.1}),
    numberField(['placement', 'steepest'], {label: 'Steepest surface', range: [0, 1.5], step: 0.05}),
    numberField(['placement', 'unevenness'], {label: 'Unevenness', range: [0, 0.5], step: 0.01}),
  ];
}

function inBox(mode) {
  if (effective(['placement', 'volume']) === undefined) {
    return h(
        'p', {class: 'buttons'},
        h('button', {
          type: 'button',
          class: 'primary',
          onclick: () => set(['placement', 'volume'], {min: [-2, -2, 0.5], max: [2, 2, 1.5]})
        },
          'Set a box'));
  }
  return [
    h('div', {class: 'pair'},
      vectorField(['placement', 'volume', 'min'], ['x', 'y', 'z'], {label: 'Box from', unit: 'm', step: 0.1, hint: ''}),
      vectorField(['placement', 'volume', 'max'], ['x', 'y', 'z'], {label: 'to', unit: 'm', step: 0.1, hint: ''})),
    choiceField(['placement', 'orientation'], [['random', 'any'], ['upright', 'upright']], {label: 'Orientation'}),
    numberField(['placement', 'rows'], {label: 'Share of scenes with a row', slider: true, step: 0.05, fallback: 0}),
    mode === 'drop' ?
        numberField(['placement', 'fall_time'], {label: 'Has to rest within', range: [1, 30], step: 0.5}) :
        null,
  ];
}

function from(mode) {
  const world = answer('api/world').value;
  const occupancy = mode === 'map' ? answer('api/placement').value : null;
  const volume = effective(['placement', 'volume']);
  const area = effective(['placement', 'area']);
  const box = mode === 'ground' ? area : mode === 'map' ? undefined : volume;
  const boxes = box?.min && box?.max ? [{low: box.min, high: box.max}] : [];
  return map({
    picture: occupancy?.picture ?? world?.map,
    extent: occupancy?.extent ?? world?.map_extent,
    boxes,
    label: 'Where objects may be, from above'
  });
}
