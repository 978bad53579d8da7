// Controls for a request's options, made from the schema that the server publishes: what it does not offer cannot be chosen,
// and what it learns to offer appears by itself.

import { el } from '../dom';
import type { Request } from '../model/request';
import { humanise } from '../text';

export interface Schema {
  $ref?: string; type?: string | string[]; description?: string; 'x-default'?: unknown; 'x-optional'?: boolean; enum?: unknown[]; 'x-enum-descriptions'?: string[]; properties?: Record<string, Schema>;
  allOf?: Schema[]; anyOf?: Schema[]; oneOf?: Schema[]; items?: Schema; minimum?: number; maximum?: number; exclusiveMinimum?: number; maxProperties?: number;
  minItems?: number; maxItems?: number; required?: string[]; nullable?: boolean;
}
export interface OpenApi { paths?: Record<string, { post?: { requestBody?: { content?: Record<string, { schema?: Schema }> } } }>; info?: unknown }

/** The request schema of a path, with its first references resolved. */
export function schemaOf(openapi: OpenApi, path: string): Schema | null {
  const body = openapi.paths?.[path]?.post?.requestBody?.content?.['application/json']?.schema;
  return body ? resolve(openapi, body) : null;
}

const isNull = (schema: Schema): boolean => schema.type === 'null';

function resolve(openapi: OpenApi, schema: Schema): Schema {
  let found = schema;
  const outer: Schema = {};
  for (let depth = 0; depth < 8; depth += 1) {
    if (found.description !== undefined) outer.description ??= found.description;
    if (found['x-default'] !== undefined) outer['x-default'] ??= found['x-default'];
    const union: Schema[] = found.oneOf ?? [];
    // The null of an optional field stands for a field that is left out, and is no choice of its own.
    if (found['x-optional']) outer['x-optional'] = true;
    else if (union.some(isNull)) outer.nullable = true;
    const others: Schema[] = union.filter((each) => !isNull(each));
    const only: Schema | undefined = union.some(isNull) && others.length === 1 ? others[0] : undefined;
    const next: Schema | undefined = found.$ref ? { $ref: found.$ref } : found.allOf?.[0] ?? only;
    if (!next) break;
    found = next.$ref ? at(openapi, next.$ref) : next;
  }
  return { ...found, ...outer };
}

const at = (openapi: OpenApi, ref: string): Schema =>
  (ref.slice(2).split('/').reduce<unknown>((value, step) => (value as Record<string, unknown> | undefined)?.[step], openapi) ?? {}) as Schema;

type Control =
  | { type: 'choice'; names: string[]; help: Record<string, string | undefined>; other: Schema | null }
  | { type: 'flag' } | { type: 'switch'; options: Schema } | { type: 'number'; whole: boolean } | { type: 'text' } | { type: 'one_of' } | { type: 'group' } | { type: 'numbers'; count: number; item: Schema };

/** What kind of control a resolved schema calls for; null if none does it justice (lists of points). */
export function controlOf(openapi: OpenApi, schema: Schema): Control | null {
  const variants = (schema.oneOf ?? schema.anyOf ?? [schema]).filter((each) => !isNull(each)).map((each) => resolve(openapi, each));
  const named = variants.flatMap((each) => each.oneOf ?? each.anyOf ?? [each]).filter((each) => each.enum);
  const names = named.flatMap((each) => each.enum ?? []);
  if (names.length > 0 && names.every((name) => typeof name === 'string')) {
    const help = Object.fromEntries(named.flatMap((each) => (each.enum ?? []).map((name, i) => [String(name), each['x-enum-descriptions']?.[i] || undefined])));
    // A union of names and one object: the object is one more choice, with controls of its own.
    return { type: 'choice', names: names as string[], help, other: variants.find((each) => each.properties) ?? null };
  }
  // True or false, or an object that says more than true.
  const options = variants.find((each) => each.properties);
  if (options && variants.some((each) => each.type === 'boolean')) return { type: 'switch', options };
  const types = [schema.type].flat();
  if (types.includes('boolean')) return { type: 'flag' };
  if (types.includes('integer') || types.includes('number')) return { type: 'number', whole: types.includes('integer') };
  if (types.includes('string')) return { type: 'text' };
  if (types.includes('object') && schema.maxProperties === 1) return { type: 'one_of' };
  if (types.includes('object') && schema.properties && Object.values(schema.properties).every((each) => controlOf(openapi, resolve(openapi, each)))) return { type: 'group' };
  if (types.includes('array') && schema.items && schema.minItems === schema.maxItems && (schema.maxItems ?? 9) <= 3) {
    const item = resolve(openapi, schema.items);
    if ([item.type].flat().some((type) => type === 'integer' || type === 'number')) return { type: 'numbers', count: schema.maxItems!, item };
  }
  return null;
}

