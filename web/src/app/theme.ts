// Light or dark: as the browser prefers, until a person chooses.

import { $ } from '../dom';
import { redraw } from './drawing';
import { restyleComparison } from './modes';
import { showQuantity } from './result';
import { look, sketch, stage, surface, THEMES } from './session';

const KEY = 'theme';

export function preferredTheme(): string {
  return localStorage.getItem(KEY) ?? (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light');
}

export function setTheme(theme: string): void {
  document.documentElement.dataset.theme = theme;
  $('theme').setAttribute('aria-pressed', String(theme === 'dark'));
  const style = THEMES[theme]!;
  Object.assign(look, style.look);
  sketch.restyle(style.sketch);
  stage.grid.style(...style.grid);
  stage.shadow.style(style.shadow);
  surface.restyle();
  showQuantity();
  restyleComparison();
  redraw();
  stage.invalidate();
}

export function switchTheme(): void {
  const theme = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
  setTheme(theme);
  localStorage.setItem(KEY, theme);
}
