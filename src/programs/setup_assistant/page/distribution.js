// The editor of a distribution: what is drawn for each scene (docs/randomize.md).
import {DEGREES, inDegrees, shownAngles, writtenAngles} from './angles.js';
import {h} from './dom.js';
import {idOf, isAngle, problemList, rounded, unitOf} from './fields.js';
import {parseFlow, printFlow} from './flow.js';
import {keyOf} from './paths.js';
import {problemsBelow} from './problems.js';
import {effective, own, parameter, set} from './store.js';

const KINDS = [
  ['off', 'off'], ['fixed', 'always'], ['uniform', 'uniform'], ['log_uniform', 'log-uniform'], ['normal', 'normal'],
  ['choice', 'one of']
];

function kindOf(value) {
  if (value === undefined) return 'off';
  if (value !== null && typeof value === 'object' && !Array.isArray(value)) {
    return KINDS.map(([kind]) => kind).find((kind) => kind in value) ?? 'fixed';
  }
  return 'fixed';
}

// options: label; range: [low, high] of the sliders, if not all that is allowed; start: the value when it is turned on;
// isColour; isAlways: it cannot be off, and is `start` by default.
export function distribution(path, given) {
  const options = inShownUnit(path, {range: parameter(path)?.range, ...given});
  const id = idOf(path);
  const value = options.shown(effective(path)) ?? (options.isAlways ? options.start : undefined);
  const kind = kindOf(value);
  const problems = problemsBelow(path);
  const text = parameter(path)?.text ?? '';
  return h(
      'div', {
        key: keyOf(path),
        class: kind === 'off' ? 'distribution off' : 'distribution',
        'data-path': keyOf(path),
        role: 'group',
        'aria-labelledby': `${id}-label`,
      },
      h('div', {class: 'distribution-head'},
        h('label', {class: 'toggle plain', title: text}, h('input', {
            type: 'checkbox',
            class: 'switch',
            role: 'switch',
            checked: kind !== 'off',
            id,
            disabled: options.isAlways && own(path) === undefined,
            title: options.isAlways ? 'Off: the default' : null,
            onchange: (event) => options.put(event.target.checked ? options.start : undefined),
          }),
          h('span', {id: `${id}-label`}, options.label, isAngle(path, options) ? null : unitOf(path, options))),
        isAngle(path, options) ? unitOf(path, options) : null,
        h('select', {
          'aria-label': `${options.label}: kind`,
          disabled: kind === 'off',
          value: kind,
          onchange: (event) => options.put(converted(value, event.target.value, options)),
        },
          KINDS.filter(([each]) => (each === 'off') === (kind === 'off'))
              .map(([each, label]) => h('option', {value: each}, label)))),
      kind === 'off' ? null : h('div', {class: 'distribution-body'}, body(path, kind, value, options)),
      problemList(problems));
}

// Adds `shown`, which converts a value from the settings for display, and `put`, which writes one; range and start are
// in the unit that is shown.
function inShownUnit(path, options) {
  if (!isAngle(path, options)) {
    return {...options, shown: (value) => value, put: (value, how) => set(path, value, how)};
  }
  const isInDegrees = inDegrees(effective(path));
  return {
    ...options,
    range: options.range.map((each) => (isInDegrees ? rounded(each * DEGREES, 0) : each)),
    start: shownAngles(options.start, isInDegrees),
    shown: (value) => shownAngles(value, isInDegrees),
    put: (value, how) => set(path, writtenAngles(value, isInDegrees), how),
  };
}

function body(path, kind, value, options) {
  const numbers = kind === 'fixed' ? [value] : value[kind];
  if (options.isColour && isColourPair(kind, numbers)) return colours(path, kind, numbers, options);
  if (['uniform', 'log_uniform'].includes(kind) && isNumbers(numbers, 2))
    return twoSliders(path, kind, numbers, options);
  if (kind === 'fixed' && typeof value === 'number') return oneSlider(path, value, options);
  if (kind === 'normal' && isNumbers(numbers, 2)) return meanAndSpread(path, value, options);
  return text(path, value, options);
}

function isNumbers(list, count) {
  return Array.isArray(list) && list.length === count && list.every((each) => typeof each === 'number');
}

function text(path, value, options) {
  return h('input', {
    type: 'text',
    class: 'code',
    'aria-label': options.label,
    value: printFlow(value),
    spellcheck: 'false',
    onchange: (event) => {
      try {
        event.target.setCustomValidity('');
        options.put(parseFlow(event.target.value));
      } catch (error) {
        event.target.setCustomValidity(error.message);
        event.target.reportValidity();
        event.target.isEdited = true;
      }
    },
  });
}

let drags = 0;

function step(path) {
  return `slider-${keyOf(path)}-${drags}`;
}

function precision([low, high]) {
  return high - low > 5 ? 2 : 3;
}

function range(label, value, [low, high], onchange) {
  return h('input', {
    type: 'range',
    min: Math.min(low, value),
    max: Math.max(high, value),
    step: 'any',
    value,
    'aria-label': label,
    onpointerdown: () => {
      ++drags;
    },
    oninput: (event) => onchange(Number(event.target.value)),
  });
}

function numberBox(label, value, onchange) {
  return h('input', {
    type: 'text',
    inputmode: 'decimal',
    class: 'number',
    'aria-label': label,
    value: printFlow(value),
    autocomplete: 'off',
    onchange: (event) => onchange(parseFlow(event.target.value || '0')),
  });
}

