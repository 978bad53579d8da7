"""The client against a real server: solve, progress, cancel, errors by pointer, live dragging."""

from __future__ import annotations

import asyncio
import io
import json
import zipfile
from pathlib import Path
from typing import Any, Dict, List

import httpx
import numpy as np
import pytest
from conftest import Server, soon

import plateau_client
from plateau_client import (
    AsyncPlateau,
    InvalidRequest,
    JobCancelled,
    JobFailed,
    NotFound,
    Plateau,
    PlateauError,
    TimedOut,
    flows,
    requests,
)

TENT = [(0.0, 0.0, 0.0), (8.0, 0.0, 3.0), (8.0, 8.0, 0.0), (0.0, 8.0, 3.0)]
SURVEY = np.array([2_600_123.123456789, 1_200_456.987654321, 431.25])


def film(shift: float = 0.0) -> Dict[str, Any]:
    """A small request, never the same twice with different shifts. A hold makes it take as long as a test needs."""
    ring = np.array(TENT) + [0.0, 0.0, shift]
    return requests.minimal_surface([ring], resolution={"triangles": 200}, cache="bypass")


def statuses(client: Plateau, **filters: Any) -> List[str]:
    return [job["status"] for job in client.jobs(**filters)]


def test_every_kind_is_solved_and_saved(tmp_path: Path) -> None:
    with Plateau() as client:
        strip = client.ruled_surface([TENT[:2], [(0, 8, 3), (4, 8, 2), (8, 8, 0)]], objective="minimal_twist")
        film = client.minimal_surface([TENT], resolution={"triangles": 2000}, units="mm")
        floor = client.uniform_mesh([(0, 0), (30, 0), (30, 20), (0, 20)], 2.5)
        square = [(0, 0, 0), (10, 0, 0), (10, 10, 0), (0, 10, 0)]
        edges = [{"along": {"from": k, "to": (k + 1) % 4}, "mode": "force", "value": 10} for k in range(4)]
        sail = client.tensile_structure([square], {"tension": 1}, cables=edges, resolution={"triangles": 500})
        assert sail.statistics["converged"] and sail.statistics["area"] == pytest.approx(63.77, rel=0.01)
        corners = [(0, 0, 0), (1, 0, 1), (1, 1, 0), (0, 1, 1), (0.2, 0.7, 3)]
        spokes = [(0, 4), (1, 4), (2, 4), (3, 4)]
        net = client.cable_net(corners, spokes, [0, 1, 2, 3], cables=[{"force_density": 1}])
        assert net.vertices[4] == pytest.approx([0.5, 0.5, 0.5]) and len(net.triangles) == 0
        assert net.edges.tolist() == [list(ends) for ends in spokes]
        assert net.forces == pytest.approx([0.75**0.5] * 4)
        assert net.statistics["balance"]["imbalance"] < 1e-9 and len(film.edges) == 0
        assert len(strip.triangles) == strip.statistics["triangles"] == 3
        assert film.statistics["converged"] and len(film.vertices) == film.statistics["vertices"]
        assert (film.unit, film.up) == ("mm", "z") and film.mean_curvature is not None and strip.mean_curvature is None
        assert floor.statistics["nodes"] == len(floor.vertices)
        for name in ("film.glb", "film.gltf", "film.obj", "film.ply", "film.stl"):
            assert film.save(tmp_path / name).stat().st_size > 1000
        assert strip.save(tmp_path / "strip.svg").read_text().startswith("<svg")
        with pytest.raises(ValueError, match="expected a name that ends in"):
            film.save("film.fbx")
        members = floor.lines()
        assert set(members) == {"members lattice", "members rim"} and members["members rim"].unit == "m"
        ends = floor.vertices[np.array(members["members rim"].paths)]
        lengths = np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1)
        np.testing.assert_allclose(members["members rim"].values["length"], lengths)
        np.testing.assert_array_equal(film.vertices[film.lines()["boundaries"].paths[0][0]], TENT[0])
        assert json.loads(film.save(tmp_path / "film.json").read_text())["vertices"] == film.vertices.tolist()


def test_lines_end_at_vertices_and_have_their_forces() -> None:
    client = Plateau()
    net = client.solve(client.example("four-cables"))
    lines = net.lines()
    assert list(lines) == ["cables low", "cables high", "reactions"]
    for name in ("cables low", "cables high"):
        assert all(path.max() < len(net.vertices) for path in lines[name].paths)
    assert lines["cables low"].values["force"] == pytest.approx([5, 5]) and lines["cables low"].unit == "kN"
    reactions = lines["reactions"]
    assert reactions.paths == [] and reactions.arrows.shape == (4, 2, 3)
    np.testing.assert_array_equal(reactions.arrows[:, 0], net.vertices[:4])
    assert sorted(reactions.values["force"]) == pytest.approx([5, 5, 6, 6])


