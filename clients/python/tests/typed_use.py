"""What the types promise; mypy --strict reads this file, and nothing runs it."""

import numpy as np

from plateau_client import AsyncPlateau, Plateau


def strip(client: Plateau) -> float:
    rails = [np.zeros((4, 3)), [[0.0, 1.0, 0.0], [1.0, 1.0, 0.0]]]
    return client.ruled_surface(rails, objective="minimal_twist", closed=False).statistics[
        "developability_deviation_deg"
    ]


async def film(client: AsyncPlateau) -> bool:
    mesh = await client.minimal_surface([[(0, 0, 0), (1, 0, 1), (1, 1, 0)]], resolution={"triangles": 100}, units="mm")
    return mesh.statistics["converged"]


def wrong(client: Plateau) -> None:
    client.minimal_surface([], objective="minimal_weight")  # type: ignore[arg-type]
    client.minimal_surface([], resolutoin={"triangles": 100})  # type: ignore[call-arg]
