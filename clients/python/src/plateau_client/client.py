"""The synchronous client. aio.py is its asynchronous twin; what both say to the server is in flows.py."""

from __future__ import annotations

import os
import time
import uuid
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, Optional, Sequence, TypeVar, Union, cast

import httpx

from . import flows, requests
from .curves import CurveLike
from .errors import PlateauError
from .mesh import Lines, Mesh, Statistics
from .progress import ProgressCallback, Watch

if TYPE_CHECKING:
    from types import TracebackType

    from typing_extensions import Unpack

    from . import api_types as api

T = TypeVar("T")


class Result(Mesh[Statistics]):
    """A mesh whose files and curves can still be fetched from the server."""

    def __init__(self, client: Plateau, job: api.Job, ply: bytes) -> None:
        super().__init__(job, ply)
        self._client = client

    def download(self, format: str = "glb") -> bytes:
        """The mesh as `glb`, `gltf`, `obj`, `ply`, `stl` or `json`; a strip's flat pattern as `svg` or `dxf`."""
        return self._client.download(self.id, format)

    def save(self, path: Union[str, Path]) -> Path:
        """Writes the mesh in the format that the name ends with, and returns the path."""
        data = self.download(flows.suffix_format(str(path)))
        Path(path).write_bytes(data)
        return Path(path)

    def lines(self) -> Dict[str, Lines]:
        """The lines on the mesh by name (`boundaries`, `bridges`, `members rim`, `cables ridge`, `reactions`…)."""
        return self._client._run(flows.lines(self.id, self._client._patience))

    def certificate(self) -> Dict[str, Any]:
        """The proof of a lower bound of the area, for requests with `certify`."""
        return self._client._run(flows.certificate(self.id, self._client._patience))

    def pattern(self, **parameters: Union[str, float, bool]) -> bytes:
        """The flat pattern of a ruled strip, by the parameters of `GET /v1/jobs/{id}/pattern`.

        `pattern(profile="cut", format="dxf", kerf=0.2)` is a ZIP archive with a file for each piece.
        """
        return self._client._run(flows.drawing(self.id, "pattern", parameters, self._client._patience))

    def schedule(self, **parameters: Union[str, float, bool]) -> bytes:
        """The parts of a result, by the parameters of `GET /v1/jobs/{id}/schedule`.

        `schedule(part="nodes")` is a table (CSV), and `schedule(format="dxf")` the numbered members in space.
        """
        return self._client._run(flows.drawing(self.id, "schedule", parameters, self._client._patience))


class Job:
    """A job on the server. `info` is what the server last said of it."""

    def __init__(self, client: Plateau, info: api.Job, request: Optional[Dict[str, Any]] = None) -> None:
        self._client = client
        self.info = info
        self.request = request
        """The request as this client sent it. None for a job that another client submitted: see `fetch_request`."""

    @property
    def id(self) -> str:
        return self.info["id"]

    @property
    def status(self) -> api.Status:
        return self.info["status"]

    def refresh(self) -> api.Job:
        """Asks the server for the job's present state."""
        self.info = self._client._run(flows.get_json(f"v1/jobs/{self.id}", self._client._patience))
        return self.info

    def fetch_request(self) -> Dict[str, Any]:
        """The request as the server accepted it, with its kind. The server keeps it as long as the job."""
        return self._client._run(flows.get_json(f"v1/jobs/{self.id}/request", self._client._patience))

    def wait(
        self, *, on_progress: Optional[ProgressCallback] = None, bar: bool = False, timeout: Optional[float] = None
    ) -> Result[Any]:
        """Waits for the end and returns the mesh.

        Raises JobFailed, JobCancelled or TimedOut; the job goes on after TimedOut.
        """
        watch = Watch(on_progress, bar)
        try:
            flow = flows.wait(self.info, watch, flows.deadline(timeout), self._client._patience)
            self.info = self._client._run(flow)
        finally:
            watch.close()
        return self.result()

    def result(self) -> Result[Any]:
        """The mesh of a job that has ended."""
        made = self._client._run(flows.mesh(self._client._result, self.info, self._client._patience))
        made.request = self.request
        return made

    def cancel(self) -> api.Job:
        """Cancels the job; a job that has ended stays as it is."""
        self.info = self._client._post(f"v1/jobs/{self.id}/cancel")
        return self.info

    def delete(self) -> None:
        """Removes the job and its mesh from the server."""
        self._client._run(flows.call(flows.Call("DELETE", f"v1/jobs/{self.id}"), self._client._patience))

    def __repr__(self) -> str:
        return f"<job {self.id}: {self.info['kind']}, {self.status}>"


