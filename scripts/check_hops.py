"""Talks with the server as Hops does, with rhino3dm as the other side of the geometry and ghhops-server as the peer.

Usage: PLATEAU_URL=http://… check_hops.py. The messages have the fields that the sources of Hops write
(mcneel/compute.rhino3d, src/hops/RemoteDefinition.cs) and the values that the tests of ghhops-server use. Rhino itself is
not part of this check.
"""

import base64
import json
import math
import os
import socket
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
import xml.etree.ElementTree as ET
from pathlib import Path
from random import Random

import rhino3dm as rhino

URL = os.environ.get("PLATEAU_URL", "")
Point = rhino.Point3d

# Components of the same shape as ours, served by ghhops-server. The first two are those of its own tests.
PEER = """
import sys
import ghhops_server as hs
hops = hs.Hops()

@hops.component("/binmult", inputs=[hs.HopsNumber("A"), hs.HopsNumber("B")], outputs=[hs.HopsNumber("Multiply")])
def multiply(a: float, b: float):
    return a * b

@hops.component("/pointat", name="PointAt", nickname="PtAt", description="Get point along curve",
                inputs=[hs.HopsCurve("Curve", "C", "Curve to evaluate"), hs.HopsNumber("t", "t", "Parameter")],
                outputs=[hs.HopsPoint("P", "P", "Point on curve at t")])
def point_at(curve, t=0.0):
    return curve.PointAt(t)

@hops.component("/minimal-surface", name="Minimal Surface", nickname="Film", description="Stand-in",
                inputs=[hs.HopsCurve("Boundaries", "B", "Closed curves.", access=hs.HopsParamAccess.LIST),
                        hs.HopsInteger("Triangles", "T", "Number of triangles.")],
                outputs=[hs.HopsMesh("Mesh", "M", "The mesh."), hs.HopsNumber("Area", "A", "Its area."),
                         hs.HopsString("Statistics", "S", "Figures.", access=hs.HopsParamAccess.LIST)])
def film(boundaries, triangles):
    import rhino3dm
    mesh = rhino3dm.Mesh()
    for x, y in [(0, 0), (1, 0), (0, 1)]:
        mesh.Vertices.Add(x, y, 0)
    mesh.Faces.AddFace(0, 1, 2)
    return mesh, 0.5, ["triangles: 1", "vertices: 3"]

hops.start("127.0.0.1", int(sys.argv[1]))
"""


def call(url, message=None, headers=None):
    """Returns status, media type and JSON of an answer."""
    body = None if message is None else json.dumps(message).encode()
    headers = {"Content-Type": "application/json; charset=utf-8", **(headers or {})}
    try:
        with urllib.request.urlopen(urllib.request.Request(url, body, headers)) as answer:
            return answer.status, answer.headers["Content-Type"], json.load(answer)
    except urllib.error.HTTPError as error:
        text = error.read()
        return error.code, error.headers["Content-Type"], json.loads(text) if text[:1] in b"[{" else None


def tree(name, kind, values):
    items = [{"type": kind, "data": json.dumps(value.Encode() if hasattr(value, "Encode") else value)} for value in values]
    return {"ParamName": name, "InnerTree": {"{0}": items}}


def number(name, value):
    return tree(name, "System.Double", [value])


def integer(name, value):
    return tree(name, "System.Int32", [value])


def text(name, value):
    return tree(name, "System.String", [value])


def curves(name, values):
    return tree(name, "Rhino.Geometry.Curve", values)


def points(name, values):
    return tree(name, "Rhino.Geometry.Point3d", [dict(zip("XYZ", value)) for value in values])


def message(pointer, *values):
    """Returns the JSON of the class Schema of Hops."""
    return {"absolutetolerance": 0.001, "angletolerance": 1.0, "modelunits": "Millimeters", "algo": None,
            "pointer": pointer, "cachesolve": True, "recursionlevel": 0, "values": list(values), "warnings": [], "errors": []}


