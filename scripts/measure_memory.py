"""Measures the memory that jobs take, and compares it with the estimates.

    python3 scripts/measure_memory.py target/release/plateau [--only EXPRESSION]

Each request is solved in the process that the service starts for a large job, so that the measured program, its
allocator and its settings are those of the service. The estimate comes from the same process. A ratio is the estimate
over the peak of the resident memory less that of the smallest job. Ratios count for jobs that take more than 8 MiB. The
exit status is 1 if one is below 0.95 or above 2. The smallest job is solved anew before each request, because the pages
of the program count, and their number changes by some megabytes with what the system has cached.
"""

import argparse
import json
import math
import os
import random
import re
import statistics
import struct
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "campaign"))
from families import film, lattice, ring, spiky, square, star, strip, wavy  # noqa: E402

LEAST, MOST, LARGE_BYTES = 0.95, 2.0, 8 << 20
# The environment of a child process, the same as `ENVIRONMENT` in `src/jobs/children.rs`.
ENVIRONMENT = {"MIMALLOC_ARENA_RESERVE": "64M", "MALLOC_ARENA_MAX": "1"}


def solve(program, request, source=None):
    """Returns the peak in bytes, the estimate in bytes, how the job ended, and the archive."""
    body = dict(request)
    kind = body.pop("kind")
    text = json.dumps(body).encode()
    limits = {"body_bytes": 1 << 40, "points": 1 << 40, "triangles": 1 << 40, "grid_cells": 1 << 60,
              "iterations": 1 << 30, "memory_bytes": 1 << 50, "batch_requests": 1}
    span = lambda seconds: {"secs": seconds, "nanos": 0}
    assignment = {"id": "measured", "kind": kind, "limits": limits, "memory_bytes": 0, "deadline": span(1200),
                  "progress_interval": span(3600), "request_bytes": len(text),
                  "source": {"Ok": [list(source[0].encode()), len(source[1])]} if source else {"Err": "none"}}
    framed = json.dumps(assignment).encode()
    with tempfile.NamedTemporaryFile() as measured, tempfile.TemporaryFile() as errors:
        # The peak of a process begins with that of the process that started it, and GNU time is small.
        command = ["/usr/bin/time", "-f", "%M", "-o", measured.name, program, "solver"]
        child = subprocess.Popen(command, env=ENVIRONMENT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=errors)
        child.stdin.write(struct.pack("<I", len(framed)) + framed + text + (source[1] if source else b""))
        child.stdin.flush()
        answer = child.stdout.read()
        child.stdin.close()
        status = child.wait()
        peak = int(measured.read().split()[-1]) * 1024
        errors.seek(0)
        said = errors.read().decode(errors="replace")
    at, estimate, end, archive = 0, 0, f"status {status}: {said[-200:]}", b""
    while at + 4 <= len(answer):
        length = struct.unpack_from("<I", answer, at)[0]
        message = json.loads(answer[at + 4:at + 4 + length])
        at += 4 + length
        if "Estimate" in message:
            estimate = message["Estimate"]
        if "Ended" in message:
            outcome = message["Ended"]["end"]
            end = next(iter(outcome)) if isinstance(outcome, dict) else outcome
            if end != "Solved":
                end = json.dumps(outcome)[:300]
            archive = answer[at:]
            break
    return peak, estimate, end, archive


def grid(n, layers=1, lift=2.0):
    """A net of squares with n cells a side, held at its sides."""
    side = n + 1
    number = lambda i, j, k: (k * side + j) * side + i
    steps = [(i, j, k) for k in range(layers) for j in range(side) for i in range(side)]
    vertices = [[float(i), float(j), k + lift * math.sin(3 * i / n) * math.cos(2 * j / n)] for i, j, k in steps]
    edges = [[number(i, j, k), number(i + a, j + b, k + c)] for i, j, k in steps
             for a, b, c in ((1, 0, 0), (0, 1, 0), (0, 0, 1)) if i + a < side and j + b < side and k + c < layers]
    supports = [number(i, j, k) for i, j, k in steps if i in (0, n) or j in (0, n)]
    return {"kind": "cable_net", "vertices": vertices, "edges": edges, "supports": supports}


def net(request, **targets):
    return {**request, "cables": [{"name": "all", "edges": list(range(len(request["edges"]))), **targets}]}