function twoSliders(path, kind, [low, high], options) {
  const digits = precision(options.range);
  const put = (pair, how) =>
      options.put({[kind]: pair.map((each) => (typeof each === 'number' ? rounded(each, digits) : each))}, how);
  const floor = kind === 'log_uniform' ? 0.001 : -Infinity;
  const part = (each) => (each - options.range[0]) / (options.range[1] - options.range[0]);
  return h(
      'div', {class: 'low-high'}, numberBox(`${options.label}, lowest`, low, (value) => put([value, high])),
      h('div', {class: 'two-sliders', style: {'--low': Math.max(0, part(low)), '--high': Math.min(1, part(high))}},
        range(
            `${options.label}, lowest, slider`, low, options.range,
            (value) => put([Math.max(floor, Math.min(value, high)), high], step(path))),
        range(
            `${options.label}, highest, slider`, high, options.range,
            (value) => put([low, Math.max(value, low)], step(path)))),
      numberBox(`${options.label}, highest`, high, (value) => put([low, value])));
}

function oneSlider(path, value, options) {
  return h(
      'div', {class: 'low-high one'},
      range(
          `${options.label}, slider`, value, options.range,
          (each) => options.put(rounded(each, precision(options.range)), step(path))),
      numberBox(options.label, value, (each) => options.put(each)));
}

function meanAndSpread(path, value, options) {
  const [mean, spread] = value.normal;
  const put = (pair, how) =>
      options.put({...value, normal: pair.map((each) => rounded(each, precision(options.range)))}, how);
  const widest = (options.range[1] - options.range[0]) / 2;
  return h(
      'div', {class: 'normal'},
      h('div', {class: 'low-high one'}, h('span', {class: 'name'}, 'mean'),
        range(`${options.label}, mean, slider`, mean, options.range, (each) => put([each, spread], step(path))),
        numberBox(`${options.label}, mean`, mean, (each) => put([each, spread]))),
      h('div', {class: 'low-high one'}, h('span', {class: 'name'}, 'std'),
        range(
            `${options.label}, standard deviation, slider`, spread, [0, widest],
            (each) => put([mean, each], step(path))),
        numberBox(`${options.label}, standard deviation`, spread, (each) => put([mean, each]))));
}

// --- Colours: between two, or always one ---

function isColour(value) {
  return Array.isArray(value) && value.length === 3 &&
      value.every((each) => typeof each === 'number' && each >= 0 && each <= 1);
}

function isColourPair(kind, numbers) {
  return (kind === 'fixed' && isColour(numbers[0])) ||
      (kind === 'uniform' && numbers.length === 2 && numbers.every(isColour));
}

function colours(path, kind, list, options) {
  const put = (index, colour, how) => {
    const next = list.map((each, at) => (at === index ? colour : each));
    // Each channel is drawn between those of the two.
    options.put(kind === 'fixed' ? next[0] : {uniform: orderedChannels(next)}, how);
  };
  return h(
      'div', {class: 'colours'},
      list.map(
          (colour, index) =>
              h('label', {}, h('span', {class: 'name'}, kind === 'fixed' ? '' : ['from', 'to'][index]), h('input', {
                  type: 'color',
                  value: hexOf(colour),
                  'aria-label': `${options.label}${kind === 'fixed' ? '' : [', from', ', to'][index]}`,
                  onchange: (event) => put(index, colourOfHex(event.target.value)),
                }),
                h('code', {}, colour.map((each) => rounded(each, 2)).join(' ')))));
}

function orderedChannels([low, high]) {
  return [low.map((each, at) => Math.min(each, high[at])), low.map((each, at) => Math.max(each, high[at]))];
}

function hexOf(colour) {
  return `#${colour.map((each) => Math.round(each * 255).toString(16).padStart(2, '0')).join('')}`;
}

function colourOfHex(text) {
  return [1, 3, 5].map((at) => rounded(parseInt(text.slice(at, at + 2), 16) / 255, 3));
}

// --- From one kind to another, with about the same values ---

function converted(value, kind, options) {
  const [low, high] = boundsOf(value, options);
  const half = (a, b) => (Array.isArray(a) ? a.map((each, at) => half(each, b[at])) : rounded((a + b) / 2, 4));
  const spread = (a, b) =>
      (Array.isArray(a) ? a.map((each, at) => spread(each, b[at])) : rounded(Math.abs(b - a) / 4, 4));
  if (kind === 'fixed') return half(low, high);
  if (kind === 'normal') return {normal: [half(low, high), spread(low, high)]};
  if (kind === 'choice') return {choice: [low, high]};
  if (kind === 'log_uniform') return {log_uniform: [positive(low), positive(high)]};
  return {uniform: [low, high]};
}

function positive(value) {
  return Array.isArray(value) ? value.map(positive) : Math.max(value, 0.01);
}

function boundsOf(value, options) {
  const kind = kindOf(value);
  const list = value?.[kind];
  const around = (mean, spread, sign) =>
      (Array.isArray(mean) ? mean.map((each, at) => around(each, Array.isArray(spread) ? spread[at] : spread, sign)) :
                             rounded(mean + sign * 2 * spread, 4));
  if (kind === 'fixed') return [value, value];
  if (kind === 'normal') return [around(list[0], list[1], -1), around(list[0], list[1], 1)];
  if (Array.isArray(list) && list.length) return [list[0], list.at(-1)];
  return boundsOf(options.start, options);
}