def solve(pointer, *values):
    # Hops replaces the last part of the component's address by `solve`; its later versions post to the host's root.
    status, media_type, answer = call(URL + "/hops/solve", message(pointer, *values))
    assert status == 200 and "json" in media_type and answer["errors"] == [], (status, answer["errors"])
    return {one["ParamName"]: [decode(item) for item in one["InnerTree"]["{0}"]] for one in answer["values"]}


def decode(item):
    value = json.loads(item["data"])
    return rhino.CommonObject.Decode(value) if isinstance(value, dict) and "archive3dm" in value else value


def polyline(corners):
    line = rhino.Polyline(len(corners))
    for corner in corners:
        line.Add(*corner)
    return line.ToPolylineCurve()


def vertices(mesh):
    return [(point.X, point.Y, point.Z) for point in (mesh.Vertices.Point3dAt(k) for k in range(len(mesh.Vertices)))]


def cross_area(mesh):
    at = vertices(mesh)
    total = 0.0
    for k in range(len(mesh.Faces)):
        a, b, c = (at[vertex] for vertex in mesh.Faces[k][:3])
        u, v = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
        total += math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2
    return total


def length(curve):
    """Returns the length of a polyline curve."""
    ends = [curve.Point(k) for k in range(curve.PointCount)]
    return sum(a.DistanceTo(b) for a, b in zip(ends, ends[1:]))


def closed_curves():
    """One closed curve of every class around the same disc of radius 2, at survey coordinates."""
    x, y = 1_000_000.1, 2_000_000.2
    circle = rhino.Circle(Point(x, y, 3.0), 2.0)
    corners = [(x + 2 * math.cos(k * math.pi / 32), y + 2 * math.sin(k * math.pi / 32), 3.0) for k in range(64)]
    halves = rhino.PolyCurve()
    halves.Append(rhino.Arc(Point(x + 2, y, 3), Point(x, y + 2, 3), Point(x - 2, y, 3)))
    halves.Append(rhino.Arc(Point(x - 2, y, 3), Point(x, y - 2, 3), Point(x + 2, y, 3)))
    lines = rhino.PolyCurve()
    for a, b in zip(corners, corners[1:] + corners[:1]):
        lines.AppendSegment(rhino.LineCurve(Point(*a), Point(*b)))
    return {
        "PolylineCurve": polyline(corners + corners[:1]),
        "ArcCurve": rhino.ArcCurve.CreateFromCircle(circle),
        "NurbsCurve": rhino.NurbsCurve.CreateFromCircle(circle),
        "PolyCurve of arcs": halves,
        "PolyCurve of lines": lines,
        "NurbsCurve, periodic": rhino.NurbsCurve.Create(True, 3, [Point(*corner) for corner in corners]),
    }


def check_curves():
    for name, curve in closed_curves().items():
        assert curve.IsValid, name
        outputs = solve("minimal-surface", curves("Boundaries", [curve]), integer("Triangles", 400))
        mesh = outputs["Mesh"][0]
        valid, log = mesh.IsValidWithLog if isinstance(mesh.IsValidWithLog, tuple) else (mesh.IsValid, "")
        assert valid, (name, log)
        assert len(mesh.Normals) == len(mesh.Vertices), name
        # A polygon of 61 points or more within a circle lacks less than 0.4 % of its area.
        area = outputs["Area"][0]
        assert 0.99 < area / (4 * math.pi) < 1.0001 and abs(cross_area(mesh) / area - 1) < 1e-6, (name, area)
        assert all(abs(z - 3) < 1e-9 for _, _, z in vertices(mesh)), name
        print(f"{name}: {len(mesh.Vertices)} vertices, area {area / (4 * math.pi):.5f} of the disc's")


def check_precision():
    """Vertices of the boundary at 1e6 are the very numbers of the curve, in both directions."""
    corners = [(1e6 + 0.1, 2e6 + 0.2, 0.0), (1e6 + 1.1, 2e6 + 0.2, 1 / 3), (1e6 + 1.1, 2e6 + 1.2, 0.0), (1e6 + 0.1, 2e6 + 1.2, 0.7)]
    outputs = solve("minimal-surface", curves("Boundaries", [polyline(corners + corners[:1])]), integer("Triangles", 200))
    found = set(vertices(outputs["Mesh"][0]))
    assert found.issuperset(corners), corners
    # rhino3dm writes the mesh again, and the server reads it again.
    again = solve("film-from-mesh", tree("Mesh", "Rhino.Geometry.Mesh", [outputs["Mesh"][0]]))
    kept = found & set(vertices(again["Mesh"][0]))
    assert kept.issuperset(corners) and abs(again["Area"][0] / outputs["Area"][0] - 1) < 1e-6
    print(f"precision: {len(corners)} corners at 1e6 exact, there and back")


