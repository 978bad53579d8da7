// JSON with a fault that a person can find.

import { FileFault } from './lines';

/** JSON, or one sentence that names the line of the first fault. */
export function parseJson(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    const [, position] = /position (\d+)/.exec(message) ?? [];
    const line = position === undefined ? text.split('\n').length : text.slice(0, Number(position)).split('\n').length;
    throw new FileFault(`this is not JSON: ${message.replace(/ (in JSON )?at position.*$/, '')}.`, line);
  }
}
