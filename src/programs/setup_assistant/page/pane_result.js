import {post} from './api.js';
import {h} from './dom.js';
import {bytes, count, grouped} from './numbers.js';
import {colourOf} from './overlay.js';
import {answer, askAgain, changed, report as tellOf, store} from './store.js';

const ANY = '';

const result = {
  page: 0,
  hasLabels: true,
  filter: {class: ANY, split: ANY, size: ANY, occlusion: ANY},
  enlarged: null,  // the index of a scene
  check: null,
  isChecking: false,
  isReporting: false,
  runState: null,
  shown: null  // what the pane shows
};

export const resultPane = {
  id: 'result',
  title: 'Result',
  text: 'The scenes of the dataset, read from its files.',
  paths: () => [],
  summary: () => '',
  draw,
};

function choose(changes) {
  Object.assign(result, changes);
  changed();
}

function draw() {
  // A run that has ended has more scenes than were read before.
  if (result.runState !== store.run.state) {
    result.runState = store.run.state;
    askAgain('api/result');
  }
  const {value: read, error} = answer('api/result', {page: result.page, ...result.filter});
  // While another selection is being read, the one before stays, so that the page does not jump.
  const value = read ?? (error ? null : result.shown);
  result.shown = value;
  if (!value) return h('p', {class: 'empty'}, error ?? 'Reading the dataset\u2026');
  if (!value.scene_count)
    return h('p', {class: 'empty'}, 'There is no scene yet. ', h('a', {href: '#run'}, 'To the run'));
  const {chosen} = value;
  const enlarged = value.scenes.find((each) => each.index === result.enlarged);
  return [
    h('div', {class: 'result-head'}, h('p', {class: 'facts'}, facts(value)),
      h('button', {type: 'button', disabled: result.isChecking, onclick: verify},
        result.isChecking ? 'Verifying\u2026' : 'Verify its files'),
      report(value.report)),
    verdict(),
    filters(value),
    h('p', {class: 'facts chosen', role: 'status'},
      `${count(chosen.scene_count, 'scene')}, ${count(sum(chosen.classes), 'label')}`,
      isFiltered() ? h('button', {type: 'button', class: 'link', onclick: () => filterBy({})}, 'Show all') : null),
    h('div', {class: 'charts'}, chart('Labels of each class', chosen.classes),
      chart('Scenes of each split', chosen.splits),
      chart('Labels by size, 32\u00b2 and 96\u00b2 px', chosen.sizes, SIZES),
      chart('Labels by the share that is hidden', chosen.occlusions, OCCLUSIONS)),
    h('div', {class: 'result-head'},
      h('label', {class: 'toggle'}, h('input', {
          type: 'checkbox',
          checked: result.hasLabels,
          onchange: (event) => choose({hasLabels: event.target.checked}),
        }),
        h('span', {}, 'Labels')),
      pages(value.pages ?? 1)),
    enlarged ? large(enlarged, value.scenes) : null,
    h('ul', {class: 'scenes'}, value.scenes.map((each) => tile(each, value.folder))),
  ];
}

function sum(counts) {
  return Object.values(counts).reduce((all, each) => all + each, 0);
}

// --- Which scenes ---

// As in COCO: small is below 32 x 32 visible pixels, large from 96 x 96 on.
const SIZES = {
  small: 'small',
  medium: 'medium',
  large: 'large'
};
const OCCLUSIONS = {
  none: 'nothing',
  part: 'up to half',
  most: 'more than half'
};

function isFiltered() {
  return Object.values(result.filter).some((each) => each !== ANY);
}

function filterBy(filter) {
  choose({page: 0, enlarged: null, filter: {class: ANY, split: ANY, size: ANY, occlusion: ANY, ...filter}});
}

// Filters by what labels scenes have: those with such a label are shown.
function filters({classes, splits}) {
  const names = (counts) => Object.fromEntries(Object.keys(counts).map((each) => [each, each]));
  return h(
      'div', {class: 'filters', role: 'group', 'aria-label': 'Which scenes'},
      [
        ['class', 'Class', names(classes)], ['split', 'Split', names(splits)], ['size', 'Size', SIZES],
        ['occlusion', 'Hidden', OCCLUSIONS]
      ].filter(([, , choices]) => Object.keys(choices).length)
          .map(
              ([name, label, choices]) =>
                  h('label', {key: name}, h('span', {}, label),
                    h('select', {
                      value: result.filter[name],
                      onchange: ({target}) => filterBy({...result.filter, [name]: target.value}),
                    },
                      h('option', {value: ANY}, 'any'),
                      Object.entries(choices).map(([value, text]) => h('option', {value}, text))))));
}

// --- Scenes ---

function picture(scene) {
  return result.hasLabels ? scene.overlay ?? scene.image : scene.image;
}

function caption(scene) {
  return [String(scene.index), scene.split ? h('span', {class: 'muted'}, ` ${scene.split}`) : null];
}

