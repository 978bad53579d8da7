"""Form finding beside Kratos and compas_fd, in one run.

    python3 -m venv PEERS && PEERS/bin/pip install -r benches/peers/requirements.txt
    cargo build --release
    PEERS/bin/python benches/peers/tensile_structures.py target/release/plateau [--seconds S] [--residual R] [TRIANGLES ...]

Two structures with closed forms, each at about so many triangles (2000 without an argument):

- `sail`: a plane film of tension 1 between the corners of a 10 x 10 square with edge cables of force 10. Each edge is
  an arc of radius 10: area 63.765571, length of a cable 10.471976, sag 1.339746.
- `catenoid`: a film between two rings of radius 10 at a distance of 12: neck 7.450711, area 699.9643.

Two more are small and run once:

- `collapse`: the same rings at distances beside 13.25487, beyond which there is no catenoid: 13.2 has one, 13.3 has
  none.
- `hypar`: the test of compas_fd (`fd_numpy`), four supports and a free point of equal force densities, at (0.5, 0.5,
  0.5).

Ours is `plateau solve` from the request to the written GLB. Kratos runs its form finding solver (the update reference
strategy) with the settings of its own test of a four-point sail on a structured mesh of as many triangles: membrane and
cable elements of its default, isotropic prestress 1, with the sparse LU of its `LinearSolversApplication`, until the
norm of its residual is at most R (1e-7, that of its test) or it has used S seconds of processor time (900). Its iterations run in
steps of ten, after which the time and the residual are looked at; the shape after each is the same to the last bit as
without steps, because the reference shape is renewed in every iteration. Its time is that of `AnalysisStage.Run`,
reading the mesh from its file included, without what the looking takes. Ours runs before it and after it, and the mean
of both counts. All are processor time of one thread. Prints one JSON line for each; `ratio` is ours over Kratos's.
Where `converged` is false Kratos was stopped, and the ratio is an upper bound.
"""

import argparse
import contextlib
import json
import math
import os
import resource
import subprocess
import sys
import tempfile
import time

EXACT = {
    "sail": {
        "area": 100 - 4 * (50 * (math.pi / 3 - math.sin(math.pi / 3))),
        "cable": 10 * math.pi / 3,
        "sag": 10 - math.sqrt(75),
    },
    "catenoid": {"area": 699.9643, "neck": 7.450711},
}


def circle(count, height):
    return [
        [10 * math.cos(2 * math.pi * k / count), 10 * math.sin(2 * math.pi * k / count), height] for k in range(count)
    ]


def rings(triangles):
    """Points on each ring and rows of a structured mesh with about equal edges."""
    count = round(math.sqrt(triangles * 2 * math.pi * 10 / 12 / 2))
    return count, max(2, round(triangles / (2 * count)))


def request(case, triangles, height=12):
    if case == "sail":
        corners = [[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]]
        cables = [{"along": {"from": k, "to": (k + 1) % 4}, "mode": "force", "value": 10} for k in range(4)]
        return {
            "kind": "tensile_structure",
            "boundaries": [corners],
            "film": {"tension": 1},
            "cables": cables,
            "resolution": {"triangles": triangles},
        }
    count, _ = rings(triangles)
    return {
        "kind": "tensile_structure",
        "boundaries": [circle(count, 0), circle(count, height)],
        "film": {"tension": 1},
        "resolution": {"triangles": triangles},
    }