const SHOWN_FIRST = ['objective', 'secondary_objective', 'resolution', 'edge_length', 'closed', 'optimise', 'max_distinct_lengths', 'topology', 'units', 'up'];
/** Fields within others that stand before all others, in this order. */
const PROMOTED = ['film.tension', 'pressure', 'film.weight'];
/** Fields about the job and not its result, which stand last. */
const LAST = ['cache', 'callback_url', 'label', 'metadata'];
/** Titles where a field's name says too little. */
const TITLES: Record<string, string> = { closed: 'Closed rails', units: 'Unit', up: 'Up axis', all_objectives: 'Compare all objectives', optimise: 'Optimise', certify: 'Prove a lower bound of the area', film: 'Woven film', callback_url: 'Callback' };
/** Fields about the sending of a request, which the studio does itself. */
const LEFT_OUT = ['kind', 'supersede', 'cancel_on_disconnect'];
const rank = (name: string): number => SHOWN_FIRST.indexOf(name) + 1 || SHOWN_FIRST.length + 1 + Math.max(0, LAST.indexOf(name) + 1);
const titleOf = (name: string): string => TITLES[name] ?? humanise(name);

export interface FormHost {
  openapi: OpenApi;
  /** Sets a field, or removes it if the value is undefined; one step of undo. */
  set(name: string, value: unknown): void;
  /** Text below a choice: what it does. */
  describe(name: string, value: string): string | undefined;
  /** Why a field, or `field=choice`, does not apply to the request as it is now; null if it does. */
  whyNot(field: string): string | null;
  /** Value of a field in the request as it is now. The field is given by names joined by dots. */
  given(field: string): unknown;
  /** The unit of a field, if it has one. */
  unit(field: string): string | undefined;
}

/** A field within another one. Setting it leaves the other fields of that object as they are. */
function promoted(host: FormHost, schema: Schema, path: string[]): HTMLElement | null {
  const field = path.reduce<Schema | null>((found, name) => {
    const inner = found?.properties?.[name];
    return inner ? resolve(host.openapi, inner) : null;
  }, schema);
  const control = field && controlOf(host.openapi, field);
  if (!field || !control) return null;
  const [first, second] = path as [string, string?];
  const set = (value: unknown): void => host.set(first, second === undefined ? value : without({ ...host.given(first) as object, [second]: value }));
  return make(host, path.at(-1)!, field, control, host.given(path.join('.')), set, path);
}

/** Fills the form for a request. `lead` stands below the promoted fields. */
export function build(form: HTMLFormElement, schema: Schema, request: Request, host: FormHost, lead: HTMLElement | null = null): void {
  const open = form.querySelector('details')?.open ?? false;
  form.replaceChildren();
  const rest = el('div', { className: 'fields' });
  form.append(...PROMOTED.flatMap((path) => promoted(host, schema, path.split('.')) ?? []));
  if (lead) form.append(lead);
  const names = Object.keys(schema.properties ?? {}).filter((name) => !LEFT_OUT.includes(name) && !PROMOTED.includes(name));
  names.sort((a, b) => rank(a) - rank(b));
  for (const name of names) {
    const field = resolve(host.openapi, schema.properties![name]!);
    const control = controlOf(host.openapi, field);
    // A choice of one is no choice.
    if (!control || (control.type === 'choice' && control.names.length < 2 && !control.other)) continue;
    const made = make(host, name, field, control, request[name], (value) => host.set(name, value), [name]);
    (SHOWN_FIRST.includes(name) ? form : rest).append(made);
  }
  if (rest.childElementCount > 0) form.append(el('details', { className: 'more', open }, el('summary', {}, 'More options'), rest));
}

