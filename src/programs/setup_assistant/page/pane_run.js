import {h} from './dom.js';
import {count, duration, fixed, grouped} from './numbers.js';
import {allProblems, count as countOf} from './problems.js';
import {startRun, stopRun, store} from './store.js';

export const runPane = {
  id: 'run',
  title: 'Run',
  text: 'Makes the dataset, as generate --config FILE does. A run that was stopped goes on where it was.',
  paths: () => [],
  summary: () =>
      ({running: `${percent()} %`,
        done: 'done',
        failed: 'failed',
        stopped: `stopped at ${percent()} %`}[store.run?.state] ??
       ''),
  draw,
};

function percent() {
  const {scenes_done: done = 0, scenes = 0} = store.run ?? {};
  return scenes ? Math.floor(100 * done / scenes) : 0;
}

function draw() {
  const {run, state, setup} = store;
  const {error} = countOf(allProblems());
  const isRunning = run.state === 'running';
  const isBlocked = error > 0 || Boolean(state.error);
  return [
    h('p', {class: 'buttons'},
      isRunning ?
          h('button', {key: 'stop', type: 'button', class: 'primary', disabled: run.elsewhere, onclick: stopRun},
            run.stopping ? 'Stop at once' : 'Stop') :
          h('button', {key: 'start', type: 'button', class: 'primary', disabled: isBlocked, onclick: startRun},
            {stopped: 'Go on', failed: 'Try again', done: 'Run again'}[run.state] ?? 'Start'),
      run.elsewhere ? h('span', {class: 'muted'}, 'Another program is writing this dataset.') :
          isBlocked ? h('a', {href: '#problems'},
                        state.error ? 'The file is no YAML' : `${count(error, 'error')} to mend first`) :
                                      h('span', {class: 'muted'}, planned(setup))),
    h('div', {class: 'progress-box', role: 'status'},
      h('progress', {max: run.scenes || 1, value: run.scenes_done ?? 0, 'aria-label': 'Scenes done'}),
      h('p', {class: 'facts'}, progress(run))),
    h('ul', {class: 'problems all'}, (run.errors ?? []).map((each) => h('li', {class: 'error'}, String(each)))),
    run.state === 'done' ?
        h('p', {class: 'buttons'}, h('a', {href: '#result', class: 'button primary'}, 'See the result'),
          h('code', {}, run.output_folder ?? '')) :
        null,
    h('section', {class: 'group'}, h('h2', {}, 'Log'),
      h('pre', {class: 'log', tabindex: '0', 'aria-label': 'Log'}, (run.log ?? []).join('\n') || ' ')),
    h('section', {class: 'group'}, h('h2', {}, 'The same by hand'),
      h('pre', {class: 'command'}, `rosrun synthetic_dataset generate --config ${state.file}`)),
  ];
}

function planned(setup) {
  const {scenes, seconds} = setup.figures ?? {};
  if (!Number.isFinite(scenes)) return '';
  return `${grouped(scenes)} scenes${Number.isFinite(seconds) ? `, about ${duration(seconds)}` : ''}`;
}

function progress(run) {
  if (run.state === 'idle') return 'Not started.';
  if (run.stopping) return 'Stops behind the scene that it makes\u2026';
  const parts = [`${grouped(run.scenes_done ?? 0)} of ${grouped(run.scenes ?? 0)} scenes`];
  if (run.state === 'running') {
    if (run.rate) parts.push(`${fixed(run.rate, 1)} a second`);
    if (Number.isFinite(run.seconds_left)) parts.push(`${duration(run.seconds_left)} left`);
  } else {
    parts.push(
        {done: 'done', failed: `failed with exit code ${run.exit_code}`, stopped: 'stopped'}[run.state] ?? run.state);
  }
  return parts.join(', ');
}
