"""Plateau for Blender: minimal surfaces, ruled strips, lattices, membranes and cable nets from picked curves.

A single file: Edit > Preferences > Add-ons > Install from Disk. Set the server's address in the add-on's preferences.
Select one or more curves and run Object > Plateau > Surface Between Curves. The mesh has the scene's unit and lies
where the curves lie. It remembers its curves and settings: select it, or the same curves, and run the command again,
and its mesh is replaced. Esc cancels.
"""

import json
import re
import threading
import urllib.error
import urllib.request

import bpy
import numpy as np

bl_info = {
    "name": "Plateau",
    "author": "Plateau",
    "version": (0, 1, 0),
    "blender": (4, 2, 0),
    "location": "View3D > Object > Plateau",
    "description": "Minimal surfaces, strips, lattices, membranes and cable nets, solved by a Plateau server",
    "category": "Object",
}

ENDED = ("succeeded", "failed", "cancelled")
REQUEST_TIMEOUT_S = 60
PATHS = {
    "ruled_surface": "/v1/ruled-surfaces",
    "minimal_surface": "/v1/minimal-surfaces",
    "uniform_mesh": "/v1/uniform-meshes",
    "tensile_structure": "/v1/tensile-structures",
    "cable_net": "/v1/cable-nets",
}
SETTINGS = ("surface", "objective", "film_objective", "lattice_objective", "triangles", "edge_length", "tension",
            "edge_force", "force_density")
"""The operator's properties that a result remembers."""
CORNER = 0.94
"""Cosine of the least turn at a corner between the cables of a membrane: 20 degrees."""
NEAR = 1e-6
"""Ends of cables that are nearer than this share of the net's size are one vertex."""
UNITS = {1.0: "m", 0.01: "cm", 0.001: "mm", 0.0254: "in", 0.3048: "ft"}
"""The service's units by the scene's metres per unit (Scene properties > Units > Unit Scale)."""


class PlateauError(Exception):
    """What is wrong, in words for the user."""


class Server:
    """Requests to a Plateau server, by the standard library alone."""

    def __init__(self, url, api_key=""):
        self.url = url.rstrip("/")
        self.headers = {"Authorization": "Bearer " + api_key} if api_key else {}

    def send(self, method, path, body=None, headers=()):
        headers = {**self.headers, **dict(headers)}
        if body is not None:
            headers["Content-Type"] = "application/json"
            body = json.dumps(body).encode()
        request = urllib.request.Request(self.url + path, data=body, headers=headers, method=method)
        try:
            with urllib.request.urlopen(request, timeout=REQUEST_TIMEOUT_S) as response:
                return response.read()
        except urllib.error.HTTPError as error:
            raise PlateauError(explain_answer(error.read())) from None
        except OSError as error:
            raise PlateauError(f"{self.url} cannot be reached: {error}") from None

    def solve(self, request, on_progress=lambda fraction: None, is_cancelled=lambda: False):
        """The finished job and its PLY; None if `is_cancelled` became true."""
        job = json.loads(self.send("POST", PATHS[request["kind"]], request))
        while job["status"] not in ENDED:
            if is_cancelled():
                self.send("POST", f"/v1/jobs/{job['id']}/cancel")
                return None
            job = json.loads(self.send("GET", f"/v1/jobs/{job['id']}", headers=[("Prefer", "wait=1")]))
            on_progress(job["progress"]["fraction"])
        if job["status"] != "succeeded":
            raise PlateauError(explain(job["error"]) if job.get("error") else "the job was cancelled")
        return job, self.send("GET", f"/v1/jobs/{job['id']}/mesh?format=ply")


def explain(problem):
    """A problem document, or the error of a failed job, as text with the place of every value that is wrong."""
    places = [f"{error['pointer']}: {error['detail']}" for error in problem.get("errors", [])]
    return "; ".join(places) or f"{problem['title']}: {problem['detail']}"


def explain_answer(body):
    """An answer that is a failure as text; a proxy's own answer need not be a problem document."""
    try:
        return explain(json.loads(body))
    except (ValueError, KeyError):
        return body[:200].decode("utf-8", "replace")


