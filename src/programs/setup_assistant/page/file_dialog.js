// The dialog that chooses one of the files that the server may read.
import {get} from './api.js';
import {h, patch} from './dom.js';
import {bytes} from './numbers.js';

const lastFolders = new Map();  // by kind
let asked = 0;                  // counts the requests for folders: the answer to an earlier one is not shown

// Returns the file's path, or null. Begins in the folder of `current`, if that is an absolute path.
export function browse(kind, what, current) {
  const dialog = document.getElementById('dialog');
  return new Promise((resolve) => {
    const choose = (file) => dialog.close(file ?? '');
    dialog.onclose = () => {
      ++asked;
      resolve(dialog.returnValue || null);
    };
    dialog.returnValue = '';
    dialog.setAttribute('aria-label', `Choose: ${what}`);
    const show = async (folder, instead) => {
      const question = ++asked;
      let listing = await list(folder, kind);
      if (listing.error && instead !== undefined) listing = await list(instead, kind);
      if (question !== asked) return;
      if (!listing.error) lastFolders.set(kind, listing.folder);
      patch(dialog, view(listing, kind, what, show, choose));
    };
    const first = folderOf(current) ?? lastFolders.get(kind) ?? '';
    patch(dialog, view({folder: first, folders: [], files: [], isRead: false}, kind, what, show, choose));
    dialog.showModal();
    show(first, '');
  });
}

function folderOf(path) {
  return typeof path === 'string' && path.startsWith('/') ? path.replace(/\/[^/]*$/, '') || '/' : null;
}

async function list(folder, kind) {
  try {
    return await get('api/files', {folder: folder || null, kind: kind === 'folder' ? 'any' : kind});
  } catch (error) {
    return {folder: folder ?? '', parent: null, folders: [], files: [], error: error.message};
  }
}

function view({folder, parent, folders, files, error, isRead = true}, kind, what, show, choose) {
  const isFolder = kind === 'folder';
  const isRoot = !folder;
  return [
    h('header', {class: 'dialog-head'}, h('h2', {}, `Choose: ${what}`),
      h('button', {type: 'button', class: 'quiet', 'aria-label': 'Close', onclick: () => choose(null)}, '\u00d7')),
    h('p', {class: 'folder'}, folder || 'Folders that may be read'),
    h('ul', {class: 'listing'},
      !isRoot &&
          h('li', {},
            h('button', {type: 'button', onclick: () => show(parent ?? '')}, h('span', {class: 'kind'}, '\u2191'),
              h('span', {class: 'name'}, 'up'))),
      folders.map((each) => {
        const path = each.path ?? (typeof each === 'string' ? joined(folder, each) : joined(folder, each.name));
        return h(
            'li', {key: `folder ${path}`},
            h('button', {type: 'button', onclick: () => show(path)}, h('span', {class: 'kind'}, '\u25b8'),
              h('span', {class: 'name'}, `${each.name ?? each}/`)));
      }),
      (isFolder ? [] : files)
          .map(
              (each) =>
                  h('li', {key: `file ${each.path}`},
                    h('button', {type: 'button', onclick: () => choose(each.path)}, h('span', {class: 'kind'}),
                      h('span', {class: 'name'}, each.name), h('span', {class: 'size'}, bytes(each.size)))))),
    error ? h('p', {class: 'problems'}, error) : null,
    !error && folders.length + files.length === 0 ?
        h('p', {class: 'empty'}, isRead ? 'Nothing of this kind is here.' : 'Reading\u2026') :
        null,
    isFolder && !isRoot ?
        h('p', {}, h('button', {type: 'button', class: 'primary', onclick: () => choose(folder)}, 'Take this folder')) :
        null,
  ];
}

function joined(folder, name) {
  return folder ? `${folder.replace(/\/$/, '')}/${name}` : name;
}
