#!/usr/bin/env python3
"""Draws where the bridges of a strip are locally convex, as SVG: Wang and Tang's Fig. 10 and 11 for any open strip.

    python3 benches/papers/convexity.py map api/examples/wang-tang-i.json > docs/validation/validity_map.svg
    python3 benches/papers/convexity.py strip api/examples/wang-tang-ii.json > docs/validation/convex_strip.svg

`map` has a cell for every pair of points, dark where the bridge between them is locally convex by judge.py, and the
paths of minimal twist (red) and of maximal convexity (blue) that the service finds. `strip` has the strip that the
request asks for, seen along the z axis: red between bridges that are not locally convex, by the marks of the JSON mesh.

The service is that of PLATEAU_URL, or the one at http://127.0.0.1:8080. Needs numpy.
"""
import json
import os
import sys

import numpy as np

import judge
from run import call, load, solve

SERVICE = os.environ.get("PLATEAU_URL", "http://127.0.0.1:8080").rstrip("/")
CELL = 6
WIDTH = 720


def lines(mesh, name):
    return next(found for found in mesh["lines"] if found["name"] == name)


def solved(request):
    """The JSON mesh of a strip."""
    job, _ = solve(SERVICE, request)
    return json.loads(call(f"{SERVICE}{job['links']['mesh']}?format=json"))


def path(request):
    """The bridges of a strip between two rails, as pairs of numbers of points."""
    mesh = solved(request)
    first, second = lines(mesh, "directrices")["paths"]
    return [(first.index(p), second.index(q)) for p, q in lines(mesh, "bridges")["paths"]]


def opened(width, height, title):
    size = f'viewBox="0 0 {width} {height}" width="{width}" height="{height}"'
    return (f'<svg xmlns="http://www.w3.org/2000/svg" {size}>\n<title>{title}</title>\n'
            f'<rect width="{width}" height="{height}" fill="#fff"/>')


def validity_map(request):
    P, Q = (np.array(rail, float) for rail in request["directrices"])
    m, n = len(P), len(Q)
    tolerance = request.get("convexity_tolerance_deg", 1e-6)
    title = ("Validity map: dark where the bridge from p_i (across) to q_j (up) is locally convex; "
             "path of minimal twist in red, of maximal convexity in blue")
    print(opened(m * CELL, n * CELL, title))
    runs = []
    for j in range(n):
        convex = [judge.is_convex(P, Q, i, j, tolerance) for i in range(m)] + [False]
        begins = [i for i in range(m) if convex[i] and not (i and convex[i - 1])]
        for i in begins:
            run = convex.index(False, i) - i
            runs.append(f"M{i * CELL} {(n - 1 - j) * CELL}h{run * CELL}v{CELL}h-{run * CELL}z")
    print(f'<path fill="#555" d="{"".join(runs)}"/>')
    for objective, colour in (("minimal_twist", "#d33"), ("maximal_convexity", "#27f")):
        asked = {**request, "objective": objective, "secondary_objective": None, "all_objectives": False}
        points = " ".join(f"{i * CELL + CELL // 2},{(n - 1 - j) * CELL + CELL // 2}" for i, j in path(asked))
        print(f'<polyline fill="none" stroke="{colour}" stroke-width="2" points="{points}"/>')
    print("</svg>")


def strip(request):
    mesh = solved(request)
    places = np.array(mesh["vertices"])
    bridges = lines(mesh, "bridges")
    concave = {frozenset(ends): mark == 1 for ends, mark in zip(bridges["paths"], bridges["values"]["values"])}
    low, high = places.min(axis=0), places.max(axis=0)
    scale = (WIDTH - 20) / (high - low)[0]
    height = round(scale * (high - low)[1]) + 20

    def at(v):
        x, y, _ = (places[v] - low) * scale
        return f"{10 + x:.1f},{height - 10 - y:.1f}"

    title = "A strip seen along z: red between bridges that are not locally convex, orange beside one"
    print(opened(WIDTH, height, title))
    for triangle in sorted(mesh["triangles"], key=lambda triangle: places[triangle][:, 2].mean()):
        sides = [frozenset((triangle[k], triangle[k - 1])) for k in range(3)]
        colour = ("#cfdcf0", "#f6c177", "#d33")[sum(concave.get(side, False) for side in sides)]
        corners = " ".join(at(v) for v in triangle)
        print(f'<polygon points="{corners}" fill="{colour}" stroke="#555" stroke-width="0.4"/>')
    for rail in lines(mesh, "directrices")["paths"]:
        points = " ".join(at(v) for v in rail)
        print(f'<polyline fill="none" stroke="#000" stroke-width="1.5" points="{points}"/>')
    print("</svg>")


def main():
    drawings = {"map": validity_map, "strip": strip}
    if len(sys.argv) != 3 or sys.argv[1] not in drawings:
        raise SystemExit(__doc__)
    drawings[sys.argv[1]](load(os.path.abspath(sys.argv[2])))


if __name__ == "__main__":
    main()
