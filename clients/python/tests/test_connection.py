"""What the client does when the line is bad: a transport stands in for a network that loses answers."""

from __future__ import annotations

import hashlib
import json
from typing import Any, Callable, Iterator, List

import httpx
import pytest
from conftest import Server

from plateau_client import Busy, ConnectionFailed, Plateau, Unauthorized, flows

TENT = [(0, 0, 0), (8, 0, 3), (8, 8, 0), (0, 8, 3)]


class Lossy(httpx.BaseTransport):
    """Passes requests on, and lets `meddle` change what comes back."""

    def __init__(self, meddle: Callable[[int, httpx.Request, httpx.Response], httpx.Response]) -> None:
        self.inner = httpx.HTTPTransport()
        self.meddle = meddle
        self.seen: List[httpx.Request] = []

    def handle_request(self, request: httpx.Request) -> httpx.Response:
        self.seen.append(request)
        return self.meddle(len(self.seen), request, self.inner.handle_request(request))


def test_an_answer_that_is_lost_is_asked_for_again_and_nothing_is_solved_twice() -> None:
    def lose_first(number: int, request: httpx.Request, response: httpx.Response) -> httpx.Response:
        if number == 1:
            response.close()
            raise httpx.ReadError("lost")
        return response

    lossy = Lossy(lose_first)
    client = Plateau(transport=lossy)
    film = client.minimal_surface([TENT])
    keys = {request.headers["idempotency-key"] for request in lossy.seen if request.method == "POST"}
    assert len(keys) == 1 and sum(request.method == "POST" for request in lossy.seen) == 2
    assert [job["id"] for job in Plateau().jobs(idempotency_key=keys.pop())] == [film.id]


class Broken(httpx.SyncByteStream):
    """A stream up to the end of its first event, and then the line is cut."""

    def __init__(self, response: httpx.Response) -> None:
        self.response = response

    def __iter__(self) -> Iterator[bytes]:
        assert isinstance(self.response.stream, httpx.SyncByteStream)
        seen = b""
        for chunk in self.response.stream:
            yield chunk
            seen += chunk
            if b"\ndata:" in seen and seen.endswith(b"\n\n"):
                raise httpx.ReadError("cut")

    def close(self) -> None:
        self.response.close()


def test_a_stream_that_breaks_goes_on_where_it_was(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(flows, "RECONNECT_S", 0.05)
    listened: List[str] = []

    def cut_first(number: int, request: httpx.Request, response: httpx.Response) -> httpx.Response:
        if not request.url.path.endswith("/events"):
            return response
        listened.append(request.headers.get("last-event-id", ""))
        if len(listened) > 1:
            server.hold.release("claimed")
            return response
        return httpx.Response(200, headers=response.headers, stream=Broken(response))

    seen: List[str] = []
    client = Plateau(transport=Lossy(cut_first))
    request = {"kind": "minimal_surface", "boundaries": [TENT], "cache": "bypass"}
    with server.hold.at("claimed"):
        client.solve(request, on_progress=lambda progress: seen.append(progress["phase"]))
    assert len(listened) >= 2 and listened[0] == "" and "." in listened[1]
    assert seen[-1] == "finished"


def test_a_job_is_followed_to_its_end_where_no_stream_passes(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(flows, "RECONNECT_S", 0.01)
    monkeypatch.setattr(flows, "POLL_S", 0.01)
    looks: List[str] = []

    def no_streams(number: int, request: httpx.Request, response: httpx.Response) -> httpx.Response:
        if request.url.path.endswith("/events"):
            response.close()
            raise httpx.ReadError("cut")
        if request.method == "GET":
            looks.append(request.url.path)
            if len(looks) > flows.STREAMS + 1:
                server.hold.release("claimed")
        return response

    seen: List[str] = []
    lossy = Lossy(no_streams)
    request = {"kind": "minimal_surface", "boundaries": [TENT], "cache": "bypass"}
    with server.hold.at("claimed"):
        film = Plateau(transport=lossy).solve(request, on_progress=lambda progress: seen.append(progress["phase"]))
    assert film.statistics["converged"] and seen[-1] == "finished"
    assert sum(request.url.path.endswith("/events") for request in lossy.seen) == flows.STREAMS


@pytest.mark.parametrize("ending", ["closed", "broken"])
def test_after_a_stream_the_job_is_asked_for_and_the_next_stream_waits(ending: str) -> None:
    running: Any = {"id": "j", "status": "running", "progress": {"phase": "newton", "fraction": 0.5}}
    seen: List[Any] = []
    flow = flows.wait(running, seen.append, None, flows.Patience())
    for last_id in ["", "7", "7"]:
        listen = next(flow) if not last_id else flow.send(None)
        assert isinstance(listen, flows.Listen) and listen.headers.get("Last-Event-ID", "") == last_id
        assert not listen.hear("progress", "7", json.dumps({"progress": running["progress"]}))
        look = flow.send(None) if ending == "closed" else flow.throw(httpx.ReadError("cut"))
        assert isinstance(look, flows.Call) and look.path == "v1/jobs/j"
        assert flow.send(httpx.Response(200, json=running)) == flows.Pause(flows.RECONNECT_S)
    ended = {**running, "status": "succeeded"}
    assert isinstance(flow.send(None), flows.Listen)
    assert isinstance(flow.send(None), flows.Call)
    with pytest.raises(StopIteration) as end:
        flow.send(httpx.Response(200, json=ended))
    assert end.value.value == ended and len(seen) == 4


def test_a_busy_server_is_asked_again_for_as_long_as_the_patience_lasts() -> None:
    def busy_twice(number: int, request: httpx.Request, response: httpx.Response) -> httpx.Response:
        if number > 2:
            return response
        response.close()
        body = {
            "type": "/problems/queue-full",
            "title": "The queue is full",
            "status": 429,
            "detail": "later",
            "instance": "/",
        }
        return httpx.Response(429, json=body, headers={"retry-after": "0"})

    assert Plateau(transport=Lossy(busy_twice)).minimal_surface([TENT]).statistics["converged"]
    with pytest.raises(Busy, match="The queue is full: later"):
        Plateau(transport=Lossy(busy_twice), patience=0).minimal_surface([TENT])


def test_a_server_that_is_not_there_and_a_key_that_is_missing(tmp_path_factory: pytest.TempPathFactory) -> None:
    # By default a mistyped address is told after seconds, and a server that was reached once is waited for.
    patience = flows.Patience()
    assert patience.seconds == flows.FIRST_CONTACT_S
    patience.reached = True
    assert patience.seconds == flows.PATIENCE_S and flows.Patience(7).seconds == 7
    absent = Plateau("http://127.0.0.1:9", patience=0.2)
    for ask in (absent.limits, lambda: absent.minimal_surface([TENT])):
        with pytest.raises(
            ConnectionFailed, match=r"^http://127\.0\.0\.1:9 cannot be reached .*start the service"
        ) as told:
            ask()
        # No server can have accepted a job, so that a key to ask for it would mislead.
        assert told.value.idempotency_key is None
    folder = tmp_path_factory.mktemp("keys")
    key = "0123456789abcdef0123456789abcdef"
    (folder / "config.toml").write_text(f'[auth.keys]\nstudio = "{hashlib.sha256(key.encode()).hexdigest()}"\n')
    server = Server(folder, "--config", str(folder / "config.toml"))
    try:
        with pytest.raises(Unauthorized):
            Plateau(server.url).minimal_surface([TENT])
        assert Plateau(server.url, api_key=key).minimal_surface([TENT]).statistics["converged"]
    finally:
        server.stop()
