// Shows a section of the documentation over the page.
import {h, patch} from './dom.js';

// `section`: its anchor, as in links to it; '' for the whole document.
export async function showDocument(document_name, section) {
  const dialog = document.getElementById('dialog');
  const show = (content) => patch(dialog, [
    h('header', {class: 'dialog-head', key: 'head'}, h('p', {class: 'folder'}, `docs/${document_name}.md`),
      h('button', {type: 'button', class: 'quiet', 'aria-label': 'Close', onclick: () => dialog.close()}, '\u00d7')),
    h('div', {class: 'document', key: `${document_name}#${section}`}, content)
  ]);
  dialog.setAttribute('aria-label', `Documentation: ${document_name}`);
  dialog.onclose = null;
  show(h('p', {class: 'empty'}, 'Reading\u2026'));
  if (!dialog.open) dialog.showModal();
  const response = await fetch(`page/${document_name}.md`);
  show(
      response.ok ? drawn(sectionOf(await response.text(), section), document_name) :
                    h('p', {class: 'empty'}, 'This part of the documentation is not here.'));
}

export function anchorOf(heading) {
  return heading.trim().toLowerCase().replace(/[^\w\- ]/g, '').replaceAll(' ', '-');
}

export function sectionOf(text, section) {
  const lines = text.split('\n');
  const isHeading = (line) => line.startsWith('## ');
  const begin = lines.findIndex((line) => isHeading(line) && anchorOf(line.slice(3)) === section);
  if (begin < 0) return text;
  const end = lines.findIndex((line, index) => index > begin && isHeading(line));
  return lines.slice(begin, end < 0 ? lines.length : end).join('\n');
}

// --- The parts of Markdown that the documentation uses ---

function drawn(text, document_name) {
  return blocksOf(text).map((lines) => block(lines, (each) => inline(each, document_name)));
}

// Lines that belong together: fenced code, tables, paragraphs and lists.
function blocksOf(text) {
  const blocks = [];
  let current = [];
  let isCode = false;
  const finish = () => {
    if (current.length) blocks.push(current);
    current = [];
  };
  for (const line of text.split('\n')) {
    const isFence = line.startsWith('```');
    if (isFence && !isCode) finish();
    if (isCode || line.trim()) current.push(line);
    if ((!line.trim() && !isCode) || (isFence && isCode)) finish();
    if (isFence) isCode = !isCode;
  }
  finish();
  return blocks;
}

function block(lines, text) {
  const [first] = lines;
  if (first.startsWith('```')) return h('pre', {}, lines.slice(1, -1).join('\n'));
  if (first.startsWith('#')) return h('h2', {}, text(first.replace(/^#+ /, '')), paragraph(lines.slice(1), text));
  if (first.startsWith('|')) return table(lines, text);
  if (/^(?:[-*]|\d+\.) /.test(first)) return list(lines, text);
  return first.startsWith('![') ? null : paragraph(lines, text);
}

function paragraph(lines, text) {
  return lines.length ? h('p', {}, text(lines.join(' '))) : null;
}

function table(lines, text) {
  const rows = lines.map((line) => line.replace(/^\||\|\s*$/g, '').split('|').map((cell) => text(cell.trim())));
  return h(
      'div', {class: 'table'},
      h('table', {}, h('thead', {}, h('tr', {}, rows[0].map((cell) => h('th', {scope: 'col'}, cell)))),
        h('tbody', {}, rows.slice(2).map((row) => h('tr', {}, row.map((cell) => h('td', {}, cell)))))));
}

function list(lines, text) {
  const items = [];
  for (const line of lines) {
    const item = /^(?:[-*]|\d+\.) (.*)$/.exec(line);
    if (item)
      items.push(item[1]);
    else
      items.push(`${items.pop() ?? ''} ${line.trim()}`);
  }
  return h('ul', {class: 'listed'}, items.map((item) => h('li', {}, text(item))));
}

const MARKS = /(`[^`]+`|\*\*[^*]+\*\*|\[[^\]]+\]\([^)]+\))/;

function inline(text, document_name) {
  return text.split(MARKS).map((part) => {
    if (part.startsWith('`') && part.length > 1) return h('code', {}, part.slice(1, -1));
    if (part.startsWith('**') && part.length > 4) return h('strong', {}, inline(part.slice(2, -2), document_name));
    const link = /^\[([^\]]+)\]\(([^)]+)\)$/.exec(part);
    return link ? linked(inline(link[1], document_name), link[2], document_name) : part;
  });
}

function linked(text, address, document_name) {
  if (/^https?:/.test(address)) return h('a', {href: address, target: '_blank', rel: 'noreferrer'}, text);
  const [, other, section] = /^(?:([\w/]+)\.md)?(?:#(.*))?$/.exec(address) ?? [];
  const isHere = other !== undefined || section !== undefined;
  if (!isHere) return h('span', {}, text);
  const show = () => showDocument(other ?? document_name, section ?? '');
  return h('button', {type: 'button', class: 'link', onclick: show}, text);
}