def ours(binary, case, triangles, folder):
    path = os.path.join(folder, "request.json")
    with open(path, "w") as file:
        json.dump(request(case, triangles), file)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run(
        [binary, "solve", path, "-o", os.path.join(folder, "mesh.glb")], check=True, capture_output=True
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    statistics = json.loads(run.stdout)
    figures = {
        "triangles": statistics["triangles"],
        "area": statistics["area"],
        "converged": statistics["converged"],
        "residual": statistics["residual"],
        "imbalance": statistics["balance"]["imbalance"],
    }
    if case == "catenoid":
        # The rings lie on both sides of the neck, so that it is inside the film.
        obj = os.path.join(folder, "mesh.obj")
        subprocess.run([binary, "solve", path, "-o", obj], check=True, capture_output=True)
        with open(obj) as file:
            points = [list(map(float, line.split()[1:4])) for line in file if line.startswith("v ")]
        figures["neck"] = min(math.hypot(x, y) for x, y, _ in points)
    if case == "sail":
        figures.update(cable=statistics["cables"][0]["length"], sag=statistics["cables"][0]["sag"])
    figures["seconds"] = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return figures


def structured(case, triangles):
    """Points, triangles, chains of cables and fixed points of a structured mesh."""
    if case == "sail":
        n = round(math.sqrt(triangles / 2))
        points = [[10 * i / n, 10 * j / n, 0.0] for j in range(n + 1) for i in range(n + 1)]

        def number(i, j):
            return j * (n + 1) + i

        # Diagonals towards the middle, so that no triangle has both edges on the film's edge.
        quads = [(i, j) for j in range(n) for i in range(n)]
        faces = []
        for i, j in quads:
            a, b, c, d = number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)
            rising = (i < n / 2) == (j < n / 2)
            faces += [[a, b, c], [a, c, d]] if rising else [[a, b, d], [b, c, d]]
        chains = [
            [number(i, 0) for i in range(n + 1)],
            [number(n, j) for j in range(n + 1)],
            [number(i, n) for i in range(n, -1, -1)],
            [number(0, j) for j in range(n, -1, -1)],
        ]
        return points, faces, chains, [number(0, 0), number(n, 0), number(0, n), number(n, n)]
    count, rows = rings(triangles)
    points = [point for row in range(rows + 1) for point in circle(count, 12 * row / rows)]
    faces = []
    for row in range(rows):
        for k in range(count):
            a, b = row * count + k, row * count + (k + 1) % count
            faces += [[a, b, b + count], [a, b + count, a + count]]
    return points, faces, [], list(range(count)) + list(range(rows * count, (rows + 1) * count))


def write_mesh(path, points, faces, chains, fixed):
    cables = [(a, b) for chain in chains for a, b in zip(chain, chain[1:])]
    with open(path, "w") as file:
        file.write("Begin Properties 1\nEnd Properties\nBegin Properties 2\nEnd Properties\nBegin Nodes\n")
        file.writelines(f"{k + 1} {x!r} {y!r} {z!r}\n" for k, (x, y, z) in enumerate(points))
        file.write("End Nodes\nBegin Elements MembraneElement3D3N\n")
        file.writelines(f"{k + 1} 1 {a + 1} {b + 1} {c + 1}\n" for k, (a, b, c) in enumerate(faces))
        file.write("End Elements\n")
        if cables:
            file.write("Begin Elements CableElement3D2N\n")
            file.writelines(f"{len(faces) + k + 1} 2 {a + 1} {b + 1}\n" for k, (a, b) in enumerate(cables))
            file.write("End Elements\n")

        def part(name, nodes, elements):
            file.write(f"Begin SubModelPart {name}\nBegin SubModelPartNodes\n")
            file.writelines(f"{v + 1}\n" for v in nodes)
            file.write("End SubModelPartNodes\nBegin SubModelPartElements\n")
            file.writelines(f"{e + 1}\n" for e in elements)
            file.write("End SubModelPartElements\nEnd SubModelPart\n")

        part("membrane", range(len(points)), range(len(faces)))
        if cables:
            part("cables", sorted({v for cable in cables for v in cable}), range(len(faces), len(faces) + len(cables)))
        part("fixed", fixed, [])


# Kratos's iterations between two looks at its time.
LOOK = 10


