import {post} from './api.js';
import {h} from './dom.js';
import {bytes, count, grouped} from './numbers.js';
import {colourOf} from './overlay.js';
import {answer, askAgain, changed, report, store} from './store.js';

const result = {
  page: 0,
  hasLabels: true,
  check: null,
  isChecking: false,
  runState: null
};

export const resultPane = {
  id: 'result',
  title: 'Result',
  text: 'The scenes of the dataset, as its files have them.',
  paths: () => [],
  summary: () => '',
  draw,
};

function draw() {
  // A run that has ended has more scenes than were read before.
  if (result.runState !== store.run.state) {
    result.runState = store.run.state;
    askAgain('api/result');
  }
  const {value, error} = answer('api/result', {page: result.page});
  if (!value) return h('p', {class: 'empty'}, error ?? 'Reading the dataset\u2026');
  if (!value.scenes?.length)
    return h('p', {class: 'empty'}, 'There is no scene yet. ', h('a', {href: '#run'}, 'To the run'));
  return [
    h('p', {class: 'facts'}, facts(value)),
    h('div', {class: 'result-head'},
      h('label', {class: 'toggle'}, h('input', {
          type: 'checkbox',
          checked: result.hasLabels,
          onchange: (event) => {
            result.hasLabels = event.target.checked;
            changed();
          },
        }),
        h('span', {}, 'Labels')),
      pages(value.pages ?? 1),
      h('button', {type: 'button', disabled: result.isChecking, onclick: verify},
        result.isChecking ? 'Verifying\u2026' : 'Verify its files')),
    verdict(),
    h('div', {class: 'charts'}, chart('Labels of each class', value.counts ?? {}),
      chart('Scenes of each split', value.splits ?? {})),
    h('ul', {class: 'scenes'},
      value.scenes.map(
          (each) =>
              h('li', {key: `${value.folder}-${each.index}`},
                h('figure', {}, h('img', {
                    src: result.hasLabels ? each.overlay ?? each.image : each.image,
                    loading: 'lazy',
                    alt: `Scene ${each.index}${each.camera ? ` of ${each.camera}` : ''}`
                  }),
                  h('figcaption', {}, String(each.index),
                    each.split ? h('span', {class: 'muted'}, ` ${each.split}`) : null))))),
  ];
}

function facts({folder, scene_count: scenes, bytes: size}) {
  return [folder, Number.isFinite(scenes) ? count(scenes, 'scene') : null, Number.isFinite(size) ? bytes(size) : null]
      .filter(Boolean)
      .join(', ');
}

function pages(number) {
  if (number < 2) return h('span', {});
  const go = (page) => {
    result.page = page;
    changed();
  };
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
    report(error);
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

function chart(title, values) {
  const entries = Object.entries(values);
  if (!entries.length) return null;
  const most = Math.max(...entries.map(([, each]) => each), 1);
  return h(
      'section', {class: 'chart', key: title}, h('h2', {}, title),
      h('dl', {},
        entries.map(
            ([name, each], index) =>
                h('div', {key: name}, h('dt', {}, name),
                  h('dd', {}, h('i', {style: {'--share': each / most, '--label': colourOf(index)}}),
                    h('span', {}, grouped(each)))))));
}
