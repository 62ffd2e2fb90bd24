// What the server has said, and how the page changes the settings. Everything that is drawn follows from this.
import {get, listen, post} from './api.js';
import {isEqual, valueAt} from './paths.js';

export const store = {
  state: null,        // the last answer of /api/state
  merged: undefined,  // its settings over those of included files
  setup: null,        // the last answer of /api/setup
  run: {state: 'idle'},
  parameters: new Map(),
  connection: 'connecting',
  notice: null,  // {text}: what the server refused last
};

const watchers = [];
const later = {
  frame: 0
};

export function watch(watcher) {
  watchers.push(watcher);
}

export function changed() {
  if (later.frame) return;
  later.frame = requestAnimationFrame(() => {
    later.frame = 0;
    for (const watcher of watchers) watcher();
  });
}

export async function start() {
  const {parameters} = await get('api/parameters');
  for (const each of parameters) store.parameters.set(each.path, each);
  await readAll();
  listen({state: takeState, setup: takeSetup, run: takeRun}, (connection) => {
    const isBack = connection === 'live' && store.connection === 'lost';
    store.connection = connection;
    if (isBack) readAll(true);
    changed();
  });
}

async function readAll(isNewServer = false) {
  // Another process counts its revisions anew.
  if (isNewServer) store.state = store.setup = null;
  const asked = [['api/state', takeState], ['api/setup', takeSetup], ['api/run', takeRun]];
  await Promise.all(asked.map(([path, take]) => get(path).then(take, refuse)));
}

function refuse(error) {
  if (error.status !== 403) return report(error);
  store.connection = 'refused';
  return changed();
}

function takeState(state) {
  if (!store.state || state.revision >= store.state.revision) {
    store.state = state;
    store.merged = overlaid(state.effective ?? undefined, state.settings);
  }
  changed();
}

export function takeStateOf(state) {
  takeState(state);
}

// Whether nothing has been chosen yet: what is missing then is nobody's error.
export function isEmpty() {
  const {state} = store;
  return Boolean(state) && !state.error && !Object.keys(state.settings ?? {}).length && !state.effective?.include &&
      !Object.keys(state.effective ?? {}).length;
}

// Whether what the server has said about the set-up belongs to earlier settings than those shown, or is not complete.
export function isStale() {
  const {setup, state} = store;
  if (!setup || setup.revision < state?.revision) return true;
  return setup.ready === false && !(setup.problems ?? []).some((each) => each.severity === 'error');
}

function takeSetup(setup) {
  store.setup = setup;
  forgetAnswers();
  changed();
}

function takeRun(run) {
  store.run = run;
  changed();
}

export function report(error) {
  store.notice = {text: error.message};
  changed();
}

// --- Changes, one after another, so that each knows the revision that the one before has made ---

let queue = Promise.resolve();

function enqueue(task) {
  const done = queue.then(task);
  queue = done.catch(() => {});
  return done;
}

async function postState(path, body) {
  const state = await post(path, {revision: store.state.revision, ...body});
  store.notice = null;
  takeState(state);
}

// changes: [[path, value], ...]; undefined removes. Changes with one `step` are undone together.
export function change(changes, step) {
  const body = {changes: changes.map(([path, value]) => ({path, value: value ?? null}))};
  if (step) body.step = step;
  return enqueue(async () => {
    try {
      await postState('api/set', body);
    } catch (error) {
      if (error.status !== 409) return report(error);
      // Somebody else was faster. A change names its settings, so it applies to theirs, too.
      takeState(await get('api/state'));
      await postState('api/set', body).catch(report);
    }
  });
}

export function set(path, value, step) {
  return change([[path, value]], step);
}

// `revision`: of the text that was changed. Throws a Refused with status 409 if somebody else was faster.
export function setText(text, revision, step) {
  return enqueue(() => postState('api/text', {text, revision, step}));
}

export function undo() {
  return enqueue(() => postState('api/undo').catch(report));
}

export function redo() {
  return enqueue(() => postState('api/redo').catch(report));
}

export function answerOutside(take) {
  return enqueue(() => postState('api/outside', {take}).catch(report));
}

