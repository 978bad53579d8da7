"""What both Python programs share: the examples, and how an answer to one is checked."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

URL = os.environ["PLATEAU_URL"]
FOLDER = Path(__file__).resolve().parents[2] / "api" / "examples"
PATIENCE = "wait=60"


def without_nulls(value: Any) -> Any:
    """A value without the fields that are null, which some clients send for every field that was not given."""
    if isinstance(value, dict):
        return {key: without_nulls(part) for key, part in value.items() if part is not None}
    return [without_nulls(part) for part in value] if isinstance(value, list) else value


def run(program: str, solve: Callable[[str, dict[str, Any]], tuple[Any, bytes]]) -> None:
    """Calls `solve` with the kind and the request of every example. It returns the statistics and the mesh as GLB."""
    failed = 0
    paths = sorted(FOLDER.glob("*.json"))
    for path in paths:
        request = json.loads(path.read_text(encoding="utf-8"))
        try:
            kind = request["kind"]
            statistics, mesh = solve(kind, request)
            # A cable net has no triangles.
            assert statistics.triangles > 0 or kind == "cable_net", statistics
            assert statistics.objective, statistics
            assert mesh[:4] == b"glTF", mesh[:40]
        except Exception as error:  # noqa: BLE001 - every example is tried
            failed += 1
            print(f"{program}: {path.stem}: {type(error).__name__}: {str(error)[:600]}", file=sys.stderr)
    print(f"{program}: {len(paths) - failed} of {len(paths)} examples")
    sys.exit(1 if failed else 0)
