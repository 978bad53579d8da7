#!/usr/bin/env python3
"""Measures a mesh by the formulas of five papers. It shares no code with any solver and needs numpy only.

    python3 benches/papers/judge.py MESH [--request REQUEST.json] [--surface NAME:b] [--domain MESH] [--lattice NAME]

MESH is a PLY, OBJ or GLB file of any origin. The answer is JSON: `faults` (empty for a sound mesh), `topology`,
`shape`, and one object for each paper that applies:

- Chen, Cai, Zheng (2008): `area`, `curvature` |k| = |sum (cot a + cot b)(Pj - Pi)| / (4 ring area) with its largest
  and mean value over the interior vertices, and the largest of its part along the vertex normal.
- Liu, Wang (2011): `F`, half the sum of the squared normal-cycle curvatures of the interior vertices, `F_all` with the
  boundary's, and with --surface (helicoid:1.9, catenoid:2.05, scherk:0.4) the paper's mean error.
- Bento, Cavalcanti: `dirichlet_energy` of the piecewise linear map from the mesh in --domain (else from itself, which
  gives the area), `components`.
- Katoh, Ohsaki, Xu: `edges` and, with --lattice NAME (a set of lines in the file), `lattice`: count, mean, min, max,
  std as in their Table 1, and with --edge-length the edges outside [l, 2 l].
- Wang, Tang: with --request, the directrices of a strip: area, total normal twist, convex bridges, bending energy, mean
  curvature variation, normal variation.

With --request the boundary of a minimal surface is compared with the one that was asked for. The definitions where a
paper is silent or misprinted are those of docs/papers. Exit status 1 if the mesh has faults.
"""
import argparse
import json
import math
import sys

import numpy as np

import meshfiles

# Altitude over longest edge below which a triangle counts as degenerate.
DEGENERATE = 1e-10
# Sine below which two directions count as parallel.
PARALLEL = 1e-14


# ---- the mesh as such


def edges_of(triangles):
    """Undirected edges (k x 2, ascending), for each half-edge its edge, and for each edge its number of triangles."""
    half = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    edges, index, count = np.unique(np.sort(half, 1), axis=0, return_inverse=True, return_counts=True)
    return half, edges, index.ravel(), count


def loops_of(half, index, count):
    """Boundary loops as lists of vertices, in the direction of their triangles; None if they branch."""
    following = {}
    for a, b in half[count[index] == 1]:
        if a in following:
            return None
        following[int(a)] = int(b)
    loops = []
    while following:
        start, at = next(iter(following.items()))
        loop = [start]
        del following[start]
        while at != start:
            if at not in following:
                return None
            loop.append(at)
            at = following.pop(at)
        loops.append(loop)
    return loops


def components_of(vertices, edges):
    """Number of connected parts of a graph over the numbers 0 to vertices - 1, isolated ones not counted."""
    parent = np.arange(vertices)

    def root(v):
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v

    for a, b in edges:
        ra, rb = root(a), root(b)
        if ra != rb:
            parent[max(ra, rb)] = min(ra, rb)
    return len({root(v) for v in np.unique(edges)}) if len(edges) else 0


def geometry_of(mesh):
    """Corners (m x 3 x 3), doubled area vectors, their lengths, and edge vectors opposite to each corner."""
    corners = mesh.vertices[mesh.triangles]
    opposite = np.stack([corners[:, 2] - corners[:, 1], corners[:, 0] - corners[:, 2], corners[:, 1] - corners[:, 0]], 1)
    normals = np.cross(opposite[:, 2], -opposite[:, 1])
    return corners, normals, np.linalg.norm(normals, axis=1), opposite


def angles_of(opposite, doubled):
    """Angles in radians at each corner."""
    cosines = [-(opposite[:, (k + 1) % 3] * opposite[:, (k + 2) % 3]).sum(1) for k in range(3)]
    return np.stack([np.arctan2(doubled, cosine) for cosine in cosines], 1)


