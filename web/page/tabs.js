// The panels at the side, one of which is seen. Arrow keys move between the tabs.

import {byId, setAttribute} from './dom.js';

export class Tabs {
  /** @param onChange  gets the name of the tab that is now seen */
  constructor(root, onChange) {
    this.buttons = [...root.querySelectorAll('[role=tab]')];
    this.onChange = onChange;
    this.buttons.forEach((button, i) => {
      button.addEventListener('click', () => this.show(button.dataset.tab));
      button.addEventListener('keydown', (event) => {
        const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
        if (!step) return;
        const next = this.buttons[(i + step + this.buttons.length) % this.buttons.length];
        next.focus();
        this.show(next.dataset.tab);
      });
    });
  }

  show(name) {
    this.current = name;
    for (const button of this.buttons) {
      const chosen = button.dataset.tab === name;
      setAttribute(button, 'aria-selected', String(chosen));
      setAttribute(button, 'tabindex', chosen ? '0' : '-1');
      byId(button.getAttribute('aria-controls')).hidden = !chosen;
    }
    this.onChange(name);
  }
}
