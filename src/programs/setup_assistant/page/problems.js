// Where a problem of the settings is shown.
import {keyOf, startsWith} from './paths.js';
import {isEmpty, store} from './store.js';

export const SEVERITIES = ['error', 'warning', 'note'];

export function allProblems() {
  const problems = isEmpty() ? [] : [...(store.setup?.problems ?? [])];
  return problems.sort((a, b) => SEVERITIES.indexOf(a.severity) - SEVERITIES.indexOf(b.severity));
}

export function problemsAt(path) {
  return allProblems().filter((each) => each.path && keyOf(each.path) === keyOf(path));
}

export function problemsBelow(path) {
  return allProblems().filter((each) => each.path && startsWith(each.path, path));
}

export function count(problems) {
  const counts = {error: 0, warning: 0, note: 0};
  for (const each of problems) ++counts[each.severity];
  return counts;
}

export function sentence(problem) {
  return problem.found || problem.about;
}

export function identity(problem) {
  return `${problem.severity} ${problem.about}: ${problem.found}`;
}
