// Settings are named by paths: arrays of keys and of indices in lists.

export function valueAt(tree, path) {
  let value = tree;
  for (const key of path) {
    if (value === null || typeof value !== 'object') return undefined;
    value = value[key];
  }
  return value === null ? undefined : value;
}

export function keyOf(path) {
  return path.join('/');
}

export function startsWith(path, beginning) {
  return beginning.every((key, index) => String(key) === String(path[index]));
}

export function isEqual(a, b) {
  return JSON.stringify(a) === JSON.stringify(b);
}

// A name that none of the others has: camera, camera_2, camera_3.
export function freeName(wanted, others) {
  for (let count = 1;; ++count) {
    const name = count === 1 ? wanted : `${wanted}_${count}`;
    if (!others.includes(name)) return name;
  }
}
