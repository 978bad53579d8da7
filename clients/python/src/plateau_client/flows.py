"""What the client says to the server, written once for the synchronous and the asynchronous client.

A flow is a generator: it yields steps (`Call`, `Listen`, `Pause`) and is sent their outcome. `client.py` and `aio.py`
carry the steps out. A flow never touches a socket, so both clients behave alike.
"""

from __future__ import annotations

import contextlib
import json
import re
import time
import uuid
from importlib.metadata import version
from typing import (
    TYPE_CHECKING,
    Any,
    Callable,
    Dict,
    Generator,
    Iterator,
    List,
    Mapping,
    NamedTuple,
    Optional,
    Sequence,
    TypeVar,
    Union,
    cast,
)

import httpx

from . import errors
from .curves import check_units, to_json
from .mesh import Lines, read_lines

if TYPE_CHECKING:
    from .api_types import Batch, Job, Problem, Progress
    from .progress import Watch

T = TypeVar("T")

USER_AGENT = f"plateau-client/{version('plateau-client')} (Python)"

PATHS = {
    "ruled_surface": "v1/ruled-surfaces",
    "minimal_surface": "v1/minimal-surfaces",
    "uniform_mesh": "v1/uniform-meshes",
    "tensile_structure": "v1/tensile-structures",
    "cable_net": "v1/cable-nets",
}
ENDED = ("succeeded", "failed", "cancelled")
JOB = re.compile(r"v1/jobs/([^/]+)")
"""The path of a job and of everything that belongs to it."""

LONG_POLL_S = 20
"""Seconds that one request waits for a job's end; the server may grant less."""
SILENCE_S = 45.0
"""An event stream that says nothing for so long is opened again. The server sends a comment every 15 s."""
RECONNECT_S = 1.0
"""Seconds from the end of an event stream to the next one."""
STREAMS = 2
"""Number of streams without any event in a row after which the job is polled instead."""
POLL_S = 2.0
PATIENCE_S = 60.0
"""Seconds for which a server that cannot be reached, or is busy, is tried again."""
FIRST_CONTACT_S = 4.0
"""The same for an address that was never reached: it may be mistyped, and its user should not wait for a minute."""
LONGEST_PAUSE_S = 3.0
"""The pause between two attempts grows from 0.1 s to this length."""
PASSING = (408, 425, 429, 502, 503, 504)
"""Answers of proxies, and of a server that is busy or starts again."""


class Patience:
    """How long a client tries again. It counts from the first failure after an answer."""

    def __init__(self, seconds: Optional[float] = None) -> None:
        self._given = seconds
        self.reached = False
        """Whether a connection to the server has been made before."""

    @property
    def seconds(self) -> float:
        if self._given is not None:
            return self._given
        return PATIENCE_S if self.reached else FIRST_CONTACT_S


class Call(NamedTuple):
    """A request and its whole answer."""

    method: str
    path: str
    params: Dict[str, Any] = {}
    headers: Dict[str, str] = {}
    body: Optional[bytes] = None
    longer_s: float = 0.0
    """Seconds that the server may take in addition to the usual time."""
    whole: bool = False
    """Carried out to its end even if the caller is cancelled: a job must be known before it can be cancelled."""


class Listen(NamedTuple):
    """A stream of events; `hear` gets each event's name, id and data and returns true when it has heard enough."""

    path: str
    headers: Dict[str, str]
    hear: Callable[[str, str, str], bool]
    silence_s: float
    """The stream has failed if nothing comes for so long."""


class Pause(NamedTuple):
    seconds: float


Step = Union[Call, Listen, Pause]
Flow = Generator[Step, Any, T]


class EventReader:
    """Puts the lines of a stream of server-sent events together."""

    def __init__(self, hear: Callable[[str, str, str], bool]) -> None:
        self._hear = hear
        self._fields: Dict[str, str] = {}

    def line(self, line: str) -> bool:
        """Takes one line; true when enough was heard."""
        if line:
            name, _, value = line.partition(":")
            value = value[1:] if value.startswith(" ") else value
            if name == "data" and "data" in self._fields:
                value = f"{self._fields['data']}\n{value}"
            self._fields[name] = value
            return False
        fields, self._fields = self._fields, {}
        if "data" not in fields:
            return False
        return self._hear(fields.get("event", "message"), fields.get("id", ""), fields["data"])


