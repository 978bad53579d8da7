"""A real server for every test run: PLATEAU_BIN, or the debug build of the checkout."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import Iterator

import pytest

CHECKOUT = Path(__file__).resolve().parents[3]


class Server:
    def __init__(self, data: Path, *arguments: str) -> None:
        binary = os.environ.get("PLATEAU_BIN") or str(CHECKOUT / "target" / "debug" / "plateau")
        self.log = (data / "log").open("w+")
        self.process = subprocess.Popen(
            [binary, "--listen", "127.0.0.1:0", "--data", str(data / "store"), *arguments],
            stdout=subprocess.PIPE,
            stderr=self.log,
            text=True,
        )
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        assert line.startswith("listening on "), line
        self.url = line.split()[-1]

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
