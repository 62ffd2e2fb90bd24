import {checkButton} from './check_button.js';
import {h} from './dom.js';
import {choiceField, more, numberField, problemList, rounded, section} from './fields.js';
import {fileField} from './file_fields.js';
import {bytes, duration, grouped} from './numbers.js';
import {problemsAt} from './problems.js';
import {effective, own, set, store} from './store.js';

export const outputPane = {
  id: 'output',
  title: 'Output',
  text: 'Where the dataset goes, how large it is, which scenes are for training, validation and test.',
  paths: () => [
      ['output_folder'], ['split'], ['if_exists'], ['sync'], ['processes'], ['shard'], ['only_scenes'], ['image'],
      ['masks'], ['background_subtractor']],
  summary: () => String(effective(['output_folder']) ?? ''),
  draw,
};

function draw() {
  return [
    section(
        'Where', fileField(['output_folder'], 'folder', {label: 'Folder'}),
        choiceField(
            ['if_exists'], [['resume', 'Go on'], ['overwrite', 'Overwrite'], ['error', 'Refuse']],
            {label: 'If there is a dataset'})),
    section('How large, how long', figures()),
    section('Splits', h('div', {'data-path': 'split', class: 'field'}, problemList(problemsAt(['split'])), split())),
    more(
        'Images', [['image', 'png_compression'], ['image', 'jpeg_quality']],
        numberField(['image', 'png_compression'], {label: 'PNG compression', slider: true, step: 1}),
        numberField(['image', 'jpeg_quality'], {label: 'JPEG quality', slider: true, step: 1})),
    more(
        'Masks', [['masks', 'method'], ['background_subtractor']],
        choiceField(
            ['masks', 'method'], [['exact', 'exact'], ['mog2', 'mog2']],
            {label: 'Method', fallback: effective(['background_subtractor']) === undefined ? 'exact' : 'mog2'}),
        numberField(['background_subtractor', 'history_length'], {label: 'Pictures to train on', step: 1}),
        numberField(['background_subtractor', 'var_threshold'], {label: 'Threshold', step: 1})),
    more(
        'Processes, parts', [['processes'], ['sync'], ['shard'], ['only_scenes']],
        numberField(['processes'], {label: 'Processes', step: 1}),
        choiceField(['sync'], null, {label: 'Waits for the disk'}),
        h('div', {class: 'pair'}, numberField(['shard', 'index'], {label: 'Shard', step: 1}),
          numberField(['shard', 'count'], {label: 'of', step: 1}))),
  ];
}

function figures() {
  const {scenes, bytes: size, seconds, memory, free_bytes: free} = store.setup?.figures ?? {};
  const rows = [
    ['Scenes', Number.isFinite(scenes) ? grouped(scenes) : null],
    [
      'On disk',
      Number.isFinite(size) ? `${bytes(size)}${Number.isFinite(free) ? ` of ${bytes(free)} free` : ''}` : null
    ],
    ['Takes', Number.isFinite(seconds) ? `about ${duration(seconds)}` : null],
    ['Memory', Number.isFinite(memory) ? bytes(memory) : null],
  ];
  return [
    h('dl', {class: 'figures'},
      rows.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value ?? '\u2013')))),
    h('p', {class: 'buttons'}, checkButton(), h('span', {class: 'muted'}, 'It measures what a run takes.')),
  ];
}

const PARTS = ['train', 'val', 'test'];

function split() {
  const value = effective(['split']);
  if (value === undefined) {
    return h(
        'p', {class: 'buttons'}, h('span', {class: 'muted'}, 'All scenes are in one.'),
        h('button', {type: 'button', onclick: () => set(['split'], {train: 0.8, val: 0.1, test: 0.1})}, 'Divide them'));
  }
  const counts = store.setup?.figures?.splits ?? {};
  const shares = PARTS.map((each) => Number(value[each] ?? 0));
  return [
    h('div', {class: 'split-bar', 'aria-hidden': 'true'},
      PARTS.map(
          (each, index) => h('i', {class: each, style: {'--share': shares[index]}}, shares[index] > 0.08 ? each : ''))),
    h('div', {class: 'triple'},
      PARTS.map((each) => numberField(['split', each], {
                  label: each,
                  unit: Number.isFinite(counts[each]) ? `${grouped(counts[each])} scenes` : '',
                  step: 0.05,
                  fallback: 0,
                  hint: '',
                }))),
    Math.abs(shares.reduce((sum, each) => sum + each, 0) - 1) > 1e-9 ?
        h('p', {class: 'buttons'},
          h('button', {type: 'button', onclick: () => complete(value, shares)}, 'Make them add up to 1')) :
        null,
    choiceField(['split', 'by'], [['blocks', 'Blocks in time'], ['scenes', 'At random']], {
      label: 'Divided by',
      fallback: 'blocks',
      hint: 'Neighbours in time look alike, so blocks test more honestly.'
    }),
    numberField(['split', 'gap'], {label: 'Left out between blocks', unit: 's', step: 0.5, fallback: 0, hint: ''}),
    own(['split']) === undefined ?
        null :
        h('p', {class: 'buttons'},
          h('button', {type: 'button', onclick: () => set(['split'], undefined)}, 'Do not divide')),
  ];
}

function complete(value, shares) {
  const sum = shares.reduce((total, each) => total + each, 0) || 1;
  const parts = PARTS.map((each, index) => [each, rounded(shares[index] / sum, 4)]).filter(([, share]) => share > 0);
  set(['split'], {...value, ...Object.fromEntries(parts)});
}
