// The processes' own status pages (APPCAST), those with warnings first.

import {element, KeyedList, setAttribute, setText} from '../page/dom.js';
import {Poller} from '../net/poller.js';
import {age, clip, missionTime} from '../page/text.js';

const kLongestPage = 20000;
const kOld_s = 6;

/** Does a page contain all words of `filter`, in its name, warnings or text? */
export function pageMatches(page, filter) {
  const all = [page.app, page.text, ...(page.config_warnings ?? []), ...(page.run_warnings ?? [])]
    .join('\n').toLowerCase();
  return filter.toLowerCase().split(/\s+/).every((word) => all.includes(word));
}

const warningsOf = (page) => [
  ...(page.config_warnings ?? []).map((text) => `configuration: ${text}`),
  ...(page.run_warnings ?? []),
];

export class StatusPanel {
  constructor(page, root) {
    this.page = page;
    this.pages = [];
    this.filter = element('input', {type: 'search', id: 'status-filter', placeholder: 'helm alpha',
      oninput: () => this.#show()});
    this.note = element('p', {class: 'dim'});
    this.place = element('div', {id: 'status'});
    this.list = new KeyedList(this.place, (app) => this.#page(app));
    root.replaceChildren(element('section', {},
      element('h3', {}, 'Status pages of the processes'),
      element('label', {class: 'filters', hidden: page.isRecorded},
        'Show only those with ', this.filter),
      this.note, this.place));
    this.poller = new Poller(1000, () => this.#ask());
    if (page.isRecorded) {
      setText(this.note, 'A recorded mission has no status pages: processes send them only while ' +
        'a viewer asks, and logs leave them out. Look at them in a running mission.');
    } else {
      setText(this.note, 'Asking the processes …');
    }
  }

  show(visible) {
    if (visible && !this.page.isRecorded) this.poller.start();
    else this.poller.stop();
  }

  reset() {
    this.list.clear();
    this.poller.renew();
  }

  async #ask() {
    const answer = await this.page.requests.get('/api/status');
    this.pages = Array.isArray(answer.pages) ? answer.pages : [];
    this.#show();
  }

  #show() {
    const filter = this.filter.value.trim();
    const shown = this.pages.filter((page) => filter === '' || pageMatches(page, filter));
    this.list.sync(shown, ({app}) => app);
    const warned = shown.filter((page) => warningsOf(page).length > 0).length;
    const count = this.pages.length === 0 ? 'No process has answered yet.'
      : `${shown.length} of ${this.pages.length} pages; ${warned} with warnings.`;
    setText(this.note, count);
  }

  #page(app) {
    const sign = element('b', {class: 'sign'});
    const when = element('span', {class: 'dim'});
    const warnings = element('ul', {class: 'warnings'});
    const warningList = new KeyedList(warnings, () => {
      const root = element('li');
      return {root, update: (item) => setText(root, `⚠ ${clip(item.text, 500)}`)};
    });
    const text = element('pre');
    const root = element('details', {'data-app': app},
      element('summary', {}, sign, ' ', element('strong', {}, app), ' ', when), warnings, text);
    let opened = false;
    return {
      root,
      update: (page) => {
        const found = warningsOf(page);
        setText(sign, found.length > 0 ? `⚠ ${found.length}` : '✓');
        setAttribute(root, 'data-warned', found.length > 0 ? 'true' : null);
        if (found.length > 0 && !opened) root.open = opened = true;
        const old = page.age_s > kOld_s ? `, silent for ${age(page.age_s)}` : '';
        setText(when, `at ${missionTime(page.t)}${old}`);
        warningList.sync(found.slice(0, 50).map((warning, i) => ({text: warning, key: String(i)})),
          ({key}) => key);
        setText(text, clip(page.text, kLongestPage));
      },
    };
  }
}
