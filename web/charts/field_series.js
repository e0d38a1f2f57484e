// Series of fields of messages, brought onto one time axis, and the spans of those that are texts.

/** Of all charts together. */
export const kMaxCharts = 8;
export const kMaxFields = 8;  // Of each chart.
const kMaxName = 300;

/** Reads "A:x,B:y;C:z", each name escaped; what makes no sense is left out. */
export function readPlots(text) {
  const unescape = (part) => {
    try {
      return decodeURIComponent(part);
    } catch {
      return '';
    }
  };
  const fits = (field) => field.length <= kMaxName && /^[^:]+:.+$/.test(field);
  return String(text ?? '').split(';').map((chart) => (
    [...new Set(chart.split(',').map(unescape).filter(fits))].slice(0, kMaxFields)))
    .filter((fields) => fields.length > 0).slice(0, kMaxCharts);
}

/** Writes what readPlots reads; null where there are no charts. */
export function writePlots(plots) {
  const text = plots.filter((fields) => fields.length > 0)
    .map((fields) => fields.map((field) => encodeURIComponent(field)).join(',')).join(';');
  return text === '' ? null : text;
}

const kUnits = {
  m: 'm', mps: 'm/s', deg: '°', rad: 'rad', s: 's', hz: 'Hz', db: 'dB', pct: '%', percentage: '%',
  mps2: 'm/s²', rps: 'rad/s', n: 'N', pa: 'Pa', c: '°C', us: 'µs',
};

/** The unit that a field's name ends with; '' where it has none. */
export function unitOf(field) {
  const [, suffix] = /_([a-z0-9]+)$/.exec(field) ?? [];
  return kUnits[suffix] ?? '';
}

/** The unit of all `fields`, or '' where they differ. */
export function commonUnit(fields) {
  const units = new Set(fields.map(unitOf));
  return units.size === 1 ? [...units][0] : '';
}

const isRow = (series, i) => Number.isFinite(series.t[i]);

/**
 * Brings series onto one axis.
 * @param answers  of /api/series: [{t, value}, ...]
 * @returns {{t: number[], columns: (number | null)[][]}}  null where a series has no value
 */
export function joinSeries(answers) {
  const times = new Set();
  const tidy = answers.map((answer) => ({t: Array.isArray(answer?.t) ? answer.t : [],
    value: Array.isArray(answer?.value) ? answer.value : []}));
  for (const series of tidy) {
    series.t.forEach((t, i) => { if (isRow(series, i)) times.add(t); });
  }
  const t = [...times].sort((a, b) => a - b);
  const rows = new Map(t.map((time, i) => [time, i]));
  const columns = tidy.map((series) => {
    const column = new Array(t.length).fill(null);
    series.t.forEach((time, i) => {
      const value = series.value[i];
      const row = rows.get(time);
      if (row !== undefined && isRow(series, i) && Number.isFinite(value)) column[row] = value;
    });
    return column;
  });
  return {t, columns};
}

/**
 * The spans of time in which a text stayed the same.
 * @param answer  of /api/series
 * @param end_s  of the last span
 * @returns {{begin_s: number, end_s: number, text: string}[]}
 */
export function spansOf(answer, end_s) {
  const spans = [];
  const times = Array.isArray(answer?.t) ? answer.t : [];
  times.forEach((t, i) => {
    if (!Number.isFinite(t)) return;
    const text = String(answer.value?.[i] ?? '');
    const last = spans[spans.length - 1];
    if (last && last.text === text) return;
    if (last) last.end_s = t;
    spans.push({begin_s: t, end_s: t, text});
  });
  if (spans.length > 0) {
    const last = spans[spans.length - 1];
    last.end_s = Math.max(last.begin_s, end_s);
  }
  return spans;
}

/** A number of 0 to `count` - 1 for a text, the same for equal texts. */
export function hueOf(text, count) {
  let hash = 0;
  for (const letter of text) hash = (hash * 31 + letter.codePointAt(0)) >>> 0;
  return hash % count;
}
