"""Judges one result: what it states against what its mesh measures, by code of its own.

`faults(request, statistics, mesh)` returns a list of sentences. The mesh is the JSON file of the job. Tolerances are those
of docs/audit.md.
"""

import math
from collections import Counter

from geometry import (angles, angle, area, components, cross, crossings, distance, dot, edges_of, largest_coordinate,
                      length, radius, scale, spread, sub, unit, add)

RELATIVE = 1e-9
CURVATURE = 0.1


class Judge:
    def __init__(self, request, statistics, mesh):
        self.request, self.statistics, self.mesh = request, statistics, mesh
        self.vertices = [tuple(v) for v in mesh["vertices"]]
        self.triangles = [tuple(t) for t in mesh["triangles"]]
        self.found = []
        self.step = 8 * math.ulp(largest_coordinate(self.vertices)) if self.vertices else 0.0

    def stated(self, pointer):
        value = self.statistics
        for key in pointer.split("/")[1:]:
            if isinstance(value, list):
                value = value[int(key)] if int(key) < len(value) else None
            elif isinstance(value, dict):
                value = value.get(key)
            else:
                return None
        return value

    def fault(self, text):
        self.found.append(text)

    def equal(self, pointer, measured):
        if self.stated(pointer) != measured:
            self.fault(f"{pointer} is stated as {self.stated(pointer)}, the mesh has {measured}")

    def near(self, pointer, measured, tolerance):
        stated = self.stated(pointer)
        if not isinstance(stated, (int, float)) or not abs(stated - measured) <= tolerance:
            self.fault(f"{pointer} is stated as {stated}, the mesh has {measured} (tolerance {tolerance:.1e})")

    def between(self, pointer, low, high):
        stated = self.stated(pointer)
        if not isinstance(stated, (int, float)) or not low <= stated <= high:
            self.fault(f"{pointer} is stated as {stated}, the mesh has {low} to {high}")

    def lines(self, name):
        return [path for line in self.mesh["lines"] if line["name"] == name for path in line["paths"]]

    # The parts that all kinds share.

    def arrays(self):
        if not all(math.isfinite(x) for v in self.vertices for x in v):
            self.fault("a coordinate is not finite")
        count = len(self.vertices)
        if not all(0 <= v < count for t in self.triangles for v in t):
            self.fault("a triangle names a vertex that does not exist")
        if any(len(set(t)) < 3 for t in self.triangles):
            self.fault("a triangle names a vertex twice")
        if any(not all(0 <= v < count for v in path) for line in self.mesh["lines"] for path in line["paths"]):
            self.fault("a line names a vertex that does not exist")
        return not self.found

    def points(self, polylines):
        numbers = self.mesh["input_vertices"]
        if [len(p) for p in polylines] != [len(n) for n in numbers]:
            self.fault("the points of the request and their vertices differ in number")
            return
        for k, (points, own) in enumerate(zip(polylines, numbers)):
            near = 1e-7 * radius(points)
            for i, (point, v) in enumerate(zip(points, own)):
                merged = i > 0 and v in (own[i - 1], own[0])
                away = distance(self.vertices[v], point)
                if away > 0 and not (merged and away <= near):
                    self.fault(f"point {i} of polyline {k} is {away} from its vertex")
                    return

    def surface(self, triangles=None):
        triangles = self.triangles if triangles is None else triangles
        at = self.vertices
        total = math.fsum(area(*(at[v] for v in t)) for t in triangles)
        rim = math.fsum(distance(at[t[k]], at[t[k - 1]]) for t in triangles for k in range(3))
        return total, RELATIVE * total + 0.5 * self.step * rim

    def edge_lengths(self, pointer, edges):
        lengths = [distance(self.vertices[a], self.vertices[b]) for a, b in edges]
        for name, value in spread(lengths).items():
            self.near(f"{pointer}/{name}", value, RELATIVE * max(lengths) + 2 * self.step)
        return lengths

    def angle_range(self):
        low, high = [], []
        for t in self.triangles:
            a, b, c = (self.vertices[v] for v in t)
            longest = max(distance(a, b), distance(b, c), distance(c, a))
            altitude = 2 * area(a, b, c) / longest if longest > 0 else 0
            slack = RELATIVE + self.step / altitude if altitude > 0 else math.inf
            own = angles(a, b, c)
            low.append((min(own), slack))
            high.append((max(own), slack))
        degrees = math.degrees(1)
        self.between("/angles_deg/min", degrees * min(a - s for a, s in low), degrees * min(a + s for a, s in low))
        self.between("/angles_deg/max", degrees * max(a - s for a, s in high), degrees * max(a + s for a, s in high))

    def manifold(self, edges):
        if any(len(sides) > 2 or sum(sides) not in (-1, 0, 1) or (len(sides) == 2 and sum(sides)) for sides in edges.values()):
            self.fault("the mesh is no oriented manifold")

    def boundaries(self, edges):
        loops = self.lines("boundaries")
        # Where boundaries touch, the mesh has a vertex for each of them at the same place.
        place = lambda v: tuple(self.vertices[v])
        side = lambda a, b: tuple(sorted((place(a), place(b))))
        borders = Counter(side(a, b) for (a, b), sides in edges.items() if len(sides) == 1)
        followed = Counter(side(a, b) for loop in loops for a, b in zip(loop, loop[1:]))
        if self.request["kind"] != "minimal_surface" or self.stated("/junctions") is not None:
            borders, followed = set(borders), set(followed)
        if borders != followed:
            self.fault(f"the boundaries follow {len(followed)} edges, and the mesh has {len(borders)} border edges")
        for k, (loop, own) in enumerate(zip(loops, self.mesh["input_vertices"])):
            walk, place = loop[:-1], 0
            if own[0] not in walk:
                self.fault(f"boundary {k} does not pass its first point")
                continue
            walk = walk[walk.index(own[0]):] + walk[:walk.index(own[0])]
            for v in own:
                if v not in walk[place:] and v != own[0]:
                    self.fault(f"boundary {k} does not pass the request's points in their order")
                    break
                place = walk.index(v) if v != own[0] else place

    def straight(self):
        """Points added between two of the request lie on the segment between them."""
        loops = self.lines("boundaries")
        shared = Counter(place for loop in loops for place in {self.vertices[v] for v in loop})
        size = radius([self.vertices[v] for loop in loops for v in loop])
        for k, (loop, own) in enumerate(zip(loops, self.mesh["input_vertices"])):
            given, walk = set(own), loop[:-1]
            if own[0] not in walk:
                continue
            walk = walk[walk.index(own[0]):] + walk[:walk.index(own[0])] + [own[0]]
            stops = [i for i, v in enumerate(walk) if v in given]
            for start, end in zip(stops, stops[1:]):
                a, b = self.vertices[walk[start]], self.vertices[walk[end]]
                along = unit(sub(b, a))
                # A side on which another boundary has a point passes through that point.
                touches = any(shared[self.vertices[v]] > 1 for v in walk[start + 1:end])
                most = 1e-7 * size if touches else self.step
                for v in walk[start + 1:end]:
                    offset = sub(self.vertices[v], a)
                    beside = length(sub(offset, scale(dot(offset, along), along)))
                    if beside > most:
                        self.fault(f"vertex {v}, added on boundary {k}, is {beside} beside its segment")
                        return

    def crossings(self):
        stated = self.stated("/self_intersections")
        if stated is None or len(self.triangles) > 3000:
            return
        least = crossings(self.vertices, self.triangles)
        if least is not None and least > stated:
            self.fault(f"/self_intersections is stated as {stated}, and at least {least} pairs cross")

    # The methods below judge one kind each.

    def minimal_surface(self):
        self.equal("/vertices", len(self.vertices))
        self.equal("/triangles", len(self.triangles))
        edges = edges_of(self.triangles)
        junctions = self.stated("/junctions") is not None
        if not junctions:
            self.manifold(edges)
            rims = [edge for edge, sides in edges.items() if len(sides) == 1]
            self.equal("/boundary_loops", components(len(self.vertices), rims))
        self.equal("/components", components(len(self.vertices), edges))
        self.equal("/euler_characteristic", len(self.vertices) - len(edges) + len(self.triangles))
        self.points(self.request["boundaries"])
        self.boundaries(edges)
        self.straight()
        total, slack = self.surface()
        self.near("/area", total, slack)
        if self.request.get("objective", "minimal_area") == "minimal_area":
            self.near("/objective_value", total, slack)
        self.edge_lengths("/edge_lengths", edges)
        self.angle_range()
        self.crossings()
        bound = self.stated("/certificate/area_lower_bound")
        if bound:
            self.near("/certificate/gap", max(0.0, total / bound - 1), RELATIVE + slack / bound)
            if total + slack < bound:
                self.fault(f"the area {total} is below its proven bound {bound}")
        if not junctions and not self.request.get("constraints"):
            self.residual()

    def residual(self):
        at, count = self.vertices, len(self.vertices)
        gradient, normal = [(0.0,) * 3] * count, [(0.0,) * 3] * count
        ring, altitude = [0.0] * count, [math.inf] * count
        for t in self.triangles:
            corners = [at[v] for v in t]
            twice = cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]))
            double, n = length(twice), unit(twice)
            longest = max(distance(corners[k], corners[k - 1]) for k in range(3))
            for k, v in enumerate(t):
                side = sub(corners[(k + 2) % 3], corners[(k + 1) % 3])
                gradient[v] = add(gradient[v], scale(0.5, cross(n, side)))
                normal[v] = add(normal[v], twice)
                ring[v] += double
                altitude[v] = min(altitude[v], double / longest if longest > 0 else 0.0)
        rim = {v for loop in self.lines("boundaries") for v in loop}
        size = radius([at[v] for v in rim])
        lows, highs, value = [0.0], [0.0], 0.0
        for v in range(count):
            if v in rim or ring[v] == 0 or altitude[v] == 0:
                continue
            own = abs(dot(gradient[v], unit(normal[v]))) * 3 / ring[v] * size
            slack = CURVATURE * own + self.step * size / altitude[v] ** 2
            value = max(value, own)
            lows.append(own - slack)
            highs.append(own + slack)
        stated = self.stated("/residual")
        tolerance = self.request.get("tolerance") or 1e-6
        if not (stated <= tolerance and value <= tolerance):
            self.between("/residual", max(lows), max(highs))

    def ruled_surface(self):
        self.equal("/vertices", len(self.vertices))
        bridges = self.lines("bridges")
        self.equal("/bridges", len(bridges))
        if not self.request.get("sampling") and self.flat:
            self.points(self.request["directrices"])
        self.equal("/triangles", len(self.triangles))
        total, slack = self.surface()
        self.near("/area", total, slack)
        count = sum(strip["triangles"] for strip in self.stated("/strips") or [])
        if self.request.get("objective") == "minimal_area":
            self.near("/objective_value", *self.surface(self.triangles[:count]))
        lengths = [distance(self.vertices[p], self.vertices[q]) for p, q in bridges]
        self.near("/shortest_bridge", min(lengths), RELATIVE * max(lengths) + 2 * self.step)
        self.near("/longest_bridge", max(lengths), RELATIVE * max(lengths) + 2 * self.step)
        known = {tuple(sorted(pair)) for pair in bridges}
        edges = edges_of(self.triangles)
        if not known <= set(edges):
            self.fault("a bridge is no edge of the mesh")
        self.folds()
        self.crossings()

    def folds(self):
        """The largest angle between triangles that follow each other, strip by strip."""
        low = high = 0.0
        start = 0
        for strip in self.stated("/strips") or []:
            own = self.triangles[start:start + strip["triangles"]]
            start += strip["triangles"]
            pairs = list(zip(own, own[1:])) + ([(own[-1], own[0])] if self.request.get("closed") and len(own) > 2 else [])
            for one, two in pairs:
                if len(set(one) & set(two)) < 2:
                    self.fault("triangles that follow each other have no common side")
                    return
                vectors, slack = [], RELATIVE
                for t in (one, two):
                    a, b, c = (self.vertices[v] for v in t)
                    twice = cross(sub(b, a), sub(c, a))
                    longest = max(distance(a, b), distance(b, c), distance(c, a))
                    thin = length(twice) <= 1e-12 * longest * longest
                    slack = math.inf if thin else slack + self.step * longest / length(twice)
                    vectors.append(twice)
                fold = angle(*vectors)
                if slack < math.inf:
                    low, high = max(low, fold - slack), max(high, fold + slack)
                else:
                    high = math.pi
        self.between("/largest_fold_deg", math.degrees(low), math.degrees(high))

    def uniform_mesh(self):
        edges = edges_of(self.triangles)
        self.equal("/nodes", len(self.vertices))
        self.equal("/triangles", len(self.triangles))
        self.equal("/edges", len(edges))
        self.manifold(edges)
        lengths = self.edge_lengths("/edge_lengths", edges)
        self.angle_range()
        members = self.lines("members lattice") + self.lines("members rim")
        if {tuple(sorted(m)) for m in members} != set(edges) or len(members) != len(edges):
            self.fault("the members are not the edges of the mesh")
        self.equal("/lattice_edges/count", len(self.lines("members lattice")))
        target, tolerance = self.request["edge_length"], self.stated("/length_tolerance")
        slack = 2 * self.step + RELATIVE * target
        equal = lambda by: sum(abs(value - target) <= tolerance + by for value in lengths)
        self.between("/equal_edges", equal(-slack), equal(slack))
        outside = lambda by: sum(value < target - by or value > 2 * target + by for value in lengths)
        self.between("/out_of_range_edges", outside(slack + 1e-6 * target), outside(-slack))
        domain = self.request["domain"]
        if "polygon" in domain and self.flat:
            rings = [domain["polygon"]] + (domain.get("holes") or [])
            self.points([[tuple(p) for p in ring] for ring in rings])
            total, slack = self.surface()
            enclosed = self.enclosed(rings)
            if abs(total - enclosed) > slack + RELATIVE * enclosed:
                self.fault(f"the mesh has the area {total}, and its polygon {enclosed}")
        self.crossings()

    @staticmethod
    def enclosed(rings):
        total = 0.0
        for k, ring in enumerate(rings):
            base = ring[0]
            twice = (0.0, 0.0, 0.0)
            for a, b in zip(ring, ring[1:] + ring[:1]):
                twice = add(twice, cross(sub(a, base), sub(b, base)))
            total += (0.5 if k == 0 else -0.5) * length(twice)
        return total

    def cable_net(self):
        at, net = self.vertices, self.request
        self.equal("/vertices", len(at))
        self.equal("/edges", len(net["edges"]))
        for support in net["supports"]:
            if tuple(at[support]) != tuple(net["vertices"][support]):
                self.fault(f"support {support} is not at its place")
        on = [(0.0, 0.0, 0.0)] * len(at)
        for load in net.get("loads") or []:
            for v in load["vertices"]:
                on[v] = add(on[v], load["force"])
        slack, path, lengths = [0.0] * len(at), 0.0, []
        for line in self.mesh["lines"]:
            if not line["name"].startswith("cables"):
                continue
            for (a, b), force in zip(line["paths"], line["values"]["values"]):
                own = distance(at[a], at[b])
                lengths.append(own)
                path += force * own
                pull = scale(force / own, sub(at[b], at[a]))
                on[a], on[b] = add(on[a], pull), sub(on[b], pull)
                for v in (a, b):
                    slack[v] += abs(force) * (RELATIVE + 2 * self.step / own)
        if len(lengths) != len(net["edges"]):
            self.fault("the cables are not the edges of the request")
            return
        self.near("/load_path", path, 1e-8 * abs(path))
        for name, value in spread(lengths).items():
            self.near(f"/edge_lengths/{name}", value, RELATIVE * max(lengths) + 2 * self.step)
        held = set(net["supports"])
        worst = max((length(on[v]) for v in range(len(at)) if v not in held), default=0.0)
        self.near("/balance/residual_force", worst, max(slack))
        for k, support in enumerate(net["supports"]):
            for axis in range(3):
                self.near(f"/reactions/{k}/force/{axis}", -on[support][axis], slack[support])

    def tensile_structure(self):
        self.equal("/vertices", len(self.vertices))
        self.equal("/triangles", len(self.triangles))
        total, slack = self.surface()
        self.near("/area", total, slack)
        self.angle_range()
        start, edges = 0, []
        for k, layer in enumerate(self.stated("/layers") or []):
            own = self.triangles[start:start + layer["triangles"]]
            start += layer["triangles"]
            part, slack = self.surface(own)
            self.near(f"/layers/{k}/area", part, slack)
            sides = edges_of(own)
            self.manifold(sides)
            self.boundaries(sides)
            edges.extend(sides)
        self.edge_lengths("/edge_lengths", edges)
        by_name = {line["name"]: line for line in self.mesh["lines"]}
        for k, cable in enumerate(self.stated("/cables") or []):
            line = by_name.get(f"cables {cable['name']}")
            if line is None:
                self.fault(f"cable {cable['name']} has no line")
                continue
            own = [distance(self.vertices[a], self.vertices[b]) for a, b in line["paths"]]
            forces = line["values"]["values"]
            self.near(f"/cables/{k}/length", math.fsum(own), RELATIVE * math.fsum(own) + 2 * len(own) * self.step)
            self.near(f"/cables/{k}/force_min", min(forces), RELATIVE * max(map(abs, forces)))
            self.near(f"/cables/{k}/force_max", max(forces), RELATIVE * max(map(abs, forces)))
        balance = self.stated("/balance")
        if balance:
            off = length(add(balance["loads"], balance["reactions"]))
            self.near("/balance/imbalance", off / max(balance["magnitudes"], 1e-300), RELATIVE)
        self.crossings()


def faults(request, statistics, mesh, warnings=()):
    """Returns what is wrong with a result, as sentences."""
    judge = Judge(request, statistics, mesh)
    judge.flat = "projected" not in {warning["code"] for warning in warnings}
    if judge.arrays():
        getattr(judge, request["kind"])()
    return judge.found