def call(request: Call, patience: Patience, until: Optional[float] = None) -> Flow[httpx.Response]:
    """Sends a request; waits and tries again while the server is busy or cannot be reached; raises what it refuses.

    Every request may be sent again, because submissions carry an Idempotency-Key. `until` is the caller's own deadline.
    An error about a job has its id.
    """
    job = JOB.match(request.path)
    with about(job and job.group(1)):
        return (yield from _call(request, patience, until))


def _call(request: Call, patience: Patience, until: Optional[float]) -> Flow[httpx.Response]:
    give_up_at: Optional[float] = None
    pause_s = 0.1
    while True:
        failure: errors.PlateauError
        cause: Optional[Exception] = None
        asked_s = 0.0
        try:
            response: httpx.Response = yield request
            patience.reached = True
            if response.status_code < 400:
                return response
            failure = problem(response)
            if response.status_code not in PASSING:
                raise failure
            retry_after = response.headers.get("retry-after", "")
            asked_s = max(0.2, float(retry_after)) if retry_after.isdigit() else 0.0
        except httpx.TransportError as error:
            if isinstance(error, httpx.UnsupportedProtocol):
                raise errors.ConnectionFailed(f"{type(error).__name__}: {error}") from error
            # A connection that breaks later had reached a server.
            patience.reached = patience.reached or not isinstance(error, (httpx.ConnectError, httpx.ConnectTimeout))
            failure, cause = unanswered(error, patience), error
        now = time.monotonic()
        give_up_at = now + patience.seconds if give_up_at is None else give_up_at
        if now + asked_s >= give_up_at:
            raise failure from cause
        pause = asked_s or min(pause_s, give_up_at - now)
        left = _left(until)
        yield Pause(pause if left is None else min(pause, left))
        _left(until)
        pause_s = min(2 * pause_s, LONGEST_PAUSE_S)


def unanswered(error: httpx.TransportError, patience: Patience) -> errors.ConnectionFailed:
    """The exception for a request without an answer: the address, and the remedy if no server was ever there."""
    url = error.request.url
    text = f"{url.scheme}://{url.netloc.decode()} cannot be reached ({type(error).__name__}: {error})"
    if not patience.reached:
        text += "; start the service there, or name its address by PLATEAU_URL"
    return errors.ConnectionFailed(text)


def problem(response: httpx.Response) -> errors.ProblemError:
    """The exception for an answer that is a failure."""
    status = response.status_code
    try:
        found = cast("Problem", response.json())
        title, detail = found["title"], found["detail"]
    except (ValueError, KeyError, TypeError):
        found = cast("Problem", {})
        title, detail = f"HTTP {status}", response.text[:200]
    kinds: Dict[int, type] = {
        400: errors.InvalidRequest,
        413: errors.InvalidRequest,
        415: errors.InvalidRequest,
        422: errors.InvalidRequest,
        401: errors.Unauthorized,
        403: errors.Unauthorized,
        404: errors.NotFound,
        410: errors.NotFound,
        429: errors.Busy,
        503: errors.Busy,
    }
    made = kinds.get(status, errors.ServerError if status >= 500 else errors.ProblemError)(
        title,
        detail,
        status=status,
        type=found.get("type", "about:blank"),
        errors=[
            errors.FieldError(item.get("pointer") or item.get("parameter") or "", item["detail"])
            for item in found.get("errors", [])
        ],
        errors_omitted=found.get("errors_omitted", False),
        request_id=response.headers.get("x-request-id"),
    )
    return cast(errors.ProblemError, made)


def get_json(
    path: str, patience: Patience, params: Optional[Dict[str, Any]] = None, until: Optional[float] = None
) -> Flow[Any]:
    response = yield from call(Call("GET", path, params or {}), patience, until)
    return response.json()


def submit(
    request: Dict[str, Any], key: str, wait_s: int, patience: Patience, until: Optional[float] = None
) -> Flow[Job]:
    """Posts a request. Its `kind` says where to; `wait_s` is how long the answer may wait for the end."""
    kind = request.get("kind")
    if kind not in PATHS:
        detail = f"must be one of {', '.join(PATHS)}"
        raise errors.InvalidRequest("The kind is missing", detail, errors=[errors.FieldError("/kind", detail)])
    check_units(request)
    headers = {"Content-Type": "application/json", "Idempotency-Key": key}
    if wait_s > 0:
        headers["Prefer"] = f"wait={wait_s}"
    posted = Call("POST", PATHS[kind], {}, headers, to_json(request), longer_s=wait_s, whole=True)
    with keyed(key, patience):
        response = yield from call(posted, patience, until)
    return cast("Job", response.json())


