// Comms: the link matrix, one link's history, the fates.

import {element} from '../page/dom.js';
import {FatesPanel} from './panel_fates.js';
import {LinkPanel} from './panel_link.js';
import {LinkMatrix} from './panel_matrix.js';
import {Poller} from '../net/poller.js';

export class CommsPanel {
  constructor(page, root) {
    this.page = page;
    root.replaceChildren();
    const part = element('section', {}, element('h3', {}, 'Links'));
    root.append(part);
    this.matrix = new LinkMatrix(part, (from, to) => page.openLink(from, to),
      () => this.poller.renew());
    this.link = new LinkPanel(page, root, () => page.openLink(null, null));
    this.fates = new FatesPanel(page, root);
    this.poller = new Poller(page.isRecorded ? 300 : 1000, () => this.#ask(),
      () => (page.isRecorded ? `${this.matrix.medium}@${page.source.t}` : null));
  }

  show(visible) {
    if (visible) this.poller.start();
    else this.poller.stop();
    this.link.show(visible);
    this.fates.show(visible);
  }

  /** @param {?{from: string, to: string}} link */
  openLink(link) {
    this.link.open(link);
    this.matrix.choose(link);
    if (link) this.link.root.scrollIntoView({block: 'nearest'});
  }

  reset() {
    this.matrix.reset();
    this.fates.reset();
    this.poller.renew();
    this.link.poller.renew();
  }

  restyle() {
    this.link.restyle();
  }

  async #ask() {
    const {medium} = this.matrix;
    const links = await this.page.requests.get('/api/links', {medium, ...this.page.query()});
    if (medium === this.matrix.medium) this.matrix.update(links, this.page.link);
  }
}
