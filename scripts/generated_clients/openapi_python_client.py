"""Runs the client of openapi-python-client over every example."""

from __future__ import annotations

from typing import Any

import examples
from python_client import Client, models
from python_client.api.jobs import get_job, get_mesh
from python_client.api.solve import post_cable_net, post_minimal_surface, post_ruled_surface, post_tensile_structure, post_uniform_mesh

KINDS: dict[str, Any] = {
    "ruled_surface": (models.RuledSurfaceRequest, post_ruled_surface, models.RuledSurfaceJob),
    "minimal_surface": (models.MinimalSurfaceRequest, post_minimal_surface, models.MinimalSurfaceJob),
    "uniform_mesh": (models.UniformMeshRequest, post_uniform_mesh, models.UniformMeshJob),
    "tensile_structure": (models.TensileStructureRequest, post_tensile_structure, models.TensileStructureJob),
    "cable_net": (models.CableNetRequest, post_cable_net, models.CableNetJob),
}


def solve(kind: str, request: dict[str, Any]) -> tuple[Any, bytes]:
    body_type, post, job_type = KINDS[kind]
    body = body_type.from_dict(request)
    assert body.to_dict() == request, "the request changes on its way through the client"
    job = post.sync(client=client, body=body, prefer=examples.PATIENCE)
    assert isinstance(job, job_type), job
    while job.status in ("queued", "running"):
        job = get_job.sync(job.id, client=client, prefer=examples.PATIENCE)
        assert isinstance(job, job_type), job
    assert job.status == "succeeded", job.error
    mesh = get_mesh.sync(job.id, client=client)
    return job.statistics, mesh.payload.read()


client = Client(base_url=examples.URL, timeout=90)
# A problem document is typed too.
refused = post_ruled_surface.sync(client=client, body=models.RuledSurfaceRequest(directrices=[]))
assert isinstance(refused, models.Problem) and refused.errors[0].pointer == "/directrices", refused
examples.run("openapi-python-client", solve)
