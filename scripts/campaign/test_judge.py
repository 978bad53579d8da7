"""The judge itself, tried on faults put in on purpose: it finds none in a result as it is, and each of them.

    PLATEAU_URL=http://… python3 scripts/campaign/test_judge.py
    python3 scripts/campaign/test_judge.py --program target/debug/plateau
"""

import copy
import os
import sys
from pathlib import Path
from random import Random

sys.path.insert(0, str(Path(__file__).parent))

import judge  # noqa: E402
from families import film, lattice, rail, ring, square, strip  # noqa: E402
from hosts import Program, Service  # noqa: E402

FILM = {**film([square(4, 1.0, 0.4)], 300), "certify": {"gap": 0.05, "seconds": 0.3}}
RINGS = film([ring(16), ring(16, 1.0, 0.5)], 300)
STRIP = strip([rail(Random(1), 8, 0), rail(Random(2), 11, 1)], objective="minimal_area")
LATTICE = lattice({"polygon": [[0, 0, 0], [20, 0, 0], [22, 14, 0], [3, 15, 0]]}, 2.0, objective="most_equal_edges")
NET = {"kind": "cable_net", "vertices": [[0, 0, 0], [2, 0, 1], [2, 2, 0], [0, 2, 1], [1, 1, 0]],
       "edges": [[0, 4], [1, 4], [2, 4], [3, 4]], "supports": [0, 1, 2, 3],
       "cables": [{"name": "all", "edges": [0, 1, 2, 3], "force_density": 2.0}]}
SAIL = {"kind": "tensile_structure", "boundaries": [[[0, 0, 0], [10, 0, 4], [10, 10, 0], [0, 10, 4]]], "film": {"tension": 2},
        "cables": [{"name": f"edge {k}", "along": {"from": k, "to": (k + 1) % 4}, "mode": "force", "value": 30} for k in range(4)],
        "resolution": {"triangles": 300}}


def shifted_boundary(statistics, mesh):
    # Each point of the boundary moves to the place of its neighbour, as when the list began at another point.
    numbers = mesh["input_vertices"][0]
    places = [mesh["vertices"][v] for v in numbers]
    for v, place in zip(numbers, places[1:] + places[:1]):
        mesh["vertices"][v] = place


def lost_triangle(statistics, mesh):
    mesh["triangles"].pop(len(mesh["triangles"]) // 2)


def swapped_figures(statistics, mesh):
    lengths = statistics["edge_lengths"]
    lengths["mean"], lengths["std_dev"] = lengths["std_dev"], lengths["mean"]


def stale_gap(statistics, mesh):
    statistics["certificate"]["gap"] += 1e-4


def moved_vertex(statistics, mesh):
    mesh["vertices"][-1][2] += 1e-3


def area_of_an_earlier_step(statistics, mesh):
    statistics["area"] *= 1 + 1e-7
    statistics["objective_value"] = statistics["area"]


def flipped_triangle(statistics, mesh):
    a, b, c = mesh["triangles"][5]
    mesh["triangles"][5] = [a, c, b]


def boundary_without_a_vertex(statistics, mesh):
    line = next(line for line in mesh["lines"] if line["name"] == "boundaries")
    line["paths"][0].pop(2)


def lost_component(statistics, mesh):
    statistics["components"] += 1


def residual_of_another_mesh(statistics, mesh):
    statistics["residual"] = 0.01


def sheets_that_cross(statistics, mesh):
    # One inner vertex is pulled through the opposite wall. The judge must find the crossings, and may find more.
    given = {v for numbers in mesh["input_vertices"] for v in numbers}
    inner = next(v for v in range(len(mesh["vertices"]) - 1, 0, -1) if v not in given)
    x, y, z = mesh["vertices"][inner]
    mesh["vertices"][inner] = [-1.5 * x, -1.5 * y, z]


def fold_of_another_strip(statistics, mesh):
    statistics["largest_fold_deg"] += 0.01


def lost_bridge(statistics, mesh):
    next(line for line in mesh["lines"] if line["name"] == "bridges")["paths"].pop(3)


def members_of_the_wrong_group(statistics, mesh):
    lines = {line["name"]: line for line in mesh["lines"]}
    lines["members rim"]["paths"].append(lines["members lattice"]["paths"].pop())


def one_equal_edge_more(statistics, mesh):
    statistics["equal_edges"] += 1


def swapped_forces(statistics, mesh):
    values = next(line for line in mesh["lines"] if line["name"].startswith("cables"))["values"]["values"]
    values[0] *= 1.01


def moved_support(statistics, mesh):
    mesh["vertices"][0][0] += 1e-9


def cable_of_another_length(statistics, mesh):
    statistics["cables"][0]["length"] += 1e-5


def triangles_of_another_layer(statistics, mesh):
    statistics["layers"][0]["triangles"] -= 2


FAULTS = [(FILM, shifted_boundary), (FILM, lost_triangle), (FILM, swapped_figures), (FILM, stale_gap), (FILM, moved_vertex),
          (FILM, area_of_an_earlier_step), (FILM, flipped_triangle), (FILM, boundary_without_a_vertex), (FILM, lost_component),
          (FILM, residual_of_another_mesh), (RINGS, sheets_that_cross), (STRIP, fold_of_another_strip), (STRIP, lost_bridge),
          (STRIP, moved_vertex), (LATTICE, members_of_the_wrong_group), (LATTICE, one_equal_edge_more), (NET, swapped_forces),
          (NET, moved_support), (SAIL, cable_of_another_length), (SAIL, triangles_of_another_layer)]


def main():
    program = sys.argv[2] if sys.argv[1:2] == ["--program"] else None
    host = Program(program) if program else Service(os.environ["PLATEAU_URL"])
    missed = 0
    outcomes = {}
    for request, fault in FAULTS:
        if id(request) not in outcomes:
            outcome = outcomes[id(request)] = host.solve(request)
            assert outcome.succeeded, (request["kind"], outcome.error, outcome.detail)
            sound = judge.faults(request, outcome.statistics, outcome.mesh, outcome.warnings)
            assert not sound, (request["kind"], sound)
        outcome = outcomes[id(request)]
        statistics, mesh = copy.deepcopy(outcome.statistics), copy.deepcopy(outcome.mesh)
        fault(statistics, mesh)
        found = judge.faults(request, statistics, mesh, outcome.warnings)
        if fault is sheets_that_cross:
            found = [sentence for sentence in found if "cross" in sentence]
        print(f"{'found' if found else 'MISSED':7} {request['kind']:18} {fault.__name__}: {found[0] if found else ''}")
        missed += not found
    print(f"{len(FAULTS) - missed} of {len(FAULTS)} faults found")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
