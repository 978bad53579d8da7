// The service behind this page, through its TypeScript client.

import { Plateau } from 'plateau-client';

/** The folder of this page, without `studio/` for the page that is embedded elsewhere: the page works behind a prefix. */
export const page = new URL('.', document.baseURI).href.replace(/studio\/$/, '');
/** The full address of a path of the service. */
export const absolute = (path: string): string => page + path.replace(/^\//, '');

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