def in_words(text, names):
    """A message with the names of the picked objects and of the settings in the place of JSON pointers."""

    def words(found):
        pointer = found.group(0)
        curve = re.match(r"/(?:domain/)?(?:boundaries|directrices|holes)/(\d+)", pointer)
        if curve:
            index = int(curve.group(1)) + (1 if "/holes/" in pointer else 0)
            return names[index] if index < len(names) else "a curve"
        if pointer.startswith("/domain/polygon"):
            return names[0]
        parts = [part for part in pointer.split("/") if part and not part.isdigit()]
        if parts[0] in ("boundaries", "directrices", "domain", "vertices", "edges", "supports"):
            return "the picked curves" if len(names) > 1 else names[0]
        return "the " + " of the ".join(part.replace("_", " ") for part in reversed(parts))

    return re.sub(r"(?<![\w/.:])/[a-z_]+(?:/[\w-]+)*", words, text)


def read_ply(data):
    """Vertices (f64) and triangles of the server's binary PLY."""
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = [line.split() for line in data[:end].decode().splitlines()]
    types = {"double": "<f8", "float": "<f4", "uchar": "u1"}
    # Lists belong to the faces, and what follows them to the edges of a net.
    own = header[: next(index for index, line in enumerate(header) if line[:2] == ["element", "face"])]
    columns = np.dtype([(line[2], types[line[1]]) for line in own if line[0] == "property"])
    counts = {line[1]: int(line[2]) for line in header if line[0] == "element"}
    table = np.frombuffer(data, columns, counts["vertex"], end)
    face = np.dtype([("size", "u1"), ("corners", "<u4", 3)])
    faces = np.frombuffer(data, face, counts["face"], end + table.nbytes)
    return np.stack([table[axis] for axis in "xyz"], axis=1), faces["corners"].astype(np.int32)


def scene_units(scene):
    """The service's unit and the factor from Blender units to it."""
    metres = 1.0 if scene.unit_settings.system == "NONE" else scene.unit_settings.scale_length
    for known, unit in UNITS.items():
        if abs(metres - known) < 1e-6 * known:
            return unit, 1.0
    return "m", metres


def lines_of(thing, depsgraph):
    """The points of a curve or of a mesh without faces, as world coordinates in f64, and the edges between them.

    Blender keeps f32. The object's own coordinates and its matrix are multiplied in f64, so that curves far from zero
    keep what their own coordinates have, if their objects' origins lie near them.
    """
    evaluated = thing.evaluated_get(depsgraph)
    mesh = evaluated.to_mesh()
    try:
        if len(mesh.polygons):
            raise PlateauError(f"{thing.name} has faces: pick curves without bevel or extrusion")
        local = np.empty(3 * len(mesh.vertices), np.float32)
        mesh.vertices.foreach_get("co", local)
        edges = np.empty(2 * len(mesh.edges), np.int32)
        mesh.edges.foreach_get("vertices", edges)
    finally:
        evaluated.to_mesh_clear()
    matrix = np.array(thing.matrix_world, dtype=np.float64)
    world = local.reshape(-1, 3).astype(np.float64) @ matrix[:3, :3].T + matrix[:3, 3]
    return world, edges.reshape(-1, 2).tolist()


def polylines(thing, depsgraph):
    """The polylines of an object, and whether each is closed."""
    world, edges = lines_of(thing, depsgraph)
    return [(world[chain], closed) for chain, closed in chains(thing.name, len(world), edges)]


def chains(name, count, edges):
    """Vertices in the order along each line, and whether the line is closed."""
    neighbours = [[] for _ in range(count)]
    for a, b in edges:
        neighbours[a].append(b)
        neighbours[b].append(a)
    if any(len(found) > 2 for found in neighbours):
        raise PlateauError(f"{name} branches: every line has to be a single curve, except in a cable net")
    seen, found = [False] * count, []
    ends = [vertex for vertex in range(count) if len(neighbours[vertex]) == 1]
    for start in ends + [vertex for vertex in range(count) if len(neighbours[vertex]) == 2]:
        if seen[start]:
            continue
        chain, vertex = [], start
        while vertex is not None:
            seen[vertex] = True
            chain.append(vertex)
            vertex = next((other for other in neighbours[vertex] if not seen[other]), None)
        found.append((chain, len(neighbours[start]) == 2))
    return found


def kind_of(surface, closed):
    """The service's kind for the operator's choice."""
    if surface == "AUTO":
        surface = "MINIMAL" if all(closed) else "RULED"
    kinds = {"MINIMAL": "minimal_surface", "RULED": "ruled_surface", "LATTICE": "uniform_mesh", "NET": "cable_net"}
    return kinds.get(surface, "tensile_structure")


