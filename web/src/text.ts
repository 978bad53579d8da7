// Words and numbers as people read them.

/** `mean_curvature` -> `Mean curvature`; units at the end of a name become units. */
export function humanise(name: string): string {
  const [, stem = name, unit] = /^(.*?)(_deg|_ms|_s)?$/.exec(name) ?? [];
  const words = stem.replaceAll('_', ' ');
  // Units and axes stay as they are: mm is not Mm.
  if (words.length <= 2) return words;
  const suffix = { _deg: ' (°)', _ms: ' (ms)', _s: ' (s)' }[unit ?? ''] ?? '';
  return words.charAt(0).toUpperCase() + words.slice(1) + suffix;
}

/** A drawing's title as the name of a file, without an extension; null if nothing of it is left. */
export const fileName = (title: string | null): string | null => (title ?? '').replace(/\.\w{2,8}$/, '').trim().toLowerCase().replace(/[^\p{L}\p{N}]+/gu, '-').replace(/^-|-$/g, '') || null;

export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** A number as people type it: `1.5`, `1,5` or a small sum such as `3+0.25`; NaN for anything else. */
export function typed(text: string): number {
  const plain = text.replace(/,/g, '.').replace(/−/g, '-');
  const parts = plain.match(/[+-]?\s*\d*\.?\d+(?:e[+-]?\d+)?/gi);
  if (!parts || parts.join('').replace(/\s/g, '') !== plain.replace(/\s/g, '')) return NaN;
  return Number(parts.reduce((sum, part) => sum + Number(part.replace(/\s/g, '')), 0).toPrecision(15));
}

const SUPERSCRIPT: Record<string, string> = { '-': '⁻', ...Object.fromEntries([...'⁰¹²³⁴⁵⁶⁷⁸⁹'].map((digit, i) => [String(i), digit])) };

/** A number for reading: `digits` significant ones, whole numbers whole, very large and small ones as powers of ten. */
export function number(value: number, digits = 5): string {
  if (Number.isInteger(value) && Math.abs(value) < 1e15) return value.toLocaleString('en').replace('-', '−');
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-4 || size >= 1e9)) {
    const [mantissa = '', power = ''] = value.toExponential(Math.min(digits, 3) - 1).split('e');
    const short = mantissa.includes('.') ? mantissa.replace(/\.?0+$/, '') : mantissa;
    return `${short.replace('-', '−')}×10${[...power.replace('+', '')].map((c) => SUPERSCRIPT[c]).join('')}`;
  }
  return String(Number(value.toPrecision(digits))).replace('-', '−');
}

export const count = (n: number, one: string, many = `${one}s`): string => `${number(n)} ${n === 1 ? one : many}`;

/** Seconds as `0.02 s`, `12 s`, `2 min 5 s`. */
export function duration(seconds: number): string {
  if (seconds < 10) return `${number(Number(seconds.toPrecision(2)))} s`;
  if (seconds < 90) return `${Math.round(seconds)} s`;
  return `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s`;
}
