// The map's colours: CSS custom properties of <html> where the page has them, else those of the
// theme (class `light` on <html>: the light one).

import {isLightTheme} from '../page/colors.js';

const kDark = {
  'map-water': '#0b1622',
  'map-shallow': '#1d4a5f',
  'map-deep': '#0a1420',
  'map-grid': 'rgba(160, 190, 215, 0.10)',
  'map-grid-major': 'rgba(160, 190, 215, 0.22)',
  'map-axis': 'rgba(190, 215, 235, 0.42)',
  'map-text': '#e8f0f6',
  'map-muted': '#a9bccb',
  'map-plate': 'rgba(8, 17, 27, 0.78)',
  'map-outline': '#05090e',
  'map-contour': 'rgba(140, 200, 215, 0.34)',
  'map-contour-text': '#9fd0da',
  'map-area': '#cfd8dc',
  'map-accent': '#ffffff',
  'map-danger': '#ff5c5c',
  'map-warning': '#ffc04d',
  'map-stale': '#8d99a3',
};

const kLight = {
  'map-water': '#f2f6f9',
  'map-shallow': '#eef7fb',
  'map-deep': '#a9c9de',
  'map-grid': 'rgba(40, 70, 95, 0.10)',
  'map-grid-major': 'rgba(40, 70, 95, 0.22)',
  'map-axis': 'rgba(30, 55, 75, 0.5)',
  'map-text': '#0d1b26',
  'map-muted': '#3c5263',
  'map-plate': 'rgba(255, 255, 255, 0.84)',
  'map-outline': '#0a1118',
  'map-contour': 'rgba(15, 80, 115, 0.42)',
  'map-contour-text': '#0f5073',
  'map-area': '#37474f',
  'map-accent': '#000000',
  'map-danger': '#c40000',
  'map-warning': '#7a4b00',
  'map-stale': '#77828b',
};

export const kFont = '"DejaVu Sans", "Segoe UI", "Helvetica Neue", Arial, sans-serif';

/** Returns the colours by name without `map-` (contourText: --map-contour-text), and `light`. */
export function readTheme() {
  const light = isLightTheme();
  const style = getComputedStyle(document.documentElement);
  const theme = {light};
  for (const [name, fallback] of Object.entries(light ? kLight : kDark)) {
    const key = name.slice(4).replace(/-(\w)/g, (_, letter) => letter.toUpperCase());
    theme[key] = style.getPropertyValue(`--${name}`).trim() || fallback;
  }
  return theme;
}
