"""The mesh of a job as numpy arrays, and its way into other libraries."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Dict, Generic, List, NamedTuple, Optional, TypeVar

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    from .api_types import Job, JobWarning

Statistics = TypeVar("Statistics")


class Lines(NamedTuple):
    """Lines along a mesh that have a name in common, and their values."""

    paths: List[npt.NDArray[np.int64]]
    """Each line as indices into `vertices`. A closed line ends with its first vertex."""
    arrows: npt.NDArray[np.float64]
    """Shape (k, 2, 3): straight lines between points that are no vertices, such as those of `reactions`."""
    values: Dict[str, npt.NDArray[np.float64]]
    """A number for each path or arrow, by its name, such as `force` or `length`. Empty if the lines have none."""
    unit: Optional[str]
    """Unit of the values."""


class Mesh(Generic[Statistics]):
    """A triangle mesh in the axes and the unit of its request.

    The coordinates are the very f64 numbers that the solver ended with, at survey coordinates too.
    """

    vertices: npt.NDArray[np.float64]
    """Shape (n, 3). The request's own points come first, in their order."""
    triangles: npt.NDArray[np.int64]
    """Shape (m, 3), indices into `vertices`. A cable net has none."""
    edges: npt.NDArray[np.int64]
    """Shape (k, 2), indices into `vertices`: the edges of a cable net, cable by cable. Other kinds have none here."""
    forces: npt.NDArray[np.float64]
    """The force of each of `edges`."""
    mean_curvature: Optional[npt.NDArray[np.float64]]
    """Per vertex, 1/unit; minimal surfaces only."""
    unit: str
    """`mm`, `cm`, `m`, `in` or `ft`."""
    up: str
    """`z` or `y`."""
    job: Job
    """The finished job: times, links, warnings."""
    statistics: Statistics
    """How good the mesh is; its fields depend on the kind."""
    request: Optional[Dict[str, Any]] = None
    """The request as this client sent it. None for a job that another client submitted."""

    def __init__(self, job: Job, ply: bytes) -> None:
        self.job = job
        self.statistics = job["statistics"]  # type: ignore[assignment]
        self.vertices, self.triangles, self.mean_curvature, self.unit, self.up = read_ply(ply)
        self.edges, self.forces = read_edges(ply)

    @property
    def id(self) -> str:
        """The job's id."""
        return self.job["id"]

    @property
    def warnings(self) -> List[JobWarning]:
        """What the server wants the caller to know, each with a `code` and a `detail`."""
        return self.job["warnings"]

    @property
    def origin(self) -> npt.NDArray[np.float64]:
        """Middle of the mesh's box. For programs that keep f32: `vertices - origin` is small everywhere."""
        middle: npt.NDArray[np.float64] = 0.5 * self.vertices.min(axis=0) + 0.5 * self.vertices.max(axis=0)
        return middle

    def __repr__(self) -> str:
        kind, unit = self.job["kind"], self.unit
        return f"<{kind}: {len(self.vertices)} vertices, {len(self.triangles)} triangles, unit {unit}, {self.up} up>"

    def to_trimesh(self) -> Any:
        """A `trimesh.Trimesh` with f64 vertices, none merged; a `trimesh.path.Path3D` for a cable net.

        The path's entities are the edges in their order, each with its force as `metadata["force"]`. Needs trimesh.
        """
        import trimesh

        made: Any
        if len(self.edges) > 0:
            from trimesh.path import Path3D
            from trimesh.path.entities import Line

            entities = [Line(ends) for ends in self.edges.tolist()]
            for entity, force in zip(entities, self.forces.tolist()):
                entity.metadata["force"] = force
            made = Path3D(entities=entities, vertices=self.vertices, process=False)
        else:
            attributes = {} if self.mean_curvature is None else {"mean_curvature": self.mean_curvature}
            made = trimesh.Trimesh(self.vertices, self.triangles, process=False, vertex_attributes=attributes)
        names = {"in": "inches", "ft": "feet"}
        made.units = names.get(self.unit, self.unit)
        return made

    def to_meshio(self) -> Any:
        """A `meshio.Mesh` with one block of triangles; of lines with their `force` for a cable net. Needs meshio."""
        import meshio

        data = {} if self.mean_curvature is None else {"mean_curvature": self.mean_curvature}
        if len(self.edges) > 0:
            return meshio.Mesh(self.vertices, [("line", self.edges)], cell_data={"force": [self.forces]})
        return meshio.Mesh(self.vertices, [("triangle", self.triangles)], point_data=data)

    def to_compas(self) -> Any:
        """A `compas.datastructures.Mesh`, its vertices with `mean_curvature` where it is known. Needs compas.

        A cable net becomes a `compas.datastructures.Graph`, its edges with `force`.
        """
        if len(self.edges) > 0:
            from compas.datastructures import Graph

            graph = Graph.from_nodes_and_edges(self.vertices.tolist(), [tuple(ends) for ends in self.edges.tolist()])
            for ends, force in zip(self.edges.tolist(), self.forces.tolist()):
                graph.edge_attribute(tuple(ends), "force", force)
            return graph
        from compas.datastructures import Mesh as CompasMesh

        mesh = CompasMesh.from_vertices_and_faces(self.vertices.tolist(), self.triangles.tolist())
        if self.mean_curvature is not None:
            for vertex, value in enumerate(self.mean_curvature.tolist()):
                mesh.vertex_attribute(vertex, "mean_curvature", value)
        return mesh

    def to_rhino3dm(self) -> Any:
        """A `rhino3dm.Mesh` with double-precision vertices and normals. Needs rhino3dm.

        A cable net becomes a list of `rhino3dm.LineCurve`, one for each edge.
        """
        import rhino3dm

        if len(self.edges) > 0:
            points = [rhino3dm.Point3d(*point) for point in self.vertices.tolist()]
            return [rhino3dm.LineCurve(points[a], points[b]) for a, b in self.edges.tolist()]
        mesh = rhino3dm.Mesh()
        for x, y, z in self.vertices.tolist():
            mesh.Vertices.AddPoint3d(x, y, z)  # `Add` keeps f32
        for a, b, c in self.triangles.tolist():
            mesh.Faces.AddFace(a, b, c)
        mesh.Normals.ComputeNormals()
        return mesh