def test_a_batch_gives_a_mesh_for_each_request_or_its_error(tmp_path: Path) -> None:
    twisted = [(0, 0, 0), (30, 20, 0), (30, 0, 0), (0, 20, 0)]
    given = [film(0.01), requests.ruled_surface([TENT[:2], TENT[2:]], direction="auto"), film(0.02)]
    client = Plateau()
    batch = client.submit_batch(given)
    films = batch.wait(timeout=60)
    assert batch.status == "succeeded" and [one["kind"] for one in batch.info["jobs"]] == [one["kind"] for one in given]
    assert [one.request for one in films if not isinstance(one, PlateauError)] == given
    assert client.batch(batch.id).info["jobs"] == batch.info["jobs"]
    with zipfile.ZipFile(io.BytesIO(batch.download(mesh_format="ply"))) as archive:
        assert "batch.json" in archive.namelist() and len(archive.namelist()) == 4
    assert batch.download("glb")[:4] == b"glTF"
    with pytest.raises(InvalidRequest, match="/requests/1"):
        client.submit_batch([film(0.03), {**film(0.03), "boundaries": [twisted[:2]]}])
    batch.delete()
    with pytest.raises(NotFound):
        batch.refresh()


def test_a_cancelled_batch_says_so_for_each_job(server: Server) -> None:
    async def cancelled() -> None:
        async with AsyncPlateau() as client:
            batch = await client.submit_batch([film(0.04), film(0.05)])
            await batch.cancel()
            assert [type(one) for one in await batch.wait()] == [JobCancelled, JobCancelled]

    with server.hold.at("claimed"):
        asyncio.run(cancelled())


def test_patterns_and_schedules_are_made_by_their_parameters() -> None:
    rails = [[(0, 0, 0), (1, 0, 0.2), (2, 0, 0)], [(0, 1, 0), (2, 1, 0.5)]]
    strip = Plateau().ruled_surface(rails)
    assert strip.pattern().startswith(b"<svg")
    assert strip.pattern(profile="cut", format="dxf", kerf=0.2).startswith(b"PK")
    assert strip.pattern(format="dxf", angles=True) != strip.pattern(format="dxf", angles=False)
    table = strip.schedule(part="bends").decode().splitlines()
    assert len(table) > 1 and "," in table[0]
    with pytest.raises(PlateauError, match="kerf"):
        strip.pattern(kerf=-1)
    with pytest.raises(NotFound):
        Plateau().minimal_surface([TENT]).pattern()

    async def alike() -> None:
        async with AsyncPlateau() as client:
            same = await client.ruled_surface(rails)
            assert await same.pattern(notches=100) == strip.pattern(notches=100)
            assert await same.schedule(part="bends") == strip.schedule(part="bends")

    asyncio.run(alike())


def test_the_request_and_the_certificate_come_back() -> None:
    client = Plateau()
    request = requests.minimal_surface([TENT], resolution={"triangles": 100}, certify={"seconds": 0.1})
    proven = client.solve(request)
    assert proven.request == request and client.job(proven.id).request is None
    assert client.submit(request).wait().request == request
    assert proven.certificate()
    with pytest.raises(NotFound):
        client.minimal_surface([TENT]).certificate()


def test_the_server_is_told_who_asks() -> None:
    for client in (Plateau(), AsyncPlateau()):
        assert client._http.headers["User-Agent"] == f"plateau-client/{plateau_client.__version__} (Python)"


def test_vertices_are_the_solver_s_own_numbers_at_survey_coordinates_too() -> None:
    client = Plateau()
    film = client.minimal_surface([np.array(TENT) + SURVEY], resolution={"triangles": 500})
    np.testing.assert_array_equal(film.vertices[:4], np.array(TENT) + SURVEY)
    obj = film.download("obj").decode()  # another writer of the server, which prints the shortest text that reads back
    read = np.array([line.split()[1:] for line in obj.splitlines() if line.startswith("v ")], dtype=np.float64)
    np.testing.assert_array_equal(film.vertices, read)


def test_every_example_is_solved_as_it_is_served() -> None:
    client = Plateau()
    for name in ("helicoid-liu-wang", "two-rails", "courtyard"):
        mesh = client.solve(client.example(name))
        assert len(mesh.triangles) == mesh.statistics["triangles"]


