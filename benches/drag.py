#!/usr/bin/env python3
"""Dragging a corner of a film: how long after the last request the last mesh is there.

A program sends ten requests a second for two seconds, each for a film of --triangles triangles with another corner, and
throws away all but the last. It does so three times each

  with `supersede`:     every request names the same series, so the server cancels the older jobs of the series
  without `supersede`:  every job runs to its end

and once sends a single request. One JSON line; with --record FILE it is appended, with date and commit.

Run:  cargo build --release && python3 benches/drag.py --record benches/results.jsonl
"""
import argparse
import datetime
import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
REQUESTS, A_SECOND = 20, 10


def ask(url, body=None, headers=None):
    data = None if body is None else json.dumps(body).encode()
    request = urllib.request.Request(url, data, {"Content-Type": "application/json", **(headers or {})})
    with urllib.request.urlopen(request) as answer:
        return answer.read()


def film(triangles, height):
    corners = [[0, 0, 0], [10, 0, 3], [10, 10, height], [0, 10, 3]]
    return {"boundaries": [corners], "resolution": {"triangles": triangles}, "cache": "bypass"}


def fetch(server, job):
    """Waits for the end of a job and returns its mesh."""
    while job["status"] in ("queued", "running"):
        job = json.loads(ask(server + job["links"]["self"], headers={"Prefer": "wait=60"}))
    assert job["status"] == "succeeded", job
    return ask(f"{server}{job['links']['mesh']}?format=glb")


def drag(server, triangles, series):
    """Seconds from the last of the requests to its mesh."""
    jobs, senders = [None] * REQUESTS, []

    def send(number):
        request = film(triangles, number / REQUESTS)
        if series:
            request["supersede"] = series
        jobs[number] = json.loads(ask(f"{server}/v1/minimal-surfaces", request))

    started = time.monotonic()
    for number in range(REQUESTS):
        time.sleep(max(0.0, started + number / A_SECOND - time.monotonic()))
        last = time.monotonic()
        senders.append(threading.Thread(target=send, args=(number,)))
        senders[-1].start()
    for sender in senders:
        sender.join()
    size = len(fetch(server, jobs[-1]))
    seconds = time.monotonic() - last
    states = [json.loads(ask(server + job["links"]["self"]))["status"] for job in jobs]
    # The jobs that go on would slow down the next run.
    for job in jobs:
        ask(f"{server}{job['links']['cancel']}", body={})
    return seconds, states.count("cancelled"), size


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--program", default=str(ROOT / "target" / "release" / "plateau"))
    arguments.add_argument("--triangles", type=int, default=150_000)
    arguments.add_argument("--runs", type=int, default=3)
    arguments.add_argument("--record")
    arguments.add_argument("--note")
    arguments = arguments.parse_args()
    with tempfile.TemporaryDirectory() as data:
        program = [arguments.program, "--listen", "127.0.0.1:0", "--data", data]
        environment = {**os.environ, "PLATEAU_LOG__LEVEL": "warn"}
        server = subprocess.Popen(program, stdout=subprocess.PIPE, text=True, env=environment)
        try:
            url = server.stdout.readline().split()[-1]
            alone = []
            for run in range(arguments.runs):
                started = time.monotonic()
                fetch(url, json.loads(ask(f"{url}/v1/minimal-surfaces", film(arguments.triangles, 5 + run))))
                alone.append(time.monotonic() - started)
            with_it = [drag(url, arguments.triangles, f"drag-{run}") for run in range(arguments.runs)]
            without = [drag(url, arguments.triangles, None) for run in range(arguments.runs)]
        finally:
            server.terminate()
            server.wait()
    seconds = [statistics.median(run[0] for run in runs) for runs in (with_it, without)]
    line = {
        "date": datetime.date.today().isoformat(),
        "commit": commit(),
        "machine": f"{os.cpu_count()} cores {platform.machine()}",
        "bench": "drag_supersede",
        "triangles": arguments.triangles,
        "requests": REQUESTS,
        "requests_a_second": A_SECOND,
        "glb_bytes": with_it[-1][2],
        "last_request_to_last_mesh_s": [round(run[0], 2) for run in with_it],
        "cancelled": [run[1] for run in with_it],
        "without_supersede_s": [round(run[0], 2) for run in without],
        "one_film_alone_s": [round(value, 2) for value in alone],
        "ratio_to_without": round(seconds[0] / seconds[1], 3),
        "build": Path(arguments.program).parent.name,
        "load_at_the_end": round(os.getloadavg()[0], 2),
    }
    if arguments.note:
        line["note"] = arguments.note
    print(json.dumps(line))
    if arguments.record:
        with open(arguments.record, "a") as record:
            record.write(json.dumps(line) + "\n")


def commit():
    return subprocess.run(["git", "rev-parse", "--short", "HEAD"], capture_output=True, text=True, cwd=ROOT).stdout.strip()


if __name__ == "__main__":
    sys.exit(main())
