"""The macro in Debian's FreeCAD: PLATEAU_URL names the server. Run by `scripts/test --long`.

FreeCAD's window is there, on Qt's platform without a screen, so that selection, undo and the dialog are FreeCAD's own.
"""

import importlib.machinery
import importlib.util
import json
import math
import os
import sys
import traceback
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
sys.path[:0] = ["/usr/lib/freecad-python3/lib"]
sys.path.append("/usr/share/freecad/Ext")
import FreeCAD  # noqa: E402
import FreeCADGui  # noqa: E402

FreeCADGui.showMainWindow()
import Part  # noqa: E402
from PySide import QtCore, QtGui  # noqa: E402

MACRO = str(Path(__file__).resolve().parents[1] / "plateau_freecad.FCMacro")
loader = importlib.machinery.SourceFileLoader("plateau_freecad", MACRO)
macro = importlib.util.module_from_spec(importlib.util.spec_from_loader("plateau_freecad", loader))
loader.exec_module(macro)

ORIGIN = (0.0, 0.0, 0.0)
SURVEY = (2_600_123_123.456789, 1_200_456_987.654321, 431_250.0)
"""Millimetres."""
SAIL = [(0, 0, 0), (10_000, 0, 4_000), (10_000, 10_000, 0), (0, 10_000, 4_000)]


def vectors(points, place=ORIGIN):
    return [FreeCAD.Vector(*(value + by for value, by in zip(point, place))) for point in points]


def add(shape, label="Wire"):
    """Adds a shape as an object and selects it."""
    thing = FreeCAD.ActiveDocument.addObject("Part::Feature", "Wire")
    thing.Label, thing.Shape = label, shape
    FreeCADGui.Selection.addSelection(thing)
    return thing


def add_wire(points, place=ORIGIN, closed=False, label="Wire"):
    points = vectors(points, place)
    return add(Part.makePolygon(points + points[:1] if closed else points), label)


def fresh():
    FreeCADGui.Selection.clearSelection()
    document = FreeCAD.newDocument()
    assert document.UndoMode == 1
    return document


def select(*things):
    FreeCADGui.Selection.clearSelection()
    for thing in things:
        FreeCADGui.Selection.addSelection(thing)


def selected():
    return [(one.Object, one.SubElementNames) for one in FreeCADGui.Selection.getSelectionEx()]


def made(**settings):
    """The result for the selection, with the macro's own settings apart from these."""
    return macro.make(FreeCAD.ActiveDocument, selected(), lambda own: {**own, **settings})


def statistics(one):
    return json.loads(one.PlateauStatistics)


def kind_of(one):
    return json.loads(macro.send("GET", "/v1/jobs/" + one.PlateauJob))["kind"]


def nearest(one, point):
    """Distance of a result's nearest vertex from a point. Both kinds of objects have document coordinates."""
    points = one.Mesh.Points if one.TypeId == "Mesh::Feature" else [vertex.Point for vertex in one.Shape.Vertexes]
    return min(max(abs(a - b) for a, b in zip((p.x, p.y, p.z), point)) for p in points)


def error_of(call):
    try:
        call()
    except macro.PlateauError as error:
        return str(error)
    raise AssertionError("no error")


def test_two_open_wires_become_a_strip_in_their_place():
    rails = [[(0, 0, 0), (1000, 0, 200), (2000, 0, 0)], [(0, 1000, 0), (2000, 1000, 500)]]
    for place in (ORIGIN, SURVEY):
        fresh()
        for rail in rails:
            add_wire(rail, place)
        one = made()
        assert one.TypeId == "Mesh::Feature" and one.Mesh.CountFacets == 3
        for rail in rails:
            for point in rail:
                # f32 holds 2,000 mm to a ten-thousandth.
                assert nearest(one, [value + by for value, by in zip(point, place)]) < 1e-3, place
        assert abs(one.Mesh.Area - statistics(one)["area"]) < 1e-5 * one.Mesh.Area


