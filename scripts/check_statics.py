#!/usr/bin/env python3
"""Sums the forces at every vertex of solved tensile structures and cable nets, from the mesh and its lines alone.

    pip install numpy
    scripts/check_statics.py BINARY [REQUEST.json ...]      (default: every tensile example and net of api/examples)

Each structure is solved by `BINARY solve` at three meshes: half, the same and twice the number of triangles of its
request (a net once). The forces come from the JSON mesh: the stress of each triangle, the force of each segment of a
cable or mast, and the weights and pressures on the areas and lengths of the mesh itself. The request says which
vertices are held, the statistics say the pressures that were found and the reactions. Nothing of the service is
imported. For each mesh one line says, as fractions of the largest force at a support:

- `free`: the largest force at a free vertex that is not balanced (of a vertex that slides, the part along its support;
  of a ring, the part along its axis),
- `sum` and `moment`: what the loads and the forces at the held vertices add up to, the moment divided by the size of
  the structure,
- `stated`: the largest difference between the reactions that the statistics state and those of the mesh.

The script fails if one of them exceeds 1e-8.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

LIMIT = 1e-8
UP = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}


def solved(binary, request, folder):
    source, target = folder / "request.json", folder / "mesh.json"
    source.write_text(json.dumps(request))
    run = subprocess.run([binary, "solve", source, "-o", target], capture_output=True, text=True, check=True)
    return json.loads(target.read_text()), json.loads(run.stdout)


class Forces:
    """Inner forces and loads on the vertices of a mesh."""

    def __init__(self, request, mesh, statistics):
        self.request, self.mesh, self.statistics = request, mesh, statistics
        self.at = np.array(mesh["vertices"], float)
        self.triangles = np.array(mesh["triangles"], int).reshape(-1, 3)
        self.up = np.array(UP[mesh["up"]], float)
        self.inner = np.zeros_like(self.at)
        self.loads = np.zeros_like(self.at)
        self.rims = [line["paths"] for line in mesh["lines"] if line["name"] == "boundaries"]
        self.rims = [path for paths in self.rims for path in paths]

    def members(self, name):
        """Pairs of vertices and their forces, for each cable or mast."""
        for line in self.mesh["lines"]:
            if line["name"] == name or line["name"].startswith(name + " "):
                yield np.array(line["paths"], int), np.array(line["values"]["values"], float)

    def add_members(self, name, sign, weights):
        for (pairs, forces), weight in zip(self.members(name), weights):
            vectors = self.at[pairs[:, 1]] - self.at[pairs[:, 0]]
            lengths = np.linalg.norm(vectors, axis=1)
            pull = (sign * forces / lengths)[:, None] * vectors
            half = -0.5 * weight * lengths[:, None] * self.up
            for end, direction in ((0, 1), (1, -1)):
                np.add.at(self.inner, pairs[:, end], direction * pull)
                np.add.at(self.loads, pairs[:, end], half)

    def add_film(self):
        stress = {name: np.array(values) for name, values in self.mesh["triangle_attributes"].items()}
        corners = self.at[self.triangles]
        double = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        area = 0.5 * np.linalg.norm(double, axis=1)
        normal = double / (2 * area)[:, None]
        along = np.stack([stress[f"stress_max_{axis}"] for axis in "xyz"], axis=1)
        across = np.cross(normal, along)
        for k in range(3):
            opposite = corners[:, (k + 2) % 3] - corners[:, (k + 1) % 3]
            edge = 0.5 * np.cross(normal, opposite)
            for direction, size in ((along, stress["stress_max"]), (across, stress["stress_min"])):
                pull = -(size * np.sum(direction * edge, axis=1))[:, None] * direction
                np.add.at(self.inner, self.triangles[:, k], pull)
        layers = self.request.get("layers") or [self.request["film"]]
        counts = [layer["triangles"] for layer in self.statistics["layers"]]
        starts = np.cumsum([0, *counts])
        for layer, start, end in zip(layers, starts, starts[1:]):
            share = -layer.get("weight", 0) / 3 * area[start:end, None] * self.up
            for k in range(3):
                np.add.at(self.loads, self.triangles[start:end, k], share)
        for chamber in self.statistics["chambers"]:
            below = chamber["below"]
            for layer, sign in ((below, 1), (below + 1, -1)):
                if layer < len(counts):
                    start, end = starts[layer], starts[layer + 1]
                    share = sign * chamber["pressure"] / 6 * double[start:end]
                    for k in range(3):
                        np.add.at(self.loads, self.triangles[start:end, k], share)

    def vertex_of(self, point):
        """The vertex at a point of the request in the air."""
        distances = np.linalg.norm(self.at - np.array(point, float), axis=1)
        return int(np.argmin(distances))


def tensile(request, mesh, statistics):
    """The forces, the held vertices, the rings with their axes, and the sliding supports of the request."""
    forces = Forces(request, mesh, statistics)
    forces.add_film()
    cables, masts = request.get("cables", []), request.get("masts", [])
    forces.add_members("cables", 1, [cable.get("weight", 0) for cable in cables])
    forces.add_members("masts", -1, [0] * len(masts))
    held, rings = set(), []
    for rim in forces.rims:
        held.update(rim)
    chains = [pairs for name in ("cables", "masts") for pairs, _ in forces.members(name)]
    for pairs in chains:
        held -= set(pairs[1:, 0])
    numbers = mesh["input_vertices"]
    for point in request.get("free_points", []):
        held.discard(numbers[point["boundary"]][point["point"]])
    # An end in the air is a support, unless it is a joint or the hub of a ring, which move.
    moving = {tuple(joint) for joint in request.get("joints", [])}
    moving |= {tuple(ring["hub"]) for ring in request.get("rings", []) if ring.get("hub")}
    fixed = {tuple(point) for member in cables + masts for point in member.get("points", [])} - moving
    fixed = {tuple(float(x) for x in point) for point in fixed}
    in_film = set(forces.triangles.ravel().tolist())
    ends = {int(v) for pairs in chains for v in (pairs[0, 0], pairs[-1, 1])}
    held |= {v for v in ends - in_film if tuple(forces.at[v]) in fixed}
    for ring in request.get("rings", []):
        members = set(forces.rims[ring["boundary"]])
        axis = np.array(ring["axis"], float)
        axis /= np.linalg.norm(axis)
        if ring.get("hub"):
            # The hub keeps its place relative to the ring.
            start = np.array(request["boundaries"][ring["boundary"]][0], float)
            travel = forces.at[numbers[ring["boundary"]][0]] - start
            members.add(forces.vertex_of(np.array(ring["hub"], float) + travel))
        forces.loads[min(members)] += ring.get("force", 0) * axis
        rings.append((members, axis))
        held -= members
    return forces, held, rings, request.get("supports", [])


def check(forces, held, rings, supports):
    """The four figures of one mesh."""
    total = forces.inner + forces.loads
    sizes = np.linalg.norm(total, axis=1)
    on_rings = {v for members, _ in rings for v in members}
    borne = held | on_rings
    sliding = set()
    for support in supports:
        if "boundary" not in support or "plane" not in support["on"]:
            raise SystemExit("of sliding supports only whole boundaries on planes are known here")
        normal = np.array(support["on"]["plane"]["normal"], float)
        normal /= np.linalg.norm(normal)
        rim = forces.rims[support["boundary"]]
        for v in rim:
            tangential = total[v] - normal * (normal @ total[v])
            sizes[v] = np.linalg.norm(tangential)
        sliding |= set(rim)
    borne |= sliding
    largest = max(np.linalg.norm(total[list(borne)], axis=1).max(), 1e-300)
    free = [v for v in range(len(sizes)) if v not in held and v not in on_rings]
    worst = sizes[free].max() if free else 0.0
    for members, axis in rings:
        worst = max(worst, abs(sum(total[v] @ axis for v in members)))
    centre = forces.at.mean(axis=0)
    arms = forces.at - centre
    reactions = np.zeros_like(total)
    reactions[list(borne)] = -total[list(borne)]
    outer = reactions + forces.loads
    size = np.linalg.norm(arms, axis=1).max()
    moment = np.linalg.norm(np.cross(arms, outer).sum(axis=0)) / size
    stated = compare(forces, reactions, held)
    return [value / largest for value in (worst, np.linalg.norm(outer.sum(axis=0)), moment, stated)]


def compare(forces, reactions, held):
    """The largest difference between the stated reactions and those at the vertices."""
    statistics = forces.statistics
    listed = [np.array(reaction["force"]) for reaction in statistics["reactions"] + statistics.get("edge_reactions", [])]
    worst = np.linalg.norm(np.sum(listed, axis=0) - reactions.sum(axis=0))
    for reaction in statistics["reactions"]:
        # At a clamped edge the stated reaction is that of the cable alone.
        if not statistics.get("edge_reactions"):
            worst = max(worst, np.linalg.norm(reactions[reaction["vertex"]] - reaction["force"]))
    return worst


def net(request, mesh, statistics):
    forces = Forces(request, mesh, statistics)
    forces.add_members("cables", 1, [0] * len(mesh["lines"]))
    held = set(request["supports"])
    for load in request.get("loads", []):
        on = load.get("vertices")
        on = [v for v in range(len(forces.at)) if v not in held] if on is None else on
        for v in on:
            forces.loads[v] += load["force"]
    return forces, held, [], []


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    binary, files = sys.argv[1], [pathlib.Path(name) for name in sys.argv[2:]]
    files = files or sorted((root / "api" / "examples").glob("*.json"))
    failed = checked = 0
    with tempfile.TemporaryDirectory() as folder:
        for file in files:
            request = json.loads(file.read_text())
            kind = request.get("kind")
            if kind not in ("tensile_structure", "cable_net"):
                continue
            counts = [None]
            if kind == "tensile_structure":
                own = request["resolution"]["triangles"]
                counts = [own // 2, own, 2 * own]
            for count in counts:
                if count is not None:
                    request["resolution"] = {"triangles": count}
                mesh, statistics = solved(binary, request, pathlib.Path(folder))
                read = tensile if kind == "tensile_structure" else net
                figures = check(*read(request, mesh, statistics))
                good = max(figures) <= LIMIT
                failed, checked = failed + (not good), checked + 1
                named = "  ".join(f"{name} {value:.1e}" for name, value in zip(("free", "sum", "moment", "stated"), figures))
                print(f"{'ok  ' if good else 'FAIL'} {file.stem:24} {len(mesh['triangles']):6}  {named}", flush=True)
    print(f"{checked} meshes, {failed} failed")
    sys.exit(1 if failed or not checked else 0)


if __name__ == "__main__":
    main()