def sum_at(vertices, triangles, values):
    """Sums values of corners (m x 3 or m x 3 x d) at their vertices."""
    total = np.zeros((vertices,) + values.shape[2:])
    np.add.at(total, triangles.ravel(), values.reshape((-1,) + values.shape[2:]))
    return total


def spread(values):
    """Their Table 1's columns, with the deviation over the count."""
    if not len(values):
        return {"count": 0}
    return {
        "count": len(values), "mean": float(values.mean()), "min": float(values.min()), "max": float(values.max()),
        "std": float(values.std()),
    }


def soundness(mesh):
    """Faults, topology and shape, and the numbers of the interior vertices."""
    half, edges, index, count = edges_of(mesh.triangles)
    _, normals, doubled, opposite = geometry_of(mesh)
    used = np.unique(mesh.triangles)
    loops = loops_of(half, index, count)
    directed = np.unique(half, axis=0, return_counts=True)[1]
    lengths = np.linalg.norm(mesh.vertices[edges[:, 0]] - mesh.vertices[edges[:, 1]], axis=1)
    longest = np.sqrt((opposite**2).sum(2).max(1))
    degenerate = doubled <= DEGENERATE * longest**2
    at_vertex = sum_at(len(mesh.vertices), mesh.triangles, np.repeat(normals[:, None], 3, 1))
    flipped = (at_vertex[mesh.triangles] / np.maximum(np.linalg.norm(at_vertex[mesh.triangles], axis=2), 1e-300)[..., None])
    flipped = (flipped.sum(1) * normals).sum(1) < 0
    components = components_of(len(mesh.vertices), edges)
    euler = len(used) - len(edges) + len(mesh.triangles)
    faults = []
    for number, text in [
        ((count > 2).sum(), "edges with more than two triangles"),
        ((directed > 1).sum(), "edges that two triangles run through in the same sense"),
        (degenerate.sum(), "degenerate triangles"),
        (flipped.sum(), "flipped triangles"),
        (len(mesh.triangles) - len(np.unique(np.sort(mesh.triangles, 1), axis=0)), "repeated triangles"),
        (int(loops is None), "boundary that branches"),
    ]:
        if number:
            faults.append(f"{int(number)} {text}")
    angles = np.degrees(angles_of(opposite, doubled))
    topology = {
        "vertices": len(used), "triangles": len(mesh.triangles), "edges": len(edges), "components": components,
        "boundary_loops": None if loops is None else len(loops), "euler_characteristic": euler,
        "genus": None if loops is None or components != 1 else (2 - euler - len(loops)) // 2,
    }
    shape = {
        "area": float(doubled.sum() / 2), "edge_lengths": spread(lengths),
        "angles_deg": {"min": float(angles.min()), "max": float(angles.max())},
    }
    rim = np.unique(half[count[index] == 1])
    return faults, topology, shape, loops, np.setdiff1d(used, rim)


# ---- Chen, Cai, Zheng


def chen_cai_zheng(mesh, interior):
    """Their curvature (section 4): the whole ring's area below the line, so a third of the usual mean curvature."""
    corners, normals, doubled, opposite = geometry_of(mesh)
    with np.errstate(divide="ignore", invalid="ignore"):
        cotangent = np.stack(
            [-(opposite[:, (k + 1) % 3] * opposite[:, (k + 2) % 3]).sum(1) / doubled for k in range(3)], 1)
    cotangent = np.nan_to_num(cotangent)
    flow = np.zeros((len(mesh.triangles), 3, 3))
    for k in range(3):
        # The edge opposite to corner k runs from corner k + 1 to corner k + 2.
        flow[:, (k + 1) % 3] += cotangent[:, k, None] * opposite[:, k]
        flow[:, (k + 2) % 3] -= cotangent[:, k, None] * opposite[:, k]
    n = len(mesh.vertices)
    total = sum_at(n, mesh.triangles, flow)[interior]
    ring = sum_at(n, mesh.triangles, np.repeat(doubled[:, None] / 2, 3, 1))[interior]
    normal = sum_at(n, mesh.triangles, np.repeat(normals[:, None], 3, 1))[interior]
    normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    full = np.linalg.norm(total, axis=1) / (4 * ring)
    along = np.abs((total * normal).sum(1)) / (4 * ring)
    if not len(full):
        return {"area": float(doubled.sum() / 2), "curvature_max": 0.0, "curvature_mean": 0.0, "curvature_normal_max": 0.0}
    return {
        "area": float(doubled.sum() / 2), "curvature_max": float(full.max()), "curvature_mean": float(full.mean()),
        "curvature_normal_max": float(along.max()),
    }


