// Perceptual colour scales, interpolated in OKLab between stops.

type Rgb = [number, number, number];

/** Viridis (van der Walt, Smith), ten stops. */
const SEQUENTIAL = ['#440154', '#482878', '#3e4a89', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6dcd59', '#b4de2c', '#fde725'];
/** From blue through the plain membrane's tone to red, of equal lightness on both sides of zero (Crameri's vik, softened). */
const DIVERGING = ['#0d3b76', '#2a6da3', '#78a9c8', '#c5d9e2', '#ece8e2', '#eacdbc', '#d69a7a', '#b3563a', '#7a2013'];

const toLinear = (c: number): number => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
const toSrgb = (c: number): number => (c <= 0.0031308 ? 12.92 * c : 1.055 * Math.max(c, 0) ** (1 / 2.4) - 0.055);

function lab([r, g, b]: Rgb): Rgb {
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s, 1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s, 0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s];
}

function fromLab([L, a, b]: Rgb): Rgb {
  const l = (L + 0.3963377774 * a + 0.2158037573 * b) ** 3, m = (L - 0.1055613458 * a - 0.0638541728 * b) ** 3, s = (L - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s, -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s];
}

const STEPS = 256;

/** Linear RGB at equal steps from 0 to 1. */
function table(stops: string[]): Rgb[] {
  const labs = stops.map((hex) => lab([1, 3, 5].map((at) => toLinear(parseInt(hex.slice(at, at + 2), 16) / 255)) as Rgb));
  return Array.from({ length: STEPS }, (_, i) => {
    const place = (i / (STEPS - 1)) * (stops.length - 1);
    const low = Math.min(Math.floor(place), stops.length - 2);
    const mixed = labs[low]!.map((value, c) => value + (place - low) * (labs[low + 1]![c]! - value)) as Rgb;
    return fromLab(mixed).map((value) => Math.min(1, Math.max(0, value))) as Rgb;
  });
}

/** For lines before a bright ground: the largest value is the darkest, and the smallest is still seen on a membrane. */
const LINES = SEQUENTIAL.slice(0, 8).reverse();

const TABLES = { sequential: table(SEQUENTIAL), lines: table(LINES), diverging: table(DIVERGING) };
export type Scale = keyof typeof TABLES;

/** Linear RGB of a fraction from 0 to 1. */
export const colour = (scale: Scale, fraction: number): Rgb => TABLES[scale][Math.round(Math.min(1, Math.max(0, fraction)) * (STEPS - 1))]!;

/** The same as CSS says it. */
export const css = (scale: Scale, fraction: number): string => `rgb(${colour(scale, fraction).map((c) => Math.round(255 * toSrgb(c))).join(' ')})`;
