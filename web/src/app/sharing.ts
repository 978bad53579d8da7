// The dialog that hands the request on: as a link, as a frame for another page, as a program, as a picture.

import { isStatic } from '../api';
import { isOfPage } from '../solvers';
import { $, el, save } from '../dom';
import { curl, python, typescript } from '../panels/programs';
import * as share from '../panels/share';
import { worldPose } from './keeping';
import { fileName } from '../text';
import { doc, isStale, session, stage } from './session';

/** A page without a service has nothing that a program could call. */
const FORMS = (['Short link', 'Link', 'Embed', 'curl', 'Python', 'TypeScript'] as const).slice(isStatic ? 1 : 0, isStatic ? 3 : 6);
/** Whether a link may name the job, because the service keeps the result that is shown. */
const isServed = (): boolean => session.shown !== null && !session.viewing && !isStale() && !isOfPage(session.shown.job);
let texts = 0;

export async function openShare(): Promise<void> {
  await showText(isServed() ? 'Short link' : 'Link');
  $<HTMLDialogElement>('share').showModal();
}

/** The request in one of its forms; form and text change together, so that what is copied is what its button says. */
async function showText(form: (typeof FORMS)[number]): Promise<void> {
  texts += 1;
  const own = texts;
  const { kind, request, title } = doc();
  const shared = { kind, request, title, camera: worldPose(), colour: session.colour };
  const text = form === 'Short link' ? share.shortLinkOf(session.shown!.job.id, shared) : form === 'Link' ? await share.linkOf(shared)
    : form === 'Embed' ? await share.embedOf(shared)
      : form === 'curl' ? curl(kind, request) : form === 'Python' ? python(kind, request) : typescript(kind, request);
  if (own !== texts) return;
  $('share-forms').replaceChildren(...FORMS.filter((each) => each !== 'Short link' || isServed()).map((each) => el('button', { type: 'button', 'aria-pressed': String(each === form), onclick: () => void showText(each) }, each)));
  $<HTMLTextAreaElement>('share-text').value = text;
  $('copied').textContent = '';
}

export async function copy(): Promise<void> {
  try {
    await navigator.clipboard.writeText($<HTMLTextAreaElement>('share-text').value);
    $('copied').textContent = 'Copied.';
  } catch {
    $<HTMLTextAreaElement>('share-text').select();
    $('copied').textContent = 'Press Ctrl C: the browser does not let this page copy.';
  }
}

export async function savePicture(): Promise<void> {
  save(await stage.picture(2, document.documentElement.dataset.theme === 'dark' ? '#1a2023' : '#f3f4f3'), `${fileName(doc().title) ?? 'plateau'}.png`);
}
