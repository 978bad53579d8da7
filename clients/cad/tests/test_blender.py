"""The add-on under the real bpy, without a window: PLATEAU_URL names the server. Run by `scripts/test --long`."""

import json
import os
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import plateau_blender  # noqa: E402

SURVEY = (2_600_123.25, 1_200_456.5, 431.25)
"""Exact in f32, as every place of a Blender object is."""
PAIRS = 500
"""Number of pairs of rails of known direction."""


def fresh_scene(metres_per_unit):
    bpy.ops.object.select_all(action="SELECT")
    bpy.ops.object.delete()
    bpy.context.scene.unit_settings.system = "METRIC"
    bpy.context.scene.unit_settings.scale_length = metres_per_unit


def add_curve(points, place, cyclic, kind="POLY"):
    data = bpy.data.curves.new("curve", "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new(kind)
    spline.points.add(len(points) - 1)
    for point, coordinates in zip(spline.points, points):
        point.co = (*coordinates, 1.0)
    spline.use_cyclic_u = cyclic
    thing = bpy.data.objects.new("curve", data)
    thing.location = place
    bpy.context.collection.objects.link(thing)
    thing.select_set(True)
    return thing


def solved(**options):
    bpy.context.view_layer.update()
    assert bpy.ops.object.plateau(url=os.environ["PLATEAU_URL"], **options) == {"FINISHED"}
    made = bpy.context.view_layer.objects.active
    return made, json.loads(made["plateau_statistics"])


def world(thing):
    own = np.array([vertex.co for vertex in thing.data.vertices], dtype=np.float64)
    return own + np.array(thing.location, dtype=np.float64)


def test_two_open_curves_become_a_strip_in_the_document_s_units_and_place():
    for metres in (1.0, 0.001, 0.3048, 0.5):
        for place in ((0.0, 0.0, 0.0), SURVEY):
            fresh_scene(metres)
            rails = [[(0, 0, 0), (1, 0, 0.25), (2, 0, 0)], [(0, 1, 0), (1, 1.5, 0.5), (2, 1, 0.5)]]
            for rail in rails:
                add_curve(rail, place, cyclic=False)
            made, statistics = solved(surface="AUTO", objective="minimal_twist")
            assert made.type == "MESH" and len(made.data.polygons) == statistics["triangles"] == 4
            expected = np.array(rails, dtype=np.float64).reshape(-1, 3) + place
            found = world(made)
            order = [int(np.argmin(np.linalg.norm(found - point, axis=1))) for point in expected]
            assert np.abs(found[order] - expected).max() < 1e-6, (metres, place)
            unit = metres if metres == 0.5 else 1.0  # half a metre is none of the service's units: it works in metres
            own = sum(polygon.area for polygon in made.data.polygons)
            assert abs(own * unit**2 - statistics["area"]) < 1e-5 * statistics["area"]


def test_two_rings_become_a_film_at_survey_coordinates():
    angles = np.linspace(0, 2 * np.pi, 48, endpoint=False)
    for place in ((0.0, 0.0, 0.0), SURVEY):
        fresh_scene(1.0)
        for height in (0.0, 0.8):
            add_curve([(np.cos(a), np.sin(a), height) for a in angles], place, cyclic=True)
        made, statistics = solved(triangles=2000)
        assert statistics["converged"] and abs(len(made.data.polygons) - 2000) <= 200
        low, high = world(made).min(axis=0), world(made).max(axis=0)
        assert np.abs(low - place - [-1, -1, 0]).max() < 1e-5 and np.abs(high - place - [1, 1, 0.8]).max() < 1e-5


def test_a_smooth_curve_is_taken_as_blender_draws_it():
    fresh_scene(1.0)
    thing = add_curve([(1, 0, 0), (1, 1, 1), (-1, 1, 0), (-1, -1, 1), (1, -1, 0)], (5, 6, 7), cyclic=True, kind="NURBS")
    made, statistics = solved(triangles=500)
    assert statistics["converged"] and made.location == thing.location


def random_rails(random, kind):
    """Points of two rails that lie side by side and run the same way, by the control points that Blender gets."""
    width, height = random.uniform(0.3, 2.5, 2), random.uniform(-2, 2, 2)
    length, radius, angle = random.uniform(1, 20), random.uniform(3, 10), random.uniform(0.2, 1.5 * np.pi)
    bends = random.uniform(-1, 1, (6, 2))

    def place(t):
        """A point of the guide and the direction to its left."""
        if kind == "line":
            return np.array([length * t, 0, 0]), np.array([0, 1, 0])
        if kind == "arc":
            outwards = np.array([np.cos(angle * t), np.sin(angle * t), 0])
            return radius * outwards, -outwards
        bend = [np.interp(t, np.linspace(0, 1, 6), bends[:, axis]) for axis in (0, 1)]
        return np.array([15 * t, *bend]), np.array([0, 1, 0])

    rails = []
    for side in (0, 1):
        count = int(random.integers(2 if kind == "line" else 8, 40))
        start, end = (0, 1) if side == 0 else (random.uniform(0, 0.15), random.uniform(0.85, 1))
        points = []
        for u in np.linspace(0, 1, count):
            point, left = place(start + u * (end - start))
            up = np.array([0, 0, height[0] + u * (height[1] - height[0])])
            points.append(tuple(point + side * ((width[0] + u * (width[1] - width[0])) * left + up)))
        rails.append(points)
    return rails


def test_rails_are_joined_in_the_direction_that_a_person_sees():
    random = np.random.default_rng(5)
    kinds = ("line", "arc", "spline")
    objectives = ("minimal_area", "minimal_twist", "maximal_convexity", "minimal_bending_energy")
    for k in range(PAIRS):
        kind = kinds[k % 3]
        first, second = random_rails(random, kind)
        for runs_against in (False, True):
            fresh_scene(1.0)
            add_curve(first, (0, 0, 0), cyclic=False)
            # The control points of a spline are smoothed by Blender.
            add_curve(second[::-1] if runs_against else second, (0, 0, 0), cyclic=False,
                      kind="NURBS" if kind == "spline" else "POLY")
            _, statistics = solved(surface="AUTO", objective=objectives[k % 4])
            assert statistics["reversed"] == [False, runs_against], (k, kind, runs_against)


SAIL = [(0, 0, 0), (10, 0, 4), (10, 10, 0), (0, 10, 4)]


def test_every_kind_in_millimetres_at_survey_coordinates():
    ring, hole = [(0, 0, 0), (30, 0, 0), (30, 20, 0), (0, 20, 0)], [(10, 8, 0), (20, 8, 0), (20, 12, 0), (10, 12, 0)]
    spokes = [[corner, (5, 5, 1)] for corner in SAIL]
    given = {
        "MINIMAL": ([SAIL], True, {"film_objective": "minimal_mean_curvature", "triangles": 300}, "minimal_surface"),
        "RULED": ([SAIL[:2], SAIL[2:]], False, {"objective": "minimal_twist"}, "ruled_surface"),
        "LATTICE": ([ring, hole], True, {"lattice_objective": "fewest_nodes", "edge_length": 2500}, "uniform_mesh"),
        "MEMBRANE": ([SAIL], True, {"tension": 2e-3, "edge_force": 20, "triangles": 300}, "tensile_structure"),
        "NET": (spokes, False, {"force_density": 1e-3}, "cable_net"),
    }
    for surface, (lines, cyclic, options, kind) in given.items():
        fresh_scene(0.001)
        picked = [add_curve([tuple(1000.0 * value for value in point) for point in line], SURVEY, cyclic) for line in lines]
        made, statistics = solved(surface=surface, **options)
        job = json.loads(plateau_blender.Server(os.environ["PLATEAU_URL"]).send("GET", "/v1/jobs/" + made["plateau_job"]))
        assert job["kind"] == kind and plateau_blender.curves_of(made) == picked
        assert all(abs(float(np.linalg.norm(world(made) - (1000.0 * np.array(point) + SURVEY), axis=1).min())) < 2e-3
                   for line in lines for point in (line if kind != "cable_net" else line[:1])), surface
        if kind == "cable_net":
            assert len(made.data.edges) == 4 and len(made.data.polygons) == 0
            assert np.abs(world(made) - (1000.0 * np.array([5, 5, 2.0]) + SURVEY)).sum(axis=1).min() < 2e-2
        elif kind == "tensile_structure":
            assert statistics["converged"] and len(statistics["cables"]) == 4
        else:
            assert statistics["objective"] in options.values()
        is_replaced_and_brought_back(made, picked[0])


def is_replaced_and_brought_back(made, curve):
    """A result that is made again after a change of its curve is the same object, and one undo brings its mesh back."""
    name, job, before, count = made.name, made["plateau_job"], world(made), len(bpy.context.scene.objects)
    # Exact in f32 beside the other coordinates.
    curve.data.splines[0].points[0].co.z += 128.0
    moved = np.array(curve.data.splines[0].points[0].co[:3], dtype=np.float64) + SURVEY
    bpy.ops.object.select_all(action="DESELECT")
    made.select_set(True)
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="the curve is moved")
    # As from the menu, which adds the operator's own undo step.
    assert bpy.ops.object.plateau("EXEC_DEFAULT", True, url=os.environ["PLATEAU_URL"]) == {"FINISHED"}
    again = bpy.data.objects[name]
    assert again["plateau_job"] != job and len(bpy.context.scene.objects) == count
    assert np.linalg.norm(world(again) - moved, axis=1).min() < 2e-3
    bpy.ops.ed.undo()
    undone = bpy.data.objects[name]
    assert undone["plateau_job"] == job and len(bpy.context.scene.objects) == count
    assert np.array_equal(world(undone), before)