/**
 * Disables what does not apply to the request as it is now, with the reason below it. A field that has a value stays enabled,
 * so that it can be removed.
 */
export function disable(form: HTMLFormElement, host: FormHost): void {
  for (const field of form.querySelectorAll<HTMLElement>('[data-path]')) disableField(field, host);
}

function disableField(field: HTMLElement, host: FormHost): void {
  const path = field.dataset.path!;
  const reason = host.whyNot(path);
  if (reason !== null || field.dataset.excluded) {
    const name = CSS.escape(path);
    for (const control of field.querySelectorAll<HTMLInputElement>(`[name="${name}"], [name^="${name}."]`)) control.disabled = reason !== null && (host.given(path) ?? null) === null;
    field.dataset.excluded = reason ?? '';
  }
  field.querySelector(':scope > .why')?.remove();
  if (reason !== null) field.append(el('p', { className: 'help why' }, reason));
  for (const option of field.querySelectorAll<HTMLOptionElement>(`select[name="${CSS.escape(path)}"] option`)) {
    const excluded = host.whyNot(`${path}=${option.value}`);
    if (excluded === null && !option.dataset.text) continue;
    option.dataset.text ??= option.textContent ?? '';
    option.disabled = excluded !== null;
    option.textContent = excluded === null ? option.dataset.text : `${option.dataset.text}: ${excluded.charAt(0).toLowerCase()}${excluded.slice(1).replace(/\.$/, '')}`;
  }
}

type Set = (value: unknown) => void;

function make(host: FormHost, name: string, field: Schema, control: Control, given: unknown, set: Set, path: string[]): HTMLElement {
  const made = controlFor(host, name, field, control, given, set, path);
  made.dataset.path = path.join('.');
  disableField(made, host);
  return made;
}

function controlFor(host: FormHost, name: string, field: Schema, control: Control, given: unknown, set: Set, path: string[]): HTMLElement {
  const value = given ?? field['x-default'];
  const title = field.description ?? '';
  const id = `option-${path.join('-')}`;
  if (control.type === 'flag') {
    const box = el('input', { type: 'checkbox', name: path.join('.'), id, checked: value === true });
    box.addEventListener('change', () => set(box.checked));
    return el('label', { className: 'check field', title }, box, titleOf(name));
  }
  if (control.type === 'switch') {
    const options = { ...control.options, description: field.description, nullable: true };
    return group(host, name, options, value === true ? {} : value || null, set, path);
  }
  if (control.type === 'choice') return choice(host, name, field, control, given, set, path);
  if (control.type === 'number') {
    const input = numberInput(path.join('.'), id, field, control.whole, value);
    input.addEventListener('change', () => { if (input.checkValidity()) set(input.value === '' ? undefined : input.valueAsNumber); else input.reportValidity(); });
    const unit = host.unit(path.join('.'));
    return el('label', { className: 'field', title, htmlFor: id }, el('span', {}, titleOf(name), unit && el('small', {}, ` ${unit}`)), input);
  }
  if (control.type === 'text') {
    const input = el('input', { type: 'text', name: path.join('.'), id, value: (value as string | null) ?? '', placeholder: 'none', autocomplete: 'off' });
    input.addEventListener('change', () => set(input.value === '' ? undefined : input.value));
    return el('label', { className: 'field', title, htmlFor: id }, el('span', {}, titleOf(name)), input);
  }
  if (control.type === 'numbers') {
    const list = Array.isArray(value) ? value as number[] : [];
    const inputs = Array.from({ length: control.count }, (_, i) => numberInput(`${path.join('.')}.${i}`, `${id}-${i}`, control.item, true, list[i]));
    inputs.forEach((input, i) => {
      input.setAttribute('aria-label', `${titleOf(name)}, ${i + 1}`);
      input.addEventListener('change', () => set(inputs.map((each) => each.valueAsNumber || control.item.minimum || 0)));
    });
    return el('div', { className: 'field', title }, el('span', {}, titleOf(name)), el('span', { className: 'pair even' }, ...inputs));
  }
  if (control.type === 'group') return group(host, name, field, given, set, path);
  return oneOf(host, name, field, value, set, path);
}