def make_request(picked, options, unit, factor):
    """The request for closed or open lines, by the operator's properties. Lengths and forces are in the scene's unit."""
    closed = [is_closed for _, is_closed in picked]
    points = [(factor * line).tolist() for line, _ in picked]
    kind = kind_of(options["surface"], closed)
    request = {"kind": kind, "units": unit, "up": "z"}
    if kind == "ruled_surface":
        if len(points) < 2 or len(set(closed)) != 1:
            raise PlateauError("a ruled surface needs two curves or more, all open or all closed")
        return {**request, "directrices": points, "closed": closed[0], "direction": "auto",
                "objective": options["objective"]}
    if not all(closed):
        names = {"minimal_surface": "minimal surface", "uniform_mesh": "lattice", "tensile_structure": "membrane"}
        raise PlateauError(f"a {names[kind]} needs closed curves")
    if kind == "minimal_surface":
        return {**request, "boundaries": points, "objective": options["film_objective"],
                "resolution": {"triangles": options["triangles"]}}
    if kind == "uniform_mesh":
        every = np.concatenate([line for line, _ in picked])
        length = options["edge_length"] or float(f"{np.linalg.norm(np.ptp(every, axis=0)) / 20:.1g}")
        flat = all(is_flat(line) for line, _ in picked)
        domain = {"polygon": points[0], "holes": points[1:]} if flat else {"boundaries": points}
        return {**request, "domain": domain, "edge_length": factor * length, "objective": options["lattice_objective"]}
    cables = [cable for k, (line, _) in enumerate(picked) for cable in edge_cables(k, line, options["edge_force"])]
    return {**request, "units": {"length": unit, "force": "kN"}, "boundaries": points, "cables": cables,
            "film": {"tension": options["tension"] / factor}, "resolution": {"triangles": options["triangles"]}}


def is_flat(line):
    """Whether a closed polyline lies in a plane, within a thousandth of its size."""
    near = line - line[0]
    normal = 0.5 * np.cross(near, np.roll(near, -1, axis=0)).sum(axis=0)
    length, size = np.linalg.norm(normal), np.linalg.norm(np.ptp(line, axis=0))
    return length > 0 and np.abs(near @ normal).max() <= 1e-3 * size * length


def edge_cables(boundary, line, force):
    """A cable along a boundary between each two of its corners."""
    if force <= 0:
        return []
    before, after = line - np.roll(line, 1, axis=0), np.roll(line, -1, axis=0) - line
    cosine = (before * after).sum(axis=1) / (np.linalg.norm(before, axis=1) * np.linalg.norm(after, axis=1))
    corners = np.flatnonzero(cosine < CORNER).tolist()
    if len(corners) < 2:
        return []
    return [{"along": {"boundary": boundary, "from": start, "to": end}, "mode": "force", "value": force}
            for start, end in zip(corners, corners[1:] + corners[:1])]


def make_net(parts, options, unit, factor):
    """A cable net of lines that meet in common points. Vertices with one edge are its supports."""
    every = np.concatenate([points for points, _ in parts])
    near = NEAR * np.linalg.norm(np.ptp(every, axis=0)) or 1.0
    origin, vertices, index_of, edges = every[0], [], {}, {}
    steps = [(i, j, k) for i in (0, -1, 1) for j in (0, -1, 1) for k in (0, -1, 1)]

    def vertex(point):
        cell = np.round((point - origin) / near).astype(np.int64).tolist()
        around = [tuple(value + step for value, step in zip(cell, one)) for one in steps]
        found = next((index_of[one] for one in around if one in index_of), None)
        if found is None:
            found = index_of[tuple(cell)] = len(vertices)
            vertices.append((factor * point).tolist())
        return found

    for points, own in parts:
        numbers = [vertex(point) for point in points]
        for a, b in own:
            a, b = numbers[a], numbers[b]
            if a != b:
                edges.setdefault((min(a, b), max(a, b)), [a, b])
    count = np.bincount(np.array(list(edges.values())).ravel(), minlength=len(vertices))
    supports = np.flatnonzero(count == 1).tolist()
    if not supports:
        raise PlateauError("a cable net needs open ends: they are its supports")
    return {"kind": "cable_net", "vertices": vertices, "edges": list(edges.values()), "supports": supports,
            "cables": [{"force_density": options["force_density"] / factor}],
            "units": {"length": unit, "force": "kN"}, "up": "z"}


