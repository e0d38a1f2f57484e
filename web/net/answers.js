// What came from the viewer, in a shape that the page can rely on, whatever it was.

const kMaxVehicles = 1000;

const arrayOf = (value) => (Array.isArray(value) ? value : []);
const isObject = (value) => typeof value === 'object' && value !== null;

/** Entries with a name, each name once. */
function named(list) {
  const byName = new Map();
  for (const entry of arrayOf(list)) {
    if (isObject(entry) && typeof entry.name === 'string' && !byName.has(entry.name)
        && byName.size < kMaxVehicles) byName.set(entry.name, entry);
  }
  return [...byName.values()];
}

// What a reporter writes where no helm has ever been.
const kNeverAHelm = 'NOHELM-EVER';

/** Returns the vehicles of a frame, without the complaint of those that are to have no helm. */
export function withoutMissingHelms(vehicles, setup) {
  const without = new Set(setup.vehicles.filter((each) => each.has_helm === false)
    .map(({name}) => name));
  if (without.size === 0) return vehicles;
  return vehicles.map((vehicle) => (
    vehicle.mode === kNeverAHelm && without.has(vehicle.name) ? {...vehicle, mode: ''} : vehicle));
}

/** A frame with a time, vehicles that have names, a clock and commands; or null. */
export function tidyFrame(frame) {
  if (!isObject(frame) || !Number.isFinite(frame.t) || !Array.isArray(frame.vehicles)) return null;
  return {
    ...frame,
    vehicles: named(frame.vehicles),
    clock: isObject(frame.clock) ? frame.clock : {},
    commands: arrayOf(frame.commands).filter(isObject),
  };
}

/** The protocol that this page was made for (docs/extending/viewer_protocol.md). */
export const kProtocol = 2;

/** A setup with vehicles that have names, notes and the ends of its time. */
export function tidySetup(setup) {
  const known = isObject(setup) ? setup : {};
  const begin_s = Number.isFinite(known.begin_s) ? known.begin_s : 0;
  const end_s = Number.isFinite(known.end_s) ? Math.max(begin_s, known.end_s) : begin_s;
  return {
    ...known,
    begin_s,
    end_s,
    vehicles: named(known.vehicles),
    causes: arrayOf(known.causes).filter((row) => isObject(row) && typeof row.key === 'string'),
    rules: arrayOf(known.rules).filter((row) => isObject(row) && typeof row.rule === 'string'),
    notes: [
      ...(known.protocol === kProtocol || !Number.isInteger(known.protocol) ? []
        : [`the viewer has protocol ${known.protocol}, this page ${kProtocol}: reload the page, or `
          + 'update the older of the two']),
      ...arrayOf(known.notes).filter((note) => typeof note === 'string'),
    ],
    backgrounds: arrayOf(known.backgrounds).filter((each) => typeof each?.file === 'string'),
  };
}

/** Events with a time and a kind, in order of time. */
export function tidyEvents(answer) {
  return arrayOf(answer?.events)
    .filter((event) => Number.isFinite(event?.t) && typeof event.kind === 'string')
    .map((event) => ({...event, vehicles: arrayOf(event.vehicles)}))
    .sort((a, b) => a.t - b.t);
}
