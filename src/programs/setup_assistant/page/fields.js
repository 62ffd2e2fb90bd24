// A field is a setting: its name, its control, what the documentation says of it, and what is wrong with it.
import {h} from './dom.js';
import {browse} from './file_dialog.js';
import {parseFlow, parseScalar, printFlow} from './flow.js';
import {keyOf} from './paths.js';
import {identity, problemsBelow, sentence} from './problems.js';
import {effective, own, parameter, set, sourceOf} from './store.js';

const SOURCES = {
  here: 'set in this file',
  included: 'from an included file',
  default: 'default'
};

export function idOf(path) {
  return `field-${keyOf(path).replace(/[^\w-]/g, '_')}`;
}

function descriptionOf(path, options) {
  return options.hint ?? (parameter(path)?.text ?? '').replace(/^REQUIRED[^.]*\.\s*/, '');
}

// `a name` in the documentation is code.
function withCode(text) {
  return text.split('`').map((part, index) => (index % 2 ? h('code', {}, part) : part));
}

function defaultOf(path, options) {
  const value = options.fallback ?? parameter(path)?.default;
  return typeof value === 'string' ? value : printFlow(value);
}

export function unitOf(path, options) {
  const unit = options.unit ?? parameter(path)?.unit;
  return unit ? h('span', {class: 'unit'}, ` [${unit}]`) : null;
}

function noteOf(path, source) {
  if (source === 'included') return 'included';
  return source !== 'here' && parameter(path)?.required ? 'required' : '';
}

// `control(props)` makes the element that is labelled; `props` has its id and its descriptions.
function field(path, options, control) {
  const id = idOf(path);
  const problems = problemsBelow(path);
  const source = sourceOf(path);
  const text = descriptionOf(path, options);
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
          options.label ?? String(path.at(-1)), unitOf(path, options)),
        h('span', {class: 'source', title: SOURCES[source]}, noteOf(path, source)), resetButton(path, options)),
      h('div', {class: 'control'}, control(props)),
      h('p', {class: 'hint', id: `${id}-hint`, title: text.length > 150 ? text : null, onclick: unfold},
        withCode(text)),
      problemList(problems, `${id}-problems`));
}

function unfold(event) {
  event.currentTarget.classList.toggle('unfolded');
}

function resetButton(path, options) {
  const isHere = own(path) !== undefined;
  return h(
      'button', {
        type: 'button',
        class: 'reset quiet',
        disabled: !isHere,
        title: 'Remove it from the file, so that the default counts',
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

function printText(value) {
  return typeof value === 'string' && parseScalar(value) === value ? value : printFlow(value);
}

function setFromText(path, text) {
  set(path, text.trim() === '' ? undefined : valueOfText(text));
}

// What begins like a list or a map is one if it can be read as one.
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
  return field(path, options, (props) => {
    const input = h('input', {
      ...props,
      type: 'text',
      inputmode: 'decimal',
      class: 'number',
      spellcheck: 'false',
      autocomplete: 'off',
      placeholder: defaultOf(path, options),
      value: printFlow(effective(path)),
      onchange: (event) => setFromText(path, event.target.value),
      onkeydown: (event) => stepByKey(event, path, options.step ?? 1),
    });
    const range = options.range ?? (options.slider ? parameter(path)?.range : null);
    return range ? [input, slider(path, {...options, range})] : input;
  });
}

// Arrow keys change a number as in a spin box.
function stepByKey(event, path, step) {
  const sign = {ArrowUp: 1, ArrowDown: -1}[event.key];
  const value = parseScalar(event.target.value || event.target.placeholder);
  if (!sign || typeof value !== 'number') return;
  event.preventDefault();
  event.target.isEdited = false;
  set(path, rounded(value + sign * step * (event.shiftKey ? 10 : 1)), `keys-${keyOf(path)}`);
}

export function rounded(value, digits = 6) {
  return Number(value.toFixed(digits));
}

let drags = 0;

function slider(path, {range: [low, high], step, label, fallback}) {
  const value = effective(path) ?? parameter(path)?.default ?? fallback;
  return h('input', {
    type: 'range',
    min: low,
    max: high,
    step: step ?? 'any',
    'aria-label': `${label ?? path.at(-1)}, slider`,
    value: typeof value === 'number' ? value : low,
    onpointerdown: () => {
      ++drags;
    },
    oninput: (event) => set(path, Number(event.target.value), `slider-${keyOf(path)}-${drags}`),
  });
}

// `choices`: texts, or [value, label] pairs; null: as documented. Few of them are buttons, many a list.
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
  return field(
      path, {...options, isGroup: true},
      (props) =>
          h('div', {class: 'vector', id: props.id},
            names.map(
                (name, index) =>
                    h('label', {class: 'component'}, h('span', {}, name), h('input', {
                        type: 'text',
                        inputmode: 'decimal',
                        class: 'number',
                        value: printFlow(roundedForEyes(list[index])),
                        'aria-describedby': props['aria-describedby'],
                        autocomplete: 'off',
                        placeholder: '0',
                        onchange: (event) => setComponent(path, names, list, index, event.target.value),
                        onkeydown: (event) => stepComponent(event, path, names, list, index, options.step ?? 0.1),
                      })))));
}

function roundedForEyes(value) {
  return typeof value === 'number' ? rounded(value, 4) : value;
}

function stepComponent(event, path, names, list, index, step) {
  const sign = {ArrowUp: 1, ArrowDown: -1}[event.key];
  const value = parseScalar(event.target.value || '0');
  if (!sign || typeof value !== 'number') return;
  event.preventDefault();
  event.target.isEdited = false;
  setComponent(path, names, list, index, String(rounded(value + sign * step * (event.shiftKey ? 10 : 1))), 'keys');
}

function setComponent(path, names, list, index, text, step) {
  const values = names.map((name, each) => list[each] ?? 0);
  values[index] = parseScalar(text || '0');
  set(path, values, step && `${step}-${keyOf(path)}-${index}`);
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
    input.isEdited = true;  // what was typed stays, to be mended
    return undefined;
  }
}

