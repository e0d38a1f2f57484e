// Mouse, pen and fingers on the map: drag pans, wheel and pinch zoom, a click without a drag is a
// click. Calls `actions` for each:
//   pan(dx, dy), zoom(factor, sx, sy), click(sx, sy), hover(sx, sy), leave(),
//   press(sx, sy) -> true where the drag is not to pan, dragged(sx, sy), released(sx, sy, moved)

const kSlop = 5;
const kWheelPixels = 240;

export class MapInput {
  #canvas;
  #actions;
  #pointers = new Map();  // id -> {x, y}
  #start = {x: 0, y: 0};  // Of a press that may become a click.
  #moved = false;
  #taken = false;

  constructor(canvas, actions) {
    this.#canvas = canvas;
    this.#actions = actions;
    canvas.style.touchAction = 'none';
    const on = (type, handle) => canvas.addEventListener(type, handle, {passive: false});
    on('pointerdown', (event) => this.#down(event));
    on('pointermove', (event) => this.#move(event));
    on('pointerup', (event) => this.#up(event, true));
    on('pointercancel', (event) => this.#up(event, false));
    on('pointerleave', (event) => {
      if (event.pointerType === 'mouse' && this.#pointers.size === 0) actions.leave();
    });
    on('wheel', (event) => this.#wheel(event));
    on('contextmenu', (event) => event.preventDefault());
  }

  #placeOf(event) {
    const box = this.#canvas.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  }

  #down(event) {
    if (event.pointerType === 'mouse' && event.button > 1) return;
    const place = this.#placeOf(event);
    // A pointer that a script made up cannot be captured; it works without.
    try { this.#canvas.setPointerCapture(event.pointerId); } catch { /* not a real pointer */ }
    this.#pointers.set(event.pointerId, place);
    this.#moved = this.#pointers.size > 1;
    if (this.#pointers.size === 1) {
      this.#start = place;
      this.#taken = this.#actions.press(place.x, place.y);
    }
  }

  #move(event) {
    const place = this.#placeOf(event);
    const before = this.#pointers.get(event.pointerId);
    this.#actions.hover(place.x, place.y);
    if (!before) return;
    if (this.#pointers.size >= 2) {
      this.#pinch(event.pointerId, before, place);
    } else {
      const far = Math.hypot(place.x - this.#start.x, place.y - this.#start.y) > kSlop;
      if (!this.#moved && !far) return;
      this.#moved = true;
      if (this.#taken) this.#actions.dragged(place.x, place.y);
      else this.#actions.pan(place.x - before.x, place.y - before.y);
    }
    this.#pointers.set(event.pointerId, place);
  }

  #pinch(id, before, place) {
    const other = ([...this.#pointers].find(([key]) => key !== id) ?? [id, before])[1];
    const apart = (a, b) => Math.max(10, Math.hypot(a.x - b.x, a.y - b.y));
    this.#actions.zoom(apart(place, other) / apart(before, other), (place.x + other.x) / 2,
                       (place.y + other.y) / 2);
    this.#actions.pan((place.x - before.x) / 2, (place.y - before.y) / 2);
  }

  #up(event, ended) {
    const place = this.#placeOf(event);
    if (!this.#pointers.delete(event.pointerId)) return;
    if (this.#pointers.size > 0) return;
    if (this.#taken) this.#actions.released(place.x, place.y, this.#moved);
    else if (ended && !this.#moved) this.#actions.click(place.x, place.y);
    this.#taken = false;
  }

  #wheel(event) {
    event.preventDefault();
    const {x, y} = this.#placeOf(event);
    const pixels = event.deltaMode === 1 ? 30 * event.deltaY :
        event.deltaMode === 2 ? 300 * event.deltaY : event.deltaY;
    const steps = Math.max(-3, Math.min(3, -pixels / kWheelPixels));
    this.#actions.zoom(2 ** steps, x, y);
  }
}
