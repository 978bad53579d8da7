"""The mesh of a job as numpy arrays, and its way into other libraries."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Generic, List, Optional, TypeVar

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    from .api_types import Job, JobWarning

Statistics = TypeVar("Statistics")


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
        """A `trimesh.Trimesh` with f64 vertices, none merged. Needs trimesh."""
        import trimesh

        attributes = {} if self.mean_curvature is None else {"mean_curvature": self.mean_curvature}
        names = {"in": "inches", "ft": "feet"}
        mesh = trimesh.Trimesh(self.vertices, self.triangles, process=False, vertex_attributes=attributes)
        mesh.units = names.get(self.unit, self.unit)
        return mesh

    def to_meshio(self) -> Any:
        """A `meshio.Mesh` with one block of triangles. Needs meshio."""
        import meshio

        data = {} if self.mean_curvature is None else {"mean_curvature": self.mean_curvature}
        return meshio.Mesh(self.vertices, [("triangle", self.triangles)], point_data=data)

    def to_compas(self) -> Any:
        """A `compas.datastructures.Mesh`, its vertices with `mean_curvature` where it is known. Needs compas."""
        from compas.datastructures import Mesh as CompasMesh

        mesh = CompasMesh.from_vertices_and_faces(self.vertices.tolist(), self.triangles.tolist())
        if self.mean_curvature is not None:
            for vertex, value in enumerate(self.mean_curvature.tolist()):
                mesh.vertex_attribute(vertex, "mean_curvature", value)
        return mesh

    def to_rhino3dm(self) -> Any:
        """A `rhino3dm.Mesh` with double-precision vertices and normals. Needs rhino3dm."""
        import rhino3dm

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


def read_lines(obj: bytes) -> Dict[str, List[npt.NDArray[np.int64]]]:
    """The curves of an OBJ file by the names of their sets, as indices into the vertices."""
    sets: Dict[str, List[npt.NDArray[np.int64]]] = {}
    name = ""
    for line in obj.split(b"\n"):
        if line.startswith(b"o "):
            name = line[2:].decode("utf-8")
        elif line.startswith(b"l "):
            sets.setdefault(name, []).append(np.array(line[2:].split(), dtype=np.int64) - 1)
    return sets