class Batch:
    """Requests that were submitted together. `info` is what the server last said of them."""

    def __init__(
        self, client: Plateau, info: api.Batch, requests: Optional[Sequence[Mapping[str, Any]]] = None
    ) -> None:
        self._client = client
        self._requests = requests
        self.info = info

    @property
    def id(self) -> str:
        return self.info["id"]

    @property
    def status(self) -> api.Status:
        return self.info["status"]

    def refresh(self) -> api.Batch:
        """Asks the server for the batch's present state."""
        self.info = self._client._run(flows.get_json(f"v1/batches/{self.id}", self._client._patience))
        return self.info

    def wait(self, *, timeout: Optional[float] = None) -> List[Union[Result[Any], PlateauError]]:
        """Waits until every job has ended, and returns a mesh for each request, in their order.

        A job without a mesh has its JobFailed or JobCancelled in the list. Raises TimedOut; the jobs go on then.
        """
        flow = flows.wait_for_batch(self.info, flows.deadline(timeout), self._client._patience)
        self.info = self._client._run(flow)
        found = self._client._run(flows.batch_results(self._client._result, self.info, self._client._patience))
        for job, one in zip(self.info["jobs"], found):
            if isinstance(one, Result) and self._requests is not None:
                one.request = dict(self._requests[job["index"]])
        return found

    def download(self, format: str = "zip", mesh_format: Optional[str] = None) -> bytes:
        """All meshes as one `zip`, each in `mesh_format` (`glb` by default), or as one `glb` scene."""
        flow = flows.batch_meshes(self.id, format, mesh_format, self._client._patience)
        return self._client._run(flow)

    def cancel(self) -> api.Batch:
        """Cancels every job that has not ended."""
        self.info = self._client._post(f"v1/batches/{self.id}/cancel")
        return self.info

    def delete(self) -> None:
        """Removes the batch with its jobs and meshes from the server."""
        self._client._run(flows.call(flows.Call("DELETE", f"v1/batches/{self.id}"), self._client._patience))

    def __repr__(self) -> str:
        return f"<batch {self.id}: {len(self.info['jobs'])} jobs, {self.status}>"


