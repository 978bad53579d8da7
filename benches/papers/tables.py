#!/usr/bin/env python3
"""Prints the tables of docs/papers, one paper after another: solved by a running service, measured by judge.py.

    python3 benches/papers/tables.py [chen-cai-zheng | liu-wang | bento-cavalcanti | katoh-ohsaki-xu | wang-tang]

The service is that of PLATEAU_URL, or the one at http://127.0.0.1:8080. Needs numpy.
"""
import os
import sys
import tempfile

import coordinates
import judge
import meshfiles
from run import load, solve

SERVICE = os.environ.get("PLATEAU_URL", "http://127.0.0.1:8080").rstrip("/")


def film(request, surface=None, lattice=None):
    """The statistics of a solved request, and what the judge measures on its mesh."""
    job, data = solve(SERVICE, request)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.obj")
        with open(path, "wb") as file:
            file.write(data)
        return job["statistics"], judge.judge(meshfiles.read(path), request, surface, None, lattice)


def example(name, **more):
    return {**load(f"api/examples/{name}.json"), **more}


def made(name, **more):
    return {**load(f"benches/papers/requests/{name}.json"), **more}


def table(columns, rows):
    print("\n| " + " | ".join(columns) + " |")
    print("|" + " --- |" * len(columns))
    for row in rows:
        print("| " + " | ".join(row) + " |", flush=True)


def ccz(found):
    figures = found["chen_cai_zheng"]
    angle = found["shape"]["angles_deg"]["min"]
    return [f"{figures['area']:.4f}", f"{figures['curvature_max']:.1e}", f"{figures['curvature_normal_max']:.1e}",
            f"{angle:.1f}°", "; ".join(found["faults"]) or "none"]


RELAXATION = {"solver": "vertex_relaxation", "initial_mesh": "rings"}
FAIRING = {"together": ["laplacian_fairing", "edge_swapping"]}
MINIMISING = {"together": ["area_minimising", "edge_swapping"]}


