#!/usr/bin/env python3
"""Writes requests/*.json: the examples of the papers that are no examples of the service.

    python3 benches/papers/coordinates.py

No paper prints its coordinates. Where one gives the surface and the number of points, the points are spread evenly over
the parameters; where it gives a picture only, the formula below is ours.
"""
import json
import math
import os

PI, TAU = math.pi, math.tau
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "requests")


def rim(surface, us, vs, nu, nv):
    """The boundary of a patch with nu and nv intervals along its sides."""
    at = lambda ends, k, n: ends[0] + (ends[1] - ends[0]) * k / n
    return (
        [surface(at(us, k, nu), vs[0]) for k in range(nu)] + [surface(us[1], at(vs, k, nv)) for k in range(nv)]
        + [surface(at(us[::-1], k, nu), vs[1]) for k in range(nu)] + [surface(us[0], at(vs[::-1], k, nv)) for k in range(nv)])


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


def membrane():
    points = []
    for k in range(9):
        reach, height = (5, 2) if k % 3 == 0 else (3.5, 0)
        points.append((reach * math.cos(TAU * k / 9), reach * math.sin(TAU * k / 9), height))
    return points


def requests():
    def films(boundaries, **more):
        return {"kind": "minimal_surface", "boundaries": boundaries, "boundary_sampling": "keep", **more}

    upper = [(x + 0.3, y, z + 0.8) for x, y, z in lobes(72, 1, 2, 0.25)]
    yield "ccz-8-top", films([lobes(160, 1.6, 3, 0.5)], resolution={"triangles": 2400})
    yield "ccz-8-bottom", films([lobes(97, 18, 2, 5)], resolution={"triangles": 1455})
    yield "ccz-4", films([banana()], resolution={"triangles": 960})
    yield "ccz-9", films([circle(72, 1.2, 0), upper], resolution={"triangles": 1152})
    yield "lw-6", films([rim(helicoid, (0.5, 2), (-PI / 3, PI / 3), 7, 7)], resolution={"interior_vertices": 20})
    yield "lw-7", films([rim(catenoid, (PI / 4, 3 * PI / 4), (-0.4, 0.4), 6, 6)], resolution={"interior_vertices": 25})
    for b in (0.4, 1, 4.9):
        for sides, interior in ((5, 16), (6, 20), (8, 30)):
            yield f"lw-8-b{b}-{4 * sides}", films([scherk(b, sides)], resolution={"interior_vertices": interior})
    yield "lw-9", films([membrane()], resolution={"interior_vertices": 4})
    yield "bc-6", films([circle(36, 10, 0), circle(36, 10, 12)], resolution={"triangles": 576})
    yield "bc-7", films([circle(36, 10, 0), circle(36, 10, 14)], resolution={"triangles": 576})


def main():
    for name, request in requests():
        with open(os.path.join(FOLDER, f"{name}.json"), "w", encoding="utf-8") as file:
            boundaries = request.pop("boundaries")
            text = json.dumps(request)[:-1] + ', "boundaries": [\n'
            text += ",\n".join("[" + ",\n".join(json.dumps(point) for point in loop) + "]" for loop in boundaries)
            file.write(text + "\n]}\n")


if __name__ == "__main__":
    main()
