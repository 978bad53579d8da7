"""Client of Plateau, a service for form finding: films, strips, lattices, membranes and cable nets."""

from importlib.metadata import version

from . import api_types, requests
from .aio import AsyncBatch, AsyncJob, AsyncPlateau, AsyncResult, Live
from .client import Batch, Job, Plateau, Result
from .curves import CurveLike, points
from .errors import (
    Busy,
    ConnectionFailed,
    FieldError,
    InvalidRequest,
    JobCancelled,
    JobFailed,
    NotFound,
    PlateauError,
    ProblemError,
    ServerError,
    TimedOut,
    Unauthorized,
)
from .mesh import Lines, Mesh

__version__ = version("plateau-client")

__all__ = [
    "AsyncBatch",
    "AsyncJob",
    "AsyncPlateau",
    "AsyncResult",
    "Batch",
    "Busy",
    "ConnectionFailed",
    "CurveLike",
    "FieldError",
    "InvalidRequest",
    "Job",
    "JobCancelled",
    "JobFailed",
    "Lines",
    "Live",
    "Mesh",
    "NotFound",
    "Plateau",
    "PlateauError",
    "ProblemError",
    "Result",
    "ServerError",
    "TimedOut",
    "Unauthorized",
    "__version__",
    "api_types",
    "points",
    "requests",
]