def sail(triangles, woven=False, **more):
    corners = [[0, 0, 0], [10, 0, 3], [10, 10, 0], [0, 10, 3]]
    cables = [{"name": f"edge {k}", "along": {"from": k, "to": (k + 1) % 4}, "mode": "force", "value": 14.0} for k in range(4)]
    prestress = {"warp": 1.0, "weft": 1.3, "direction": {"parallel": [1, 0, 0]}} if woven else {"tension": 1.0}
    return {"kind": "tensile_structure", "boundaries": [corners], "film": prestress, "cables": cables,
            "resolution": {"triangles": triangles}, **more}


def cushion(triangles):
    return {"kind": "tensile_structure", "boundaries": [ring(48, 5.0)], "layers": [{"tension": 1.0}, {"tension": 1.0}],
            "chambers": [{"pressure": 0.1}], "resolution": {"triangles": triangles}}


def dome(edge_length, height=6.0, **options):
    control = [[[10 * i, 8 * j, height if i in (1, 2) and j in (1, 2) else 0.0] for j in range(4)] for i in range(4)]
    return lattice({"bezier": {"control_points": control}}, edge_length, **options)


def zigzag(points, width=40.0):
    """A polygon whose long sides are zigzags along a diagonal."""
    half = points // 2
    there = [[k + (k % 2) * 0.5, k - (k % 2) * 0.5, 0.0] for k in range(half)]
    back = [[x - width, y + width, 0.0] for x, y, _ in reversed(there)]
    return there + back


def rails(count, closed=False):
    def points(y):
        turn = lambda k: 2 * math.pi * k / count
        if closed:
            return [[(3 + 0.3 * y * math.sin(5 * turn(k))) * math.cos(turn(k)), (3 + 0.2 * math.sin(3 * turn(k))) * math.sin(turn(k)),
                     y + 0.2 * math.cos(2 * turn(k))] for k in range(count)]
        return [[9 * k / count, y + 0.2 * math.sin(3 * turn(k) + y), 0.4 * math.cos(2 * turn(k) + 2 * y)] for k in range(count)]
    return [points(0.0), points(1.0)]


def jagged_rails(count):
    rng = random.Random(5)
    return [[[9 * k / count, y + 0.2 * rng.random(), 0.4 * rng.random()] for k in range(count)] for y in (0, 1)]


