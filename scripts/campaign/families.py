"""Families of requests. A family draws one case from a random generator.

A case has the request, the relations that its result must keep, and sentences that say what is expected. Families named
`fault_…` draw neighbours of a request that once ended wrongly.
"""

import math
from dataclasses import dataclass, field

from geometry import Motion

TURN = 2 * math.pi


@dataclass
class Case:
    request: dict
    # Names of relations of `relations.py`.
    relations: tuple = ()
    # Functions of the outcome that return a sentence if something is wrong.
    checks: list = field(default_factory=list)


FAMILIES = {}


def family(function):
    FAMILIES[function.__name__] = function
    return function


def film(boundaries, triangles, **options):
    return {"kind": "minimal_surface", "boundaries": boundaries, "resolution": {"triangles": triangles}, **options}


def ring(count, r=1.0, z=0.0, centre=(0.0, 0.0), phase=0.0):
    angle = lambda k: TURN * (k + phase) / count
    return [[centre[0] + r * math.cos(angle(k)), centre[1] + r * math.sin(angle(k)), z] for k in range(count)]


def square(side_points, size=1.0, height=0.0, first=0):
    """A square with so many points a side, whose middles are raised in turn; the list begins at point `first`."""
    points = []
    corners = [(0, 0), (size, 0), (size, size), (0, size)]
    for k in range(4):
        (ax, ay), (bx, by) = corners[k], corners[(k + 1) % 4]
        for i in range(side_points):
            t = i / side_points
            z = height * ((1 - t) if k % 2 == 0 else t)
            points.append([ax + t * (bx - ax), ay + t * (by - ay), z])
    return points[first:] + points[:first]


def wavy(random, count, z=0.0, r=1.0):
    waves = [(random.randint(1, 4), random.uniform(0, 0.25), random.uniform(0, TURN)) for _ in range(3)]
    lift = [(random.randint(1, 3), random.uniform(0, 0.3), random.uniform(0, TURN)) for _ in range(2)]
    points = []
    for k in range(count):
        a = TURN * k / count
        here = r * (1 + sum(h * math.sin(n * a + p) for n, h, p in waves) / 2)
        up = z + sum(h * math.sin(n * a + p) for n, h, p in lift)
        points.append([here * math.cos(a), here * math.sin(a), up])
    return points


def star(random, count):
    """A plane star-shaped polygon."""
    return [[r * math.cos(TURN * k / count), r * math.sin(TURN * k / count), 0.0]
            for k in range(count) for r in [random.uniform(0.5, 1.0)]]


def shoelace(ring_points):
    pairs = zip(ring_points, ring_points[1:] + ring_points[:1])
    return abs(math.fsum(a[0] * b[1] - a[1] * b[0] for a, b in pairs)) / 2


def states(pointer, value, relative=1e-9):
    """Expects a stated figure."""
    def check(outcome):
        if not outcome.succeeded:
            return f"failed with {outcome.error}: {outcome.detail[:160]}"
        stated = outcome.stated(pointer)
        if not isinstance(stated, (int, float)) or abs(stated - value) > relative * abs(value):
            return f"{pointer} is {stated}, and {value} is right"
    return check


def at_most(pointer, value):
    def check(outcome):
        if not outcome.succeeded:
            return f"failed with {outcome.error}: {outcome.detail[:160]}"
        if not (outcome.stated(pointer) or 0) <= value:
            return f"{pointer} is {outcome.stated(pointer)}, more than {value}"
    return check


def succeeds(outcome):
    if not outcome.succeeded:
        return f"failed with {outcome.error}: {outcome.detail[:160]}"


def refused_as(*kinds):
    def check(outcome):
        if outcome.succeeded:
            return f"was solved, and {' or '.join(kinds)} is right"
        if outcome.error not in kinds:
            return f"ended with {outcome.error}, and {' or '.join(kinds)} is right"
    return check


def has_pointer(prefix):
    def check(outcome):
        if not any(pointer.startswith(prefix) for pointer in outcome.pointers):
            return f"names {outcome.pointers[:3]}, and {prefix} is right"
    return check


def right_number_of_triangles(asked):
    def check(outcome):
        given = outcome.stated("/triangles")
        if outcome.succeeded and abs(given / asked - 1) > 0.1 and not outcome.warns("resolution_missed", "refined"):
            return f"{given} triangles for {asked} without a warning"
    return check


# Films.

@family
def film_wavy_loop(random):
    return Case(film([wavy(random, random.randint(5, 60))], random.choice([150, 300, 600])), ("moved", "first_point", "reversed", "scaled"), [succeeds])


@family
def film_skew_square(random):
    points = random.randint(1, 12)
    request = film([square(points, 1.0, random.uniform(0.1, 1.0))], random.choice([200, 500]))
    return Case(request, ("moved", "first_point", "finer"), [succeeds])


@family
def film_two_rings(random):
    count = random.randint(12, 36)
    gap = random.uniform(0.2, 1.0)
    request = film([ring(count), ring(count, 1.0, gap, phase=random.random())], random.choice([300, 600]))
    return Case(request, ("moved", "reordered"), [succeeds])


@family
def film_of_the_papers_solvers(random):
    request = film([square(random.randint(3, 8), 1.0, random.uniform(0.1, 0.6))], 200)
    solver = random.choice(["vertex_relaxation", "pinkall_polthier", "newton"])
    return Case({**request, "solver": solver}, ("default_solver",), [succeeds])


@family
def film_other_objectives(random):
    objective = random.choice(["minimal_dirichlet_energy", "minimal_mean_curvature"])
    return Case({**film([square(random.randint(3, 6), 1.0, random.uniform(0.1, 0.5))], 150), "objective": objective}, (), [succeeds])


@family
def film_three_rings_best(random):
    rings = [ring(14, random.uniform(0.5, 1.0), random.uniform(0.3, 0.6) * k, (random.uniform(-0.3, 0.3), 0)) for k in range(3)]
    return Case({**film(rings, 400), "topology": "best"}, ("moved", "reordered"))


def spiky(random, count):
    """A closed polygon with spikes and waves, near the unit circle."""
    every, height, bend = random.choice([1, 3, 4, 5]), random.uniform(0.3, 1.5), random.uniform(0.05, 0.4)
    waves, phase = random.randint(1, 4), random.uniform(0, TURN)
    points = []
    for k in range(count):
        a = TURN * k / count
        if every == 1:
            r = 1 + height * (1 + math.sin(5 * a + phase)) / 2
        else:
            r = 1 + (height if k % every == 0 else random.uniform(-0.05, 0.05))
        points.append([r * math.cos(a), r * math.sin(a), bend * math.sin(waves * a + phase) + random.uniform(-0.02, 0.02)])
    return points


def spiky_loops(random, numbers):
    """A polygon with spikes and as many others near it as are drawn from `numbers`, in any order and sense."""
    first = spiky(random, random.randint(12, 40))
    loops = [first]
    for k in range(random.choice(numbers)):
        base = first if random.random() < 0.7 else spiky(random, random.randint(12, 40))
        turn, gap, side = random.uniform(0, TURN), (k + 1) * random.uniform(0.0, random.choice([0.1, 0.5])), random.uniform(0, 0.2)
        cos, sin = math.cos(turn), math.sin(turn)
        loop = [[cos * x - sin * y + side, sin * x + cos * y, z + gap] for x, y, z in base]
        loops.append(loop[::-1] if random.random() < 0.5 else loop)
    random.shuffle(loops)
    return loops


