"""Measures how long solvers go on after their job is cancelled, at the largest size of every kind.

    python3 scripts/measure_cancels.py target/release/plateau [--only EXPRESSION] [--moments 10] [--longest 40]

Every job runs on a thread of the service, which nothing kills. Each is submitted several times and cancelled at moments
that are spread over its time, at most the longest. The time ends when the service counts no running job. All times are
processor time of the service, so that other work on the machine does not count. The exit status is 1 if one is above
MOST_S. A factorisation of a large sparse matrix does not look at its signal and may take longer.
"""

import argparse
import http.client
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
import time

from measure_memory import cushion, dome, grid, jagged_rails, net, rails, sail, zigzag
from families import film, lattice, ring, spiky, square, star, strip, wavy

MOST_S = 0.5
TICKS_PER_S = os.sysconf("SC_CLK_TCK")
PATHS = {"minimal_surface": "minimal-surfaces", "tensile_structure": "tensile-structures", "cable_net": "cable-nets",
         "ruled_surface": "ruled-surfaces", "uniform_mesh": "uniform-meshes"}
# Every job on a thread that is never given up, and no limit that is below what the largest requests need.
ENVIRONMENT = {"PLATEAU_JOBS__THREAD_BYTES": str(1 << 50), "PLATEAU_JOBS__MEMORY_BYTES": str(1 << 40),
               "PLATEAU_LIMITS__MEMORY_BYTES": str(1 << 40), "PLATEAU_WORKERS": "1", "PLATEAU_LOG__LEVEL": "error",
               "PLATEAU_JOBS__UNRESPONSIVE_MS": str(1 << 40)}


