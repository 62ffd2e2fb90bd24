// The settings file as text. What a click has changed is marked; what is typed is sent, and changes the form.
import {h, patch} from './dom.js';
import {report, setText, store} from './store.js';
import {show, view} from './view_state.js';
import {lineOf} from './yaml_lines.js';

const PAUSE = 400;  // [ms] without a key before the text is sent

const editor = {
  text: null,
  typed: null,
  base: 0,
  timer: 0,
  session: 0,
  mark: null,
  conflict: false
};

export function drawYaml() {
  const {state} = store;
  if (!state) return;
  takeText(state.text);
  const error = state.error;
  const text = editor.typed ?? state.text;
  patch(document.getElementById('yaml'), [
    h('header', {class: 'yaml-head'},
      h('button', {
        type: 'button',
        class: 'quiet disclosure',
        'aria-expanded': String(view.isYamlOpen),
        'aria-controls': 'yaml-body',
        onclick: () => show({isYamlOpen: !view.isYamlOpen}),
      },
        view.isYamlOpen ? '\u25be' : '\u25b8', ' Settings file'),
      h('span', {class: 'yaml-state', role: 'status'}, statusText(error))),
    h('div', {class: 'yaml-body', id: 'yaml-body', hidden: !view.isYamlOpen},
      h('div', {class: 'yaml-scroll'}, h('pre', {class: 'line-numbers', 'aria-hidden': 'true'}, lineNumbers(text)),
        h('div', {class: 'yaml-text'}, mark(editor.mark, 'changed'),
          error ? mark([error.line ?? 1, error.line ?? 1], 'wrong') : null, h('textarea', {
            id: 'yaml-input',
            spellcheck: 'false',
            wrap: 'off',
            autocapitalize: 'off',
            'aria-label': 'Settings file, YAML',
            'aria-invalid': error ? 'true' : null,
            rows: lineCount(text),
            value: text,
            oninput,
            onblur,
            onkeydown,
          })))),
    editor.conflict ? conflict() : null,
  ]);
}

function statusText(error) {
  if (editor.typed !== null && !error) return 'typing\u2026';
  if (error) return `line ${error.line ?? '?'}: ${error.message}`;
  return `saved, revision ${store.state.revision}`;
}

function lineCount(text) {
  return text.split('\n').length;
}

function lineNumbers(text) {
  return Array.from({length: lineCount(text)}, (unused, index) => index + 1).join('\n');
}

function mark(lines, kind) {
  if (!lines) return null;
  return h('div', {class: `mark ${kind}`, style: {'--first': lines[0] - 1, '--count': lines[1] - lines[0] + 1}});
}

// Marks and shows the lines in which a text differs from the one before, unless they were typed here.
function takeText(text) {
  if (text === editor.text) return;
  const isFirst = editor.text === null;
  const isTyped = editor.typed !== null || document.activeElement?.id === 'yaml-input';
  editor.mark = isFirst || isTyped ? null : changedLines(editor.text, text);
  editor.text = text;
  if (editor.mark) requestAnimationFrame(() => scrollToLine(editor.mark[0]));
}

function changedLines(before, after) {
  const [a, b] = [before.split('\n'), after.split('\n')];
  let first = 0;
  while (first < b.length && a[first] === b[first]) ++first;
  let end = 0;
  while (end < Math.min(a.length, b.length) - first && a[a.length - 1 - end] === b[b.length - 1 - end]) ++end;
  return b.length - end > first ? [first + 1, b.length - end] : null;
}

function scrollToLine(line) {
  const box = document.querySelector('.yaml-scroll');
  if (!box) return;
  const height = parseFloat(getComputedStyle(box).lineHeight);
  const top = (line - 1) * height;
  if (top < box.scrollTop || top > box.scrollTop + box.clientHeight - 2 * height) {
    box.scrollTop = Math.max(0, top - box.clientHeight / 3);
  }
}

// Marks where a setting is, unless something is being typed.
export function showSetting(path) {
  const line = editor.typed === null && store.state ? lineOf(store.state.text, path) : null;
  if (!line) return;
  editor.mark = [line, line];
  drawYaml();
  scrollToLine(line);
}

export function goToLine(line) {
  show({isYamlOpen: true});
  requestAnimationFrame(() => {
    const input = document.getElementById('yaml-input');
    const start = input.value.split('\n').slice(0, line - 1).join('\n').length + (line > 1 ? 1 : 0);
    input.focus({preventScroll: true});
    input.setSelectionRange(start, start);
    scrollToLine(line);
  });
}

function oninput(event) {
  if (editor.typed === null) editor.base = store.state.revision;
  editor.typed = event.target.value;
  event.target.isEdited = false;  // this field tracks by itself what is being typed
  event.target.rows = lineCount(editor.typed);
  clearTimeout(editor.timer);
  editor.timer = setTimeout(send, PAUSE);
  drawYaml();
}

function onblur() {
  clearTimeout(editor.timer);
  ++editor.session;
  if (editor.typed !== null && !editor.conflict) send();
}

// Enter keeps the indentation. Tab leaves the field, as everywhere.
function onkeydown(event) {
  if (event.key !== 'Enter' || event.isComposing || event.ctrlKey) return;
  const {value, selectionStart, selectionEnd} = event.target;
  const indent = /^ */.exec(value.slice(value.lastIndexOf('\n', selectionStart - 1) + 1, selectionStart))[0];
  if (!indent) return;
  event.preventDefault();
  event.target.setRangeText(`\n${indent}`, selectionStart, selectionEnd, 'end');
  event.target.dispatchEvent(new Event('input', {bubbles: true}));
}

async function send() {
  const text = editor.typed;
  if (text === null || text === store.state.text) {
    editor.typed = null;
    return drawYaml();
  }
  try {
    await setText(text, editor.base, `typing-${editor.session}`);
    editor.base = store.state.revision;
    if (editor.typed === text) editor.typed = null;
    editor.conflict = false;
  } catch (error) {
    if (error.status === 409)
      editor.conflict = true;
    else
      report(error);
  }
  return drawYaml();
}

function conflict() {
  return h(
      'div', {class: 'banner', role: 'alert'},
      h('span', {}, 'The settings were changed elsewhere while you were typing.'),
      h('button', {
        type: 'button',
        onclick: () => {
          Object.assign(editor, {conflict: false, base: store.state.revision});
          send();
        }
      },
        'Keep what I typed'),
      h('button', {
        type: 'button',
        onclick: () => {
          Object.assign(editor, {conflict: false, typed: null});
          drawYaml();
        }
      },
        'Take theirs'));
}
