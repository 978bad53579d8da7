#!/usr/bin/env python3
"""Checks the certificate of a lower bound of the area, in exact rational arithmetic and with no code of the service.

    curl -s http://127.0.0.1:8080/v1/jobs/ID/certificate | python3 scripts/check_certificate.py

For every orientation of the boundary it recomputes, from the tetrahedra and the values on edges and faces,

1. that the tetrahedra fill the box exactly once and that the boundary lies inside it, or inside it and its mirror images,
2. that |curl A| <= 1 at the four vertices of every tetrahedron (the curl is linear in between), except for tetrahedra
   that lie beyond one of the stated half-spaces, each of which holds the whole boundary: surfaces are no larger after
   their nearest-point projection onto the convex set of the half-spaces' common points,
3. the circulation of A around the boundary, which must not be below the bound that the certificate states.

The field: A is the sum over edges ij (i < j) of value times w_ij = li grad lj - lj grad li, and over faces ijk (i < j < k)
of the first value times lk w_ij and the second times li w_jk, where l are the barycentric coordinates. Only the tangential
part of A passes continuously from one tetrahedron to the next; Stokes' theorem needs no more.

With planes of symmetry ("mirrors") the box lies on one side of each. On the other side A is sign times its mirror image,
so that |curl A| has the same values there. With the sign -1 it passes continuously only if it has no tangential part in the plane,
which is checked. Segments of the boundary are reflected into the box, and their integrals multiplied with the signs.

With a "frame" all coordinates but those of the loops refer to other axes: a point p of the boundary has there the products of the axes
with p - origin. The axes are perpendicular only up to rounding, and the bound is divided by what that can add to an area.

Exit status: 0 if everything holds, 1 if not.
"""

import json
import sys
from collections import defaultdict
from fractions import Fraction


class Refused(Exception):
    pass


def require(condition, message):
    if not condition:
        raise Refused(message)


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def det(a, b, c, d):
    """Six times the signed volume of a tetrahedron."""
    return dot(cross(sub(b, a), sub(c, a)), sub(d, a))