# ---- Liu, Wang


def relative(off, coordinate):
    return np.where(np.abs(coordinate) > 1, off / np.maximum(np.abs(coordinate), 1), off)


SURFACES = {
    "helicoid": lambda p, b: relative(np.abs(p[:, 1] - p[:, 0] * np.tan(p[:, 2] / b)), p[:, 1]),
    "catenoid": lambda p, b: relative(
        np.abs(p[:, 2] - np.sqrt(np.maximum((b * np.cosh(p[:, 1] / b)) ** 2 - p[:, 0] ** 2, 0))), p[:, 2]),
    "scherk": lambda p, b: relative(
        np.abs(p[:, 2] - np.log(np.cos(b * p[:, 1]) / np.cos(b * p[:, 0])) / b), p[:, 2]),
    # The axis of Chen, Cai and Zheng's catenoid is z.
    "catenoid-z": lambda p, b: np.abs(np.hypot(p[:, 0], p[:, 1]) - b * np.cosh(p[:, 2] / b)),
    "plane-z": lambda p, b: np.abs(p[:, 2] - b),
}


def liu_wang(mesh, interior, surface):
    half, edges, index, count = edges_of(mesh.triangles)
    _, normals, doubled, _ = geometry_of(mesh)
    n = len(mesh.vertices)
    unit = normals / np.maximum(doubled, 1e-300)[:, None]
    owner = np.tile(np.arange(len(mesh.triangles)), 3)
    order = np.argsort(index, kind="stable")
    pairs = order[np.isin(index[order], np.flatnonzero(count == 2))].reshape(-1, 2)
    left, right = owner[pairs[:, 0]], owner[pairs[:, 1]]
    edge = mesh.vertices[half[pairs[:, 0], 1]] - mesh.vertices[half[pairs[:, 0], 0]]
    length = np.linalg.norm(edge, axis=1)
    sine = (np.cross(unit[left], unit[right]) * edge).sum(1) / np.maximum(length, 1e-300)
    angle = np.arctan2(sine, (unit[left] * unit[right]).sum(1))
    bent = np.zeros(n)
    np.add.at(bent, half[pairs[:, 0]].ravel(), np.repeat(angle * length / 2, 2))
    ring = sum_at(n, mesh.triangles, np.repeat(doubled[:, None] / 2, 3, 1)) / 3
    used = np.unique(mesh.triangles)
    cycle = np.zeros(n)
    cycle[used] = bent[used] / ring[used]
    found = {
        "F": float(0.5 * (cycle[interior] ** 2).sum()), "F_all": float(0.5 * (cycle[used] ** 2).sum()),
        "mean_cycle_curvature": float(np.abs(cycle[interior]).mean()) if len(interior) else 0.0,
    }
    if surface:
        name, _, b = surface.partition(":")
        errors = SURFACES[name](mesh.vertices[interior], float(b or 1))
        found["mean_error"] = float(errors.mean()) if len(errors) else 0.0
        found["max_error"] = float(errors.max()) if len(errors) else 0.0
    return found


# ---- Bento, Cavalcanti


