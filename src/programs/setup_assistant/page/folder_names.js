// Folders as the settings file names them: $(find package), not where that is on this machine.

const BEGINNING = /^\$\((?:find|dirname|env|optenv)[^)]*\)/;

// [folder, "$(find package)"] pairs, longest folder first.
// `written`: settings as they are in the file; `meant`: the same with substitutions filled in.
export function foldersAsWritten(written, meant) {
  const found = new Map();
  collect(written, meant, found);
  return [...found].sort(([a], [b]) => b.length - a.length);
}

function collect(written, meant, found) {
  if (typeof written === 'string' && typeof meant === 'string') {
    const name = BEGINNING.exec(written)?.[0];
    const rest = name && written.slice(name.length);
    if (!name || !meant.startsWith('/') || !meant.endsWith(rest)) return;
    const folder = meant.slice(0, meant.length - rest.length);
    if (folder) found.set(folder, name);
  } else if (written !== null && meant !== null && typeof written === 'object' && typeof meant === 'object') {
    for (const key of Object.keys(written)) collect(written[key], meant[key], found);
  }
}

export function withFoldersAsWritten(text, folders) {
  return folders.reduce((named, [folder, name]) => {
    const isWhole = (before, behind) => !/[\w./-]$/.test(before) && /^(?:[/'"`,;:\s)]|$)/.test(behind);
    return named.split(folder).reduce((all, part) => all + (isWhole(all, part) ? name : folder) + part);
  }, text ?? '');
}