def kratos(case, triangles, tolerance, limit, folder):
    import KratosMultiphysics
    import KratosMultiphysics.LinearSolversApplication  # noqa: F401 (registers the solver)
    import KratosMultiphysics.StructuralMechanicsApplication  # noqa: F401 (registers the elements)
    from KratosMultiphysics.StructuralMechanicsApplication.structural_mechanics_analysis import (
        StructuralMechanicsAnalysis,
    )

    points, faces, chains, fixed = structured(case, triangles)
    write_mesh(os.path.join(folder, "mesh.mdpa"), points, faces, chains, fixed)
    membrane = {
        "model_part_name": "Structure.membrane",
        "properties_id": 1,
        "Material": {
            "constitutive_law": {"name": "LinearElasticPlaneStress2DLaw"},
            "Variables": {
                "THICKNESS": 1.0,
                "PRESTRESS_VECTOR": [1.0, 1.0, 0],
                "DENSITY": 0.0,
                "YOUNG_MODULUS": 0.0,
                "POISSON_RATIO": 0.0,
            },
            "Tables": {},
        },
    }
    cables = {
        "model_part_name": "Structure.cables",
        "properties_id": 2,
        "Material": {
            "constitutive_law": {"name": "TrussConstitutiveLaw"},
            "Variables": {"DENSITY": 0.0, "YOUNG_MODULUS": 1e-15, "CROSS_AREA": 1.0, "TRUSS_PRESTRESS_PK2": 10.0},
            "Tables": {},
        },
    }
    with open(os.path.join(folder, "materials.json"), "w") as file:
        json.dump({"properties": [membrane] + ([cables] if chains else [])}, file)
    parameters = {
        "problem_data": {
            "problem_name": case,
            "parallel_type": "OpenMP",
            "echo_level": 0,
            "start_time": 0.0,
            "end_time": 1e9,
        },
        "solver_settings": {
            "solver_type": "formfinding",
            "model_part_name": "Structure",
            "domain_size": 3,
            "echo_level": 0,
            "analysis_type": "non_linear",
            "model_import_settings": {"input_type": "mdpa", "input_filename": os.path.join(folder, "mesh")},
            "material_import_settings": {"materials_filename": os.path.join(folder, "materials.json")},
            "time_stepping": {"time_step": 1.0},
            "line_search": False,
            "convergence_criterion": "residual_criterion",
            "displacement_relative_tolerance": tolerance,
            "displacement_absolute_tolerance": tolerance,
            "residual_relative_tolerance": 0.0,
            "residual_absolute_tolerance": tolerance,
            "max_iteration": LOOK,
            "rotation_dofs": False,
            "linear_solver_settings": {"solver_type": "LinearSolversApplication.sparse_lu"},
            "printing_format": "none",
            "write_formfound_geometry_file": False,
            "projection_settings": {
                "model_part_name": "Structure",
                "echo_level": 0,
                "projection_type": "planar",
                # Must lie in no element's normal; the prestress is the same in all directions.
                "global_direction": [1.0, 0, 0] if case == "sail" else [0, 0, 1.0],
                "variable_name": "LOCAL_PRESTRESS_AXIS_1",
                "method_specific_settings": {},
                "check_local_space_dimension": False,
            },
        },
        "processes": {
            "constraints_process_list": [
                {
                    "python_module": "assign_vector_variable_process",
                    "kratos_module": "KratosMultiphysics",
                    "Parameters": {
                        "model_part_name": "Structure.fixed",
                        "variable_name": "DISPLACEMENT",
                        "interval": [0.0, "End"],
                        "constrained": [True, True, True],
                        "value": [0.0, 0.0, 0.0],
                    },
                }
            ],
            "loads_process_list": [],
        },
        "output_processes": {},
    }
    model = KratosMultiphysics.Model()
    KratosMultiphysics.Logger.GetDefaultOutput().SetSeverity(KratosMultiphysics.Logger.Severity.WARNING)
    analysis = StructuralMechanicsAnalysis(model, KratosMultiphysics.Parameters(json.dumps(parameters)))
    start = time.process_time()
    analysis.Initialize()
    part = model["Structure"]
    run = {"iterations": 0, "residual": math.inf, "seconds": 0.0}
    finalize = analysis.FinalizeSolutionStep

    def finalize_step():
        finalize()
        run["seconds"] = time.process_time() - start
        run["iterations"] += part.ProcessInfo[KratosMultiphysics.NL_ITERATION_NUMBER]
        run["residual"] = part.ProcessInfo[KratosMultiphysics.RESIDUAL_NORM]

    analysis.FinalizeSolutionStep = finalize_step
    analysis.KeepAdvancingSolutionLoop = lambda: run["residual"] > tolerance and run["seconds"] < limit
    analysis.RunSolutionLoop()
    analysis.Finalize()
    at = [(node.X, node.Y, node.Z) for node in part.Nodes]
    with open(os.path.join(folder, "kratos.obj"), "w") as file:
        file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in at)
        file.writelines(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces)

    def distance(a, b):
        return math.dist(at[a], at[b])

    def area(face):
        a, b, c = (distance(face[k], face[k - 1]) for k in range(3))
        s = 0.5 * (a + b + c)
        return math.sqrt(max(0.0, s * (s - a) * (s - b) * (s - c)))

    figures = {
        "triangles": len(faces),
        "area": sum(map(area, faces)),
        "seconds": run["seconds"],
        "iterations": run["iterations"],
        "residual": run["residual"],
        "converged": run["residual"] <= tolerance,
    }
    if chains:
        figures["cable"] = sum(distance(a, b) for a, b in zip(chains[0], chains[0][1:]))
        figures["sag"] = max(abs(at[v][1]) for v in chains[0])
    else:
        figures["neck"] = min(math.hypot(x, y) for x, y, _ in at)
    return figures