class Plateau:
    """A Plateau server.

    `url` defaults to the environment's PLATEAU_URL, then http://127.0.0.1:8080; `api_key` to PLATEAU_API_KEY. A path in
    the URL is the server's public base path. `patience`: seconds for which a request is tried again while
    the server cannot be reached or is busy. The default is 60, and 4 for an address that was never reached. `timeout`
    limits each request, in seconds.
    Use it as a context manager, or call `close`, where connections should not stay open.
    """

    def __init__(
        self,
        url: Optional[str] = None,
        *,
        api_key: Optional[str] = None,
        patience: Optional[float] = None,
        timeout: float = 30.0,
        transport: Optional[httpx.BaseTransport] = None,
    ) -> None:
        self.url = (url or os.environ.get("PLATEAU_URL") or "http://127.0.0.1:8080").rstrip("/")
        self._patience = flows.Patience(patience)
        self._timeout = timeout
        key = api_key or os.environ.get("PLATEAU_API_KEY")
        headers = {"User-Agent": flows.USER_AGENT, **({"Authorization": f"Bearer {key}"} if key else {})}
        self._http = httpx.Client(base_url=self.url + "/", headers=headers, timeout=timeout, transport=transport)

    def ruled_surface(
        self,
        directrices: CurveLike,
        *,
        on_progress: Optional[ProgressCallback] = None,
        bar: bool = False,
        timeout: Optional[float] = None,
        **options: Unpack[api.RuledSurfaceOptions],
    ) -> Result[api.RuledStatistics]:
        """The best triangulated strip between each pair of neighbouring directrices."""
        request = requests.ruled_surface(directrices, **options)
        return self._solve(request, Watch(on_progress, bar), timeout)

    def minimal_surface(
        self,
        boundaries: CurveLike,
        *,
        on_progress: Optional[ProgressCallback] = None,
        bar: bool = False,
        timeout: Optional[float] = None,
        **options: Unpack[api.MinimalSurfaceOptions],
    ) -> Result[api.MinimalStatistics]:
        """The minimal surface that spans closed boundaries."""
        request = requests.minimal_surface(boundaries, **options)
        return self._solve(request, Watch(on_progress, bar), timeout)

    def uniform_mesh(
        self,
        domain: Union[CurveLike, Mapping[str, Any]],
        edge_length: float,
        *,
        on_progress: Optional[ProgressCallback] = None,
        bar: bool = False,
        timeout: Optional[float] = None,
        **options: Unpack[api.UniformMeshOptions],
    ) -> Result[api.UniformStatistics]:
        """A mesh of nearly equal members on a polygon (with holes), a Bézier or NURBS patch, or a minimal surface."""
        request = requests.uniform_mesh(domain, edge_length, **options)
        return self._solve(request, Watch(on_progress, bar), timeout)

    def tensile_structure(
        self,
        boundaries: CurveLike,
        film: Union[api.TensileFilm, Sequence[api.TensileFilm]],
        *,
        on_progress: Optional[ProgressCallback] = None,
        bar: bool = False,
        timeout: Optional[float] = None,
        **options: Unpack[api.TensileStructureOptions],
    ) -> Result[api.TensileStatistics]:
        """The shape in equilibrium of a film of constant tension with cables, pressure and weight.

        Several films are the layers of a cushion, with `chambers` between them.
        """
        request = requests.tensile_structure(boundaries, film, **options)
        return self._solve(request, Watch(on_progress, bar), timeout)

    def cable_net(
        self,
        vertices: CurveLike,
        edges: Any,
        supports: Any,
        *,
        on_progress: Optional[ProgressCallback] = None,
        bar: bool = False,
        timeout: Optional[float] = None,
        **options: Unpack[api.CableNetOptions],
    ) -> Result[api.CableNetStatistics]:
        """The shape in equilibrium of a cable net that comes nearest to target forces and lengths.

        `edges` are pairs of indices into `vertices`, and `supports` are the indices of the vertices that do not move.
        """
        request = requests.cable_net(vertices, edges, supports, **options)
        return self._solve(request, Watch(on_progress, bar), timeout)

    def solve(
        self,
        request: Mapping[str, Any],
        *,
        on_progress: Optional[ProgressCallback] = None,
        bar: bool = False,
        timeout: Optional[float] = None,
    ) -> Result[Any]:
        """Solves a request with its `kind` in it, such as those of `GET /v1/examples`."""
        return self._solve(dict(request), Watch(on_progress, bar), timeout)

    def submit(self, request: Mapping[str, Any], *, idempotency_key: Optional[str] = None) -> Job:
        """Submits a request with its `kind` in it and returns the job at once. `requests` makes such requests."""
        key = idempotency_key or uuid.uuid4().hex
        return Job(self, self._run(flows.submit(dict(request), key, 0, self._patience)), dict(request))

    def submit_batch(self, requests: Sequence[Mapping[str, Any]], *, idempotency_key: Optional[str] = None) -> Batch:
        """Submits many requests at once, each with its `kind` in it, and returns the batch at once."""
        key = idempotency_key or uuid.uuid4().hex
        return Batch(self, self._run(flows.submit_batch(requests, key, self._patience)), requests)

    def batch(self, batch_id: str) -> Batch:
        """A batch by its id."""
        return Batch(self, self._run(flows.get_json(f"v1/batches/{batch_id}", self._patience)))

    def job(self, job_id: str) -> Job:
        """A job by its id."""
        return Job(self, self._run(flows.get_json(f"v1/jobs/{job_id}", self._patience)))

    def resume(
        self,
        job_id: str,
        *,
        on_progress: Optional[ProgressCallback] = None,
        bar: bool = False,
        timeout: Optional[float] = None,
    ) -> Result[Any]:
        """Waits for a job of an earlier call and returns its mesh. Every error has the id as `job_id`."""
        job = self.job(job_id)
        return job.wait(on_progress=on_progress, bar=bar, timeout=timeout)

    def jobs(self, **filters: Any) -> Iterator[api.JobSummary]:
        """All jobs, newest first, page by page; `status`, `kind` and `idempotency_key` choose among them."""
        while True:
            page = self._run(flows.get_json("v1/jobs", self._patience, filters))
            for job in page["jobs"]:
                yield job
            if not page.get("next_cursor"):
                return
            filters["cursor"] = page["next_cursor"]

    def download(self, job_id: str, format: str = "glb") -> bytes:
        """A file of a job that has succeeded."""
        return self._run(flows.download(job_id, format, self._patience))

    def objectives(self) -> api.ObjectiveList:
        """What can be asked for."""
        return cast("api.ObjectiveList", self._run(flows.get_json("v1/objectives", self._patience)))

    def limits(self) -> api.Limits:
        """How large requests to this server may be."""
        return cast("api.Limits", self._run(flows.get_json("v1/limits", self._patience)))

    def example(self, name: str) -> Dict[str, Any]:
        """The request of an example, its `kind` in it, ready for `solve`."""
        found = self._run(flows.get_json(f"v1/examples/{name}", self._patience))
        return {"kind": found["kind"], **found["request"]}

    def close(self) -> None:
        """Closes the connections."""
        self._http.close()

    def __enter__(self) -> Plateau:
        return self

    def __exit__(self, kind: Optional[type], error: Optional[BaseException], trace: Optional[TracebackType]) -> None:
        self.close()

    def _result(self, job: api.Job, ply: bytes) -> Result[Any]:
        return Result(self, job, ply)

    def _solve(self, request: Dict[str, Any], watch: Watch, timeout: Optional[float]) -> Result[Any]:
        made = self._run(flows.solve(self._result, request, watch, timeout, self._patience, first_wait_s=1))
        made.request = request
        return made

    def _post(self, path: str) -> Any:
        return (self._run(flows.call(flows.Call("POST", path), self._patience))).json()

    def _run(self, flow: flows.Flow[T]) -> T:
        """Carries out the steps of a flow."""
        try:
            step = next(flow)
            while True:
                try:
                    outcome = self._carry_out(step)
                except BaseException as error:
                    step = flow.throw(error)
                else:
                    step = flow.send(outcome)
        except StopIteration as end:
            return cast("T", end.value)

    def _carry_out(self, step: flows.Step) -> Optional[httpx.Response]:
        if isinstance(step, flows.Pause):
            time.sleep(step.seconds)
            return None
        if isinstance(step, flows.Call):
            limit = httpx.Timeout(self._timeout, read=self._timeout + step.longer_s)
            return self._http.request(
                step.method, step.path, params=step.params, headers=step.headers, content=step.body, timeout=limit
            )
        reader = flows.EventReader(step.hear)
        limit = httpx.Timeout(self._timeout, read=step.silence_s)
        with self._http.stream("GET", step.path, headers=step.headers, timeout=limit) as response:
            if response.status_code != 200:
                response.read()
                return response
            for line in response.iter_lines():
                if reader.line(line):
                    return None
        return None
