// The history of one link: why it failed how often, its ratio and range over time, its last fates.

import {failureOf} from '../net/requests.js';
import {causeWords, fateSign, isBlocked} from '../page/causes.js';
import {TimeChart} from '../charts/charts.js';
import {element, KeyedList, setText} from '../page/dom.js';
import {Poller} from '../net/poller.js';
import {clip, missionTime, ratio} from '../page/text.js';

/** The causes with their counts, the most frequent first. */
export function causeCounts(causes) {
  return Object.entries(causes ?? {})
    .filter(([, count]) => Number.isFinite(count))
    .map(([cause, count]) => ({cause, count}))
    .sort((a, b) => b.count - a.count || a.cause.localeCompare(b.cause));
}

export class LinkPanel {
  constructor(page, parent, onClose) {
    this.page = page;
    this.link = null;
    this.title = element('h3', {id: 'link-title'});
    this.kinds = element('p', {class: 'dim'});
    this.causes = element('tbody');
    this.fates = element('ol', {class: 'fates', 'aria-label': 'Last fates of this link'});
    this.charts = element('div', {class: 'charts'});
    this.root = element('section', {id: 'link', hidden: true},
      element('header', {class: 'row'}, this.title,
        element('button', {type: 'button', class: 'close', 'aria-label': 'Close the link',
          onclick: onClose}, '✕')),
      this.kinds,
      element('table', {class: 'causes'},
        element('caption', {}, 'What became of its transmissions'), this.causes),
      this.charts, element('h4', {}, 'Last fates'), this.fates);
    parent.append(this.root);
    /** @type {?TimeChart} */
    this.ratioChart = null;
    /** @type {?TimeChart} */
    this.rangeChart = null;
    this.causeList = new KeyedList(this.causes, (cause) => this.#causeRow(cause));
    this.fateList = new KeyedList(this.fates, () => fateRow());
    this.poller = new Poller(page.isRecorded ? 300 : 1000, () => this.#ask(), () => (
      page.isRecorded ? `${this.link?.from}>${this.link?.to}@${page.source.t}` : null));
  }

  /** @param {?{from: string, to: string}} link  null: none */
  open(link) {
    const same = link && this.link && link.from === this.link.from && link.to === this.link.to;
    this.link = link;
    this.root.hidden = !link;
    if (same) return;
    this.poller.stop();
    if (!link) return;
    setText(this.title, `${link.from} → ${link.to}`);
    setText(this.kinds, '');
    this.causeList.clear();
    this.fateList.clear();
    if (this.visible) this.poller.start();
    this.poller.renew();
  }

  show(visible) {
    this.visible = visible;
    if (visible && this.link) this.poller.start();
    else this.poller.stop();
  }

  restyle() {
    this.ratioChart?.restyle();
    this.rangeChart?.restyle();
  }

  async #ask() {
    if (!this.link) return;
    const {from, to} = this.link;
    let answer;
    try {
      answer = await this.page.requests.get('/api/link', {from, to, ...this.page.query()});
    } catch (error) {
      const {status, message} = failureOf(error);
      if (status === 400 || status === 404) setText(this.kinds, message);
      throw error;
    }
    if (this.link?.from === from && this.link?.to === to) this.#update(answer);
  }

  #update(answer) {
    const kinds = Object.entries(answer.by_kind ?? {}).map(([kind, {delivered, offered}]) =>
      `${kind}: ${delivered} of ${offered} delivered (${ratio(delivered, offered)})`);
    setText(this.kinds, kinds.length > 0 ? kinds.join(' · ') : 'Nothing was sent on this link.');
    const counts = causeCounts(answer.causes);
    this.most = Math.max(1, ...counts.map(({count}) => count));
    this.causeList.sync(counts, ({cause}) => cause);
    this.#updateCharts(answer);
    const fates = Array.isArray(answer.fates) ? answer.fates.slice(0, 50) : [];
    this.fateList.sync(fates, (fate) => String(fate.id));
  }

  #updateCharts({ratio: bins, range}) {
    this.ratioChart ??= new TimeChart(this.charts, {
      title: 'Delivered', unit: '%', digits: 0, span: 100, floor: 0, bars: true,
      series: [{label: 'of what was sent', color: '--chart-1'}]});
    this.rangeChart ??= new TimeChart(this.charts, {
      title: 'Range', unit: 'm', digits: 1, span: 20, floor: 0,
      series: [{label: 'between the two', color: '--chart-1'},
        {label: 'limit', color: '--chart-2', dash: true}]});
    const percent = (bins?.delivered ?? []).map((delivered, i) => (
      bins.offered[i] > 0 ? (100 * delivered) / bins.offered[i] : null));
    this.ratioChart.setData(bins?.t, [percent]);
    this.rangeChart.setData(range?.t, [range?.range_m, range?.limit_m]);
  }

  #causeRow(cause) {
    const count = element('td', {class: 'number'});
    const bar = element('i', {class: isBlocked(cause) ? 'bar blocked' : 'bar'});
    const root = element('tr', {'data-cause': cause},
      element('th', {scope: 'row'}, `${fateSign(cause)} ${clip(causeWords(cause), 40)}`), count,
      element('td', {class: 'bars'}, bar));
    return {
      root,
      update: (item) => {
        setText(count, String(item.count));
        bar.style.width = `${(100 * item.count) / (this.most ?? item.count)}%`;
      },
    };
  }
}

/** A row of a list of fates; its text is the viewer's. */
export function fateRow() {
  const sign = element('b', {class: 'sign', 'aria-hidden': 'true'});
  const time = element('time');
  const text = element('span');
  const root = element('li', {}, sign, time, text);
  let shown = null;
  return {
    root,
    update: (fate) => {
      const line = `${fate.t} ${fate.text}`;
      if (shown === line) return;
      shown = line;
      root.dataset.cause = clip(fate.cause, 40);
      root.dataset.blocked = String(isBlocked(fate.cause));
      setText(sign, fateSign(fate.cause));
      setText(time, missionTime(fate.t));
      const times = fate.count > 1 ? ` (× ${fate.count})` : '';
      setText(text, clip(fate.text) + times);
    },
  };
}
