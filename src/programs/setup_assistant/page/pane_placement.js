import {h} from './dom.js';
import {choiceField, fileField, more, numberField, section, textField, vectorField} from './fields.js';
import {map} from './figure_map.js';
import {count} from './numbers.js';
import {answer, effective, set} from './store.js';

export const placementPane = {
  id: 'placement',
  title: 'Without a recording',
  text: 'Objects are put somewhere else for each scene: on the free cells of a map, in a box, or dropped from it.',
  paths: () => [['motion'], ['placement'], ['scenes']],
  summary: () =>
      (effective(['motion']) === 'placement' ?
           `${effective(['placement', 'mode']) ?? 'map'}${
               effective(['scenes']) ? `, ${count(effective(['scenes']), 'scene')}` : ''}` :
                                       'not used'),
  draw,
};

function draw() {
  const motion = choiceField(
      ['motion'], [['bag', 'Follow a recording'], ['placement', 'Place at random']],
      {label: 'Objects\u2019 poses', fallback: 'bag'});
  if (effective(['motion']) !== 'placement') {
    return [motion, h('p', {class: 'empty'}, 'Objects follow the recording, so nothing is placed at random.')];
  }
  const mode = effective(['placement', 'mode']) ?? 'map';
  return [
    motion,
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
    textField(['placement', 'map_topic'], {label: 'or a topic', hint: 'Of type nav_msgs/OccupancyGrid, of the bags.'}),
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
