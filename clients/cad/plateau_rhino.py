#! python3
"""Plateau for Rhino 8: minimal surfaces, ruled strips, lattices, membranes and cable nets from picked curves.

A single file: ScriptEditor > Open, or `_-ScriptEditor _Run`. Pick curves and answer the prompts. The result has the
document's unit and lies where the curves lie. It remembers its curves and settings: pick it, or the same curves, and run
the script again, and it is replaced in one undo step. Esc cancels.
"""

import json
import os
import re
import struct
import urllib.error
import urllib.request

import Rhino
import rhinoscriptsyntax as rs
import scriptcontext as sc

URL = os.environ.get("PLATEAU_URL", "http://127.0.0.1:8080")
API_KEY = os.environ.get("PLATEAU_API_KEY", "")

SAMPLES = 96
"""Number of points on the curved pieces of a curve together."""
LEAST_SAMPLES = 8
"""Number of points on a curved piece that is short beside the others."""
ENDED = ("succeeded", "failed", "cancelled")
PATHS = {
    "ruled_surface": "/v1/ruled-surfaces",
    "minimal_surface": "/v1/minimal-surfaces",
    "uniform_mesh": "/v1/uniform-meshes",
    "tensile_structure": "/v1/tensile-structures",
    "cable_net": "/v1/cable-nets",
}
SURFACES = {
    "MinimalSurface": "minimal_surface",
    "RuledStrip": "ruled_surface",
    "Lattice": "uniform_mesh",
    "Membrane": "tensile_structure",
    "CableNet": "cable_net",
}
"""The words of the first prompt."""
OBJECTIVES = {
    "minimal_surface": ["minimal_area", "minimal_dirichlet_energy", "minimal_mean_curvature"],
    "ruled_surface": ["minimal_area", "minimal_twist", "maximal_convexity", "minimal_bending_energy"],
    "uniform_mesh": ["most_equal_edges", "fewest_nodes"],
}
NUMBERS = {
    "minimal_surface": {"triangles": "Number of triangles"},
    "ruled_surface": {},
    "uniform_mesh": {"edge_length": "Length of the members"},
    "tensile_structure": {
        "tension": "Tension of the film, kN per unit of length",
        "edge_force": "Force of the cables between corners in kN, or 0 for fixed edges",
        "triangles": "Number of triangles",
    },
    "cable_net": {"force_density": "Force per length of each cable, kN per unit of length"},
}
"""The numbers that each kind asks for. Open ends of a cable net are its supports."""
CORNER = 0.94
"""Cosine of the least turn at a corner between the cables of a membrane: 20 degrees."""
NEAR = 1e-6
"""Ends of cables that are nearer than this share of the net's size are one vertex."""
KEY = "plateau"
"""Name of the user text that a result remembers its curves and settings by."""
UNITS = {"Millimeters": "mm", "Centimeters": "cm", "Meters": "m", "Inches": "in", "Feet": "ft"}
CURVES, MESHES = 4, 32
"""Rhino's object filters."""


class PlateauError(Exception):
    """What is wrong, in words for the user."""


def send(method, path, body=None, headers=None):
    headers = dict(headers or {})
    if API_KEY:
        headers["Authorization"] = "Bearer " + API_KEY
    if body is not None:
        headers["Content-Type"] = "application/json"
        body = json.dumps(body).encode()
    request = urllib.request.Request(URL.rstrip("/") + path, data=body, headers=headers, method=method)
    try:
        with urllib.request.urlopen(request, timeout=60) as response:
            return response.read()
    except urllib.error.HTTPError as error:
        raise PlateauError(explain_answer(error.read())) from None
    except OSError as error:
        raise PlateauError(f"{URL} cannot be reached: {error}") from None


def explain(problem):
    """A problem document, or the error of a failed job, as text. `solve` puts names in the place of pointers."""
    places = [f"{error['pointer']}: {error['detail']}" for error in problem.get("errors", [])]
    return "; ".join(places) or f"{problem['title']}: {problem['detail']}"


def explain_answer(body):
    """An answer that is a failure as text; a proxy's own answer need not be a problem document."""
    try:
        return explain(json.loads(body))
    except (ValueError, KeyError):
        return body[:200].decode("utf-8", "replace")