def curves_of(made):
    """The objects that a result was made from, without those that are gone."""
    names = sorted((name for name in made.keys() if name.startswith("plateau_curve_")), key=lambda name: int(name[14:]))
    return [made[name] for name in names if made[name] is not None and made[name].name in bpy.context.scene.objects]


def put_mesh(context, old, origin, factor, job, ply, edges, curves, settings):
    """The result as a mesh object whose origin is that of the first curve: the vertices, in f32, are small beside it.

    An old result keeps its object with its materials and modifiers, and gets the new mesh.
    """
    vertices, triangles = read_ply(ply)
    mesh = bpy.data.meshes.new("Plateau")
    local = vertices / factor - np.array(origin, dtype=np.float64)
    mesh.from_pydata(local.tolist(), edges, triangles.tolist())
    mesh.update()
    if old is None:
        made = bpy.data.objects.new("Plateau", mesh)
        context.collection.objects.link(made)
    else:
        made, mesh_before = old, old.data
        for material in mesh_before.materials:
            mesh.materials.append(material)
        made.data = mesh
        if mesh_before.users == 0:
            bpy.data.meshes.remove(mesh_before)
    made.location = origin
    made["plateau_job"] = job["id"]
    made["plateau_statistics"] = json.dumps(job["statistics"])
    made["plateau_settings"] = json.dumps(settings)
    for index, curve in enumerate(curves):
        made[f"plateau_curve_{index}"] = curve
    return made


class PlateauPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__

    url: bpy.props.StringProperty(name="Server", default="http://127.0.0.1:8080")
    api_key: bpy.props.StringProperty(name="API key", subtype="PASSWORD")

    def draw(self, context):
        self.layout.prop(self, "url")
        self.layout.prop(self, "api_key")


