"""Requests as dictionaries, for `submit`, for batches and for files. Curves become lists of points."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Mapping, Sequence, Union

import numpy as np

from .curves import CurveLike, curve_at, curves
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
    boundaries: CurveLike,
    film: Union[api.TensileFilm, Sequence[api.TensileFilm]],
    **options: Unpack[api.TensileStructureOptions],
) -> Dict[str, Any]:
    films: Dict[str, Any] = {"layers": list(film)} if isinstance(film, (list, tuple)) else {"film": film}
    return {"kind": "tensile_structure", "boundaries": curves("boundaries", boundaries), **films, **options}


def cable_net(vertices: CurveLike, edges: Any, supports: Any, **options: Unpack[api.CableNetOptions]) -> Dict[str, Any]:
    return {
        "kind": "cable_net",
        "vertices": curve_at("/vertices", vertices),
        # The server says what is wrong with an index.
        "edges": np.asarray(edges, dtype=object).tolist(),
        "supports": np.asarray(supports, dtype=object).tolist(),
        **options,
    }
