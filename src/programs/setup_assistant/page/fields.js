// A field is a setting: its name, its control, what the documentation says about it, and what is wrong with it.
import {chooseUnit, convertedAngles, DEGREES, inDegrees, shownAngles, writtenAngles} from './angles.js';
import {showDocument} from './doc_dialog.js';
import {h} from './dom.js';
import {parseFlow, parseScalar, printFlow} from './flow.js';
import {helpOf} from './help.js';
import {isEqual, keyOf} from './paths.js';
import {identity, problemsBelow, sentence} from './problems.js';
import {documentedPath, effective, own, parameter, set, sourceOf} from './store.js';

const SOURCES = {
  here: 'set in this file',
  included: 'from an included file',
  default: 'default'
};

export function idOf(path) {
  return `field-${keyOf(path).replace(/[^\w-]/g, '_')}`;
}

// {text, document, section} for whoever fills in the field; without a document, there is no more to read.
function descriptionOf(path, options) {
  if (options.hint !== undefined) return {text: options.hint.replace(/\[([^\]]+)\]\([^)]+\)/g, '$1')};
  return helpOf(documentedPath(path).join('/')) ?? {text: firstSentence(parameter(path)?.text ?? '')};
}

// The first sentence of a text from config/params.yaml, which is written for whoever reads that file.
function firstSentence(text) {
  const plain = text.replace(/^REQUIRED[^.]*\.\s*/, '').replace(/\s*\(docs\/[^)]*\)/g, '');
  return /^(.*?[.;:])(?:\s|$)/.exec(plain)?.[1].replace(/[;:]$/, '.') ?? plain;
}

function hint(path, options, id) {
  const {text, document, section} = descriptionOf(path, options);
  const label = `More about ${options.label ?? path.at(-1)}`;
  return h(
      'p', {class: 'hint', id}, withCode(text),
      document ?
          [
            ' ',
            h('button',
              {type: 'button', class: 'link more', 'aria-label': label, onclick: () => showDocument(document, section)},
              'More')
          ] :
          null);
}

// Shows `names` in backquotes as code.
function withCode(text) {
  return text.split('`').map((part, index) => (index % 2 ? h('code', {}, part) : part));
}

function defaultOf(path, options) {
  const default_value = options.fallback ?? parameter(path)?.default;
  const value = isAngle(path, options) ? shownAngles(default_value, inDegrees(effective(path))) : default_value;
  return typeof value === 'string' ? value : printFlow(value);
}

function unitNameOf(path, options) {
  return options.unit ?? parameter(path)?.unit;
}

export function isAngle(path, options) {
  return unitNameOf(path, options) === 'rad';
}

// The unit; for an angle, a button that switches between radians and degrees, also for the value in the file.
export function unitOf(path, options) {
  const unit = unitNameOf(path, options);
  if (!isAngle(path, options)) return unit ? h('span', {class: 'unit'}, ` [${unit}]`) : null;
  const isInDegrees = inDegrees(effective(path));
  const here = own(path);
  const change = () => {
    chooseUnit(!isInDegrees);
    const converted = convertedAngles(here, !isInDegrees);
    if (here !== undefined && !isEqual(converted, here)) set(path, converted);
  };
  return h(
      'button', {
        type: 'button',
        class: 'unit quiet',
        title: isInDegrees ? 'Show and write radians' : 'Show and write degrees',
        'aria-label': `${options.label ?? path.at(-1)} in ${isInDegrees ? 'radians' : 'degrees'}`,
        onclick: change,
      },
      isInDegrees ? '[deg]' : '[rad]');
}

function noteOf(path, source) {
  if (source === 'included') return 'included';
  return source !== 'here' && parameter(path)?.required ? 'required' : '';
}

// `control(props)` makes the element that is labelled; `props` has its id and its descriptions.
export function field(path, options, control) {
  const id = idOf(path);
  const problems = problemsBelow(path);
  const source = sourceOf(path);
  const props = {
    id,
    'aria-describedby': `${id}-hint ${id}-problems`,
    'aria-invalid': problems.some((each) => each.severity === 'error') ? 'true' : null,
  };
  const isGroup = options.isGroup === true;
  return h(
      'div', {
        key: keyOf(path),
        class: `field ${options.class ?? ''}`,
        'data-path': keyOf(path),
        'data-source': source,
        role: isGroup ? 'group' : null,
        'aria-labelledby': isGroup ? `${id}-label` : null,
      },
      h('div', {class: 'field-head'},
        h(isGroup ? 'span' : 'label', {class: 'field-label', id: `${id}-label`, 'for': isGroup ? null : id},
          options.label ?? String(path.at(-1)), isAngle(path, options) ? null : unitOf(path, options)),
        isAngle(path, options) ? unitOf(path, options) : null,
        h('span', {class: 'source', title: SOURCES[source]}, noteOf(path, source)), resetButton(path, options)),
      h('div', {class: 'control'}, control(props)), hint(path, options, `${id}-hint`),
      problemList(problems, `${id}-problems`));
}

