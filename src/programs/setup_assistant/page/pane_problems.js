import {checkButton} from './check_button.js';
import {h} from './dom.js';
import {count} from './numbers.js';
import {keyOf} from './paths.js';
import {allProblems, sentence, SEVERITIES} from './problems.js';
import {store} from './store.js';
import {goToLine} from './yaml_editor.js';

export const problemsPane = {
  id: 'problems',
  title: 'Problems',
  text: 'What is wrong or odd about these settings. Each entry leads to its field.',
  paths: () => [],
  summary: () => (store.state?.error ? 'no YAML' : ''),
  draw,
};

function draw() {
  const {error} = store.state;
  const problems = allProblems();
  return [
    h('p', {class: 'buttons'}, checkButton({class: 'primary'}),
      h('span', {class: 'muted'}, 'Makes scenes all over the run and looks for what is odd about them.')),
    error ? h('ul', {class: 'problems all'},
              h('li', {class: 'error'}, h('span', {class: 'severity'}, 'error'), ' ',
                h('button', {type: 'button', class: 'link', onclick: () => goToLine(error.line ?? 1)},
                  `The text is no YAML: line ${error.line}`),
                ` ${error.message}`)) :
            null,
    h('div', {}, SEVERITIES.map((severity) => list(severity, problems.filter((each) => each.severity === severity)))),
    problems.length || error ? null : h('p', {class: 'empty'}, 'Nothing is wrong.'),
  ];
}

function list(severity, problems) {
  if (!problems.length) return null;
  return h(
      'section', {class: 'group', key: severity}, h('h2', {}, count(problems.length, severity)),
      h('ul', {class: 'problems all'},
        problems.map(
            (each) =>
                h('li', {class: severity}, h('span', {class: 'about'}, link(each)),
                  h('span', {class: 'what'}, sentence(each)),
                  each.cure ? h('span', {class: 'cure'}, each.cure) : null))));
}

function link(problem) {
  const pane = problem.path && paneWith(problem.path);
  if (!pane) return problem.about ?? '';
  return h('a', {href: `#${pane.id}:${encodeURIComponent(keyOf(problem.path))}`}, problem.about || keyOf(problem.path));
}

// panes.js imports this file, so it says who has a setting.
let paneWith = () => null;

export function findPanesBy(find) {
  paneWith = find;
}
