#!/usr/bin/env python3
"""Minimal surfaces beside what people use today, in one run on one core.

Ours: from the raw boundary to the finished statistics with stability, residual <= 1e-8
(`cargo bench -p plateau-minimal-surface --bench minimal_surface -- --case ...`, built by this script).
Peers, each from a structured mesh of the same size that is handed to them (not timed):
  igl_cholmod   Pinkall and Polthier's iteration with libigl's cotangent matrix and CHOLMOD (scikit-sparse), symbolic
                factorisation reused, until the residual max|H|R is below --tolerance (1e-3). No stability.
  evolver       Surface Evolver (Debian's evolver-nox): gradient steps, then `hessian_seek`, to the same residual.
A peer that is not installed is left out, and said to be. Times are processor seconds of the solve alone.
One JSON line a measurement; with --record FILE they are appended, with date, commit and our ratio to igl_cholmod.

Set-up of the peers:  python3 -m venv V && V/bin/pip install numpy scipy libigl 'scikit-sparse<0.5'   (libsuitesparse-dev)
Run:                  V/bin/python benches/minimal_surface_peers.py --sizes 2000,20000,200000
"""
import argparse
import datetime
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[variable] = "1"
try:
    import numpy as np
except ImportError:
    np = None


# ---- the problems, as structured meshes


