// The request as a program that posts it and saves the mesh.

import type { Kind } from 'plateau-client';
import { absolute, hasKey } from '../api';
import { KINDS, type Request } from '../model/request';

const slashed = (text: string): string => text.replaceAll("'", String.raw`'\''`);

export function curl(kind: Kind, request: Request): string {
  const key = hasKey() ? ` -H "Authorization: Bearer $PLATEAU_KEY"` : '';
  const origin = new URL(absolute('/')).origin;
  return `# Posts the request, waits for its job, and saves the mesh as surface.glb.
job=$(curl -sS --fail-with-body -D - -o /dev/null${key} -H 'Content-Type: application/json' -X POST '${absolute(KINDS[kind].path)}' --data-binary @- <<'JSON' | tr -d '\\r' | sed -n 's/^[Ll]ocation: //p'
${JSON.stringify(request)}
JSON
)
curl -sS --fail --retry 120 --retry-delay 1 --retry-all-errors${key} -o surface.glb "${slashed(origin)}$job/mesh?format=glb"
`;
}

export function python(kind: Kind, request: Request): string {
  const key = hasKey() ? `,\n    "Authorization": "Bearer " + os.environ["PLATEAU_KEY"]` : '';
  return `import json
import os
import time
import urllib.request

SERVER = "${new URL(absolute('/')).origin}"
HEADERS = {
    "Content-Type": "application/json",
    "Prefer": "wait=30"${key},
}
REQUEST = json.loads(r"""${JSON.stringify(request)}""")


def call(url, body=None):
    data = None if body is None else json.dumps(body).encode()
    with urllib.request.urlopen(urllib.request.Request(url, data, HEADERS)) as answer:
        return answer.read()


job = json.loads(call("${absolute(KINDS[kind].path)}", REQUEST))
while job["status"] in ("queued", "running"):
    time.sleep(0.2)
    job = json.loads(call(SERVER + job["links"]["self"]))
if job["status"] != "succeeded":
    raise SystemExit(job["error"])
print(json.dumps({k: v for k, v in job["statistics"].items() if isinstance(v, (int, float))}, indent=1))
with open("surface.glb", "wb") as file:
    file.write(call(SERVER + job["links"]["mesh"] + "?format=glb"))
`.replace(/^import os\n/m, key ? 'import os\n' : '');
}

export function typescript(kind: Kind, request: Request): string {
  const key = hasKey() ? `, Authorization: \`Bearer \${process.env.PLATEAU_KEY}\`` : '';
  return `import { writeFile } from "node:fs/promises";

interface Job {
  status: "queued" | "running" | "succeeded" | "failed" | "cancelled";
  links: { self: string; mesh: string };
  error: unknown;
}

const server = "${new URL(absolute('/')).origin}";
const headers = { "Content-Type": "application/json", Prefer: "wait=30"${key} };
const request = ${JSON.stringify(request)};

async function call(url: string, init: RequestInit = {}): Promise<Response> {
  const answer = await fetch(url, { ...init, headers });
  if (!answer.ok) throw new Error(await answer.text());
  return answer;
}

let job = (await (await call("${absolute(KINDS[kind].path)}", { method: "POST", body: JSON.stringify(request) })).json()) as Job;
while (job.status === "queued" || job.status === "running") {
  job = (await (await call(server + job.links.self)).json()) as Job;
}
if (job.status !== "succeeded") throw new Error(JSON.stringify(job.error));
const mesh = await call(server + job.links.mesh + "?format=glb");
await writeFile("surface.glb", new Uint8Array(await mesh.arrayBuffer()));
`;
}