@family
def fault_topologies_side_by_side(random):
    loops = spiky_loops(random, [1, 1, 1, 2])
    return Case({**film(loops, random.choice([1000, 2000, 3000])), "topology": "best"}, ("as_fixed", "as_free", "reordered"))


@family
def film_with_fixed_point(random):
    request = film([square(random.randint(2, 6))], 300)
    request["constraints"] = {"points": [[random.uniform(0.3, 0.7), random.uniform(0.3, 0.7), random.uniform(0.1, 0.5)]]}
    return Case(request, (), [succeeds])


@family
def film_plane_star(random):
    outline = star(random, random.randint(5, 24))
    return Case(film([outline], random.choice([200, 500])), ("moved", "first_point"), [states("/area", shoelace(outline), 1e-9)])


@family
def film_certified(random):
    request = film([square(random.randint(1, 4), 1.0, random.uniform(0.1, 0.6))], 200)
    return Case({**request, "certify": {"gap": 0.02, "seconds": 0.5}}, (), [succeeds])


@family
def film_far_from_zero(random):
    shift = [random.uniform(-1e7, 1e7) for _ in range(3)]
    points = [[a + b for a, b in zip(p, shift)] for p in wavy(random, random.randint(5, 30), r=random.uniform(1, 50))]
    return Case(film([points], 300), (), [succeeds])


@family
def film_of_any_scale(random):
    k = 10.0 ** random.uniform(-6, 6)
    points = [[k * x for x in p] for p in wavy(random, random.randint(5, 30))]
    return Case(film([points], 300), (), [succeeds])


# Strips.

STRIP_OBJECTIVES = ["minimal_area", "minimal_twist", "maximal_convexity", "minimal_bending_energy",
                    "minimal_mean_curvature_variation"]


def rail(random, count, y, lift=0.4):
    phase, wave = random.uniform(0, TURN), random.randint(1, 3)
    steps = [random.uniform(0.5, 1.5) for _ in range(count)]
    total, x, points = sum(steps), 0.0, []
    for step in steps:
        u = x / total
        points.append([4 * u, y + 0.2 * math.sin(wave * TURN * u + phase), lift * math.cos(wave * 3 * u + phase)])
        x += step
    return points


def strip(directrices, **options):
    return {"kind": "ruled_surface", "directrices": directrices, **options}


@family
def strip_open(random):
    request = strip([rail(random, random.randint(2, 40), 0), rail(random, random.randint(2, 40), 1)], objective=random.choice(STRIP_OBJECTIVES))
    if request["objective"] == "maximal_convexity" and random.random() < 0.6:
        request["secondary_objective"] = random.choice(["minimal_bending_energy", "minimal_mean_curvature_variation"])
    return Case(request, ("exchanged", "moved", "scaled"), [succeeds])


@family
def strip_closed(random):
    loops = [wavy(random, random.randint(3, 30)), wavy(random, random.randint(3, 30), 1.0)]
    return Case(strip(loops, closed=True, objective=random.choice(STRIP_OBJECTIVES)), ("moved", "first_point"), [succeeds])


@family
def strip_with_normals(random):
    rails = [rail(random, random.randint(3, 20), k) for k in (0, 1)]
    normals = [[[random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 1.0] for _ in one] for one in rails]
    return Case(strip(rails, objective="minimal_normal_variation", normals=normals), (), [succeeds])


@family
def strip_stack_with_caps(random):
    count = random.randint(4, 20)
    loops = [ring(count, random.uniform(0.5, 1.5), 0.7 * k) for k in range(random.randint(2, 4))]
    return Case(strip(loops, closed=True, caps=random.choice(["none", "flat"])), (), [succeeds])


@family
def strip_fan(random):
    apex = [[random.uniform(-1, 1), random.uniform(-1, 1), 2.0]]
    return Case(strip([apex, rail(random, random.randint(2, 200), 0)]), ("moved",), [succeeds])


@family
def strip_far_from_zero(random):
    shift = [random.uniform(-1e7, 1e7) for _ in range(3)]
    k = 10.0 ** random.uniform(0, 2)
    rails = [[[k * a + b for a, b in zip(p, shift)] for p in rail(random, random.randint(2, 20), y)] for y in (0, 1)]
    return Case(strip(rails, objective=random.choice(STRIP_OBJECTIVES)), (), [succeeds])


@family
def strip_of_any_scale(random):
    k = 10.0 ** random.uniform(-6, 6)
    rails = [[[k * x for x in p] for p in rail(random, random.randint(2, 20), y)] for y in (0, 1)]
    return Case(strip(rails, objective=random.choice(STRIP_OBJECTIVES)), (), [succeeds])


# Lattices.

def lattice(domain, edge_length, **options):
    return {"kind": "uniform_mesh", "domain": domain, "edge_length": edge_length, **options}


@family
def lattice_polygon(random):
    outline = [[10 * x for x in p] for p in ring(random.randint(4, 9), phase=random.random())]
    objective = random.choice(["fewest_nodes", "most_equal_edges"])
    return Case(lattice({"polygon": outline}, random.uniform(1.0, 3.0), objective=objective), ("scaled",), [succeeds])


@family
def lattice_with_hole(random):
    outline = [[0, 0, 0], [20, 0, 0], [20, 14, 0], [0, 14, 0]]
    hole = [[10 + 3 * x, 7 + 3 * y, 0] for x, y, _ in ring(random.randint(3, 8), phase=random.random())]
    return Case(lattice({"polygon": outline, "holes": [hole]}, random.uniform(1.0, 2.0), objective=random.choice(["fewest_nodes", "most_equal_edges"])), (), [succeeds])


@family
def lattice_on_bezier(random):
    control = [[[10 * i, 8 * j, random.uniform(0, 8)] for j in range(4)] for i in range(4)]
    return Case(lattice({"bezier": {"control_points": control}}, random.uniform(3, 5), objective=random.choice(["fewest_nodes", "most_equal_edges"])), (), [succeeds])


@family
def lattice_far_from_zero(random):
    shift = [random.uniform(-1e7, 1e7) for _ in range(2)] + [0.0]
    outline = [[10 * a + b for a, b in zip(p, shift)] for p in ring(random.randint(4, 9), phase=random.random())]
    return Case(lattice({"polygon": outline}, random.uniform(1.5, 3.0), objective="most_equal_edges"), (), [succeeds])


# Tensile structures and nets.

@family
def sail_with_cables(random):
    height = random.uniform(1, 4)
    corners = [[0, 0, 0], [10, 0, height], [10, 10, 0], [0, 10, height]]
    tension = random.uniform(0.5, 3)
    cables = [{"name": f"edge {k}", "along": {"from": k, "to": (k + 1) % 4}, "mode": "force", "value": tension * random.uniform(9, 20)}
              for k in range(4)]
    return Case({"kind": "tensile_structure", "boundaries": [corners], "film": {"tension": tension}, "cables": cables,
                 "resolution": {"triangles": random.choice([200, 500])}}, ("moved_sideways",))


@family
def inflated_ring(random):
    request = {"kind": "tensile_structure", "boundaries": [ring(random.randint(12, 40), 5.0)], "film": {"tension": 1.0},
               "pressure": random.uniform(0.02, 0.25), "resolution": {"triangles": 400}}
    return Case(request, ("first_point",), [succeeds])


@family
def sail_far_from_zero(random):
    case, shift = sail_with_cables(random), [random.uniform(-1e7, 1e7) for _ in range(3)]
    case.request["boundaries"] = [[[a + b for a, b in zip(p, shift)] for p in case.request["boundaries"][0]]]
    case.relations = ()
    return case


