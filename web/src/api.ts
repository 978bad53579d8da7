// The service behind this page, through its TypeScript client.

import { NotFound, Plateau } from 'plateau-client';

/** The folder of this page, without `studio/` for the page that is embedded elsewhere: the page works behind a prefix. */
export const page = new URL('.', document.baseURI).href.replace(/studio\/$/, '');
/** The full address of a path of the service. */
export const absolute = (path: string): string => page + path.replace(/^\//, '');

/** Whether this page lies in a folder of a file server, without a service behind it. */
export const isStatic = document.documentElement.hasAttribute('data-static');

/** Time for which a busy server is asked again before the page says that it is busy. */
const PATIENCE_MS = 10_000;
const connect = (apiKey: string): Plateau => new Plateau({ url: page, apiKey, patienceMs: PATIENCE_MS });

let key = '';
export let plateau = connect(key);
export const hasKey = (): boolean => key !== '';
export function setKey(value: string): void {
  key = value;
  plateau = connect(key);
}

/** A document that the service publishes, of which a page without a service has a copy. */
export async function published<T>(path: string): Promise<T> {
  if (!isStatic) return plateau.getJson<T>(path);
  const answer = await fetch(absolute(`studio/data/${path.replace(/^v1\//, '').replace(/\.json$/, '')}.json`));
  if (answer.status === 404) throw new NotFound({ title: 'There is no such document', detail: path });
  if (!answer.ok) throw new Error(`${path} was answered with ${answer.status}`);
  return answer.json() as Promise<T>;
}
