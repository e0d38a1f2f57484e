// The mission file while it is edited: its text, what the viewer finds in it, and the way back.
//
//   const editor = new PlanEditor(requests, (plan) => ...);
//   await editor.open();
//   await editor.edit({do: 'move', handle: 3, point: 0, points: [[10, -20]]});
//
// The viewer makes every change of the text and checks it (docs/extending/viewer_protocol.md, /api/plan): the
// page never writes TOML by itself.

const kMaxSteps = 100;
const kRun_ms = 50_000;  // A mission is started, and its viewer.

const arrayOf = (value) => (Array.isArray(value) ? value : []);
const texts = (value) => arrayOf(value).filter((text) => typeof text === 'string').slice(0, 200);

/**
 * @typedef {object} PlanHandle  places that can be moved
 * @property {string} vehicle  "": of the mission
 * @property {string} name
 * @property {string} kind
 * @property {string} key
 * @property {string} updates  the variable of a behavior's updates, or ""
 * @property {'point' | 'line' | 'polygon'} shape
 * @property {[number, number][]} points
 *
 * @typedef {object} Plan
 * @property {string} file
 * @property {string} text
 * @property {boolean} mayWrite
 * @property {string[]} errors
 * @property {string[]} warnings
 * @property {PlanHandle[]} handles
 * @property {string[]} vehicles
 * @property {any} setup  what a map draws; null where there are errors
 */

/** What came from the viewer, in a shape that can be relied on. @returns {Plan} */
export function tidyPlan(answer) {
  return {
    file: String(answer?.file ?? ''),
    text: String(answer?.text ?? ''),
    mayWrite: answer?.may_write === true,
    errors: texts(answer?.errors),
    warnings: texts(answer?.warnings),
    vehicles: texts(answer?.vehicles),
    handles: arrayOf(answer?.handles).filter((handle) => typeof handle?.kind === 'string'
        && ['point', 'line', 'polygon'].includes(handle.shape)).map((handle) => ({
      vehicle: String(handle.vehicle ?? ''), name: String(handle.name ?? ''), kind: handle.kind,
      key: String(handle.key ?? ''), updates: String(handle.updates ?? ''), shape: handle.shape,
      points: arrayOf(handle.points).filter((point) => Number.isFinite(point?.[0])
          && Number.isFinite(point?.[1])),
    })).filter(({points}) => points.length > 0),
    setup: typeof answer?.setup === 'object' ? answer.setup : null,
  };
}

/** Names a handle for a person: "alpha, loiter_west (loiter)". */
export function handleWords({vehicle, name, kind}) {
  const what = name === '' || name === kind ? kind : `${name} (${kind})`;
  return vehicle === '' ? what : `${vehicle}, ${what}`;
}

const kMaxCompared = 400;  // Lines of each side; more are listed as a whole.

/**
 * Returns the lines that differ, in order: {line, before, after}, of which one is null. `line` counts
 * from 1 in the text that has it.
 */
export function changedLines(before, after) {
  const [a, b] = [before.split('\n'), after.split('\n')];
  let first = 0;
  while (first < a.length && first < b.length && a[first] === b[first]) ++first;
  while (a.length > first && b.length > first && a.at(-1) === b.at(-1)) {
    a.pop();
    b.pop();
  }
  const [removed, added] = [a.slice(first), b.slice(first)];
  const isSmall = removed.length <= kMaxCompared && added.length <= kMaxCompared;
  const common = isSmall ? commonLengths(removed, added) : null;
  const changes = [];
  let [i, k] = [0, 0];
  while (i < removed.length || k < added.length) {
    if (common && i < removed.length && k < added.length && removed[i] === added[k]) {
      ++i;
      ++k;
    } else if (k === added.length
        || (i < removed.length && (!common || common[i + 1][k] >= common[i][k + 1]))) {
      changes.push({line: first + i + 1, before: removed[i], after: null});
      ++i;
    } else {
      changes.push({line: first + k + 1, before: null, after: added[k]});
      ++k;
    }
  }
  return changes;
}

