// The time line of a recorded mission: play, speed, scrub, events as marks.

import {element, setAttribute, setText} from './dom.js';
import {eventSign} from '../panels/panel_events.js';
import {isGrave, kSpeeds, neighbourEvent} from '../net/source.js';
import {clip, missionTime, words} from './text.js';

const kMarks = 400;  // More cannot be distinguished on a screen.

/**
 * Chooses which events have a mark: all grave ones first, at most `limit`, spread over the list.
 * @returns events in their order
 */
export function marksOf(events, limit) {
  const thin = (list, most) => (list.length <= most ? list
    : Array.from({length: most}, (_, i) => list[Math.floor((i * list.length) / most)]));
  const grave = thin(events.filter(isGrave), limit);
  const others = thin(events.filter((event) => !isGrave(event)), limit - grave.length);
  return [...grave, ...others].sort((a, b) => a.t - b.t);
}

export class Timeline {
  /** @param source  a RecordedSource */
  constructor(root, source) {
    this.source = source;
    this.events = [];
    const {begin_s, end_s, tick_s} = source.setup;
    const button = (id, label, title, onclick) => element('button',
      {type: 'button', id, title, 'aria-label': title, onclick}, label);
    this.playButton = button('play', '▶', 'Play (space)', () => source.toggle());
    this.speed = element('select', {id: 'speed', 'aria-label': 'Speed', title: 'Speed (< >)',
      onchange: () => source.setSpeed(Number(this.speed.value))},
    kSpeeds.map((speed) => element('option', {value: speed}, `${speed}×`)));
    this.range = element('input', {type: 'range', id: 'timeline-position', min: begin_s, max: end_s,
      step: tick_s > 0 ? tick_s : 0.1, value: begin_s, 'aria-label': 'Mission time',
      oninput: () => source.seek(Number(this.range.value))});
    this.marks = element('div', {class: 'marks'});
    this.now = element('output', {id: 'timeline-time', for: 'timeline-position'});
    root.replaceChildren(
      element('div', {class: 'buttons'},
        button('previous-grave', '⊗◀', 'Previous trouble: collision, grounding, all-stop, expectation missed ({)',
          () => this.jump(-1, true)),
        button('previous-event', '|◀', 'Previous event ([)', () => this.jump(-1, false)),
        button('step-back', '‹', 'One step back (,)', () => source.step(-1)), this.playButton,
        button('step-on', '›', 'One step on (.)', () => source.step(1)),
        button('next-event', '▶|', 'Next event (])', () => this.jump(1, false)),
        button('next-grave', '▶⊗', 'Next trouble: collision, grounding, all-stop, expectation missed (})', () => this.jump(1, true)),
        this.speed),
      element('div', {class: 'track'}, this.marks, this.range,
        element('div', {class: 'ends'}, element('span', {}, missionTime(begin_s, 0)),
          element('span', {}, missionTime(end_s, 0)))),
      this.now);
    root.hidden = false;
    this.update();
  }

  setEvents(events) {
    this.events = events;
    const {begin_s, end_s} = this.source.setup;
    const length_s = Math.max(end_s - begin_s, 1e-9);
    const percent = (t) => (100 * Math.min(1, Math.max(0, (t - begin_s) / length_s))).toFixed(3);
    this.marks.replaceChildren(...marksOf(events, kMarks).map((event) => element('button', {
      type: 'button', tabindex: '-1', 'data-kind': clip(event.kind, 40),
      'data-grave': isGrave(event) ? 'true' : null,
      style: `left: ${percent(event.t)}%`,
      title: `${missionTime(event.t)} ${words(clip(event.kind, 40))}: ${clip(event.text, 200)}`,
      'aria-label': `${words(clip(event.kind, 40))} at ${missionTime(event.t)}`,
      onclick: () => this.source.seek(event.t),
    }, isGrave(event) ? eventSign(event) : '')));
  }

  /** Goes to the next (1) or previous (-1) event. */
  jump(direction, onlyGrave) {
    const event = neighbourEvent(this.events, this.source.t, direction, onlyGrave);
    if (event) this.source.seek(event.t);
    return event;
  }

  /** Shows the time and whether it plays. */
  update() {
    const {t, playing, speed} = this.source;
    if (Number(this.range.value) !== t) this.range.value = String(t);
    setAttribute(this.range, 'aria-valuetext', missionTime(t));
    setText(this.now, `${missionTime(t)} / ${missionTime(this.source.setup.end_s, 0)}`);
    setText(this.playButton, playing ? '❚❚' : '▶');
    setAttribute(this.playButton, 'aria-pressed', String(playing));
    if (this.speed.value !== String(speed)) this.speed.value = String(speed);
  }
}