def read_ply(data: bytes) -> Any:
    """Vertices, triangles, mean curvature, unit and up axis of the server's binary PLY."""
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = [line.split() for line in data[:end].decode("utf-8").splitlines()]
    counts = {line[1]: int(line[2]) for line in header if line[0] == "element"}
    columns = _columns(header, "vertex")
    frame = next(line for line in header if line[:2] == ["comment", "unit"])
    table = np.frombuffer(data, dtype=columns, count=counts["vertex"], offset=end)
    face: Any = np.dtype([("size", "u1"), ("corners", "<u4", 3)])
    faces = np.frombuffer(data, dtype=face, count=counts["face"], offset=end + table.nbytes)
    curvature = table["mean_curvature"].copy() if "mean_curvature" in columns.names else None
    vertices = np.stack([table["x"], table["y"], table["z"]], axis=1)
    return vertices, faces["corners"].astype(np.int64), curvature, frame[2].rstrip(","), frame[3]


def read_edges(data: bytes) -> Any:
    """The edges of the server's binary PLY and their forces, which follow the faces."""
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = [line.split() for line in data[:end].decode("utf-8").splitlines()]
    counts = {line[1]: int(line[2]) for line in header if line[0] == "element"}
    count = counts.get("edge", 0)
    if count == 0:
        return np.empty((0, 2), dtype=np.int64), np.empty(0)
    columns = _columns(header, "edge")
    table = np.frombuffer(data, dtype=columns, count=count, offset=len(data) - count * columns.itemsize)
    ends = np.stack([table["vertex1"], table["vertex2"]], axis=1).astype(np.int64)
    return ends, table["force"].copy() if "force" in columns.names else np.empty(0)


def _columns(header: List[List[str]], element: str) -> Any:
    """The type of one row of an element of a PLY file, lists left out."""
    types = {"double": "<f8", "float": "<f4", "uchar": "u1", "int": "<i4"}
    found, current = [], ""
    for line in header:
        if line[0] == "element":
            current = line[1]
        elif line[0] == "property" and len(line) == 3 and current == element:
            found.append((line[2], types[line[1]]))
    return np.dtype(found)


def read_lines(data: bytes) -> Dict[str, Lines]:
    """The lines of a mesh in the server's JSON, by name."""
    found: Dict[str, Lines] = {}
    for line in json.loads(data)["lines"]:
        said = line["values"]
        found[line["name"]] = Lines(
            [np.array(path, dtype=np.int64) for path in line["paths"]],
            np.array(line["arrows"], dtype=np.float64).reshape(-1, 2, 3),
            {said["name"]: np.array(said["values"], dtype=np.float64)} if said else {},
            said["unit"] if said else None,
        )
    return found
