// The frames of a recording on a time line: when each is known, its rate, how far it moves.
import {h} from './dom.js';
import {fixed} from './numbers.js';
import {frameOf, objectNames} from './store.js';
import {currentInstant, instantCount, secondsOf, show} from './view_state.js';

export function timeline(recording) {
  const {duration, frames} = recording;
  const rows = inOrder(frames);
  const used = new Set(objectNames().map(frameOf));
  const now = secondsOf(currentInstant());
  return h(
      'div', {class: 'timeline', role: 'table', 'aria-label': 'Frames of the recording'},
      h('div', {class: 'timeline-row head', role: 'row'},
        ['frame', 'rate', 'moves', `0 to ${fixed(duration, 1)} s`].map(
            (each, index) =>
                h('span',
                  {role: 'columnheader',
                   class: index === 0 ? 'frame' :
                       index < 3      ? 'figure' :
                                        ''},
                  each))),
      h('div', {class: 'timeline-rows', role: 'rowgroup', tabindex: '0', 'aria-label': 'Frames'},
        rows.map(({frame, depth}) => row(frame, depth, duration, now, used.has(frame.name)))));
}

// The frames in rows, with children below their parents.
function inOrder(frames) {
  const names = new Set(frames.map((each) => each.name));
  const below = new Map();
  for (const frame of frames) {
    const parent = names.has(frame.parent) && frame.parent !== frame.name ? frame.parent : '';
    below.set(parent, [...(below.get(parent) ?? []), frame]);
  }
  const rows = [];
  const add = (parent, depth) => {
    for (const frame of below.get(parent) ?? []) {
      rows.push({frame, depth});
      add(frame.name, depth + 1);
    }
  };
  add('', 0);
  return rows;
}

function row(frame, depth, duration, now, isUsed) {
  return h(
      'div', {key: frame.name, class: isUsed ? 'timeline-row used' : 'timeline-row', role: 'row'},
      h('span', {
        class: 'frame',
        role: 'rowheader',
        style: {'--depth': Math.min(depth, 6)},
        title: frame.parent ? `${frame.parent} \u2192 ${frame.name}` : frame.name
      },
        frame.name),
      h('span', {class: 'figure', role: 'cell'},
        frame.is_static                 ? 'static' :
            Number.isFinite(frame.rate) ? `${fixed(frame.rate, frame.rate < 10 ? 1 : 0)} Hz` :
                                          ''),
      h('span', {class: 'figure', role: 'cell'}, frame.is_static ? '' : movement(frame)),
      h('span', {class: 'track', role: 'cell', 'aria-label': spans(frame), onclick: (event) => jump(event, duration)},
        frame.is_static ?
            h('i', {class: 'known always', style: {'--from': 0, '--to': 1}}) :
            h('span', {},
              (frame.known ??
               []).map(([from,
                         to]) => h('i', {class: 'known', style: {'--from': from / duration, '--to': to / duration}}))),
        Number.isFinite(now) ? h('i', {class: 'now', style: {'--at': now / duration}}) : null));
}

function movement(frame) {
  if (frame.moved > 0.001) return `${fixed(frame.moved, frame.moved < 10 ? 2 : 0)} m`;
  return frame.turned > 0.001 ? `${Math.round(frame.turned * 180 / Math.PI)}\u00b0` : 'stands';
}

function spans(frame) {
  if (frame.is_static) return 'always known';
  return `known ${(frame.known ?? []).map(([from, to]) => `from ${fixed(from, 1)} to ${fixed(to, 1)} s`).join(', ')}`;
}

function jump(event, duration) {
  const box = event.currentTarget.getBoundingClientRect();
  const time = duration * (event.clientX - box.left) / box.width;
  let best = 0;
  for (let each = 0; each < instantCount(); ++each) {
    if (Math.abs(secondsOf(each) - time) < Math.abs(secondsOf(best) - time)) best = each;
  }
  show({instant: best});
}