def test_every_kind_in_millimetres_at_survey_coordinates():
    ring = [(0, 0, 0), (30_000, 0, 0), (30_000, 20_000, 0), (0, 20_000, 0)]
    hole = [(10_000, 8_000, 0), (20_000, 8_000, 0), (20_000, 12_000, 0), (10_000, 12_000, 0)]
    spokes = [[corner, (5_000, 5_000, 1_000)] for corner in SAIL]
    given = {
        "Minimal surface": ([SAIL], True, {"Objective": "minimal_mean_curvature", "Triangles": 300}, "minimal_surface"),
        "Ruled strip": ([SAIL[:2], SAIL[2:]], False, {"Objective": "minimal_twist"}, "ruled_surface"),
        "Lattice": ([ring, hole], True, {"Objective": "fewest_nodes", "EdgeLength": 2_500.0}, "uniform_mesh"),
        "Membrane": ([SAIL], True, {"Tension": 2e-3, "EdgeForce": 20.0, "Triangles": 300}, "tensile_structure"),
        "Cable net": (spokes, False, {"ForceDensity": 1e-3}, "cable_net"),
    }
    assert set(given) == set(macro.SURFACES)
    for surface, (lines, closed, settings, kind) in given.items():
        fresh()
        curves = [add_wire(line, SURVEY, closed) for line in lines]
        one = made(Surface=surface, **settings)
        assert kind_of(one) == kind and [thing for thing, _ in macro.curves_of(one)] == curves
        for line in lines:
            for point in line if kind != "cable_net" else line[:1]:
                assert nearest(one, [value + by for value, by in zip(point, SURVEY)]) < 2e-3, (surface, point)
        if kind == "cable_net":
            # In the middle of equal forces the node is the mean of the supports.
            middle = [value + by for value, by in zip((5_000, 5_000, 2_000), SURVEY)]
            assert len(one.Shape.Edges) == 4 and nearest(one, middle) < 1e-3
        elif kind == "tensile_structure":
            assert statistics(one)["converged"] and len(statistics(one)["cables"]) == 4
        else:
            assert statistics(one)["objective"] == settings["Objective"]
        is_replaced_and_brought_back(one, curves[0], lines[0], closed)


def is_replaced_and_brought_back(one, curve, line, closed):
    """A result that is made again after a change of its curve is the same object, and one undo brings it back."""
    def coordinates():
        points = one.Mesh.Points if one.TypeId == "Mesh::Feature" else [vertex.Point for vertex in one.Shape.Vertexes]
        return [(point.x, point.y, point.z) for point in points]

    document = FreeCAD.ActiveDocument
    job, before, names = one.PlateauJob, coordinates(), [other.Name for other in document.Objects]
    points = vectors([(*line[0][:2], line[0][2] + 100), *line[1:]], SURVEY)
    curve.Shape = Part.makePolygon(points + points[:1] if closed else points)
    select(one)
    count = document.UndoCount
    assert macro.main() == one and document.UndoCount == count + 1 and one.PlateauJob != job
    assert [other.Name for other in document.Objects] == names
    assert nearest(one, [points[0].x, points[0].y, points[0].z]) < 2e-3
    document.undo()
    assert one.PlateauJob == job and coordinates() == before and [other.Name for other in document.Objects] == names


def test_circles_and_loose_edges_become_a_film():
    fresh()
    for z in (0, 800):
        add(Part.Wire(Part.makeCircle(1000, FreeCAD.Vector(0, 0, z))))
    one = made()
    assert statistics(one)["converged"] and one.Mesh.CountFacets == statistics(one)["triangles"]
    fresh()
    corners = vectors(((0, 0, 0), (8000, 0, 3000), (8000, 8000, 0), (0, 8000, 3000)))
    for a, b in zip(corners, corners[1:] + corners[:1]):
        add(Part.makeLine(a, b))
    assert statistics(made())["boundary_loops"] == 1


def test_picked_edges_of_a_solid_are_the_curves():
    document = fresh()
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    FreeCADGui.Selection.clearSelection()
    for edge in ("Edge1", "Edge5"):
        FreeCADGui.Selection.addSelection(box, edge)
    one = made()
    assert kind_of(one) == "ruled_surface" and macro.curves_of(one) == [(box, ("Edge1", "Edge5"))]


