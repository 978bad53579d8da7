"""Whom progress is told to: the caller's function, a bar on standard error, or both."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Callable, Optional

if TYPE_CHECKING:
    from .api_types import Progress

ProgressCallback = Callable[["Progress"], None]

BAR_WIDTH = 24
"""Characters of a full bar."""


class Watch:
    """Passes progress on to a function and to a bar; false if nobody listens."""

    def __init__(self, callback: Optional[ProgressCallback], bar: bool) -> None:
        self._callback = callback
        self._bar = bar
        self._drawn = False

    def __bool__(self) -> bool:
        return self._bar or self._callback is not None

    def __call__(self, progress: Progress) -> None:
        if self._bar:
            sys.stderr.write("\r\x1b[K" + line(progress))
            sys.stderr.flush()
            self._drawn = True
        if self._callback is not None:
            self._callback(progress)

    def close(self) -> None:
        """Ends the bar's line."""
        if self._drawn:
            sys.stderr.write("\n")
            self._drawn = False


def line(progress: Progress) -> str:
    """The bar as text."""
    filled = round(BAR_WIDTH * progress["fraction"])
    text = f"{'█' * filled}{'·' * (BAR_WIDTH - filled)} {100 * progress['fraction']:3.0f} % {progress['phase']}"
    residual = progress.get("residual")
    text += f", iteration {progress['iteration']}" if progress["iteration"] else ""
    return text + (f", residual {residual:.1e}" if residual is not None else "")
