"""The Rhino script against rhino3dm and a stand-in for Rhino (rhino_stand_in.py)."""

import json
import math
import os
import sys
import urllib.request
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import rhino_stand_in  # noqa: E402

document = rhino_stand_in.install()
import plateau_rhino  # noqa: E402
import rhino3dm  # noqa: E402

SURVEY = (2_600_123.123456789, 1_200_456.987654321, 431.25)


def fresh(*curves, unit="Meters", names=(), **answers):
    """An empty document with these curves, picked. `answers` are what the user types at the prompts with these words."""
    document.objects.clear()
    document.texts.clear()
    document.names.clear()
    document.picked = [document.add(curve, name) for curve, name in zip(curves, [*names, *[None] * len(curves)])]
    document.said[:], document.prompts[:], document.records[:], document.escape = [], [], [], False
    document.answers = {words.replace("_", " "): answer for words, answer in answers.items()}
    document.ModelUnitSystem = f"Rhino.UnitSystem.{unit}"


def polyline(points, place=(0.0, 0.0, 0.0)):
    made = rhino3dm.Polyline(len(points))
    for point in points:
        made.Add(*(value + by for value, by in zip(point, place)))
    return made.ToPolylineCurve()


def statistics():
    with urllib.request.urlopen(os.environ["PLATEAU_URL"] + "/v1/jobs?limit=1") as response:
        path = json.load(response)["jobs"][0]["links"]["self"]
    with urllib.request.urlopen(os.environ["PLATEAU_URL"] + path) as response:
        return json.load(response)


def test_two_open_curves_become_a_strip_at_survey_coordinates_exactly():
    rails = [[(0, 0, 0), (1, 0, 0.2), (2, 0, 0)], [(0, 1, 0), (2, 1, 0.5)]]
    fresh(*(polyline(rail, SURVEY) for rail in rails), unit="Millimeters")
    # The job warns that STL files are relative to an origin, which does not concern Rhino.
    assert len(plateau_rhino.main()) == 1 and not any("STL" in line for line in document.said), document.said
    (mesh,) = document.meshes
    assert mesh.IsValid and len(mesh.Faces) == 3 and len(mesh.Normals) == 5
    expected = [[value + by for value, by in zip(point, SURVEY)] for rail in rails for point in rail]
    found = [mesh.Vertices.Point3dAt(index) for index in range(5)]
    assert [[point.X, point.Y, point.Z] for point in found] == expected
    assert statistics()["kind"] == "ruled_surface"


def test_two_rings_become_a_film():
    ring = rhino3dm.Circle(rhino3dm.Point3d(0, 0, 0), 1.0).ToNurbsCurve()
    other = rhino3dm.Circle(rhino3dm.Point3d(0, 0, 0.8), 1.0).ToNurbsCurve()
    fresh(ring, other)
    assert len(plateau_rhino.main() or ()) == 1, document.said
    job = statistics()
    assert job["statistics"]["converged"] and job["statistics"]["boundary_loops"] == 2
    assert len(document.meshes[0].Faces) == job["statistics"]["triangles"]


def test_a_closed_polyline_is_not_given_twice_at_its_end():
    fresh(polyline([(0, 0, 0), (8, 0, 3), (8, 8, 0), (0, 8, 3), (0, 0, 0)]))
    assert len(plateau_rhino.main()) == 1 and document.said == []


def arc(a, b, c):
    return rhino3dm.Arc(*(rhino3dm.Point3d(*point) for point in (a, b, c)))