def bento_cavalcanti(mesh, domain, components):
    """Dirichlet energy: a quarter of the sum of (cot a + cot b) in the domain times the squared length of the image."""
    if domain.triangles.shape != mesh.triangles.shape or (domain.triangles != mesh.triangles).any():
        raise SystemExit("--domain: its triangles must be those of the mesh")
    _, _, doubled, before = geometry_of(domain)
    _, _, _, after = geometry_of(mesh)
    cotangent = np.stack([-(before[:, (k + 1) % 3] * before[:, (k + 2) % 3]).sum(1) / doubled for k in range(3)], 1)
    return {"dirichlet_energy": float(0.25 * (cotangent * (after**2).sum(2)).sum()), "components": components}


# ---- Katoh, Ohsaki, Xu


def katoh_ohsaki_xu(mesh, lattice, length, tolerance):
    _, edges, _, _ = edges_of(mesh.triangles)
    lengths = lambda pairs: np.linalg.norm(mesh.vertices[pairs[:, 0]] - mesh.vertices[pairs[:, 1]], axis=1)
    all_edges = lengths(edges)
    found = {"edges": spread(all_edges)}
    if lattice is not None:
        if lattice not in mesh.lines:
            raise SystemExit(f"--lattice: the file has no lines named {lattice}, only {sorted(mesh.lines)}")
        found["lattice"] = spread(lengths(np.unique(np.sort(mesh.lines[lattice], 1), axis=0)))
        found["lattice_share"] = found["lattice"]["count"] / found["edges"]["count"]
    if length:
        slack = length * max(1e-9, 4 * mesh.digits)
        found["outside"] = int(((all_edges < length - slack) | (all_edges > 2 * length + slack)).sum())
        found["equal"] = int((np.abs(all_edges - length) <= tolerance * length + slack).sum())
    return found


# ---- Wang, Tang


def unit_cross(u, v):
    """u x v over its length, or None where it vanishes."""
    c = np.cross(u, v)
    size = math.sqrt(c @ c)
    return None if size <= PARALLEL * math.sqrt((u @ u) * (v @ v)) else c / size


def tangents_of(points, closed):
    """Derivative of the quadratic through three points by chord length (eq. 13 and 14), chords at open ends."""
    k = len(points)
    found = []
    for i in range(k):
        if not closed and i in (0, k - 1):
            found.append(points[1] - points[0] if i == 0 else points[-1] - points[-2])
            continue
        before, after = points[i] - points[i - 1], points[(i + 1) % k] - points[i]
        a, b = math.sqrt(before @ before), math.sqrt(after @ after)
        alpha = a / (a + b) if a > 0 and b > 0 else 0.5
        found.append((1 - alpha) / alpha * before + alpha / (1 - alpha) * after)
    return found


def bridges_of(mesh, P, Q):
    """The open strip's bridges (i, j), from its triangles. Vertices are recognised by their places."""
    places = np.concatenate([P, Q])
    near = max(4 * mesh.digits * np.abs(places).max(), 1e-12)
    label = {}
    for v in np.unique(mesh.triangles):
        hits = np.flatnonzero(np.abs(places - mesh.vertices[v]).max(1) <= near)
        if not len(hits):
            raise SystemExit(f"vertex {v} is no point of a directrix")
        label[v] = [int(k) for k in hits]
    m, n = len(P), len(Q)
    steps = {}
    for triangle in mesh.triangles:
        # A triangle has one segment of a directrix, from k to k + 1, and one point of the other.
        found = None
        for r in range(3):
            a, b, c = (triangle[(r + s) % 3] for s in range(3))
            for x in label[a]:
                for y in label[b]:
                    if abs(x - y) == 1 and (x < m) == (y < m):
                        found = found or (min(x, y), [z for z in label[c] if (z < m) != (x < m)])
        if not (found and found[1]):
            raise SystemExit(f"triangle {triangle.tolist()} is no bridge triangle")
        if found[0] in steps:
            raise SystemExit(f"two triangles on segment {found[0]}")
        steps[found[0]] = found[1]
    path = [(0, 0)]
    while path[-1] != (m - 1, n - 1):
        i, j = path[-1]
        if i < m - 1 and m + j in steps.get(i, []):
            path.append((i + 1, j))
        elif j < n - 1 and i in steps.get(m + j, []):
            path.append((i, j + 1))
        else:
            raise SystemExit(f"no triangle follows bridge {(i, j)}")
    return path