@family
def net_far_from_zero_or_of_any_scale(random):
    case, shift = net_of_squares(random), [random.choice([0, 1]) * random.uniform(-1e7, 1e7) for _ in range(3)]
    k = 10.0 ** random.uniform(-3, 4)
    case.request["vertices"] = [[k * a + b for a, b in zip(p, shift)] for p in case.request["vertices"]]
    case.relations = ()
    return case


@family
def lattice_of_any_scale(random):
    case, k = lattice_polygon(random), 10.0 ** random.uniform(-6, 6)
    case.request["domain"]["polygon"] = [[k * x for x in p] for p in case.request["domain"]["polygon"]]
    case.request["edge_length"] *= k
    case.relations = ()
    return case


@family
def sail_of_any_scale(random):
    case, k = sail_with_cables(random), 10.0 ** random.uniform(-6, 6)
    case.request["boundaries"] = [[[k * x for x in p] for p in case.request["boundaries"][0]]]
    for cable in case.request["cables"]:
        cable["value"] *= k
    case.relations = ()
    return case


@family
def net_of_squares(random):
    n = random.randint(3, 8)
    number = lambda i, j: i * (n + 1) + j
    vertices = [[float(i), float(j), random.uniform(0, 2) if i in (0, n) and j in (0, n) else 0.0] for i in range(n + 1) for j in range(n + 1)]
    edges = [[number(i, j), number(i + di, j + dj)] for i in range(n + 1) for j in range(n + 1) for di, dj in ((1, 0), (0, 1))
             if i + di <= n and j + dj <= n]
    supports = sorted({number(i, j) for i in range(n + 1) for j in range(n + 1) if i in (0, n) and j in (0, n)} |
                      {random.randrange(len(vertices)) for _ in range(2)})
    cables = [{"name": "all", "edges": list(range(len(edges))), "force_density": random.uniform(0.5, 5)}]
    request = {"kind": "cable_net", "vertices": vertices, "edges": edges, "supports": supports, "cables": cables}
    if random.random() < 0.5:
        request["loads"] = [{"vertices": [v], "force": [0.0, 0.0, -random.uniform(0, 0.2)]} for v in range(len(vertices))]
    return Case(request, ("moved_sideways",), [succeeds])


# Neighbours of requests that once ended wrongly.

@family
def fault_first_point_is_no_corner(random):
    points = random.randint(25, 60)
    height = random.choice([0.0, random.uniform(0.1, 0.5)])
    outline = square(points, 1.0, height, random.randrange(1, points))
    triangles = random.choice([2000, 3000])
    checks = [states("/area", 1.0)] if height == 0 else [succeeds]
    return Case(film([outline], triangles), (), checks)


@family
def fault_two_near_rings(random):
    count = random.choice([12, 24, 48])
    gap = 10.0 ** random.uniform(-5, -3)
    return Case({**film([ring(count), ring(count, 1.0, gap)], 300), "topology": random.choice(["fixed", "free"])}, (), [at_most("/area", TURN * gap * 2)])


@family
def fault_best_of_near_rings(random):
    count, gap = random.choice([12, 24]), 10.0 ** random.uniform(-4, -1.5)
    return Case({**film([ring(count), ring(count, 1.0, gap)], 300), "topology": "best"}, ("moved", "reordered"), [at_most("/area", TURN * gap * 2)])


@family
def fault_best_with_a_tiny_ring(random):
    r = 10.0 ** random.uniform(-3, -1)
    loops = [ring(32), ring(16, r, random.uniform(0.2, 1.0))]
    return Case({**film(loops, 600), "topology": "best"}, ("reordered",), [succeeds])


@family
def fault_borromean_rings(random):
    a, b, count = random.uniform(1.6, 2.0), random.uniform(0.8, 1.0), 24
    angles = [TURN * k / count for k in range(count)]
    loops = [[[a * math.cos(t), b * math.sin(t), 0.0] for t in angles], [[0.0, a * math.cos(t), b * math.sin(t)] for t in angles],
             [[b * math.sin(t), 0.0, a * math.cos(t)] for t in angles]]
    return Case({**film(loops, 300), "topology": "best"}, ("moved", "reordered"))


@family
def fault_rings_beyond_the_limit(random):
    """No connected film exists between rings of radii 1 and r this far apart."""
    r = 10.0 ** random.uniform(-1.5, 0)
    # The largest distance of a catenoid through both circles, over its waist.
    reach = lambda waist: waist * (math.acosh(1 / waist) + math.acosh(max(1.0, r / waist)))
    limit = max(reach(r * (0.001 + 0.999 * k / 2000)) for k in range(2001))
    gap = limit * random.uniform(1.05, 1.6)
    def check(outcome):
        if outcome.succeeded and outcome.stated("/components") == 1 and outcome.stated("/converged") and not outcome.warns("near_critical", "unstable", "stability_undecided"):
            return f"converged without a word at {gap / limit:.3f} of the limit (radius {r:.3f})"
    return Case(film([ring(48), ring(max(12, int(48 * r)), r, gap)], random.choice([600, 1200])), (), [check])


@family
def fault_certificate_of_many_rings(random):
    """Beyond six loops the bound covers every direction too: four annuli are not below it."""
    loops = []
    for k in range(4):
        loops += [ring(8, 1.0, 0.0, (4.0 * k, 0)), ring(8, 1.0, random.uniform(0.3, 0.6), (4.0 * k, 0))]
    def check(outcome):
        if outcome.succeeded and outcome.stated("/certificate/area_lower_bound") is not None:
            bound, annuli = outcome.stated("/certificate/area_lower_bound"), 4 * TURN * 0.6
            if bound > annuli:
                return f"a bound of {bound}, and four annuli have at most {annuli}"
    return Case({**film(loops, 400), "topology": "free", "certify": {"gap": 0.1, "seconds": 0.2}}, (), [check])


@family
def fault_canopy_with_near_sides(random):
    near = 10.0 ** random.uniform(-3.5, -2)
    outline = [[0, 0, 0], [1, 0, 0.3], [1, 1, 0], [0.5 + near, 1, 0.2], [0.5 + near, 0.5, 0.25], [0.5, 0.5, 0.25], [0.5, 1, 0.2], [0, 1, 0.4]]
    def check(outcome):
        if outcome.error == "self-intersecting-boundary":
            return "refused as crossing, and its sides do not cross"
    return Case(film([outline], 400), (), [check])


@family
def fault_unstable_catenoid_descends(random):
    count, gap = 24, random.uniform(0.5, 0.9)
    half = gap / 2
    # The waist of the unstable catenoid is the smaller solution of w cosh(half / w) = 1.
    low, high = half / 50, half / 1.19968
    value = lambda w: w * math.cosh(half / w) - 1
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if value(middle) > 0 else (low, middle)
    waist, rows = 0.5 * (low + high), 8
    vertices = [[waist * math.cosh(z / waist) * math.cos(TURN * k / count), waist * math.cosh(z / waist) * math.sin(TURN * k / count), z]
                for z in [half * (2 * i / rows - 1) for i in range(rows + 1)] for k in range(count)]
    triangles = []
    for i in range(rows):
        for k in range(count):
            a, b = i * count + k, i * count + (k + 1) % count
            triangles += [[a, b, b + count], [a, b + count, a + count]]
    loops = [vertices[:count], vertices[-count:]]
    # The initial mesh has the boundaries' points exactly.
    request = {"kind": "minimal_surface", "boundaries": loops, "initial_mesh": {"vertices": vertices, "triangles": triangles}, "on_unstable": "descend"}
    return Case(request, (), [succeeds])


@family
def fault_fans_of_many_points(random):
    apex = [[0.0, 0.0, 1.0]]
    return Case(strip([ring(random.randint(300, 900)), apex], closed=True), (), [succeeds])


