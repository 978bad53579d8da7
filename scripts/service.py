"""Asks the server that PLATEAU_URL names."""

import json
import os
import urllib.request

PATHS = {
    "minimal_surface": "minimal-surfaces",
    "ruled_surface": "ruled-surfaces",
    "uniform_mesh": "uniform-meshes",
    "tensile_structure": "tensile-structures",
    "cable_net": "cable-nets",
}


def request(path, body=None, headers=None):
    data = None if body is None else json.dumps(body).encode()
    sent = urllib.request.Request(
        os.environ["PLATEAU_URL"] + path, data, {"Content-Type": "application/json", **(headers or {})}
    )
    with urllib.request.urlopen(sent) as answer:
        return answer.read()


def solve(kind, body):
    job = json.loads(request(f"/v1/{PATHS[kind]}", body, {"Prefer": "wait=60"}))
    while job["status"] in ("queued", "running"):
        job = json.loads(request(job["links"]["self"], headers={"Prefer": "wait=60"}))
    assert job["status"] == "succeeded", job["error"]
    return job


def examples():
    """Returns name, kind and request of every example."""
    listed = json.loads(request("/v1/examples"))["examples"]
    read = [(one["name"], json.loads(request(f"/v1/examples/{one['name']}"))) for one in listed]
    return [(name, example["kind"], example["request"]) for name, example in read]