def is_convex(P, Q, i, j, tolerance_deg):
    """Whether the bridge lies on the hull of itself and its neighbours: seen along it, the directions to them fit in a
    closed half-plane."""
    e = Q[j] - P[i]
    size = math.sqrt(e @ e)
    if size == 0:
        return True
    u = e / size
    v = np.cross(u, np.eye(3)[np.argmin(np.abs(u))])
    v /= math.sqrt(v @ v)
    w = np.cross(u, v)
    fuzz = np.spacing(max(np.abs(P).max(), np.abs(Q).max()))
    angles, slack = [], math.radians(tolerance_deg)
    for points, k in ((P, i), (Q, j)):
        for q in (k - 1, k + 1):
            if 0 <= q < len(points):
                d = points[q] - P[i]
                x, y = d @ v, d @ w
                reach = math.hypot(x, y)
                if reach > fuzz:
                    angles.append(math.atan2(y, x))
                    slack = max(slack, fuzz / reach)
    if len(angles) <= 2:
        return True
    angles.sort()
    gaps = [b - a for a, b in zip(angles, angles[1:])] + [angles[0] + math.tau - angles[-1]]
    return max(gaps) >= math.pi - slack


def wang_tang(mesh, request):
    """Their Table 1 for an open strip between two directrices."""
    if len(request["directrices"]) != 2 or request.get("closed"):
        return {"skipped": "only open strips between two directrices are measured"}
    P, Q = (np.array(line, float) for line in request["directrices"])
    middle = np.concatenate([P, Q]).mean(0)
    path = bridges_of(mesh, P, Q)
    P, Q = P - middle, Q - middle
    given = request.get("tangents")
    tP, tQ = ([np.array(t, float) for t in line] for line in given) if given else (tangents_of(P, False), tangents_of(Q, False))
    count = len(path)
    area, sides = 0.0, []
    for (i, j), (i2, j2) in zip(path, path[1:]):
        u, v = (P[i2] if i2 > i else Q[j2]) - P[i], Q[j] - P[i]
        c = np.cross(u, v)
        area += 0.5 * math.sqrt(c @ c)
        sides.append((0.5 * math.sqrt(c @ c), unit_cross(u, v)))
    twist, convex, bending, variation, H = 0.0, [], [0.0] * count, 0.0, [np.zeros(3)] * count
    both_ways = [0.0, 0.0]
    tolerance = request.get("convexity_tolerance_deg", 1e-6)
    normals = request.get("normals")
    monotone = request.get("bending", "monotone") == "monotone"
    for k, (i, j) in enumerate(path):
        e = Q[j] - P[i]
        n_p, n_q = unit_cross(e, tP[i]), unit_cross(e, tQ[j])
        twist += 1.0 - (0.0 if n_p is None or n_q is None else n_p @ n_q)
        if normals:
            for way in range(2):
                sign = 1 - 2 * way
                for mine, given_one in ((n_p, normals[0][i]), (n_q, normals[1][j])):
                    given_one = np.array(given_one, float)
                    both_ways[way] += 1.0 - (0.0 if mine is None else sign * (mine @ given_one))
        convex.append(is_convex(P, Q, i, j, tolerance))
        if k in (0, count - 1):
            continue
        (a_left, left), (a_right, right) = sides[k - 1], sides[k]
        if left is None or right is None:
            continue
        c, s = left @ right, np.cross(left, right)
        sine_squared = s @ s
        A = a_left + a_right
        L = 2 * A / math.sqrt(e @ e)
        bending[k] = A * (2 - sine_squared if monotone and c < 0 else sine_squared) / L**2
        H[k] = np.cross(e, left - right)
    jumps = [math.sqrt((a - b) @ (a - b)) for a, b in zip(H, H[1:])]
    found = {
        "area": area, "total_normal_twist": twist, "convex_bridges": sum(convex), "bridges": count,
        "bending_energy": math.fsum(bending), "mean_curvature_variation": math.fsum(jumps),
        "normal_variation": min(both_ways) if normals else None,
        "concave_bending_energy": math.fsum(b for b, good in zip(bending, convex) if not good),
        "concave_mean_curvature_variation": math.fsum(h for h, good in zip(jumps, convex[1:]) if not good),
    }
    return found


