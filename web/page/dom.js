// Making and changing elements. Text from messages becomes text nodes and nothing else.

/**
 * Makes an element. Attributes that begin with "on" are listeners, `class` and `data-...` are
 * written as in HTML, null and false leave an attribute out, true sets it without a value.
 * Children are nodes or texts; null is left out.
 */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === false || value === undefined) continue;
    if (typeof value === 'function') made.addEventListener(name.slice(2), value);
    // Set this way it needs no unsafe-inline of the page's security policy.
    else if (name === 'style') made.style.cssText = String(value);
    else made.setAttribute(name, value === true ? '' : String(value));
  }
  for (const child of children.flat()) {
    if (child !== null && child !== undefined) made.append(child);
  }
  return made;
}

/** Returns the element of the page with this id: index.html has it. @returns {HTMLElement} */
export function byId(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no element #${id}`);
  return found;
}

/** Returns what draws on a canvas. @returns {CanvasRenderingContext2D} */
export function context2d(canvas, options = {}) {
  const context = canvas.getContext('2d', options);
  if (!context) throw new Error('the browser draws on no canvas');
  return context;
}

/** Sets the text of `node`, which holds no elements, where it is another one. */
export function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

/** Sets or removes an attribute where that changes something. */
export function setAttribute(node, name, value) {
  if (value === null || value === false) {
    if (node.hasAttribute(name)) node.removeAttribute(name);
  } else if (node.getAttribute(name) !== String(value)) {
    node.setAttribute(name, String(value));
  }
}

/**
 * Keeps the children of `parent` in step with a list: one element per key, made once by
 * `create(key)`, which returns {root, update(item)}, moved only where the order changed.
 */
export class KeyedList {
  constructor(parent, create) {
    this.parent = parent;
    this.create = create;
    this.rows = new Map();
  }

  /** @param items  in their order @param keyOf  a text for each, no two alike */
  sync(items, keyOf) {
    const wanted = new Set();
    let place = this.parent.firstChild;
    for (const item of items) {
      const key = keyOf(item);
      if (wanted.has(key)) continue;
      wanted.add(key);
      let row = this.rows.get(key);
      if (!row) {
        row = this.create(key);
        this.rows.set(key, row);
      }
      row.update(item);
      if (row.root === place) place = place.nextSibling;
      else this.parent.insertBefore(row.root, place);
    }
    if (wanted.size === this.rows.size) return;
    for (const [key, row] of this.rows) {
      if (wanted.has(key)) continue;
      row.root.remove();
      this.rows.delete(key);
    }
  }

  clear() {
    for (const row of this.rows.values()) row.root.remove();
    this.rows.clear();
  }
}
