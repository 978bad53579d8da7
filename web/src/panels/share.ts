// A link that holds request and camera, and the frame for another page.

import type { Kind } from 'plateau-client';
import { page } from '../api';
import type { Request } from '../model/request';
import type { Pose } from '../stage/stage';

export interface Shared { kind: Kind; request: Request; title?: string | null; camera?: Pose; colour?: string }

async function through(bytes: Uint8Array<ArrayBuffer>, stream: CompressionStream | DecompressionStream): Promise<Uint8Array<ArrayBuffer>> {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

export async function pack(value: unknown): Promise<string> {
  const bytes = await through(new TextEncoder().encode(JSON.stringify(value)), new CompressionStream('deflate-raw'));
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

export async function unpack(text: string): Promise<unknown> {
  const bytes = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(await through(bytes, new DecompressionStream('deflate-raw'))));
}

export const linkOf = async (shared: Shared): Promise<string> => `${page}#s=${await pack(shared)}`;

export async function embedOf(shared: Shared): Promise<string> {
  return `<iframe src="${page}studio/embed.html#s=${await pack(shared)}" width="800" height="500" title="Plateau" loading="lazy"></iframe>`;
}
