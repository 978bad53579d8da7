"""Plateau for Blender: minimal surfaces and ruled strips between picked curves.

A single file: Edit > Preferences > Add-ons > Install from Disk. Set the server's address in the add-on's preferences.
Select one or more curves and run Object > Plateau > Surface Between Curves. The mesh has the scene's unit and lies
where the curves lie. Esc cancels.
"""

import json
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
    "description": "Minimal surfaces and ruled strips between curves, solved by a Plateau server",
    "category": "Object",
}

ENDED = ("succeeded", "failed", "cancelled")
REQUEST_TIMEOUT_S = 60
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
        paths = {"ruled_surface": "/v1/ruled-surfaces", "minimal_surface": "/v1/minimal-surfaces"}
        job = json.loads(self.send("POST", paths[request["kind"]], request))
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


def read_ply(data):
    """Vertices (f64) and triangles of the server's binary PLY."""
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = [line.split() for line in data[:end].decode().splitlines()]
    types = {"double": "<f8", "float": "<f4", "uchar": "u1"}
    columns = np.dtype([(line[2], types[line[1]]) for line in header if line[0] == "property" and line[1] != "list"])
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


def polylines(thing, depsgraph):
    """The polylines of a curve or of a mesh without faces: world coordinates in f64, and whether each is closed.

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
    return [(world[chain], closed) for chain, closed in chains(len(world), edges.reshape(-1, 2).tolist())]


def chains(count, edges):
    """Vertices in the order along each line, and whether the line is closed."""
    neighbours = [[] for _ in range(count)]
    for a, b in edges:
        neighbours[a].append(b)
        neighbours[b].append(a)
    if any(len(found) > 2 for found in neighbours):
        raise PlateauError("a picked line branches: every line has to be a single curve")
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


def make_request(picked, options, unit, factor):
    """Closed curves bound a minimal surface; open ones, and closed ones on request, are directrices."""
    closed = [is_closed for _, is_closed in picked]
    points = [(factor * line).tolist() for line, _ in picked]
    if options["surface"] == "RULED" or (options["surface"] == "AUTO" and not all(closed)):
        if len(points) < 2 or len(set(closed)) != 1:
            raise PlateauError("a ruled surface needs two curves or more, all open or all closed")
        return {"kind": "ruled_surface", "directrices": points, "closed": closed[0], "direction": "auto",
                "objective": options["objective"], "units": unit, "up": "z"}
    if not all(closed):
        raise PlateauError("a minimal surface needs closed curves")
    return {"kind": "minimal_surface", "boundaries": points, "resolution": {"triangles": options["triangles"]},
            "units": unit, "up": "z"}


def add_mesh(context, origin, factor, job, ply):
    """A mesh object whose origin is that of the first picked curve: the vertices, in f32, are small beside it."""
    vertices, triangles = read_ply(ply)
    mesh = bpy.data.meshes.new("Plateau")
    mesh.from_pydata((vertices / factor - np.array(origin, dtype=np.float64)).tolist(), [], triangles.tolist())
    mesh.update()
    made = bpy.data.objects.new("Plateau", mesh)
    made.location = origin
    made["plateau_job"] = job["id"]
    made["plateau_statistics"] = json.dumps(job["statistics"])
    context.collection.objects.link(made)
    return made


class PlateauPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__

    url: bpy.props.StringProperty(name="Server", default="http://127.0.0.1:8080")
    api_key: bpy.props.StringProperty(name="API key", subtype="PASSWORD")

    def draw(self, context):
        self.layout.prop(self, "url")
        self.layout.prop(self, "api_key")


class OBJECT_OT_plateau(bpy.types.Operator):
    """Spans the selected curves: closed ones by a minimal surface, open ones by a ruled strip"""

    bl_idname = "object.plateau"
    bl_label = "Surface Between Curves"
    bl_options = {"REGISTER", "UNDO"}

    surface: bpy.props.EnumProperty(name="Surface", default="AUTO", items=[
        ("AUTO", "By the curves", "Closed curves: minimal surface. Open curves: ruled surface"),
        ("MINIMAL", "Minimal surface", "The film that spans closed curves"),
        ("RULED", "Ruled surface", "The best strip between each pair of curves"),
    ])
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
        try:
            self.prepare(context)
            return self.finish(context, self.server.solve(self.request))
        except PlateauError as error:
            self.report({"ERROR"}, str(error))
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
            self.report({"ERROR"}, self.fault)
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
        curves = [thing for thing in context.selected_objects if thing.type in {"CURVE", "MESH"}]
        picked = [line for thing in curves for line in polylines(thing, depsgraph)]
        if not picked:
            raise PlateauError("select curves first")
        unit, self.factor = scene_units(context.scene)
        self.origin = tuple(curves[0].matrix_world.translation)
        options = {"surface": self.surface, "objective": self.objective, "triangles": self.triangles}
        self.request = make_request(picked, options, unit, self.factor)

    def finish(self, context, outcome):
        if outcome is None:
            self.report({"INFO"}, "Cancelled")
            return {"CANCELLED"}
        job, ply = outcome
        made = add_mesh(context, self.origin, self.factor, job, ply)
        for thing in context.selected_objects:
            thing.select_set(False)
        made.select_set(True)
        context.view_layer.objects.active = made
        # `far_from_zero` is about STL files.
        for warning in (one for one in job["warnings"] if one["code"] != "far_from_zero"):
            self.report({"WARNING"}, warning["detail"])
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
