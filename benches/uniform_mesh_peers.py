"""Uniform meshes of a square beside Shewchuk's Triangle (PyPI `triangle`), in one run, processor time of one core.

    cargo test -p plateau-uniform-mesh --bench uniform_mesh --no-run     (prints the binary; `cargo build --release` for the other)
    python3 benches/uniform_mesh_peers.py BENCH_BINARY [NODES ...]
    python3 benches/uniform_mesh_peers.py target/release/plateau [NODES ...]

With the bench's binary ours is the process `--case OBJECTIVE NODES`: start, meshing, checking, statistics. With `plateau` it is
`plateau solve` from the request to the written GLB. Triangle's is the call alone: a square of the same edge length 1, quality 30
degrees, and the largest area that gives it about as many nodes. All are the least of three runs, ours and theirs in turn.
Prints one JSON line a case; `ratio` is ours over Triangle's per node.

    python3 benches/uniform_mesh_peers.py target/release/plateau --curved [PATCHES | FIRST..END]

meshes random wavy patches under both objectives and with MeshLab's isotropic remesher (PyPI `pymeshlab`, `numpy`), which starts
from a grid of 300 x 300 points on the patch and has the same edge length as its target. Lengths are in units of the edge length,
areas relative to the patch's own; seconds are processor time, for ours of the whole process, for MeshLab of the filter alone.
"""
import json
import math
import os
import resource
import subprocess
import sys
import tempfile
import time



def square(side):
    return [[0, 0], [side, 0], [side, side], [0, side]]


def peer(nodes):
    import triangle

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


def figures(points, triangles, edge_length):
    """Edge range and mean, smallest angle and area of a mesh."""
    import numpy as np

    a, b, c = (points[triangles[:, k]] for k in range(3))
    ends = np.unique(np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    lengths = np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1) / edge_length

    def angle(o, p, q):
        u, v = p - o, q - o
        return np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(1))

    smallest = min(angle(a, b, c).min(), angle(b, c, a).min(), angle(c, a, b).min())
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    return {"nodes": len(points), "shortest": round(lengths.min(), 2), "longest": round(lengths.max(), 2),
            "deviation": round(lengths.std(), 3), "equal": round(float((abs(lengths - 1) <= 1e-3).mean()), 3),
            "angle_deg": round(float(np.degrees(smallest)), 1)}, area


def random_patch(rng):
    """A NURBS request of one to four degrees, its control points half a wavelength apart and up to one wavelength high."""
    degrees = [int(d) for d in rng.integers(1, 5, 2)]
    counts = [d + 1 + int(rng.integers(0, 4)) for d in degrees]
    wavelength, kind = 20.0, int(rng.integers(0, 3))
    amplitude = wavelength * rng.uniform()

    def height(i, j):
        if kind == 1:
            return amplitude * rng.uniform(-1, 1)
        return amplitude if (i + j if kind == 0 else i) % 2 == 0 else -amplitude

    patch = {"degrees": degrees,
             "knots": [[0.0] * d + [float(k) for k in range(n - d + 1)] + [float(n - d)] * d for d, n in zip(degrees, counts)],
             "control_points": [[[10.0 * i, 10.0 * j, height(i, j)] for j in range(counts[1])] for i in range(counts[0])]}
    if rng.uniform() < 0.4:
        patch["weights"] = rng.uniform(0.5, 2.0, counts).tolist()
    return patch, wavelength * rng.uniform(0.04, 0.05)


def grid(patch, n):
    """The patch at n x n parameters."""
    import numpy as np

    def basis(knots, degree, count):
        t = np.linspace(knots[degree], knots[count], n)
        t[-1] = np.nextafter(t[-1], t[0])
        table = [((t >= knots[k]) & (t < knots[k + 1])).astype(float) for k in range(len(knots) - 1)]
        for d in range(1, degree + 1):
            def part(w, top, bottom):
                return w * top / bottom if bottom > 0 else 0 * t
            table = [part(table[k], t - knots[k], knots[k + d] - knots[k])
                     + part(table[k + 1], knots[k + d + 1] - t, knots[k + d + 1] - knots[k + 1])
                     for k in range(len(table) - 1)]
        return np.array(table)

    points = np.array(patch["control_points"])
    weights = np.array(patch.get("weights", np.ones(points.shape[:2])))
    u, v = (basis(patch["knots"][k], patch["degrees"][k], points.shape[k]) for k in range(2))
    total = np.einsum("ip,jq,ij->pq", u, v, weights)
    points = np.einsum("ip,jq,ijk->pqk", u, v, points * weights[..., None]) / total[..., None]
    k = np.arange(n * n).reshape(n, n)
    a, b, c, d = (x.ravel() for x in (k[:-1, :-1], k[1:, :-1], k[1:, 1:], k[:-1, 1:]))
    return points.reshape(-1, 3), np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def read_obj(path):
    import numpy as np

    points, triangles = [], []
    for line in open(path):
        words = line.split()
        if words and words[0] == "v":
            points.append([float(x) for x in words[1:4]])
        elif words and words[0] == "f":
            triangles.append([int(x.split("/")[0]) - 1 for x in words[1:4]])
    return np.array(points), np.array(triangles)


def curved(binary, numbers):
    import numpy as np
    import pymeshlab

    rng = np.random.default_rng(1)
    for number in range(numbers.stop):
        patch, edge_length = random_patch(rng)
        if number not in numbers:
            continue
        fine = grid(patch, 300)
        _, exact = figures(*fine, edge_length)
        with tempfile.TemporaryDirectory() as folder:
            for objective in ["fewest_nodes", "most_equal_edges"]:
                request, mesh = os.path.join(folder, "request.json"), os.path.join(folder, "mesh.obj")
                with open(request, "w") as file:
                    json.dump({"kind": "uniform_mesh", "domain": {"nurbs": patch}, "edge_length": edge_length,
                               "objective": objective}, file)
                before = resource.getrusage(resource.RUSAGE_CHILDREN)
                done = subprocess.run([binary, "solve", request, "-o", mesh], capture_output=True)
                after = resource.getrusage(resource.RUSAGE_CHILDREN)
                seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
                if done.returncode:
                    print(json.dumps({"patch": number, "who": objective, "refused": done.stderr.decode()[-200:]}), flush=True)
                    continue
                found, area = figures(*read_obj(mesh), edge_length)
                print(json.dumps({"patch": number, "who": objective, **found, "area_error": round(area / exact - 1, 4),
                                  "seconds": round(seconds, 2)}), flush=True)
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(*fine))
        start = time.process_time()
        meshes.meshing_isotropic_explicit_remeshing(targetlen=pymeshlab.PureValue(edge_length), iterations=10)
        seconds = time.process_time() - start
        result = meshes.current_mesh()
        found, area = figures(result.vertex_matrix(), result.face_matrix(), edge_length)
        print(json.dumps({"patch": number, "who": "meshlab", **found, "area_error": round(area / exact - 1, 4),
                          "seconds": round(seconds, 2)}), flush=True)


if "--curved" in sys.argv:
    asked = (sys.argv[sys.argv.index("--curved") + 1:] or ["20"])[0].split("..")
    curved(sys.argv[1], range(int(asked[0]), int(asked[1])) if len(asked) == 2 else range(int(asked[0])))
    sys.exit()

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
