"""Reads every example in every format with the programs that people already have, and compares what they read.

Usage: PLATEAU_URL=http://… scripts/check_readers.py [--write] [--reader NAME]…

Each example is solved, and its mesh is fetched as JSON, which has every digit. A copy of one example at survey
coordinates is solved too. Each reader then reads each file in a process of its own, so that a crash is a finding and not
the end of this script. The script compares triangles, area and positions with the JSON mesh, and finds out from the
positions in which axes and unit the reader shows the mesh. It prints a table, and fails if a reader crashes, refuses a
file, or loses triangles, area or place, other than as EXPECTED says. With --write the table replaces the one of
docs/readers.md. A reader that is not installed is named as skipped.

The readers: .tools/readers/bin/pip install -r scripts/readers.txt, Debian's assimp-utils, and npm ci in scripts/ and web/.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from service import examples, request, solve
from skips import skip

ROOT = Path(__file__).resolve().parent.parent
METRES = {"mm": 0.001, "cm": 0.01, "m": 1.0, "in": 0.0254, "ft": 0.3048}
SURVEY = (412_345.678, 5_654_321.012, 251.5)
SURVEY_OF = "wavy-strip"

# Each file: its format and the parameters of the request, as the table names it.
FILES = {
    "GLB": "format=glb",
    "GLB, lines=false": "format=glb&lines=false",
    "glTF": "format=gltf",
    "glTF, lines=false": "format=gltf&lines=false",
    "OBJ": "format=obj",
    "OBJ, lines=false": "format=obj&lines=false",
    "PLY": "format=ply",
    "PLY, ascii": "format=ply&encoding=ascii",
    "STL": "format=stl",
    "JSON": "format=json",
}


# ---- readers: each takes a file and returns vertices and triangles in the axes and unit that the program shows


def trimesh(path):
    import trimesh as library

    scene = library.load_scene(path, process=False)
    meshes = [m for m in scene.dump() if isinstance(m, library.Trimesh)]
    return joined([(m.vertices, m.faces) for m in meshes])


def meshio(path):
    import meshio as library

    mesh = library.read(path)
    return mesh.points, mesh.cells_dict["triangle"]


def pymeshlab(path):
    import pymeshlab as library

    meshes = library.MeshSet(verbose=False)
    meshes.load_new_mesh(str(path))
    parts = []
    for mesh in (meshes.mesh(k) for k in range(len(meshes))):
        vertices = np.c_[mesh.vertex_matrix(), np.ones(mesh.vertex_number())] @ np.array(mesh.transform_matrix()).T
        parts.append((vertices[:, :3], mesh.face_matrix()))
    return joined(parts)


def open3d(path):
    import open3d as library

    library.utility.set_verbosity_level(library.utility.VerbosityLevel.Error)
    mesh = library.io.read_triangle_mesh(str(path))
    return np.asarray(mesh.vertices), np.asarray(mesh.triangles)


def compas(path):
    from compas.datastructures import Mesh

    mesh = getattr(Mesh, f"from_{path.suffix[1:]}")(path)
    vertices, faces = mesh.to_vertices_and_faces(triangulated=True)
    return vertices, faces


def rhino3dm(path):
    import rhino3dm as library

    given = json.loads(path.read_text())
    mesh = library.Mesh()
    for x, y, z in given["vertices"]:
        mesh.Vertices.AddPoint3d(x, y, z)  # `Add` keeps f32
    for a, b, c in given["triangles"]:
        mesh.Faces.AddFace(a, b, c)
    # Through a file, because that is how a mesh reaches Rhino.
    model, written = library.File3dm(), path.with_suffix(".3dm")
    model.Objects.AddMesh(mesh)
    model.Write(str(written), 8)
    read = library.File3dm.Read(str(written)).Objects[0].Geometry
    vertices = [(v.X, v.Y, v.Z) for v in (read.Vertices.Point3dAt(k) for k in range(len(read.Vertices)))]
    return vertices, [read.Faces[k][:3] for k in range(read.Faces.Count)]


def assimp(path):
    # Assimp's library reads the file; its program writes what was read as OBJ with nine digits.
    written = path.with_name(path.stem + "-assimp.obj")
    ran = subprocess.run(["assimp", "export", path, written], capture_output=True, text=True)
    if ran.returncode < 0:
        os.kill(os.getpid(), -ran.returncode)
    if ran.returncode > 0 or not written.exists():
        raise ValueError(ran.stdout.strip().splitlines()[-1])
    return obj(written)


def three(path):
    return from_node(["scripts/read_with_three.mjs", path])


def khronos(path):
    ran = subprocess.run(["node", "scripts/validate-gltf.mjs", path], capture_output=True, text=True, cwd=ROOT)
    if ran.returncode != 0:
        raise ValueError(ran.stdout.splitlines()[0])
    return None


READERS = {
    "trimesh": (trimesh, ["GLB", "glTF", "OBJ", "PLY", "PLY, ascii", "STL"]),
    "meshio": (meshio, ["OBJ", "OBJ, lines=false", "PLY", "PLY, ascii", "STL"]),
    "pymeshlab": (pymeshlab, ["GLB", "GLB, lines=false", "glTF, lines=false", "OBJ", "PLY", "PLY, ascii", "STL"]),
    "Open3D": (open3d, ["GLB", "GLB, lines=false", "glTF", "OBJ", "PLY", "PLY, ascii", "STL"]),
    "Assimp": (assimp, ["GLB", "GLB, lines=false", "glTF", "glTF, lines=false", "OBJ", "PLY", "PLY, ascii", "STL"]),
    "compas": (compas, ["OBJ", "OBJ, lines=false", "PLY", "PLY, ascii", "STL"]),
    "rhino3dm": (rhino3dm, ["JSON"]),
    "three.js": (three, ["GLB", "glTF", "OBJ", "PLY", "PLY, ascii", "STL"]),
    "Khronos validator": (khronos, ["GLB", "GLB, lines=false", "glTF"]),
}

# What is known to be lost, and what to do instead.
EXPECTED = {
    ("compas", "PLY"): "reads no binary PLY: `encoding=ascii`",
    ("pymeshlab", "GLB"): "takes lines for triangles and may crash: `lines=false`",
    ("Assimp", "GLB"): "its exporter ends at lines with values: `lines=false`",
    ("Assimp", "glTF"): "its exporter ends at lines with values: `lines=false`",
}


def joined(parts):
    vertices, triangles, count = [], [], 0
    for part_vertices, part_triangles in parts:
        vertices.append(np.asarray(part_vertices, float))
        triangles.append(np.asarray(part_triangles, int) + count)
        count += len(part_vertices)
    return np.concatenate(vertices), np.concatenate(triangles)


def obj(path):
    vertices, triangles = [], []
    for line in path.read_text().splitlines():
        word, *rest = line.split()[:4] or [""]
        if word == "v":
            vertices.append([float(x) for x in rest])
        if word == "f":
            triangles.append([int(corner.split("/")[0]) - 1 for corner in rest])
    return vertices, triangles


def from_node(command):
    ran = subprocess.run(["node", *command], capture_output=True, cwd=ROOT)
    if ran.returncode != 0:
        raise ValueError(ran.stderr.decode().strip().splitlines()[-1])
    head, _, data = ran.stdout.partition(b"\n")
    corners = json.loads(head)["vertices"]
    vertices = np.frombuffer(data, "<f8", 3 * corners).reshape(-1, 3)
    return vertices, np.arange(corners).reshape(-1, 3)


# ---- comparison, in the reader's own process


def area(vertices, triangles):
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()


def frames(mesh):
    """The mesh in each system of axes and units that a file may be shown in, with the length of one unit."""
    vertices, scale = np.array(mesh["vertices"]), METRES[mesh["unit"]]
    middle = 0.5 * vertices.min(0) + 0.5 * vertices.max(0)

    def gltf(points):
        return scale * (points if mesh["up"] == "y" else np.c_[points[:, 0], points[:, 2], -points[:, 1]])

    return {
        "the request's": (vertices, 1.0),
        "the request's, around the middle": (vertices - middle, 1.0),
        "metres, Y up": (gltf(vertices), scale),
        "metres, Y up, around the middle": (gltf(vertices - middle), scale),
    }


def compare(read, mesh):
    vertices, triangles = (np.asarray(part) for part in read)
    vertices = vertices.astype(float)
    used = vertices[np.unique(triangles)]
    expected_triangles = np.array(mesh["triangles"])
    found = {"triangles": len(triangles), "of": len(expected_triangles), "frames": {}}
    tree = cKDTree(used)
    for name, (points, unit) in frames(mesh).items():
        points = points[np.unique(expected_triangles)]
        size = np.linalg.norm(points.max(0) - points.min(0))
        apart = max(tree.query(points)[0].max(), cKDTree(points).query(used)[0].max())
        expected = area(frames(mesh)[name][0], expected_triangles)
        found["frames"][name] = {
            "apart": apart / size,
            "apart_metres": apart / unit * METRES[mesh["unit"]],
            "area": abs(area(vertices, triangles) / expected - 1) if expected > 0 else 0.0,
        }
    return found


def read_all(reader, names):
    """The part that runs in a process of its own: a line of JSON before and after each file."""
    for name in names:
        print(json.dumps({"reading": name}), flush=True)
        path, mesh = Path(name), json.loads(Path(name).with_name("mesh.json").read_text())
        try:
            read = READERS[reader][0](path)
            answer = {} if read is None else compare(read, mesh)
        except ImportError as error:
            answer = {"missing": str(error)}
        except Exception as error:  # Whatever a reader says of a file is its finding.
            answer = {"refused": f"{type(error).__name__}: {error}"[:300]}
        print(json.dumps(answer), flush=True)


# ---- the meshes and the table


def moved(points, by):
    if isinstance(points[0], (int, float)):
        return [x + d for x, d in zip(points, by)]
    return [moved(part, by) for part in points]


def fetch_all(folder):
    """Writes every file of every example with triangles, and returns the names of the meshes."""
    names = []
    for name, kind, body in examples():
        if kind == "cable_net":
            continue  # A cable net has lines and no triangles, so the table's areas would say nothing.
        names.append(name)
        requests = {name: body}
        if name == SURVEY_OF:
            requests["survey"] = {**body, "directrices": moved(body["directrices"], SURVEY)}
        for own, given in requests.items():
            job = solve(kind, given)
            (folder / own).mkdir()
            (folder / own / "mesh.json").write_bytes(request(job["links"]["mesh"] + "?format=json"))
            for title, query in FILES.items():
                (folder / own / file_name(title)).write_bytes(request(f"{job['links']['mesh']}?{query}"))
    return [*names, "survey"]


def file_name(title):
    kind, _, option = title.partition(", ")
    suffix = {"GLB": "glb", "glTF": "gltf", "OBJ": "obj", "PLY": "ply", "STL": "stl", "JSON": "json"}[kind]
    return f"{option.replace('=', '-') or 'file'}.{suffix}"


def findings(reader, paths):
    """What a reader finds in each file. A crash ends its process, and another one goes on with the next file."""
    found, left = {}, list(paths)
    while left:
        command = [sys.executable, __file__, "--child", reader, *left]
        ran = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        lines = [json.loads(line) for line in ran.stdout.splitlines() if line.startswith("{")]
        answers = [line for line in lines if "reading" not in line]
        if len(answers) < len(left):
            how = f"signal {-ran.returncode}" if ran.returncode < 0 else f"exit status {ran.returncode}"
            answers.append({"crashed": how})
        found.update(zip(left, answers))
        left = left[len(answers) :]
        if answers and "missing" in answers[-1]:
            break
    return found


def row(reader, title, names, folder):
    """A row of the table, and what is wrong."""
    paths = {name: str(folder / name / file_name(title)) for name in names}
    found = findings(reader, paths.values())
    if any("missing" in answer for answer in found.values()):
        return None, []
    wrong = []
    for name, path in paths.items():
        for trouble in ("crashed", "refused"):
            if trouble in found[path]:
                wrong.append(f"{reader}, {title}, {name}: {trouble}: {found[path][trouble]}")
    read = {name: found[path] for name, path in paths.items() if "frames" in found[path]}
    good = sum(not ({"crashed", "refused"} & found[path].keys()) for path in paths.values())
    cells = [reader, title, f"{good} of {len(paths)}"]
    if not read:
        return [*cells, "", "", "", ""], wrong
    near = {name: answer for name, answer in read.items() if name != "survey"}
    frame = min(
        near[next(iter(near))]["frames"],
        key=lambda frame: max(answer["frames"][frame]["apart"] for answer in near.values()),
    )
    largest_area = max(answer["frames"][frame]["area"] for answer in near.values())
    largest = max(answer["frames"][frame]["apart"] for answer in near.values())
    for name, answer in near.items():
        figures = answer["frames"][frame]
        if answer["triangles"] != answer["of"]:
            wrong.append(f"{reader}, {title}, {name}: {answer['triangles']} of {answer['of']} triangles")
        elif figures["area"] > 1e-4 or figures["apart"] > 1e-4:
            wrong.append(f"{reader}, {title}, {name}: area {figures['area']:.1e}, apart {figures['apart']:.1e}")
    far = ""
    if "survey" in read:
        best = min(read["survey"]["frames"], key=lambda frame: read["survey"]["frames"][frame]["apart"])
        metres = read["survey"]["frames"][best]["apart_metres"]
        far = f"{length(metres)}" + ("" if best == frame else f", {best}")
    return [*cells, ratio(largest_area), frame, ratio(largest), far], wrong


def ratio(value):
    return "exact" if value == 0 else f"{value:.0e}"


def length(metres):
    if metres == 0:
        return "exact"
    return f"{metres * 1000:.1g} mm" if metres < 0.01 else f"{metres:.1g} m"


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--write", action="store_true")
    arguments.add_argument("--reader", action="append", choices=READERS)
    arguments = arguments.parse_args()
    started = time.monotonic()
    rows, troubles, skipped = [], [], 0
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        names = fetch_all(folder)
        print(f"{len(names)} meshes in {len(FILES)} files each, {time.monotonic() - started:.0f} s", flush=True)
        for reader in arguments.reader or READERS:
            reason = missing(reader)
            for title in READERS[reader][1] if reason is None else []:
                cells, wrong = row(reader, title, names, folder)
                if cells is None:
                    reason = "it is not installed"
                    break
                expected = EXPECTED.get((reader, title))
                rows.append([*cells, expected or ""])
                print(" | ".join(rows[-1]), flush=True)
                if expected is None:
                    troubles.extend(wrong)
                elif not wrong:
                    troubles.append(f"{reader}, {title}: reads everything now, so EXPECTED is out of date")
            if reason is not None:
                skipped += 1
                skip(f"reader {reader}", reason)
    if arguments.write:
        write(rows)
    for trouble in troubles:
        print(f"FAILED: {trouble}")
    print(f"{len(rows)} rows, {len(troubles)} failed, {skipped} readers skipped, {time.monotonic() - started:.0f} s")
    return 1 if troubles or not rows else 0


def missing(reader):
    """Why a reader that is no Python library cannot run."""
    if reader == "Assimp" and not shutil.which("assimp"):
        return "Debian's assimp-utils is not installed"
    if reader in ("three.js", "Khronos validator"):
        where = "web" if reader == "three.js" else "scripts"
        if not shutil.which("node") or not (ROOT / where / "node_modules").exists():
            return f"npm ci has not run in {where}/"
    return None


def write(rows):
    head = ["program", "file", "read", "area, largest error", "axes and unit", "positions, of the size",
            "at survey coordinates", "note"]
    lines = [head, ["---"] * len(head), *rows]
    table = "\n".join("| " + " | ".join(line) + " |" for line in lines)
    path = ROOT / "docs" / "readers.md"
    before, _, rest = path.read_text().partition("<!-- table -->\n")
    path.write_text(f"{before}<!-- table -->\n{table}\n<!-- end -->{rest.partition('<!-- end -->')[2]}")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--child"]:
        read_all(sys.argv[2], sys.argv[3:])
    else:
        sys.exit(main())
