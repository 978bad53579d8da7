#!/usr/bin/env python3
"""Other programs on the papers' examples, judged like the service's meshes.

    python3 -m venv PEERS && PEERS/bin/pip install numpy scipy libigl pymeshlab triangle -r benches/peers/requirements.txt
    PEERS/bin/python benches/papers/peers.py [--only NAME] [--keep FOLDER]

Each program gets the boundary of the example and a structured mesh of about as many triangles, laid out by transfinite
interpolation of the boundary, and does what its documentation offers for the task:

- libigl: Pinkall and Polthier's iteration with its cotangent matrix, until the area changes by less than 1e-9 of itself
  or 500 times.
- jax_fdm: the net of the mesh's quads with the force density 1 in every edge, in equilibrium; its quads cut in two.
- Kratos: its form finding (update reference strategy) to a residual norm of 1e-7, rings of radius 10, 12 apart.
- MeshLab: isotropic remeshing (pymeshlab) of a fine mesh of the roof to l = 5.
- Triangle: conforming Delaunay triangulation of the floor with angles of at least 30 degrees (pq30) and l = 2.

A program that is not installed is left out, and said to be. Seconds are processor time of the program's own part.
"""
import argparse
import importlib.metadata
import json
import os
import sys
import tempfile
import time

import numpy as np

import judge
import meshfiles

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
# Intervals along the sides of the two patches of Chen, Cai and Zheng, as their requests have them.
PATCHES = {"ccz-6-helicoid": (12, 81), "ccz-7-catenoid": (52, 26)}


def example(name):
    with open(os.path.join(ROOT, "api", "examples", f"{name}.json"), encoding="utf-8") as file:
        return json.load(file)


def write(path, vertices, triangles):
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in np.asarray(vertices, float).tolist())
        file.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in np.asarray(triangles).tolist())


def patch(name, points):
    """A grid over the four sides of a boundary by transfinite interpolation: its points and quads."""
    nu, nv = PATCHES[name]
    P = np.array(points, float)
    bottom, right = P[: nu + 1], P[nu : nu + nv + 1]
    top, left = P[nu + nv : 2 * nu + nv + 1][::-1], np.concatenate([P[2 * nu + nv :], P[:1]])[::-1]
    s, t = np.linspace(0, 1, nu + 1)[:, None, None], np.linspace(0, 1, nv + 1)[None, :, None]
    grid = ((1 - t) * bottom[:, None] + t * top[:, None] + (1 - s) * left[None] + s * right[None]
            - (1 - s) * (1 - t) * P[0] - s * (1 - t) * P[nu] - s * t * P[nu + nv] - (1 - s) * t * P[2 * nu + nv])
    at = np.arange((nu + 1) * (nv + 1)).reshape(nu + 1, nv + 1)
    quads = np.stack([at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]], -1).reshape(-1, 4)
    rim = np.unique(np.concatenate([at[0], at[-1], at[:, 0], at[:, -1]]))
    return grid.reshape(-1, 3), quads, rim


def halves(quads):
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def libigl(name, request):
    import igl
    import scipy.sparse.linalg as spl

    vertices, quads, rim = patch(name, request["boundaries"][0])
    triangles = halves(quads)
    free = np.setdiff1d(np.arange(len(vertices)), rim)
    area = lambda: np.linalg.norm(np.cross(
        vertices[triangles[:, 1]] - vertices[triangles[:, 0]], vertices[triangles[:, 2]] - vertices[triangles[:, 0]]),
        axis=1).sum() / 2
    start, before, steps = time.process_time(), area(), 0
    for steps in range(1, 501):
        matrix = igl.cotmatrix(np.ascontiguousarray(vertices), triangles).tocsr()
        right = -matrix[free][:, rim] @ vertices[rim]
        vertices[free] = spl.splu(matrix[free][:, free].tocsc()).solve(right)
        now = area()
        if abs(before - now) < 1e-9 * now:
            break
        before = now
    return vertices, triangles, time.process_time() - start, f"{steps} steps"


def jax_fdm(name, request):
    from jax_fdm.datastructures import FDNetwork
    from jax_fdm.equilibrium import fdm

    vertices, quads, rim = patch(name, request["boundaries"][0])
    edges = {tuple(sorted((int(q[k]), int(q[k - 1])))) for q in quads for k in range(4)}
    net = FDNetwork.from_nodes_and_edges(vertices.tolist(), sorted(edges))
    net.nodes_supports([int(v) for v in rim])
    net.edges_forcedensities(1.0)
    start = time.process_time()
    found = fdm(net)
    seconds = time.process_time() - start
    return np.array([found.node_coordinates(v) for v in range(len(vertices))]), halves(quads), seconds, "density 1"


