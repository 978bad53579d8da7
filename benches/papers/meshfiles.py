"""Reads triangle meshes that anyone wrote: PLY (ASCII and binary), OBJ and GLB. Needs numpy only."""
import json
import struct

import numpy as np

PLY_TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2", "ushort": "u2",
    "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4", "float": "f4", "float32": "f4",
    "double": "f8", "float64": "f8",
}
GLTF_TYPES = {5120: "i1", 5121: "u1", 5122: "i2", 5123: "u2", 5125: "u4", 5126: "f4"}
GLTF_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class Mesh:
    """Vertices (n x 3, float64), triangles (m x 3, vertex numbers from 0) and named sets of segments (k x 2)."""

    def __init__(self, vertices, triangles, lines=None, digits=1e-15):
        self.vertices = np.asarray(vertices, float).reshape(-1, 3)
        self.triangles = np.asarray(triangles, np.int64).reshape(-1, 3)
        self.lines = {name: np.asarray(pairs, np.int64).reshape(-1, 2) for name, pairs in (lines or {}).items()}
        # Relative precision of the coordinates: GLB and many PLY files have 24 bits.
        self.digits = digits
        if len(self.triangles) and not 0 <= self.triangles.min() <= self.triangles.max() < len(self.vertices):
            raise ValueError("a triangle names a vertex that does not exist")
        if not np.isfinite(self.vertices).all():
            raise ValueError("a coordinate is not a finite number")


def read(path):
    """The mesh in a file, by the file's ending. Polygons are cut into fans. Vertices keep the file's order, and GLB's
    metres with Y up are turned back to Z up."""
    ending = str(path).rsplit(".", 1)[-1].lower()
    readers = {"ply": read_ply, "obj": read_obj, "glb": read_glb}
    if ending not in readers:
        raise ValueError(f"{path}: not a .ply, .obj or .glb file")
    with open(path, "rb") as file:
        return readers[ending](file.read())


def fans(polygons):
    return [(polygon[0], polygon[k], polygon[k + 1]) for polygon in polygons for k in range(1, len(polygon) - 1)]


def read_obj(data):
    vertices, polygons, lines, name = [], [], {}, ""
    for row in data.decode("utf-8", "replace").splitlines():
        words = row.split()
        if not words:
            continue
        # Numbers count from 1, and negative ones from the end.
        index = lambda word: (lambda k: k - 1 if k > 0 else len(vertices) + k)(int(word.split("/")[0]))
        if words[0] == "v":
            vertices.append([float(word) for word in words[1:4]])
        elif words[0] == "f":
            polygons.append([index(word) for word in words[1:]])
        elif words[0] in ("o", "g"):
            name = "_".join(words[1:])
        elif words[0] == "l":
            ends = [index(word) for word in words[1:]]
            lines.setdefault(name, []).extend(zip(ends, ends[1:]))
    return Mesh(vertices, fans(polygons), lines)


def read_ply(data):
    head, body = data.split(b"end_header", 1)
    body = body[body.index(b"\n") + 1:]
    elements, encoding = [], "ascii"
    for words in (row.split() for row in head.decode("ascii", "replace").splitlines()):
        if words and words[0] == "format":
            encoding = words[1]
        elif words and words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words and words[0] == "property":
            elements[-1][2].append((words[-1], [PLY_TYPES[word] for word in words[1:-1] if word != "list"]))
    order = "<" if encoding == "binary_little_endian" else ">"
    numbers, at, found, digits = body.split() if encoding == "ascii" else None, 0, {}, 1e-15

    def take(kind):
        nonlocal at
        if numbers is not None:
            at += 1
            return float(numbers[at - 1])
        value = np.frombuffer(body, order + kind, 1, at)[0]
        at += np.dtype(kind).itemsize
        return value

    for name, count, properties in elements:
        plain = all(len(kinds) == 1 for _, kinds in properties)
        if plain and numbers is None:
            kind = np.dtype([(key, order + kinds[0]) for key, kinds in properties])
            found[name] = np.frombuffer(body, kind, count, at)
            at += kind.itemsize * count
        elif plain:
            table = np.array(numbers[at:at + count * len(properties)], float).reshape(count, len(properties))
            at += table.size
            found[name] = {key: table[:, k] for k, (key, _) in enumerate(properties)}
        else:
            rows = []
            for _ in range(count):
                row = {}
                for key, kinds in properties:
                    row[key] = [take(kinds[1]) for _ in range(int(take(kinds[0])))] if len(kinds) == 2 else take(kinds[0])
                rows.append(row)
            found[name] = rows
        if name == "vertex" and any(key == "x" and kinds[0] == "f4" for key, kinds in properties):
            digits = 6e-8
    vertices = np.stack([np.asarray(found["vertex"][axis], float) for axis in "xyz"], 1)
    key = lambda row: row["vertex_indices"] if "vertex_indices" in row else row["vertex_index"]
    polygons = [[int(k) for k in key(row)] for row in found.get("face", [])]
    lines = {}
    if "edge" in found:
        edges = found["edge"]
        lines["edge"] = np.stack([np.asarray(edges["vertex1"], np.int64), np.asarray(edges["vertex2"], np.int64)], 1)
    return Mesh(vertices, fans(polygons), lines, digits)


def read_glb(data):
    if data[:4] != b"glTF":
        raise ValueError("not a GLB file")
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20:20 + length])
    binary = data[20 + length + 8:]

    def array(number):
        accessor = document["accessors"][number]
        view = document["bufferViews"][accessor["bufferView"]]
        kind, width = np.dtype("<" + GLTF_TYPES[accessor["componentType"]]), GLTF_WIDTHS[accessor["type"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", kind.itemsize * width)
        rows = np.ndarray((accessor["count"], width), kind, binary, start, (stride, kind.itemsize))
        return rows[:, 0] if width == 1 else rows

    vertices, triangles, lines, offset = [], [], {}, 0
    for node in document["nodes"]:
        if "mesh" not in node or any(key in node for key in ("matrix", "rotation", "scale")):
            continue
        shift = np.array(node.get("translation", [0, 0, 0]), float)
        for primitive in document["meshes"][node["mesh"]]["primitives"]:
            points = array(primitive["attributes"]["POSITION"]).astype(float) + shift
            indices = array(primitive["indices"]) if "indices" in primitive else np.arange(len(points))
            indices = indices.astype(np.int64) + offset
            mode = primitive.get("mode", 4)
            if mode == 4:
                triangles.append(indices.reshape(-1, 3))
            elif mode == 1:
                lines[node.get("name", "")] = indices.reshape(-1, 2)
            elif mode == 3:
                lines[node.get("name", "")] = np.stack([indices[:-1], indices[1:]], 1)
            vertices.append(points)
            offset += len(points)
    vertices = np.concatenate(vertices)
    # glTF is in metres with Y up: (x, y, z) stands for (x, -z, y).
    vertices = np.stack([vertices[:, 0], -vertices[:, 2], vertices[:, 1]], 1)
    return Mesh(vertices, np.concatenate(triangles) if triangles else [], lines, 6e-8)
