"""The cable net by targets beside jax_fdm (PyPI `jax_fdm`), in one run.

    cargo test -p plateau-cable-net --bench cable_net --no-run     (prints the binary)
    PEERS/bin/python benches/cable_net_peers.py [--seconds S] BENCH_BINARY [CELLS ...]     (PEERS: benches/peers)

The net is that of jax_fdm's `cablenet.md`: 10 m, CELLS x CELLS cells (10 without an argument), two opposite corners lifted by
5 m; forces of 20 kN on the rim, equal lengths inside, no force density below 0.1. Both start from the same densities and
minimise the same loss, the sum of the two mean squared errors. jax_fdm runs as in its example: L-BFGS-B, at most 1000
iterations, tolerance 1e-8. It runs in a process of its own and is stopped after S seconds of processor time (900); such a
line has `"peer_ended": false`. Ours runs before it and after it, and the mean of both counts.

`seconds` is the wall time of our solver and `process_seconds` the processor time of our whole process. `peer_seconds` is
the wall time of `constrained_fdm` with the compilation that precedes its first iteration, `peer_optimisation_seconds`
without it, and `peer_process_seconds` the processor time of the whole process. `ratio` is seconds over
peer_optimisation_seconds, and `process_ratio` the same of the processor times. Prints one JSON line for each net.
"""
import argparse
import contextlib
import io
import json
import re
import resource
import signal
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


def processor_seconds(usage):
    return usage.ru_utime + usage.ru_stime


def ours(binary, cells):
    before = processor_seconds(resource.getrusage(resource.RUSAGE_CHILDREN))
    run = subprocess.run([binary, "--case", str(cells)], check=True, capture_output=True, text=True)
    seconds = processor_seconds(resource.getrusage(resource.RUSAGE_CHILDREN)) - before
    return {**json.loads(run.stdout), "process_seconds": seconds}


def peer_in_its_own_process(cells, limit):
    """The figures of jax_fdm, or what it had used when it was stopped."""

    def bound():
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))

    before = processor_seconds(resource.getrusage(resource.RUSAGE_CHILDREN))
    run = subprocess.run(
        [sys.executable, __file__, "--peer", str(cells)], capture_output=True, text=True, preexec_fn=bound
    )
    seconds = processor_seconds(resource.getrusage(resource.RUSAGE_CHILDREN)) - before
    figures = {"peer_ended": run.returncode == 0, "peer_process_seconds": round(seconds, 2)}
    if run.returncode == 0:
        figures.update(json.loads(run.stdout.splitlines()[-1]))
    elif run.returncode not in (-signal.SIGXCPU, -signal.SIGKILL):
        raise SystemExit(run.stderr)
    return figures


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seconds", type=int, default=900)
    parser.add_argument("--peer", type=int, help=argparse.SUPPRESS)
    parser.add_argument("binary", nargs="?")
    parser.add_argument("cells", nargs="*", type=int, default=[10])
    arguments = parser.parse_intermixed_args()
    if arguments.peer is not None:
        print(json.dumps(peer(arguments.peer)))
        return
    for cells in arguments.cells:
        line = ours(arguments.binary, cells)
        line.update(peer="jax_fdm", **peer_in_its_own_process(cells, arguments.seconds))
        again = ours(arguments.binary, cells)
        for name in ("seconds", "process_seconds"):
            line[name] = round(0.5 * (line[name] + again[name]), 4)
        if line.get("peer_optimisation_seconds"):
            line["ratio"] = round(line["seconds"] / line["peer_optimisation_seconds"], 5)
        line["process_ratio"] = round(line["process_seconds"] / line["peer_process_seconds"], 5)
        print(json.dumps(line), flush=True)


if __name__ == "__main__":
    main()