def test_progress_rises_and_the_bar_is_drawn(server: Server, capfd: pytest.CaptureFixture[str]) -> None:
    seen: List[float] = []

    def follow(progress: Any) -> None:
        seen.append(progress["fraction"])
        if seen[-1] >= 0.5:
            server.hold.release("half")

    with server.hold.at("half"):
        Plateau().solve(film(0.001), on_progress=follow, bar=True)
    assert any(0.5 <= fraction < 1.0 for fraction in seen)
    assert seen[0] < 0.5 and seen == sorted(seen) and seen[-1] == 1.0
    drawn = capfd.readouterr().err
    assert "100 % finished" in drawn and drawn.endswith("\n")


def test_a_job_is_cancelled_by_whoever_has_its_handle(server: Server) -> None:
    client = Plateau()
    with server.hold.at("claimed"):
        job = client.submit(film(0.002))
        assert job.status in ("queued", "running")
        assert job.cancel()["status"] == "cancelled"
        with pytest.raises(JobCancelled):
            job.wait()
        job.delete()
        with pytest.raises(NotFound):
            job.refresh()


def test_who_stops_waiting_cancels_the_job(server: Server) -> None:
    client = Plateau()

    def interrupt(progress: Any) -> None:
        raise KeyboardInterrupt

    async def task() -> None:
        async with AsyncPlateau() as other:
            running = asyncio.ensure_future(other.solve(film(0.005)))
            while not server.hold.holds_one():
                await asyncio.sleep(0.01)  # between two looks
            running.cancel()
            with pytest.raises(asyncio.CancelledError):
                await running

    def nothing_runs() -> bool:
        busy = statuses(client, status="running") + statuses(client, status="queued")
        return not busy and not server.hold.holds_one()

    with server.hold.at("claimed"):
        with pytest.raises(KeyboardInterrupt):
            client.solve(film(0.003), on_progress=interrupt)
        with pytest.raises(TimedOut):
            client.solve(film(0.004), timeout=0.5)
        assert soon(nothing_runs)
        asyncio.run(task())
        assert soon(nothing_runs)


def test_a_wait_that_times_out_leaves_the_job_running(server: Server) -> None:
    with server.hold.at("claimed"):
        job = Plateau().submit(film(0.006))
        with pytest.raises(TimedOut):
            job.wait(timeout=0.2)
        assert job.refresh()["status"] in ("queued", "running")
        job.cancel()


def test_errors_lead_to_the_values() -> None:
    client = Plateau()
    with pytest.raises(InvalidRequest) as refused:
        client.minimal_surface([TENT], resolution={"triangles": -5}, units="MM")  # type: ignore[arg-type]
    error = refused.value
    assert error.status == 422 and {found.pointer for found in error.errors} == {"/resolution/triangles", "/units"}
    assert "/units" in str(error) and error.request_id

    with pytest.raises(InvalidRequest) as local:
        client.minimal_surface([TENT, [(0, 0, 0), (1, float("nan"), 0), (1, 1, 0)]])
    assert local.value.status is None and local.value.errors[0].pointer == "/boundaries/1/1/1"
    with pytest.raises(ValueError, match="/boundaries/0: expected points"):
        client.minimal_surface([["a", "b"]])
    with pytest.raises(InvalidRequest, match="/boundaries: must be a list of curves"):
        client.minimal_surface(5)
    with pytest.raises(InvalidRequest, match="/kind"):
        client.solve({"boundaries": [TENT]})


def test_slips_are_explained_before_they_are_sent() -> None:
    from shapely.geometry import LineString, Polygon

    client = Plateau("http://127.0.0.1:9", patience=0)  # nothing listens there
    one_curve: List[Any] = [TENT, np.array(TENT), [list(point) for point in TENT], LineString(TENT)]
    for curve in one_curve:
        with pytest.raises(InvalidRequest, match="/boundaries: lacks a level of brackets: it must be a list of "):
            client.minimal_surface(curve)
    with pytest.raises(InvalidRequest, match="/directrices: lacks a level of brackets"):
        client.ruled_surface(TENT)
    polygon = Polygon(TENT, [[(1, 1), (2, 1), (2, 2)]])
    with pytest.raises(InvalidRequest, match=r"/boundaries: .* pass \[polygon.exterior, \*polygon.interiors\]"):
        client.minimal_surface(polygon)
    assert len(requests.minimal_surface([polygon.exterior, *polygon.interiors])["boundaries"]) == 2
    with pytest.raises(InvalidRequest, match=r'/units: must be an object, such as \{"force":"kN","length":"mm"\}'):
        client.tensile_structure([TENT], {"tension": 1}, units="mm")  # type: ignore[arg-type]
    with pytest.raises(InvalidRequest, match="/requests/0/units"):
        client.submit_batch([requests.cable_net(TENT, [(0, 1)], [0], units="mm")])  # type: ignore[arg-type]
    with pytest.raises(InvalidRequest, match="/boundaries/1: expected points .*, got NoneType"):
        client.minimal_surface([TENT, None])
    # A strip from an apex, and one between two points and a curve, are none of these slips.
    assert requests.ruled_surface([TENT[0], TENT[1:]])["directrices"][0] == [list(TENT[0])]