@family
def fault_tiny_directrix(random):
    k = 10.0 ** random.uniform(-13, -9)
    tiny = [[k * x for x in p] for p in rail(random, random.randint(3, 8), 0)]
    return Case(strip([tiny, rail(random, 12, 1)], objective=random.choice(STRIP_OBJECTIVES)), (), [succeeds])


@family
def fault_rails_side_by_side(random):
    """Aligned rails must not be reversed."""
    n, width, rise = random.randint(2, 6), random.uniform(1, 4), random.uniform(0, 3)
    one = [[10.0 * i / (n - 1), 0.0, 0.0] for i in range(n)]
    other = [[10.0 * i / (n - 1), width, rise * i / (n - 1)] for i in range(n)]
    def check(outcome):
        if outcome.succeeded and (any(outcome.stated("/reversed")) or outcome.stated("/largest_fold_deg") > 90):
            return "aligned rails were reversed"
    return Case(strip([one, other], direction="auto"), (), [succeeds, check])


@family
def fault_aerofoils_that_run_alike(random):
    def foil(chord, z, count):
        thickness = random.uniform(0.08, 0.16)
        half = lambda x: 5 * thickness * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x ** 3 - 0.1036 * x ** 4)
        xs = [0.5 * (1 + math.cos(math.pi * k / count)) for k in range(count + 1)]
        upper = [[chord * x, chord * half(x), z] for x in xs]
        lower = [[chord * x, -chord * half(x), z] for x in reversed(xs[1:-1])]
        return upper + lower
    request = strip([foil(1.0, 0.0, random.randint(8, 16)), foil(random.uniform(0.4, 0.9), 2.0, random.randint(8, 16))], closed=True)
    def check(outcome):
        if outcome.warns("opposite_directions"):
            return "warned of opposite directions, and both aerofoils run alike"
    return Case(request, (), [succeeds, check])


@family
def fault_plane_holes_that_touch(random):
    x = random.uniform(0.8, 1.2)
    outline = [[0, 0, 0], [10, 0, 0], [10, 6, 0], [0, 6, 0]]
    holes = [[[2, 2, 0], [5, 3, 0], [2, 4, 0]], [[5, 3, 0], [5 + 2 * x, 2, 0], [5 + 2 * x, 4, 0]]]
    right = 60 - shoelace(holes[0]) - shoelace(holes[1])
    return Case(film([outline] + holes, 400), (), [states("/area", right, 1e-9)])


@family
def fault_plane_hole_that_touches_the_outline(random):
    y = random.uniform(2, 4)
    outline = [[0, 0, 0], [10, 0, 0], [10, y, 0], [10, 6, 0], [0, 6, 0]]
    hole = [[10, y, 0], [6, y + 1, 0], [6, y - 1, 0]]
    return Case(film([outline, hole], 400), (), [states("/area", 60 - shoelace(hole), 1e-9)])


@family
def fault_plane_holes_that_cross(random):
    outline = [[0, 0, 0], [10, 0, 0], [10, 6, 0], [0, 6, 0]]
    shift = random.uniform(0.5, 1.5)
    holes = [[[2, 2, 0], [5, 2, 0], [5, 4, 0], [2, 4, 0]], [[2 + shift, 1, 0], [4 + shift, 3, 0], [2 + shift, 5, 0]]]
    return Case(film([outline] + holes, 400), (), [refused_as("self-intersecting-boundary"), has_pointer("/boundaries")])


@family
def fault_roof_stored_to_a_millimetre(random):
    slope, turn = random.uniform(0.2, 1.0), random.uniform(0, TURN)
    outline = []
    for x, y, _ in ring(random.randint(4, 8), random.uniform(4, 9), phase=random.random()):
        outline.append([round(x, 3), round(y, 3), round(slope * (x * math.cos(turn) + y * math.sin(turn)), 3)])
    return Case(lattice({"polygon": outline}, random.uniform(1.0, 2.0), objective="fewest_nodes"), (), [succeeds])


@family
def fault_lattice_hole_on_a_slanted_side(random):
    t = random.uniform(0.2, 0.8)
    outline = [[0, 0, 0], [10, 0, 0], [10, 6, 0]]
    on = [10 * t, 6 * t, 0]
    hole = [on, [8, 1, 0], [9, 1, 0]]
    def check(outcome):
        if outcome.succeeded and outcome.stated("/edge_lengths/min") < 1e-6:
            return "an edge without length"
    return Case(lattice({"polygon": outline, "holes": [hole]}, 0.8, objective="fewest_nodes"), (), [check])


@family
def fault_best_of_small_pieces(random):
    loops = [ring(24, 1.0), ring(16, random.uniform(0.02, 0.2), 0.0, (random.uniform(3, 8), 0))]
    for p in loops[1]:
        p[2] = 0.01 * math.sin(3 * p[0])
    def check(outcome):
        if outcome.succeeded and outcome.stated("/converged") is not True:
            return f"not converged: residual {outcome.stated('/residual')}"
    return Case({**film(loops, 400), "topology": "best"}, (), [succeeds, check])


@family
def fault_fewer_triangles_than_asked(random):
    asked = random.choice([500, 1000, 2000])
    outline = [[0, 0, 0], [random.uniform(4, 30), 0, 0], [8, 1, 2], [0, 1, 0]]
    return Case(film([outline], asked), (), [succeeds, right_number_of_triangles(asked)])


@family
def fault_fixed_point_outside(random):
    request = film([square(3)], 200)
    request["constraints"] = {"points": [[0.5, 0.5, 0.0], [random.uniform(3, 9), 0.5, 0.0]]}
    def check(outcome):
        if not outcome.succeeded and not any(p.startswith("/constraints/points/1") for p in outcome.pointers):
            return f"names {outcome.pointers[:3]}, and /constraints/points/1 is right"
    return Case(request, (), [check])


@family
def fault_unequal_loop_sampled_with_its_end(random):
    loop = wavy(random, random.randint(8, 40))
    loop.append([x + random.uniform(-1, 1) * 1e-12 for x in loop[0]])
    return Case(film([loop], 300), (), [succeeds])


# Points that should be one, and parts of films that are flat.

def size_of(points):
    mean = [math.fsum(p[k] for p in points) / len(points) for k in range(3)]
    return max(math.dist(p, mean) for p in points)


def beside(random, point, distance):
    """A point at this distance; 0 stands for one unit in the last place."""
    if distance == 0:
        return [math.nextafter(x, math.inf) for x in point]
    way = [random.gauss(0, 1) for _ in range(3)]
    length = math.hypot(*way)
    return [x + distance * w / length for x, w in zip(point, way)]


def joins(distance):
    """Expects that an end at this fraction of the size from its point was joined, or that the message is about it."""
    def check(outcome):
        code = "joined" if distance <= 1e-7 else "nearly_joined"
        if outcome.succeeded and not outcome.warns(code):
            return f"an end {distance:g} of the size beside its point has no warning {code}"
        if not outcome.succeeded and (distance <= 1e-7 or "join" not in outcome.texts):
            return f"an end {distance:g} of the size beside its point ends with {outcome.error}: {outcome.texts[:160]}"
    return check


DISTANCES = [0, 1e-12, 1e-9, 1e-7, 1e-4, 1e-3]


