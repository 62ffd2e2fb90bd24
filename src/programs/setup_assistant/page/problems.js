// The problems of the settings, and those to show at each setting.
import {foldersAsWritten, withFoldersAsWritten} from './folder_names.js';
import {keyOf, startsWith} from './paths.js';
import {isEmpty, store} from './store.js';

export const SEVERITIES = ['error', 'warning', 'note'];

const shown = {
  setup: null,
  state: null,
  problems: []
};

// All problems, the worst first, each once, with folders as the file names them.
export function allProblems() {
  if (isEmpty()) return [];
  const {setup, state} = store;
  if (shown.setup === setup && shown.state === state) return shown.problems;
  const folders = foldersAsWritten(state?.settings, state?.effective);
  const byIdentity = new Map();
  for (const each of setup?.problems ?? []) {
    const [about, found, cure] = [each.about, each.found, each.cure].map((text) => withFoldersAsWritten(text, folders));
    const problem = {...each, about, found, cure};
    if (!byIdentity.has(identity(problem))) byIdentity.set(identity(problem), problem);
  }
  const problems =
      [...byIdentity.values()].sort((a, b) => SEVERITIES.indexOf(a.severity) - SEVERITIES.indexOf(b.severity));
  Object.assign(shown, {setup, state, problems});
  return problems;
}

// Groups the problems that say the same about several settings.
export function inGroups(problems) {
  const groups = new Map();
  for (const each of problems) {
    const key = JSON.stringify([each.severity, sentence(each), each.cure]);
    groups.set(key, [...(groups.get(key) ?? []), each]);
  }
  return [...groups.values()];
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
