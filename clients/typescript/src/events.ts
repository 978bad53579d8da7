/** Server-sent events by fetch, which unlike EventSource can send an API key. */
export interface ServerEvent {
  event: string;
  id: string;
  data: string;
}

/** The events of a response's body, as they come. */
export async function* readEvents(body: ReadableStream<Uint8Array>): AsyncGenerator<ServerEvent> {
  const reader = body.getReader();
  const decoder = new TextDecoder();
  let text = '';
  let fields: Partial<ServerEvent> = {};
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return;
      const lines = (text + decoder.decode(value, { stream: true })).split('\n');
      text = lines.pop()!;
      for (const raw of lines) {
        const line = raw.replace(/\r$/, '');
        if (line === '') {
          const { event = 'message', id = '', data } = fields;
          fields = {};
          if (data !== undefined) yield { event, id, data };
          continue;
        }
        const colon = line.indexOf(':');
        const name = colon < 0 ? line : line.slice(0, colon);
        const content = colon < 0 ? '' : line.slice(colon + 1).replace(/^ /, '');
        if (name === 'data') fields.data = fields.data === undefined ? content : `${fields.data}\n${content}`;
        else if (name === 'event' || name === 'id') fields[name] = content;
      }
    }
  } finally {
    await reader.cancel().catch(() => undefined);
  }
}