def cases():
    """Yields a name and a request near the default limits of its kind."""
    size = 2_000_000
    for solver in ("newton", "vertex_relaxation", "pinkall_polthier"):
        yield f"film, {solver}", {**film([square(12, 1.0, 0.4)], size), "solver": solver}
    yield "film, Dirichlet energy", {**film([square(12, 1.0, 0.4)], size), "objective": "minimal_dirichlet_energy"}
    yield "film, mean curvature", {**film([square(8, 1.0, 0.4)], size // 4), "objective": "minimal_mean_curvature"}
    three = [ring(24), ring(24, 1.0, 0.5), ring(24, 0.8, 1.0)]
    yield "film, best topology", {**film(three, size // 4), "topology": "best"}
    yield "film, free topology", {**film([ring(48), ring(48, 1.0, 0.6)], size // 4), "topology": "free"}
    yield "film of a spiky loop", film([spiky(random.Random(3), 60)], size)
    yield "film of 200,000 points", film([ring(100_000), ring(100_000, 1.0, 0.5)], size)
    yield "film, certified", {**film([square(4, 1.0, 0.5)], 500), "certify": {"gap": 0.0, "seconds": 600.0}}
    yield "sail with cables", sail(size)
    yield "woven sail", sail(size // 4, woven=True)
    yield "cushion", cushion(size // 4)
    yield "net with force densities", net(grid(300), force_density=1.0)
    yield "net with forces", {**net(grid(300), force=1.0), "least_force_density": 1e-6}
    yield "net in space", {**net(grid(40, 40), force=1.0), "least_force_density": 1e-6}
    for objective in ("minimal_area", "minimal_bending_energy", "minimal_twist", "maximal_convexity"):
        yield f"strip, {objective}", strip(rails(44_000), objective=objective)
    yield "strip of jagged rails", strip(jagged_rails(44_000))
    yield "strip, all objectives", strip(rails(20_000), all_objectives=True)
    yield "closed strip", strip(rails(44_000, True), closed=True)
    yield "closed strip, bending", strip(rails(8_000, True), closed=True, objective="minimal_bending_energy")
    side = math.sqrt(100 / (900_000 * 0.866))
    floor = {"polygon": [[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]]}
    star_floor = {"polygon": [[9 * x, 9 * y, 0] for x, y, _ in star(random.Random(4), 30)]}
    for objective in ("fewest_nodes", "most_equal_edges"):
        yield f"floor, {objective}", lattice(floor, side, objective=objective)
        yield f"star floor, {objective}", lattice(star_floor, 1.5 * side, objective=objective)
        yield f"zigzag floor, {objective}", lattice({"polygon": zigzag(190_000)}, 4.0, objective=objective)
        yield f"dome, {objective}", dome(math.sqrt(900 / (200_000 * 0.866)), objective=objective)
        yield f"high dome, {objective}", dome(math.sqrt(900 / (60_000 * 0.866)), 60.0, objective=objective)
    loop = [[15 * x, 15 * y, 15 * z] for x, y, z in wavy(random.Random(2), 40)]
    yield "lattice on a film", lattice({"boundaries": [loop]}, math.sqrt(700 / (100_000 * 0.866)))
    shared = {"optimise": "lengths", "max_distinct_lengths": 8}
    yield "dome, shared lengths", dome(math.sqrt(900 / (20_000 * 0.866)), **shared)


class Server:
    def __init__(self, program, folder):
        command = [program, "--listen", "127.0.0.1:0", "--data", folder]
        self.process = subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.PIPE, text=True)
        self.port = int(self.process.stdout.readline().rsplit(":", 1)[1])

    def ask(self, method, path, body=None):
        client = http.client.HTTPConnection("127.0.0.1", self.port, timeout=120)
        client.request(method, path, body, {"content-type": "application/json"})
        answer = client.getresponse()
        content = answer.read()
        client.close()
        return answer.status, content

    def processor_s(self):
        """Returns the processor time that the service has taken."""
        with open(f"/proc/{self.process.pid}/stat") as stat:
            fields = stat.read().rsplit(") ", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / TICKS_PER_S

    def runs(self):
        """Returns whether a job runs."""
        text = self.ask("GET", "/metrics")[1].decode()
        return float(re.search(r"^plateau_jobs_running (\S+)", text, re.MULTILINE).group(1)) > 0

    def submit(self, request):
        body = json.dumps({**request, "cache": "bypass"})
        status, content = self.ask("POST", f"/v1/{PATHS[request['kind']]}", body)
        job = json.loads(content)
        if status != 202:
            raise SystemExit(f"{status}: {content[:500]}")
        while not self.runs():
            if json.loads(self.ask("GET", job["links"]["self"])[1])["status"] not in ("queued", "running"):
                break
            time.sleep(0.002)
        return job

    def cancel(self, request, moment):
        """Cancels a job at this time after its start. Returns the time for which the solver goes on, the time at which
        the job was cancelled, and whether it had ended before."""
        began = self.processor_s()
        job = self.submit(request)
        while self.processor_s() - began < moment and self.runs():
            time.sleep(0.01)
        cancelled = self.processor_s()
        status = json.loads(self.ask("POST", job["links"]["cancel"])[1])["status"]
        while self.runs():
            time.sleep(0.002)
        return self.processor_s() - cancelled, cancelled - began, status != "cancelled"


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("program")
    arguments.add_argument("--only", default="", help="measure the cases whose names match this expression")
    arguments.add_argument("--moments", type=int, default=10)
    arguments.add_argument("--longest", type=float, default=40.0)
    arguments = arguments.parse_args()
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        server = Server(os.path.abspath(arguments.program), folder)
        try:
            print("| request | time, s | longest end after a cancel, s | at, s |", flush=True)
            print("| --- | --- | --- | --- |", flush=True)
            for name, request in cases():
                if not re.search(arguments.only, name):
                    continue
                # The first cancel tells how long the job takes.
                ends = [server.cancel(request, arguments.longest)]
                whole = ends[0][1]
                moments = [whole * (k + 0.5) / arguments.moments for k in range(arguments.moments)]
                ends += [server.cancel(request, moment) for moment in moments]
                longest, at, _ = max((end for end in ends if not end[2]), default=(0.0, 0.0, False))
                wrong += longest > MOST_S
                more = "" if ends[0][2] else " or more"
                mark = " <--" if longest > MOST_S else ""
                print(f"| {name} | {whole:.1f}{more} | {longest:.2f} | {at:.1f} |{mark}", flush=True)
        finally:
            server.process.kill()
            server.process.wait()
    print(f"\n{wrong} above {MOST_S} s")
    sys.exit(1 if wrong else 0)


main()