@family
def fault_guide_beside_its_point(random):
    width, depth, rise = random.uniform(6, 10), random.uniform(6, 10), random.uniform(0.5, 2)
    outline = [[0, 0, 0], [width / 2, 0, 0], [width, 0, 0], [width, depth, 0], [width / 2, depth, 0], [0, depth, 0]]
    count = random.randint(3, 30)
    arch = [[width / 2, depth * k / count, rise * math.sin(math.pi * k / count)] for k in range(count + 1)]
    arch[0], arch[-1] = list(outline[1]), list(outline[4])
    distance, end = random.choice(DISTANCES), random.choice([0, -1])
    arch[end] = beside(random, arch[end], distance * size_of(outline + arch))
    return Case({**film([outline], random.choice([400, 1000])), "constraints": {"polylines": [arch]}}, (), [joins(distance)])


@family
def fault_guide_ends_on_a_side(random):
    width, depth, rise = random.uniform(6, 10), random.uniform(6, 10), random.uniform(0.5, 2)
    outline = [[0, 0, 0], [width, 0, 0], [width, depth, 0], [0, depth, 0]]
    x, count = random.uniform(0.1, 0.9) * width, random.randint(3, 30)
    arch = [[x, depth * k / count, rise * math.sin(math.pi * k / count)] for k in range(count + 1)]
    arch[0][2] = arch[-1][2] = 0
    return Case({**film([outline], 500), "constraints": {"polylines": [arch]}}, (), [succeeds])


@family
def fault_level_guide(random):
    outline = ring(random.choice([4, 8, 40]), random.uniform(8, 12))
    guide = ring(random.choice([3, 6, 30]), random.uniform(2, 3.5), random.uniform(0.3, 2),
                 (random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)), random.random())
    guide.append(guide[0])
    return Case({**film([outline], random.choice([500, 2000])), "constraints": {"polylines": [guide]}}, (), [succeeds])


@family
def fault_half_flat_roof(random):
    width, depth = random.uniform(2, 6), random.uniform(5, 10)
    end = width + random.uniform(2, 6)
    roof = [[0, 0, 0], [width, 0, 0], [end, 0, random.uniform(0.5, 3)], [end, depth, random.uniform(0.5, 3)], [width, depth, 0],
            [0, depth, 0]]
    request = {**film([roof], random.choice([500, 2000])), "constraints": {"polylines": [[roof[1], roof[4]]]}}
    return Case(request, (), [succeeds])


@family
def fault_guy_beside_its_corner(random):
    case = sail_with_cables(random)
    corners = case.request["boundaries"][0]
    corner, anchor = corners[1], [13, -3, corners[1][2]]
    distance = random.choice(DISTANCES)
    far = size_of(corners + [anchor, [10.5, -6, 0]])
    guys = [[corner, anchor], [beside(random, corner, distance * far), [10.5, -6, 0]]]
    # The edges are strong enough to keep every corner open, and the guys pull as much as two edges at 90 degrees.
    for cable in case.request["cables"]:
        cable["value"] *= 2
    pull = 0.7 * sum(cable["value"] for cable in case.request["cables"][:2])
    case.request["cables"] += [{"points": ends, "value": pull * share} for ends, share in zip(guys, (0.75, 0.25))]
    case.request["free_points"] = [{"point": 1}]
    return Case(case.request, (), [joins(distance)])


@family
def fault_mast_beside_its_corner(random):
    case = sail_with_cables(random)
    corners, tension = case.request["boundaries"][0], case.request["film"]["tension"]
    corner, distance = corners[1], random.choice(DISTANCES)
    far = size_of(corners + [[10, 0, 0], [14, -4, 0]])
    case.request["masts"] = [{"points": [[10, 0, 0], beside(random, corner, distance * far)], "value": corner[2]}]
    case.request["cables"].append({"points": [corner, [14, -4, 0]], "value": tension * 25})
    case.request["free_points"] = [{"point": 1}]
    return Case(case.request, (), [joins(distance)])


# The way in: strips, nets, sails and patches with a closed form.

@family
def fault_plane_strip_of_most_convex_bridges(random):
    """Every bridge of a plane strip is convex, also where it is folded upon itself. The flat one is right."""
    motion = Motion(random, 5.0)
    place = lambda points: [list(motion(p)) for p in points]
    if random.random() < 0.5:
        closed, sides = True, random.randint(3, 9)
        outer, inner = ring(sides, 2.0, phase=random.random()), ring(random.randint(3, 24), 0.7, phase=random.random())
        area = shoelace(outer) - shoelace(inner)
    else:
        closed = False
        arc = lambda r, count: [[r * math.cos(k / (count - 1)), r * math.sin(k / (count - 1)), 0.0] for k in range(count)]
        inner, outer = arc(1.0, random.randint(2, 24)), arc(random.uniform(1.2, 3.0), random.randint(2, 24))
        # A coarse outer arc would cut the inner one.
        outer = arc(math.hypot(*outer[0][:2]) * 1.2, random.randint(8, 24))
        area = shoelace(outer + inner[::-1])
    options = {"objective": "maximal_convexity", "closed": closed}
    secondary = random.choice([None, "minimal_bending_energy", "minimal_mean_curvature_variation"])
    if secondary:
        options["secondary_objective"] = secondary
    checks = [states("/area", area, 1e-9), at_most("/largest_fold_deg", 1e-4)]
    return Case(strip([place(inner), place(outer)], **options), (), checks)


@family
def fault_profile_with_a_sharp_edge(random):
    """The fold at a trailing edge is the profile's own."""
    half = lambda x, t: 5 * t * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x ** 3 - 0.1036 * x ** 4)
    count, thickness = random.randint(8, 24), random.uniform(0.08, 0.2)
    xs = [0.5 * (1 + math.cos(math.pi * k / count)) for k in range(count + 1)]
    foil = lambda chord, z: [[chord * (x - 0.3), chord * half(x, thickness), z] for x in xs] + \
        [[chord * (x - 0.3), -chord * half(x, thickness), z] for x in reversed(xs[1:-1])]
    sections = [foil(1.0 - 0.1 * k, 1.5 * k) for k in range(random.randint(2, 4))]
    def check(outcome):
        if outcome.warns("folds"):
            return "warned of folds at the profile's own sharp edge"
    return Case(strip(sections, closed=True), (), [succeeds, check])


@family
def fault_hoops_up_to_a_limit(random):
    """Radial cables of density q between two rings, and hoops of force F between them: with q s = 2 F sin(π / n) the
    radii are a + (b - a) k / m - s k (m - k) / 2, and no net has a hoop for which one of them is negative."""
    n, m, q = random.choice([8, 12, 16]), random.randint(3, 7), random.uniform(0.5, 5)
    a, b, height = random.uniform(0.8, 2.0), random.uniform(4.0, 8.0), random.uniform(0.0, 4.0)
    limit = min((a + (b - a) * k / m) * 2 / (k * (m - k)) for k in range(1, m))
    s = limit * random.choice([random.uniform(0.2, 0.95), random.uniform(1.05, 20)])
    at = lambda r, z, j: [r * math.cos(TURN * j / n), r * math.sin(TURN * j / n), z]
    vertices = [at(a + (b - a) * k / m, height * (1 - k / m), j) for k in range(m + 1) for j in range(n)]
    radial = [[k * n + j, (k + 1) * n + j] for k in range(m) for j in range(n)]
    hoops = [[k * n + j, k * n + (j + 1) % n] for k in range(1, m) for j in range(n)]
    sine = math.sin(math.pi / n)
    request = {"kind": "cable_net", "vertices": vertices, "edges": radial + hoops,
               "supports": list(range(n)) + list(range(m * n, (m + 1) * n)),
               "cables": [{"name": "radial", "edges": list(range(len(radial))), "force_density": q},
                          {"name": "hoop", "edges": list(range(len(radial), len(radial + hoops))), "force": q * s / (2 * sine)}]}
    if s > limit:
        return Case(request, (), [refused_as("targets-not-reached"), has_pointer("/edges/")])
    least = min(a + (b - a) * k / m - s * k * (m - k) / 2 for k in range(1, m))
    return Case(request, (), [states("/cables/1/edge_lengths/min", 2 * least * sine, 2e-2)])


