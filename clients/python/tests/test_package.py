"""The package itself: types, the least Python, generated types, a wheel in a fresh environment, the README's code."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import sysconfig
import venv
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PAGES = [ROOT / "README.md", ROOT.parents[1] / "README.md", ROOT.parents[1] / "docs" / "clients.md"]
"""The package's own page, and those of the project that show the client."""
BLOCKS = [
    block for page in PAGES for block in re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
]


def run(*command: object, cwd: Path = ROOT) -> str:
    done = subprocess.run([str(part) for part in command], cwd=cwd, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_mypy_is_strict_and_silent() -> None:
    run(sys.executable, "-m", "mypy")


def test_the_programs_of_the_pages_are_strictly_typed(tmp_path: Path) -> None:
    for number, block in enumerate(BLOCKS):
        (tmp_path / f"block{number}.py").write_text(block, encoding="utf-8")
    everything = "".join(BLOCKS)
    for kind in ("ruled_surface", "minimal_surface", "uniform_mesh", "tensile_structure", "cable_net"):
        assert f".{kind}(" in everything
    run(sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", *sorted(tmp_path.glob("block*.py")))


def test_the_code_is_formatted_and_linted() -> None:
    run(sys.executable, "-m", "ruff", "format", "--check", ".")
    run(sys.executable, "-m", "ruff", "check", ".")


def test_nothing_needs_more_than_python_3_9() -> None:
    run(
        Path(sys.executable).with_name("vermin"),
        "--target=3.9-",
        "--no-tips",
        "--violations",
        "src",
        "generate_types.py",
    )


def test_the_types_are_those_of_the_api_document() -> None:
    run(sys.executable, "generate_types.py", "--check")


@pytest.mark.parametrize("block", BLOCKS, ids=range(len(BLOCKS)))
def test_the_code_of_the_pages_runs_and_leaves_a_checkout_clean(block: str, tmp_path: Path) -> None:
    exec(compile(block, "README.md", "exec"), {"__name__": "readme"})
    for written in tmp_path.iterdir():
        run("git", "check-ignore", "--no-index", written.name, cwd=ROOT.parents[1])


def test_the_wheel_works_in_a_fresh_environment(tmp_path: Path) -> None:
    """With PLATEAU_FULL=1 pip fetches what the wheel asks for, else the environment borrows it from this one."""
    run(sys.executable, "-m", "build", "--no-isolation", "--outdir", tmp_path / "dist")
    assert next((tmp_path / "dist").glob("*.tar.gz")).stat().st_size > 1000
    with zipfile.ZipFile(next((tmp_path / "dist").glob("*.whl"))) as wheel:
        packed = {name.rpartition("/")[2]: wheel.read(name) for name in wheel.namelist() if ".dist-info" in name}
    for name in ("LICENSE-MIT", "LICENSE-APACHE"):
        assert packed[name] == (ROOT.parents[1] / name).read_bytes(), f"{name} differs from the project's"
    workspace = (ROOT.parents[1] / "Cargo.toml").read_text(encoding="utf-8")
    addresses = re.findall(r'^repository = "(.*)"', workspace, re.MULTILINE)
    assert re.findall(r"^Project-URL: Repository, (.*)$", packed["METADATA"].decode(), re.MULTILINE) == addresses
    venv.create(tmp_path / "fresh", with_pip=False)
    python = tmp_path / "fresh" / "bin" / "python"
    full = os.environ.get("PLATEAU_FULL") == "1"
    borrowed = [] if full else ["--no-deps", "--no-index"]
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--python", python]
    run(*pip, "install", "--quiet", *borrowed, next((tmp_path / "dist").glob("*.whl")))
    installed = run(*pip, "list", "--format=freeze")
    assert "plateau-client==0.1.0" in installed and "trimesh" not in installed
    if not full:
        site = next((tmp_path / "fresh" / "lib").glob("python*/site-packages"))
        (site / "borrowed.pth").write_text(sysconfig.get_path("purelib"), encoding="utf-8")
    run(python, "-c", BLOCKS[0], cwd=tmp_path)
    assert (tmp_path / "film.glb").read_bytes()[:4] == b"glTF"
    assert "fresh" in run(python, "-c", "import plateau_client; print(plateau_client.__file__)")
