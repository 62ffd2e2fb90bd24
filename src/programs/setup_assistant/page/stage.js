// The dataset's own picture, the time slider, and which labels are shown.
import {cameraDrag, dragHint} from './camera_drag.js';
import {h, patch} from './dom.js';
import {glance} from './glance.js';
import {count, fixed} from './numbers.js';
import {overlay} from './overlay.js';
import {allProblems, count as countOf} from './problems.js';
import {scene} from './scene_loader.js';
import {isEmpty, store} from './store.js';
import {cameraNames, currentCamera, currentInstant, instantCount, secondsOf, show, view} from './view_state.js';

const LABELS =
    [['boxes', 'Boxes'], ['masks', 'Masks'], ['keypoints', 'Keypoints'], ['cuboids', 'Cuboids'], ['names', 'Names']];
const LAYERS = [['picture', 'Picture'], ['depth', 'Depth'], ['instances', 'Instances']];

export function drawStage() {
  patch(document.getElementById('stage'), [picture(), slider(), switches()]);
}

function picture() {
  const {value} = scene;
  const hint = dragHint();
  const message = whyNoPicture();
  return h(
      'div', {
        class: `picture${hint ? ' draggable' : ''}${isOld(value) ? ' old' : ''}`,
        ...(hint ? cameraDrag : noDrag()),
        tabindex: hint ? '0' : null,
        role: hint ? 'application' : null,
        'aria-label': hint ? `Camera. ${hint}` : null,
        style: {'--ratio': value ? value.camera.width / value.camera.height : 4 / 3},
      },
      h('canvas', {
        unmanaged: true,
        role: 'img',
        'aria-label': altText(value),
        created: drawBitmap,
        class: message ? 'dimmed' : ''
      }),
      value && !glance.bitmap ? overlay(value, view.shown) : null,
      h('div', {class: 'loading', hidden: !scene.isLoading}),
      message ? h('p', {class: 'message', role: 'status'}, message) : null,
      hint ? h('p', {class: 'drag-hint', 'aria-hidden': 'true'}, hint) : null);
}

// Whether a picture belongs to settings that have changed since.
function isOld(value) {
  return Boolean(value) && value.revision < store.state?.revision;
}

function noDrag() {
  return Object.fromEntries(Object.keys(cameraDrag).map((each) => [each, null]));
}

let drawn = '';

function drawBitmap(canvas) {
  const bitmap = glance.bitmap ?? scene.bitmap;
  if (!bitmap) return;
  canvas.width = bitmap.width;
  canvas.height = bitmap.height;
  canvas.getContext('2d').drawImage(bitmap, 0, 0);
  canvas.dataset.count = scene.count;
  canvas.dataset.glances = glance.count;
  canvas.dataset.revision = glance.bitmap ? '' : scene.value.revision;
  canvas.dataset.instant = scene.value?.instant ?? '';
}

export function redrawBitmap() {
  const key = `${scene.count} ${glance.count}`;
  if (drawn === key) return;
  drawn = key;
  const canvas = document.querySelector('#stage canvas');
  if (canvas) drawBitmap(canvas);
}

function altText(value) {
  if (!value) return 'No picture yet';
  const objects = (value.labels?.objects ?? []).filter((each) => each.box).map((each) => each.name);
  return `Picture of ${value.camera.name ?? 'the camera'} with ${objects.join(', ') || 'no object'} in sight`;
}

function whyNoPicture() {
  if (isEmpty()) return 'The picture of the dataset appears here.';
  if (store.state?.error) return 'The settings file is not valid YAML at the moment; this is the earlier picture.';
  const {error} = countOf(allProblems());
  if (error) return `${count(error, 'error')} in the settings: no picture can be made until they are corrected.`;
  return scene.error;
}

function slider() {
  const instants = instantCount();
  const instant = currentInstant();
  const seconds = secondsOf(instant);
  return h(
      'div', {class: 'time'},
      h('button', {
        type: 'button',
        class: 'quiet',
        'aria-label': 'Earlier scene',
        disabled: instant <= 0,
        onclick: () => show({instant: instant - 1})
      },
        '\u2039'),
      h('input', {
        type: 'range',
        min: 0,
        max: Math.max(instants - 1, 0),
        step: 1,
        value: instant,
        disabled: instants < 2,
        id: 'time',
        'aria-label': 'Scene',
        'aria-valuetext': `scene ${instant + 1} of ${instants}`,
        oninput: (event) => show({instant: Number(event.target.value)}),
      }),
      h('button', {
        type: 'button',
        class: 'quiet',
        'aria-label': 'Later scene',
        disabled: instant >= instants - 1,
        onclick: () => show({instant: instant + 1})
      },
        '\u203a'),
      h('output', {class: 'time-text', 'for': 'time'}, instants ? `${instant} / ${instants - 1}` : '',
        h('span', {}, Number.isFinite(seconds) ? `${fixed(seconds)} s` : '')));
}

function switches() {
  const names = cameraNames();
  return h(
      'div', {class: 'switches'},
      h('div', {class: 'toggles', role: 'group', 'aria-label': 'Labels'},
        LABELS.map(
            ([name, label]) =>
                h('label', {class: 'toggle'}, h('input', {
                    type: 'checkbox',
                    checked: view.shown[name],
                    onchange: (event) => show({shown: {...view.shown, [name]: event.target.checked}}),
                  }),
                  h('span', {}, label)))),
      h('select', {'aria-label': 'Layer', value: view.layer, onchange: (event) => show({layer: event.target.value})},
        LAYERS.map(([name, label]) => h('option', {value: name}, label))),
      names.length > 1 ?
          h('select',
            {'aria-label': 'Camera', value: currentCamera(), onchange: (event) => show({camera: event.target.value})},
            names.map((each) => h('option', {value: each}, each))) :
          null);
}
