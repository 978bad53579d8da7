#!/usr/bin/env python3
"""Writes requests/*.json: the examples of the papers that are no examples of the service.

    python3 benches/papers/coordinates.py

No paper prints its coordinates. Where one gives the surface and the number of points, the points are spread evenly over
the parameters; where it gives a picture only, the formula below is ours.
"""
import json
import math
import os
from random import Random

PI, TAU = math.pi, math.tau
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "requests")


def rim(surface, us, vs, nu, nv):
    """The boundary of a patch with nu and nv intervals along its sides."""
    return rim_of(surface, us, vs, (nu, nv, nu, nv))


def rim_of(surface, us, vs, sides):
    """The boundary of a patch with a number of intervals for each side: at vs[0], us[1], vs[1] and us[0]."""
    at = lambda ends, k, n: ends[0] + (ends[1] - ends[0]) * k / n
    a, b, c, d = sides
    return (
        [surface(at(us, k, a), vs[0]) for k in range(a)] + [surface(us[1], at(vs, k, b)) for k in range(b)]
        + [surface(at(us[::-1], k, c), vs[1]) for k in range(c)] + [surface(us[0], at(vs[::-1], k, d)) for k in range(d)])


def circle(n, radius, z):
    return [(radius * math.cos(TAU * k / n), radius * math.sin(TAU * k / n), z) for k in range(n)]


def lobes(n, radius, count, height):
    """A loop whose radius has two lobes and whose height has `count`."""
    points = []
    for t in (TAU * k / n for k in range(n)):
        r = radius * (1 + 0.15 * math.cos(2 * t))
        points.append((r * math.cos(t), r * math.sin(t), height * math.cos(count * t)))
    return points


def banana():
    """Its rings towards the centroid cross themselves, as those of Chen, Cai and Zheng's Fig. 4."""
    points = []
    for t in (TAU * k / 96 for k in range(96)):
        angle, radius = 2.4 * math.cos(t), 3 + 0.7 * math.sin(t)
        points.append((radius * math.sin(angle), 0.4 * math.cos(2 * t), radius * math.cos(angle)))
    return points


def helicoid(u, v):
    return (u * math.cos(v), u * math.sin(v), 1.9 * v)


def catenoid(u, v):
    return (2.05 * math.cos(u) * math.cosh(v), 2.05 * v, 2.05 * math.sin(u) * math.cosh(v))


def scherk_surface(b):
    return lambda x, y: (x, y, math.log(math.cos(b * y) / math.cos(b * x)) / b)


def scherk(b, sides):
    side = (-0.3 * PI / b, 0.3 * PI / b)
    return rim(scherk_surface(b), side, side, sides, sides)


def rounded(points):
    return [tuple(round(c, 6) for c in point) for point in points]


def helix(radius):
    """Three turns that rise 0.25 a radian, 251 points."""
    angles = [3 * TAU * k / 250 for k in range(251)]
    return rounded((radius * math.cos(t), radius * math.sin(t), 0.25 * t) for t in angles)


LEAN = 0.6


def shoe():
    """Two ovals, and the normals of the surface whose rulings lean by LEAN from the lower oval to the upper one."""
    lower = lambda t: (3 * math.cos(t), 2 * math.sin(t), 0.1 * math.sin(2 * t))
    upper = lambda t: (2.4 * math.cos(t), 1.8 * math.sin(t), 2 + 0.3 * math.cos(3 * t))
    along = lambda curve, t: [b - a for a, b in zip(curve(t - 1e-5), curve(t + 1e-5))]

    def normal(curve, t, ruling):
        (a, b, c), (x, y, z) = along(curve, t), ruling
        n = (b * z - c * y, c * x - a * z, a * y - b * x)
        size = math.sqrt(sum(v * v for v in n))
        return tuple(v / size for v in n)

    angles = [TAU * k / 110 for k in range(111)]
    between = lambda t, s: [b - a for a, b in zip(lower(t), upper(s))]
    normals = [[normal(lower, t, between(t, t + LEAN)) for t in angles], [normal(upper, t, between(t - LEAN, t)) for t in angles]]
    return [rounded(map(curve, angles)) for curve in (lower, upper)], [rounded(row) for row in normals]


