"""Solves a request by a running service or by `plateau solve`."""

import json
import subprocess
import tempfile
import time
import urllib.error
import urllib.request
from pathlib import Path

PATHS = {"minimal_surface": "/v1/minimal-surfaces", "ruled_surface": "/v1/ruled-surfaces", "uniform_mesh": "/v1/uniform-meshes",
         "tensile_structure": "/v1/tensile-structures", "cable_net": "/v1/cable-nets"}
# Failures that are never the request's fault.
DEFECTS = {"audit-failed", "solver-panicked", "solver-crashed", "memory-limit", "internal", "invalid-mesh", "worker-lost",
           "unresponsive"}


class Outcome:
    """A result or a failure."""

    def __init__(self, seconds):
        self.seconds = seconds
        self.succeeded, self.error, self.detail, self.pointers, self.texts = False, None, "", [], ""
        self.statistics, self.mesh, self.warnings = {}, None, []

    def stated(self, pointer):
        value = self.statistics
        for key in pointer.split("/")[1:]:
            value = value.get(key) if isinstance(value, dict) else value[int(key)] if isinstance(value, list) else None
        return value

    def warns(self, *codes):
        return any(warning["code"] in codes for warning in self.warnings)

    def fail(self, problem):
        self.error = str(problem.get("type", "")).rsplit("/", 1)[-1]
        self.detail = problem.get("detail") or ""
        errors = problem.get("errors") or []
        self.pointers = [error.get("pointer", "") for error in errors]
        # The detail, and those of all errors.
        self.texts = " ".join([self.detail, *(error.get("detail", "") for error in errors)])
        return self


class Service:
    """A server under a base URL. A request that does not end in `patience` seconds is cancelled."""

    def __init__(self, url, patience=60):
        self.url, self.patience = url.rstrip("/"), patience

    def call(self, method, path, body=None, headers=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.url + path, data, method=method, headers={"Content-Type": "application/json", **(headers or {})})
        try:
            with urllib.request.urlopen(request, timeout=self.patience + 30) as answer:
                return answer.status, json.load(answer)
        except urllib.error.HTTPError as error:
            return error.code, json.load(error)

    def solve(self, request):
        started = time.monotonic()
        status, job = self.call("POST", PATHS[request["kind"]], request, {"Prefer": f"wait={self.patience}"})
        outcome = Outcome(time.monotonic() - started)
        if status >= 400:
            return outcome.fail(job)
        while job["status"] in ("queued", "running"):
            if time.monotonic() - started > self.patience:
                cancelled = time.monotonic()
                self.call("POST", f"/v1/jobs/{job['id']}/cancel")
                outcome.seconds = cancelled - started
                return outcome.fail({"type": "no-answer", "detail": f"no answer in {self.patience} s"})
            _, job = self.call("GET", f"/v1/jobs/{job['id']}", headers={"Prefer": "wait=5"})
        outcome.seconds = time.monotonic() - started
        if job["status"] != "succeeded":
            return outcome.fail(job.get("error") or {"type": job["status"]})
        outcome.succeeded, outcome.statistics, outcome.warnings = True, job["statistics"], job["warnings"]
        _, outcome.mesh = self.call("GET", job["links"]["mesh"] + "?format=json")
        return outcome


    def cancelled(self, request, delay):
        """Submits a request and cancels it after `delay` seconds. Returns the seconds until the job has ended."""
        status, job = self.call("POST", PATHS[request["kind"]], request)
        if status >= 400:
            return 0.0
        time.sleep(delay)
        started = time.monotonic()
        self.call("POST", f"/v1/jobs/{job['id']}/cancel")
        while job["status"] in ("queued", "running") and time.monotonic() - started < self.patience:
            _, job = self.call("GET", f"/v1/jobs/{job['id']}", headers={"Prefer": "wait=1"})
        return time.monotonic() - started


class Program:
    """`plateau solve`."""

    def __init__(self, path, patience=60):
        self.path, self.patience = path, patience

    def cancelled(self, request, delay):
        """A program has no jobs, and is ended by a signal."""
        return 0.0

    def solve(self, request):
        with tempfile.TemporaryDirectory() as folder:
            source, target = Path(folder, "request.json"), Path(folder, "mesh.json")
            source.write_text(json.dumps(request))
            started = time.monotonic()
            try:
                run = subprocess.run([self.path, "solve", str(source), "-o", str(target)], capture_output=True, text=True, timeout=self.patience)
            except subprocess.TimeoutExpired:
                return Outcome(self.patience).fail({"type": "no-answer", "detail": f"no answer in {self.patience} s"})
            outcome = Outcome(time.monotonic() - started)
            if run.returncode != 0:
                # A request that is refused before it is solved has no type.
                kinds = [line.removeprefix("type: ") for line in run.stderr.splitlines() if line.startswith("type: ")]
                kind = "solver-panicked" if "panicked" in run.stderr else (kinds or ["invalid-request"])[-1]
                pointers = [line.split(":")[0].strip() for line in run.stderr.splitlines() if line.startswith("  /")]
                return outcome.fail({"type": kind, "detail": run.stderr.strip(), "errors": [{"pointer": p} for p in pointers]})
            outcome.succeeded, outcome.statistics = True, json.loads(run.stdout)
            outcome.mesh = json.loads(target.read_text())
            lines = [line.split(": ", 2) for line in run.stderr.splitlines() if line.startswith("warning: ")]
            outcome.warnings = [{"code": line[1], "detail": line[-1]} for line in lines]
            return outcome