def test_corners_are_kept_beside_curved_edges():
    """A sail of 8 m with one curved edge, whose corners were cut by 141 mm. Its edges are drawn in both directions."""
    corners = vectors(((0, 0, 0), (8000, 0, 0), (8000, 8000, 0), (0, 8000, 0)))
    a, b, c, d = corners
    arc = Part.Arc(d, FreeCAD.Vector(1000, 4000, 0), a).toShape()
    segment = 8500**2 * math.asin(4 / 8.5) - 7500 * 4000
    for edges in ([Part.makeLine(a, b), Part.makeLine(b, c), Part.makeLine(c, d), arc],
                  [Part.makeLine(b, a), Part.makeLine(b, c), Part.makeLine(d, c), arc]):
        # FreeCAD joins edges in order in the one case, and turns them round in the other.
        for shapes in (edges, [Part.Wire(edges)]):
            fresh()
            for shape in shapes:
                add(shape)
            one = made()
            for corner in corners:
                assert nearest(one, corner) < 1e-3, (corner, nearest(one, corner))
            assert abs(statistics(one)["area"] - (64e6 - segment)) < 1e4


def test_an_edge_keeps_its_kinks_and_a_circle_its_points():
    spline = Part.BSplineCurve()
    poles = vectors(((0, 0, 0), (1, 1, 0), (2, 0, 0), (3, 1, 0), (4, 0, 0)))
    spline.buildFromPolesMultsKnots(poles, [3, 2, 3], [0, 1, 2], False, 2)
    for shape in (spline.toShape(), spline.toShape().reversed()):
        points = macro.points_of(Part.Wire([shape]))
        assert len(points) == 97 and [2.0, 0.0, 0.0] in points
    circle = macro.points_of(Part.Wire(Part.makeCircle(1000)))
    assert len(circle) == len(set(map(tuple, circle))) == macro.SAMPLES


def test_a_result_is_replaced_and_keeps_its_settings():
    spokes = [[corner, (5_000, 5_000, 1_000)] for corner in SAIL]
    for surface, lines, closed in (("Minimal surface", [SAIL], True), ("Cable net", spokes, False)):
        document = fresh()
        curves = [add_wire(line, ORIGIN, closed, f"Edge {k}") for k, line in enumerate(lines)]
        one = made(Surface=surface, Triangles=300)
        one.Label, one.ViewObject.Transparency = "My roof", 40
        before, count, first = one.PlateauJob, len(document.Objects), statistics(one)
        points = vectors([(0, 0, 2_000), *lines[0][1:]])
        curves[0].Shape = Part.makePolygon(points + points[:1] if closed else points)
        for picked in ([one], curves):
            select(*picked)
            # The dialog is not asked again: its settings are the result's properties.
            again = macro.make(document, selected(), lambda own: 1 / 0)
            assert again == one and again.Label == "My roof" and again.ViewObject.Transparency == 40
            assert len(document.Objects) == count and again.PlateauJob != before
            if closed:
                # The triangles that were asked for, not the dialog's own 2000.
                assert abs(statistics(one)["triangles"] - 300) <= 30 and statistics(one)["area"] != first["area"]
        if closed:
            one.PlateauTriangles = 600
            select(one)
            assert macro.main().Mesh.CountFacets > 500
            # Another surface is of another type in FreeCAD and takes the place of the old one, with its name.
            one.PlateauSurface, one.PlateauEdgeForce = "Membrane", 30.0
            assert kind_of(macro.main()) == "tensile_structure"
        document.removeObject(curves[0].Name)
        select(one)
        text = error_of(lambda: made())
        assert "Edge 0 of My roof is gone" in text, text


