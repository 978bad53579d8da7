"""Runs the Python client of openapi-generator over every example."""

from __future__ import annotations

from typing import Any

import examples
import generator_client as generated

KINDS: dict[str, Any] = {
    "ruled_surface": (generated.RuledSurfaceRequest, "post_ruled_surface", generated.RuledSurfaceJob),
    "minimal_surface": (generated.MinimalSurfaceRequest, "post_minimal_surface", generated.MinimalSurfaceJob),
    "uniform_mesh": (generated.UniformMeshRequest, "post_uniform_mesh", generated.UniformMeshJob),
    "tensile_structure": (generated.TensileStructureRequest, "post_tensile_structure", generated.TensileStructureJob),
    "cable_net": (generated.CableNetRequest, "post_cable_net", generated.CableNetJob),
}


def solve(kind: str, request: dict[str, Any]) -> tuple[Any, bytes]:
    body_type, post, job_type = KINDS[kind]
    body = body_type.from_dict(request)
    assert examples.without_nulls(body.to_dict()) == examples.without_nulls(request), "the request changes on its way through the client"
    job = getattr(solving, post)(body, prefer=examples.PATIENCE)
    assert isinstance(job, job_type), job
    while job.status in ("queued", "running"):
        job = jobs.get_job(job.id, prefer=examples.PATIENCE).actual_instance
        assert isinstance(job, job_type), job
    assert job.status == "succeeded", job.error
    return job.statistics, bytes(jobs.get_mesh(job.id, format="glb"))


api = generated.ApiClient(generated.Configuration(host=examples.URL))
solving, jobs = generated.SolveApi(api), generated.JobsApi(api)
example = generated.CatalogueApi(api).get_example("tent")
assert isinstance(example.request.actual_instance, generated.MinimalSurfaceRequestWithKind), example
examples.run("openapi-generator", solve)