def check_components():
    rails = [polyline([(k / 4, y, bend * (k / 4 - 1.5) ** 2) for k in range(12)]) for y, bend in [(0, .2), (1, -.1), (2, .3)]]
    strip = solve("ruled-strip", curves("Rails", rails), text("Objective", "minimal_twist"))
    flat = sum(abs(sum(a.X * b.Y - a.Y * b.X for a, b in zip(line, line[1:]))) / 2
               for line in ([curve.Point(k) for k in range(curve.PointCount)] for curve in strip["Outlines"]))
    assert len(strip["Outlines"]) == 2 and abs(flat / strip["Area"][0] - 1) < 1e-9 and all(one.IsClosed for one in strip["Outlines"])
    assert len(strip["Folds"]) == len(strip["Fold Angles"]) > 10
    nurbs = rhino.NurbsCurve.Create(False, 3, [Point(0, 0, 0), Point(1, 1, 0), Point(2, -1, 1), Point(3, 0, 0)])
    line = rhino.LineCurve(Point(0, 3, 0), Point(3, 3, 0))
    mixed = solve("ruled-strip", curves("Rails", [nurbs, line]), integer("Samples", 30))
    assert len(mixed["Mesh"][0].Faces) == 58
    square = polyline([(0, 0, 0), (10, 0, 0), (10, 10, 0), (0, 10, 0), (0, 0, 0)])
    grid = solve("uniform-mesh", curves("Boundaries", [square]), number("Edge Length", 1.0))
    assert abs(cross_area(grid["Mesh"][0]) - 100) < 1e-9 and len(grid["Members"]) == len(grid["Member Lengths"])
    assert all(abs(length(curve) - value) < 1e-9 for curve, value in zip(grid["Members"], grid["Member Lengths"]))
    corners = [(0, 0, 0), (10, 0, 4), (10, 10, 0), (0, 10, 4)]
    sail = solve("tensile-structure", curves("Boundaries", [polyline(corners + corners[:1])]), points("Anchors", corners),
                 number("Cable Value", 12.0), integer("Triangles", 300))
    assert len(sail["Cables"]) == len(sail["Cable Forces"]) and len(sail["Anchor Forces"]) == 4
    dome = solve("pneumatic-film", curves("Boundaries", [closed_curves()["ArcCurve"]]), number("Pressure", 0.4),
                 integer("Triangles", 300))
    assert max(z for _, _, z in vertices(dome["Mesh"][0])) > 3.1
    started = solve("minimal-surface-start", curves("Boundaries", [square]), integer("Triangles", 100))
    for refresh in range(600):
        status, _, answer = call(URL + "/solve", message("/hops/minimal-surface-poll", text("Job", started["Job"][0]),
                                                         number("Refresh", refresh)))
        if status == 200:
            break
        assert status == 202, answer
        time.sleep(0.1)  # between two looks
    assert decode(answer["values"][0]["InnerTree"]["{0}"][0]) == "succeeded" and abs(decode(answer["values"][3]["InnerTree"]["{0}"][0]) - 100) < 1e-6
    print("components: strip, flat pattern, uniform mesh, sail, dome, start and poll")