def test_corners_are_kept_beside_curved_edges():
    """A sail of 8 m with one curved edge, whose corners were cut by 141 mm."""
    corners = [(0, 0, 0), (8, 0, 0), (8, 8, 0), (0, 8, 0)]
    lines = [rhino3dm.Line(rhino3dm.Point3d(*a), rhino3dm.Point3d(*b)) for a, b in zip(corners, corners[1:])]
    sail = rhino3dm.PolyCurve()
    for edge in [*lines, arc((0, 8, 0), (1, 4, 0), (0, 0, 0))]:
        sail.Append(edge)
    # The same as one NURBS curve, whose kinks are knots of full multiplicity.
    for curve in (sail, sail.ToNurbsCurve()):
        assert curve.IsClosed
        fresh(curve)
        assert len(plateau_rhino.main() or ()) == 1, document.said
        (mesh,) = document.meshes
        found = [mesh.Vertices.Point3dAt(index) for index in range(len(mesh.Vertices))]
        for corner in corners:
            nearest = min(point.DistanceTo(rhino3dm.Point3d(*corner)) for point in found)
            assert nearest < 1e-9, (corner, nearest)
        segment = 8.5**2 * math.asin(4 / 8.5) - 7.5 * 4
        assert abs(statistics()["statistics"]["area"] - (64 - segment)) < 1e-2
    # An open curve keeps its ends and its kink.
    rail = rhino3dm.PolyCurve()
    rail.Append(arc((0, 0, 0), (2, 1, 0), (4, 0, 0)))
    rail.Append(arc((4, 0, 0), (6, 1, 0), (8, 0, 0)))
    points = plateau_rhino.points_of(rhino_stand_in.Curve(rail))
    assert len(points) == 97
    for at, end in ((0, (0, 0, 0)), (48, (4, 0, 0)), (96, (8, 0, 0))):
        assert math.dist(points[at], end) < 1e-9, points[at]


def test_a_smooth_closed_curve_is_divided_as_a_whole():
    circle = rhino3dm.Circle(rhino3dm.Point3d(0, 0, 0), 1.0)
    for curve in (circle.ToNurbsCurve(), rhino3dm.ArcCurve.CreateFromCircle(circle)):
        points = plateau_rhino.points_of(rhino_stand_in.Curve(curve))
        assert len(points) == len(set(map(tuple, points))) == plateau_rhino.SAMPLES


def test_what_cannot_be_solved_is_said_with_the_object_s_name():
    line = polyline([(0, 0, 0), (1, 0, 0)])
    fresh(line)
    assert plateau_rhino.main() is None and "two curves or more" in document.said[0]
    fresh(line, line, unit="Miles")
    assert plateau_rhino.main() is None and "Miles" in document.said[0]
    ring = polyline([(0, 0, 0), (8, 0, 3), (8, 8, 0), (0, 8, 3), (0, 0, 0)])
    straight = polyline([(0, 0, 9), (1, 0, 9), (1, 0, 9), (0, 0, 9)])
    fresh(ring, straight, names=[None, "gutter"])
    assert plateau_rhino.main() is None and document.said[0].startswith("Plateau: gutter"), document.said
    fresh(straight)
    assert plateau_rhino.main() is None and document.said[0].startswith("Plateau: curve 1"), document.said
    fresh(ring, triangles=10_000_000_000)
    assert plateau_rhino.main() is None and "the triangles of the resolution" in document.said[0], document.said
    words = plateau_rhino.in_words("/domain/holes/0/3: twists; /domain/polygon is no polygon (see http://a/b)", ["a", "b"])
    assert words == "b: twists; a is no polygon (see http://a/b)"


SAIL = [(0, 0, 0), (10, 0, 4), (10, 10, 0), (0, 10, 4), (0, 0, 0)]


def moved(points, scale):
    return [tuple(scale * value + by for value, by in zip(point, SURVEY)) for point in points]