export function fileField(path, kind, options = {}) {
  return field(
      path, options,
      (props) =>
          h('div', {class: 'with-button'}, h('input', {
              ...props,
              type: 'text',
              spellcheck: 'false',
              autocomplete: 'off',
              placeholder: options.placeholder ?? '',
              value: printText(effective(path)),
              onchange: (event) => setFromText(path, event.target.value),
            }),
            h('button', {
              type: 'button',
              onclick: () => pick(kind, {...options, current: effective(path)}, (file) => set(path, file))
            },
              'Browse\u2026')));
}

async function pick(kind, options, use) {
  const file = await browse(kind, options.label ?? kind, options.current);
  if (file) use(file);
}

// A file or several: a text or a list of texts.
export function fileListField(path, kind, options = {}) {
  const value = effective(path);
  const files = value === undefined ? [] : [].concat(value);
  const put = (list) =>
      set(path,
          list.length === 0                        ? undefined :
              list.length === 1 && !options.isList ? list[0] :
                                                     list);
  const add = (file) => put([...files, file]);
  return field(
      path, {...options, isGroup: true},
      (props) =>
          h('div', {class: 'file-list', id: props.id},
            h('div', {},
              files.map(
                  (file, index) =>
                      h('div', {class: 'with-button'}, h('input', {
                          type: 'text',
                          value: String(file),
                          spellcheck: 'false',
                          autocomplete: 'off',
                          'aria-label': `${options.label ?? path.at(-1)} ${index + 1}`,
                          'aria-describedby': props['aria-describedby'],
                          'aria-invalid': props['aria-invalid'],
                          onchange: (event) => put(files.map((each, at) => (at === index ? event.target.value : each))),
                        }),
                        h('button', {
                          type: 'button',
                          class: 'quiet',
                          'aria-label': `Remove ${file}`,
                          onclick: () => put(files.filter((each, at) => at !== index))
                        },
                          '\u00d7')))),
            h('button', {type: 'button', onclick: () => pick(kind, options, add)},
              files.length ? 'Add\u2026' : 'Browse\u2026')));
}

export function section(title, ...children) {
  return h('section', {class: 'group', key: title}, h('h2', {}, title), ...children);
}

// Rarely needed settings; closed until one of them is set or wrong.
export function more(title, paths, ...children) {
  const isUsed = paths.some((each) => own(each) !== undefined || problemsBelow(each).length > 0);
  return h('details', {class: 'group', key: title, opened: isUsed}, h('summary', {}, title), ...children);
}