def integers(numbers):
    """Floats and their sums and products as integers over one power of two: exact."""
    ratios = [x.as_integer_ratio() for x in numbers]
    scale = max((d for _, d in ratios), default=1)
    return [n * (scale // d) for n, d in ratios], scale


EVEN = [(0, 1, 2, 3), (0, 2, 3, 1), (0, 3, 1, 2), (1, 2, 0, 3), (1, 3, 2, 0), (2, 3, 0, 1)]


class Orientation:
    def __init__(self, part):
        points = [tuple(p) for loop in part["loops"] for p in loop]
        self.enlargement, self.framed = 1, bool(part.get("frame"))
        if self.framed:
            origin, *axes = [tuple(map(Fraction, p)) for p in [part["frame"]["origin"]] + part["frame"]["axes"]]
            require(len(axes) == 3, "a frame has three axes")
            points = [tuple(dot(axis, sub(p, origin)) for axis in axes) for p in points]
            # The largest eigenvalue of the axes' products bounds the factor by which an area is enlarged.
            self.enlargement = max(1, max(sum(abs(dot(a, b)) for b in axes) for a in axes))
        corners = [tuple(p) for p in part["box"]]
        flat = [x for p in list(map(tuple, part["vertices"])) + points + corners for x in p]
        flat, self.scale = integers(flat)
        flat = [tuple(flat[k : k + 3]) for k in range(0, len(flat), 3)]
        n = len(part["vertices"])
        self.vertices = flat[:n]
        self.loops, at = [], n
        for loop in part["loops"]:
            self.loops.append(flat[at : at + len(loop)])
            at += len(loop)
        self.box = flat[at : at + 2]
        self.mirrors = {"xyz".index(mirror["axis"]): mirror["sign"] for mirror in part.get("mirrors", [])}
        require(all(sign in (1, -1) for sign in self.mirrors.values()), "the sign of a mirror is neither 1 nor -1")
        for mirror in part.get("mirrors", []):
            at = part["box"][0]["xyz".index(mirror["axis"])]
            require(mirror["at"] == at, "the low corner of the box does not lie in a plane of symmetry")
        self.tetrahedra = [tuple(t) for t in part["tetrahedra"]]
        values, self.value_scale = integers(part["edge_values"] + [x for f in part["face_values"] for x in f])
        m = len(part["edges"])
        require(m == len(part["edge_values"]) and len(part["faces"]) == len(part["face_values"]), "values are missing")
        self.edges = {tuple(e): v for e, v in zip(part["edges"], values)}
        self.faces = {tuple(f): (values[m + 2 * k], values[m + 2 * k + 1]) for k, f in enumerate(part["faces"])}
        require(all(i < j for i, j in self.edges) and len(self.edges) == m, "edges are not i < j, once each")
        require(all(i < j < k for i, j, k in self.faces), "faces are not i < j < k")
        require(len(self.faces) == len(part["faces"]), "a face stands twice")
        self.half_spaces = [tuple(integers(direction)[0]) for direction in part.get("half_spaces", [])]
        pairs = part.get("unconstrained", [])
        self.unconstrained = dict(map(tuple, pairs))
        self.free = set(part.get("free_loops", []))
        require(len(self.unconstrained) == len(pairs), "a tetrahedron is unconstrained twice")

    def reflected(self, p, axis):
        return tuple(2 * self.box[0][k] - p[k] if k == axis else p[k] for k in range(3))

    def images(self, p):
        found = [p]
        for axis in self.mirrors:
            found += [self.reflected(q, axis) for q in found]
        return found

    def check_mesh(self):
        low, high = self.box
        inside = lambda p: all(low[k] <= p[k] <= high[k] for k in range(3))
        require(all(map(inside, self.vertices)), "a vertex lies outside the box")
        within = lambda p: any(map(inside, self.images(p)))
        require(all(within(p) for loop in self.loops for p in loop), "the boundary leaves the box")
        total, sides = 0, defaultdict(list)
        self.volumes = []
        for t in self.tetrahedra:
            corners = [self.vertices[v] for v in t]
            volume = det(*corners)
            require(volume != 0, "a tetrahedron is flat")
            self.volumes.append(volume)
            total += abs(volume)
            for k in range(4):
                sides[tuple(sorted(t[:k] + t[k + 1 :]))].append(t[k])
        extent = sub(high, low)
        require(total == 6 * extent[0] * extent[1] * extent[2], "the tetrahedra do not have the box's volume")
        for face, apexes in sides.items():
            a, b, c = (self.vertices[v] for v in face)
            if len(apexes) == 1:
                flat = any(a[k] == b[k] == c[k] == end[k] for k in range(3) for end in (low, high))
                require(flat, "a face of one tetrahedron lies inside the box")
            else:
                require(len(apexes) == 2, "a face has more than two tetrahedra")
                one, other = (det(a, b, c, self.vertices[v]) for v in apexes)
                require((one > 0) != (other > 0), "two tetrahedra lie on one side of their face")

    def check_mirrors(self):
        """The field has no tangential part in a plane where it changes its sign."""
        for axis in (axis for axis, sign in self.mirrors.items() if sign < 0):
            inside = lambda simplex: all(self.vertices[v][axis] == self.box[0][axis] for v in simplex)
            zero = all(value == 0 for edge, value in self.edges.items() if inside(edge))
            zero = zero and all(pair == (0, 0) for face, pair in self.faces.items() if inside(face))
            require(zero, f"the field has a tangential part in the plane of symmetry across {'xyz'[axis]}")

    def check_half_spaces(self):
        """Every unconstrained tetrahedron lies beyond a half-space that holds the boundary, and its mirror images do too."""
        points = [q for loop in self.loops for p in loop for q in self.images(p)]
        reach = [max(dot(d, p) for p in points) for d in self.half_spaces]
        for number, half_space in self.unconstrained.items():
            require(0 <= number < len(self.tetrahedra) and 0 <= half_space < len(reach), "no such half-space")
            direction = self.half_spaces[half_space]
            beyond = all(dot(direction, self.vertices[v]) > reach[half_space] for v in self.tetrahedra[number])
            require(beyond, f"tetrahedron {number} does not lie beyond half-space {half_space}")

    def local(self, t):
        """Signed edge values by positions, and faces as positions in ascending order of number with their values."""
        edges = {}
        for a in range(4):
            for b in range(4):
                if a != b:
                    i, j = t[a], t[b]
                    edges[a, b] = self.edges[i, j] if i < j else -self.edges[j, i]
        faces = []
        for k in range(4):
            order = sorted((p for p in range(4) if p != k), key=lambda p: t[p])
            faces.append((order, self.faces[tuple(t[p] for p in order)]))
        return edges, faces

    def largest_curl_squared(self):
        """The largest |curl A|^2 over all constrained tetrahedra, as a fraction."""
        largest = Fraction(0)
        for number, (t, volume) in enumerate(zip(self.tetrahedra, self.volumes)):
            if number in self.unconstrained:
                continue
            edges, faces = self.local(t)
            corners = [self.vertices[v] for v in t]
            for p in range(4):
                c = defaultdict(int)
                for (a, b), value in edges.items():
                    c[a, b] += value
                for (i, j, k), (first, second) in faces:
                    if p == i:
                        c[j, k] += 2 * second - first
                    elif p == j:
                        c[k, i] -= first + second
                    elif p == k:
                        c[i, j] += 2 * first - second
                v = (0, 0, 0)
                for i, j, k, l in EVEN:
                    factor, along = c[i, j] - c[j, i], sub(corners[l], corners[k])
                    v = (v[0] + factor * along[0], v[1] + factor * along[1], v[2] + factor * along[2])
                # Lengths are in units of 1/scale, values in 1/value_scale: curl = v scale^2 / (volume value_scale).
                squared, below = dot(v, v) * self.scale**4, (volume * self.value_scale) ** 2
                if squared * largest.denominator > largest.numerator * below:
                    largest = Fraction(squared, below)
        return largest

    def circulation(self):
        """The exact integral of A around all loops, where the magnitude of that around a free loop is subtracted."""
        low, high = self.box
        cells = 24
        size = [max(1, -(-(high[k] - low[k]) // cells)) for k in range(3)]
        span = lambda points, k: range(
            (min(p[k] for p in points) - low[k]) // size[k], (max(p[k] for p in points) - low[k]) // size[k] + 1
        )
        grid = defaultdict(list)
        for number, t in enumerate(self.tetrahedra):
            corners = [self.vertices[v] for v in t]
            for x in span(corners, 0):
                for y in span(corners, 1):
                    for z in span(corners, 2):
                        grid[x, y, z].append(number)
        total = Fraction(0)
        for number, loop in enumerate(self.loops):
            around = Fraction(0)
            for segment in zip(loop, loop[1:] + loop[:1]):
                for start, end, sign in self.parts(*segment):
                    near = set()
                    for x in span((start, end), 0):
                        for y in span((start, end), 1):
                            for z in span((start, end), 2):
                                near.update(grid[x, y, z])
                    around += sign * self.along(start, end, sorted(near))
            total += -abs(around) if number in self.free else around
        return total / self.value_scale

    def parts(self, start, end):
        """The parts of a segment between the planes of symmetry, reflected into the box, and what their integrals are
        multiplied with."""
        parts = [(start, end, 1)]
        for axis, sign in self.mirrors.items():
            at, cut = self.box[0][axis], []
            for a, b, factor in parts:
                if (a[axis] - at) * (b[axis] - at) < 0:
                    t = Fraction(at - a[axis], b[axis] - a[axis])
                    middle = tuple(at if k == axis else a[k] + (b[k] - a[k]) * t for k in range(3))
                    cut += [(a, middle, factor), (middle, b, factor)]
                else:
                    cut.append((a, b, factor))
            beyond = lambda part: part[0][axis] < at or part[1][axis] < at
            turned = lambda part: (self.reflected(part[0], axis), self.reflected(part[1], axis), sign * part[2])
            parts = [turned(part) if beyond(part) else part for part in cut]
        return parts

    def along(self, start, end, near):
        pieces = []
        for number in near:
            t, volume = self.tetrahedra[number], self.volumes[number]
            corners = [self.vertices[v] for v in t]
            at = []
            for p in (start, end):
                at.append([Fraction(det(*(p if q == k else corners[q] for q in range(4))), volume) for k in range(4)])
            first, last = Fraction(0), Fraction(1)
            for a, b in zip(*at):
                if a < 0 and b < 0:
                    last = Fraction(-1)
                elif a < 0:
                    first = max(first, a / (a - b))
                elif b < 0:
                    last = min(last, a / (a - b))
            if first < last:
                pieces.append((first, last, number, at))
        pieces.sort(key=lambda piece: piece[:3])
        total, reached = Fraction(0), Fraction(0)
        while reached < 1:
            found = next((p for p in pieces if p[0] <= reached < p[1]), None)
            require(found is not None, "a segment of the boundary leaves the tetrahedra")
            _, last, number, (a, b) = found
            edges, faces = self.local(self.tetrahedra[number])
            p = [x + (y - x) * reached for x, y in zip(a, b)]
            q = [x + (y - x) * last for x, y in zip(a, b)]
            w = lambda i, j: p[i] * q[j] - p[j] * q[i]
            total += sum(edges[i, j] * w(i, j) for i in range(4) for j in range(i + 1, 4))
            for (i, j, k), (first, second) in faces:
                total += (first * (p[k] + q[k]) * w(i, j) + second * (p[i] + q[i]) * w(j, k)) / 2
            reached = last
        return total


def check(certificate):
    """Returns in words what is proven. Raises Refused if the proof does not hold."""
    parts = certificate["orientations"]
    require(parts, "no orientation")
    loops = parts[0]["loops"]
    seen = []
    for part in parts:
        require(len(part["loops"]) == len(loops), "another number of loops")
        signs = []
        for own, first in zip(part["loops"], loops):
            require(own in (first, first[::-1]), "another boundary")
            signs.append(own == first)
        free = part.get("free_loops", [])
        require(all(0 <= number < len(loops) for number in free), "no such loop is free")
        seen.append([None if number in free else sign for number, sign in enumerate(signs)])
        orientation = Orientation(part)
        orientation.check_mesh()
        orientation.check_mirrors()
        orientation.check_half_spaces()
        curl = orientation.largest_curl_squared()
        require(curl <= 1, f"|curl A| reaches {float(curl) ** 0.5!r}, more than 1")
        circulation = orientation.circulation()
        stated = part["area_lower_bound"]
        least_area = circulation / orientation.enlargement
        require(Fraction(stated) <= least_area, f"the circulation is {float(circulation)!r}, below the stated {stated!r}")
        require(certificate["area_lower_bound"] <= stated, "the bound exceeds that of an orientation")
        frame = ", in a frame of their own" if orientation.framed else ""
        mirrors = "".join(f", reflected at {'xyz'[axis]}" for axis in sorted(orientation.mirrors))
        print(f"{len(orientation.tetrahedra)} tetrahedra{frame}{mirrors}, {len(orientation.unconstrained)} of them unconstrained: "
              f"|curl A| <= {float(curl) ** 0.5:.15f}, circulation {float(circulation)!r} >= {stated!r}")
    require(covers_all(seen), "an orientation of the loops is missing")
    return "the bound holds"


def covers_all(seen):
    """Whether every orientation belongs to one of the given ones, in which None stands for both directions. Reversing all
    loops gives the same orientation."""
    count = len(seen[0])
    fixed = next((k for k in range(count) if all(signs[k] is not None for signs in seen)), None)
    if fixed is None:
        return False
    of = {tuple(None if sign is None else sign == signs[fixed] for sign in signs) for signs in seen}
    # They share no orientation, and there are as many as there can be.
    apart = lambda a, b: any(p is not None and q is not None and p != q for p, q in zip(a, b))
    disjoint = all(apart(a, b) for a in of for b in of if a != b)
    return disjoint and sum(2 ** signs.count(None) for signs in of) == 2 ** (count - 1)


def main():
    try:
        proven = check(json.load(open(sys.argv[1]) if len(sys.argv) > 1 else sys.stdin))
    except Refused as refused:
        print(f"refused: {refused}", file=sys.stderr)
        return 1
    print(proven)
    return 0


if __name__ == "__main__":
    sys.exit(main())
