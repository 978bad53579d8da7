"""Every way in which a request can fail, as an exception."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Optional, Sequence

if TYPE_CHECKING:
    from .api_types import Job


class FieldError(NamedTuple):
    """One value that cannot be used."""

    pointer: str
    """JSON Pointer (RFC 6901) into the request, for example `/boundaries/0/17/2`."""
    detail: str


class PlateauError(Exception):
    """Base class of all errors of this package."""

    job_id: Optional[str] = None
    """The id of the job that the error is about, if the server had accepted one. `resume` comes back to the job."""


class ProblemError(PlateauError):
    """The server refused a request. The message holds its reason and every pointer."""

    def __init__(
        self,
        title: str,
        detail: str,
        *,
        status: Optional[int] = None,
        type: str = "about:blank",
        errors: Sequence[FieldError] = (),
        errors_omitted: bool = False,
        request_id: Optional[str] = None,
    ) -> None:
        self.title = title
        self.detail = detail
        self.status = status
        """HTTP status, or None if the client itself found the fault."""
        self.type = type
        self.errors = tuple(errors)
        self.errors_omitted = errors_omitted
        """True if there are more errors than `errors` holds."""
        self.request_id = request_id
        """The request's id in the server's log."""
        lines = [f"{title}: {detail}" if detail else title]
        lines += [f"  {error.pointer or '(the whole request)'}: {error.detail}" for error in self.errors]
        lines += ["  … and more"] if errors_omitted else []
        super().__init__("\n".join(lines))


class InvalidRequest(ProblemError, ValueError):
    """Values of the request cannot be used (400, 413, 415, 422, or found before sending). See `errors`."""


class Unauthorized(ProblemError):
    """The API key is missing or wrong (401), or may not do this (403)."""


class NotFound(ProblemError):
    """There is no such job, or it has expired (404, 410)."""


class Busy(ProblemError):
    """The queue is full or the rate is used up (429, 503), and stayed so for as long as the client tried again."""


class ServerError(ProblemError):
    """The server failed (5xx)."""


class JobFailed(ProblemError):
    """The solver found no valid mesh. `detail` and `errors` say what was wrong and what to try."""

    def __init__(self, job: Job) -> None:
        self.job = job
        self.job_id = job["id"]
        error = job.get("error")
        errors = [FieldError(item["pointer"], item["detail"]) for item in error["errors"]] if error else []
        super().__init__(
            error["title"] if error else "The job failed",
            error["detail"] if error else "",
            type=error["type"] if error else "about:blank",
            errors=errors,
        )


class JobCancelled(PlateauError):
    """The job was cancelled before it ended."""

    def __init__(self, job: Job) -> None:
        self.job = job
        self.job_id = job["id"]
        super().__init__(f"job {job['id']} was cancelled")


class TimedOut(PlateauError):
    """The time that the caller gave is over."""


class ConnectionFailed(PlateauError):
    """The server could not be reached for as long as the client tried. A job that it had accepted goes on there."""

    idempotency_key: Optional[str] = None
    """The key of a submission that got no answer. `submit` with the same request and key makes no second job."""

    def __str__(self) -> str:
        text = super().__str__()
        if self.job_id is not None:
            return f"{text}; job {self.job_id} goes on at the server, and resume({self.job_id!r}) comes back to it"
        if self.idempotency_key is not None:
            key = f"idempotency_key={self.idempotency_key!r}"
            return f"{text}; submit() with {key} and the same request makes no second job"
        return text
