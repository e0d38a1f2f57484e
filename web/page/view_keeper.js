// Keeps the view in the page's address, and takes it from there.

import {writePlots} from '../charts/field_series.js';
import {kPulseStyles} from '../map/draw_signals.js';
import {kLayers} from './top_bar.js';
import {readHash, writeHash} from './url_state.js';

const kLeastBetweenWrites_ms = 300;  // Browsers allow 100 in 30 s and more.

export class ViewKeeper {
  constructor(page) {
    this.page = page;
    this.layerNames = kLayers.map(([name]) => name);
    this.firstLayers = {...page.map.view.layers};
    this.written_ms = -Infinity;
    this.dirty = false;
    addEventListener('hashchange', () => {
      if (location.hash !== this.hash) this.restore();
    });
    const {theme} = readHash(location.hash, this.layerNames);
    document.documentElement.className = theme ?? 'dark';
  }

  /** The view is another one than the address shows. */
  changed() {
    this.dirty = true;
  }

  /** Takes the view from the address; what it does not name stays. */
  restore() {
    const {page} = this;
    const state = readHash(location.hash, this.layerNames);
    const theme = state.theme ?? document.documentElement.className;
    if (theme !== document.documentElement.className) page.setTheme(theme);
    page.tabs.show(state.tab ?? page.tabs.current ?? 'vehicle');
    const names = page.setup.vehicles.map(({name}) => name);
    if (names.includes(state.select) || page.names().includes(state.select)) {
      page.select(state.select);
    } else {
      this.wanted = state.select;
    }
    if (state.from !== null && state.to !== null) page.openLink(state.from, state.to);
    const plots = state.plots ?? [];
    if (writePlots(plots) !== writePlots(page.panels.data.plots)) {
      page.panels.data.setPlots(plots);
    }
    if (state.layers) page.map.view = {layers: state.layers};
    page.top.showLayers(page.map.view.layers);
    if (state.pulses) page.map.view = {pulseStyle: state.pulses};
    page.top.showPulseStyle(page.map.view.pulseStyle);
    this.#place(state);
    if (page.isRecorded && state.t !== null) page.source.seek(state.t);
    this.hash = location.hash;
    this.dirty = false;
  }

  /** Chooses a vehicle of the address that only frames know. */
  firstFrame() {
    if (this.wanted && this.page.names().includes(this.wanted)) this.page.select(this.wanted);
    this.wanted = null;
  }

  /** Writes the address, now and then. */
  tick() {
    const now_ms = performance.now();
    const moves = this.page.isRecorded && this.page.source.t !== this.written_t;
    if ((!this.dirty && !moves) || now_ms - this.written_ms < kLeastBetweenWrites_ms) return;
    this.dirty = false;
    this.written_ms = now_ms;
    this.written_t = this.page.source.t;
    this.hash = writeHash(this.#state());
    history.replaceState(null, '', location.pathname + location.search + this.hash);
  }

  #place({x, y, metresPerPixel, follow}) {
    const {map} = this.page;
    if (x !== null && y !== null && metresPerPixel !== null) {
      map.view = {cx: x, cy: y, metresPerPixel};
    }
    if (follow !== map.view.follow) map.follow(follow);
  }

  #state() {
    const {page} = this;
    const {cx, cy, metresPerPixel, follow, layers, pulseStyle} = page.map.view;
    const sameLayers = this.layerNames.every((name) => layers[name] === this.firstLayers[name]);
    return {
      x: cx, y: cy, metresPerPixel, follow, select: page.selected, from: page.link?.from,
      to: page.link?.to, layers: sameLayers ? null : layers, tab: page.tabs.current,
      plots: page.panels.data.plots,
      t: page.isRecorded ? page.source.t : null, theme: document.documentElement.className,
      pulses: pulseStyle === kPulseStyles[0][0] ? null : pulseStyle,
    };
  }
}
