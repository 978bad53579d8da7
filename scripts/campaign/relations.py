"""Relations between the results of two requests that mean the same surface.

Each function takes a random generator and a request and returns the other request, with the factor by which its area or
objective differs, or `None` where the relation does not apply. `agree` compares the two outcomes.
"""

import copy

from geometry import Motion, radius

# Members of each kind that hold polylines.
POLYLINES = {"minimal_surface": "boundaries", "ruled_surface": "directrices", "tensile_structure": "boundaries", "cable_net": "vertices"}
RELATIONS = {}


def relation(function):
    RELATIONS[function.__name__] = function
    return function


def lists(request):
    member = POLYLINES.get(request["kind"])
    return None if member is None else request[member]


def mapped(request, to):
    """Maps every point of a request."""
    other = copy.deepcopy(request)
    member = POLYLINES.get(request["kind"])
    if member is None:
        rings = [other["domain"]["polygon"]] + other["domain"].get("holes", [])
        for ring in rings:
            ring[:] = [list(to(p)) for p in ring]
    elif member == "vertices":
        other[member] = [list(to(p)) for p in other[member]]
    else:
        other[member] = [[list(to(p)) for p in line] for line in other[member]]
    return other


@relation
def moved(random, request):
    size = max(radius(line) for line in lists(request))
    return mapped(request, Motion(random, 3 * size)), 1.0


@relation
def moved_sideways(random, request):
    shift = [random.uniform(-50, 50) for _ in range(3)]
    return mapped(request, lambda p: [a + b for a, b in zip(p, shift)]), 1.0


@relation
def scaled(random, request):
    # A power of two changes no digit. Areas grow by its square, energies and counts by other powers.
    k = 2.0 ** random.choice([-12, -3, 4, 15])
    other = mapped(request, lambda p: [k * x for x in p])
    powers = {"minimal_area": 2, "minimal_mean_curvature_variation": 1}
    if request["kind"] == "uniform_mesh":
        other["edge_length"] = k * request["edge_length"]
        return other, 1.0
    return other, k ** powers.get(request.get("objective", "minimal_area"), 0)


@relation
def reordered(random, request):
    other = copy.deepcopy(request)
    random.shuffle(other["boundaries"])
    return other, 1.0


@relation
def as_fixed(random, request):
    return {**copy.deepcopy(request), "topology": "fixed"}, 1.0


@relation
def as_free(random, request):
    return {**copy.deepcopy(request), "topology": "free"}, 1.0


@relation
def reversed(random, request):
    other = copy.deepcopy(request)
    other["boundaries"] = [line[::-1] for line in other["boundaries"]]
    return other, 1.0


@relation
def first_point(random, request):
    other = copy.deepcopy(request)
    member = POLYLINES[request["kind"]]
    other[member] = [line[k:] + line[:k] for line in other[member] for k in [random.randrange(len(line))]]
    return other, 1.0


@relation
def exchanged(random, request):
    # Only the count of the coupled curvature variation survives the exchange.
    return {**copy.deepcopy(request), "directrices": copy.deepcopy(request["directrices"])[::-1]}, 1.0


@relation
def finer(random, request):
    other = copy.deepcopy(request)
    other["resolution"] = {"triangles": 3 * request["resolution"]["triangles"]}
    return other, 1.0


@relation
def default_solver(random, request):
    other = copy.deepcopy(request)
    del other["solver"]
    return other, 1.0


@relation
def as_many_steps_as_needed(random, request):
    other = copy.deepcopy(request)
    del other["max_iterations"], other["tolerance"]
    return other, 1.0


# Relative difference of the areas of two meshes of one film that is not the mesh's own error. A film's own error is in
# `extrapolated_area`, and falls with the square of the edge length.
FILM = 1e-6
# Papers' own solvers stop by the change of the area.
OTHER_SOLVER = 5e-3
# Optima of strips are the same path, or one of equal value.
STRIP = 1e-9


