#!/usr/bin/env python3
"""The judge on meshes whose figures are known: exact surfaces, a plane, hand-made strips, and wrong meshes.

    python3 benches/papers/test_judge.py
"""
import json
import math
import os
import struct
import tempfile
import unittest

import numpy as np

import judge
import meshfiles


def grid(surface, us, vs):
    """The image of a grid of parameters, each cell cut along the same diagonal."""
    nu, nv = len(us), len(vs)
    vertices = np.array([surface(u, v) for u in us for v in vs])
    at = lambda i, j: i * nv + j
    triangles = []
    for i in range(nu - 1):
        for j in range(nv - 1):
            triangles += [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
    return meshfiles.Mesh(vertices, triangles)


def catenoid(n):
    point = lambda u, v: (math.cosh(v) * math.cos(u), math.cosh(v) * math.sin(u), v)
    return grid(point, np.linspace(-1, 1, n + 1), np.linspace(-0.5, 0.5, n + 1))


def helicoid(n):
    point = lambda u, v: (u * math.cos(v), u * math.sin(v), 1.9 * v)
    return grid(point, np.linspace(0.5, 2, n + 1), np.linspace(-1, 1, n + 1))


def plane():
    vertices = np.random.default_rng(1).random((7, 7, 2)) * 0.4
    point = lambda i, j: (i + vertices[int(i), int(j), 0], j + vertices[int(i), int(j), 1], 2.0)
    return grid(point, range(7), range(7))


class ExactSurfaces(unittest.TestCase):
    def test_catenoid(self):
        # The area is the integral of cosh² v: 2 (v / 2 + sinh(2 v) / 4) from -0.5 to 0.5.
        exact = 2 * (0.5 + math.sinh(1) / 2)
        errors, bends = [], []
        for n in (16, 32, 64):
            found = judge.judge(catenoid(n), surface="catenoid-z:1")
            self.assertEqual(found["faults"], [])
            self.assertLess(found["liu_wang"]["max_error"], 1e-14)
            errors.append(exact - found["shape"]["area"])
            bends.append(found["chen_cai_zheng"]["curvature_normal_max"])
        for coarse, fine in zip(errors, errors[1:]):
            self.assertAlmostEqual(coarse / fine, 4, delta=0.02)
        # The points lie on the surface, so that the curvature vanishes with the square of the edge length.
        self.assertLess(bends[2], bends[0] / 12)

    def test_helicoid(self):
        found = judge.judge(helicoid(24), surface="helicoid:1.9")
        self.assertEqual(found["topology"]["euler_characteristic"], 1)
        self.assertLess(found["liu_wang"]["mean_error"], 1e-14)
        self.assertLess(found["liu_wang"]["mean_cycle_curvature"], 2e-3)
        moved = helicoid(24)
        moved.vertices[:, 1] += 0.01 * (np.abs(moved.vertices[:, 1]) <= 1)
        self.assertGreater(judge.judge(moved, surface="helicoid:1.9")["liu_wang"]["mean_error"], 4e-3)

    def test_a_cylinder_has_the_curvature_of_a_cylinder(self):
        # H = 1/4 of a cylinder of radius 2; Chen, Cai and Zheng's figure is a third of that.
        point = lambda u, v: (2 * math.cos(u), 2 * math.sin(u), v)
        found = judge.judge(grid(point, np.linspace(0, 2, 81), np.linspace(0, 2, 41)))
        self.assertAlmostEqual(found["chen_cai_zheng"]["curvature_mean"], 0.25 / 3, delta=1e-4)
        self.assertAlmostEqual(found["chen_cai_zheng"]["curvature_normal_max"], 0.25 / 3, delta=1e-4)
        # Liu and Wang's normal cycle gives the sum of the principal curvatures.
        self.assertAlmostEqual(found["liu_wang"]["mean_cycle_curvature"], 0.5, delta=0.002)

    def test_plane(self):
        found = judge.judge(plane(), surface="plane-z:2")
        self.assertEqual(found["faults"], [])
        for paper, figure in [("chen_cai_zheng", "curvature_max"), ("liu_wang", "F"), ("liu_wang", "mean_error")]:
            self.assertLess(found[paper][figure], 1e-12, figure)
        self.assertAlmostEqual(found["bento_cavalcanti"]["dirichlet_energy"], found["shape"]["area"], places=12)

    def test_dirichlet_energy_of_a_stretch(self):
        # (x, y) -> (3 x, y): half of 3² + 1² times the area.
        image = plane()
        image.vertices[:, 0] *= 3
        found = judge.judge(image, domain=plane())
        self.assertAlmostEqual(
            found["bento_cavalcanti"]["dirichlet_energy"], 5 * judge.judge(plane())["shape"]["area"], places=11)

    def test_equal_edges(self):
        lattice = grid(lambda i, j: (5 * (i + j / 2), 5 * j * math.sqrt(0.75), 0), range(6), range(5))
        # The other diagonal has the lattice's length.
        lattice = meshfiles.Mesh(lattice.vertices, [
            t for i in range(5) for j in range(4)
            for t in ([i * 5 + j, i * 5 + j + 5, i * 5 + j + 1], [i * 5 + j + 5, i * 5 + j + 6, i * 5 + j + 1])])
        found = judge.judge(lattice, length=5.0)["katoh_ohsaki_xu"]
        self.assertEqual((found["edges"]["count"], found["equal"], found["outside"]), (69, 69, 0))
        self.assertAlmostEqual(found["edges"]["std"], 0, places=12)


class Strips(unittest.TestCase):
    def strip(self, P, Q, path):
        m = len(P)
        triangles = [(i, i2, m + j) if i2 > i else (i, m + j2, m + j) for (i, j), (i2, j2) in zip(path, path[1:])]
        return judge.wang_tang(meshfiles.Mesh(list(P) + list(Q), triangles), {"directrices": [P, Q]})

    def test_a_plane_strip_is_developable(self):
        P, Q = [(k, 0, 0) for k in range(4)], [(k + 0.3, 1, 0) for k in range(4)]
        found = self.strip(P, Q, [(0, 0), (1, 0), (1, 1), (2, 1), (2, 2), (3, 2), (3, 3)])
        self.assertAlmostEqual(found["area"], 3)
        for figure in ("total_normal_twist", "bending_energy", "mean_curvature_variation"):
            self.assertAlmostEqual(found[figure], 0)
        self.assertEqual((found["convex_bridges"], found["bridges"]), (7, 7))

    def test_a_right_angle_has_the_bending_of_its_formula(self):
        # Two triangles at a right angle along a bridge of length 1: A = 1, L = 2, U = A sin² / L² = 1/4.
        P, Q = [(0, 0, 0), (0, 0, 1)], [(1, 0, 0), (0, 1, 0)]
        found = self.strip([P[0]] + [(0, 1, 0)], [(1, 0, 0), (0, 0, 1)], [(0, 0), (0, 1), (1, 1)])
        self.assertEqual(found["bridges"], 3)
        # The bridge from (0, 0, 0) to (0, 0, 1) has length 1 and triangles of area 1/2 in the planes y = 0, x = 0.
        self.assertAlmostEqual(found["bending_energy"], 0.25)
        # H is sqrt(2) long there and 0 at both ends.
        self.assertAlmostEqual(found["mean_curvature_variation"], 2 * math.sqrt(2))

    def test_a_saddle_bridge_is_not_convex(self):
        P = [(0, 0, 0), (1, 0, 0.5), (2, 0, 0)]
        Q = [(0, 1, 0), (1, 1, -0.5), (2, 1, 0)]
        found = self.strip(P, Q, [(0, 0), (1, 0), (1, 1), (2, 1), (2, 2)])
        self.assertEqual(found["convex_bridges"], 4)


class WrongMeshes(unittest.TestCase):
    def faults(self, change):
        mesh = catenoid(8)
        mesh = change(mesh) or mesh
        return " ".join(judge.judge(mesh)["faults"])

    def test_each_fault_is_named(self):
        def with_triangles(change):
            return lambda mesh: meshfiles.Mesh(mesh.vertices, change(mesh.triangles))

        turned = lambda t: np.concatenate([[t[40][::-1]], t[:40], t[41:]])
        self.assertIn("run through in the same sense", self.faults(with_triangles(turned)))
        self.assertIn("repeated", self.faults(with_triangles(lambda t: np.concatenate([t, t[:1]]))))
        self.assertIn("more than two", self.faults(with_triangles(lambda t: np.concatenate([t, [[0, 9, 30]], [[9, 10, 40]]]))))

        def fold(mesh):
            mesh.vertices[40] = mesh.vertices[22] + 0.9 * (mesh.vertices[22] - mesh.vertices[40])

        self.assertIn("flipped", self.faults(fold))

        def collapse(mesh):
            mesh.vertices[40] = mesh.vertices[41]

        self.assertIn("degenerate", self.faults(collapse))

    def test_a_hole_is_a_loop_and_a_moved_boundary_is_named(self):
        mesh = catenoid(8)
        rim = judge.soundness(mesh)[3][0]
        request = {"boundaries": [mesh.vertices[rim].tolist()]}
        self.assertEqual(judge.judge(mesh, request)["faults"], [])
        self.assertEqual(judge.judge(mesh, {"boundaries": [request["boundaries"][0][::-1]]})["faults"], [])
        holed = meshfiles.Mesh(mesh.vertices, np.delete(mesh.triangles, 60, 0))
        self.assertEqual(judge.judge(holed)["topology"]["boundary_loops"], 2)
        mesh.vertices[rim[3]] += 1e-9
        self.assertEqual(judge.judge(mesh, request)["faults"], ["boundary 0 is not a loop of the mesh"])


class Files(unittest.TestCase):
    def same(self, name, data, digits=0.0):
        mesh = catenoid(4)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, name)
            with open(path, "wb") as file:
                file.write(data)
            found = meshfiles.read(path)
        self.assertLessEqual(np.abs(found.vertices - mesh.vertices).max(), digits)
        self.assertTrue((found.triangles == mesh.triangles).all())
        return found

    def test_obj_with_lines_and_negative_numbers(self):
        mesh = catenoid(4)
        rows = ["# a comment"] + [f"v {x!r} {y!r} {z!r}" for x, y, z in mesh.vertices.tolist()] + ["o surface"]
        rows += [f"f {a - 25}/1 {b + 1}//2 {c + 1}" for a, b, c in mesh.triangles]
        found = self.same("a.obj", "\n".join(rows + ["o lattice", "l 1 2 3"]).encode())
        self.assertEqual(found.lines["lattice"].tolist(), [[0, 1], [1, 2]])

    def test_ply_in_three_encodings(self):
        mesh = catenoid(4)
        for encoding, order in [("ascii", ""), ("binary_little_endian", "<"), ("binary_big_endian", ">")]:
            head = (f"ply\nformat {encoding} 1.0\nelement vertex 25\nproperty double x\nproperty double y\n"
                    "property double z\nproperty uchar red\nelement face 32\nproperty list uchar int vertex_indices\n"
                    "end_header\n").encode()
            if encoding == "ascii":
                body = "".join(f"{x!r} {y!r} {z!r} 7\n" for x, y, z in mesh.vertices.tolist())
                body = (body + "".join(f"3 {a} {b} {c}\n" for a, b, c in mesh.triangles)).encode()
            else:
                body = b"".join(struct.pack(order + "dddB", *p, 7) for p in mesh.vertices)
                body += b"".join(struct.pack(order + "Biii", 3, *t) for t in mesh.triangles)
            self.same("a.ply", head + body)

    def test_glb_turns_back_to_z_up(self):
        mesh = catenoid(4)
        shift = np.array([10.0, 20.0, 30.0])
        y_up = np.stack([mesh.vertices[:, 0], mesh.vertices[:, 2], -mesh.vertices[:, 1]], 1) - shift
        points, indices = y_up.astype("<f4").tobytes(), mesh.triangles.astype("<u2").tobytes()
        document = {
            "nodes": [{"mesh": 0, "translation": shift.tolist()}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 25, "type": "VEC3"},
                          {"bufferView": 1, "componentType": 5123, "count": 96, "type": "SCALAR"}],
            "bufferViews": [{"byteLength": len(points)}, {"byteOffset": len(points), "byteLength": len(indices)}],
        }
        text = json.dumps(document).encode()
        text += b" " * (-len(text) % 4)
        body = struct.pack("<I4s", len(text), b"JSON") + text
        body += struct.pack("<I4s", len(points + indices), b"BIN\0") + points + indices
        self.same("a.glb", struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body, 1e-5)


if __name__ == "__main__":
    unittest.main()
