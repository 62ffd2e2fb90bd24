// The field for a name that is chosen within the settings: of an object, of a camera.
import {h} from './dom.js';

// A name to which other settings refer. `why`: the reason why it stays, or null; `whyNot(wanted)`: the reason why a
// name is not possible, or null.
export function renaming(id, name, {why = null, whyNot, rename}) {
  const onchange = ({target}) => {
    const wanted = target.value.trim();
    const problem = wanted === name ? null : whyNot(wanted);
    target.setCustomValidity(problem ?? '');
    if (problem) {
      target.reportValidity();
      target.isEdited = true;  // what was typed stays, to be corrected
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