def error_of(outcome):
    """Returns an estimate of the error of a film's area: of its mesh, not of its solver."""
    extrapolated = outcome.stated("/extrapolated_area/area")
    area = outcome.stated("/area")
    return abs(area - extrapolated) if extrapolated is not None else 0.02 * area


def contradiction(best, other):
    """Returns a sentence if the answer of topology best to a request contradicts that of topology fixed or free."""
    def connected(outcome):
        return outcome.succeeded and outcome.stated("/components") == 1

    # The lesser area of two meshes of one film says nothing within their errors.
    slack = sum(2 * error_of(outcome) for outcome in (best, other) if outcome.succeeded)
    if connected(other) and other.stated("/converged"):
        # A stationary film that is no minimum is not compared by best.
        if (other.stated("/stability") or {}).get("stable") is not True:
            return None
        if not best.succeeded:
            return f"best failed with {best.error}, and a connected film of {other.stated('/area')} exists"
        if best.stated("/spanning/connected_film_exists") is not True:
            return f"best knows no connected film, and one of {other.stated('/area')} exists"
        # Films that pass through themselves or each other come after all others, whatever their area.
        crosses = (other.stated("/self_intersections") or 0) > 0
        whole = next(way for way in best.stated("/spanning/topologies") if len(way["films"]) == 1)
        if best.warns("films_cross") and not crosses:
            return f"best has films that cross, and a connected film of {other.stated('/area')} does not cross itself"
        if crosses and not whole["films_cross"]:
            return None
        least = whole["area"] if crosses else best.stated("/area")
        if least > other.stated("/area") + slack:
            return f"best has {least}, and a connected film of {other.stated('/area')} exists"
    elif connected(best) and best.stated("/converged"):
        if not other.succeeded:
            return f"{other.error} is stated, and best has the film of {best.stated('/area')}"
        if not other.stated("/converged"):
            return f"not converged, and best has the film of {best.stated('/area')}"
    return None


def agree(name, request, one, other, factor):
    """Returns a sentence if two results differ by more than the relation allows."""
    if name in ("as_fixed", "as_free"):
        found = contradiction(one, other)
        return f"{name}: {found}" if found else None
    if one.succeeded != other.succeeded:
        return f"{name}: one succeeded and the other failed with {one.error or other.error}"
    if not one.succeeded:
        return None
    kind = request["kind"]
    if kind == "uniform_mesh":
        pairs = [(p, one.stated(p), other.stated(p)) for p in ("/nodes", "/triangles")]
        wrong = [f"{p} {a} and {b}" for p, a, b in pairs if a != b]
        return f"{name}: {', '.join(wrong)}" if wrong else None
    if kind == "ruled_surface":
        a, b = one.stated("/objective_value") * factor, other.stated("/objective_value")
        # Terms that round to zero each add up to nothing of this size.
        slack = STRIP * max(abs(a), abs(b)) + 1e-9 * factor
        return f"{name}: objectives {a} and {b}" if abs(a - b) > slack else None
    if name == "as_many_steps_as_needed":
        a, b = one.stated("/objective_value"), other.stated("/objective_value")
        return f"{name}: losses {a} and {b}" if a > 1.1 * b + 1e-6 else None
    pointer = "/load_path" if kind == "cable_net" else "/area"
    a, b = one.stated(pointer) * factor, other.stated(pointer)
    if kind == "cable_net":
        return f"{name}: load paths {a} and {b}" if abs(a - b) > 1e-6 * abs(a) else None
    if not (one.stated("/converged") and other.stated("/converged")):
        return None
    # Two local minima of one boundary are both right, unless the least one was asked for.
    if one.stated("/components") != other.stated("/components") and request.get("topology") != "best":
        return None
    slack = FILM * a
    if kind == "minimal_surface":
        slack += 2 * (error_of(one) * factor + error_of(other))
    else:
        slack += 0.01 * a
    if name == "default_solver":
        slack += OTHER_SOLVER * a
    return f"{name}: areas {a} and {b} differ by more than {slack:.2e}" if abs(a - b) > slack else None
