// Numbers and commands as the page writes them: as lib/tools/report/table_text.h does.

export const kMaxDrawn = 1e30; // Beyond this an axis has no sensible marks.

export const canBeDrawn = (value) => Number.isFinite(value) && Math.abs(value) <= kMaxDrawn;

/** Up to five significant digits, as %.5g of C; "-" for what is no number. */
export function cellText(value) {
  if (!Number.isFinite(value)) return '-';
  if (value === 0) return '0';
  const [digits, power] = value.toExponential(4).split('e');
  const exponent = Number(power);
  const trim = (text) => text.includes('.') ? text.replace(/\.?0+$/, '') : text;
  if (exponent >= -4 && exponent < 5) return trim(value.toFixed(4 - exponent));
  const sign = exponent < 0 ? '-' : '+';
  return `${trim(digits)}e${sign}${String(Math.abs(exponent)).padStart(2, '0')}`;
}

/** A value of a quantity with its unit: "12.5 m", "95 %". */
export function valueText(value, quantity) {
  if (quantity.isShare) return Number.isFinite(value) ? `${cellText(100 * value)} %` : '-';
  return quantity.unit && Number.isFinite(value) ? `${cellText(value)} ${quantity.unit}` :
    cellText(value);
}

/** "1,234,567". */
export const countText = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, ',');

/** "1 trial", "2,000 trials". */
export const countOf = (count, thing) => `${countText(count)} ${thing}${count === 1 ? '' : 's'}`;

/** A value as TOML writes it, without its quotes. */
export function plainValue(toml) {
  return /^(["'])[^]*\1$/.test(toml) && toml.length > 1 ? toml.slice(1, -1) : toml;
}

/** The number that TOML writes so; NaN: it is none. */
export const numberOf = (toml) => toml.trim() === '' ? NaN : Number(toml);

/** At most `length` characters. */
export const clipped = (text, length) =>
  text.length > length ? `${text.slice(0, length - 1)}…` : text;

/** One word for a POSIX shell, whatever it holds; control characters as bash's $'...' has them. */
export function shellWord(text) {
  if (/^[\w./:@%+,=][\w./:@%+,=-]*$/.test(text)) return text;
  // eslint-disable-next-line no-control-regex
  if (!/[\x00-\x1f\x7f]/.test(text)) return `'${text.replaceAll("'", "'\\''")}'`;
  const escaped = text.replaceAll('\\', '\\\\').replaceAll("'", "\\'")
    // eslint-disable-next-line no-control-regex
    .replace(/[\x00-\x1f\x7f]/g, (letter) =>
      `\\x${letter.charCodeAt(0).toString(16).padStart(2, '0')}`);
  return `$'${escaped}'`;
}

/** The command that replays a trial. */
export const replayCommand = (dir, trial) =>
  `shoal campaign replay ${shellWord(dir)} ${shellWord(trial)} --view`;