function resetButton(path, options) {
  const isHere = own(path) !== undefined;
  return h(
      'button', {
        type: 'button',
        class: 'reset quiet',
        disabled: !isHere,
        title: 'Remove it from the file, so that the default applies',
        'aria-label': `Reset ${options.label ?? path.at(-1)}`,
        onclick: () => set(path, undefined),
      },
      '\u21ba');
}

export function problemList(problems, id = null) {
  return h(
      'ul', {class: 'problems', id, hidden: problems.length === 0},
      problems.map(
          (each) =>
              h('li', {class: each.severity, 'data-problem': identity(each)},
                h('span', {class: 'severity'}, each.severity), ' ', sentence(each),
                each.cure && h('span', {class: 'cure'}, `; ${each.cure}`))));
}

// --- Kinds of fields ---

export function textField(path, options = {}) {
  const list = options.suggestions?.length ? `${idOf(path)}-list` : null;
  return field(
      path, options,
      (props) =>
          [h('input', {
             ...props,
             type: 'text',
             list,
             spellcheck: 'false',
             autocomplete: 'off',
             placeholder: defaultOf(path, options),
             value: printText(effective(path)),
             onchange: (event) => setFromText(path, event.target.value),
           }),
           list && h('datalist', {id: list}, options.suggestions.map((each) => h('option', {value: each}))),
  ]);
}

export function printText(value) {
  return typeof value === 'string' && parseScalar(value) === value ? value : printFlow(value);
}

export function setFromText(path, text) {
  set(path, text.trim() === '' ? undefined : valueOfText(text));
}