# ---- the boundary that was asked for


def boundary_faults(mesh, loops, boundaries):
    """The loops must pass through the given points in their order, and no farther from their sides than rounding."""
    faults = []
    scale = max(np.abs(np.concatenate([np.array(b, float) for b in boundaries])).max(), 1e-300)
    near = 8 * mesh.digits * scale
    for k, boundary in enumerate(boundaries):
        points = np.array(boundary, float)
        found = False
        for loop in loops or []:
            around = mesh.vertices[loop]
            starts = np.flatnonzero(np.abs(around - points[0]).max(1) <= near)
            for start in starts:
                for turned in (np.roll(around, -start, 0), np.roll(around[::-1], -(len(loop) - 1 - start), 0)):
                    at = 0
                    for point in turned:
                        if at < len(points) and np.abs(point - points[at]).max() <= near:
                            at += 1
                    if at == len(points) and distance_to(turned, points) <= near:
                        found = True
        if not found:
            faults.append(f"boundary {k} is not a loop of the mesh")
    return faults


def distance_to(points, polygon):
    """Largest distance of points from the sides of a closed polygon."""
    a, b = polygon, np.roll(polygon, -1, 0)
    side = b - a
    squared = np.maximum((side**2).sum(1), 1e-300)
    largest = 0.0
    for p in points:
        t = np.clip(((p - a) * side).sum(1) / squared, 0, 1)
        largest = max(largest, np.sqrt(((a + t[:, None] * side - p) ** 2).sum(1)).min())
    return largest


def judge(mesh, request=None, surface=None, domain=None, lattice=None, length=None, tolerance=1e-3):
    """Everything that applies to the mesh, as a dictionary."""
    if not len(mesh.triangles):
        raise SystemExit("the file has no triangles")
    faults, topology, shape, loops, interior = soundness(mesh)
    found = {"faults": faults, "topology": topology, "shape": shape}
    request = request or {}
    if "directrices" in request:
        # A strip may fold by more than 90 degrees; that is no fault of the mesh.
        found["faults"] = [fault for fault in faults if "flipped" not in fault]
        found["wang_tang"] = wang_tang(mesh, request)
        return found
    found["chen_cai_zheng"] = chen_cai_zheng(mesh, interior)
    found["liu_wang"] = liu_wang(mesh, interior, surface)
    if not any("degenerate" in fault for fault in faults):
        found["bento_cavalcanti"] = bento_cavalcanti(mesh, domain or mesh, topology["components"])
    found["katoh_ohsaki_xu"] = katoh_ohsaki_xu(mesh, lattice, length, tolerance)
    if "boundaries" in request:
        faults.extend(boundary_faults(mesh, loops, request["boundaries"]))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("--request", help="the JSON of the request: boundaries or directrices")
    parser.add_argument("--surface", help="the exact surface, for example helicoid:1.9")
    parser.add_argument("--domain", help="the mesh before a step, with the same triangles")
    parser.add_argument("--lattice", help="the name of the lines that are the lattice group")
    parser.add_argument("--edge-length", type=float)
    parser.add_argument("--length-tolerance", type=float, default=1e-3)
    options = parser.parse_args()
    request = None
    if options.request:
        with open(options.request, encoding="utf-8") as file:
            request = json.load(file)
    domain = meshfiles.read(options.domain) if options.domain else None
    found = judge(
        meshfiles.read(options.mesh), request, options.surface, domain, options.lattice, options.edge_length,
        options.length_tolerance)
    print(json.dumps(found, indent=2))
    sys.exit(1 if found["faults"] else 0)


if __name__ == "__main__":
    main()
