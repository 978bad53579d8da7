// A proxy in front of the service that breaks connections where a test wants it.

import { createServer, request as ask } from 'node:http';
import { pipeline, Transform } from 'node:stream';

/**
 * Starts a proxy on a free port in front of the server whose address `target` returns: { url, seen, breakAll, stop }.
 * `breakAll` breaks every connection of the moment. A test sets `meddle`, which gets each request, may change its headers, and
 * says what becomes of it:
 *   undefined             it is passed on
 *   'break'               the connection is broken without an answer
 *   'silence'             there never is an answer, and the service does not see the request
 *   { cut: expression }   the answer is passed on up to the end of the expression's first match, and then broken
 *   { cutAfter: ms }      the answer is passed on for so long, and then broken
 *   a promise             any of these, once it is settled
 */
export async function startProxy(target) {
  const proxy = { url: '', seen: [], meddle: () => undefined, breakAll: () => server.closeAllConnections() };
  const server = createServer(async (incoming, outgoing) => {
    proxy.seen.push(incoming);
    const rule = await proxy.meddle(incoming);
    if (rule === 'silence') return;
    if (rule === 'break') {
      incoming.destroy();
      return;
    }
    const { hostname, port } = new URL(target());
    const onward = ask({ hostname, port, method: incoming.method, path: incoming.url, headers: incoming.headers }, (answer) => {
      outgoing.writeHead(answer.statusCode, answer.headers);
      outgoing.flushHeaders();
      const steps = rule?.cut ? [cutting(rule.cut, () => outgoing.destroy())] : [];
      if (rule?.cutAfter) setTimeout(() => outgoing.destroy(), rule.cutAfter);
      pipeline(answer, ...steps, outgoing, () => answer.destroy());
    });
    onward.on('error', () => outgoing.destroy());
    outgoing.on('close', () => onward.destroy());
    incoming.pipe(onward);
  });
  await new Promise((resolve) => { server.listen(0, '127.0.0.1', resolve); });
  proxy.url = `http://127.0.0.1:${server.address().port}`;
  proxy.stop = async () => {
    proxy.breakAll();
    await new Promise((resolve) => { server.close(resolve); });
  };
  return proxy;
}

/** Passes bytes on up to the end of an expression's first match, and then calls `cut` once they are written. */
function cutting(expression, cut) {
  let text = '', passed = 0;
  return new Transform({
    transform(chunk, _, done) {
      text += chunk.toString('latin1');
      const match = expression.exec(text);
      const end = match ? match.index + match[0].length : text.length;
      this.push(Buffer.from(text.slice(passed, end), 'latin1'));
      passed = end;
      // The bytes reach the page before the connection breaks.
      if (match) setImmediate(() => setImmediate(cut));
      else done();
    },
  });
}