def check_files():
    """Patterns and schedules as lines, and the Grasshopper files in the repository."""
    strip = solve("ruled-strip", curves("Rails", [polyline([(0, y, 0), (1, y, y / 4), (2, y, 0)]) for y in (0, 1)]))
    drawing = solve("pattern", text("Job", strip["Job"][0]), text("Query", "format=dxf"))["Lines"]
    # The first pair is a comment with the program's name.
    assert [line.strip() for line in drawing[:4]] == ["999", drawing[1], "0", "SECTION"] and drawing[-1] == "EOF", drawing[:4]
    table = solve("schedule", text("Job", strip["Job"][0]), text("Query", "part=bends"))["Lines"]
    assert len(table) > 1 and "," in table[0], table
    subprocess.run([sys.executable, str(Path(__file__).parent / "grasshopper_files.py"), "--check"], check=True)
    paths = sorted((Path(__file__).parent.parent / "clients" / "grasshopper").glob("*.ghx"))
    for path in paths:
        root = ET.parse(path).getroot()
        for parts in [*root.iter("items"), *root.iter("chunks")]:
            assert int(parts.get("count")) == len(parts), (path, parts.attrib)
        value = {item.get("name"): item.text for item in root.iter("item")}
        assert int(value["ObjectCount"]) == len(list(root.iterfind(".//chunk[@name='Object']")))
        address = value["RemoteDefinitionLocation"]
        assert address == f"http://localhost:8080/hops/{path.stem}", address
        assert call(URL + f"/hops/{path.stem}")[2]["Nickname"] == value["NickName"]
    print(f"files: pattern, schedule, {len(paths)} files of Grasshopper")


def rails(random):
    """Two rails of lines, arcs or NURBS curves that lie side by side and run the same way, and the second one reversed."""
    width, height = [random.uniform(0.3, 2.5) for _ in range(2)], [random.uniform(-2, 2) for _ in range(2)]
    kind, size, angle = random.choice(["line", "arc", "spline"]), random.uniform(3, 10), random.uniform(0.3, 4.5)
    bends = [(random.uniform(-1, 1), random.uniform(-1, 1)) for _ in range(6)]

    def curve(side, backwards):
        def at(t):
            across, up = side * (width[0] + t * (width[1] - width[0])), side * (height[0] + t * (height[1] - height[0]))
            if kind == "arc":
                # The heights of an arc's points are those of a plane, so that it stays an arc.
                x, y = math.cos(angle * t), math.sin(angle * t)
                return Point((size - side * width[0]) * x, (size - side * width[0]) * y, side * (height[0] + 0.1 * height[1] * x))
            bend = bends[round(5 * t)] if kind == "spline" else (0, 0)
            return Point(2 * size * t, across + bend[0], up + bend[1])

        def along(count):
            return [at((count - 1 - k if backwards else k) / (count - 1)) for k in range(count)]

        if kind == "line":
            return rhino.LineCurve(*along(2))
        if kind == "arc":
            joined = rhino.PolyCurve()
            joined.Append(rhino.Arc(*along(3)))
            return joined
        return rhino.NurbsCurve.Create(False, 3, along(6))

    return curve(0, False), curve(1, False), curve(1, True)


def check_directions(pairs=100):
    """No rail of known direction is reversed, and every one that runs against its neighbour is."""
    random = Random(7)
    for k in range(pairs):
        first, second, backwards = rails(random)
        for other, runs_against in [(second, "false"), (backwards, "true")]:
            outputs = solve("ruled-strip", curves("Rails", [first, other]))
            assert f"reversed: false, {runs_against}" in outputs["Statistics"], (k, runs_against, outputs["Statistics"])
    print(f"directions: {pairs} pairs of rails, each also with one rail reversed")


def check_units():
    """The document of these messages is in millimetres."""
    square = polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 0)])
    outputs = solve("minimal-surface", curves("Boundaries", [square]), integer("Triangles", 50))
    mesh = call(f"{URL}/v1/jobs/{outputs['Job'][0]}/mesh?format=gltf")[2]
    assert mesh["asset"]["extras"]["unit"] == "mm", mesh["asset"]
    miles = {**message("minimal-surface", curves("Boundaries", [square])), "modelunits": "Miles"}
    status, _, answer = call(URL + "/hops/solve", miles)
    assert status == 422 and "Miles" in answer["errors"][0], answer
    print("units: those of the document; miles are refused")


def check_icon():
    status, _, described = call(URL + "/hops/minimal-surface")
    assert status == 200 and base64.b64decode(described["Icon"]).startswith(b"\x89PNG")


