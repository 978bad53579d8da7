#!/usr/bin/env python3
"""A finish that lowers the tangential part of the area's gradient, tried on the default solver's meshes.

    python3 benches/papers/finish.py          (PLATEAU_URL, or the service at http://127.0.0.1:8080; numpy and scipy)

The default solver ends at a film whose area no motion along the normals lowers. Chen, Cai and Zheng's curvature also
contains the part of the area's gradient along the surface, which depends on the layout of the triangles. The finish is

1. Four sweeps over the vertices, in alternating directions. The area of a vertex's ring is a convex function of the
   vertex, with the gradient sum(n x e) and the second derivative sum(|e|²/2A n nT) (n, A: normal and area of a triangle,
   e: its edge opposite to the vertex). One Newton step, damped by 0.003 of the trace, at most a quarter of the shortest
   edge, halved up to two times and left out if an angle would fall below 21 degrees. Vertices whose curvature times the
   boundary's radius is below 0.003 stay.
2. Two steps of Newton's method in normal heights.

It prints the films before and after, and the error of the area that is extrapolated from each mesh and its halving.
"""
import os
import sys
import tempfile

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as linalg

import judge
import meshfiles
from run import load, solve

SERVICE = os.environ.get("PLATEAU_URL", "http://127.0.0.1:8080").rstrip("/")
DAMPING, REACH, NEGLIGIBLE, LEAST_ANGLE, SWEEPS = 3e-3, 0.25, 3e-3, np.radians(21), 4
# Chen, Cai and Zheng's largest curvature, and the limit of the area on our polygon.
SURFACES = {"helicoid": (7e-4, 535.0748), "catenoid": (4e-3, 58.1637)}


def area_of(vertices, triangles):
    return judge.geometry_of(meshfiles.Mesh(vertices, triangles))[2].sum() / 2


def rim_of(triangles):
    half, _, index, count = judge.edges_of(triangles)
    return np.unique(half[count[index] == 1])


def rings_of(count, triangles):
    rings = [[] for _ in range(count)]
    for a, b, c in triangles:
        rings[a].append((b, c))
        rings[b].append((c, a))
        rings[c].append((a, b))
    return [np.array(ring) for ring in rings]


def least_tangent(place, following, last):
    u, w, x = following - place, last - following, place - last
    doubled = np.linalg.norm(np.cross(u, w), axis=1)
    return (doubled / np.maximum(np.maximum(-(u * x).sum(1), -(w * u).sum(1)), -(x * w).sum(1))).min()


def slide(vertices, free, rings, radius):
    """The sweeps; returns how often a vertex was moved."""
    moved = 0
    for sweep in range(SWEEPS):
        for v in free[:: 1 if sweep % 2 == 0 else -1]:
            following, last, here = vertices[rings[v][:, 0]], vertices[rings[v][:, 1]], vertices[v]
            edge = last - following
            normal = np.cross(edge, here - following)
            doubled = np.linalg.norm(normal, axis=1)
            normal /= doubled[:, None]
            gradient = np.cross(normal, edge).sum(0)
            if np.linalg.norm(gradient) / (2 * doubled.sum()) * radius < NEGLIGIBLE:
                continue
            second = np.einsum("i,ij,ik->jk", (edge * edge).sum(1) / doubled, normal, normal)
            step = -np.linalg.solve(second + DAMPING * np.trace(second) * np.eye(3), gradient)
            step *= min(1, REACH * np.linalg.norm(following - here, axis=1).min() / np.linalg.norm(step))
            bound = min(least_tangent(here, following, last), np.tan(LEAST_ANGLE))
            for part in (1, 0.5, 0.25):
                if least_tangent(here + part * step, following, last) >= bound:
                    vertices[v] = here + part * step
                    moved += 1
                    break
    return moved


