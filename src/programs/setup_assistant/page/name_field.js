// The field of a name that the settings themselves have: of an object, of a camera.
import {h} from './dom.js';

// A name that others refer to. `why` it stays, or null; `whyNot(wanted)` a name cannot be had, or null.
export function renaming(id, name, {why = null, whyNot, rename}) {
  const onchange = ({target}) => {
    const wanted = target.value.trim();
    const problem = wanted === name ? null : whyNot(wanted);
    target.setCustomValidity(problem ?? '');
    if (problem) {
      target.reportValidity();
      target.isEdited = true;  // what was typed stays, to be mended
    } else if (wanted !== name) {
      rename(wanted);
    }
  };
  return h(
      'div', {class: 'field', key: id},
      h('div', {class: 'field-head'}, h('label', {class: 'field-label', 'for': id}, 'Name')),
      h('div', {class: 'control'}, h('input', {
          id,
          type: 'text',
          value: name,
          disabled: why !== null,
          spellcheck: 'false',
          autocomplete: 'off',
          'aria-describedby': `${id}-hint`,
          onchange
        })),
      h('p', {class: 'hint', id: `${id}-hint`}, why ?? ''));
}