@family
def fault_sags_of_unequal_edges(random):
    """An edge of a plane sail is an arc of radius F / σ, so its sag determines its force."""
    angles = sorted(random.uniform(0, TURN) for _ in range(5))
    while min((b - a) % TURN for a, b in zip(angles, angles[1:] + angles[:1])) < 0.15 or \
            max((b - a) % TURN for a, b in zip(angles, angles[1:] + angles[:1])) > 2.5:
        angles = sorted(random.uniform(0, TURN) for _ in range(5))
    corners = [[8 * math.cos(a), 8 * math.sin(a), 0.0] for a in angles]
    chords = [math.dist(corners[k], corners[(k + 1) % 5]) for k in range(5)]
    sags = [random.uniform(0.04, 0.12) * chord for chord in chords]
    cables = [{"name": f"edge {k}", "along": {"from": k, "to": (k + 1) % 5}, "mode": "sag", "value": sags[k]} for k in range(5)]
    request = {"kind": "tensile_structure", "boundaries": [corners], "film": {"tension": 1.0}, "cables": cables}
    right = [(c * c / 4 + s * s) / (2 * s) for c, s in zip(chords, sags)]
    return Case(request, (), [states(f"/cables/{k}/force", right[k], 1e-2) for k in range(5)])


@family
def fault_sail_whose_corners_close(random):
    """By Gauss and Bonnet the edge cables of a sail between four points turn by less than a whole turn."""
    height, tension = random.uniform(0.2, 4.0), random.uniform(0.5, 3.0)
    corners = [[0, 0, 0], [10, 0, height], [10, 10, 0], [0, 10, height]]
    force = tension * random.uniform(6.0, 9.0)
    cables = [{"name": f"edge {k}", "along": {"from": k, "to": (k + 1) % 4}, "mode": "force", "value": force} for k in range(4)]
    request = {"kind": "tensile_structure", "boundaries": [corners], "film": {"tension": tension}, "cables": cables,
               "resolution": {"triangles": random.choice([300, 800, 2000])}}
    def check(outcome):
        if outcome.succeeded:
            turn = sum(tension * outcome.stated(f"/cables/{k}/length") / outcome.stated(f"/cables/{k}/force") for k in range(4))
            if turn > TURN + 0.01:
                return f"its cables turn by {turn:.3f}, and a film lets them turn by {TURN:.3f}"
        elif outcome.error != "no-equilibrium":
            return f"ended with {outcome.error}, and no-equilibrium is right"
    return Case(request, (), [check])


@family
def fault_way_out_and_back(random):
    """A boundary that runs out and back passes points twice, which are named."""
    outline = square(3, 1.0, random.uniform(0.1, 0.6))
    k = random.randrange(len(outline))
    way = [[x + random.uniform(-0.4, 0.4) for x in outline[k]] for _ in range(random.randint(1, 3))]
    points = outline[:k + 1] + way + way[-2::-1] + [outline[k]] + outline[k + 1:]
    return Case(film([points], 300), (), [refused_as("invalid-request"), has_pointer(f"/boundaries/0/{k + len(way)}")])


@family
def fault_a_single_triangle(random):
    corners = [[random.uniform(-1, 1) for _ in range(3)] for _ in range(3)]
    request = film([corners], 1, initial_mesh=random.choice(["auto", "planar", "rings"]))
    return Case(request, (), [states("/triangles", 1), states("/vertices", 3)])
# Tensile structures whose right results were withheld or denied.

def converges(outcome):
    if not outcome.succeeded:
        return f"failed with {outcome.error}: {outcome.detail[:160]}"
    if outcome.stated("/converged") is not True:
        return f"not converged: residual {outcome.stated('/residual')}, {outcome.stated('/stop_reason')}"


def never_denied(outcome):
    if outcome.error == "no-equilibrium":
        return f"denied: {outcome.detail[:160]}"


def tensile(boundaries, tension=1.0, triangles=None, **options):
    request = {"kind": "tensile_structure", "boundaries": boundaries, "film": {"tension": tension}, **options}
    return {**request, "resolution": {"triangles": triangles}} if triangles else request


def along(k, count, mode, value, **options):
    return {"name": f"e{k}", "along": {"from": k, "to": (k + 1) % count}, "mode": mode, "value": value, **options}


def corners(random, count):
    """Corners of a sail, and for each side the force with which its cable forms an arc under a tension of 1."""
    points = []
    for k in range(count):
        angle, r = TURN * (k + random.uniform(-0.2, 0.2)) / count, random.uniform(3.5, 6.5)
        points.append([r * math.cos(angle), r * math.sin(angle), random.uniform(0, 3.5) * ((k + 1) % 2)])
    def angle(k):
        a, b = ([p - q for p, q in zip(points[(k + d) % count], points[k])] for d in (-1, 1))
        return math.acos(sum(p * q for p, q in zip(a, b)) / math.dist(a, [0] * 3) / math.dist(b, [0] * 3))
    forces = []
    for k in range(count):
        half = 0.5 * min(angle(k), angle((k + 1) % count), 2.4) * random.uniform(0.3, 0.85)
        forces.append(0.5 * math.dist(points[k], points[(k + 1) % count]) / math.sin(half))
    return points, forces


def towards(a, b):
    length = math.dist(a, b)
    return [(q - p) / length for p, q in zip(a, b)]


@family
def fault_noisy_frame(random):
    """A film in a closed frame whose points are measured with noise. A film of least area exists for every loop."""
    count, noise = random.randint(20, 150), random.uniform(0, 0.3)
    waves = [(random.randint(2, 4), random.uniform(0, 1.2), random.uniform(0, TURN)) for _ in range(2)]
    loop = []
    for k in range(count):
        a = TURN * k / count
        r = 5 * (1 + 0.1 * waves[0][1] * math.sin(waves[0][0] * a + waves[0][2])) + random.uniform(-noise, noise)
        z = sum(h * math.sin(n * a + p) for n, h, p in waves) + random.uniform(-noise, noise)
        loop.append([r * math.cos(a), r * math.sin(a), z])
    return Case(tensile([loop], random.uniform(0.5, 3), random.choice([None, 500, 1500])), (), [converges])


@family
def fault_conic_tent_in_rigid_frame(random):
    count = random.randint(4, 7)
    outline = [[5 * math.cos(TURN * k / count), 5 * math.sin(TURN * k / count), random.uniform(-1, 1)] for k in range(count)]
    loops, level = [outline], sum(z for _, _, z in outline) / count
    for k in range(random.choice([1, 2])):
        x = 0 if k == 0 and random.random() < 0.5 else (-1) ** k * random.uniform(1.5, 2.2)
        if k == 1 and loops[1][0][0] * x > 0:
            continue
        tilt, turn, r = random.uniform(0, 0.3), random.uniform(0, TURN), random.uniform(0.5, 1.0)
        # No film exists where a ring of radius 0.5 is 2.9 radii above the outline, or one of radius 1 is 2.6.
        top = min(1.2, level + 2.2 * r)
        loops.append([[x + r * math.cos(a), random.uniform(-0.1, 0.1) + r * math.sin(a), top + tilt * r * math.cos(a + turn)]
                      for a in (TURN * j / 14 for j in range(14))])
    return Case(tensile(loops, random.uniform(0.5, 3), random.choice([None, 800])), (), [never_denied])


