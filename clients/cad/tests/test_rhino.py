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


def fresh(*curves, unit="Meters"):
    document.picked, document.meshes[:], document.said[:], document.escape = list(curves), [], [], False
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
    assert plateau_rhino.main() == 1 and not any("STL" in line for line in document.said), document.said
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
    assert plateau_rhino.main() == 1, document.said
    job = statistics()
    assert job["statistics"]["converged"] and job["statistics"]["boundary_loops"] == 2
    assert len(document.meshes[0].Faces) == job["statistics"]["triangles"]


def test_a_closed_polyline_is_not_given_twice_at_its_end():
    fresh(polyline([(0, 0, 0), (8, 0, 3), (8, 8, 0), (0, 8, 3), (0, 0, 0)]))
    assert plateau_rhino.main() == 1 and document.said == []


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
        assert plateau_rhino.main() == 1, document.said
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


def test_what_cannot_be_solved_is_said():
    line = polyline([(0, 0, 0), (1, 0, 0)])
    fresh(line)
    assert plateau_rhino.main() is None and "two open curves" in document.said[0]
    fresh(line, line, unit="Miles")
    assert plateau_rhino.main() is None and "Miles" in document.said[0]
    fresh(polyline([(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 0, 0)]))
    assert plateau_rhino.main() is None and "/boundaries" in document.said[0], document.said


def test_escape_cancels_the_job():
    fresh(polyline([(0, 0, 0), (8, 0, 3), (8, 8, 0), (0, 8, 3.5), (0, 0, 0)]))
    document.escape = True
    assert plateau_rhino.main() is None and document.said == ["Plateau: cancelled"]


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print("passed:", name)
