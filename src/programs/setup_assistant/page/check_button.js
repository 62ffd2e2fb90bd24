// The thorough check, which makes some scenes and takes seconds.
import {h} from './dom.js';
import {allProblems, count as countOf} from './problems.js';
import {changed, checkAll, store} from './store.js';

const checking = {
  isOn: false
};

export function checkButton(options = {}) {
  const isBlocked = Boolean(store.state.error) || countOf(allProblems()).error > 0;
  return h(
      'button', {type: 'button', class: options.class, disabled: checking.isOn || isBlocked, onclick: check},
      checking.isOn ? 'Checking\u2026' : 'Check with nine scenes');
}

async function check() {
  checking.isOn = true;
  changed();
  await checkAll();
  checking.isOn = false;
  changed();
}
