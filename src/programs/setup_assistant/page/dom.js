// Draws trees of elements and changes what differs from the last drawing. All text becomes text nodes, so names from
// users' files are never read as HTML.

const SVG = 'http://www.w3.org/2000/svg';
const PROPERTIES = new Set(['checked', 'disabled', 'indeterminate', 'hidden', 'multiple', 'readOnly', 'selected']);

// null, undefined and false keep their position, so that what follows keeps its element, and with it the focus.
export function h(tag, props, ...children) {
  return {tag, props: props ?? {}, children: children.flat(Infinity)};
}

export function patch(parent, children, namespace = null) {
  // Removes first what is no longer drawn: an element that is moved past it would lose the focus.
  const keys = new Set(children.map((child) => child?.props?.key));
  const keyed = new Map();
  for (const node of Array.from(parent.childNodes)) {
    const key = node.drawn?.props?.key;
    if (key === undefined) continue;
    if (keys.has(key))
      keyed.set(key, node);
    else
      node.remove();
  }
  let at = parent.firstChild;
  for (const child of children) {
    const key = child?.props?.key;
    const candidate = key === undefined ? at : keyed.get(key);
    if (candidate && isSameKind(candidate, child)) {
      if (candidate === at)
        at = at.nextSibling;
      else
        parent.insertBefore(candidate, at);
      update(candidate, child, namespace);
    } else {
      parent.insertBefore(create(child, namespace), at);
      if (at && key === undefined && at.drawn?.props?.key === undefined) {
        const replaced = at;
        at = at.nextSibling;
        replaced.remove();
      }
    }
  }
  while (at) {
    const next = at.nextSibling;
    at.remove();
    at = next;
  }
}

function isNothing(child) {
  return child === null || child === undefined || child === false;
}

function isSameKind(node, child) {
  if (isNothing(child)) return node.nodeType === Node.COMMENT_NODE;
  if (typeof child !== 'object') return node.nodeType === Node.TEXT_NODE;
  return node.drawn?.tag === child.tag && node.drawn.props.key === child.props.key;
}

function create(child, namespace) {
  if (isNothing(child)) return document.createComment('');
  if (typeof child !== 'object') return document.createTextNode(String(child));
  const inside = child.tag === 'svg' ? SVG : namespace;
  const node = inside ? document.createElementNS(inside, child.tag) : document.createElement(child.tag);
  node.drawn = {tag: child.tag, props: {key: child.props.key}};
  if (['INPUT', 'TEXTAREA'].includes(node.tagName)) watchTyping(node);
  update(node, child, namespace);
  child.props.created?.(node);
  return node;
}

// Marks what is being typed or dragged, which the server's last answer must not overwrite.
function watchTyping(node) {
  node.addEventListener('input', () => {
    node.isEdited = true;
  });
  for (const end of ['change', 'blur'])
    node.addEventListener(end, () => {
      node.isEdited = false;
    });
}

function update(node, child, namespace) {
  if (isNothing(child)) return;
  if (typeof child !== 'object') {
    if (node.data !== String(child)) node.data = String(child);
    return;
  }
  const before = node.drawn.props;
  for (const name of Object.keys(before)) {
    if (!(name in child.props)) setProperty(node, name, undefined, before[name]);
  }
  for (const [name, value] of Object.entries(child.props)) {
    if (name !== 'value') setProperty(node, name, value, before[name]);
  }
  node.drawn = child;
  if (!child.props.unmanaged) patch(node, child.children, child.tag === 'svg' ? SVG : namespace);
  // Set after the children, since a select has its options only then.
  if ('value' in child.props && !node.isEdited) {
    const text = String(child.props.value ?? '');
    if (node.value !== text) node.value = text;
  }
}

function setProperty(node, name, value, before) {
  if (['key', 'created', 'unmanaged', 'value'].includes(name)) return;
  if (name === 'opened') {
    // Details stay as the user left them, but open when there is something to see.
    if (value && !before) node.open = true;
  } else if (name.startsWith('on')) {
    node[name] = value ?? null;
  } else if (PROPERTIES.has(name)) {
    if (node[name] !== Boolean(value)) node[name] = Boolean(value);
  } else if (name === 'style') {
    for (const [key, each] of Object.entries(value ?? {})) node.style.setProperty(key, each);
  } else if (value === undefined || value === null || value === false) {
    node.removeAttribute(name);
  } else if (value !== before || !node.hasAttribute(name)) {
    node.setAttribute(name, value === true ? '' : String(value));
  }
}
