"""Uniform meshes of a square beside Shewchuk's Triangle (PyPI `triangle`), in one run, processor time of one core.

    python3 benches/uniform_mesh_peers.py target/release/plateau [NODES ...]

Ours is `plateau solve` from the request to the written GLB: reading, meshing, checking, statistics, export. Triangle's is the
call alone: the same square, quality 30 degrees, and a largest area that gives it about as many nodes. Both are the least of
three runs. Prints one JSON line a case; `ratio` is ours over Triangle's per node.
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
    best = math.inf
    for _ in range(3):
        start = time.process_time()
        made = len(triangle.triangulate(mesh, "pq30a1.160")["vertices"])
        best = min(best, time.process_time() - start)
    return best, made


def ours(binary, objective, density, nodes, folder):
    request, mesh = os.path.join(folder, "request.json"), os.path.join(folder, "mesh.glb")
    polygon = [[x, y, 0] for x, y in square(math.sqrt(nodes / density))]
    with open(request, "w") as file:
        json.dump({"kind": "uniform_mesh", "domain": {"polygon": polygon}, "edge_length": 1, "objective": objective}, file)
    best = math.inf
    for _ in range(3):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([binary, "solve", request, "-o", mesh], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL, env={**os.environ, "PLATEAU_LIMITS__TRIANGLES": "4000000"})
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        best = min(best, after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)
    return best


with tempfile.TemporaryDirectory() as folder:
    for nodes in [int(n) for n in sys.argv[2:]] or [1000, 10000, 100000]:
        theirs, made = peer(nodes)
        for objective, density in [("fewest_nodes", 0.68), ("most_equal_edges", 1.155)]:
            seconds = ours(sys.argv[1], objective, density, nodes, folder)
            print(json.dumps({"bench": f"uniform_mesh/{objective}", "nodes": nodes, "seconds": round(seconds, 4),
                              "baseline": "triangle pq30", "baseline_nodes": made, "baseline_seconds": round(theirs, 4),
                              "ratio": round(seconds / nodes / (theirs / made), 2)}), flush=True)
