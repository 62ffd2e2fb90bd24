import {distribution} from './distribution.js';
import {h} from './dom.js';
import {choiceField, flowField, numberField, section, textField, vectorField} from './fields.js';
import {fileField, fileListField} from './file_fields.js';
import {answer, askAgain, effective, objectNames, own, set} from './store.js';
import {currentCamera} from './view_state.js';

export const randomisationPane = {
  id: 'randomisation',
  title: 'Randomisation',
  text: 'Light, paint, sensor and clutter that differ from scene to scene, so that a network does not learn them.',
  paths: () => [['randomize'], ['include'], ['seed']],
  summary: () => Object.keys(effective(['randomize']) ?? {}).join(', ') || 'nothing',
  draw,
};

const root = (...rest) => ['randomize', ...rest];

function draw() {
  return [
    draws(),
    preset(),
    section('Light', lights(), light()),
    section('Surfaces', surfaces()),
    section(
        'Camera',
        distribution(
            root('sensor', 'exposure'),
            {label: 'Exposure', range: [-3, 3], start: {normal: [0, 0.35], min: -0.7, max: 0.7}}),
        distribution(root('sensor', 'blur'), {label: 'Blur', range: [0, 5], start: {uniform: [0, 0.8]}}),
        distribution(root('sensor', 'noise_stddev'), {label: 'Noise', range: [0, 0.1], start: {uniform: [0, 0.015]}}),
        distribution(
            root('sensor', 'white_balance'),
            {label: 'White balance', range: [2000, 15000], start: {log_uniform: [5000, 8500]}}),
        distribution(
            root('sensor', 'jpeg_quality'), {label: 'JPEG quality', range: [1, 100], start: {uniform: [40, 95]}}),
        distribution(
            root('sensor', 'field_of_view'), {label: 'Field of view', range: [0.2, 3], start: {uniform: [0.7, 1.4]}})),
    section('Weather', weather()),
    effective(['motion']) === 'placement' ? null : section('Time', distribution(root('time', 'jitter'), {
                                                             label: 'Later or earlier by',
                                                             range: [-0.1, 0.1],
                                                             start: {uniform: [-0.01, 0.01]}
                                                           })),
    background(),
    section('Objects', objects()),
    distractors(),
    numberField(['seed'], {label: 'Seed', step: 1}),
  ];
}

function draws() {
  const query = {count: 9, camera: currentCamera()};
  const {value, error, isAsked} = answer('api/draws', query);
  const pictures = value?.pictures ?? [];
  return h(
      'section', {class: 'group draws', key: 'draws'},
      h('div', {class: 'draws-head'}, h('h2', {}, 'Nine draws'),
        h('span', {class: 'muted', role: 'status'}, error ?? (isAsked ? 'drawing\u2026' : '')),
        h('button', {type: 'button', class: 'quiet', onclick: () => askAgain('api/draws')}, 'Draw anew')),
      h('div', {class: isAsked ? 'nine old' : 'nine'}, Array.from({length: 9}, (unused, index) => {
        const each = pictures[index];
        return h(
            'div', {class: 'draw', title: each ? drawsText(each.draws) : null},
            each ? h('img', {src: each.picture, alt: `Draw ${index + 1}`}) : null);
      })));
}

function drawsText(draws = {}) {
  return Object.entries(draws).map(([name, value]) => `${name}: ${value}`).join('\n');
}

// A switch for something other than a setting that is true or false.
function switchFor(path, label, isOn, change, hint) {
  return h(
      'div', {class: 'field', key: path.join('/'), 'data-path': path.join('/')},
      h('label', {class: 'toggle plain'}, h('input', {
          type: 'checkbox',
          class: 'switch',
          role: 'switch',
          checked: isOn,
          onchange: (event) => change(event.target.checked),
        }),
        h('span', {}, label)),
      hint ? h('p', {class: 'hint'}, hint) : null);
}

// Settings name the preset themselves, or include config/randomize_default.yaml.
function usePreset(isOn) {
  set(root('preset'), isOn ? 'transfer' : undefined);
  const includes = [].concat(own(['include']) ?? []);
  const others = includes.filter((each) => !String(each).includes('randomize_default'));
  if (isOn || others.length === includes.length) return;
  set(['include'], others.length > 1 ? others : others[0]);
}

