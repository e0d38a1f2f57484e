// From the metres of a chart's projection to degrees: UTM and Web Mercator.

const kDegrees = 180 / Math.PI;
const kEarth_m = 6378137;
// WGS 84; ETRS89 and NAD83 use GRS 80, which differs by less than a millimetre.
const kFlattening = 1 / 298.257223563;
const kThird = kFlattening / (2 - kFlattening);
const kScale = 0.9996;
const kFalseEast_m = 500_000;
const kFalseNorth_m = 10_000_000;  // Of zones of the South.

// Krueger's series in the third flattening n, to n^4: C. F. F. Karney (2011), "Transverse Mercator
// with an accuracy of a few nanometers", J. Geodesy 85: A of (14), beta of (36). delta leads from
// the conformal to the geographic latitude: Kawase (2011), "A general formula for meridian arc
// length", (6).
const n = kThird;
const kRectifying_m = kEarth_m / (1 + n) * (1 + n ** 2 / 4 + n ** 4 / 64);
const kBeta = [
  n / 2 - 2 / 3 * n ** 2 + 37 / 96 * n ** 3 - 1 / 360 * n ** 4,
  n ** 2 / 48 + n ** 3 / 15 - 437 / 1440 * n ** 4,
  17 / 480 * n ** 3 - 37 / 840 * n ** 4,
  4397 / 161280 * n ** 4,
];
const kDelta = [
  2 * n - 2 / 3 * n ** 2 - 2 * n ** 3 + 116 / 45 * n ** 4,
  7 / 3 * n ** 2 - 8 / 5 * n ** 3 - 227 / 45 * n ** 4,
  56 / 15 * n ** 3 - 136 / 35 * n ** 4,
  4279 / 630 * n ** 4,
];

/** Returns [longitude, latitude] in degrees of a place in a UTM zone, 1 to 60. */
export function fromUtm(east_m, north_m, zone, isSouth = false) {
  const xi = (north_m - (isSouth ? kFalseNorth_m : 0)) / (kScale * kRectifying_m);
  const eta = (east_m - kFalseEast_m) / (kScale * kRectifying_m);
  let [x, e] = [xi, eta];
  kBeta.forEach((beta, i) => {
    const j = 2 * (i + 1);
    x -= beta * Math.sin(j * xi) * Math.cosh(j * eta);
    e -= beta * Math.cos(j * xi) * Math.sinh(j * eta);
  });
  const conformal = Math.asin(Math.sin(x) / Math.cosh(e));
  let latitude = conformal;
  kDelta.forEach((delta, i) => { latitude += delta * Math.sin(2 * (i + 1) * conformal); });
  const meridian = 6 * zone - 183;
  return [meridian + Math.atan2(Math.sinh(e), Math.cos(x)) * kDegrees, latitude * kDegrees];
}

/** Returns [longitude, latitude] in degrees. */
export function fromWebMercator(east_m, north_m) {
  return [east_m / kEarth_m * kDegrees, Math.atan(Math.sinh(north_m / kEarth_m)) * kDegrees];
}

/**
 * Returns what makes [longitude, latitude] of the metres (east, north) of a projected coordinate
 * system by its EPSG number; null where it is not known here.
 * @param {number} epsg
 * @returns {((east: number, north: number) => [number, number]) | null}
 */
export function projectionOf(epsg) {
  if (epsg === 3857) return (e, north) => /** @type {[number, number]} */ (fromWebMercator(e, north));
  const zone = (first, count, isSouth = false) => (
    epsg >= first && epsg < first + count ? {number: epsg - first + 1, isSouth} : null);
  const utm = zone(32601, 60) ?? zone(32701, 60, true)  // WGS 84
      ?? (epsg >= 25828 && epsg <= 25838 ? {number: epsg - 25800, isSouth: false} : null)  // ETRS89
      ?? zone(26901, 23);  // NAD83
  return utm ? (e, north) => /** @type {[number, number]} */ (
    fromUtm(e, north, utm.number, utm.isSouth)) : null;
}

// Web tiles: zoom z has 2^z columns from longitude -180 and as many rows from the North.

const kLimit = 85.0511287798066;  // Of the square map, degrees of latitude.

/** Returns the place of a point in columns and rows of zoom `z`, with fractions. */
export function tilePlace(lon, lat, z) {
  const count = 2 ** z;
  const sine = Math.sin(Math.max(-kLimit, Math.min(kLimit, lat)) / kDegrees);
  return {x: (lon + 180) / 360 * count,
    y: (0.5 - Math.log((1 + sine) / (1 - sine)) / (4 * Math.PI)) * count};
}

/** Returns [longitude, latitude] of a place in columns and rows of zoom `z`. */
export function tileCorner(x, y, z) {
  const count = 2 ** z;
  return [x / count * 360 - 180,
    Math.atan(Math.sinh(Math.PI * (1 - 2 * y / count))) * kDegrees];
}
