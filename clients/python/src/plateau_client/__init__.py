"""Client of Plateau, a service for form finding: minimal surfaces, ruled surfaces and uniform meshes."""

from . import api_types, requests
from .aio import AsyncJob, AsyncPlateau, AsyncResult, Live
from .client import Job, Plateau, Result
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
from .mesh import Mesh

__all__ = [
    "AsyncJob",
    "AsyncPlateau",
    "AsyncResult",
    "Busy",
    "ConnectionFailed",
    "CurveLike",
    "FieldError",
    "InvalidRequest",
    "Job",
    "JobCancelled",
    "JobFailed",
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
    "api_types",
    "points",
    "requests",
]