// A text that begins like a list or a map is one if it can be read as such.
function valueOfText(text) {
  if (!/^\s*[[{]/.test(text)) return parseScalar(text);
  try {
    return parseFlow(text);
  } catch {
    return text;
  }
}

// options.slider: with a slider over the whole range.
export function numberField(path, options = {}) {
  const isInDegrees = isAngle(path, options) && inDegrees(effective(path));
  const scale = isInDegrees ? DEGREES : 1;
  const put = (value, step) => set(path, isInDegrees ? writtenAngles(value, true) : value, step);
  return field(path, options, (props) => {
    const value = effective(path);
    const input = h('input', {
      ...props,
      type: 'text',
      inputmode: 'decimal',
      class: 'number',
      spellcheck: 'false',
      autocomplete: 'off',
      placeholder: defaultOf(path, options),
      value: printFlow(isAngle(path, options) ? shownAngles(value, isInDegrees) : value),
      onchange: ({target}) => put(target.value.trim() === '' ? undefined : valueOfText(target.value)),
      onkeydown: (event) => stepByKey(event, path, isInDegrees ? 1 : options.step ?? 1, put),
    });
    const range = options.range ?? (options.slider ? parameter(path)?.range : null);
    return range ? [input, slider(path, {...options, range}, scale, put)] : input;
  });
}

// Arrow keys change a number as in a spin box.
function stepByKey(event, path, step, put) {
  const sign = {ArrowUp: 1, ArrowDown: -1}[event.key];
  const value = parseScalar(event.target.value || event.target.placeholder);
  if (!sign || typeof value !== 'number') return;
  event.preventDefault();
  event.target.isEdited = false;
  put(rounded(value + sign * step * (event.shiftKey ? 10 : 1)), `keys-${keyOf(path)}`);
}

export function rounded(value, digits = 6) {
  return Number(value.toFixed(digits));
}

let drags = 0;

// `scale`: the factor from the setting's unit to the one that is shown.
function slider(path, {range: [low, high], step, label, fallback}, scale, put) {
  const value = effective(path) ?? parameter(path)?.default ?? fallback;
  const shown = scale === 1 ? value : shownAngles(value, true);
  return h('input', {
    type: 'range',
    min: low * scale,
    max: high * scale,
    step: scale === 1 ? step ?? 'any' : 'any',
    'aria-label': `${label ?? path.at(-1)}, slider`,
    value: typeof shown === 'number' ? shown : low * scale,
    onpointerdown: () => {
      ++drags;
    },
    oninput: (event) => put(Number(event.target.value), `slider-${keyOf(path)}-${drags}`),
  });
}

// `choices`: texts, or [value, label] pairs; null: as documented. Up to four are shown as buttons, more as a list.
export function choiceField(path, choices, options = {}) {
  const pairs =
      (choices ?? parameter(path)?.choices ?? []).map((each) => (Array.isArray(each) ? each : [each, String(each)]));
  const value = effective(path) ?? options.fallback ?? parameter(path)?.default;
  const choose = options.choose ?? ((chosen) => set(path, chosen));
  if (pairs.length > 4) {
    return field(
        path, options,
        (props) =>
            h('select', {
              ...props,
              value: String(value ?? ''),
              onchange: (event) => choose(pairs[event.target.selectedIndex][0]),
            },
              pairs.map(([each, label]) => h('option', {value: String(each)}, label))));
  }
  return field(path, {...options, isGroup: true}, (props) => segments(props.id, pairs, value, choose));
}

export function segments(id, pairs, value, choose, describedBy = null) {
  return h(
      'div', {class: 'segments', id, 'aria-describedby': describedBy},
      pairs.map(
          ([each, label]) =>
              h('label', {class: 'segment'},
                h('input', {type: 'radio', name: id, checked: each === value, onchange: () => choose(each)}),
                h('span', {}, label))));
}

export function switchField(path, options = {}) {
  const value = effective(path) ?? options.fallback ?? parameter(path)?.default;
  return field(path, {...options, class: 'switch-field'}, (props) => h('input', {
                                                            ...props,
                                                            type: 'checkbox',
                                                            class: 'switch',
                                                            role: 'switch',
                                                            checked: value === true,
                                                            onchange: (event) => set(path, event.target.checked),
                                                          }));
}

export function vectorField(path, names, options = {}) {
  const values = effective(path) ?? options.value;
  const list = Array.isArray(values) ? values : [];
  const isInDegrees = isAngle(path, options) && inDegrees(values);
  const shown = isAngle(path, options) ? shownAngles(list, isInDegrees) : list;
  const put = (index, text, step) => {
    const typed = writtenAngles(parseScalar(text || '0'), isInDegrees);
    const all = names.map((name, at) => (at === index ? typed : list[at] ?? 0));
    set(path, isInDegrees ? convertedAngles(all, true) : all, step && `${step}-${keyOf(path)}-${index}`);
  };
  return field(
      path, {...options, isGroup: true},
      (props) =>
          h('div', {class: 'vector', id: props.id},
            names.map((name, index) => h('label', {class: 'component'}, h('span', {}, name), h('input', {
                                           type: 'text',
                                           inputmode: 'decimal',
                                           class: 'number',
                                           value: printFlow(roundedForEyes(shown[index])),
                                           'aria-describedby': props['aria-describedby'],
                                           autocomplete: 'off',
                                           placeholder: '0',
                                           onchange: (event) => put(index, event.target.value),
                                           onkeydown: (event) =>
                                               stepComponent(event, index, isInDegrees ? 1 : options.step ?? 0.1, put),
                                         })))));
}

function roundedForEyes(value) {
  return typeof value === 'number' ? rounded(value, 4) : value;
}

function stepComponent(event, index, step, put) {
  const sign = {ArrowUp: 1, ArrowDown: -1}[event.key];
  const value = parseScalar(event.target.value || '0');
  if (!sign || typeof value !== 'number') return;
  event.preventDefault();
  event.target.isEdited = false;
  put(index, String(rounded(value + sign * step * (event.shiftKey ? 10 : 1))), 'keys');
}

// Any value, as YAML in one line.
export function flowField(path, options = {}) {
  return field(path, options, (props) => h('input', {
                                ...props,
                                type: 'text',
                                class: 'code',
                                spellcheck: 'false',
                                autocomplete: 'off',
                                placeholder: defaultOf(path, options),
                                value: printFlow(effective(path)),
                                onchange: (event) => setFromFlow(path, event.target),
                              }));
}

function setFromFlow(path, input) {
  input.setCustomValidity('');
  if (input.value.trim() === '') return set(path, undefined);
  try {
    return set(path, parseFlow(input.value));
  } catch (error) {
    input.setCustomValidity(error.message);
    input.reportValidity();
    input.isEdited = true;  // what was typed stays, to be corrected
    return undefined;
  }
}

export function section(title, ...children) {
  return h('section', {class: 'group', key: title}, h('h2', {}, title), ...children);
}

// Rarely needed settings; closed until one of them is set or wrong.
export function more(title, paths, ...children) {
  const isUsed = paths.some((each) => own(each) !== undefined || problemsBelow(each).length > 0);
  return h('details', {class: 'group', key: title, opened: isUsed}, h('summary', {}, title), ...children);
}