def in_words(text, names):
    """A message with the names of the picked objects and of the settings in the place of JSON pointers."""

    def words(found):
        pointer = found.group(0)
        curve = re.match(r"/(?:domain/)?(?:boundaries|directrices|holes)/(\d+)", pointer)
        if curve:
            index = int(curve.group(1)) + (1 if "/holes/" in pointer else 0)
            return names[index] if index < len(names) else "a curve"
        if pointer.startswith("/domain/polygon"):
            return names[0]
        parts = [part for part in pointer.split("/") if part and not part.isdigit()]
        if parts[0] in ("boundaries", "directrices", "domain", "vertices", "edges", "supports"):
            return "the picked curves" if len(names) > 1 else names[0]
        return "the " + " of the ".join(part.replace("_", " ") for part in reversed(parts))

    return re.sub(r"(?<![\w/.:])/[a-z_]+(?:/[\w-]+)*", words, text)


def solve(request):
    """The finished job and its PLY; None if Esc was pressed."""
    job = json.loads(send("POST", PATHS[request["kind"]], request))
    while job["status"] not in ENDED:
        if sc.escape_test(False):
            send("POST", f"/v1/jobs/{job['id']}/cancel")
            return None
        job = json.loads(send("GET", f"/v1/jobs/{job['id']}", headers={"Prefer": "wait=1"}))
        progress = job["progress"]
        Rhino.RhinoApp.SetCommandPrompt(f"Plateau: {progress['phase']} {100 * progress['fraction']:.0f} %")
    if job["status"] != "succeeded":
        raise PlateauError(explain(job["error"]) if job.get("error") else "the job was cancelled")
    return job, send("GET", f"/v1/jobs/{job['id']}/mesh?format=ply")


def points_of(curve):
    """The points of a curve, the first of a closed one not repeated.

    A curve is split at its kinks. Straight pieces keep their ends, and curved ones are divided into equal lengths.
    """
    found, polyline = curve.TryGetPolyline()
    if found:
        points = list(polyline)
    else:
        pieces = smooth_pieces(curve)
        lengths = [0.0 if piece.IsLinear() else piece.GetLength() for piece in pieces]
        points = [pieces[0].PointAtStart]
        for piece, length in zip(pieces, lengths):
            if length > 0.0:
                count = max(LEAST_SAMPLES, round(SAMPLES * length / sum(lengths)))
                # The parameters of a closed piece leave out its end.
                points += [piece.PointAt(at) for at in piece.DivideByCount(count, True)[1:count]]
            points.append(piece.PointAtEnd)
    points = [[point.X, point.Y, point.Z] for point in points]
    return points[:-1] if curve.IsClosed else points


def smooth_pieces(curve):
    """The pieces of a curve between its kinks."""
    start, end = curve.Domain.T0, curve.Domain.T1
    cuts = [start]
    while True:
        found, at = curve.GetNextDiscontinuity(Rhino.Geometry.Continuity.G1_continuous, cuts[-1], end)
        if not found or not cuts[-1] < at < end:
            break
        cuts.append(at)
    if len(cuts) == 1:
        return [curve]
    return [curve.Trim(a, b) for a, b in zip(cuts, cuts[1:] + [end])]


def kind_by_curves(curves):
    """What the first prompt offers."""
    return "MinimalSurface" if all(curve.IsClosed for curve in curves) else "RuledStrip"


def default_numbers(curves):
    """Numbers that suit the size of the curves."""
    length = float(f"{size_of([point for curve in curves for point in points_of(curve)]) / 20:.1g}")
    return {"triangles": 2000, "edge_length": length, "tension": 1.0, "edge_force": 0.0, "force_density": 1.0}


def size_of(points):
    """Diagonal of the points' box."""
    return sum((max(axis) - min(axis)) ** 2 for axis in zip(*points)) ** 0.5


def make_request(curves, unit, settings):
    """The request of a kind for curves, by the settings that its prompts ask for."""
    kind = settings["kind"]
    lines = [points_of(curve) for curve in curves]
    closed = [curve.IsClosed for curve in curves]
    request = {"kind": kind, "units": unit, "up": "z"}
    if "objective" in settings:
        request["objective"] = settings["objective"]
    if kind in ("tensile_structure", "cable_net"):
        request["units"] = {"length": unit, "force": "kN"}
    if kind in ("minimal_surface", "tensile_structure"):
        request["resolution"] = {"triangles": int(settings["triangles"])}
    if kind == "cable_net":
        return {**request, **net_of(lines, closed), "cables": [{"force_density": settings["force_density"]}]}
    if kind == "ruled_surface":
        if len(lines) < 2 or len(set(closed)) != 1:
            raise PlateauError("a ruled strip needs two curves or more, all open or all closed")
        return {**request, "directrices": lines, "closed": closed[0], "direction": "auto"}
    if not all(closed):
        raise PlateauError(f"a {SURFACE_OF[kind]} needs closed curves")
    if kind == "uniform_mesh":
        flat = all(is_flat(line) for line in lines)
        domain = {"polygon": lines[0], "holes": lines[1:]} if flat else {"boundaries": lines}
        return {**request, "domain": domain, "edge_length": settings["edge_length"]}
    if kind == "tensile_structure":
        cables = edge_cables(lines, settings["edge_force"]) if settings["edge_force"] > 0 else []
        request = {**request, "film": {"tension": settings["tension"]}, "cables": cables}
    return {**request, "boundaries": lines}


