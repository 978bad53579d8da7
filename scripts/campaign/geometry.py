"""Vectors, measures of triangle meshes and crossings of triangles, in plain Python.

A vector is a tuple of three numbers. Nothing here is taken from the solvers.
"""

import math


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(k, a):
    return (k * a[0], k * a[1], k * a[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def length(a):
    return math.sqrt(dot(a, a))


def distance(a, b):
    return length(sub(a, b))


def unit(a):
    norm = length(a)
    return scale(1 / norm, a) if norm > 0 else (0.0, 0.0, 0.0)


def mean(points):
    count = len(points)
    return tuple(math.fsum(p[k] for p in points) / count for k in range(3))


def radius(points):
    centre = mean(points)
    return max(distance(p, centre) for p in points)


def largest_coordinate(points):
    return max(abs(x) for p in points for x in p)


def area(a, b, c):
    return 0.5 * length(cross(sub(b, a), sub(c, a)))


def angle(u, v):
    return math.atan2(length(cross(u, v)), dot(u, v))


def angles(a, b, c):
    return angle(sub(b, a), sub(c, a)), angle(sub(c, b), sub(a, b)), angle(sub(a, c), sub(b, c))


def edges_of(triangles):
    """Returns for each edge, with its smaller vertex first, its triangles as +1 or -1 by their direction along it."""
    edges = {}
    for triangle in triangles:
        for k in range(3):
            a, b = triangle[k], triangle[(k + 1) % 3]
            edges.setdefault((min(a, b), max(a, b)), []).append(1 if a < b else -1)
    return edges


def components(count, edges):
    """Returns the number of connected sets among the vertices that have an edge."""
    root = list(range(count))

    def find(v):
        while root[v] != v:
            root[v] = root[root[v]]
            v = root[v]
        return v

    used = set()
    for a, b in edges:
        used.update((a, b))
        root[find(a)] = find(b)
    return len({find(v) for v in used})


def spread(values):
    count = len(values)
    middle = math.fsum(values) / count
    deviation = math.sqrt(math.fsum((v - middle) ** 2 for v in values) / count)
    return {"min": min(values), "mean": middle, "max": max(values), "std_dev": deviation}


def orientation(a, b, c, d):
    """Returns six times the volume of a tetrahedron, and a bound of its rounding."""
    u, v, w = sub(a, d), sub(b, d), sub(c, d)
    m = cross(v, w)
    bound = 1e-14 * length(u) * length(v) * length(w)
    return dot(u, m), bound


def pierces(p, q, a, b, c):
    """Returns whether the segment p q goes through the inside of a triangle, decided only where rounding cannot."""
    above, e1 = orientation(a, b, c, p)
    below, e2 = orientation(a, b, c, q)
    if abs(above) <= e1 or abs(below) <= e2 or (above > 0) == (below > 0):
        return False
    sides = [orientation(p, q, x, y) for x, y in ((a, b), (b, c), (c, a))]
    if any(abs(value) <= bound for value, bound in sides):
        return False
    return len({value > 0 for value, _ in sides}) == 1


def crossings(vertices, triangles):
    """Returns the number of pairs of triangles without a common vertex of which an edge of one pierces the other.

    A grid finds the pairs. Pairs that only touch, or that share a vertex, are not counted, so the number is a lower bound
    of what the solvers call self-intersections.
    """
    if not triangles:
        return 0
    places = [tuple(v) for v in vertices]
    mean_edge = math.fsum(distance(places[t[0]], places[t[1]]) for t in triangles) / len(triangles)
    cell = 2 * mean_edge or 1.0
    grid, found = {}, set()
    for number, t in enumerate(triangles):
        corners = [places[v] for v in t]
        low = [math.floor(min(p[k] for p in corners) / cell) for k in range(3)]
        high = [math.floor(max(p[k] for p in corners) / cell) for k in range(3)]
        if (high[0] - low[0] + 1) * (high[1] - low[1] + 1) * (high[2] - low[2] + 1) > 4000:
            return None
        for x in range(low[0], high[0] + 1):
            for y in range(low[1], high[1] + 1):
                for z in range(low[2], high[2] + 1):
                    for other in grid.setdefault((x, y, z), []):
                        pair = (other, number)
                        if pair in found or set(triangles[other]) & set(t):
                            continue
                        one, two = [places[v] for v in triangles[other]], corners
                        # Vertices with equal coordinates count as one.
                        if set(one) & set(two):
                            continue
                        if any(max(p[k] for p in one) < min(p[k] for p in two) or
                               max(p[k] for p in two) < min(p[k] for p in one) for k in range(3)):
                            continue
                        sides = lambda s: ((s[0], s[1]), (s[1], s[2]), (s[2], s[0]))
                        if any(pierces(p, q, *two) for p, q in sides(one)) or any(pierces(p, q, *one) for p, q in sides(two)):
                            found.add(pair)
                    grid[(x, y, z)].append(number)
    return len(found)


class Motion:
    """A rigid motion: a rotation by a random unit quaternion, then a translation."""

    def __init__(self, random, reach=1.0):
        w, x, y, z = (random.gauss(0, 1) for _ in range(4))
        n = math.sqrt(w * w + x * x + y * y + z * z)
        w, x, y, z = w / n, x / n, y / n, z / n
        self.rows = ((1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
                     (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
                     (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)))
        self.shift = tuple(random.uniform(-reach, reach) for _ in range(3))

    def __call__(self, point):
        return add(tuple(dot(row, point) for row in self.rows), self.shift)