function preset() {
  return switchFor(
      root('preset'), 'For networks that are to work on photographs', effective(root('preset')) === 'transfer',
      usePreset,
      'Other light, paint, backgrounds, clutter and wear in each scene; without a world also rooms and cameras. ' +
          'Settings here override it.');
}

// Entries of a group by name: for every light, or for a single one.
function named(group, names, draw) {
  return h('div', {}, names.map((name, index) => {
    const path = root(group, name);
    const isSet = effective(path) !== undefined;
    if (index === 0) return h('div', {key: name}, draw(name));
    return h(
        'details', {key: name, opened: isSet, class: 'named'},
        h('summary', {}, name, isSet ? h('span', {class: 'dot', title: 'has entries of its own'}) : null), draw(name));
  }));
}

function namesIn(group, first, known) {
  return [...new Set([...first, ...known, ...Object.keys(effective(root(group)) ?? {})])];
}

function lights() {
  const known = (answer('api/world').value?.lights ?? [])
                    .map((each) => each.name ?? each)
                    .filter((each) => typeof each === 'string');
  return named('lights', namesIn('lights', ['every'], known), (name) => {
    const label = name === 'every' ? 'Every light\u2019s ' : '';
    const at = (entry) => root('lights', name, entry);
    const capital = (text) => (label ? label + text : text[0].toUpperCase() + text.slice(1));
    return [
      distribution(at('intensity'), {label: capital('brightness'), range: [0, 3], start: {uniform: [0.5, 1.3]}}),
      distribution(
          at('colour'),
          {label: capital('colour'), range: [0, 1], start: {uniform: [[0.85, 0.8, 0.65], [1, 1, 1]]}, isColour: true}),
      distribution(
          at('elevation'),
          {label: capital('height above the horizon'), range: [-1.57, 1.57], start: {uniform: [0.5, 1.35]}}),
      distribution(
          at('azimuth'), {label: capital('direction'), range: [-3.1416, 3.1416], start: {uniform: [-3.1416, 3.1416]}}),
      distribution(at('shift'), {label: capital('shift'), range: [-2, 2], start: {normal: [0, 0.2]}}),
      numberField(at('present'), {label: capital('chance to be on'), slider: true, step: 0.01, fallback: 1}),
    ];
  });
}

function light() {
  return [
    distribution(root('ambient'), {
      label: 'Light that is everywhere',
      start: {uniform: [[0.42, 0.42, 0.45], [0.68, 0.68, 0.68]]},
      isColour: true
    }),
    distribution(root('light_count'), {label: 'How many lights are on', range: [0, 10], start: {choice: [1, 2]}}),
  ];
}

function weather() {
  const at = (entry) => root('weather', entry);
  const isSet = ['visibility', 'rain', 'snow'].some((entry) => effective(at(entry)) !== undefined);
  return [
    distribution(at('visibility'), {label: 'Visibility in fog', range: [1, 1000], start: {log_uniform: [20, 500]}}),
    distribution(at('rain'), {label: 'Rain', range: [0, 100], start: {log_uniform: [2, 50]}}),
    distribution(at('snow'), {label: 'Snow, as water', range: [0, 10], start: {log_uniform: [0.2, 3]}}),
    distribution(at('dust'), {label: 'Dust on the lens, share', start: {log_uniform: [0.002, 0.05]}}),
    isSet ?
        [
          distribution(at('wind'), {label: 'Wind', range: [-20, 20], start: {normal: [[0, 0, 0], [2, 2, 0]]}}),
          distribution(at('colour'), {label: 'Colour of the air', start: {uniform: [0.6, 0.85]}, isColour: true}),
          numberField(at('present'), {label: 'Chance of any weather', slider: true, step: 0.01, fallback: 1}),
        ] :
        null,
  ];
}