SURFACE_OF = {"minimal_surface": "minimal surface", "uniform_mesh": "lattice", "tensile_structure": "membrane"}


def difference(a, b):
    return [one - other for one, other in zip(a, b)]


def dot(a, b):
    return sum(one * other for one, other in zip(a, b))


def is_flat(line):
    """Whether a closed polyline lies in a plane, within a thousandth of its size."""
    area = [0.0, 0.0, 0.0]
    for a, b in zip(line, line[1:] + line[:1]):
        a, b = difference(a, line[0]), difference(b, line[0])
        cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        area = [one + other for one, other in zip(area, cross)]
    length = dot(area, area) ** 0.5
    return length > 0 and all(abs(dot(difference(p, line[0]), area)) <= 1e-3 * size_of(line) * length for p in line)


def edge_cables(lines, force):
    """A cable along each boundary between two of its corners."""
    cables = []
    for boundary, line in enumerate(lines):
        corners = []
        for index, point in enumerate(line):
            before, after = difference(point, line[index - 1]), difference(line[(index + 1) % len(line)], point)
            if dot(before, after) < CORNER * (dot(before, before) * dot(after, after)) ** 0.5:
                corners.append(index)
        for start, end in zip(corners, corners[1:] + corners[:1]) if len(corners) > 1 else []:
            along = {"boundary": boundary, "from": start, "to": end}
            cables.append({"along": along, "mode": "force", "value": force})
    return cables


def net_of(lines, closed):
    """Vertices and edges of a net. Points that lie together are one vertex, and vertices with one edge are supports."""
    near = NEAR * size_of([point for line in lines for point in line])
    origin = lines[0][0]
    vertices, index_of, edges, count = [], {}, {}, []

    def vertex(point):
        cell = [round(value / near) for value in difference(point, origin)] if near > 0 else [0, 0, 0]
        neighbours = [(cell[0] + i, cell[1] + j, cell[2] + k) for i in (0, -1, 1) for j in (0, -1, 1) for k in (0, -1, 1)]
        found = next((index_of[one] for one in neighbours if one in index_of), None)
        if found is None:
            found = index_of[tuple(cell)] = len(vertices)
            vertices.append(point)
            count.append(0)
        return found

    for line, is_closed in zip(lines, closed):
        along = [vertex(point) for point in line]
        for a, b in zip(along, along[1:] + (along[:1] if is_closed else [])):
            if a != b and (min(a, b), max(a, b)) not in edges:
                edges[min(a, b), max(a, b)] = [a, b]
                count[a] += 1
                count[b] += 1
    supports = [one for one, number in enumerate(count) if number == 1]
    if not supports:
        raise PlateauError("a cable net needs open ends: they are its supports")
    return {"vertices": vertices, "edges": list(edges.values()), "supports": supports}


def read_ply(data):
    """Vertices (f64) and triangles of the server's binary PLY."""
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = [line.split() for line in data[:end].decode().splitlines()]
    types = {"double": "d", "float": "f", "uchar": "B"}
    # Lists belong to the faces, and integers to the edges of a net, as does the force that follows them.
    own = header[: next(index for index, line in enumerate(header) if line[:2] == ["element", "face"])]
    columns = "".join(types[line[1]] for line in own if line[0] == "property")
    counts = {line[1]: int(line[2]) for line in header if line[0] == "element"}
    row, face = struct.Struct("<" + columns), struct.Struct("<B3I")
    faces = end + row.size * counts["vertex"]
    vertices = [values[:3] for values in row.iter_unpack(data[end:faces])]
    return vertices, [values[1:] for values in face.iter_unpack(data[faces : faces + face.size * counts["face"]])]


