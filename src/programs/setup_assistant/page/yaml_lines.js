// Where a setting is in the text of a settings file.

const ENTRY = /^( *)(?:"([^"]*)"|'([^']*)'|([^\s#:'"[{][^#:]*?)) *:(?:\s|$)/;

// The line, from 1, of the setting or of the nearest group around it that has a line; null if there is none.
export function lineOf(text, path) {
  const groups = [];  // those around a line, with their indentation
  let best = null;
  text.split('\n').forEach((line, index) => {
    const entry = ENTRY.exec(line);
    if (!entry) return;
    const indent = entry[1].length;
    while (groups.length && groups.at(-1).indent >= indent) groups.pop();
    groups.push({indent, key: entry[2] ?? entry[3] ?? entry[4]});
    const isOnPath = groups.length <= path.length && groups.every(({key}, depth) => key === String(path[depth]));
    if (isOnPath && groups.length > (best?.depth ?? 0)) best = {depth: groups.length, line: index + 1};
  });
  return best?.line ?? null;
}