class OBJECT_OT_plateau(bpy.types.Operator):
    """Makes a surface from the selected curves, or makes the selected result again"""

    bl_idname = "object.plateau"
    bl_label = "Surface Between Curves"
    bl_options = {"REGISTER", "UNDO"}

    surface: bpy.props.EnumProperty(name="Surface", default="AUTO", items=[
        ("AUTO", "By the curves", "Closed curves: minimal surface. Open curves: ruled surface"),
        ("MINIMAL", "Minimal surface", "The film that spans closed curves"),
        ("RULED", "Ruled surface", "The best strip between each pair of curves"),
        ("LATTICE", "Lattice", "Members of nearly one length on a closed outline with holes"),
        ("MEMBRANE", "Membrane", "A film of given tension over closed curves, with cables along its edges"),
        ("NET", "Cable net", "Lines that meet; open ends are supports"),
    ])
    film_objective: bpy.props.EnumProperty(name="Minimal surface", default="minimal_area", items=[
        ("minimal_area", "Least area", ""), ("minimal_dirichlet_energy", "Least Dirichlet energy", ""),
        ("minimal_mean_curvature", "Least mean curvature", ""),
    ])
    lattice_objective: bpy.props.EnumProperty(name="Lattice", default="most_equal_edges", items=[
        ("most_equal_edges", "Most equal members", ""), ("fewest_nodes", "Fewest nodes", ""),
    ])
    edge_length: bpy.props.FloatProperty(name="Length of the members", default=0, min=0, description="0: by the size")
    tension: bpy.props.FloatProperty(name="Tension of the film", default=1, min=0, description="kN per unit of length")
    edge_force: bpy.props.FloatProperty(name="Force of edge cables", default=0, min=0, description="kN; 0: fixed edges")
    force_density: bpy.props.FloatProperty(name="Force per length", default=1, description="kN per unit of length")
    objective: bpy.props.EnumProperty(name="Ruled surface", default="minimal_area", items=[
        ("minimal_area", "Least area", ""), ("minimal_twist", "Least twist (developable)", ""),
        ("maximal_convexity", "Most convex", ""), ("minimal_bending_energy", "Least bending", ""),
    ])
    triangles: bpy.props.IntProperty(name="Triangles", default=2000, min=1, max=1_000_000)
    url: bpy.props.StringProperty(name="Server", description="Empty: as in the preferences", options={"SKIP_SAVE"})

    @classmethod
    def poll(cls, context):
        return bool(context.selected_objects)

    def execute(self, context):
        self.names = []
        try:
            self.prepare(context)
            return self.finish(context, self.server.solve(self.request))
        except PlateauError as error:
            self.report({"ERROR"}, in_words(str(error), self.names))
            return {"CANCELLED"}

    def invoke(self, context, event):
        try:
            self.prepare(context)
        except PlateauError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.cancelled, self.fraction, self.outcome, self.fault = threading.Event(), 0.0, None, None
        self.thread = threading.Thread(target=self.work, daemon=True)
        self.thread.start()
        self.timer = context.window_manager.event_timer_add(0.1, window=context.window)
        context.window_manager.modal_handler_add(self)
        context.window_manager.progress_begin(0, 100)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            self.cancelled.set()
        if event.type != "TIMER" or self.thread.is_alive():
            context.window_manager.progress_update(100 * self.fraction)
            return {"RUNNING_MODAL"} if event.type in {"TIMER", "ESC"} else {"PASS_THROUGH"}
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()
        if self.fault is not None:
            self.report({"ERROR"}, in_words(self.fault, self.names))
            return {"CANCELLED"}
        return self.finish(context, self.outcome)

    def work(self):
        """Runs beside Blender's own thread and touches none of its data."""
        try:
            self.outcome = self.server.solve(self.request, self.tell, self.cancelled.is_set)
        except PlateauError as error:
            self.fault = str(error)

    def tell(self, fraction):
        self.fraction = fraction

    def prepare(self, context):
        addon = context.preferences.addons.get(__name__)
        url = self.url or (addon.preferences.url if addon else "http://127.0.0.1:8080")
        self.server = Server(url, addon.preferences.api_key if addon else "")
        depsgraph = context.evaluated_depsgraph_get()
        self.curves, self.old = self.pick(context)
        if not self.curves:
            raise PlateauError("select curves first")
        remembered = json.loads(self.old["plateau_settings"]) if self.old else {}
        own = {name: getattr(self, name) for name in SETTINGS}
        self.settings = {name: remembered.get(name, value) if not self.properties.is_property_set(name) else value
                         for name, value in own.items()}
        unit, self.factor = scene_units(context.scene)
        self.origin = tuple(self.curves[0].matrix_world.translation)
        if self.settings["surface"] == "NET":
            self.names = [thing.name for thing in self.curves]
            self.request = make_net([lines_of(thing, depsgraph) for thing in self.curves], self.settings, unit, self.factor)
            return
        picked = [(thing.name, line) for thing in self.curves for line in polylines(thing, depsgraph)]
        self.names = [name for name, _ in picked]
        if not picked:
            raise PlateauError("select curves first")
        self.request = make_request([line for _, line in picked], self.settings, unit, self.factor)

    def pick(self, context):
        """The curves to work on and the result that is replaced, if there is one."""
        selected = [thing for thing in context.selected_objects if thing.type in {"CURVE", "MESH"}]
        results = [thing for thing in selected if "plateau_job" in thing]
        if results:
            curves = curves_of(results[0])
            count = sum(name.startswith("plateau_curve_") for name in results[0].keys())
            if len(curves) < count:
                raise PlateauError(f"a curve of {results[0].name} is gone")
            return curves, results[0]
        made = [thing for thing in context.scene.objects if "plateau_job" in thing and set(curves_of(thing)) == set(selected)]
        return selected, made[0] if made and selected else None

    def finish(self, context, outcome):
        if outcome is None:
            self.report({"INFO"}, "Cancelled")
            return {"CANCELLED"}
        job, ply = outcome
        edges = self.request.get("edges", [])
        made = put_mesh(context, self.old, self.origin, self.factor, job, ply, edges, self.curves, self.settings)
        for thing in context.selected_objects:
            thing.select_set(False)
        made.select_set(True)
        context.view_layer.objects.active = made
        # `far_from_zero` is about STL files.
        for warning in (one for one in job["warnings"] if one["code"] != "far_from_zero"):
            self.report({"WARNING"}, in_words(warning["detail"], self.names))
        return {"FINISHED"}


class VIEW3D_MT_plateau(bpy.types.Menu):
    bl_label = "Plateau"

    def draw(self, context):
        self.layout.operator(OBJECT_OT_plateau.bl_idname)


def draw_menu(self, context):
    self.layout.menu(VIEW3D_MT_plateau.__name__)


CLASSES = (PlateauPreferences, OBJECT_OT_plateau, VIEW3D_MT_plateau)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.VIEW3D_MT_object.append(draw_menu)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(draw_menu)
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
