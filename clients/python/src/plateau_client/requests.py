"""Requests as dictionaries, for `submit`, for batches and for files. Curves become lists of points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Mapping, Union

from .curves import CurveLike, curves
from .curves import domain as read_domain

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from . import api_types as api


def ruled_surface(directrices: CurveLike, **options: Unpack[api.RuledSurfaceOptions]) -> Dict[str, Any]:
    return {"kind": "ruled_surface", "directrices": curves("directrices", directrices), **options}


def minimal_surface(boundaries: CurveLike, **options: Unpack[api.MinimalSurfaceOptions]) -> Dict[str, Any]:
    return {"kind": "minimal_surface", "boundaries": curves("boundaries", boundaries), **options}


def uniform_mesh(
    domain: Union[CurveLike, Mapping[str, Any]], edge_length: float, **options: Unpack[api.UniformMeshOptions]
) -> Dict[str, Any]:
    return {"kind": "uniform_mesh", "domain": read_domain(domain), "edge_length": edge_length, **options}


def tensile_structure(
    boundaries: CurveLike, film: api.TensileFilm, **options: Unpack[api.TensileStructureOptions]
) -> Dict[str, Any]:
    loops = curves("boundaries", boundaries)
    return {"kind": "tensile_structure", "boundaries": loops, "film": film, **options}