def test_every_kind_in_millimetres_at_survey_coordinates():
    ring = [(0, 0, 0), (30, 0, 0), (30, 20, 0), (0, 20, 0), (0, 0, 0)]
    hole = [(10, 8, 0), (20, 8, 0), (20, 12, 0), (10, 12, 0), (10, 8, 0)]
    spokes = [[(0, 0, 0), (5, 5, 1)], [(10, 0, 4), (5, 5, 1)], [(10, 10, 0), (5, 5, 1)], [(0, 10, 4), (5, 5, 1)]]
    given = {
        "MinimalSurface": ([SAIL], {"objective": "MinimalMeanCurvature", "triangles": 300}),
        "RuledStrip": ([SAIL[:2], SAIL[2:4]], {"objective": "MinimalTwist"}),
        "Lattice": ([ring, hole], {"objective": "FewestNodes", "members": 2500.0}),
        "Membrane": ([SAIL], {"Tension": 2e-3, "cables": 20.0, "triangles": 300}),
        "CableNet": (spokes, {"Force_per": 1e-3}),
    }
    for word, (lines, answers) in given.items():
        curves = [polyline(moved(line, 1000.0)) for line in lines]
        fresh(*curves, unit="Millimeters", what_to_make=word, **answers)
        made = plateau_rhino.main()
        assert made, (word, document.said)
        job = statistics()
        assert job["kind"] == plateau_rhino.SURFACES[word]
        memory = json.loads(document.texts[made[0], "plateau"])
        assert memory["curves"] == document.picked and memory["job"] == job["id"]
        asked = [prompt for prompt, _ in document.prompts]
        assert all(any(words.replace("_", " ") in prompt for prompt in asked) for words in answers), asked
        if "objective" in memory["settings"]:
            assert job["statistics"]["objective"] == memory["settings"]["objective"]
        if word == "CableNet":
            middle = [document.objects[one].PointAtEnd for one in made]
            expected = moved([(5, 5, 2)], 1000.0)[0]
            assert len(made) == 4
            assert all(math.dist((point.X, point.Y, point.Z), expected) < 1e-5 for point in middle), middle
        else:
            (mesh,) = document.meshes
            assert len(mesh.Faces) == job["statistics"].get("triangles", len(mesh.Faces))
            corner = mesh.Vertices.Point3dAt(0)
            assert [corner.X, corner.Y, corner.Z] == list(moved([lines[0][0]], 1000.0)[0])
        if word == "Membrane":
            # The edges are cables: the film is smaller than over straight edges.
            assert job["statistics"]["converged"] and len(job["statistics"]["cables"]) == 4
        ids, before = list(document.picked), dict(document.objects)
        document.picked, document.answers = made[:1], {}
        again = plateau_rhino.main()
        assert again and set(document.objects) == {*ids, *again} and not set(again) & set(made), (word, document.said)
        document.undo()
        assert document.objects == before


def test_a_result_is_replaced_in_one_undo_step():
    for lines, answers in (([SAIL], {"triangles": 200}), ([[(0, 0, 0), (1, 1, 1)], [(2, 0, 0), (1, 1, 1)], [(1, 2, 0), (1, 1, 1)]], {"what_to_make": "CableNet"})):
        fresh(*map(polyline, lines), **answers)
        curves = list(document.picked)
        first = plateau_rhino.main()
        before = dict(document.objects)
        for picked in (curves, first[:1]):
            document.picked, document.answers = picked, {}
            document.prompts[:] = []
            again = plateau_rhino.main()
            # The prompts offer what was chosen before.
            offered = dict(document.prompts)
            assert offered["Plateau: what to make"] == ("MinimalSurface" if len(lines) == 1 else "CableNet")
            assert offered.get("Plateau: Number of triangles", 200) == 200
            assert set(document.objects) == {*curves, *again} and not set(again) & set(first)
            document.undo()
            assert document.objects == before
    # A curve that is gone is said, and nothing is changed.
    del document.objects[curves[0]]
    document.picked = first[:1]
    assert plateau_rhino.main() is None and "gone" in document.said[-1]


def test_escape_cancels_the_job():
    fresh(polyline([(0, 0, 0), (8, 0, 3), (8, 8, 0), (0, 8, 3.5), (0, 0, 0)]))
    document.escape = True
    assert plateau_rhino.main() is None and document.said == ["Plateau: cancelled"]


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print("passed:", name)