def chen_cai_zheng():
    columns = ["boundary, triangles", "run", "area", "largest curvature", "along the normal", "smallest angle", "faults"]

    def runs():
        for name, request, limit, printed in [
            ("helicoid", made("ccz-6"), 536.023, [("536.17", "0.1"), ("536.07", "0.0007")]),
            ("catenoid", example("catenoid"), 58.1637, [("58.95", "0.23"), ("58.2", "0.004")]),
        ]:
            first = f"{name}, {request['resolution']['triangles']}"
            for step, (area, curvature) in zip(("step 2", "step 3"), printed):
                yield [first, f"the paper's {step}", area, curvature, "", "", ""]
            for tolerance, shown in ((0.01 / limit, "0.01"), (1e-6, "1e-6 of the area"), (1e-9, "1e-9 of the area")):
                for step, stages in (("step 2", [FAIRING]), ("steps 2 and 3", None)):
                    found = film({**request, **RELAXATION, "area_tolerance": tolerance, "processes": stages})[1]
                    yield [first, f"{step}, ε {shown}", *ccz(found)]
            statistics, found = film(request)
            yield [f"{name}, {statistics['triangles']}", "**default**", *ccz(found)]
            yield [first, "limit on this polygon", f"{limit}", "", "", "", ""]

    table(columns, runs())

    def sizes():
        for name, limit, printed in [("helicoid", 535.0748, "0.00070"), ("catenoid", 58.1637, "0.00400")]:
            for count in (500, 2000, 20000):
                sampling = {"boundary_sampling": "refine"} if count > 5000 else {}
                statistics, found = film(example(name, resolution={"triangles": count}, tolerance=1e-8, **sampling))
                figures, extrapolated = found["chen_cai_zheng"], statistics["extrapolated_area"]
                error = f"{extrapolated['area'] / limit - 1:.1e}" if extrapolated else ""
                yield [name, str(statistics["triangles"]), f"{figures['area']:.4f}", error, f"{figures['curvature_max']:.5f}",
                       f"{figures['curvature_normal_max']:.0e}", f"{found['shape']['angles_deg']['min']:.1f}°"]
            yield [name, "the paper", "", "", printed, "", ""]

    table(["surface", "triangles", "area", "extrapolated area, less the limit, of the limit", "largest curvature", "along the normal",
           "smallest angle"], sizes())

    def levels():
        for name, goal, counts, printed in [
            ("ccz-8-top", 1e-3, (800, 2400), [("9.9", "0.004"), ("9.87", "0.001")]),
            ("ccz-8-bottom", 1e-4, (485, 1455), [("1191.3", "4.8e-05"), ("1187.8", "1.1e-05")]),
        ]:
            points = len(made(name)["boundaries"][0])
            for count, (area, curvature) in zip(counts, printed):
                first = f"{points} points, {count}"
                yield [first, "the paper", area, curvature, "", "", ""]
                # The loosest power of ten at which the largest curvature is at the goal.
                for power in range(6, 11):
                    request = made(name, **RELAXATION, area_tolerance=10.0**-power, resolution={"triangles": count})
                    found = film(request)[1]
                    if found["chen_cai_zheng"]["curvature_max"] <= goal or power == 10:
                        break
                row = ccz(found)
                yield [first, f"steps 2 and 3, to a curvature of {goal:.1e}", row[0], row[1], f"10^-{power}",
                       *row[3:]]
                row = ccz(film(made(name, resolution={"triangles": count}))[1])
                yield [first, "**default**", row[0], row[1], "", *row[3:]]

    table(["boundary, triangles", "run", "area", "largest curvature", "ε", "smallest angle", "faults"], levels())

    def orders():
        boundary = coordinates.rim(coordinates.scherk_surface(1), (-0.4 * coordinates.PI, 0.4 * coordinates.PI),
                                   (-0.4 * coordinates.PI, 0.4 * coordinates.PI), 10, 10)
        scherk = {"kind": "minimal_surface", "boundaries": [boundary], "boundary_sampling": "keep",
                  "resolution": {"triangles": 800}}
        for name, stages in [
            ("theirs", None), ("area + swapping", [MINIMISING]), ("fairing + swapping", [FAIRING]),
            ("area + swapping, then fairing + swapping", [MINIMISING, FAIRING]),
            ("fairing, area, swapping in one stage", [{"together": ["laplacian_fairing", "area_minimising", "edge_swapping"]}]),
        ]:
            statistics, found = film({**scherk, **RELAXATION, "processes": stages})
            yield [name, str(statistics["iterations"]), *ccz(found)[:3]]
        statistics, found = film(scherk)
        yield ["**default**", str(statistics["iterations"]), *ccz(found)[:3]]

    table(["order of the processes", "sweeps", "area", "largest curvature", "along the normal"], orders())

    def starts():
        for shown, name in (("rings that cross (Fig. 4)", "ccz-4"), ("two contours (Fig. 9)", "ccz-9")):
            for run, more in (("steps 2 and 3, ε 1e-8 of the area", {**RELAXATION, "area_tolerance": 1e-8}), ("**default**", {})):
                statistics, found = film(made(name, **more))
                yield [shown, run, f"{statistics['initial_area']:.3f}", *ccz(found)]

    table(["boundary", "run", "area at first", *columns[2:]], starts())


