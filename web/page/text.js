// Numbers and names as the page writes them. What is not known is written "–".

const kUnknown = '–';

const isNumber = (value) => typeof value === 'number' && Number.isFinite(value);

/** "87.1 m", or "–". */
export function quantity(value, digits, unit = '') {
  if (!isNumber(value)) return kUnknown;
  // No "-0.0".
  const rounded = Number(value.toFixed(digits)) === 0 ? 0 : value;
  const text = rounded.toFixed(digits);
  if (unit === '') return text;
  return unit === '°' || unit === '%' ? text + unit : `${text} ${unit}`;
}

/** Mission time: "02:03.4", with hours where there are any: "1:02:03.4". */
export function missionTime(t_s, digits = 1) {
  if (!isNumber(t_s)) return kUnknown;
  const scale = 10 ** digits;
  let rest = Math.round(Math.abs(t_s) * scale);
  const sign = t_s < 0 && rest > 0 ? '-' : '';
  const fraction = digits > 0 ? `.${String(rest % scale).padStart(digits, '0')}` : '';
  rest = Math.floor(rest / scale);
  const two = (number) => String(number).padStart(2, '0');
  const hours = Math.floor(rest / 3600);
  const minutes = two(Math.floor(rest / 60) % 60);
  return `${sign}${hours > 0 ? `${hours}:` : ''}${minutes}:${two(rest % 60)}${fraction}`;
}

/** How long ago: "0.3 s", "12 s", "3 min", "2 h"; never negative. */
export function age(seconds) {
  if (!isNumber(seconds)) return kUnknown;
  const positive = Math.max(0, seconds);
  if (positive < 9.95) return `${positive.toFixed(1)} s`;
  if (positive < 99.5) return `${Math.round(positive)} s`;
  if (positive < 5400) return `${Math.round(positive / 60)} min`;
  return `${Math.round(positive / 3600)} h`;
}

/** A heading as sailors write it: "007°". */
export function heading(degrees) {
  if (!isNumber(degrees)) return kUnknown;
  const whole = ((Math.round(degrees) % 360) + 360) % 360;
  return `${String(whole).padStart(3, '0')}°`;
}

/** 20 of 24 as "83%"; "–" where nothing was offered. 100% only where none is missing. */
export function ratio(delivered, offered) {
  if (!isNumber(delivered) || !isNumber(offered) || offered <= 0) return kUnknown;
  const percent = (100 * delivered) / offered;
  if (delivered < offered && percent > 99) return '99%';
  if (delivered > 0 && percent < 1) return '1%';
  return `${Math.round(percent)}%`;
}

/** "out_of_range" as "out of range". */
export function words(name) {
  return String(name ?? '').replaceAll('_', ' ');
}

/** At most `length` characters of a text that came in a message. */
export function clip(text, length = 300) {
  const whole = String(text ?? '');
  return whole.length > length ? `${whole.slice(0, length - 1)}…` : whole;
}

/** A name for a file: letters, digits, dot, dash and underscore. */
export function fileName(text) {
  const safe = String(text ?? '').replaceAll(/[^A-Za-z0-9._-]+/g, '_').slice(0, 80);
  return safe === '' ? 'mission' : safe;
}