/** Names, the null of a nullable field, and where the schema has one an object with fields of its own. */
function choice(host: FormHost, name: string, field: Schema, control: Control & { type: 'choice' }, given: unknown, set: Set, path: string[]): HTMLElement {
  const id = `option-${path.join('-')}`;
  let value = given ?? field['x-default'];
  const put = (next: unknown): void => {
    value = next ?? field['x-default'];
    set(next);
  };
  const OTHER = '(object)';
  const options = control.names.map((each) => el('option', { value: each, title: control.help[each] ?? '' }, humanise(each)));
  if (field.nullable || field['x-default'] === undefined) options.unshift(el('option', { value: '' }, field.nullable ? 'None' : 'Default'));
  const isObject = (): boolean => value !== null && typeof value === 'object';
  const other = control.other && isForm(host.openapi, control.other) ? control.other : null;
  if (other) options.push(el('option', { value: OTHER }, 'Weighted sum'));
  else if (isObject()) options.push(el('option', { value: OTHER }, 'As in the request'));
  const select = el('select', { name: path.join('.'), id }, ...options);
  select.value = isObject() ? OTHER : String(value ?? '');
  const help = el('p', { className: 'help' });
  const below = el('div', { className: 'fields nested' });
  const show = (): void => {
    help.textContent = host.describe(name, select.value) ?? control.help[select.value] ?? '';
    help.hidden = help.textContent === '';
    below.replaceChildren();
    below.hidden = select.value !== OTHER || !other;
    if (below.hidden || !other) return;
    const held = (): Record<string, unknown> => (isObject() ? value as Record<string, unknown> : {});
    for (const [inner, schema] of Object.entries(other.properties ?? {})) {
      const found = resolve(host.openapi, schema);
      const made = controlOf(host.openapi, found);
      if (made) below.append(make(host, inner, found, made, held()[inner], (next) => put(without({ ...held(), [inner]: next })), [...path, inner]));
    }
  };
  select.addEventListener('change', () => {
    if (select.value === OTHER) { if (other) put(firstOf(host.openapi, other)); } else put(select.value === '' ? undefined : select.value);
    show();
  });
  show();
  return el('div', { className: 'field choice' }, el('label', { htmlFor: id, title: field.description ?? '' }, titleOf(name)), select, help, below);
}

/** Whether an object can be filled in by controls: every field that it needs has one. */
const isForm = (openapi: OpenApi, schema: Schema): boolean =>
  Object.values(schema.properties ?? {}).length > 0 && (schema.required ?? []).every((name) => controlOf(openapi, resolve(openapi, schema.properties![name]!)));

/** A sound value to start from: what is required, with the first number of a group of weights set to 1. */
function firstOf(openapi: OpenApi, schema: Schema): Record<string, unknown> {
  return Object.fromEntries((schema.required ?? []).map((name) => {
    const field = resolve(openapi, schema.properties![name]!);
    const [first] = Object.keys(field.properties ?? {});
    return [name, first ? { [first]: 1 } : field['x-default'] ?? field.enum?.[0] ?? 1];
  }));
}

const without = (object: Record<string, unknown>): Record<string, unknown> => Object.fromEntries(Object.entries(object).filter(([, value]) => value !== undefined));

