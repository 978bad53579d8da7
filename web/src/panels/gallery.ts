// The examples by purpose, with a picture each.

import type { ExampleSummary } from 'plateau-client';
import { el } from '../dom';
import sprite from '../thumbnails.json';

const GROUPS: { title: string; about: string; names: (string | RegExp)[] }[] = [
  { title: 'Tents', about: 'Membranes on a boundary of their own', names: ['tent', 'ridge-rope', 'four-corners', 'own-mesh'] },
  { title: 'Canopies and soap films', about: 'Several rings, every way to span them', names: [/rings/, /loops/, /half-circles/] },
  { title: 'Strips', about: 'Ruled surfaces that fold flat', names: ['two-rails', 'wavy-strip', 'contour-stack', /^wang-tang/] },
  { title: 'Gridshells and floors', about: 'Lattices of equal members', names: ['vault-equal-members', /^latticed/, 'vault', 'courtyard', /^floor/] },
  { title: 'Tensile structures', about: 'Films with cables, pressure and weight', names: [/sail/, /cable/, /film-on/, /mast/, /conic/, /cushion/, 'ridge-and-valley', 'air-hall', 'inflated-disc'] },
  { title: 'From the papers', about: 'Helicoid, catenoid, Scherk and the methods that found them', names: [/./] },
];
const PREFIX: Record<string, number> = { minimal_surface: 5, ruled_surface: 2, uniform_mesh: 3, tensile_structure: 4, cable_net: 4 };

/** A line of a few words for a card; the whole title is its tooltip. */
const short = (title: string): string => title.replace(/ \((.*)\)$/, '').replace(/, every way to span them compared$/, ', compared');

export function gallery(examples: ExampleSummary[], choose: (example: ExampleSummary) => void): HTMLElement[] {
  const left = new Set(examples);
  const groups = GROUPS.map((group, g) => {
    const rank = ({ name: own }: ExampleSummary): number => group.names.findIndex((name) => (typeof name === 'string' ? name === own : name.test(own)));
    const found = [...left].filter((each) => rank(each) >= 0 && (g < GROUPS.length - 1 || left.has(each))).sort((a, b) => rank(a) - rank(b));
    found.forEach((each) => left.delete(each));
    return { ...group, found };
  });
  // What this page was not told of goes to the group of its kind.
  for (const each of left) groups[PREFIX[each.kind] ?? GROUPS.length - 1]!.found.push(each);
  return groups.filter(({ found }) => found.length > 0).map(({ title, about, found }) => el('section', {},
    el('h3', {}, title, el('small', {}, about)),
    el('div', { className: 'cards' }, ...found.map((each) => {
      const card = el('button', { type: 'button', className: 'card', title: each.title }, picture(each.name), el('span', {}, short(each.title)));
      card.dataset.example = each.name;
      card.addEventListener('click', () => choose(each));
      return card;
    }))));
}

function picture(name: string): HTMLElement {
  const index = (sprite.names as string[]).indexOf(name);
  const box = el('span', { className: 'thumbnail' });
  box.setAttribute('aria-hidden', 'true');
  if (index >= 0) {
    const { columns } = sprite;
    const rows = Math.ceil(sprite.names.length / columns);
    const [x, y] = [index % columns, Math.floor(index / columns)];
    box.style.backgroundSize = `${columns * 100}% ${rows * 100}%`;
    box.style.backgroundPosition = `${columns > 1 ? (100 * x) / (columns - 1) : 0}% ${rows > 1 ? (100 * y) / (rows - 1) : 0}%`;
  } else box.classList.add('missing');
  return box;
}