def middle(values):
    return sorted(values)[len(values) // 2]


# Ranges of the parameters over which Liu and Wang's surfaces are measured; they print none.
PATCHES = [
    ("helicoid, u 0.5..2, v ±π/3", coordinates.helicoid, (0.5, 2), coordinates.PI / 3, 7, 20, "helicoid:1.9", "0.716"),
    ("helicoid, u ±2, v ±π/3", coordinates.helicoid, (-2, 2), coordinates.PI / 3, 7, 20, "helicoid:1.9", "0.716"),
    ("helicoid, u 0.5..2, v ±π/6", coordinates.helicoid, (0.5, 2), coordinates.PI / 6, 7, 20, "helicoid:1.9", "0.716"),
    ("catenoid, u π/4..3π/4, v ±0.4", coordinates.catenoid, (coordinates.PI / 4, 3 * coordinates.PI / 4), 0.4, 6, 25, "catenoid:2.05", "0.651"),
    ("catenoid, u π/4..3π/4, v ±0.3", coordinates.catenoid, (coordinates.PI / 4, 3 * coordinates.PI / 4), 0.3, 6, 25, "catenoid:2.05", "0.651"),
    ("catenoid, u π/6..5π/6, v ±0.7", coordinates.catenoid, (coordinates.PI / 6, 5 * coordinates.PI / 6), 0.7, 6, 25, "catenoid:2.05", "0.651"),
]


def liu_wang():
    def errors(boundary, interior, surface, **more):
        def of(seed):
            request = {"kind": "minimal_surface", "boundaries": [boundary], "seed": seed,
                       "initial_mesh": "barycentres", "resolution": {"interior_vertices": interior}, **more}
            return film(request, surface)[1]["liu_wang"]["mean_error"]

        return middle([of(seed) for seed in range(1, 10)])

    def row(name, boundary, interior, surface, printed):
        least = {"objective": "minimal_mean_curvature"}
        area = {"solver": "vertex_relaxation", "processes": ["area_minimising"]}
        own = errors(boundary, interior, surface, **least)
        plain = errors(boundary, interior, surface, **least, candidate_fairing=False)
        loose, tight = (errors(boundary, interior, surface, **area, area_tolerance=e) for e in (1e-4, 1e-9))
        whole = errors(boundary, interior, surface, solver="vertex_relaxation")
        rest = [errors(boundary, interior, surface, **least, boundary_curvature=True), errors(boundary, interior, surface)]
        return [name, f"{own:.2e}", f"{plain:.2e}", f"{loose:.2e}", f"{own / loose:.2f}", f"{tight:.2e}", f"{own / tight:.2f}",
                f"{whole:.2e}", f"{own / whole:.2f}", f"{plain / whole:.2f}", printed, *(f"{value:.2e}" for value in rest)]

    columns = ["surface", "least squares", "without fairing", "area, to 1e-4", "ratio", "area, to 1e-9", "ratio", "Chen, Cai, Zheng",
               "ratio", "ratio without fairing", "the paper's ratio", "all rows", "**default**"]
    table(columns, (
        row(name, coordinates.rim(surface, us, (-v, v), sides, sides), interior, exact, printed)
        for name, surface, us, v, sides, interior, exact, printed in PATCHES))
    table(columns, (
        row(f"Scherk b = {b}, {4 * sides} + {interior}", coordinates.scherk(b, sides), interior, f"scherk:{b}", "")
        for b in (0.4, 1, 4.9) for sides, interior in ((5, 16), (6, 20), (8, 30))))

    def membrane():
        yield ["the paper, on its own nine points", "4.786e-04", "", ""]
        for name, more in (("least squares", {"objective": "minimal_mean_curvature"}),
                           ("all rows", {"objective": "minimal_mean_curvature", "boundary_curvature": True}),
                           ("**default**", {"initial_mesh": "barycentres"})):
            statistics, found = film(made("lw-9", **more))
            yield [name, f"{statistics['mean_curvature']['mean']:.3e}", f"{found['liu_wang']['mean_cycle_curvature']:.1e}",
                   f"{found['shape']['area']:.4f}"]

    table(["membrane of 9 + 4 points", "mean of the mean curvatures, by the area's gradient", "by the normal cycle", "area"],
          membrane())


def bento_cavalcanti():
    def row(shown, rules, linear, request):
        statistics, found = film(request)
        angles = found["shape"]["angles_deg"]
        return [shown, rules, linear, str(statistics["iterations"]), statistics["stop_reason"],
                str(statistics["components"]), f"{found['shape']['area']:.4f}", str(statistics["triangles"]),
                f"{angles['min']:.1f}° to {angles['max']:.1f}°", str(statistics["degenerate_triangles"])]

    def rings():
        for figure, name, rules in [("Fig. 6", "bc-6", 1), ("Fig. 7", "bc-7", 1), ("Fig. 8", "bc-7", 0)]:
            shown = f"{figure}: rings {made(name)['boundaries'][1][0][2]} apart"
            for linear in ("direct", "conjugate_gradients"):
                yield row(shown, "on" if rules else "off", linear, made(
                    name, solver="pinkall_polthier", topology="free", initial_mesh="rings", tolerance=0,
                    linear_solver=linear, degenerate_angle_deg=rules, max_iterations=200, area_tolerance=1e-6 if rules else 0))
            if rules:
                yield row(shown, "on", "**default**", made(name, topology="free"))
        shown = "Fig. 9: cut cylinder"
        for linear in ("direct", "conjugate_gradients"):
            yield row(shown, "on", linear, example("cut-cylinder", linear_solver=linear))
        yield row(shown, "on, 8°", "direct", example("cut-cylinder", degenerate_angle_deg=8))
        yield row(shown, "off", "direct", example("cut-cylinder", degenerate_angle_deg=0))
        kept = ("kind", "units", "boundaries", "boundary_sampling", "initial_mesh", "resolution")
        plain = {key: value for key, value in example("cut-cylinder").items() if key in kept}
        yield row(shown, "none", "**default**", plain)

    table(["example", "rules", "linear solver", "steps", "stopped by", "components", "area", "triangles", "angles",
           "degenerate triangles"], rings())

    def best():
        for name in ("rings-12-best", "rings-14-best", "three-rings", "tetrahedron-loops", "nested-loops"):
            spanning = film(example(name))[0]["spanning"]
            for topology in spanning["topologies"][:4]:
                area = topology["area"]
                yield [name, " ".join(str(loops) for loops in topology["films"]),
                       "does not hold" if area is None else f"{area:.4f}",
                       "" if not topology["stability"] else {True: "yes", False: "no", None: "undecided"}[topology["stability"]["stable"]],
                       "yes" if topology["films_cross"] else ""]

    table(["example", "films over", "area", "stable", "cross"], best())


def katoh_ohsaki_xu():
    theirs = {
        ("auxiliary_surface", "all"): "645, 6.8173, 5.0000, 10.0000, 1.6711", ("plane", "lattice"): "774, 5, 5, 5, 0",
        ("plane", "all"): "954, 5.3633, 4.5893, 9.9727, 0.9888", ("surface", "lattice"): "774, 5.0775, 4.2043, 6.1972, 0.2780",
        ("surface", "all"): "954, 5.4280, 4.2043, 10.6405, 1.0605",
        ("optimised_nodes", "lattice"): "774, 4.9597, 4.3490, 5.3982, 0.1915",
        ("optimised_nodes", "all"): "954, 5.4765, 4.3490, 13.3777, 1.4842",
    }
    names = ["latticed-roof", "latticed-roof-steep", "latticed-film"]
    solved = [film(example(name), lattice="members_lattice") for name in names]

    def rows():
        shown = {"auxiliary_surface": "auxiliary, on the surface", "auxiliary_plane": "auxiliary, in the plane", "plane": "plane",
                 "surface": "surface", "optimised_nodes": "optimised"}
        for stage in ("auxiliary_surface", "auxiliary_plane", "plane", "surface", "optimised_nodes"):
            for group in ("lattice", "all"):
                cells = []
                for statistics, _ in solved:
                    row = next(row for row in statistics["stages"] if row["name"] == stage)[group]
                    cells.append("" if row is None else ", ".join(
                        [str(row["count"])] + [f"{row[key]:.4f}" for key in ("mean", "min", "max", "std_dev")]))
                if any(cells):
                    name = f"{shown[stage]}{'' if stage.startswith('aux') else ', G1' if group == 'lattice' else ', all'}"
                    yield [name, theirs.get((stage, group), ""), *cells]
        for name, group in (("judged from the file, G1", "lattice"), ("judged from the file, all", "edges")):
            yield [name, "", *(", ".join(
                [str(found["katoh_ohsaki_xu"][group]["count"])]
                + [f"{found['katoh_ohsaki_xu'][group][key]:.4f}" for key in ("mean", "min", "max", "std")]) for _, found in solved)]
        stage = lambda statistics, name: next(row for row in statistics["stages"] if row["name"] == name)["lattice"]
        falls = []
        for statistics, _ in solved:
            before, after = stage(statistics, "surface"), stage(statistics, "optimised_nodes")
            falls.append(f"{after['std_dev'] / before['std_dev']:.2f}, "
                         f"{(after['max'] - after['min']) / (before['max'] - before['min']):.2f}")
        yield ["G1's std and range, after / before", "0.69, 0.53", *falls]
        yield ["G1's share of the members", "0.8113", *(f"{found['katoh_ohsaki_xu']['lattice_share']:.4f}" for _, found in solved)]
        yield ["smallest angle", "not given", *(f"{found['shape']['angles_deg']['min']:.1f}°" for _, found in solved)]

    table(["row: count, mean, min, max, std", "theirs", *(f"`{name}`" for name in names)], rows())

    def floors():
        for length in (4, 2, 1, 0.5):
            few, plain = (film(example(name, edge_length=length))[0] for name in ("floor-fewest-nodes", "floor-equal-members"))
            boundary = 2 * plain["nodes"] - 2 - plain["triangles"]
            yield [f"{length}", f"{boundary}", f"{plain['edges']}", f"{plain['equal_edges']}", f"{plain['distinct_lengths']}",
                   f"{few['nodes']}", f"{few['nodes'] / few['node_lower_bound']:.2f}"]

    table(["ℓ", "boundary nodes", "members", "of length ℓ", "different lengths", "nodes, problem 1",
           "over the lower bound of the fewest"], floors())


# Their Table 1: area, twist, convex edges, bending, curvature variation, normal variation.
PRINTED = {
    ("i", "minimal_area"): (40.56, 16.62, 12, 65.47, 49.65), ("i", "minimal_twist"): (40.94, 5.28, 105, 4.07, 14.94),
    ("i", "maximal_convexity"): (40.94, 5.29, 112, 3.97, 14.50),
    ("i", "minimal_bending_energy"): (40.94, 5.30, 108, 3.92, 14.79),
    ("i", "minimal_mean_curvature_variation"): (40.93, 5.93, 74, 7.37, 7.66),
    ("ii", "minimal_area"): (87.13, 124.08, 8, 1168.67, 218.29), ("ii", "maximal_convexity"): (89.22, 77.00, 180, 60.86, 53.98),
    ("ii", "maximal_convexity + minimal_bending_energy"): (89.23, 78.57, 180, 58.45, 51.85),
    ("ii", "maximal_convexity + minimal_mean_curvature_variation"): (89.22, 77.42, 180, 71.81, 51.10),
    ("iii", "minimal_area"): (12.10, 20.54, 5, 49.03, 32.34), ("iii", "minimal_bending_energy"): (12.15, 23.32, 10, 22.84, 29.19),
    ("iv", "maximal_convexity"): (0.15, 10.73, 153, 35.34, 2.41),
    ("iv", "maximal_convexity + minimal_bending_energy"): (0.15, 9.24, 153, 24.50, 2.14),
    ("v", "minimal_bending_energy"): (41.85, 3.02, 103, 44.18, 29.54, 7.39),
    ("v", "minimal_normal_variation"): (41.90, 16.56, 16, 292.37, 90.57, 4.35),
}


def wang_tang():
    alone = ["minimal_area", "minimal_twist", "maximal_convexity", "minimal_bending_energy", "minimal_mean_curvature_variation"]
    coupled = ["maximal_convexity + minimal_bending_energy", "maximal_convexity + minimal_mean_curvature_variation"]

    figures = ["area", "total_normal_twist", "convex_bridges", "bending_energy", "mean_curvature_variation", "normal_variation"]

    def block(shown, request, printed):
        """The rows of one pair of rails; the best of each column stands out."""
        objectives = alone + (["minimal_normal_variation"] if request.get("normals") else []) + coupled
        found = []
        for objective in objectives:
            first, _, second = objective.partition(" + ")
            more = {"objective": first, "secondary_objective": second or None, "all_objectives": False}
            found.append(film({**request, **more})[1]["wang_tang"])
        for objective, f in zip(objectives, found):
            cells = []
            for k, name in enumerate(figures):
                if f[name] is None:
                    cells.append("")
                    continue
                best = max if name == "convex_bridges" else min
                cell = lambda g: f"{g[name]}/{g['bridges']}" if name == "convex_bridges" else f"{g[name]:.2f}"
                own = cell(f) if cell(f) != cell(best(found, key=lambda g: g[name])) else f"**{cell(f)}**"
                theirs = printed.get(objective, ())[k:k + 1]
                cells.append(own + "".join(f" ({value})" if k == 2 else f" ({value:.2f})" for value in theirs))
            yield [shown, objective.replace("_", " "), *cells]

    def rows():
        for number in ("i", "ii", "iii", "iv", "v", "vi"):
            own = {objective: values for (of, objective), values in PRINTED.items() if of == number}
            yield from block(number.upper(), example(f"wang-tang-{number}"), own)

    columns = ["example", "objective", "area", "normal twist", "convex bridges", "bending energy", "curvature variation",
               "normal variation"]
    table(columns, rows())

    def others():
        theirs = {number: {objective: values for (of, objective), values in PRINTED.items() if of == number} for number in ("iii", "v")}
        yield from block("two helices", made("wt-3"), theirs["iii"])
        yield from block("two ovals", made("wt-5"), theirs["v"])

    table(["rails", *columns[1:]], others())

    def moved():
        for objective in alone:
            counts = objective == "maximal_convexity"
            cells = []
            for name, tolerance in [("clean", None), ("noisy", None), ("noisy", 0.01), ("noisy", 0.02), ("noisy", 0.04)]:
                request = made(f"wt-7-{name}", objective=objective, rail_tolerance=tolerance)
                statistics = solve(SERVICE, request)[0]["statistics"]
                value = statistics["objective_value"]
                cells.append(f"{statistics['bridges'] - value:.0f}" if counts else f"{value:.3f}")
            yield [objective.replace("_", " ") + (": bridges that are not convex" if counts else ""), *cells]

    table(["objective", "clean", "with noise", "tolerance d/2", "d", "2d"], moved())


PAPERS = {"chen-cai-zheng": chen_cai_zheng, "liu-wang": liu_wang, "bento-cavalcanti": bento_cavalcanti,
          "katoh-ohsaki-xu": katoh_ohsaki_xu, "wang-tang": wang_tang}


def main():
    names = sys.argv[1:] or list(PAPERS)
    for name in names:
        if name not in PAPERS:
            raise SystemExit(f"usage: tables.py [{' | '.join(PAPERS)}]")
        PAPERS[name]()


if __name__ == "__main__":
    main()
