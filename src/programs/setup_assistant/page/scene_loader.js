// The scene under the time slider. There is one request at a time: after each answer, what is wanted by then is
// requested, so that dragging shows as many pictures as the server can draw, and always the last one.
import {get} from './api.js';
import {forgetGlance} from './glance.js';
import {changed, store, watch} from './store.js';
import {currentCamera, currentInstant, view} from './view_state.js';

export const scene = {
  value: null,
  bitmap: null,
  error: null,
  isLoading: false,
  count: 0
};

let asked = null;
let shown = null;

function wanted() {
  if (!store.state || store.state.error) return null;
  return JSON.stringify([currentInstant(), currentCamera(), store.state.revision, view.layer, store.setup?.ready]);
}

watch(load);

async function load() {
  const key = wanted();
  if (asked || key === null || key === shown) return;
  asked = key;
  scene.isLoading = true;
  try {
    const value = await get('api/scene', {
      instant: currentInstant(),
      camera: currentCamera(),
      revision: store.state.revision,
    });
    const url = view.layer === 'picture' ? value.picture : value[view.layer] ?? value.picture;
    const response = await fetch(url);
    if (!response.ok) throw new Error(`The picture cannot be loaded (${response.status}).`);
    scene.bitmap?.close();
    scene.bitmap = await createImageBitmap(await response.blob());
    Object.assign(scene, {value, error: null, count: scene.count + 1});
    if (value.revision >= store.state.revision) forgetGlance();
  } catch (error) {
    scene.error = error.message;
  }
  // A restarted server has settings of its own; its first answers make another key.
  shown = key;
  asked = null;
  scene.isLoading = wanted() !== shown;
  changed();
  load();
}

// Loads the scene even if it is shown already, as after the server was away.
export function loadAgain() {
  shown = null;
  load();
}
