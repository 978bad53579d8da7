// Small helpers for making elements and texts.

export const $ = (id) => document.getElementById(id);

/** An element with properties (or attributes, where there is no such property) and children. Text is never read as HTML. */
export function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key in made) made[key] = value;
    else made.setAttribute(key, value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

const SVG = 'http://www.w3.org/2000/svg';

export function svg(name, attributes = {}, ...children) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/** `mean_curvature` -> `Mean curvature`; units at the end of a name become units. */
export function humanise(name) {
  const [, stem, unit] = /^(.*?)(_deg|_ms|_s)?$/.exec(name);
  const words = stem.replaceAll('_', ' ');
  // Units and axes stay as they are: mm is not Mm.
  if (words.length <= 2) return words;
  const suffix = { _deg: ' (°)', _ms: ' (ms)', _s: ' (s)' }[unit] ?? '';
  return words.charAt(0).toUpperCase() + words.slice(1) + suffix;
}

/** A number for reading: seven digits, and whole numbers whole. */
export function number(value) {
  if (Number.isInteger(value) && Math.abs(value) < 1e15) return value.toLocaleString('en');
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e9)) {
    const [digits, power] = value.toExponential(3).split('e');
    return `${digits}×10${[...power.replace('+', '')].map((c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[c])).join('')}`;
  }
  return String(Number(value.toPrecision(7)));
}

/** Hands a file to the browser's downloads. */
export function save(blob, name) {
  const url = URL.createObjectURL(blob);
  const link = element('a', { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