@family
def fault_sail_with_crossing_ridges(random):
    points, forces = corners(random, 4)
    sides = [along(k, 4, "force", force) for k, force in enumerate(forces)]
    middle = [0.25 * sum(p[axis] for p in points) for axis in range(3)]
    ridges = [{"name": f"r{k}", "across": [points[k], middle, points[k + 2]], "mode": "force", "value": random.uniform(1, 12)} for k in (0, 1)]
    return Case(tensile([points], 1.0, random.choice([300, 800]), cables=sides + ridges), (), [never_denied])


@family
def fault_sail_on_a_flying_mast(random):
    count = random.randint(4, 7)
    points, forces = corners(random, count)
    top = max(p[2] for p in points) * 0.5
    height, r = top + random.uniform(0.8, 1.8), random.uniform(0.6, 1.2)
    loop = [[x, y, height] for x, y, _ in ring(random.choice([16, 22]), r)][::-1]
    hub = [0.0, 0.0, height]
    cables = [along(k, count, "force", force) for k, force in enumerate(forces)]
    foot = [random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), top - 2.0]
    options = {"rings": [{"boundary": 1, "axis": [0, 0, 1], "hub": hub}]}
    if random.random() < 0.5:
        options["joints"] = [foot]
        cables += [{"name": f"s{k}", "points": [foot, p], "mode": "force", "value": random.uniform(9, 16)} for k, p in enumerate(points)]
    options["masts"] = [{"points": [foot, hub], "mode": "length", "value": math.dist(foot, hub)}]
    return Case(tensile([points, loop], 1.0, random.choice([60, 200, 400, 1000]), cables=cables, **options), (), [never_denied])


@family
def fault_sail_with_sliding_corners(random):
    count = random.randint(3, 7)
    points, forces = corners(random, count)
    cables = [along(k, count, "force", force) for k, force in enumerate(forces)]
    supports = []
    for k in random.sample(range(count), random.randint(1, 2)):
        here, before, after = points[k], points[k - 1], points[(k + 1) % count]
        pull = [f * a + g * b for a, b in zip(towards(here, before), towards(here, after)) for f, g in [(forces[k - 1], forces[k])]]
        out = [-x / math.dist(pull, [0] * 3) for x in pull]
        radius = random.uniform(3, 8)
        level = towards([0, 0, 0], [out[0], out[1], 0])
        on = random.choice([
            {"line": {"point": here, "direction": [-level[1], level[0], 0.0]}},
            {"sphere": {"centre": [h + radius * o for h, o in zip(here, out)], "radius": radius}},
            {"plane": {"point": here, "normal": out}}])
        # The pull of the two sides is perpendicular to the support, so that the corner is near its equilibrium.
        supports.append({"point": {"boundary": 0, "point": k}, "on": on})
    return Case(tensile([points], 1.0, random.choice([200, 400, 800]), cables=cables, supports=supports))


@family
def fault_arch_of_many_points(random):
    """A frame with more points than the first coarse mesh has triangles, and one edge on a cable."""
    count, height, depth = random.randint(350, 500), random.uniform(2, 5), random.uniform(5, 9)
    loop = [[5 * math.cos(math.pi * k / count), 0.0, height * math.sin(math.pi * k / count)] for k in range(count + 1)]
    loop += [[-5.0, depth, 0.0], [5.0, depth, 0.0]]
    side = {"along": {"from": count + 1, "to": count + 2}, "mode": "force", "value": random.uniform(8, 15)}
    return Case(tensile([loop], 1.0, 2000, cables=[side]), (), [converges])


@family
def fault_ridge_of_given_length(random):
    """A saddle with a ridge or a valley, whose length is a little more than its chord."""
    height = random.uniform(0.5, 2)
    points = [[0, 0, 0], [10, 0, height], [10, 10, 0], [0, 10, height]]
    cables = [along(k, 4, "force", random.uniform(7.5, 14)) for k in range(4)]
    first = random.choice([0, 1])
    chord = math.dist(points[first], points[first + 2])
    length = chord * (1 + 10 ** random.uniform(-4, -2.5))
    cables.append({"name": "ridge", "across": [points[first], points[first + 2]], "mode": "length", "value": length})
    def check(outcome):
        # The film alone may draw the line to less than this length.
        return None if outcome.error == "slack-cable" else converges(outcome)
    return Case(tensile([points], 1.0, random.choice([None, 400, 1000]), cables=cables), (), [check])


@family
def fault_tube(random):
    """A cylinder is in equilibrium under the pressure σ / R, stable up to the length π R, and with its volume up to 2 π R."""
    r, count, tension = random.uniform(0.5, 3), random.choice([24, 32, 40]), random.uniform(0.5, 2)
    by_pressure = random.random() < 0.5
    length = r * (random.uniform(1.0, 2.7) if by_pressure else random.uniform(1.0, 5.2))
    loops = [ring(count, r), ring(count, r, length)]
    # The polygon's own radius of balance.
    side, face = 2 * r * math.sin(math.pi / count), shoelace(loops[0])
    options = {"pressure": tension * count * side / 2 / face} if by_pressure else {"volume": face * length}
    return Case(tensile(loops, tension, random.choice([800, 1500]), **options), (), [states("/area", count * side * length, 0.02)])


@family
def fault_gap_of_coaxial_rings(random):
    """The largest catenoid between circles of radius 1 and r has the height max c (acosh(1 / c) + acosh(r / c))."""
    r = random.uniform(0.1, 0.9)
    largest = max(c * (math.acosh(1 / c) + math.acosh(max(1, r / c))) for c in [r * k / 4000 for k in range(1, 4001)])
    fraction = random.uniform(0.3, 0.95)
    request = film([ring(64), ring(random.choice([32, 48]), r, largest / fraction)], random.choice([300, 600, 2000]))
    def check(outcome):
        found = outcome.stated("/spanning/largest_gap_fraction")
        # The cone refuses wide gaps at once, and the fraction is null.
        if outcome.succeeded and found is not None and abs(found / fraction - 1) > 0.02:
            return f"largest_gap_fraction is {found}, and {fraction} is right"
    return Case({**request, "topology": "best"}, (), [succeeds, check])


@family
def fault_woven_cone(random):
    """On the cone of two rings sin φ = (c / r)^k with the slope φ of the meridian and the ratio k of weft to warp."""
    k, inner, outer, steps = random.uniform(0.2, 0.9), random.uniform(0.8, 2.0), random.uniform(6.0, 10.0), 2000
    c = inner * random.uniform(0.2, 0.75)
    height = area = 0.0
    for i in range(steps):
        r = inner + (outer - inner) * (i + 0.5) / steps
        sine = (c / r) ** k
        height += sine / math.sqrt(1 - sine * sine) * (outer - inner) / steps
        area += TURN * r / math.sqrt(1 - sine * sine) * (outer - inner) / steps
    stresses = {"warp": 4.0, "weft": 4.0 * k, "direction": {"radial": {"point": [0, 0, 0], "axis": [0, 0, 1]}}}
    request = {"kind": "tensile_structure", "boundaries": [ring(64, outer), ring(32, inner, height)],
               "film": stresses, "resolution": {"triangles": random.choice([1000, 3000])}}
    return Case(request, (), [states("/area", area, 0.02)])