def kratos(folder):
    sys.path.insert(0, os.path.join(ROOT, "benches", "peers"))
    import tensile_structures

    with tensile_structures.output_to_stderr():
        figures = tensile_structures.kratos("catenoid", 576, 1e-7, 300, folder)
    mesh = meshfiles.read(os.path.join(folder, "kratos.obj"))
    return mesh.vertices, mesh.triangles, figures["seconds"], f"{figures['iterations']} iterations"


def meshlab(request):
    import pymeshlab

    control = np.array(request["domain"]["bezier"]["control_points"], float)
    t, n = np.linspace(0, 1, 121), 121

    def bernstein(degree):
        from math import comb

        return np.stack([comb(degree, k) * t**k * (1 - t) ** (degree - k) for k in range(degree + 1)])

    u, v = bernstein(control.shape[0] - 1), bernstein(control.shape[1] - 1)
    points = np.einsum("ip,jq,ijk->pqk", u, v, control).reshape(-1, 3)
    k = np.arange(n * n).reshape(n, n)
    quads = np.stack([k[:-1, :-1], k[1:, :-1], k[1:, 1:], k[:-1, 1:]], -1).reshape(-1, 4)
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(points, halves(quads)))
    start = time.process_time()
    meshes.meshing_isotropic_explicit_remeshing(targetlen=pymeshlab.PureValue(request["edge_length"]), iterations=10)
    seconds = time.process_time() - start
    found = meshes.current_mesh()
    return found.vertex_matrix(), found.face_matrix(), seconds, "10 iterations"


def triangle(request):
    import triangle as program

    polygon, length = np.array(request["domain"]["polygon"], float), request["edge_length"]
    points = []
    for a, b in zip(polygon, np.roll(polygon, -1, 0)):
        pieces = max(1, int(np.linalg.norm(b - a) / length))
        points += [a + (b - a) * k / pieces for k in range(pieces)]
    points = np.array(points)[:, :2]
    ends = np.arange(len(points))
    start = time.process_time()
    # The largest area is that of an equilateral triangle of edge sqrt(2) l.
    found = program.triangulate(
        {"vertices": points, "segments": np.stack([ends, np.roll(ends, -1)], 1)}, f"pq30a{length**2 * 3**0.5 / 2:.6f}Y")
    seconds = time.process_time() - start
    vertices = np.column_stack([found["vertices"], np.zeros(len(found["vertices"]))])
    return vertices, found["triangles"], seconds, "pq30"


def runs(folder):
    for name, file in (("ccz-6-helicoid", "helicoid"), ("ccz-7-catenoid", "catenoid")):
        yield name, "libigl", lambda n=name, f=file: libigl(n, example(f)), example(file)
        yield name, "jax_fdm", lambda n=name, f=file: jax_fdm(n, example(f)), example(file)
    yield "bc-6-rings-12", "KratosMultiphysics", lambda: kratos(folder), {}
    roof, floor = example("latticed-roof"), example("floor-fewest-nodes")
    yield "kox-roof", "pymeshlab", lambda: meshlab(roof), {"edge_length": roof["edge_length"]}
    yield "kox-floor", "triangle", lambda: triangle(floor), {"edge_length": floor["edge_length"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="a part of an example's or a program's name")
    parser.add_argument("--keep", help="the folder for the meshes")
    options = parser.parse_args()
    print("| example | program | triangles | area | largest curvature | along the normal | edges: min, mean, max "
          "| smallest angle | faults | seconds |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or temporary
        os.makedirs(folder, exist_ok=True)
        for name, program, solve, request in runs(folder):
            if options.only not in name and options.only not in program:
                continue
            try:
                version = importlib.metadata.version(program)
                vertices, triangles, seconds, how = solve()
            except ImportError as error:
                print(f"| {name} | {program}: not installed ({error}) |" + " |" * 8)
                continue
            path = os.path.join(folder, f"{name}.{program}.obj")
            write(path, vertices, triangles)
            found = judge.judge(meshfiles.read(path), request if "boundaries" in request else None)
            ccz, shape, lengths = found["chen_cai_zheng"], found["shape"], found["shape"]["edge_lengths"]
            is_film = name.startswith(("ccz", "bc"))
            curvatures = [f"{ccz['curvature_max']:.1e}", f"{ccz['curvature_normal_max']:.1e}"] if is_film else ["", ""]
            print("| " + " | ".join([
                name, f"{program} {version}, {how}", str(found["topology"]["triangles"]), f"{shape['area']:.4f}", *curvatures,
                f"{lengths['min']:.3f}, {lengths['mean']:.3f}, {lengths['max']:.3f}", f"{shape['angles_deg']['min']:.1f}°",
                "; ".join(found["faults"]) or "none", f"{seconds:.2f}"]) + " |", flush=True)


if __name__ == "__main__":
    main()
