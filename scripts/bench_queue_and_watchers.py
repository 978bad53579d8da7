"""Lists 10,000 queued jobs page by page, then follows one job with 1,000 watchers. Prints the figures as JSON. Used by
scripts/bench-load."""

import asyncio
import json
import math
import sys
import time
import urllib.parse
import urllib.request

JOBS = 10_000
WATCHERS = 1_000


def strip(number, points):
    def rail(y, phase):
        return [[10 * k / points, y + math.sin(9 * k / points + phase), math.cos(7 * k / points)] for k in range(points)]

    first = rail(0, 0)
    first[0][0] = -1e-9 * number
    return json.dumps({"directrices": [first, rail(4, 1)], "cache": "bypass"}).encode()


def endless():
    """Returns a film with tolerances of 0, which is solved until it is cancelled."""
    turns = [2 * math.pi * k / 100 for k in range(100)]
    loop = [[math.cos(t), math.sin(t), 0.3 * math.sin(2 * t)] for t in turns]
    return json.dumps({"boundaries": [loop], "resolution": {"triangles": 20_000}, "solver": "vertex_relaxation",
                       "area_tolerance": 0, "fairing_tolerance": 0, "max_iterations": 1_000_000}).encode()


async def post(reader, writer, path, body):
    head = f"POST {path} HTTP/1.1\r\nhost: localhost\r\ncontent-type: application/json\r\ncontent-length: {len(body)}\r\n\r\n"
    writer.write(head.encode() + body)
    status = int((await reader.readline()).split()[1])
    length = 0
    while (line := await reader.readline()) not in (b"\r\n", b""):
        name, _, value = line.partition(b":")
        if name.lower() == b"content-length":
            length = int(value)
    return status, json.loads(await reader.readexactly(length))


async def fill(host, port):
    async def client(share):
        reader, writer = await asyncio.open_connection(host, port)
        for number in share:
            status, _ = await post(reader, writer, "/v1/ruled-surfaces", strip(number, 4))
            assert status == 202, status
        writer.close()

    started = time.perf_counter()
    await asyncio.gather(*(client(range(start, JOBS, 16)) for start in range(16)))
    return time.perf_counter() - started


def list_all(url):
    seen, pages, path = set(), [], "/v1/jobs?status=queued&limit=200"
    while path:
        started = time.perf_counter()
        page = json.load(urllib.request.urlopen(url + path))
        pages.append(time.perf_counter() - started)
        ids = {job["id"] for job in page["jobs"]}
        assert not ids & seen
        seen |= ids
        path = page["next_cursor"] and f"/v1/jobs?status=queued&limit=200&cursor={page['next_cursor']}"
    assert len(seen) == JOBS, len(seen)
    return pages


def resident_mib(pid):
    for line in open(f"/proc/{pid}/status"):
        if line.startswith("VmRSS:"):
            return int(line.split()[1]) / 1024


async def watch(host, port, pid):
    reader, writer = await asyncio.open_connection(host, port)
    status, job = await post(reader, writer, "/v1/minimal-surfaces", endless())
    assert status == 202, job
    before = resident_mib(pid)
    seen_at, progress = [], 0

    async def watcher():
        nonlocal progress
        reader, writer = await asyncio.open_connection(host, port)
        writer.write(f"GET {job['links']['events']} HTTP/1.1\r\nhost: localhost\r\n\r\n".encode())
        while line := await reader.readline():
            if line.startswith(b"event: progress"):
                progress += 1
            if line.startswith(b"data:") and b'"status":"cancelled"' in line:
                seen_at.append(time.perf_counter())
                writer.close()
                return

    watchers = [asyncio.create_task(watcher()) for _ in range(WATCHERS)]
    while progress < WATCHERS:
        await asyncio.sleep(0.01)  # between two looks
    during = resident_mib(pid)
    asked = time.perf_counter()
    status, cancelled = await post(reader, writer, job["links"]["cancel"], b"")
    assert (status, cancelled["status"]) == (200, "cancelled")
    await asyncio.gather(*watchers)
    last = max(seen_at) - asked
    return {"watchers": len(seen_at), "progress_events": progress, "last_sees_cancel_ms": round(last * 1000, 1),
            "memory_mib": [round(before, 1), round(during, 1)]}


def address(url):
    parts = urllib.parse.urlsplit(url)
    return parts.hostname, parts.port


queue, watched, pid = sys.argv[1:]
filled_s = asyncio.run(fill(*address(queue)))
pages = sorted(list_all(queue))
print(json.dumps({
    "queued_10000": {"submitted_per_s": round(JOBS / filled_s), "pages": len(pages),
                     "page_p50_ms": round(pages[len(pages) // 2] * 1000, 2), "page_max_ms": round(pages[-1] * 1000, 2)},
    "watchers_1000": asyncio.run(watch(*address(watched), pid)),
}))