def arcs(noise):
    """Two arcs of half a cylinder, 20 points each, the second of which leans; each point moves by at most `noise`."""
    random = Random(68)

    def near(point):
        direction = [random.gauss(0, 1) for _ in point]
        distance = noise * random.random() ** (1 / 3) / math.hypot(*direction)
        return tuple(a + distance * b for a, b in zip(point, direction))

    angles = [PI * k / 19 for k in range(20)]
    return [rounded(near((math.cos(t), math.sin(t), height + lean * math.cos(t))) for t in angles)
            for height, lean in ((0, 0), (1, 0.2))]


def membrane():
    points = []
    for k in range(9):
        reach, height = (5, 2) if k % 3 == 0 else (3.5, 0)
        points.append((reach * math.cos(TAU * k / 9), reach * math.sin(TAU * k / 9), height))
    return points


def requests():
    def film(boundary, **more):
        return {"kind": "minimal_surface", "boundaries": [boundary], **more}

    def films(boundaries, **more):
        return {"kind": "minimal_surface", "boundaries": boundaries, "boundary_sampling": "keep", **more}

    upper = [(x + 0.3, y, z + 0.8) for x, y, z in lobes(72, 1, 2, 0.25)]
    screw = lambda u, v: (u * math.cos(v), u * math.sin(v), v)
    yield "ccz-6", films([rim_of(screw, (2, 10), (-1, 10), (12, 113, 12, 49))], resolution={"triangles": 2050})
    yield "ccz-8-top", films([lobes(160, 1.6, 3, 0.5)], resolution={"triangles": 2400})
    yield "ccz-8-bottom", films([lobes(97, 18, 2, 5)], resolution={"triangles": 1455})
    yield "ccz-4", films([banana()], resolution={"triangles": 960})
    yield "ccz-9", films([circle(72, 1.2, 0), upper], resolution={"triangles": 1152})
    yield "lw-6", film(rim(helicoid, (0.5, 2), (-PI / 3, PI / 3), 7, 7), resolution={"interior_vertices": 20})
    yield "lw-7", film(rim(catenoid, (PI / 4, 3 * PI / 4), (-0.4, 0.4), 6, 6), resolution={"interior_vertices": 25})
    for b in (0.4, 1, 4.9):
        for sides, interior in ((5, 16), (6, 20), (8, 30)):
            yield f"lw-8-b{b}-{4 * sides}", film(scherk(b, sides), resolution={"interior_vertices": interior})
    yield "lw-9", film(membrane(), resolution={"interior_vertices": 4})
    yield "bc-6", films([circle(36, 10, 0), circle(36, 10, 12)], resolution={"triangles": 576})
    yield "bc-7", films([circle(36, 10, 0), circle(36, 10, 14)], resolution={"triangles": 576})
    without_rules = {"solver": "pinkall_polthier", "topology": "free", "linear_solver": "conjugate_gradients",
                     "initial_mesh": "rings", "degenerate_angle_deg": 0, "area_tolerance": 0, "tolerance": 0,
                     "max_iterations": 200}
    yield "bc-8", films([circle(36, 10, 0), circle(36, 10, 14)], **without_rules, resolution={"triangles": 576})

    strips = {"kind": "ruled_surface"}
    rails, normals = shoe()
    yield "wt-3", {**strips, "objective": "minimal_bending_energy", "directrices": [helix(1), helix(1.5)]}
    yield "wt-5", {**strips, "objective": "minimal_normal_variation", "normals": normals, "directrices": rails}
    yield "wt-7-clean", {**strips, "objective": "minimal_bending_energy", "directrices": arcs(0)}
    yield "wt-7-noisy", {**strips, "objective": "minimal_bending_energy", "directrices": arcs(0.02)}


def main():
    for name, request in requests():
        with open(os.path.join(FOLDER, f"{name}.json"), "w", encoding="utf-8") as file:
            curves = "boundaries" if "boundaries" in request else "directrices"
            loops = request.pop(curves)
            text = json.dumps(request)[:-1] + f', "{curves}": [\n'
            text += ",\n".join("[" + ",\n".join(json.dumps(point) for point in loop) + "]" for loop in loops)
            file.write(text + "\n]}\n")


if __name__ == "__main__":
    main()
