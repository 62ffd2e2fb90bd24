import {h} from './dom.js';
import {choiceField, flowField, more, numberField, section, textField} from './fields.js';
import {map} from './figure_map.js';
import {timeline} from './figure_timeline.js';
import {fileListField} from './file_fields.js';
import {greeting, greets} from './greeting.js';
import {count, duration, fileName} from './numbers.js';
import {chooseMotion, isPlaced, PLACEMENT_PATHS, placementFields, placementSummary} from './placement_fields.js';
import {waysOfObjects} from './recording.js';
import {answer, effective} from './store.js';

const PATHS = [
  'bag_file', 'simulated_rate', 'start_offset', 'duration', 'when_unknown', 'max_tf_gap', 'stretch', 'tf_topics',
  'pose_topics', 'global_frame', 'motions'
];

const WHEN_UNKNOWN = [['skip_scene', 'No scenes'], ['absent', 'Scenes without it']];

export const recordingPane = {
  id: 'recording',
  title: 'Recording',
  text: 'Where objects are: as in a bag with the TF tree or, without one, placed at random.',
  paths: () => [...PATHS.map((each) => [each]), ...PLACEMENT_PATHS],
  summary: () => (isPlaced() ? placementSummary() : [].concat(effective(['bag_file']) ?? []).map(fileName).join(', ')),
  draw,
};

function draw() {
  if (greets()) return [greeting()];
  if (isPlaced()) return [motionChoice(), ...placementFields()];
  const {value: recording, error} = answer('api/recording');
  const frames = (recording?.frames ?? []).map((each) => each.name);
  const roots = [...new Set(
      (recording?.frames ?? []).map((each) => each.parent).filter((each) => each && !frames.includes(each)))];
  const length = recording?.duration;
  return [
    motionChoice(),
    section('Bags', fileListField(['bag_file'], 'bag', {label: 'Bags'})),
    section(
        'What is in it', error ? h('p', {class: 'empty'}, error) : null,
        !recording && !error ? h('div', {class: 'placeholder'}, 'Reading the recording\u2026') : null,
        recording ? h('p', {class: 'facts'}, facts(recording)) : null, recording ? timeline(recording) : null,
        recording ? waysMap() : null),
    section(
        'Scenes', numberField(['simulated_rate'], {label: 'Scenes a second', range: [0.5, 30], step: 0.5}),
        h('div', {class: 'pair'},
          numberField(
              ['start_offset'],
              {label: 'Left out at the start', range: length ? [0, length] : null, step: 0.1, fallback: 0}),
          numberField(
              ['duration'],
              {label: 'Used after that', range: length ? [0.1, length] : null, step: 0.1, fallback: 'all'})),
        textField(['global_frame'], {label: 'Frame of the world', suggestions: [...roots, ...frames]})),
    more(
        'Gaps, stretches, other topics',
        [['when_unknown'], ['max_tf_gap'], ['stretch'], ['tf_topics'], ['pose_topics']],
        choiceField(['when_unknown'], WHEN_UNKNOWN, {label: 'While an object\u2019s frame is not known'}),
        numberField(['max_tf_gap'], {label: 'Longest gap in TF', step: 0.1, fallback: 'by frame'}),
        numberField(['stretch'], {label: 'Stretch', fallback: 'the longest'}),
        flowField(['tf_topics'], {label: 'Topics with TF', fallback: ['/tf', '/tf_static']}),
        flowField(['pose_topics'], {label: 'Other topics with poses', fallback: 'where one has it'})),
    severalMotions(),
  ];
}

function motionChoice() {
  return choiceField(
      ['motion'], [['bag', 'Follow a recording'], ['placement', 'Place at random']],
      {label: 'Objects\u2019 poses', fallback: 'bag', choose: chooseMotion});
}

function facts(recording) {
  const topics = recording.topics?.length ? `, ${count(recording.topics.length, 'topic')}` : '';
  return `${duration(recording.duration)}, ${count(recording.frames.length, 'frame')}${topics}`;
}

function waysMap() {
  const {value: world} = answer('api/world');
  return map(
      {picture: world?.map, extent: world?.map_extent, ways: waysOfObjects(), label: 'Ways of the objects from above'});
}

function severalMotions() {
  const motions = effective(['motions']);
  if (!Array.isArray(motions)) return null;
  return section(
      'Several motions',
      h('p', {class: 'hint'},
        'This file makes one dataset of several motions. The panes show what they share; a motion\u2019s own settings are changed in the text of the file.'),
      h('ul', {class: 'chips'}, motions.map((each) => h('li', {}, String(each?.name ?? '?')))));
}