def grid(nu, nv):
    i, j = np.meshgrid(np.arange(nu), np.arange(nv), indexing="ij")
    a = (i * (nv + 1) + j).ravel()
    b, c, d = a + nv + 1, a + nv + 2, a + 1
    alternate = ((i + j) % 2 == 0).ravel()[:, None]
    first = np.where(alternate, np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    second = np.where(alternate, np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    return np.concatenate([first, second])


def helicoid(size):
    nv = max(4, round((size / 2 * 5) ** 0.5))
    nu = max(2, round(size / 2 / nv))
    u, v = np.meshgrid(np.linspace(2, 10, nu + 1), np.linspace(-1, 10, nv + 1), indexing="ij")
    vertices = np.stack([u * np.cos(v), u * np.sin(v), v], -1).reshape(-1, 3)
    rim = np.zeros((nu + 1, nv + 1), bool)
    rim[[0, -1], :] = rim[:, [0, -1]] = True
    return harmonic(vertices, grid(nu, nv), rim.ravel()), grid(nu, nv), rim.ravel()


def rings(size):
    strips = max(2, round((size / 2 / (2 * np.pi)) ** 0.5))
    n = round(size / 2 / strips)
    t = 2 * np.pi * np.arange(n) / n
    circle = np.stack([np.cos(t), np.sin(t), np.zeros(n)], 1)
    heights = np.linspace(-0.5, 0.5, strips + 1)
    vertices = np.concatenate([circle + [0, 0, z] for z in heights])
    i, j = np.meshgrid(np.arange(strips), np.arange(n), indexing="ij")
    p, q = (i * n + j).ravel(), (i * n + (j + 1) % n).ravel()
    alternate = ((i + j) % 2 == 0).ravel()[:, None]
    first = np.where(alternate, np.stack([p, q, q + n], 1), np.stack([p, q, p + n], 1))
    second = np.where(alternate, np.stack([p, q + n, p + n], 1), np.stack([q, q + n, p + n], 1))
    rim = np.zeros(len(vertices), bool)
    rim[:n] = rim[-n:] = True
    return vertices, np.concatenate([first, second]), rim


def harmonic(vertices, faces, rim):
    """The free vertices moved to where every one is the mean of its neighbours."""
    import scipy.sparse as sp
    import scipy.sparse.linalg as spl

    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    edges = np.unique(np.sort(ends, 1), axis=0)
    n = len(vertices)
    w = sp.coo_matrix((np.ones(len(edges)), (edges[:, 0], edges[:, 1])), (n, n))
    w = (w + w.T).tocsr()
    laplacian = (sp.diags(np.asarray(w.sum(1)).ravel()) - w).tocsr()
    free = np.flatnonzero(~rim)
    fixed = np.flatnonzero(rim)
    result = vertices.copy()
    rows = laplacian[free]
    options = dict(permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=dict(SymmetricMode=True))
    result[free] = spl.splu(rows[:, free].tocsc(), **options).solve(-(rows[:, fixed] @ vertices[fixed]))
    return result


def residual(vertices, faces, rim):
    """max |area gradient| / (2/3 ring area), times the largest distance of a rim vertex from their mean."""
    a, b, c = vertices[faces[:, 0]], vertices[faces[:, 1]], vertices[faces[:, 2]]
    m = np.cross(b - a, c - a)
    double = np.linalg.norm(m, axis=1)
    normal = m / double[:, None]
    gradient = np.zeros_like(vertices)
    ring = np.zeros(len(vertices))
    for k, edge in enumerate((c - b, a - c, b - a)):
        pull = 0.5 * np.cross(normal, edge)
        for axis in range(3):
            gradient[:, axis] += np.bincount(faces[:, k], pull[:, axis], len(vertices))
        ring += np.bincount(faces[:, k], 0.5 * double, len(vertices))
    points = vertices[rim]
    radius = np.linalg.norm(points - points.mean(0), axis=1).max()
    curvature = np.linalg.norm(gradient, axis=1) / (2 * ring / 3)
    return float(curvature[~rim].max() * radius), float(0.5 * double.sum())


# ---- peers


def igl_cholmod(problem, size, tolerance, limit):
    import igl
    import scipy.sparse as sp
    from sksparse import cholmod

    vertices, faces, rim = problem(size)
    faces = np.ascontiguousarray(faces, dtype=np.int64)
    free, fixed = np.flatnonzero(~rim), np.flatnonzero(rim)
    spent, solves, factor = 0.0, 0, None
    reached, area = residual(vertices, faces, rim)
    while reached > tolerance and solves < 300 and spent < limit:
        start = time.process_time()
        laplacian = (-igl.cotmatrix(np.ascontiguousarray(vertices), faces)).tocsr()
        rows = laplacian[free]
        matrix = sp.csc_matrix(rows[:, free])
        if factor is None:
            factor = cholmod.analyze(matrix)
        factor.cholesky_inplace(matrix)
        moved = vertices.copy()
        moved[free] = factor(-(rows[:, fixed] @ vertices[fixed]))
        spent += time.process_time() - start
        vertices, solves = moved, solves + 1
        reached, area = residual(vertices, faces, rim)
    return dict(triangles=len(faces), seconds=spent, iterations=solves, area=area, residual_full=reached)


def evolver(problem, size, tolerance, limit):
    binary = shutil.which("evolver-nox-d") or shutil.which("evolver-nox") or shutil.which("evolver")
    if binary is None:
        raise ImportError("evolver-nox")
    vertices, faces, rim = problem(size)
    ends = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    low = np.sort(ends, 1)
    edges, inverse = np.unique(low, axis=0, return_inverse=True)
    signed = np.where(ends[:, 0] == low[:, 0], inverse.ravel() + 1, -(inverse.ravel() + 1))
    m = len(faces)
    on_rim = np.bincount(inverse.ravel(), minlength=len(edges)) == 1
    lines = ["vertices"]
    lines += [f"{k + 1} {x:.17g} {y:.17g} {z:.17g}{' fixed' if rim[k] else ''}" for k, (x, y, z) in enumerate(vertices)]
    lines += ["edges"]
    lines += [f"{k + 1} {a + 1} {b + 1}{' fixed' if on_rim[k] else ''}" for k, (a, b) in enumerate(edges)]
    lines += ["faces"] + [f"{t + 1} {signed[t]} {signed[m + t]} {signed[2 * m + t]}" for t in range(m)]
    # A few steps of gradient descent, then second derivatives in normal directions until the steps are nothing.
    lines += ["read", "hessian_normal", "g 5", "hessian_seek", "hessian_seek", "hessian_seek", "hessian", "hessian", "hessian"]
    lines += ['printf "AREA %.15g\\n", total_area', "q", "q", ""]
    with tempfile.TemporaryDirectory() as folder:
        name = os.path.join(folder, "film.fe")
        with open(name, "w") as file:
            file.write("\n".join(lines))
        empty = os.path.join(folder, "empty.fe")
        with open(empty, "w") as file:
            cut = next(k for k, line in enumerate(lines) if line == "read")
            file.write("\n".join(lines[: cut + 1] + ["q", "q", ""]))
        import resource

        def run(path):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            out = subprocess.run([binary, path], input="q\nq\n", capture_output=True, text=True, timeout=limit)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            return out.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

        _, reading = run(empty)
        out, whole = run(name)
    area = [line.split()[1] for line in out.splitlines() if line.startswith("AREA")]
    if not area:
        raise RuntimeError("no area: " + " | ".join(out.splitlines()[-3:])[:200])
    return dict(triangles=m, seconds=max(whole - reading, 0.0), area=float(area[-1]))


PEERS = {"igl_cholmod": igl_cholmod, "evolver": evolver}
PROBLEMS = {"helicoid": helicoid, "rings": rings}


def ours(root):
    """Builds our benchmark; returns its binary."""
    command = ["cargo", "bench", "-p", "plateau-minimal-surface", "--bench", "minimal_surface", "--no-run", "--message-format=json"]
    out = subprocess.run(command, cwd=root, capture_output=True, text=True, check=True).stdout
    targets = [json.loads(line) for line in out.splitlines() if '"executable":"' in line]
    return next(t["executable"] for t in targets if t["target"]["name"] == "minimal_surface")


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--sizes", default="2000,20000,200000")
    arguments.add_argument("--problems", default="rings,helicoid")
    arguments.add_argument("--peers", default="igl_cholmod,evolver")
    arguments.add_argument("--tolerance", type=float, default=1e-3)
    arguments.add_argument("--limit", type=float, default=120, help="seconds for one measurement of a peer")
    arguments.add_argument("--record", help="append the lines to this file")
    arguments.add_argument("--one", nargs=3, help=argparse.SUPPRESS)
    given = arguments.parse_args()
    if given.one:
        peer, problem, size = given.one
        return print(json.dumps(PEERS[peer](PROBLEMS[problem], int(size), given.tolerance, given.limit)))
    root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=root, capture_output=True, text=True).stdout.strip()
    binary = ours(root)
    head = dict(date=datetime.date.today().isoformat(), commit=commit, machine=f"{os.cpu_count()} cores {os.uname().machine}")
    for size in map(int, given.sizes.split(",")):
        for problem in given.problems.split(","):
            out = subprocess.run([binary, "--case", problem, str(size)], capture_output=True, text=True, check=True).stdout
            own = json.loads(out)
            rows = [dict(head, **own, solver="plateau")]
            for peer in filter(None, given.peers.split(",")):
                row = dict(head, bench="minimal_surface", problem=problem, solver=peer)
                command = [sys.executable, os.path.abspath(__file__), "--one", peer, problem, str(size)]
                command += ["--tolerance", str(given.tolerance), "--limit", str(given.limit)]
                try:
                    done = subprocess.run(command, capture_output=True, text=True, timeout=4 * given.limit + 60)
                    if done.returncode:
                        raise RuntimeError((done.stderr.strip().splitlines() or ["failed"])[-1][:200])
                    row.update(json.loads(done.stdout.strip().splitlines()[-1]))
                    row["seconds"] = round(row["seconds"], 4)
                    if row["seconds"] > 0:
                        rows[0]["ratio_to_" + peer] = round(own["seconds"] / row["seconds"], 4)
                except (RuntimeError, subprocess.TimeoutExpired) as error:
                    row["not_measured"] = str(error)[:200]
                rows.append(row)
            for row in rows:
                line = json.dumps(row)
                print(line, flush=True)
                if given.record:
                    with open(given.record, "a") as file:
                        file.write(line + "\n")


if __name__ == "__main__":
    main()