@contextlib.contextmanager
def output_to_stderr():
    """Lets what Kratos's libraries print follow the errors, so that only results are printed."""
    sys.stdout.flush()
    own = os.dup(1)
    os.dup2(2, 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(own, 1)
        os.close(own)


def collapse(binary, folder):
    """Whether ours finds a catenoid between rings at distances beside the limit."""
    found = {}
    for height in (13.2, 13.3):
        path = os.path.join(folder, "request.json")
        with open(path, "w") as file:
            json.dump(request("catenoid", 8000, height), file)
        run = subprocess.run(
            [binary, "solve", path, "-o", os.path.join(folder, "mesh.glb")], capture_output=True, text=True
        )
        found[height] = (
            {"area": json.loads(run.stdout)["area"]} if run.returncode == 0 else {"refused": run.stderr.splitlines()[0]}
        )
    return {"bench": "tensile_structure/collapse", "exact": {"limit": 13.25487}, "ours": found}


def hypar(binary, folder):
    from compas_fd.solvers import fd_numpy

    vertices = [[0, 0, 0], [1, 0, 1], [1, 1, 0], [0, 1, 1], [0.2, 0.7, 3]]
    edges = [[0, 4], [1, 4], [2, 4], [3, 4]]
    start = time.process_time()
    theirs = fd_numpy(vertices=vertices, fixed=[0, 1, 2, 3], edges=edges, forcedensities=[1.0] * 4).vertices[4]
    seconds = time.process_time() - start
    path, obj = os.path.join(folder, "request.json"), os.path.join(folder, "net.obj")
    with open(path, "w") as file:
        json.dump(
            {
                "kind": "cable_net",
                "vertices": vertices,
                "edges": edges,
                "supports": [0, 1, 2, 3],
                "cables": [{"force_density": 1}],
            },
            file,
        )
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([binary, "solve", path, "-o", obj], check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(obj) as file:
        points = [list(map(float, line.split()[1:4])) for line in file if line.startswith("v ")]
    return {
        "bench": "tensile_structure/hypar",
        "exact": [0.5, 0.5, 0.5],
        "ours": {
            "point": points[4],
            "process_seconds": after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime,
        },
        "compas_fd": {"point": [float(x) for x in theirs], "seconds": seconds},
    }


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("binary")
    parser.add_argument("triangles", nargs="*", type=int, default=[2000])
    parser.add_argument("--seconds", type=float, default=900)
    parser.add_argument("--residual", type=float, default=1e-7)
    arguments = parser.parse_intermixed_args()
    with tempfile.TemporaryDirectory() as folder:
        print(json.dumps(hypar(arguments.binary, folder)), flush=True)
        print(json.dumps(collapse(arguments.binary, folder)), flush=True)
    for triangles in arguments.triangles:
        for case in ("sail", "catenoid"):
            with tempfile.TemporaryDirectory() as folder:
                own = ours(arguments.binary, case, triangles, folder)
                with output_to_stderr():
                    theirs = kratos(case, triangles, arguments.residual, arguments.seconds, folder)
                again = ours(arguments.binary, case, triangles, folder)["seconds"]
                own["seconds"] = 0.5 * (own["seconds"] + again)
            line = {"bench": f"tensile_structure/{case}", "exact": EXACT[case], "ours": own, "kratos": theirs}
            line["ratio"] = round(own["seconds"] / theirs["seconds"], 4)
            print(json.dumps(line), flush=True)


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    main()