def make_mesh(ply):
    """A Rhino mesh that keeps f64, so that it is exact at survey coordinates too."""
    vertices, triangles = read_ply(ply)
    mesh = Rhino.Geometry.Mesh()
    mesh.Vertices.UseDoublePrecisionVertices = True
    for x, y, z in vertices:
        mesh.Vertices.Add(x, y, z)
    for a, b, c in triangles:
        mesh.Faces.AddFace(a, b, c)
    mesh.Normals.ComputeNormals()
    mesh.Compact()
    return mesh


def ask(curves, remembered):
    """The settings that the user chooses, beginning with those of the result that is replaced. None after Esc."""
    settings = {**default_numbers(curves), **remembered}
    offered = next((word for word, kind in SURFACES.items() if kind == remembered.get("kind")), kind_by_curves(curves))
    word = rs.GetString("Plateau: what to make", offered, list(SURFACES))
    if word not in SURFACES:
        return None
    kind = SURFACES[word]
    chosen = {"kind": kind}
    if kind in OBJECTIVES:
        # Rhino's options have no underscores.
        words = {"".join(part.title() for part in name.split("_")): name for name in OBJECTIVES[kind]}
        first = next((text for text, name in words.items() if name == settings.get("objective")), next(iter(words)))
        text = rs.GetString("Plateau: objective", first, list(words))
        if text not in words:
            return None
        chosen["objective"] = words[text]
    for name, prompt in NUMBERS[kind].items():
        number = rs.GetReal(f"Plateau: {prompt}", settings[name], 0.0)
        if number is None:
            return None
        chosen[name] = number
    return chosen


def memory_of(one):
    """What a result remembers; None for any other object."""
    text = rs.GetUserText(one, KEY)
    return json.loads(text) if text else None


def results_with(curves):
    """The objects of the results that were made from these curves."""
    found = [(one, memory_of(one)) for one in rs.ObjectsByType(CURVES | MESHES) or []]
    return [(one, memory) for one, memory in found if memory and set(memory["curves"]) == set(curves)]


def replace(old, job, ply, lines, memory):
    """Puts a result in the place of the old one, in one undo step."""
    record = sc.doc.BeginUndoRecord("Plateau")
    try:
        if old:
            rs.DeleteObjects(old)
        if lines:
            vertices, _ = read_ply(ply)
            made = [rs.AddLine(vertices[a], vertices[b]) for a, b in lines]
            rs.AddObjectsToGroup(made, rs.AddGroup())
        else:
            made = [sc.doc.Objects.AddMesh(make_mesh(ply))]
        for one in made:
            rs.SetUserText(one, KEY, json.dumps({**memory, "job": job["id"]}))
    finally:
        sc.doc.EndUndoRecord(record)
    sc.doc.Views.Redraw()
    return made


def main():
    picked = rs.GetObjects("Pick curves, or a result to make again", filter=CURVES | MESHES, preselect=True)
    if not picked:
        return None
    names = []
    try:
        unit = UNITS.get(str(sc.doc.ModelUnitSystem).split(".")[-1])
        if unit is None:
            raise PlateauError(f"the document's unit {sc.doc.ModelUnitSystem} is none of {', '.join(UNITS)}")
        own = next((memory for memory in map(memory_of, picked) if memory), None)
        ids = own["curves"] if own else [str(one) for one in picked]
        old = results_with(ids)
        curves = [rs.coercecurve(one) for one in ids]
        if any(curve is None for curve in curves):
            raise PlateauError("a curve of this result is gone, or a picked object is no curve")
        names += [rs.ObjectName(one) or f"curve {number}" for number, one in enumerate(ids, 1)]
        settings = ask(curves, old[0][1]["settings"] if old else {})
        if settings is None:
            return None
        request = make_request(curves, unit, settings)
        outcome = solve(request)
    except PlateauError as error:
        Rhino.RhinoApp.WriteLine(f"Plateau: {in_words(str(error), names)}")
        return None
    if outcome is None:
        Rhino.RhinoApp.WriteLine("Plateau: cancelled")
        return None
    job, ply = outcome
    memory = {"curves": ids, "settings": settings}
    made = replace([one for one, _ in old], job, ply, request.get("edges"), memory)
    # `far_from_zero` is about STL files.
    for warning in (one for one in job["warnings"] if one["code"] != "far_from_zero"):
        Rhino.RhinoApp.WriteLine(f"Plateau: {in_words(warning['detail'], names)}")
    return made


if __name__ == "__main__":
    main()
