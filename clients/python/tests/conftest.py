"""A real server for every test run: PLATEAU_BIN, or the debug build of the checkout with the feature `test-hooks`."""

from __future__ import annotations

import contextlib
import os
import runpy
import subprocess
import time
from pathlib import Path
from typing import Callable, Iterator

import pytest

CHECKOUT = Path(__file__).resolve().parents[3]


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Records a test that skips itself, as the project's other tests do."""
    if report.skipped and isinstance(report.longrepr, tuple):
        skip = runpy.run_path(str(CHECKOUT / "scripts" / "skips.py"))["skip"]
        skip(f"Python client, {report.location[2].partition('[')[0]}", report.longrepr[2].removeprefix("Skipped: "))


def soon(condition: Callable[[], bool]) -> bool:
    """Looks again and again until the condition holds. The bound is longer than any step takes on any machine."""
    end = time.monotonic() + 120
    while not condition() and time.monotonic() < end:
        time.sleep(0.01)  # between two looks
    return condition()


class Hold:
    """Holds the server's jobs at a stage, so that no test depends on how long a film takes (src/test_hooks.rs)."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir(exist_ok=True)

    @contextlib.contextmanager
    def at(self, stage: str) -> Iterator[None]:
        """Holds every job that reaches the stage, until the end of the block or `release`."""
        (self.folder / stage).touch()
        try:
            yield
        finally:
            self.release(stage)

    def release(self, stage: str) -> None:
        (self.folder / stage).unlink(missing_ok=True)

    def holds_one(self) -> bool:
        """Whether a job is held now."""
        return any(self.folder.glob("held.*"))


class Server:
    def __init__(self, data: Path, *arguments: str) -> None:
        self.log = (data / "log").open("w+")
        self.hold = Hold(data / "hold")
        self._data = data
        self._arguments = arguments
        self.url = ""
        self.start("127.0.0.1:0")

    def start(self, address: str = "") -> None:
        """Starts the server on its data: at an address, or where it was before `kill`."""
        binary = os.environ.get("PLATEAU_BIN") or str(CHECKOUT / "target" / "debug" / "plateau")
        address = address or self.url.partition("://")[2]
        self.process = subprocess.Popen(
            [binary, "--listen", address, "--data", str(self._data / "store"), *self._arguments],
            stdout=subprocess.PIPE,
            stderr=self.log,
            text=True,
            env={**os.environ, "PLATEAU_TEST_HOLD_DIR": str(self.hold.folder)},
        )
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        assert line.startswith("listening on "), line
        self.url = line.split()[-1]

    def kill(self) -> None:
        """Ends the server at once, as a power cut does."""
        self.process.kill()
        self.process.wait(timeout=30)

    def stop(self) -> None:
        self.process.terminate()
        self.process.wait(timeout=30)
        self.log.seek(0)
        assert "panic" not in self.log.read()


@pytest.fixture(scope="session")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    started = Server(tmp_path_factory.mktemp("server"))
    yield started
    started.stop()


@pytest.fixture(autouse=True)
def environment(server: Server, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Every test talks to that server by default and writes into a folder of its own."""
    monkeypatch.setenv("PLATEAU_URL", server.url)
    monkeypatch.delenv("PLATEAU_API_KEY", raising=False)
    monkeypatch.chdir(tmp_path)