def test_a_slip_is_told_in_the_words_of_the_server(server: Server) -> None:
    points = [list(point) for point in TENT]
    net = {"edges": [(0, 1)], "supports": [0]}
    slips: List[Dict[str, Any]] = [
        {"kind": "minimal_surface", "boundaries": points},
        {"kind": "minimal_surface", "boundaries": [[points]]},
        {"kind": "minimal_surface", "boundaries": [points, [points]]},
        {"kind": "ruled_surface", "directrices": points},
        {"kind": "uniform_mesh", "domain": {"polygon": [points]}, "edge_length": 1.0},
        {"kind": "uniform_mesh", "domain": {"polygon": points, "holes": points}, "edge_length": 1.0},
        {"kind": "tensile_structure", "boundaries": [points], "film": {"tension": 1}, "units": "m"},
        {"kind": "cable_net", "vertices": [points], **net},
        {"kind": "cable_net", "vertices": points, "units": "m", **net},
    ]
    for slip in slips:
        options = {name: value for name, value in slip.items() if name != "kind"}
        with pytest.raises(InvalidRequest) as local:
            getattr(Plateau(), slip["kind"])(**options)
        answer = httpx.post(f"{server.url}/{flows.PATHS[slip['kind']]}", json=options)
        said = [(error["pointer"], error["detail"]) for error in answer.json()["errors"]]
        assert local.value.status is None and list(local.value.errors) == said, slip


def test_the_server_says_what_is_wrong_with_an_index_or_a_film() -> None:
    client = Plateau()
    for edges, pointer in (([(0, 1), (0, 1, 2)], "/edges/1"), (None, "/edges"), ([(0, None)], "/edges/0/1")):
        with pytest.raises(InvalidRequest, match=f"{pointer}: ") as refused:
            client.cable_net(TENT, edges, [0], cables=[{"force": 1}])
        assert refused.value.status == 422
    for film_, pointer in ((None, "/film"), (2, "/film"), ([2], "/layers/0")):
        with pytest.raises(InvalidRequest, match=f"{pointer}: "):
            client.tensile_structure([TENT], film_)  # type: ignore[arg-type]
    same = [
        client.cable_net(TENT, *given, cables=[{"force": 1}])
        for given in (
            ([(0, 1), (1, 2), (2, 3), (3, 1)], [0, 2, 3]),
            (np.array([[0, 1], [1, 2], [2, 3], [3, 1]]), np.array([0, 2, 3])),
        )
    ]
    np.testing.assert_array_equal(same[0].vertices, same[1].vertices)


def test_every_error_about_a_job_has_its_id() -> None:
    client = Plateau()
    mesh = client.solve(film(0.06))
    job = client.job(mesh.id)
    with pytest.raises(NotFound) as missing:
        mesh.certificate()
    assert missing.value.job_id == mesh.id
    job.delete()
    steps: List[Any] = [
        mesh.download,
        mesh.lines,
        mesh.pattern,
        lambda: mesh.schedule(part="nodes"),
        mesh.certificate,
        job.refresh,
        job.fetch_request,
        job.result,
        job.cancel,
        lambda: client.job(job.id),
        lambda: client.resume(job.id),
    ]
    for step in steps:
        with pytest.raises(NotFound) as gone:
            step()
        assert gone.value.job_id == mesh.id


def test_a_job_that_fails_says_why() -> None:
    client = Plateau()
    twisted = [(0, 0, 0), (30, 20, 0), (30, 0, 0), (0, 20, 0)]
    with pytest.raises((JobFailed, InvalidRequest)) as failed:
        client.uniform_mesh(twisted, 2.5)
    assert failed.value.detail


def test_only_the_newest_of_a_drag_is_delivered(server: Server) -> None:
    async def drag() -> None:
        async with AsyncPlateau() as client:
            live = client.live()
            tasks = []
            with server.hold.at("claimed"):
                for step in range(20):
                    followed = asyncio.Event()
                    request = film(0.01 + step / 1000)
                    tasks.append(asyncio.ensure_future(live.solve(request, on_progress=lambda _, e=followed: e.set())))
                    # The first ten follow each other once the server has the one before, the others at once.
                    if step < 10:
                        await followed.wait()
            meshes = await asyncio.gather(*tasks)
            assert all(mesh is None for mesh in meshes[:-1])
            newest = meshes[-1]
            assert newest is not None and newest.vertices[:4, 2].min() == pytest.approx(0.029)

    asyncio.run(drag())
    client = Plateau()
    assert soon(lambda: statuses(client, status="running") == [])