def test_a_result_is_replaced_and_keeps_its_settings():
    for surface, lines, cyclic in (("MINIMAL", [SAIL], True), ("NET", [[corner, (5, 5, 1)] for corner in SAIL], False)):
        fresh_scene(1.0)
        picked = [add_curve(line, (0, 0, 0), cyclic) for line in lines]
        made, first = solved(surface=surface, triangles=300)
        made.name = "My roof"
        made.data.materials.append(bpy.data.materials.new("cloth"))
        before, count = made["plateau_job"], len(bpy.context.scene.objects)
        picked[0].data.splines[0].points[0].co.z = 2.0
        for selected in ([made], picked):
            bpy.ops.object.select_all(action="DESELECT")
            for thing in selected:
                thing.select_set(True)
            again, statistics = solved()
            assert again == made and again.name == "My roof" and again.data.materials[0].name.startswith("cloth")
            assert len(bpy.context.scene.objects) == count and again["plateau_job"] != before
            if surface == "MINIMAL":
                # The triangles that were asked for, not the operator's own 2000.
                assert abs(statistics["triangles"] - 300) <= 30 and statistics["area"] != first["area"]
        bpy.data.objects.remove(picked[0])
        bpy.ops.object.select_all(action="DESELECT")
        made.select_set(True)
        try:
            solved()
        except RuntimeError as error:
            assert "My roof" in str(error) and "gone" in str(error)
        else:
            raise AssertionError("no error")


