// The panes, in the order of the work, and which of them shows a setting.
import {camerasPane} from './pane_cameras.js';
import {formatsPane} from './pane_formats.js';
import {objectsPane} from './pane_objects.js';
import {outputPane} from './pane_output.js';
import {findPanesBy, problemsPane} from './pane_problems.js';
import {randomisationPane} from './pane_randomisation.js';
import {recordingPane} from './pane_recording.js';
import {resultPane} from './pane_result.js';
import {runPane} from './pane_run.js';
import {worldPane} from './pane_world.js';
import {keyOf, startsWith} from './paths.js';

export const panes = [
  recordingPane,
  objectsPane,
  worldPane,
  camerasPane,
  randomisationPane,
  formatsPane,
  outputPane,
  problemsPane,
  runPane,
  resultPane,
];

function paneOf(path) {
  return panes.find((pane) => pane.paths().some((each) => startsWith(path, each))) ?? null;
}

findPanesBy(paneOf);

// Focuses the field of a setting, or that of the nearest group around it.
export function focusField(key) {
  const path = key.split('/');
  for (let length = path.length; length > 0; --length) {
    const name = CSS.escape(keyOf(path.slice(0, length)));
    const found = document.querySelector(`#pane [data-path="${name}"], #pane [data-path^="${name}/"]`);
    if (!found) continue;
    for (let details = found.closest('details'); details; details = details.parentElement.closest('details'))
      details.open = true;
    found.scrollIntoView({block: 'center'});
    found.classList.add('found');
    setTimeout(() => found.classList.remove('found'), 1600);
    (found.querySelector('input, select, textarea, button:not(.reset)') ?? found).focus({preventScroll: true});
    return true;
  }
  const pane = document.getElementById('pane');
  pane.scrollTop = 0;
  pane.focus();
  return false;
}
