// Whether the page is at work, as `aria-busy` on its body, and the order of what was asked for.

let underWay = 0;
let asked = 0;
let newestOpening = 0;

/** The number of something that is asked for: a solve, an opening, a download. Later ones have larger numbers. */
export function ask(): number {
  asked += 1;
  return asked;
}

/** The page is busy from the press that begins some work until its end, however it ends. */
export async function whileBusy<T>(work: () => Promise<T>): Promise<T> {
  underWay += 1;
  document.body.setAttribute('aria-busy', 'true');
  try {
    return await work();
  } finally {
    underWay -= 1;
    document.body.setAttribute('aria-busy', String(underWay > 0));
  }
}

/** What is still being fetched will not be opened, because something else was chosen since. */
export function supersedeOpenings(): void {
  newestOpening = ask();
}

/** Uses what `fetch` brings, unless something else is being opened by then: the later of two openings wins. */
export const opening = <T>(fetch: () => Promise<T>, use: (found: T) => void, fail: (error: unknown, turn: number) => void): Promise<void> => whileBusy(async () => {
  const own = ask();
  newestOpening = own;
  try {
    const found = await fetch();
    if (own === newestOpening) use(found);
  } catch (error) {
    if (own === newestOpening) fail(error, own);
  }
});
