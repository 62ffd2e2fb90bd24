import {h} from './dom.js';
import {count, duration, fixed, grouped} from './numbers.js';
import {allProblems, count as countOf} from './problems.js';
import {changed, effective, startRun, stopRun, store, watch} from './store.js';

export const runPane = {
  id: 'run',
  title: 'Run',
  text: 'Makes the dataset, as generate --config FILE does. A stopped run continues where it was.',
  paths: () => [],
  summary: () =>
      ({running: `${percent()} %`,
        done: 'done',
        failed: 'failed',
        stopped: `stopped at ${percent()} %`}[store.run?.state] ??
       ''),
  draw,
};

// How many scenes are done and how many there will be. Until the run tells, the numbers are those of the set-up.
function counts() {
  const {run, setup} = store;
  if (run.scenes) return {done: run.scenes_done ?? 0, all: run.scenes};
  return {done: setup?.earlier?.scenes ?? 0, all: setup?.figures?.scenes ?? 0};
}

function percent() {
  const {done, all} = counts();
  return all ? Math.floor(100 * done / all) : 0;
}

// The folder for which the user is being asked whether its dataset may be removed.
const asking = {
  folder: null
};

function ask(folder) {
  asking.folder = folder;
  changed();
}

// The log stays scrolled to its end, unless the user looks further up.
let followsEnd = true;
let lastTop = 0;

// Lines that arrive between a scroll and its event do not mean that the user has scrolled up.
function noteEnd({target: log}) {
  const isAtEnd = log.scrollTop + log.clientHeight >= log.scrollHeight - 4;
  followsEnd = isAtEnd || (followsEnd && log.scrollTop >= lastTop);
  lastTop = log.scrollTop;
}

watch(() => requestAnimationFrame(() => {
        const log = document.querySelector('.log');
        if (!log || !followsEnd) return;
        log.scrollTop = log.scrollHeight;
        lastTop = log.scrollTop;
      }));

function draw() {
  const {run, state} = store;
  const {done, all} = counts();
  return [
    ...controls(),
    h('div', {class: 'progress-box', role: 'status'},
      h('progress', {max: all || 1, value: done, 'aria-label': 'Scenes done'}), h('p', {class: 'facts'}, progress(run)),
      resultLink()),
    h('ul', {class: 'problems all'},
      (run.errors ?? []).map((each) => h('li', {class: 'error'}, h('div', {class: 'entry'}, String(each))))),
    h('section', {class: 'group'}, h('h2', {}, 'Log'),
      h('pre', {class: 'log', tabindex: '0', 'aria-label': 'Log', onscroll: noteEnd},
        (run.log ?? []).join('\n') || ' ')),
    h('section', {class: 'group'}, h('h2', {}, 'The same by hand'),
      h('pre', {class: 'command'}, `rosrun synthetic_dataset generate --config ${state.file}`)),
  ];
}

function controls() {
  const {run, state, setup} = store;
  const {error} = countOf(allProblems());
  if (run.state === 'running') {
    asking.folder = null;
    const other = run.elsewhere && h('span', {class: 'muted'}, 'Another program is writing this dataset.');
    return [row(
        'running', button(run.stopping ? 'Stop at once' : 'Stop', stopRun, {disabled: run.elsewhere}),
        other || h('span', {class: 'muted'}, planned(setup)))];
  }
  if (state.error || error > 0) {
    const why = state.error ? 'The file is not valid YAML' : `${count(error, 'error')} to correct first`;
    return [row('blocked', button('Start', startRun, {disabled: true}), h('a', {href: '#problems'}, why))];
  }
  const {earlier} = setup;
  if (earlier?.fault) return [h('p', {}, earlier.fault), row('unreadable', elsewhere())];
  if (earlier && asking.folder === folder()) return [confirmation(earlier)];
  asking.folder = null;
  const isRefused = earlier && (earlier.differences.length > 0 || effective(['if_exists']) === 'error');
  if (isRefused) return inTheWay(earlier);
  if (earlier?.complete) {
    return [row(
        'made', h('a', {href: '#result', class: 'button primary'}, 'Open the result'),
        h('button', {type: 'button', onclick: () => ask(folder())}, 'Make it again\u2026'),
        h('span', {class: 'muted'}, `Made: ${grouped(earlier.scenes)} scenes in `, h('code', {}, folder())))];
  }
  const action = earlier ? 'Go on' : run.state === 'failed' ? 'Try again' : 'Start';
  return [row('ready', button(action, () => startRun()), h('span', {class: 'muted'}, planned(setup)))];
}

function row(key, ...children) {
  return h('p', {key, class: 'buttons'}, children);
}

function button(text, onclick, props = {}) {
  return h('button', {type: 'button', class: 'primary', onclick, ...props}, text);
}

// The folder of the dataset that the set-up knows and to which `earlier` refers.
function folder() {
  return store.setup.figures?.output_folder ?? '';
}

function elsewhere() {
  return h('a', {href: '#output:output_folder', class: 'button'}, 'Choose another folder');
}

// A dataset of other settings, or one that must not be touched.
function inTheWay(earlier) {
  const MOST_SHOWN = 4;
  const more = earlier.differences.length - MOST_SHOWN;
  return [
    h('p', {}, h('code', {}, folder()), ` holds a dataset of ${count(earlier.scenes, 'scene')}`,
      earlier.differences.length ? ' that was made with other settings:' : '.'),
    h('ul', {class: 'differences'}, earlier.differences.slice(0, MOST_SHOWN).map((each) => h('li', {}, each)),
      more > 0 ? h('li', {}, `and ${more} more`) : null),
    row('refused', button('Replace it\u2026', () => ask(folder())), elsewhere()),
  ];
}

function confirmation(earlier) {
  return h(
      'p', {key: 'asked', class: 'buttons', role: 'alertdialog', 'aria-label': 'Replace the dataset'},
      h('span', {}, `This removes the ${count(earlier.scenes, 'scene')} in `, h('code', {}, folder()), '.'),
      button('Remove and start', () => startRun({replace: asking.folder}), {class: 'danger'}),
      h('button', {type: 'button', onclick: () => ask(null)}, 'Keep them'));
}

function planned(setup) {
  const {scenes, seconds} = setup.figures ?? {};
  if (!Number.isFinite(scenes)) return '';
  return `${grouped(scenes)} scenes${Number.isFinite(seconds) ? `, about ${duration(seconds)}` : ''}`;
}

// A link to a dataset that is not complete yet; the buttons above lead to a complete one.
function resultLink() {
  return counts().done && !store.setup.earlier?.complete ?
      h('p', {}, h('a', {href: '#result'}, 'Open the result so far')) :
      null;
}

function progress(run) {
  const {done, all} = counts();
  const made = `${grouped(done)} of ${count(all, 'scene')}`;
  if (run.state === 'idle') return all ? `Not started: ${made}.` : 'Not started.';
  if (run.stopping) return 'Stops after the current scene\u2026';
  const parts = [made];
  if (run.state === 'running') {
    if (run.rate) parts.push(`${fixed(run.rate, 1)} a second`);
    if (Number.isFinite(run.seconds_left)) parts.push(`${duration(run.seconds_left)} left`);
  } else {
    parts.push(
        {done: 'done', failed: `failed with exit code ${run.exit_code}`, stopped: 'stopped'}[run.state] ?? run.state);
  }
  return parts.join(', ');
}