/** Of the rests from i and k: how long their longest common subsequence is (Wagner, Fischer 1974). */
function commonLengths(a, b) {
  const lengths = Array.from({length: a.length + 1}, () => new Uint16Array(b.length + 1));
  for (let i = a.length - 1; i >= 0; --i) {
    for (let k = b.length - 1; k >= 0; --k) {
      lengths[i][k] = a[i] === b[k] ? lengths[i + 1][k + 1] + 1
        : Math.max(lengths[i + 1][k], lengths[i][k + 1]);
    }
  }
  return lengths;
}

const keyOf = ({vehicle, name, kind, key}) => [vehicle, name, kind, key].join('\0');
const kMovable = ['waypoints', 'path_follow', 'survey', 'loiter', 'station_keep', 'return'];

/**
 * Returns the orders, {target, words}, by which vehicles that are under way take the changes from
 * `before` to `after`, and in `left` what can only be of a new run.
 */
export function updatesBetween(before, after) {
  const known = new Map(before.handles.map((handle) => [keyOf(handle), handle]));
  const orders = [];
  const left = [];
  for (const handle of after.handles) {
    const old = known.get(keyOf(handle));
    if (old && JSON.stringify(old.points) === JSON.stringify(handle.points)) continue;
    const {vehicle: target, name, kind, key, updates, points} = handle;
    const numbers = points.flat().map(String);
    if (old && target !== '' && updates !== '') {
      const text = points.map((point) => point.join(',')).join(':');
      orders.push({target, words: ['set', `${updates}=${key} = ${text}`]});
    } else if (old && target !== '' && name !== '' && kMovable.includes(kind)
        && ['points', 'polygon', 'center', 'point'].includes(key)) {
      orders.push({target, words: ['move', name, ...numbers]});
    } else {
      left.push(handleWords(handle));
    }
  }
  return {orders, left};
}

export class PlanEditor {
  /** @type {Plan | null} */
  plan = null;
  /** @type {Plan | null} As the file has it. */
  original = null;
  #requests;
  #onChange;
  #before = [];    // Texts to go back to.
  #asked = 0;

  /** @param onChange  is called after each change, with the plan; null: it was closed */
  constructor(requests, onChange) {
    this.#requests = requests;
    this.#onChange = onChange;
  }

  get isOpen() { return this.plan !== null; }
  get isChanged() { return this.plan !== null && this.plan.text !== this.original?.text; }
  get canUndo() { return this.#before.length > 0; }

  /** Asks for the mission's file. Throws a RequestError. */
  async open() {
    this.original = await this.#ask({});
    this.#before = [];
    this.#take(this.original);
  }

  close() {
    this.#asked += 1;
    this.original = null;
    this.#before = [];
    this.#take(null);
  }

  /** Makes one change; throws an error that states why it cannot be made. */
  async edit(edit) {
    await this.#change({text: this.plan?.text, edit});
  }

  /** Takes a text that the user has written. */
  async setText(text) {
    if (text !== this.plan?.text) await this.#change({text});
  }

  async undo() {
    const text = this.#before.pop();
    if (text === undefined) return;
    this.#take(await this.#ask({text}));
  }

  async revert() {
    if (this.original) await this.#change({text: this.original.text});
  }

  /** Writes the text as a new file; returns its path. */
  async save() {
    return (await this.#requests.post('/api/plan/write', {text: this.plan?.text})).file;
  }

  /** Writes it and runs it; returns {file, url}. */
  async run() {
    return this.#requests.post('/api/plan/run', {text: this.plan?.text}, kRun_ms);
  }

  async #change(question) {
    const before = this.plan?.text;
    const asked = ++this.#asked;
    const plan = await this.#ask(question);
    if (asked !== this.#asked) return;  // A later one is on its way.
    if (before !== undefined && before !== plan.text) {
      this.#before.push(before);
      this.#before.splice(0, this.#before.length - kMaxSteps);
    }
    this.#take(plan);
  }

  async #ask(question) {
    return tidyPlan(await this.#requests.post('/api/plan', question));
  }

  #take(plan) {
    this.plan = plan;
    this.#onChange(plan);
  }
}
