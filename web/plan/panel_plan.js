// The panel in which a mission is planned: tools, places, what is wrong, the change as TOML, and what
// becomes of it.

import {failureOf} from '../net/requests.js';
import {byId, element, setAttribute, setText} from '../page/dom.js';
import {clip} from '../page/text.js';
import {changedLines, handleWords, PlanEditor, updatesBetween} from './plan_editor.js';
import {kTools, PlanLayer} from './plan_layer.js';

const kTyped_ms = 400;   // A text is checked when the user has stopped for so long.
const kMaxShownLines = 80;
const kMaxShownErrors = 20;

const kToolLabels = {
  waypoints: ['+ waypoints', 'Click the points, then the last one once more, or Enter'],
  loiter: ['+ loiter', 'Click its centre, then a point of its circle'],
  station_keep: ['+ station', 'Click the place to stay at'],
  survey: ['+ survey', 'Click the corners of the area, then the last one once more, or Enter'],
  obstacle: ['+ obstacle', 'Click its corners, then the last one once more, or Enter'],
  area: ['+ region', 'Click the corners of the area of operations, then the last one once more, or Enter'],
};
const kOfVehicle = ['waypoints', 'loiter', 'station_keep', 'survey'];

export class PlanPanel {
  constructor(page, root) {
    this.page = page;
    this.editor = new PlanEditor(page.requests, (plan) => this.#show(plan));
    this.layer = new PlanLayer({
      onEdit: (edit) => this.#try(() => this.editor.edit(edit)),
      onDrawn: (tool, points) => this.#drawn(tool, points),
      onChosen: (handle) => this.#chose(handle),
      onTool: () => this.#showTool(),
    });
    page.map.setPlanLayer(this.layer);
    this.begin = element('button', {type: 'button', id: 'plan-begin',
      onclick: () => this.#try(() => this.editor.open())}, 'Edit the plan');
    this.intro = element('p', {class: 'hint'}, 'Drag waypoints, areas, obstacles and starts on the '
      + 'map. The change is shown as the mission file would have it, and checked as shoal check does. '
      + 'The mission file itself is never changed.');
    this.note = element('p', {id: 'plan-note', role: 'status'});
    this.body = element('div', {id: 'plan-body', hidden: true}, this.#tools(), this.#places(),
      this.#problems(), this.#changes(), this.#text(), this.#outcomes());
    root.replaceChildren(element('section', {}, element('h3', {}, 'Plan'), this.intro, this.begin,
      this.note), this.body);
    this.#show(null);
  }

  show() {}

  /** Another mission is shown. */
  reset() { this.editor.close(); }

  get isDrawing() { return this.layer.tool !== ''; }

  /** Esc: gives up what is being drawn. */
  cancel() { this.layer.cancel(); }

  /** Enter: ends what is being drawn. */
  finish() { return this.layer.finish(); }

  removeChosen() { return this.layer.isOpen && this.layer.removeChosen(); }

  async #try(work) {
    this.#state('');
    try {
      await work();
    } catch (error) {
      this.#state(failureOf(error).message, true);
      if (this.editor.plan) this.#show(this.editor.plan);
    }
  }

  #state(text, isBad = false) {
    setText(this.note, clip(text, 500));
    setAttribute(this.note, 'data-state', isBad ? 'bad' : null);
  }

  #button(id, label, title, onclick, extra = {}) {
    return element('button', {type: 'button', id, title, onclick, ...extra}, label);
  }

  #tools() {
    this.vehicle = element('select', {id: 'plan-vehicle', 'aria-label': 'Vehicle of a new task'});
    this.toolButtons = Object.keys(kTools).map((tool) => {
      const [label, title] = kToolLabels[tool];
      return this.#button(`plan-tool-${tool}`, label, title,
        () => this.layer.setTool(this.layer.tool === tool ? '' : tool),
        {'data-tool': tool, 'aria-pressed': 'false'});
    });
    this.finishButton = this.#button('plan-finish', 'Done', 'End the drawing (Enter)',
      () => this.layer.finish(), {hidden: true});
    this.hint = element('p', {class: 'dim', id: 'plan-hint', role: 'status'});
    return element('section', {}, element('label', {class: 'row'}, element('h4', {}, 'New, for'),
      this.vehicle), element('div', {class: 'buttons'}, this.toolButtons, this.finishButton), this.hint);
  }

  #places() {
    this.handle = element('select', {id: 'plan-handle', 'aria-label': 'Place to change',
      onchange: () => this.#choseInList()});
    this.points = element('table', {id: 'plan-points'});
    return element('section', {}, element('label', {class: 'row'}, element('h4', {}, 'Place'),
      this.handle), this.points);
  }

  #problems() {
    this.problems = element('ul', {id: 'plan-problems', 'aria-live': 'polite'});
    return element('section', {}, element('h4', {}, 'Check'), this.problems);
  }

  #changes() {
    this.changes = element('pre', {id: 'plan-changes', tabindex: 0, 'aria-label': 'Changed lines'});
    return element('section', {}, element('h4', {}, 'Change'), this.changes);
  }

  #text() {
    this.area = element('textarea', {id: 'plan-text', spellcheck: 'false', rows: 12,
      'aria-label': 'The mission file', oninput: () => {
        clearTimeout(this.typed);
        this.typed = setTimeout(() => this.#try(() => this.editor.setText(this.area.value)), kTyped_ms);
      }});
    return element('details', {}, element('summary', {}, 'The whole file'), this.area);
  }

  #outcomes() {
    this.undoButton = this.#button('plan-undo', 'Undo', 'take the last change back',
      () => this.#try(() => this.editor.undo()));
    this.revertButton = this.#button('plan-revert', 'As it was', 'take all changes back',
      () => this.#try(() => this.editor.revert()));
    this.sendButton = this.#button('plan-send', 'Send to the vehicles',
      'they go on by the changed plan', () => this.#send());
    this.downloadButton = this.#button('plan-download', 'Download', 'save it as a mission file',
      () => this.page.download(new Blob([this.editor.plan?.text ?? ''], {type: 'application/toml'}),
        this.#fileName()));
    this.writeButton = this.#button('plan-write', 'Write beside', 'a new file beside the mission file',
      () => this.#write());
    this.runButton = this.#button('plan-run', '▶ Write and run', 'a new file, and a run of it',
      () => this.#run());
    this.closeButton = this.#button('plan-close', 'Close', 'end planning, without the changes',
      () => this.editor.close());
    this.outcome = element('p', {id: 'plan-outcome', role: 'status'});
    return element('section', {}, element('div', {class: 'buttons'}, this.undoButton, this.revertButton,
      this.sendButton, this.downloadButton, this.writeButton, this.runButton, this.closeButton),
    this.outcome);
  }

  #fileName() {
    const name = (this.editor.plan?.file ?? '').split('/').pop() || 'mission.toml';
    return name.replace(/(\.toml)?$/, '_plan.toml');
  }

  #show(plan) {
    const isOpen = plan !== null;
    this.begin.hidden = isOpen;
    this.intro.hidden = isOpen;
    this.body.hidden = !isOpen;
    this.layer.show(plan);
    // A text with errors has no map: the last one that had stays.
    if (!isOpen) this.page.map.setPlan(null);
    else if (plan.setup) this.page.map.setPlan(plan.setup);
    if (!isOpen) return;
    this.#showVehicles(plan);
    this.#showHandles(plan);
    this.#showProblems(plan);
    this.#showChanges(plan);
    if (document.activeElement !== this.area) this.area.value = plan.text;
    const {isChanged} = this.editor;
    const isSound = plan.errors.length === 0;
    this.undoButton.disabled = !this.editor.canUndo;
    this.revertButton.disabled = !isChanged;
    this.downloadButton.disabled = !isChanged;
    for (const button of [this.writeButton, this.runButton]) {
      button.hidden = !plan.mayWrite;
      button.disabled = !isSound;
    }
    const canSend = !this.page.isRecorded && this.page.setup.commands;
    this.sendButton.hidden = !canSend;
    this.sendButton.disabled = !isChanged || !isSound;
  }

  #showVehicles({vehicles}) {
    const kept = this.vehicle.value || this.page.selected;
    this.vehicle.replaceChildren(...vehicles.map((name) => element('option', {value: name}, name)));
    if (vehicles.includes(kept)) this.vehicle.value = kept;
    for (const button of this.toolButtons ?? []) {
      button.disabled = vehicles.length === 0 && kOfVehicle.includes(button.dataset.tool ?? '');
    }
  }

  #showHandles({handles}) {
    this.handle.replaceChildren(element('option', {value: ''}, '–'), ...handles.map((handle, i) =>
      element('option', {value: String(i)}, clip(handleWords(handle), 60))));
    this.handle.value = this.layer.chosen ? String(this.layer.chosen.handle) : '';
    this.#showPoints();
  }

  #showPoints() {
    const {chosen} = this.layer;
    const handle = chosen ? this.editor.plan?.handles[chosen.handle] : null;
    if (!chosen || !handle) {
      this.points.replaceChildren();
      return;
    }
    const least = handle.shape === 'polygon' ? 3 : 1;
    const canRemove = handle.shape !== 'point' && handle.points.length > least;
    this.points.replaceChildren(element('tbody', {}, handle.points.slice(0, 200).map((point, i) =>
      element('tr', {'aria-current': chosen.point === i ? 'true' : null},
        element('th', {scope: 'row'}, String(i + 1)),
        ...['x', 'y'].map((axis, k) => element('td', {}, element('input', {type: 'number', step: 'any',
          value: point[k], 'aria-label': `${axis} of point ${i + 1}, m`, 'data-point': i, 'data-axis': axis,
          onchange: (event) => this.#typedPoint(chosen.handle, i, k, Number(event.target.value))}))),
        element('td', {}, canRemove ? element('button', {type: 'button', title: 'take it out (Delete)',
          'aria-label': `Take out point ${i + 1}`, onclick: () => this.#try(() =>
            this.editor.edit({do: 'remove', handle: chosen.handle, point: i}))}, '✕') : null)))));
  }

  #typedPoint(handle, point, axis, value) {
    const place = [...this.editor.plan?.handles[handle]?.points[point] ?? []];
    if (place.length !== 2 || !Number.isFinite(value)) return;
    place[axis] = value;
    this.#try(() => this.editor.edit({do: 'move', handle, point, points: [place]}));
  }

  #chose(handle) {
    this.handle.value = String(handle);
    this.#showPoints();
  }

  #choseInList() {
    if (this.handle.value !== '') this.layer.choose(Number(this.handle.value), 0);
  }

  #showProblems({errors, warnings}) {
    const row = (text, state, sign) => element('li', {'data-state': state}, `${sign} ${clip(text, 500)}`);
    this.problems.replaceChildren(
      ...errors.slice(0, kMaxShownErrors).map((text) => row(text, 'bad', '✗')),
      ...warnings.slice(0, kMaxShownErrors).map((text) => row(text, 'warn', '⚠')),
      ...(errors.length + warnings.length === 0 ? [row('no errors, no warnings', 'good', '✓')] : []));
  }

  #showChanges({text}) {
    const lines = changedLines(this.editor.original?.text ?? '', text);
    const shown = lines.slice(0, kMaxShownLines).map(({line, before, after}) => element('span',
      {'data-state': before === null ? 'added' : 'removed'},
      `${before === null ? '+' : '−'}${String(line).padStart(4)}  ${clip(before ?? after ?? '', 300)}\n`));
    if (lines.length > kMaxShownLines) shown.push(element('span', {}, `… ${lines.length - kMaxShownLines} more\n`));
    this.changes.replaceChildren(...(shown.length > 0 ? shown : ['nothing yet']));
  }

  #showTool() {
    if (!this.toolButtons) return;  // Of the constructor.
    const {tool, numDrawn} = this.layer;
    for (const button of this.toolButtons) {
      setAttribute(button, 'aria-pressed', String(button.dataset.tool === tool));
    }
    setText(this.hint, tool === '' ? '' : `${kToolLabels[tool][1]}. Esc: not at all.`);
    this.finishButton.hidden = tool === '' || numDrawn < kTools[tool].least;
    byId('stage').classList.toggle('aiming', tool !== '');
  }

  #drawn(tool, points) {
    const edit = tool === 'obstacle' || tool === 'area' ? {do: tool, points}
      : {do: 'task', vehicle: this.vehicle.value, kind: tool, points};
    this.#try(() => this.editor.edit(edit));
  }

  async #send() {
    const {original, plan} = this.editor;
    if (!original || !plan) return;
    const {orders, left} = updatesBetween(original, plan);
    for (const {target, words} of orders) await this.page.commands.send(target, words);
    const more = left.length > 0 ? ` Only in a new run: ${left.join('; ')}.` : '';
    this.#report(orders.length === 0 ? `Nothing of it can be sent.${more}`
      : `${orders.length} sent; the panel Commands shows what became of them.${more}`);
  }

  #report(text, ...more) {
    this.outcome.replaceChildren(clip(text, 500), ...more);
  }

  #write() {
    return this.#try(async () => this.#report(`Written: ${await this.editor.save()}`));
  }

  #run() {
    return this.#try(async () => {
      this.runButton.disabled = true;
      this.#report('The mission starts …');
      try {
        const {file, url} = await this.editor.run();
        // Of a viewer on this machine; other addresses are no links.
        const isOwn = /^http:\/\/[\w.:[\]-]+\/(\?token=[0-9a-f]+)?$/.test(String(url));
        this.#report(`${file} runs. `, isOwn ? element('a', {id: 'plan-open', href: url, target: '_blank',
          rel: 'noopener'}, 'Open its viewer') : String(url));
      } catch (error) {
        this.#report('');
        throw error;
      } finally {
        this.runButton.disabled = false;
      }
    });
  }
}
