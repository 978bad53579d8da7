#! python3
"""Plateau for Rhino 8: minimal surfaces and ruled strips between picked curves.

A single file: ScriptEditor > Open, or `_-ScriptEditor _Run`. Pick curves; closed ones bound a minimal surface, open
ones are directrices of a ruled strip. The mesh has the document's unit and lies where the curves lie. Esc cancels.
"""

import json
import os
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
PATHS = {"ruled_surface": "/v1/ruled-surfaces", "minimal_surface": "/v1/minimal-surfaces"}
UNITS = {"Millimeters": "mm", "Centimeters": "cm", "Meters": "m", "Inches": "in", "Feet": "ft"}
CURVES = 4
"""Rhino's object filter for curves."""


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
    """A problem document, or the error of a failed job, as text with the place of every value that is wrong."""
    places = [f"{error['pointer']}: {error['detail']}" for error in problem.get("errors", [])]
    return "; ".join(places) or f"{problem['title']}: {problem['detail']}"


def explain_answer(body):
    """An answer that is a failure as text; a proxy's own answer need not be a problem document."""
    try:
        return explain(json.loads(body))
    except (ValueError, KeyError):
        return body[:200].decode("utf-8", "replace")


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


def make_request(curves, unit):
    closed = [curve.IsClosed for curve in curves]
    lines = [points_of(curve) for curve in curves]
    if all(closed):
        return {"kind": "minimal_surface", "boundaries": lines, "units": unit, "up": "z"}
    if any(closed) or len(lines) < 2:
        raise PlateauError("pick closed curves for a minimal surface, or two open curves or more for a ruled strip")
    return {"kind": "ruled_surface", "directrices": lines, "direction": "auto", "units": unit, "up": "z"}


def read_ply(data):
    """Vertices (f64) and triangles of the server's binary PLY."""
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = [line.split() for line in data[:end].decode().splitlines()]
    types = {"double": "d", "float": "f", "uchar": "B"}
    columns = "".join(types[line[1]] for line in header if line[0] == "property" and line[1] != "list")
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


def main():
    ids = rs.GetObjects("Pick closed curves, or two open ones", filter=CURVES, preselect=True)
    if not ids:
        return None
    try:
        unit = UNITS.get(str(sc.doc.ModelUnitSystem).split(".")[-1])
        if unit is None:
            raise PlateauError(f"the document's unit {sc.doc.ModelUnitSystem} is none of {', '.join(UNITS)}")
        outcome = solve(make_request([rs.coercecurve(one) for one in ids], unit))
    except PlateauError as error:
        Rhino.RhinoApp.WriteLine(f"Plateau: {error}")
        return None
    if outcome is None:
        Rhino.RhinoApp.WriteLine("Plateau: cancelled")
        return None
    job, ply = outcome
    made = sc.doc.Objects.AddMesh(make_mesh(ply))
    sc.doc.Views.Redraw()
    # `far_from_zero` is about STL files.
    for warning in (one for one in job["warnings"] if one["code"] != "far_from_zero"):
        Rhino.RhinoApp.WriteLine(f"Plateau: {warning['detail']}")
    return made


if __name__ == "__main__":
    main()
