"""Uniform meshes of a square beside Shewchuk's Triangle (PyPI `triangle`), in one run, processor time of one core.

    cargo test -p plateau-geometry --bench uniform_mesh --no-run     (prints the binary; `cargo build --release` for the other)
    python3 benches/uniform_mesh_peers.py BENCH_BINARY [NODES ...]
    python3 benches/uniform_mesh_peers.py target/release/plateau [NODES ...]

With the bench's binary ours is the process `--case OBJECTIVE NODES`: start, meshing, checking, statistics. With `plateau` it is
`plateau solve` from the request to the written GLB. Triangle's is the call alone: a square of the same edge length 1, quality 30
degrees, and the largest area that gives it about as many nodes. All are the least of three runs, ours and theirs in turn.
Prints one JSON line a case; `ratio` is ours over Triangle's per node.
"""
import json
import math
import os
import resource
import subprocess
import sys
import tempfile
import time

import triangle


def square(side):
    return [[0, 0], [side, 0], [side, side], [0, side]]


def peer(nodes):
    mesh = {"vertices": square(math.sqrt(nodes / 0.68)), "segments": [[0, 1], [1, 2], [2, 3], [3, 0]]}
    start = time.process_time()
    made = len(triangle.triangulate(mesh, "pq30a1.160")["vertices"])
    return time.process_time() - start, made


def ours(binary, objective, density, nodes, folder):
    if not os.path.basename(binary).startswith("uniform_mesh"):
        request, mesh = os.path.join(folder, "request.json"), os.path.join(folder, "mesh.glb")
        polygon = [[x, y, 0] for x, y in square(math.sqrt(nodes / density))]
        with open(request, "w") as file:
            json.dump({"kind": "uniform_mesh", "domain": {"polygon": polygon}, "edge_length": 1, "objective": objective}, file)
        command = [binary, "solve", request, "-o", mesh]
    else:
        command = [binary, "--case", objective, str(nodes)]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   env={**os.environ, "PLATEAU_LIMITS__TRIANGLES": "4000000"})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


with tempfile.TemporaryDirectory() as folder:
    for nodes in [int(n) for n in sys.argv[2:]] or [1000, 10000, 100000, 1000000]:
        theirs, made = min(peer(nodes) for _ in range(3))
        for objective, density in [("fewest_nodes", 0.68), ("most_equal_edges", 1.155)]:
            seconds = math.inf
            for _ in range(3):
                seconds = min(seconds, ours(sys.argv[1], objective, density, nodes, folder))
                theirs = min(theirs, peer(nodes)[0])
            print(json.dumps({"bench": f"uniform_mesh/{objective}", "nodes": nodes, "seconds": round(seconds, 4),
                              "baseline": "triangle pq30", "baseline_nodes": made, "baseline_seconds": round(theirs, 4),
                              "ratio": round(seconds / nodes / (theirs / made), 2)}), flush=True)
