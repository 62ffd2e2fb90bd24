import {checkButton} from './check_button.js';
import {h} from './dom.js';
import {count} from './numbers.js';
import {keyOf} from './paths.js';
import {allProblems, identity, inGroups, sentence, SEVERITIES} from './problems.js';
import {store} from './store.js';
import {goToLine} from './yaml_editor.js';

export const problemsPane = {
  id: 'problems',
  title: 'Problems',
  text: 'What is wrong or odd about these settings. Each entry leads to its field.',
  paths: () => [],
  summary: () => (store.state?.error ? 'invalid YAML' : ''),
  draw,
};

function draw() {
  const {error} = store.state;
  const problems = allProblems();
  return [
    h('p', {class: 'buttons'}, checkButton({class: 'primary'}),
      h('span', {class: 'muted'}, 'Makes scenes all over the run and looks for what is odd about them.')),
    error ? h('ul', {class: 'problems all'},
              h('li', {class: 'error'},
                h('div', {class: 'entry'},
                  h('button', {type: 'button', class: 'link', onclick: () => goToLine(error.line ?? 1)},
                    `The text is not valid YAML: line ${error.line}`),
                  ` ${error.message}`))) :
            null,
    h('div', {}, SEVERITIES.map((severity) => list(severity, problems.filter((each) => each.severity === severity)))),
    problems.length || error ? null : h('p', {class: 'empty'}, 'Nothing is wrong.'),
  ];
}

function list(severity, problems) {
  if (!problems.length) return null;
  return h(
      'section', {class: 'group', key: severity}, h('h2', {}, count(problems.length, severity)),
      h('ul', {class: 'problems all'}, inGroups(problems).map((group) => entry(severity, group))));
}

// An entry about a single setting leads to it wherever the entry is clicked.
function entry(severity, group) {
  const [first] = group;
  const address = group.length === 1 ? addressOf(first) : null;
  return h(
      'li', {key: identity(first), class: severity, 'data-problem': identity(first)},
      h(address ? 'a' : 'div', {class: 'entry', href: address},
        h('span', {class: 'about'}, group.map((each, index) => [index ? ', ' : '', name(each, !address)])),
        h('span', {class: 'what'}, sentence(first)), first.cure ? h('span', {class: 'cure'}, first.cure) : null));
}

function name(problem, isLink) {
  const text = problem.about || keyOf(problem.path ?? []);
  const address = isLink && addressOf(problem);
  return address ? h('a', {href: address}, text) : text;
}

function addressOf({path}) {
  const pane = path && paneWith(path);
  return pane ? `#${pane.id}:${encodeURIComponent(keyOf(path))}` : null;
}

// Finds the pane of a setting. Set by panes.js, which this file cannot import, since panes.js imports this file.
let paneWith = () => null;

export function findPanesBy(find) {
  paneWith = find;
}
