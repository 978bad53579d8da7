"""The server is killed while clients wait for their jobs, and is started again on the same data."""

from __future__ import annotations

import asyncio
import os
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from conftest import Server, soon

from plateau_client import AsyncPlateau, ConnectionFailed, Plateau, TimedOut, requests

DOWN_S = [8, 30] if os.environ.get("PLATEAU_FULL") == "1" else [5]
RING = [(0, 0, 0), (8, 0, 3), (8, 8, 0), (0, 8, 3)]


def film(shift: float) -> Any:
    ring = [(x, y, z + shift) for x, y, z in RING]
    return requests.minimal_surface([ring], resolution={"triangles": 200}, cache="bypass")


@pytest.fixture(autouse=True)
def short_lease(monkeypatch: pytest.MonkeyPatch) -> None:
    """A job of a killed server is taken up again when its lease is over, which lasts 15 s otherwise."""
    monkeypatch.setenv("PLATEAU_JOBS__LEASE_MS", "2000")


@pytest.mark.parametrize("down_s", DOWN_S)
def test_a_killed_server_gives_the_same_job_s_result_after_its_restart(tmp_path: Path, down_s: float) -> None:
    own = Server(tmp_path)
    seen: list[float] = []
    also_seen: list[float] = []

    def is_waited_for(count: int) -> bool:
        return len(list(Plateau(own.url).jobs())) == count

    async def of_async(shift: float, on_progress: Any) -> Any:
        async with AsyncPlateau(own.url) as client:
            return await client.solve(film(shift), on_progress=on_progress)

    try:
        with own.hold.at("claimed"), ThreadPoolExecutor() as pool:
            waiting = [
                pool.submit(Plateau(own.url).solve, film(0.1)),
                pool.submit(Plateau(own.url).solve, film(0.2), on_progress=lambda said: seen.append(said["fraction"])),
                pool.submit(lambda: asyncio.run(of_async(0.3, None))),
                pool.submit(lambda: asyncio.run(of_async(0.4, lambda said: also_seen.append(said["fraction"])))),
                pool.submit(lambda: Plateau(own.url).submit_batch([film(0.5)]).wait()[0]),
            ]
            assert soon(lambda: is_waited_for(5) and own.hold.holds_one())
            submitted = {job["id"] for job in Plateau(own.url).jobs()}
            own.kill()
            time.sleep(down_s)
            own.hold.release("claimed")
            own.start()
            started = time.monotonic()
            films = [one.result(timeout=120) for one in waiting]
        print(f"down for {down_s} s, and the results came {time.monotonic() - started:.1f} s after the restart")
        assert {one.id for one in films} == submitted == {job["id"] for job in Plateau(own.url).jobs()}
        assert [round(float(one.vertices[0, 2]), 9) for one in films] == [0.1, 0.2, 0.3, 0.4, 0.5]
        assert seen[-1] == also_seen[-1] == 1.0
    finally:
        own.stop()


def test_an_error_carries_the_job_and_a_call_resumes_it(tmp_path: Path) -> None:
    own = Server(tmp_path)
    client = Plateau(own.url, patience=0.3)
    try:
        with own.hold.at("claimed"), ThreadPoolExecutor() as pool:
            job = client.submit(film(0.4))
            followed = pool.submit(client.solve, film(0.5), on_progress=lambda progress: None)
            waiting = [pool.submit(job.wait), followed]
            assert soon(lambda: len(list(Plateau(own.url).jobs())) == 2 and own.hold.holds_one())
            submitted = {one["id"] for one in Plateau(own.url).jobs()}
            own.kill()
            ids = []
            for one in waiting:
                with pytest.raises(ConnectionFailed, match="goes on at the server") as lost:
                    one.result(timeout=60)
                ids.append(lost.value.job_id or "")
                assert ids[-1] in str(lost.value)
        own.start()
        assert set(ids) == submitted
        for job_id in ids:
            resumed = Plateau(own.url).resume(job_id)
            assert resumed.id == job_id and resumed.statistics["converged"]

        with own.hold.at("claimed"):
            job = client.submit(film(0.6))
            with pytest.raises(TimedOut) as late:
                job.wait(timeout=0.2)
            assert late.value.job_id == job.id
            own.kill()
            # The caller's timeout ends the wait although the patience lasts longer.
            begun = time.monotonic()
            patient = Plateau(own.url, patience=60)
            with pytest.raises(TimedOut):
                patient._run(_wait(patient, job.info, 1.0))
            assert time.monotonic() - begun < 10
        with pytest.raises(ConnectionFailed) as unanswered:
            client.solve(film(0.7))
        key = unanswered.value.idempotency_key
        assert unanswered.value.job_id is None and key is not None and key in str(unanswered.value)
    finally:
        if own.process.poll() is None:
            own.stop()


def _wait(client: Plateau, job: Any, timeout: float) -> Any:
    from plateau_client import flows
    from plateau_client.progress import Watch

    return flows.wait(job, Watch(None, False), flows.deadline(timeout), client._patience)
