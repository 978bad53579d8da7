// Whether the page is at work, as `aria-busy` on its body, and which of several openings counts.

let underWay = 0;
let openings = 0;

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

/** Uses what `fetch` brings, unless something else is being opened by then: the later of two openings wins. */
export const opening = <T>(fetch: () => Promise<T>, use: (found: T) => void, fail: (error: unknown) => void): Promise<void> => whileBusy(async () => {
  openings += 1;
  const own = openings;
  try {
    const found = await fetch();
    if (own === openings) use(found);
  } catch (error) {
    if (own === openings) fail(error);
  }
});