@family
def fault_stiff_edge_cables(random):
    """Each edge is an arc of its unstressed length, and its force is the arc's radius times the tension of 1."""
    size, bend = random.uniform(1, 20), random.uniform(0.1, 0.6)
    length = size * bend / math.sin(bend)
    force = size / (2 * math.sin(bend))
    cables = [along(k, 4, "unstressed_length", length) for k in range(4)]
    for cable in cables:
        cable["axial_stiffness"] = force * 10 ** random.uniform(5, 9)
    request = tensile([[[0, 0, 0], [size, 0, 0], [size, size, 0], [0, size, 0]]], 1.0, random.choice([400, 800]), cables=cables)
    return Case(request, (), [states("/cables/0/force", force, 0.02)])


@family
def fault_woven_plane_sail(random):
    """A plane woven sail with sharp corners. Scaled by √weft along the warp and by √warp across it, it is a sail of equal
    stresses, so that its edges are arcs of ellipses, and the corners stay open if those of the other sail do."""
    count = random.randint(3, 5)
    points, _ = corners(random, count)
    warp, weft, turn = 10 ** random.uniform(-0.5, 0.5), 10 ** random.uniform(-0.5, 0.5), random.uniform(0, math.pi)
    cos, sin = math.cos(turn), math.sin(turn)
    scaled = [[math.sqrt(weft) * (cos * x + sin * y), math.sqrt(warp) * (cos * y - sin * x)] for x, y, _ in points]
    def angle(k):
        a, b = (towards(scaled[k], scaled[(k + d) % count]) for d in (-1, 1))
        return math.acos(a[0] * b[0] + a[1] * b[1])
    cables, outside = [], 0.0
    for k in range(count):
        half = random.uniform(0.3, 0.42) * min(angle(k), angle((k + 1) % count), 2.4)
        a, b = scaled[k], scaled[(k + 1) % count]
        radius, inwards = math.dist(a, b) / (2 * math.sin(half)), math.atan2(b[0] - a[0], a[1] - b[1])
        # The force times the element of length, and the element of length, along the arc.
        turns = [inwards + half * (2 * (i + 0.5) / 200 - 1) for i in range(200)]
        force = [radius * math.hypot(math.sqrt(warp) * math.sin(t), math.sqrt(weft) * math.cos(t)) for t in turns]
        step = [math.hypot(math.sin(t) / math.sqrt(weft), math.cos(t) / math.sqrt(warp)) for t in turns]
        cables.append(along(k, count, "force", math.fsum(f * s for f, s in zip(force, step)) / math.fsum(step)))
        outside += radius * radius * (half - math.sin(half) * math.cos(half))
    request = tensile([[[x, y, 0.0] for x, y, _ in points]], 1.0, random.choice([800, 1500, 3000]), cables=cables)
    area = abs(shoelace([[x, y, 0.0] for x, y in scaled]) - outside) / math.sqrt(warp * weft)
    request["film"] = {"warp": warp, "weft": weft, "direction": {"parallel": [cos, sin, 0.0]}}
    return Case(request, (), [converges, states("/area", area, 0.02)])


@family
def fault_edge_of_given_horizontal_component(random):
    """A sail in a tilted plane, whose edges are arcs under one force. The part across the up axis is given at each first end."""
    size, bend, tilt, turn = random.uniform(1, 20), random.uniform(0.1, 0.5), random.uniform(0, 1.3), random.uniform(0, TURN)
    def placed(x, y):
        y, z = y * math.cos(tilt), y * math.sin(tilt)
        return [x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn), z]
    force = size / (2 * math.sin(bend))
    points = [placed(*p) for p in [(0, 0), (size, 0), (size, size), (0, size)]]
    cables = []
    for k in range(4):
        direction = k * math.pi / 2 + bend
        x, y, _ = placed(math.cos(direction), math.sin(direction))
        cables.append(along(k, 4, "horizontal_component", force * math.hypot(x, y)))
    request = tensile([points], 1.0, random.choice([400, 800]), cables=cables)
    return Case(request, (), [converges] + [states(f"/cables/{k}/force", force, 0.02) for k in range(4)])


def solved_linear(rows, right):
    """Solves a small linear system by elimination; `right` has a vector for each row."""
    rows = [row + list(r) for row, r in zip(rows, right)]
    for k in range(len(rows)):
        best = max(range(k, len(rows)), key=lambda i: abs(rows[i][k]))
        rows[k], rows[best] = rows[best], rows[k]
        for i in range(len(rows)):
            if i != k:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    return [[x / rows[k][k] for x in rows[k][len(rows):]] for k in range(len(rows))]


@family
def fault_net_of_few_steps(random):
    """A net whose number of steps is limited. Its lengths and forces are a little beside those of a net in equilibrium."""
    fixed, free = random.randint(4, 7), random.randint(6, 12)
    edges = {(a, random.randrange(fixed)) for a in range(fixed, fixed + free)}
    for a in range(fixed + 1, fixed + free):
        edges |= {(a, random.randrange(fixed, a)), (a, random.randrange(a))}
    edges = sorted(map(list, edges))
    supports = [[random.uniform(-4, 4) for _ in range(3)] for _ in range(fixed)]
    force = [[random.uniform(-0.5, 0.5) for _ in range(3)] for _ in range(free)]
    densities = [random.uniform(0.3, 3) for _ in edges]
    # The force density method (Schek, 1974): the balance of each free vertex is linear in the places.
    rows, right = [[0.0] * free for _ in range(free)], [list(f) for f in force]
    for (a, b), q in zip(edges, densities):
        for here, there in ((a - fixed, b - fixed), (b - fixed, a - fixed)):
            if here >= 0:
                rows[here][here] += q
                if there >= 0:
                    rows[here][there] -= q
                else:
                    right[here] = [r + q * x for r, x in zip(right[here], supports[there + fixed])]
    vertices = supports + solved_linear(rows, right)
    cables = []
    for k, ((a, b), q) in enumerate(zip(edges, densities)):
        length, beside = math.dist(vertices[a], vertices[b]), random.uniform(0.9, 1.1)
        goal = random.choice([{}, {"length": length * beside}, {"force": q * length * beside}])
        cables.append({"name": f"c{k}", "edges": [k], **goal})
    start = supports + [[x + random.uniform(-0.5, 0.5) for x in vertex] for vertex in vertices[fixed:]]
    loads = [{"vertices": [fixed + k], "force": f} for k, f in enumerate(force)]
    request = {"kind": "cable_net", "vertices": start, "edges": edges, "supports": list(range(fixed)), "cables": cables, "loads": loads,
               "tolerance": 1e-9, "max_iterations": random.choice([400, 2000])}
    return Case(request, ("as_many_steps_as_needed",), [])


@family
def fault_scan_of_many_points(random):
    """A rim that was scanned with more points than its noise allows, so that it turns to and fro."""
    count, radius = random.randint(300, 700), random.uniform(20, 100)
    noise = random.uniform(0.0, 0.4) * TURN * radius / count
    waves = [(random.randint(2, 5), random.uniform(0, 0.1) * radius, random.uniform(0, TURN)) for _ in range(2)]
    rim = []
    for k in range(count):
        a = TURN * k / count + random.uniform(-noise, noise) / radius
        z = sum(h * math.sin(n * a + p) for n, h, p in waves) + random.uniform(-noise, noise)
        r = radius + random.uniform(-noise, noise)
        rim.append([r * math.cos(a), r * math.sin(a), z])
    return Case(film([rim], random.choice([2000, 4000])), (), [converges])


@family
def fault_topologies_of_large_meshes(random):
    """Above 4,000 triangles the topologies are compared on coarse meshes first."""
    loops = spiky_loops(random, [1])
    return Case({**film(loops, random.randint(4500, 9000)), "topology": "best"}, ("as_fixed", "as_free", "reordered"))
