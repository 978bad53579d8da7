"""Curves of shapely, compas and rhino3dm in; trimesh, compas, rhino3dm and meshio out."""

from __future__ import annotations

import numpy as np
import pytest

from plateau_client import InvalidRequest, Plateau, points, requests

TENT = [[0.0, 0.0, 0.0], [8.0, 0.0, 3.0], [8.0, 8.0, 0.0], [0.0, 8.0, 3.0]]
SURVEY = [2_600_123.123456789, 1_200_456.987654321, 431.25]


def test_curves_of_shapely() -> None:
    from shapely.geometry import LinearRing, LineString, MultiPoint, Polygon

    assert points(LineString(TENT)) == TENT
    assert points(LinearRing(TENT)) == points(Polygon(TENT)) == TENT
    assert points(LineString([(0, 0), (1, 2)])) == [[0, 0, 0], [1, 2, 0]]
    holed = Polygon([(0, 0), (9, 0), (9, 9)], [[(3, 1), (5, 1), (5, 2)]])
    assert requests.uniform_mesh(holed, 1.0)["domain"] == {
        "polygon": [[0, 0, 0], [9, 0, 0], [9, 9, 0]],
        "holes": [[[3, 1, 0], [5, 1, 0], [5, 2, 0]]],
    }
    for wrong in (holed, MultiPoint(TENT)):
        with pytest.raises(InvalidRequest):
            points(wrong)


def test_curves_of_compas() -> None:
    from compas.geometry import Bezier, Circle, Line, Point, Polygon, Polyline

    assert points(Polyline(TENT)) == points(Polygon(TENT)) == points(Polyline([*TENT, TENT[0]])) == TENT
    assert points(Line(TENT[0], TENT[1])) == TENT[:2]
    assert points(Point(1, 2, 3)) == [[1, 2, 3]]
    bezier = points(Bezier([[0, 0, 0], [1, 2, 0], [3, 0, 0]]), samples=5)
    assert len(bezier) == 5 and bezier[0] == [0, 0, 0] and bezier[2] == [1.25, 1, 0] and bezier[4] == [3, 0, 0]
    assert len(points(Bezier([[0, 0, 0], [1, 2, 0], [3, 0, 0], [0, 0, 0]]), samples=5)) == 5
    circle = np.array(points(Circle(5.0), samples=16))
    np.testing.assert_allclose(np.linalg.norm(circle, axis=1), 5.0)
    assert len(np.unique(circle.round(9), axis=0)) == 16


def test_curves_of_rhino3dm() -> None:
    import rhino3dm

    polyline = rhino3dm.Polyline(4)
    for x, y, z in TENT:
        polyline.Add(x + SURVEY[0], y + SURVEY[1], z)
    expected = [[x + SURVEY[0], y + SURVEY[1], z] for x, y, z in TENT]
    assert points(polyline) == points(polyline.ToPolylineCurve()) == expected

    ends = rhino3dm.Point3d(0, 0, 0), rhino3dm.Point3d(1, 2, 3)
    assert points(rhino3dm.LineCurve(*ends)) == points(rhino3dm.Line(*ends)) == [[0, 0, 0], [1, 2, 3]]
    joined = rhino3dm.PolyCurve()
    joined.Append(rhino3dm.Line(*ends))
    joined.Append(rhino3dm.Arc(ends[1], rhino3dm.Point3d(2, 3, 3), rhino3dm.Point3d(3, 2, 3)))
    assert len(points(joined, samples=9)) == 10
    for circle in (rhino3dm.Circle(5.0), rhino3dm.Circle(5.0).ToNurbsCurve()):
        sampled = np.array(points(circle, samples=24))
        np.testing.assert_allclose(np.linalg.norm(sampled, axis=1), 5.0)
        assert len(np.unique(sampled.round(9), axis=0)) == 24
    with pytest.raises(InvalidRequest):
        points(rhino3dm.Sphere(rhino3dm.Point3d(0, 0, 0), 1.0))


def test_the_mesh_in_other_libraries_at_survey_coordinates() -> None:
    film = Plateau().minimal_surface([np.array(TENT) + SURVEY], resolution={"triangles": 500}, units="ft")
    area = film.statistics["area"]
    assert film.mean_curvature is not None

    of_trimesh = film.to_trimesh()
    assert of_trimesh.area == pytest.approx(area, rel=1e-9) and of_trimesh.units == "feet"
    np.testing.assert_array_equal(of_trimesh.vertices, film.vertices)

    of_meshio = film.to_meshio()
    np.testing.assert_array_equal(of_meshio.points, film.vertices)
    np.testing.assert_array_equal(of_meshio.point_data["mean_curvature"], film.mean_curvature)

    of_compas = film.to_compas()
    assert of_compas.area() == pytest.approx(area, rel=1e-9)
    assert of_compas.vertex_coordinates(0) == film.vertices[0].tolist()
    assert of_compas.vertex_attribute(7, "mean_curvature") == film.mean_curvature[7]

    of_rhino = film.to_rhino3dm()
    assert (
        of_rhino.IsValid and len(of_rhino.Faces) == len(film.triangles) and len(of_rhino.Normals) == len(film.vertices)
    )
    for index in (0, 100, len(film.vertices) - 1):
        point = of_rhino.Vertices.Point3dAt(index)
        assert [point.X, point.Y, point.Z] == film.vertices[index].tolist()


def test_a_cable_net_keeps_its_edges_and_forces() -> None:
    client = Plateau()
    net = client.solve(client.example("four-cables"))
    edges, forces = net.edges.tolist(), net.forces.tolist()
    assert len(edges) == 4

    of_meshio = net.to_meshio()
    np.testing.assert_array_equal(of_meshio.cells_dict["line"], net.edges)
    np.testing.assert_array_equal(of_meshio.cell_data["force"][0], net.forces)

    of_compas = net.to_compas()
    assert sorted(list(ends) for ends in of_compas.edges()) == sorted(edges)
    assert [of_compas.edge_attribute(tuple(ends), "force") for ends in edges] == forces

    of_trimesh = net.to_trimesh()
    assert [entity.points.tolist() for entity in of_trimesh.entities] == edges
    assert [entity.metadata["force"] for entity in of_trimesh.entities] == forces and of_trimesh.units == "m"
    np.testing.assert_array_equal(of_trimesh.vertices, net.vertices)

    for curve, (a, b) in zip(net.to_rhino3dm(), edges):
        for point, vertex in ((curve.PointAtStart, a), (curve.PointAtEnd, b)):
            assert [point.X, point.Y, point.Z] == net.vertices[vertex].tolist()
