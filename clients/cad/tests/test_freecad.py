"""The macro under Debian's FreeCAD, without a window: PLATEAU_URL names the server. Run by `scripts/test --long`."""

import importlib.machinery
import importlib.util
import json
import math
import sys
from pathlib import Path

sys.path.insert(0, "/usr/lib/freecad-python3/lib")
import FreeCAD  # noqa: E402
import Part  # noqa: E402

MACRO = str(Path(__file__).resolve().parents[1] / "plateau_freecad.FCMacro")
loader = importlib.machinery.SourceFileLoader("plateau_freecad", MACRO)
macro = importlib.util.module_from_spec(importlib.util.spec_from_loader("plateau_freecad", loader))
loader.exec_module(macro)

SURVEY = (2_600_123_123.456789, 1_200_456_987.654321, 431_250.0)
"""Millimetres."""


def wire(points, place, closed=False):
    vectors = [FreeCAD.Vector(*(value + by for value, by in zip(point, place))) for point in points]
    return Part.makePolygon(vectors + vectors[:1] if closed else vectors)


def nearest(made, point):
    """Distance of a mesh's nearest vertex from a point. Mesh.Points are in the document's coordinates."""
    return min(max(abs(a - b) for a, b in zip((p.x, p.y, p.z), point)) for p in made.Mesh.Points)


def test_two_open_wires_become_a_strip_in_their_place():
    document = FreeCAD.newDocument()
    rails = [[(0, 0, 0), (1000, 0, 200), (2000, 0, 0)], [(0, 1000, 0), (2000, 1000, 500)]]
    for place in ((0.0, 0.0, 0.0), SURVEY):
        made = macro.span(document, [wire(rail, place) for rail in rails])
        assert made.TypeId == "Mesh::Feature" and made.Mesh.CountFacets == 3
        for rail in rails:
            for point in rail:
                # f32 holds 2,000 mm to a ten-thousandth.
                assert nearest(made, [value + by for value, by in zip(point, place)]) < 1e-3, place
        assert abs(made.Mesh.Area - json.loads(made.PlateauStatistics)["area"]) < 1e-5 * made.Mesh.Area


def test_circles_and_loose_edges_become_a_film():
    document = FreeCAD.newDocument()
    rings = [Part.Wire(Part.makeCircle(1000, FreeCAD.Vector(0, 0, z))) for z in (0, 800)]
    made = macro.span(document, rings)
    statistics = json.loads(made.PlateauStatistics)
    assert statistics["converged"] and made.Mesh.CountFacets == statistics["triangles"]
    corners = [FreeCAD.Vector(*p) for p in ((0, 0, 0), (8000, 0, 3000), (8000, 8000, 0), (0, 8000, 3000))]
    edges = [Part.makeLine(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]
    assert json.loads(macro.span(document, edges).PlateauStatistics)["boundary_loops"] == 1


def test_corners_are_kept_beside_curved_edges():
    """A sail of 8 m with one curved edge, whose corners were cut by 141 mm. Its edges are drawn in both directions."""
    document = FreeCAD.newDocument()
    corners = [FreeCAD.Vector(*point) for point in ((0, 0, 0), (8000, 0, 0), (8000, 8000, 0), (0, 8000, 0))]
    a, b, c, d = corners
    arc = Part.Arc(d, FreeCAD.Vector(1000, 4000, 0), a).toShape()
    segment = 8500**2 * math.asin(4 / 8.5) - 7500 * 4000
    for edges in ([Part.makeLine(a, b), Part.makeLine(b, c), Part.makeLine(c, d), arc],
                  [Part.makeLine(b, a), Part.makeLine(b, c), Part.makeLine(d, c), arc]):
        # FreeCAD joins edges in order in the one case, and turns them round in the other.
        for shapes in (edges, [Part.Wire(edges)]):
            made = macro.span(document, shapes)
            for corner in corners:
                assert nearest(made, corner) < 1e-3, (corner, nearest(made, corner))
            assert abs(json.loads(made.PlateauStatistics)["area"] - (64e6 - segment)) < 1e4


def test_an_edge_keeps_its_kinks_and_a_circle_its_points():
    poles = [FreeCAD.Vector(*point) for point in ((0, 0, 0), (1, 1, 0), (2, 0, 0), (3, 1, 0), (4, 0, 0))]
    spline = Part.BSplineCurve()
    spline.buildFromPolesMultsKnots(poles, [3, 2, 3], [0, 1, 2], False, 2)
    for shape in (spline.toShape(), spline.toShape().reversed()):
        points = macro.points_of(Part.Wire([shape]))
        assert len(points) == 97 and [2.0, 0.0, 0.0] in points
    circle = macro.points_of(Part.Wire(Part.makeCircle(1000)))
    assert len(circle) == len(set(map(tuple, circle))) == macro.SAMPLES


def test_what_cannot_be_solved_is_said():
    document = FreeCAD.newDocument()
    one = wire([(0, 0, 0), (1, 0, 0)], (0, 0, 0))
    straight = wire([(0, 0, 0), (1, 0, 0), (2, 0, 0)], (0, 0, 0), closed=True)
    for shapes, text in (([], "closed wires"), ([one], "closed wires"), ([straight], "/boundaries")):
        try:
            macro.span(document, shapes)
        except macro.PlateauError as error:
            assert text in str(error), error
        else:
            raise AssertionError("no error")


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print("passed:", name)