@contextlib.contextmanager
def keyed(key: str, patience: Patience) -> Iterator[None]:
    """Gives a failed connection the key of its submission, which a server may have accepted if one was ever reached."""
    try:
        yield
    except errors.ConnectionFailed as error:
        error.idempotency_key = key if patience.reached else None
        raise


@contextlib.contextmanager
def about(job_id: Optional[str]) -> Iterator[None]:
    """Gives every error of the block the id of its job."""
    try:
        yield
    except errors.PlateauError as error:
        error.job_id = error.job_id or job_id
        raise


def wait(job: Job, watch: Watch, deadline: Optional[float], patience: Patience) -> Flow[Job]:
    """Waits until a job has ended, however it ended."""
    with about(job["id"]):
        if watch and job["status"] in ENDED:
            watch(job["progress"])
        elif watch:
            job = yield from _listen(job, watch, deadline, patience)
        while job["status"] not in ENDED:
            left = _left(deadline)
            seconds = LONG_POLL_S if left is None else max(1, min(LONG_POLL_S, int(left)))
            request = Call("GET", f"v1/jobs/{job['id']}", {}, {"Prefer": f"wait={seconds}"}, longer_s=seconds)
            job = cast("Job", (yield from call(request, patience, deadline)).json())
    return job


def deadline(timeout: Optional[float]) -> Optional[float]:
    """The moment of the monotonic clock at which a timeout is over."""
    return None if timeout is None else time.monotonic() + timeout


def _left(deadline: Optional[float]) -> Optional[float]:
    if deadline is None:
        return None
    left = deadline - time.monotonic()
    if left <= 0:
        raise errors.TimedOut("the job has not ended within the timeout")
    return left


def _listen(job: Job, watch: Watch, deadline: Optional[float], patience: Patience) -> Flow[Job]:
    """Follows the events of a job and passes its progress on.

    After a stream has ended or broken, the job is asked for, and after a pause the stream is opened again from the last
    event on. Where no stream passes, the job is asked for every other second.
    """
    newest: List[Job] = [job]
    last_id: List[str] = [""]
    streams: List[int] = [STREAMS]

    def hear(event: str, event_id: str, data: str) -> bool:
        said = json.loads(data)
        last_id[0] = event_id
        streams[0] = STREAMS
        if event == "status":
            newest[0] = cast("Job", said)
        watch(cast("Progress", said["progress"]))
        _left(deadline)
        return newest[0]["status"] in ENDED

    while newest[0]["status"] not in ENDED:
        left = _left(deadline)
        if streams[0] > 0:
            streams[0] -= 1
            silence_s = SILENCE_S if left is None else min(SILENCE_S, left)
            headers = {"Accept": "text/event-stream"}
            if last_id[0]:
                headers["Last-Event-ID"] = last_id[0]
            listen = Listen(f"v1/jobs/{job['id']}/events", headers, hear, silence_s)
            try:
                refused: Optional[httpx.Response] = yield listen
                if refused is not None and refused.status_code == 204:
                    # No event follows the last one.
                    streams[0] = 0
            except httpx.TransportError:
                pass
            if newest[0]["status"] in ENDED:
                break
            _left(deadline)
        newest[0] = cast("Job", (yield from get_json(f"v1/jobs/{job['id']}", patience, until=deadline)))
        if newest[0]["status"] in ENDED or streams[0] == 0:
            watch(newest[0]["progress"])
        if newest[0]["status"] not in ENDED:
            left, pause_s = _left(deadline), RECONNECT_S if streams[0] > 0 else POLL_S
            yield Pause(pause_s if left is None else min(pause_s, left))
    return newest[0]


def finished(job: Job) -> Job:
    """The job if it has succeeded; else raises how it ended."""
    if job["status"] == "failed":
        raise errors.JobFailed(job)
    if job["status"] == "cancelled":
        raise errors.JobCancelled(job)
    return job


def mesh(make: Callable[[Job, bytes], T], job: Job, patience: Patience) -> Flow[T]:
    """The mesh of a job that has ended. PLY, because it keeps f64 coordinates and the mean curvature."""
    return make(job, (yield from download(finished(job)["id"], "ply", patience)))


def download(job_id: str, format: str, patience: Patience) -> Flow[bytes]:
    part = "pattern" if format in ("svg", "dxf") else "mesh"
    response = yield from call(Call("GET", f"v1/jobs/{job_id}/{part}", {"format": format}), patience)
    return response.content


def lines(job_id: str, patience: Patience) -> Flow[Dict[str, Lines]]:
    """The lines on a mesh. From JSON, which has their values and the mesh's own vertex indices."""
    return read_lines((yield from download(job_id, "json", patience)))


