#!/usr/bin/env python3
"""Solves the papers' examples through a running service and judges the meshes that it returns.

    python3 benches/papers/run.py [http://127.0.0.1:8080] [--only TEXT] [--keep FOLDER] [--update]

examples.json lists them. Each figure of a mesh is measured by judge.py from the OBJ file, never taken from the
service's statistics. The table has the paper's printed figure, the expected one and the measured one; the exit status
is 1 if one is farther from the expected than its `within`, which is a part of the figure, or if a mesh has faults that the run does not expect.
--update writes the measured figures into examples.json as the expected ones. The requests of several examples run one
after another, so that the seconds of the table are those of one request; they include the transfer.
"""
import argparse
import json
import os
import sys
import tempfile
import time
import urllib.error
import urllib.request

import judge
import meshfiles

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
EXAMPLES = os.path.join(HERE, "examples.json")
# Seconds for which one example may be solved.
PATIENCE = 300


def load(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return json.load(file)


def call(url, body=None, **headers):
    data = None if body is None else json.dumps(body).encode()
    request = urllib.request.Request(url, data, {"Content-Type": "application/json", **headers} if data else headers)
    try:
        with urllib.request.urlopen(request, timeout=PATIENCE) as answer:
            return answer.read()
    except urllib.error.HTTPError as error:
        raise SystemExit(f"{url}: {error.code} {error.read().decode()[:400]}") from None


def solve(service, request):
    """The finished job and its mesh as OBJ, in the client's axes with all digits."""
    path = request["kind"].replace("_", "-") + ("es" if request["kind"].endswith("mesh") else "s")
    job = json.loads(call(f"{service}/v1/{path}", request, Prefer="wait=60"))
    ends = time.monotonic() + PATIENCE
    while job["status"] in ("queued", "running") and time.monotonic() < ends:
        job = json.loads(call(service + job["links"]["self"], Prefer="wait=60"))
    if job["status"] != "succeeded":
        raise SystemExit(f"{job['status']}: {json.dumps(job.get('error'))[:400]}")
    return job, call(service + job["links"]["mesh"] + "?format=obj")


def pick(found, name):
    for part in name.split("."):
        found = found.get(part) if isinstance(found, dict) else None
    return found


def shown(value):
    if value is None:
        return ""
    if isinstance(value, int):
        return str(value)
    return f"{value:.2e}" if value and abs(value) < 0.01 else f"{value:.6g}"


def run_of(service, example, run, keep):
    request = {**load(example["request"]), **example["runs"][run].get("with", {})}
    started = time.monotonic()
    job, data = solve(service, request)
    seconds = time.monotonic() - started
    folder = keep or tempfile.mkdtemp()
    path = os.path.join(folder, f"{example['name']}.{run.replace(' ', '-')}.obj")
    with open(path, "wb") as file:
        file.write(data)
    found = judge.judge(
        meshfiles.read(path), request, example.get("surface"), None, example.get("lattice"),
        request.get("edge_length"))
    if not keep:
        os.remove(path)
        os.rmdir(folder)
    return job, found, seconds


def compare(example, run, found, update):
    """The table's rows for a run, and whether all its figures are as expected."""
    entry, right, rows = example["runs"][run], True, []
    expected = entry.setdefault("expected", {})
    for figure in example["figures"]:
        name = figure["name"]
        value = pick(found, name)
        if update:
            expected[name] = value
        want, within = expected.get(name), figure["within"]
        # A figure below `noise` is rounding, whatever its digits.
        noise = figure.get("noise", 0.0)
        good = value is not None and want is not None and abs(value - want) <= max(within * abs(want), noise)
        right &= good
        rows.append([name.split(".", 1)[1], shown(figure.get("printed")), shown(want), shown(value), "" if good else "DIFFERS"])
    return rows, right


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("service", nargs="?", default=os.environ.get("PLATEAU_URL", "http://127.0.0.1:8080"))
    parser.add_argument("--only", default="", help="a part of the examples' names")
    parser.add_argument("--keep", help="the folder for the meshes")
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()
    if options.keep:
        os.makedirs(options.keep, exist_ok=True)
    service = options.service.rstrip("/")
    catalogue = load(EXAMPLES)
    right = True
    print("| example | run | figure | the paper | expected | measured | | seconds |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for example in catalogue["examples"]:
        if options.only not in example["name"]:
            continue
        for run in example["runs"]:
            job, found, seconds = run_of(service, example, run, options.keep)
            rows, good = compare(example, run, found, options.update)
            entry = example["runs"][run]
            if options.update and "faults" in entry:
                entry["faults"] = found["faults"]
            right &= good and found["faults"] == entry.get("faults", [])
            for k, row in enumerate(rows):
                head = [example["name"], run] if k == 0 else ["", ""]
                print("| " + " | ".join(head + row + [f"{seconds:.2f}" if k == 0 else ""]) + " |", flush=True)
            for fault in found["faults"]:
                print(f"| | | {'fault' if fault in entry.get('faults', []) else 'FAULT'} | | | {fault} | | |")
            if job["statistics"].get("converged") is False:
                print("| | | not converged | | | | | |")
    if options.update:
        with open(EXAMPLES, "w", encoding="utf-8") as file:
            json.dump(catalogue, file, indent=1, ensure_ascii=False)
            file.write("\n")
    sys.exit(0 if right or options.update else 1)


if __name__ == "__main__":
    main()