function surfaces() {
  const names = namesIn('materials', ['world', 'objects', 'distractors'], []);
  return named('materials', names, (name) => {
    const at = (entry) => root('materials', name, entry);
    const of = {world: 'World\u2019s', objects: 'Objects\u2019', distractors: 'Clutter\u2019s'}[name] ??
        `${name}\u2019s`;
    return [
      distribution(at('tint'), {label: `${of} tint`, start: {uniform: [[0.6, 0.6, 0.6], [1, 1, 1]]}, isColour: true}),
      distribution(
          at('colour'), {label: `${of} colour`, start: {uniform: [[0.3, 0.3, 0.3], [1, 1, 1]]}, isColour: true}),
      distribution(at('roughness'), {label: `${of} roughness`, start: {uniform: [0.3, 1]}}),
      distribution(at('metalness'), {label: `${of} metalness`, start: {choice: [0, 1], weights: [4, 1]}}),
      fileField(at('textures'), 'folder', {label: `${of} textures`, placeholder: 'a folder, procedural or natural'}),
      choiceField(at('for_each'), null, {label: 'Drawn for each'}),
    ];
  });
}

function background() {
  const value = effective(root('background'));
  const isGroup = value !== undefined && typeof value === 'object' && !Array.isArray(value) &&
      !['uniform', 'normal', 'choice', 'log_uniform'].some((each) => each in value);
  return section(
      'Background',
      isGroup ?
          [
            fileField(
                root('background', 'pictures'), 'folder',
                {label: 'A folder of pictures', placeholder: 'a folder, or natural'}),
            choiceField(root('background', 'projection'), null, {label: 'They are'}),
            numberField(root('background', 'present'), {label: 'Chance of one', slider: true, step: 0.05, fallback: 1}),
            distribution(
                root('background', 'brightness'), {label: 'Brightness', range: [0, 3], start: {uniform: [0.7, 1.2]}}),
            distribution(
                root('background', 'colour'),
                {label: 'Colour without one', start: {uniform: [[0.3, 0.3, 0.3], [0.9, 0.9, 0.9]]}, isColour: true}),
            h('p', {class: 'buttons'},
              h('button', {type: 'button', onclick: () => set(root('background'), undefined)}, 'No background')),
          ] :
          [
            distribution(root('background'), {
              label: 'Colour behind everything',
              range: [0, 1],
              start: {uniform: [[0.3, 0.3, 0.3], [0.9, 0.9, 0.9]]},
              isColour: true
            }),
            h('p', {class: 'buttons'},
              h('button', {
                type: 'button',
                onclick: () => set(root('background'), {pictures: '', ...(value === undefined ? {} : {colour: value})})
              },
                'Pictures\u2026')),
          ]);
}

function objects() {
  return named('objects', namesIn('objects', ['every'], objectNames()), (name) => {
    const at = (entry) => root('objects', name, entry);
    return [
      numberField(at('present'), {
        label: name === 'every' ? 'Chance of every object to be there' : 'Chance to be there',
        slider: true,
        step: 0.01,
        fallback: 1
      }),
      name === 'every' ?
          null :
          [
            distribution(at('scale'), {label: 'Size', unit: 'times', range: [0.2, 3], start: {uniform: [0.8, 1.25]}}),
            flowField(at('model'), {label: 'Another model'}),
          ],
    ];
  });
}

function distractors() {
  const path = root('distractors');
  const isOn = effective(path) !== undefined;
  const at = (entry) => [...path, entry];
  const start = {volume: {min: [-4, -3, 0.1], max: [4, 3, 2.2]}, count: {uniform: [0, 8]}};
  return section(
      'Clutter',
      switchFor(
          path, 'Things without a label between the objects', isOn, (value) => set(path, value ? start : undefined)),
      isOn ? h('div', {}, distribution(at('count'), {label: 'How many', range: [0, 40], start: {uniform: [0, 8]}}),
               distribution(at('size'), {label: 'Size', range: [0.01, 2], start: {log_uniform: [0.08, 0.4]}}),
               choiceField(at('mode'), null, {label: 'They'}),
               h('div', {class: 'pair'},
                 vectorField([...at('volume'), 'min'], ['x', 'y', 'z'], {label: 'Box from', unit: 'm', hint: ''}),
                 vectorField([...at('volume'), 'max'], ['x', 'y', 'z'], {label: 'to', unit: 'm', hint: ''})),
               fileField(at('textures'), 'folder', {label: 'Their textures', placeholder: 'procedural'}),
               fileListField(at('models'), 'model', {label: 'Models instead', isList: true}),
               textField(at('class'), {label: 'Class, if they are to be labelled'}),
               numberField(at('pool'), {label: 'Different ones in the run', step: 1})) :
             null);
}