function group(host: FormHost, name: string, field: Schema, given: unknown, set: Set, path: string[]): HTMLElement {
  let held = (given ?? null) as Record<string, unknown> | null;
  const names = Object.keys(field.properties ?? {}).filter((each) => !PROMOTED.includes([...path, each].join('.')));
  const inner = el('div', { className: 'fields nested' });
  const optional = field.nullable === true;
  const fill = (): void => {
    inner.replaceChildren(...names.map((each) => {
      const found = resolve(host.openapi, field.properties![each]!);
      return make(host, each, found, controlOf(host.openapi, found)!, held?.[each], (next) => {
        // A promoted field of the same object may have been set meanwhile.
        held = without({ ...(path.length === 1 ? host.given(name) as object | null : held), [each]: next });
        set(held);
      }, [...path, each]);
    }));
  };
  if (!optional) {
    fill();
    return el('fieldset', { className: 'field nested', title: field.description ?? '' }, el('legend', {}, titleOf(name)), inner);
  }
  const box = el('input', { type: 'checkbox', name: path.join('.'), id: `option-${path.join('-')}`, checked: held !== null });
  const show = (): void => {
    inner.hidden = held === null;
    inner.replaceChildren();
    if (held) fill();
  };
  box.addEventListener('change', () => {
    held = box.checked ? firstOf(host.openapi, field) : null;
    set(held ?? undefined);
    show();
  });
  show();
  return el('div', { className: 'field nested' }, el('label', { className: 'check', title: field.description ?? '' }, box, titleOf(name)), inner);
}

function numberInput(name: string, id: string, field: Schema, whole: boolean, value: unknown): HTMLInputElement {
  const least = field.minimum ?? (field.exclusiveMinimum !== undefined ? field.exclusiveMinimum : undefined);
  return el('input', {
    type: 'number', name, id, step: whole ? '1' : 'any', value: (value as number | null | undefined) ?? '', placeholder: 'auto', inputMode: 'decimal',
    ...(least !== undefined && { min: String(least) }), ...(field.maximum !== undefined && { max: String(field.maximum) }),
  });
}

/** An object of which exactly one number is given, such as the resolution. */
function oneOf(host: FormHost, name: string, field: Schema, value: unknown, set: Set, path: string[]): HTMLElement {
  let held = (value ?? {}) as Record<string, number | null>;
  const choices = Object.keys(field.properties ?? {});
  let chosen = choices.find((each) => held[each] !== undefined && held[each] !== null) ?? choices[0]!;
  const select = el('select', { 'aria-label': titleOf(name), name: path.join('.') }, ...choices.map((each) => el('option', { value: each }, humanise(each))));
  select.value = chosen;
  const schema = (each: string): Schema => resolve(host.openapi, field.properties![each]!);
  const whole = (each: string): boolean => [schema(each).type].flat().includes('integer');
  const input = numberInput(`${path.join('.')}.value`, `option-${path.join('-')}`, schema(chosen), whole(chosen), held[chosen]);
  input.setAttribute('aria-label', `${titleOf(name)}, value`);
  select.addEventListener('change', () => {
    input.value = '';
    input.step = whole(select.value) ? '1' : 'any';
    input.focus();
  });
  const pair = el('span', { className: 'pair' }, select, input);
  // A choice that is left without a number is given up, because the form shows what the request holds. While another window has
  // the focus the pair keeps it.
  pair.addEventListener('focusout', (event) => {
    if (input.value !== '' || pair.contains(event.relatedTarget as Node | null) || pair.contains(document.activeElement)) return;
    select.value = chosen;
    input.step = whole(chosen) ? '1' : 'any';
    input.value = String(held[chosen] ?? '');
  });
  input.addEventListener('change', () => {
    if (!input.reportValidity()) return;
    chosen = select.value;
    held = input.value === '' ? {} : { [chosen]: input.valueAsNumber };
    set(input.value === '' ? undefined : held);
  });
  return el('div', { className: 'field', title: field.description ?? '' }, el('span', {}, titleOf(name)), pair);
}