def shape(value):
    """Returns a value with its leaves replaced by the names of their types."""
    if isinstance(value, dict):
        return {key: shape(one) for key, one in value.items()}
    if isinstance(value, list):
        return [shape(one) for one in value]
    return type(value).__name__


def check_peer():
    """The same messages to ghhops-server and to this server give answers of the same shape."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    peer = f"http://127.0.0.1:{port}"
    folder = tempfile.TemporaryDirectory()
    program = os.path.join(folder.name, "peer.py")
    with open(program, "w") as file:
        file.write(PEER)
    process = subprocess.Popen([sys.executable, program, str(port)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        for _ in range(1200):
            try:
                call(peer + "/pointat")
                break
            except urllib.error.URLError:
                time.sleep(0.1)  # between two looks
        # The peer itself works with the requests of its own tests.
        _, _, product = call(peer + "/solve", message("binmult", number("A", 3.0), number("B", 4.0)))
        assert decode(product["values"][0]["InnerTree"]["0"][0]) == 12.0
        line = rhino.LineCurve(Point(0, 0, 0), Point(2, 0, 0))
        _, _, at = call(peer + "/solve", message("pointat", curves("Curve", [line]), number("t", 1.0)))
        assert at["errors"] == [] if "errors" in at else at["values"][0]["ParamName"] == "P"

        # Descriptions: every field of the peer's is there, with the same type.
        theirs, ours = call(peer + "/minimal-surface"), call(URL + "/hops/minimal-surface")
        assert theirs[0] == ours[0] == 200 and "json" in ours[1]
        assert set(theirs[2]) <= set(ours[2]), set(theirs[2]) - set(ours[2])
        for side in ["Inputs", "Outputs"]:
            own = {one["Name"]: one for one in ours[2][side]}
            for one in theirs[2][side]:
                for field in ["Name", "ParamType", "ResultType", "AtLeast"] + ["AtMost"] * (side == "Inputs"):
                    assert own[one["Name"]][field] == one[field], (field, one, own[one["Name"]])
        assert isinstance(call(peer + "/")[2], list) and isinstance(call(URL + "/hops")[2], list)

        # Solving: the same values by name, type and form of the data.
        square = polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 0)])
        asked = message("minimal-surface", curves("Boundaries", [square]), integer("Triangles", 50))
        theirs, ours = call(peer + "/solve", asked), call(URL + "/solve", {**asked, "pointer": "hops/minimal-surface"})
        assert theirs[0] == ours[0] == 200
        own = {one["ParamName"]: one for one in ours[2]["values"]}
        for one in theirs[2]["values"]:
            # ghhops-server names the branch `0`, and Rhino.Compute `{0}`. Hops removes the brackets.
            (branch, items), = own[one["ParamName"]]["InnerTree"].items()
            (other, peers), = one["InnerTree"].items()
            assert branch.strip("{}") == other.strip("{}")
            assert shape(items[0]) == shape(peers[0]) and items[0]["type"] == peers[0]["type"]
            assert shape(json.loads(items[0]["data"])) == shape(json.loads(peers[0]["data"])), one["ParamName"]

        # Errors: the same status where Hops looks at it, and lists of text.
        for broken in [message("minimal-surface"), message("minimal-surface", curves("Boundaries", [square]))][:1]:
            theirs, ours = call(peer + "/solve", broken), call(URL + "/hops/solve", broken)
            assert theirs[0] == ours[0] == 500 and theirs[2]["errors"][0] == ours[2]["errors"][0] == "Bad inputs"
        theirs, ours = call(peer + "/solve", message("nothing")), call(URL + "/hops/solve", message("nothing"))
        assert shape(theirs[2]["errors"]) == shape(ours[2]["errors"]) == ["str"] and ours[2]["values"] == []
        assert call(URL + "/solve")[0] == 405
        print("ghhops-server: descriptions, values and errors have the same shape")
    finally:
        process.terminate()
        process.wait()
        folder.cleanup()


if __name__ == "__main__":
    check_icon()
    check_curves()
    check_precision()
    check_components()
    check_files()
    check_directions()
    check_units()
    check_peer()
