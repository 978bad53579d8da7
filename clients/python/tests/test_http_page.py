"""docs/http-in-ten-minutes.md: its commands for bash, typed one after the other into one terminal."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from conftest import CHECKOUT, Server

PAGE = (CHECKOUT / "docs" / "http-in-ten-minutes.md").read_text(encoding="utf-8")
PRINTED = "http://127.0.0.1:8080"


def test_the_commands_run_as_they_are_printed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if shutil.which("curl") is None or shutil.which("bash") is None:
        pytest.skip("curl or bash is missing")
    (tmp_path / "secret").write_text("whsec_" + "A" * 43 + "=\n", encoding="utf-8")
    monkeypatch.setenv("PLATEAU_WEBHOOKS__SECRET_FILE", str(tmp_path / "secret"))
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    blocks = re.findall(r"^```sh\n(.*?)^```", PAGE, re.DOTALL | re.MULTILINE)
    assert PRINTED in blocks[0]
    script = "\necho; echo '=== next'\n".join(blocks).replace(PRINTED, "$SERVICE")
    server = Server(tmp_path)
    monkeypatch.setenv("SERVICE", server.url)
    try:
        done = subprocess.run(["bash", "-euc", script + "\npwd"], capture_output=True, text=True, timeout=120)
    finally:
        server.stop()
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stderr == ""
    _, submitted, keyed, waited, events, _, _, cancelled, superseded, batch, hook, kept, refused = done.stdout.split(
        "=== next"
    )
    assert re.fullmatch(r"http://[\d.:]+/v1/jobs/\w{26}", submitted.strip())
    assert len(set(keyed.split())) == 1 and len(keyed.split()) == 2
    assert '"status":"succeeded"' in waited and "event: status" in events and '"status":"succeeded"' in events
    assert '"status":"cancelled"' in cancelled and superseded.count('"kind":"minimal_surface"') == 3
    assert '"succeeded":2' in batch and '"links"' in hook
    assert '"jobs":[' in kept and '"boundaries":[' in kept
    assert '"pointer":"/boundaries/0"' in refused and '"pointer":"/units"' in refused and "\n422\n" in refused
    folder = Path(done.stdout.split()[-1])
    assert folder.parent == tmp_path
    starts = {"film.glb": b"glTF", "tent.glb": b"glTF", "film.obj": b"#", "meshes.zip": b"PK"}
    assert {path.name: path.read_bytes()[: len(starts[path.name])] for path in folder.iterdir()} == starts


def test_every_step_has_commands_for_both_shells() -> None:
    fences = re.findall(r"^```(\w+)$", PAGE, re.MULTILINE)
    assert fences == ["sh", "powershell"] * (len(fences) // 2)
    for block in re.findall(r"^```powershell\n(.*?)^```", PAGE, re.DOTALL | re.MULTILINE):
        # `curl` alone is another command of Windows PowerShell, which also takes quotation marks out of arguments.
        assert not re.search(r"\bcurl (?!\.exe)", block) and "-d '" not in block and "/dev/null" not in block