def newton(vertices, triangles, free, steps):
    """Newton's method for the area in heights along the vertex normals."""
    count, unknown = len(vertices), np.full(len(vertices), -1)
    unknown[free] = np.arange(len(free))
    for _ in range(steps):
        _, normal, doubled, edge = judge.geometry_of(meshfiles.Mesh(vertices, triangles))
        frame = judge.sum_at(count, triangles, np.repeat(normal[:, None], 3, 1))
        frame /= np.maximum(np.linalg.norm(frame, axis=1), 1e-300)[:, None]
        unit = normal / doubled[:, None]
        gradient = judge.sum_at(count, triangles, 0.5 * np.cross(unit[:, None], edge))
        rows, columns, values = [], [], []
        for i in range(3):
            for j in range(3):
                along = frame[triangles[:, j]]
                change = np.cross(edge[:, j], along)
                change = (change - (change * unit).sum(1)[:, None] * unit) / doubled[:, None]
                sign = 0 if i == j else 1 if j == (i + 2) % 3 else -1
                entry = 0.5 * np.cross(change, edge[:, i]) + 0.5 * sign * np.cross(unit, along)
                at = (unknown[triangles[:, i]] >= 0) & (unknown[triangles[:, j]] >= 0)
                rows.append(unknown[triangles[at, i]])
                columns.append(unknown[triangles[at, j]])
                values.append((entry * frame[triangles[:, i]]).sum(1)[at])
        entries = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
        matrix = sparse.csc_matrix(entries, shape=(len(free), len(free)))
        vertices[free] += linalg.splu(matrix).solve(-(gradient * frame).sum(1)[free])[:, None] * frame[free]


def extrapolated(vertices, triangles):
    """The limit of the area by h², from the mesh and the mesh with every edge halved, corrected along its normals."""
    _, edges, index, _ = judge.edges_of(triangles)
    a, b, c = triangles.T
    ab, bc, ca = len(vertices) + index.reshape(3, -1)
    finer = np.concatenate([np.stack(t, 1) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    places = np.concatenate([vertices, (vertices[edges[:, 0]] + vertices[edges[:, 1]]) / 2])
    newton(places, finer, np.setdiff1d(np.unique(finer), rim_of(finer)), 3)
    return (4 * area_of(places, finer) - area_of(vertices, triangles)) / 3


def main():
    print("\n| surface | triangles | film | area | extrapolated area, less the limit, of the limit | largest curvature | along the "
          "normal | smallest angle | vertices moved |")
    print("|" + " --- |" * 9)
    for name, (printed, limit) in SURFACES.items():
        for count in (500, 2000, 20000):
            request = {**load(f"api/examples/{name}.json"), "resolution": {"triangles": count}, "tolerance": 1e-8}
            if count > 5000:
                request["boundary_sampling"] = "refine"
            _, data = solve(SERVICE, request)
            with tempfile.NamedTemporaryFile(suffix=".obj", delete=False) as file:
                file.write(data)
            mesh = meshfiles.read(file.name)
            os.remove(file.name)
            rim = rim_of(mesh.triangles)
            free = np.setdiff1d(np.unique(mesh.triangles), rim)
            around = mesh.vertices[rim] - mesh.vertices[rim].mean(0)
            rings = rings_of(len(mesh.vertices), mesh.triangles)
            for film in ("default", "finished"):
                moved = ""
                if film == "finished":
                    moved = str(slide(mesh.vertices, free, rings, np.linalg.norm(around, axis=1).max()))
                    newton(mesh.vertices, mesh.triangles, free, 2)
                found = judge.judge(mesh)
                error = f"{extrapolated(mesh.vertices, mesh.triangles) / limit - 1:.1e}" if count < 5000 else ""
                figures = found["chen_cai_zheng"]
                print(f"| {name} | {len(mesh.triangles)} | {film} | {figures['area']:.4f} | {error} | {figures['curvature_max']:.5f} | "
                      f"{figures['curvature_normal_max']:.0e} | {found['shape']['angles_deg']['min']:.1f}° | {moved} |", flush=True)
        print(f"| {name} | | the paper | | | {printed:.5f} | | | |")


if __name__ == "__main__":
    sys.exit(main())