def drawing(
    job_id: str, part: str, parameters: Mapping[str, Union[str, float, bool]], patience: Patience
) -> Flow[bytes]:
    """A file that is made from a result. The service writes booleans in small letters."""
    query = {name: str(value).lower() if isinstance(value, bool) else str(value) for name, value in parameters.items()}
    return (yield from call(Call("GET", f"v1/jobs/{job_id}/{part}", query), patience)).content


def certificate(job_id: str, patience: Patience) -> Flow[Dict[str, Any]]:
    return cast("Dict[str, Any]", (yield from get_json(f"v1/jobs/{job_id}/certificate", patience)))


def submit_batch(requests: Sequence[Mapping[str, Any]], key: str, patience: Patience) -> Flow[Batch]:
    for index, request in enumerate(requests):
        check_units(request, f"/requests/{index}")
    headers = {"Content-Type": "application/json", "Idempotency-Key": key}
    body = to_json({"requests": [dict(request) for request in requests]})
    posted = Call("POST", "v1/batches", {}, headers, body, whole=True)
    with keyed(key, patience):
        response = yield from call(posted, patience)
    return cast("Batch", response.json())


def wait_for_batch(batch: Batch, deadline: Optional[float], patience: Patience) -> Flow[Batch]:
    """Waits until every job of a batch has ended."""
    while batch["status"] not in ENDED:
        left = _left(deadline)
        seconds = LONG_POLL_S if left is None else max(1, min(LONG_POLL_S, int(left)))
        request = Call("GET", f"v1/batches/{batch['id']}", {}, {"Prefer": f"wait={seconds}"}, longer_s=seconds)
        batch = cast("Batch", (yield from call(request, patience, deadline)).json())
    return batch


def batch_results(
    make: Callable[[Job, bytes], T], batch: Batch, patience: Patience
) -> Flow[List[Union[T, errors.PlateauError]]]:
    """The mesh of each job of a batch that has ended, or the error that its own call would have raised."""
    found: List[Union[T, errors.PlateauError]] = []
    for one in batch["jobs"]:
        job = cast("Job", (yield from get_json(f"v1/jobs/{one['id']}", patience)))
        try:
            found.append((yield from mesh(make, job, patience)))
        except (errors.JobFailed, errors.JobCancelled) as error:
            found.append(error)
    return found


def batch_meshes(batch_id: str, format: str, mesh_format: Optional[str], patience: Patience) -> Flow[bytes]:
    params = {"format": format, **({"mesh_format": mesh_format} if mesh_format else {})}
    return (yield from call(Call("GET", f"v1/batches/{batch_id}/meshes", params), patience)).content


def solve(
    make: Callable[[Job, bytes], T],
    request: Dict[str, Any],
    watch: Watch,
    timeout: Optional[float],
    patience: Patience,
    first_wait_s: int,
) -> Flow[T]:
    """Submits, waits, and gets the mesh. The answer to the submission may wait `first_wait_s` for the end.

    A caller that stops waiting (Ctrl-C, a cancelled task, a timeout, an exception of its own function) cancels the job.
    A lost connection does not: the job goes on at the server, and `resume` comes back to it.
    """
    key = uuid.uuid4().hex
    end = deadline(timeout)
    job: Optional[Job] = None
    try:
        job = yield from submit(request, key, 0 if watch else first_wait_s, patience, end)
        job = yield from wait(job, watch, end, patience)
    except (GeneratorExit, errors.ProblemError, errors.ConnectionFailed):
        raise
    except BaseException:
        yield from give_up(job, key)
        raise
    finally:
        watch.close()
    return (yield from mesh(make, job, patience))


def give_up(job: Optional[Job], key: str) -> Flow[None]:
    """Cancels a job that nobody waits for any more, found by its key if the answer to its submission never came."""
    try:
        ids = (
            [job["id"]]
            if job
            else [found["id"] for found in (yield Call("GET", "v1/jobs", {"idempotency_key": key})).json()["jobs"]]
        )
        for job_id in ids:
            yield Call("POST", f"v1/jobs/{job_id}/cancel")
    except (httpx.HTTPError, KeyError, ValueError):
        pass


def suffix_format(path: str) -> str:
    """The format that a file's name asks for."""
    suffix = path.rsplit(".", 1)[-1].lower() if "." in path else ""
    if suffix not in ("glb", "gltf", "obj", "ply", "stl", "json", "svg", "dxf"):
        raise ValueError(f"{path}: expected a name that ends in .glb, .gltf, .obj, .ply, .stl, .json, .svg or .dxf")
    return suffix