def cases():
    """Yields a name and a request, each shape in three sizes."""
    rng = random.Random(1)
    for size in (10_000, 40_000, 120_000):
        yield f"film, {size} triangles", film([square(12, 1.0, 0.4)], size)
        yield f"film of two rings, {size}", film([ring(48), ring(48, 1.0, 0.6)], size)
        yield f"film, best topology, {size}", {**film([ring(24), ring(24, 1.0, 0.5), ring(24, 0.8, 1.0)], size), "topology": "best"}
        yield f"film, vertex relaxation, {size}", {**film([square(12, 1.0, 0.4)], size), "solver": "vertex_relaxation", "max_iterations": 20}
        yield f"film, Pinkall and Polthier, {size}", {**film([square(12, 1.0, 0.4)], size), "solver": "pinkall_polthier", "max_iterations": 20}
        yield f"film, Dirichlet energy, {size}", {**film([square(12, 1.0, 0.4)], size), "objective": "minimal_dirichlet_energy"}
        yield f"film, free topology, {size}", {**film([ring(48), ring(48, 1.0, 0.6)], size), "topology": "free", "max_iterations": 20}
        yield f"film of a spiky loop, {size}", film([spiky(random.Random(3), 60)], size)
        yield f"film with edge length, {size}", {**film([ring(60)], 0), "resolution": {"edge_length": math.sqrt(math.pi / (size * 0.433))}}
    for size in (2_000, 8_000, 20_000):
        yield f"film, mean curvature, {size}", {**film([square(8, 1.0, 0.4)], size), "objective": "minimal_mean_curvature", "max_iterations": 5}
    for size in (4_000, 20_000, 60_000):
        yield f"sail with cables, {size}", sail(size)
        yield f"woven sail, {size}", sail(size, woven=True)
        yield f"cushion of two layers, {size // 2}", cushion(size // 2)
        inflated = {"kind": "tensile_structure", "boundaries": [ring(40, 5.0)], "film": {"tension": 1.0}, "pressure": 0.1}
        yield f"inflated ring, {size}", {**inflated, "resolution": {"triangles": size}}
    for size in (40, 80, 150):
        yield f"net with force densities, {size}", net(grid(size), force_density=1.0)
        yield f"net with forces, {size}", {**net(grid(size), force=1.0), "max_iterations": 4, "least_force_density": 1e-6}
    for size in (8, 12, 18):
        yield f"net in space, {size}", {**net(grid(size, size), force=1.0), "max_iterations": 4, "least_force_density": 1e-6}
        yield f"net in space with force densities, {2 * size}", net(grid(2 * size, 2 * size), force_density=1.0)
    for size in (3_000, 10_000, 30_000):
        yield f"strip of least area, {size}", strip(rails(size))
        yield f"strip of jagged rails, {size}", strip(jagged_rails(size))
    for size in (3_000, 8_000, 16_000):
        yield f"strip, bending, {size}", strip(rails(size), objective="minimal_bending_energy")
        yield f"strip, twist, {size}", strip(rails(size), objective="minimal_twist")
        yield f"strip, convexity, {size}", strip(rails(size), objective="maximal_convexity")
        yield f"closed strip, {size}", strip(rails(size, True), closed=True)
        if size < 16_000:
            yield f"strip whose rails move, {size}", strip(rails(size), objective="minimal_bending_energy", rail_tolerance=1e-5)
    for size in (1_000, 2_000, 4_000):
        yield f"closed strip, bending, {size}", strip(rails(size, True), closed=True, objective="minimal_bending_energy")
        yield f"strip, all objectives, {size}", strip(rails(size), all_objectives=True)
    for nodes in (5_000, 30_000, 120_000):
        length = math.sqrt(100 / (nodes * 0.866))
        floor = {"polygon": [[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]]}
        yield f"floor, fewest nodes, {nodes} nodes", lattice(floor, length, objective="fewest_nodes")
        yield f"floor, equal edges, {nodes} nodes", lattice(floor, length, objective="most_equal_edges")
        yield f"star floor, {nodes} nodes", lattice({"polygon": [[9 * x, 9 * y, 0] for x, y, _ in star(random.Random(4), 30)]}, length, objective="fewest_nodes")
    for points in (5_000, 20_000, 60_000):
        yield f"zigzag floor, {points} points", lattice({"polygon": zigzag(points)}, 1.2, objective="most_equal_edges")
        yield f"thin zigzag floor, {points} points", lattice({"polygon": zigzag(points, 0.5)}, 0.28, objective="fewest_nodes")
        yield f"coarse zigzag floor, {points} points", lattice({"polygon": zigzag(points)}, 12.0, objective="fewest_nodes")
    for nodes in (1_500, 6_000, 20_000):
        length = math.sqrt(900 / (nodes * 0.866))
        yield f"dome, fewest nodes, {nodes} nodes", dome(length, objective="fewest_nodes")
        yield f"dome, equal edges, {nodes} nodes", dome(length, objective="most_equal_edges")
        if nodes < 20_000:
            yield f"high dome, fewest nodes, {nodes} nodes", dome(length, 60.0, objective="fewest_nodes")
            yield f"high dome, equal edges, {nodes} nodes", dome(length, 60.0, objective="most_equal_edges")
        yield f"lattice on a film, {nodes} nodes", lattice({"boundaries": [[[15 * x, 15 * y, 15 * z] for x, y, z in wavy(random.Random(2), 40)]]}, math.sqrt(700 / (nodes * 0.866)))
    for seconds in (1, 3, 10):
        yield f"film, certified for {seconds} s", {**film([square(4, 1.0, 0.5)], 500), "certify": {"gap": 0.0, "seconds": float(seconds)}}


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("program")
    arguments.add_argument("--only", default="", help="measure the cases whose names match this expression")
    arguments = arguments.parse_args()
    program = os.path.abspath(arguments.program)
    smallest = film([square(2, 1.0, 0.3)], 50)
    print("| request | peak above the base | estimate | ratio |\n| --- | --- | --- | --- |", flush=True)
    wrong = 0
    for name, request in cases():
        if not re.search(arguments.only, name):
            continue
        began = time.monotonic()
        base = statistics.median(solve(program, smallest)[0] for _ in range(3))
        peak, estimate, end, _ = solve(program, request)
        taken = max(peak - base, 1)
        ratio = estimate / taken
        counts = taken > LARGE_BYTES
        bad = counts and not LEAST <= ratio <= MOST or end != "Solved"
        wrong += bad
        note = "" if end == "Solved" else f" {end}"
        print(f"| {name} | {taken / 1e6:.1f} MB | {estimate / 1e6:.1f} MB | {ratio:.2f} |"
              f"{' <--' if bad else ''}{note}  ({time.monotonic() - began:.0f} s)", flush=True)
    print(f"\n{wrong} outside of {LEAST} to {MOST}")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
