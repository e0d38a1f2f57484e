// Where tasks and behaviors lie at a time: those of the mission file, moved by the updates that the
// helms have taken (events of kind "replanned").

import {isNumber} from './geometry.js';

const arrayOr = (value) => (Array.isArray(value) ? value : []);

/** Places that are finite. */
export const placesOf = (points) => arrayOr(points).filter(
  (point) => Array.isArray(point) && isNumber(point[0]) && isNumber(point[1]));

const partsOf = (list) => arrayOr(list).filter((part) => typeof part?.name === 'string')
  .map((part) => ({...part, points: placesOf(part.points), area: placesOf(part.area)}));

export class PresentPlan {
  #first;
  #replans = [];     // {t, vehicle, name, parts}, in order of time.
  #count = -1;       // Of those that #now has.
  #now = new Map();
  /** Counts the changes of what at() returns. */
  version = 0;

  constructor(setup) {
    this.#first = new Map(arrayOr(setup?.vehicles).map((vehicle) => [vehicle?.name,
      [...partsOf(vehicle?.behaviors), ...partsOf(vehicle?.tasks)]]));
  }

  /** @param events  as tidyEvents returns them */
  setEvents(events) {
    this.#replans = arrayOr(events).filter(({kind, plan, vehicles}) => kind === 'replanned'
        && typeof plan?.name === 'string' && Array.isArray(plan.parts) && vehicles.length > 0)
      .map(({t, plan, vehicles}) => ({t, vehicle: vehicles[0], name: plan.name,
        parts: partsOf(plan.parts)}));
    this.#count = -1;
  }

  /** Returns, by vehicle, [{name, kind, points, closed, radius_m, marked, area}] at `t`. */
  at(t) {
    const count = this.#replans.findIndex((each) => each.t > t);
    const wanted = count < 0 ? this.#replans.length : count;
    if (wanted === this.#count) return this.#now;
    this.#count = wanted;
    this.version += 1;
    this.#now = new Map(this.#first);
    for (const {vehicle, name, parts} of this.#replans.slice(0, wanted)) {
      const others = (this.#now.get(vehicle) ?? []).filter((part) => part.name !== name);
      this.#now.set(vehicle, [...others, ...parts]);
    }
    return this.#now;
  }
}
