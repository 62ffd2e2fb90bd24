// Fields of settings that name files or folders, which a dialog chooses.
import {h} from './dom.js';
import {field, printText, setFromText} from './fields.js';
import {browse} from './file_dialog.js';
import {effective, set} from './store.js';

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