def test_one_undo_brings_the_old_result_back():
    fresh_scene(1.0)
    add_curve(SAIL, (0, 0, 0), cyclic=True)
    made, _ = solved(triangles=300)
    made.name = "Undone"
    bpy.ops.ed.undo_push(message="the first result")
    before, count = made["plateau_job"], len(made.data.polygons)
    # As from the menu, which adds the operator's own undo step.
    done = bpy.ops.object.plateau("EXEC_DEFAULT", True, url=os.environ["PLATEAU_URL"], triangles=600)
    again = bpy.data.objects["Undone"]
    assert done == {"FINISHED"} and len(again.data.polygons) > 1.5 * count and again["plateau_job"] != before
    bpy.ops.ed.undo()
    undone = bpy.data.objects["Undone"]
    assert len(undone.data.polygons) == count and undone["plateau_job"] == before


def test_what_cannot_be_solved_is_said_with_the_object_s_name():
    fresh_scene(1.0)
    add_curve([(0, 0, 0), (1, 0, 0), (1, 0, 0)], (0, 0, 0), cyclic=True).name = "Gutter"
    try:
        bpy.ops.object.plateau(url=os.environ["PLATEAU_URL"])
    except RuntimeError as error:
        assert "Gutter: " in str(error) and "/boundaries" not in str(error), error
    else:
        raise AssertionError("no error")
    fresh_scene(1.0)
    add_curve([(0, 0, 0), (1, 0, 0)], (0, 0, 0), cyclic=False)
    for options, text in (({}, "needs two curves"), ({"surface": "MINIMAL"}, "needs closed curves")):
        try:
            bpy.ops.object.plateau(url=os.environ["PLATEAU_URL"], **options)
        except RuntimeError as error:
            assert text in str(error)
        else:
            raise AssertionError("no error")
    add_curve([(0, 1, 0), (1, 1, 0)], (0, 0, 0), cyclic=False)
    try:
        bpy.ops.object.plateau(url="http://127.0.0.1:9")
    except RuntimeError as error:
        assert "cannot be reached" in str(error)


if __name__ == "__main__":
    plateau_blender.register()
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print("passed:", name)
    plateau_blender.unregister()