def test_one_undo_brings_the_old_result_back():
    document = fresh()
    thing = add_wire(SAIL, ORIGIN, True)
    made(Triangles=300)
    one = document.Objects[-1]
    before, count, facets = one.PlateauJob, document.UndoCount, one.Mesh.CountFacets
    one.PlateauTriangles = 600
    select(one)
    assert macro.main().Mesh.CountFacets > 1.5 * facets and document.UndoCount == count + 1
    document.undo()
    assert one.PlateauJob == before and one.Mesh.CountFacets == facets
    document.redo()
    assert one.PlateauJob != before
    document.undo()
    # A surface becomes a net, whose object is of another type.
    spokes = [add_wire([corner, (5_000, 5_000, 1_000)]) for corner in SAIL]
    select(*spokes)
    net, objects = made(Surface="Cable net"), [other.Name for other in document.Objects]
    before = net.PlateauJob
    net.PlateauSurface, net.Label = "Ruled strip", "My net"
    select(net)
    strip, count = macro.main(), document.UndoCount
    assert strip.TypeId == "Mesh::Feature" and strip.Label == "My net" and len(document.Objects) == len(objects)
    document.undo()
    assert document.getObjectsByLabel("My net")[0].PlateauJob == before and document.UndoCount == count - 1
    assert thing in document.Objects and [other.Name for other in document.Objects] == objects


def test_the_dialog_chooses_the_surface_and_its_numbers():
    document = fresh()
    add_wire(SAIL, ORIGIN, True)

    def answer(button, surface="Membrane"):
        dialog = QtGui.QApplication.activeModalWidget()
        boxes, numbers = dialog.findChildren(QtGui.QComboBox), dialog.findChildren(QtGui.QLineEdit)
        assert boxes[0].currentText() == "Minimal surface" and boxes[1].count() == 3
        boxes[0].setCurrentText(surface)
        on = [number.isEnabled() for number in numbers]
        assert not boxes[1].isEnabled() and on == ["Membrane" in on for _, on in macro.NUMBERS.values()], on
        numbers[0].setText("400")
        numbers[3].setText("25")
        dialog.findChild(QtGui.QDialogButtonBox).button(button).click()

    QtCore.QTimer.singleShot(0, lambda: answer(QtGui.QDialogButtonBox.Cancel))
    assert macro.main() is None and len(document.Objects) == 1
    QtCore.QTimer.singleShot(0, lambda: answer(QtGui.QDialogButtonBox.Ok))
    one = macro.main()
    assert kind_of(one) == "tensile_structure" and len(statistics(one)["cables"]) == 4
    assert (one.PlateauTriangles, one.PlateauEdgeForce) == (400, 25.0)


def test_what_cannot_be_solved_is_said_with_the_object_s_name():
    fresh()
    assert "select wires" in error_of(lambda: made())
    add_wire([(0, 0, 0), (1, 0, 0)], label="Rail")
    assert "needs two wires" in error_of(lambda: made())
    assert "needs closed wires, but Rail is open" in error_of(lambda: made(Surface="Lattice"))
    fresh()
    add_wire(SAIL, ORIGIN, True)
    add_wire([(0, 0, 0), (4_000, 0, 0), (8_000, 0, 0)], ORIGIN, True, label="Gutter")
    text = error_of(lambda: made())
    assert "Gutter: " in text and "/boundaries" not in text, text
    text = error_of(lambda: made(Surface="Lattice", EdgeLength=-1.0))
    assert "edge length" in text and "/edge_length" not in text, text
    thing = fresh().addObject("Mesh::Feature", "Terrain")
    select(thing)
    assert error_of(lambda: made()) == "Terrain has no edges"
    assert [other.Name for other in FreeCAD.ActiveDocument.Objects] == ["Terrain"]


if __name__ == "__main__":
    status = 0
    for name, test in list(globals().items()):
        if name.startswith("test_") and (len(sys.argv) < 2 or sys.argv[1] in name):
            try:
                test()
                print("passed:", name)
            except Exception:  # noqa: BLE001 - every test is tried
                traceback.print_exc()
                print("FAILED:", name)
                status = 1
    sys.stdout.flush()
    # The end of a Python that has opened FreeCAD's window crashes in PySide.
    os._exit(status)
