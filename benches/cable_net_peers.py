"""The cable net by targets beside jax_fdm (PyPI `jax_fdm`), in one run.

    cargo test -p plateau-geometry --bench cable_net --no-run     (prints the binary)
    python3 benches/cable_net_peers.py BENCH_BINARY [CELLS ...]

The net is that of jax_fdm's `cablenet.md`: 10 m, CELLS x CELLS cells (10 without an argument), two opposite corners lifted by
5 m; forces of 20 kN on the rim, equal lengths inside, no force density below 0.1. Both start from the same densities and
minimise the same loss, the sum of the two mean squared errors. jax_fdm runs as in its example: L-BFGS-B, 1000 iterations,
tolerance 1e-8. Seconds are wall time: for ours of the solver (`seconds`) and of the whole process (`process_seconds`), for
jax_fdm of `constrained_fdm` with the compilation that precedes its first iteration (`peer_seconds`) and without
(`peer_optimisation_seconds`). Prints one JSON line for each net; `ratio` is seconds over peer_optimisation_seconds.
"""
import contextlib
import io
import json
import re
import subprocess
import sys
import time


def peer(cells):
    from jax_fdm.datastructures import FDMesh
    from jax_fdm.equilibrium import constrained_fdm
    from jax_fdm.goals import EdgeForceGoal, EdgeLengthGoal
    from jax_fdm.losses import Loss, MeanSquaredError
    from jax_fdm.optimization import LBFGSB
    from jax_fdm.parameters import EdgeForceDensityParameter

    size = 10.0 / cells
    net = FDMesh.from_meshgrid(10.0, nx=cells)
    rim = [edge for edge in net.edges() if net.is_edge_on_boundary(edge)]
    inside = [edge for edge in net.edges() if not net.is_edge_on_boundary(edge)]
    corners = list(net.vertices_where(vertex_degree=2))
    net.vertices_supports(corners)
    for corner in (corners[0], corners[-1]):
        net.vertex_attribute(corner, "z", 5.0)
    for edges, force in ((rim, 20.0), (inside, 1.0)):
        for edge in edges:
            net.edge_forcedensity(edge, force / net.edge_length(edge))
    parameters = [EdgeForceDensityParameter(edge, 0.1, None) for edge in net.edges()]
    forces = MeanSquaredError([EdgeForceGoal(edge, target=20.0) for edge in rim], name="force")
    lengths = MeanSquaredError([EdgeLengthGoal(edge, target=size) for edge in inside], name="length")
    log = io.StringIO()
    start = time.perf_counter()
    with contextlib.redirect_stdout(log):
        found = constrained_fdm(
            net, optimizer=LBFGSB(), loss=Loss(forces, lengths), parameters=parameters, maxiter=1000, tol=1e-8
        )
    seconds = time.perf_counter() - start
    by_force = [found.edge_force(edge) for edge in rim]
    by_length = [found.edge_length(edge) for edge in inside]

    def mean(values):
        return sum(values) / len(values)

    optimisation = re.search(r"elapsed time: ([\d.e+-]+)", log.getvalue())
    return {
        "peer_seconds": round(seconds, 3),
        "peer_optimisation_seconds": round(float(optimisation.group(1)), 3) if optimisation else None,
        "peer_loss": mean([(force - 20.0) ** 2 for force in by_force]) + mean([(length - size) ** 2 for length in by_length]),
        "peer_force": [round(min(by_force), 4), round(max(by_force), 4)],
        "peer_length": [round(min(by_length), 4), round(max(by_length), 4)],
    }


def main():
    binary, nets = sys.argv[1], [int(cells) for cells in sys.argv[2:]] or [10]
    for cells in nets:
        start = time.perf_counter()
        run = subprocess.run([binary, "--case", str(cells)], check=True, capture_output=True, text=True)
        line = json.loads(run.stdout)
        line["process_seconds"] = round(time.perf_counter() - start, 3)
        line.update(peer="jax_fdm", **peer(cells))
        if line["peer_optimisation_seconds"]:
            line["ratio"] = round(line["seconds"] / line["peer_optimisation_seconds"], 5)
        print(json.dumps(line), flush=True)


main()