// `replace`: the folder whose dataset is removed first.
export async function startRun({replace = null} = {}) {
  await post('api/run/start', {replace}).then(takeRun, report);
}

export async function stopRun() {
  await post('api/run/stop').then(takeRun, report);
}

export async function checkAll() {
  await post('api/check').then(takeSetup, report);
}

// --- Values ---

export function own(path) {
  return valueAt(store.state?.settings, path);
}

// A value from this file or from included ones. One from this file is shown as it is written there, with $(find ...).
export function effective(path) {
  return valueAt(store.merged, path);
}

function overlaid(below, above) {
  if (above === undefined || above === null) return below;
  if (!isMap(below) || !isMap(above)) return above;
  const merged = {...below};
  for (const [key, value] of Object.entries(above)) merged[key] = overlaid(below[key], value);
  return merged;
}

function isMap(value) {
  return value !== null && typeof value === 'object' && !Array.isArray(value);
}

// Where a value comes from: this file, an included one, or neither.
export function sourceOf(path) {
  if (own(path) !== undefined) return 'here';
  return effective(path) === undefined ? 'default' : 'included';
}

export function objectNames() {
  const list = effective(['robot_list']);
  if (list === undefined) return [];
  return (Array.isArray(list) ? list : [list]).map(String);
}

// The TF frame that an object follows.
export function frameOf(name) {
  return effective([name, 'frame']) ?? `${name}/${effective([name, 'frame_id']) ?? 'base_link'}`;
}

// What config/params.yaml says about a setting. Objects, cameras and lights share the text of their kind.
export function parameter(path) {
  return store.parameters.get(documentedPath(path).join('/'));
}

export function documentedPath(path) {
  const [first, second, ...rest] = path.map(String);
  if (first === 'cameras' && second !== undefined) return ['camera', ...rest];
  if (first === 'motions' && second !== undefined) return documentedPath(rest);
  if (objectNames().includes(first)) return ['alpha', ...path.slice(1).map(String)];
  if (first === 'randomize' && ['lights', 'materials', 'objects'].includes(second) && rest.length > 1) {
    const kind = {lights: ['every'], materials: ['world'], objects: ['alpha', 'every']}[second];
    const found = kind.map((each) => [first, second, each, ...rest.slice(1)]);
    return found.find((each) => store.parameters.has(each.join('/'))) ?? found[0];
  }
  return path.map(String);
}

// --- Other answers, which are read again after each change ---

const answers = new Map();

// Browsers open at most six connections to a server. Pictures and clicks need some of them, so only a few requests may
// wait for answers that take long.
const MOST_WAITING = 2;
const waiting = {
  count: 0,
  queue: []
};

async function inTurn(ask) {
  if (waiting.count >= MOST_WAITING)
    await new Promise((resolve) => {
      waiting.queue.push(resolve);
    });
  else
    ++waiting.count;
  try {
    return await ask();
  } finally {
    const next = waiting.queue.shift();
    if (next)
      next();
    else
      --waiting.count;
  }
}

function forgetAnswers() {
  for (const answer of answers.values()) answer.isOld = true;
}

// The last known answer ({value, error}); asks for a new one if settings have changed since.
export function answer(path, query = {}) {
  const key = path + JSON.stringify(query);
  let known = answers.get(key);
  if (!known) answers.set(key, known = {isOld: true, isAsked: false, value: undefined, error: null});
  if (known.isOld && !known.isAsked) {
    known.isOld = false;
    known.isAsked = true;
    inTurn(() => get(path, query))
        .then(
            (value) => {
              const isNew = !isEqual(value, known.value) || known.error !== null;
              Object.assign(known, {value, error: null});
              return isNew;
            },
            (error) => {
              known.error = error.message;
              return true;
            },
            )
        .then((isNew) => {
          known.isAsked = false;
          if (isNew || known.isOld) changed();
        });
  }
  return known;
}

export function askAgain(path) {
  for (const [key, known] of answers)
    if (key.startsWith(path)) known.isOld = true;
  changed();
}
