// Draws the page whenever what the server has said, or what the page shows, has changed.
import {h, patch} from './dom.js';
import {problemList} from './fields.js';
import {count, fileName} from './numbers.js';
import {focusField, panes} from './panes.js';
import {allProblems, count as countOf, identity, problemsBelow} from './problems.js';
import {loadAgain} from './scene_loader.js';
import {drawStage, redrawBitmap} from './stage.js';
import {answerOutside, changed, isEmpty, isStale, redo, start, store, undo, watch} from './store.js';
import {show, view} from './view_state.js';
import {drawYaml, showSetting} from './yaml_editor.js';

function drawHeader() {
  const {state} = store;
  const all = countOf(allProblems());
  document.title = state ? `${fileName(state.file)} \u2013 Setup assistant` : 'Setup assistant';
  patch(document.getElementById('header'), [
    h('h1', {}, 'Setup assistant'),
    h('span', {class: 'file', title: state?.file}, fileName(state?.file)),
    h('button', {
      type: 'button',
      class: `verdict ${verdictClass(all)}`,
      onclick: () => goTo('problems'),
      title: 'To the problems',
    },
      verdict(all)),
    h('div', {class: 'history'},
      h('button', {
        type: 'button',
        class: 'quiet',
        disabled: !state?.can_undo,
        onclick: undo,
        title: 'Undo (Ctrl+Z)',
        'aria-keyshortcuts': 'Control+Z'
      },
        'Undo'),
      h('button', {
        type: 'button',
        class: 'quiet',
        disabled: !state?.can_redo,
        onclick: redo,
        title: 'Redo (Ctrl+Shift+Z)',
        'aria-keyshortcuts': 'Control+Shift+Z'
      },
        'Redo')),
  ]);
}

function verdictClass({error, warning}) {
  if (store.state?.error) return 'error';
  if (isEmpty() || isStale()) return 'reading';
  if (error) return 'error';
  return warning ? 'warning' : 'fine';
}

function verdict({error, warning}) {
  if (store.state?.error) return 'invalid YAML';
  if (isEmpty()) return 'nothing chosen yet';
  if (isStale()) return 'reading\u2026';
  if (error) return count(error, 'error');
  return warning ? count(warning, 'warning') : 'ready to run';
}

function drawBanners() {
  const {state, connection, notice} = store;
  patch(document.getElementById('banners'), [
    connection === 'lost' ?
        h('div', {key: 'lost', class: 'banner'}, 'No answer from setup_assistant. Start it again; this page waits.') :
        null,
    connection === 'refused' ? h('div', {key: 'refused', class: 'banner error'},
                                 'setup_assistant was restarted with a new token. Open the address that it printed.') :
                               null,
    state?.outside ?
        h('div', {key: 'outside', class: 'banner', role: 'alertdialog', 'aria-label': 'The file was changed'},
          h('span', {}, `Another program has changed ${fileName(state.file)}.`),
          h('button', {type: 'button', class: 'primary', onclick: () => answerOutside(true)}, 'Load its text'),
          h('button', {type: 'button', onclick: () => answerOutside(false)}, 'Keep this page\u2019s')) :
        null,
    notice ? h('div', {key: 'notice', class: 'banner error', role: 'alert'}, h('span', {}, notice.text),
               h('button', {
                 type: 'button',
                 class: 'quiet',
                 'aria-label': 'Close',
                 onclick: () => {
                   store.notice = null;
                   changed();
                 }
               },
                 '\u00d7')) :
             null,
  ]);
}

let stepInView = null;

function drawNav() {
  const nav = document.getElementById('nav');
  patch(nav, [h('ul', {}, panes.map((pane) => h('li', {key: pane.id}, navLink(pane))))]);
  if (stepInView === view.pane) return;
  stepInView = view.pane;
  // Scrolls only the steps: on a telephone, the page itself may be scrolled anywhere.
  const step = nav.querySelector('[aria-current]');
  nav.scrollLeft = step.offsetLeft - (nav.clientWidth - step.offsetWidth) / 2;
}

function navLink(pane) {
  const isHere = pane.id === view.pane;
  const counts =
      pane.id === 'problems' ? countOf(allProblems()) : countOf(pane.paths().flatMap((each) => problemsBelow(each)));
  const worst = counts.error ? 'error' : counts.warning ? 'warning' : null;
  const number = counts.error || counts.warning;
  return h(
      'a', {href: `#${pane.id}`, 'aria-current': isHere ? 'page' : null, class: 'step'},
      h('span', {class: 'step-title'}, pane.title),
      h('span', {class: 'step-summary'}, store.state ? pane.summary() : ''),
      h('span', {class: `badge ${worst ?? ''}`, hidden: !worst, 'aria-label': worst ? count(number, worst) : null},
        worst ? number : ''));
}

function drawPane() {
  const pane = panes.find((each) => each.id === view.pane) ?? panes[0];
  document.body.dataset.pane = pane.id;
  document.body.classList.toggle('stale', isStale());
  document.body.classList.toggle('nothing-yet', isEmpty());
  patch(document.getElementById('pane'), [
    h('div', {key: pane.id, class: 'pane'},
      h('header', {class: 'pane-head'}, h('h1', {}, pane.title), h('p', {}, pane.text)),
      h('div', {class: 'pane-others field', unmanaged: true}),
      store.state && store.setup ? h('div', {class: 'pane-body'}, pane.draw()) :
                                   h('p', {class: 'empty'}, 'Reading the settings\u2026')),
  ]);
  patch(
      document.querySelector('.pane-others'),
      [problemList(withoutField(pane).map((each) => ({...each, found: `${each.about}: ${each.found}`})))]);
}

// Problems of a pane's settings that none of its fields shows.
function withoutField(pane) {
  const shown =
      new Set([...document.querySelectorAll('.pane-body [data-problem]')].map((each) => each.dataset.problem));
  return pane.paths()
      .flatMap((each) => problemsBelow(each))
      .filter((each) => each.severity !== 'note' && !shown.has(identity(each)));
}

watch(() => {
  drawHeader();
  drawBanners();
  drawNav();
  drawPane();
  drawStage();
  redrawBitmap();
  drawYaml();
});

let connectionBefore = null;
watch(() => {
  if (connectionBefore === 'lost' && store.connection === 'live') loadAgain();
  connectionBefore = store.connection;
});

function readAddress() {
  const [id, ...rest] = decodeURIComponent(location.hash.slice(1)).split(':');
  const pane = panes.find((each) => each.id === id);
  if (!pane) return;
  const isOther = pane.id !== view.pane;
  show({pane: pane.id});
  if (isOther) document.getElementById('pane').scrollTop = 0;
  if (rest.length) requestAnimationFrame(() => focusField(rest.join(':')));
}

function goTo(id) {
  location.hash = id;
}

function onKey(event) {
  if (!(event.ctrlKey || event.metaKey) || event.altKey || !'zy'.includes(event.key.toLowerCase())) return;
  // A field in which something is being typed has an undo of its own.
  if (document.activeElement?.isEdited) return;
  event.preventDefault();
  const edited = document.activeElement;
  if (edited?.matches?.('input, textarea')) edited.isEdited = false;
  if (event.key.toLowerCase() === 'y' || event.shiftKey)
    redo();
  else
    undo();
}

document.getElementById('pane').addEventListener('focusin', (event) => {
  const field = event.target.closest('[data-path]');
  if (field) showSetting(field.dataset.path.split('/'));
});
addEventListener('hashchange', readAddress);
addEventListener('keydown', onKey);
readAddress();
changed();
start();
