// A link that holds request and camera, and the frame for another page.

import type { Kind } from 'plateau-client';
import { page, plateau } from '../api';
import type { Request, Vec3 } from '../model/request';
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

/** Maximum number of characters of a title in a short link. */
const LONGEST_TITLE = 60;

/** A link that names a job of the service, with the camera as finely as it is seen. */
export function shortLinkOf(job: string, { title, camera, colour }: Shared): string {
  const { eye, target } = camera!;
  const digits = Math.min(Math.max(4 - Math.floor(Math.log10(Math.hypot(...eye.map((value, axis) => value - target[axis]!)))), 0), 20);
  const rest = new URLSearchParams({ j: job, v: [...eye, ...target].map((value) => String(Number(value.toFixed(digits)))).join('_'), ...(colour && colour !== 'plain' && { c: colour }), ...(title && { t: title.slice(0, LONGEST_TITLE) }) });
  return `${page}#${rest}`;
}

/** The request that a short link names, with its camera; null if the address is none. */
export async function openShort(hash: string): Promise<(Shared & { job: string }) | null> {
  const values = new URLSearchParams(hash.slice(1));
  const job = values.get('j');
  if (!job) return null;
  const { kind, ...given } = await plateau.getJson<Request & { kind: Kind }>(`v1/jobs/${encodeURIComponent(job)}/request`);
  // The service writes fields that were left out as null.
  const request = Object.fromEntries(Object.entries(given).filter(([, value]) => value !== null));
  const view = (values.get('v') ?? '').split('_').map(Number);
  const camera = view.length === 6 && view.every(Number.isFinite) ? { eye: view.slice(0, 3) as Vec3, target: view.slice(3) as Vec3 } : undefined;
  return { kind, request, title: values.get('t'), job, colour: values.get('c') ?? 'plain', ...(camera && { camera }) };
}

export async function embedOf(shared: Shared): Promise<string> {
  return `<iframe src="${page}studio/embed.html#s=${await pack(shared)}" width="800" height="500" title="Plateau" loading="lazy"></iframe>`;
}