function nameOf({index, camera}) {
  return `Scene ${index}${camera ? ` of ${camera}` : ''}`;
}

function tile(scene, folder) {
  return h(
      'li', {key: `${folder}-${scene.index}`},
      h('button', {
        type: 'button',
        class: 'tile',
        'aria-label': `Enlarge ${nameOf(scene)}`,
        onclick: () => {
          choose({enlarged: scene.index});
          requestAnimationFrame(() => document.querySelector('.enlarged')?.scrollIntoView({block: 'nearest'}));
        }
      },
        h('img', {src: `${picture(scene)}&width=${TILE}`, loading: 'lazy', alt: nameOf(scene)}),
        h('span', {class: 'caption'}, caption(scene))));
}

const TILE = 480;  // [px]

// A scene in its own resolution, with buttons for the ones before and after it.
function large(scene, scenes) {
  const at = scenes.indexOf(scene);
  const go = (step) => choose({enlarged: scenes[at + step].index});
  const close = () => choose({enlarged: null});
  const onkeydown = (event) => {
    const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (event.key === 'Escape') close();
    if (step && scenes[at + step]) go(step);
  };
  const step = (by, label, sign) =>
      h('button',
        {type: 'button', class: 'quiet', 'aria-label': label, disabled: !scenes[at + by], onclick: () => go(by)}, sign);
  return h(
      'figure', {
        key: 'enlarged',
        class: 'enlarged',
        tabindex: '-1',
        onkeydown,
        created: (node) => requestAnimationFrame(() => node.focus())
      },
      h('figcaption', {}, step(-1, 'Scene before', '\u2039'), h('span', {}, nameOf(scene), ' ', caption(scene)[1]),
        step(1, 'Next scene', '\u203a'),
        h('a', {href: picture(scene), target: '_blank', rel: 'noreferrer'}, 'On its own'),
        h('button', {type: 'button', class: 'quiet', 'aria-label': 'Make it small again', onclick: close}, '\u00d7')),
      h('img', {src: picture(scene), alt: nameOf(scene)}));
}

// --- The report: a page of its own ---

function report(time) {
  return [
    time === null ? null :
                    h('a', {href: `api/report?made=${time}`, target: '_blank', rel: 'noreferrer', class: 'button'},
                      'Open the report'),
    h('button', {type: 'button', disabled: result.isReporting, onclick: makeReport},
      result.isReporting ? 'Making the report\u2026' :
          time === null  ? 'Make the report' :
                           'Make it again'),
  ];
}

async function makeReport() {
  choose({isReporting: true});
  try {
    await post('api/report');
    askAgain('api/result');
  } catch (error) {
    tellOf(error);
  }
  choose({isReporting: false});
}

function facts({folder, scene_count: scenes, bytes: size}) {
  return [folder, Number.isFinite(scenes) ? count(scenes, 'scene') : null, Number.isFinite(size) ? bytes(size) : null]
      .filter(Boolean)
      .join(', ');
}

function pages(number) {
  if (number < 2) return h('span', {});
  const go = (page) => choose({page, enlarged: null});
  return h(
      'div', {class: 'pages', role: 'group', 'aria-label': 'Pages'},
      h('button', {
        type: 'button',
        class: 'quiet',
        'aria-label': 'Page before',
        disabled: result.page <= 0,
        onclick: () => go(result.page - 1)
      },
        '\u2039'),
      h('span', {}, `${result.page + 1} / ${number}`),
      h('button', {
        type: 'button',
        class: 'quiet',
        'aria-label': 'Next page',
        disabled: result.page >= number - 1,
        onclick: () => go(result.page + 1)
      },
        '\u203a'));
}

async function verify() {
  result.isChecking = true;
  changed();
  try {
    result.check = await post('api/verify');
  } catch (error) {
    tellOf(error);
  }
  result.isChecking = false;
  changed();
}

function verdict() {
  if (!result.check) return null;
  const {ok, problems = [], summary} = result.check;
  if (ok) return h('p', {class: 'verdict-line fine', role: 'status'}, summary ?? 'All files are as they should be.');
  return h(
      'ul', {class: 'problems', role: 'status'},
      problems.map((each) => h('li', {class: 'error'}, h('span', {class: 'severity'}, 'error'), ' ', String(each))));
}

function chart(title, values, names = null) {
  const keys = names ? Object.keys(names).filter((each) => values[each]) : Object.keys(values);
  if (!keys.length) return null;
  const most = Math.max(...keys.map((each) => values[each]), 1);
  return h(
      'section', {class: 'chart', key: title}, h('h2', {}, title),
      h('dl', {},
        keys.map(
            (key, index) =>
                h('div', {key}, h('dt', {}, names?.[key] ?? key),
                  h('dd', {}, h('i', {style: {'--share': values[key] / most, '--label': colourOf(index)}}),
                    h('span', {}, grouped(values[key])))))));
}
