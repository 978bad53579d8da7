// Controls for a request's options, made from the schema that the server publishes: what it does not offer cannot be chosen,
// and what it learns to offer appears by itself.

import { element, humanise } from './dom.js';

/** The request schema of a path, and a resolver for its references. */
export function schemaOf(openapi, path) {
  const body = openapi.paths?.[path]?.post?.requestBody?.content?.['application/json']?.schema;
  return body ? resolve(openapi, body) : null;
}

function resolve(openapi, schema) {
  let found = schema;
  const outer = {};
  for (let depth = 0; depth < 8; depth += 1) {
    if (found.description) outer.description ??= found.description;
    if (found.default !== undefined) outer.default ??= found.default;
    if (nonNull(found)) outer.nullable = true;
    const next = found.$ref ?? found.allOf?.[0]?.$ref ?? nonNull(found)?.$ref;
    if (!next) break;
    found = next.slice(2).split('/').reduce((value, step) => value?.[step], openapi) ?? {};
  }
  return { ...(nonNull(found) ?? found), ...outer };
}

const nonNull = (schema) => (schema.anyOf ?? schema.oneOf)?.some((each) => each.type === 'null')
  ? (schema.anyOf ?? schema.oneOf).find((each) => each.type !== 'null') : null;

/** What kind of control a resolved schema calls for; null if none does it justice (lists, nested objects). */
function controlOf(schema) {
  const variants = schema.oneOf ?? [schema];
  const names = variants.flatMap((each) => each.enum ?? [each.const]);
  if (names.every((name) => typeof name === 'string')) {
    const help = Object.fromEntries(variants.flatMap((each) => (each.enum ?? [each.const]).map((name) => [name, each.description])));
    return { type: 'choice', names, help };
  }
  const types = [schema.type].flat();
  if (types.includes('boolean')) return { type: 'flag' };
  if (types.includes('integer') || types.includes('number')) return { type: 'number', whole: types.includes('integer') };
  if (types.includes('object') && schema.maxProperties === 1) return { type: 'one_of' };
  return null;
}

const SHOWN_FIRST = ['objective', 'secondary_objective', 'solver', 'resolution', 'edge_length', 'closed', 'optimise_nodes', 'boundary_sampling'];

/** Fills the form; `onChange` is called after each change of `request`. */
export function build(form, openapi, schema, request, onChange) {
  form.replaceChildren();
  const rest = element('div');
  const names = Object.keys(schema.properties ?? {}).filter((name) => name !== 'kind');
  names.sort((a, b) => rank(a) - rank(b));
  for (const name of names) {
    const field = resolve(openapi, schema.properties[name]);
    const control = controlOf(field);
    // A choice of one is no choice, and a default that nothing can change needs no control.
    if (!control || (control.type === 'choice' && control.names.length < 2)) continue;
    const made = make(openapi, name, field, control, request, onChange);
    (SHOWN_FIRST.includes(name) ? form : rest).append(made);
  }
  if (rest.childElementCount > 0) form.append(element('details', {}, element('summary', {}, 'More options'), rest));
}

const rank = (name) => (SHOWN_FIRST.indexOf(name) + 1 || SHOWN_FIRST.length + 1);

function make(openapi, name, field, control, request, onChange) {
  const value = request[name] ?? field.default;
  const set = (next) => {
    if (next === undefined) delete request[name];
    else request[name] = next;
    onChange(name);
  };
  const title = field.description ?? '';
  if (control.type === 'flag') {
    const box = element('input', { type: 'checkbox', name, checked: value === true });
    box.addEventListener('change', () => set(box.checked));
    return element('label', { className: 'check', title }, box, humanise(name));
  }
  if (control.type === 'choice') {
    const options = control.names.map((each) => element('option', { value: each, title: control.help[each] ?? '' }, humanise(each)));
    if (field.nullable || field.default === undefined) {
      options.unshift(element('option', { value: '' }, field.nullable ? 'None' : 'Default'));
    }
    const select = element('select', { name }, ...options);
    select.value = value ?? '';
    select.addEventListener('change', () => set(select.value || undefined));
    return element('label', { title }, humanise(name), select);
  }
  if (control.type === 'number') {
    const input = numberInput(name, field, control.whole, value);
    input.addEventListener('change', () => set(input.value === '' ? undefined : input.valueAsNumber));
    return element('label', { title }, humanise(name), input);
  }
  return oneOf(openapi, name, field, value, set);
}

function numberInput(name, field, whole, value) {
  return element('input', {
    type: 'number', name, step: whole ? 1 : 'any', value: value ?? '', placeholder: 'auto',
    ...(field.minimum !== undefined && { min: field.minimum }), ...(field.maximum !== undefined && { max: field.maximum }),
  });
}

/** An object of which exactly one number is given, such as the resolution. */
function oneOf(openapi, name, field, value, set) {
  const choices = Object.keys(field.properties ?? {});
  const chosen = choices.find((each) => value?.[each] !== undefined && value[each] !== null) ?? choices[0];
  const select = element('select', { 'aria-label': humanise(name) }, ...choices.map((each) => element('option', { value: each }, humanise(each))));
  select.value = chosen;
  const schema = (choice) => resolve(openapi, field.properties[choice]);
  const input = numberInput(name, schema(chosen), [schema(chosen).type].flat().includes('integer'), value?.[chosen]);
  input.setAttribute('aria-label', `${humanise(name)}, value`);
  const changed = () => {
    input.step = [schema(select.value).type].flat().includes('integer') ? 1 : 'any';
    if (input.value !== '') set({ [select.value]: input.valueAsNumber });
  };
  select.addEventListener('change', () => { input.value = ''; input.focus(); });
  input.addEventListener('change', changed);
  return element('div', { className: 'field', title: field.description ?? '' }, element('span', {}, humanise(name)), element('span', { className: 'pair' }, select, input));
}
