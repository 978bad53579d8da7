"""A stand-in for Rhino, since Rhino itself is not to be had where the tests run. It is not Rhino.

It gives `plateau_rhino.py` the few names of RhinoCommon, rhinoscriptsyntax and scriptcontext that the script uses, with
the signatures of McNeel's documentation, and does their work by rhino3dm, McNeel's own openNURBS.
"""

import math
import sys
import types

import rhino3dm


class Curve:
    """RhinoCommon's Curve over one of rhino3dm."""

    def __init__(self, inner):
        self.inner = inner
        self.IsClosed, self.IsLinear, self.Domain = inner.IsClosed, inner.IsLinear, inner.Domain
        self.PointAt, self.PointAtStart, self.PointAtEnd = inner.PointAt, inner.PointAtStart, inner.PointAtEnd

    def TryGetPolyline(self):
        """Python.NET gives `out` parameters as a tuple."""
        polyline = self.inner.TryGetPolyline() if self.inner.IsPolyline() else None
        return (False, None) if polyline is None else (True, [polyline[index] for index in range(polyline.Count)])

    def GetLength(self):
        start, end = self.inner.Domain.T0, self.inner.Domain.T1
        points = [self.PointAt(start + (end - start) * i / 1000) for i in range(1001)]
        return sum(a.DistanceTo(b) for a, b in zip(points, points[1:]))

    def Trim(self, start, end):
        return Curve(self.inner.Trim(start, end))

    def GetNextDiscontinuity(self, continuity, start, end):
        """Python.NET gives `out` parameters as a tuple. The end of an open curve is a discontinuity too."""
        assert continuity == "G1"
        for at in sorted(set(joints(self.inner))):
            if start < at < end:
                step = 1e-9 * (end - start)
                before, after = self.inner.TangentAt(at - step), self.inner.TangentAt(at + step)
                if before.X * after.X + before.Y * after.Y + before.Z * after.Z < math.cos(math.radians(1)):
                    return True, at
        return (False, 0.0) if self.IsClosed else (True, end)

    def DivideByCount(self, count, include_ends):
        """Equal parameter steps instead of equal lengths; as in Rhino, a closed curve has no second end."""
        assert include_ends
        start, end = self.inner.Domain.T0, self.inner.Domain.T1
        return [start + (end - start) * i / count for i in range(count if self.IsClosed else count + 1)]


def joints(curve):
    """Parameters at which a curve of rhino3dm may have a kink."""
    if isinstance(curve, rhino3dm.PolyCurve):
        for index in range(curve.SegmentCount):
            own, segment = curve.SegmentDomain(index), curve.SegmentCurve(index)
            yield own.T0
            scale = (own.T1 - own.T0) / (segment.Domain.T1 - segment.Domain.T0)
            yield from (own.T0 + scale * (at - segment.Domain.T0) for at in joints(segment))
    elif isinstance(curve, rhino3dm.NurbsCurve):
        knots = [curve.Knots[index] for index in range(len(curve.Knots))]
        yield from (knot for knot in knots if knots.count(knot) >= curve.Degree)
    elif isinstance(curve, rhino3dm.PolylineCurve):
        yield from range(1, curve.PointCount)


class Vertices:
    """RhinoCommon's vertex list, which keeps f64 only if it is told to."""

    def __init__(self, inner):
        self.inner = inner
        self.UseDoublePrecisionVertices = False

    def Add(self, x, y, z):
        return (self.inner.AddPoint3d if self.UseDoublePrecisionVertices else self.inner.Add)(x, y, z)


class Mesh:
    """RhinoCommon's Mesh over rhino3dm's."""

    def __init__(self):
        self.inner = rhino3dm.Mesh()
        self.Vertices = Vertices(self.inner.Vertices)
        self.Faces, self.Normals, self.Compact = self.inner.Faces, self.inner.Normals, self.inner.Compact


class Document:
    """The active document: objects by id with their names and user text, what was said, and undo records."""

    def __init__(self):
        self.ModelUnitSystem = "Rhino.UnitSystem.Meters"
        self.objects, self.names, self.texts = {}, {}, {}
        self.picked, self.said, self.answers, self.prompts, self.escape = [], [], {}, [], False
        self.records, self.before, self.count = [], None, 0
        self.Objects = types.SimpleNamespace(AddMesh=lambda mesh: self.add(mesh.inner))
        self.Views = types.SimpleNamespace(Redraw=lambda: None)

    @property
    def meshes(self):
        return [one for one in self.objects.values() if isinstance(one, rhino3dm.Mesh)]

    def add(self, thing, name=None):
        self.count += 1
        one = f"id {self.count}"
        self.objects[one] = thing
        if name:
            self.names[one] = name
        return one

    def delete(self, ids):
        for one in ids:
            del self.objects[one]

    def BeginUndoRecord(self, description):
        self.before = dict(self.objects), dict(self.texts)
        return 1

    def EndUndoRecord(self, serial):
        self.records.append(self.before)
        self.before = None

    def undo(self):
        self.objects, self.texts = self.records.pop()

    def set_text(self, one, key, value):
        assert self.before is not None, "an undo record is open"
        self.texts[one, key] = value

    def answer(self, prompt, default):
        """What the user types; Enter takes the default."""
        self.prompts.append((prompt, default))
        return next((value for words, value in self.answers.items() if words in prompt), default)


def coercecurve(document, one):
    thing = document.objects.get(one)
    return Curve(thing) if isinstance(thing, rhino3dm.Curve) else None


def add_line(document, a, b):
    return document.add(rhino3dm.LineCurve(rhino3dm.Point3d(*a), rhino3dm.Point3d(*b)))


def install():
    """Puts the stand-in's modules in the place of Rhino's and returns the document."""
    document = Document()
    app = types.SimpleNamespace(WriteLine=document.said.append, SetCommandPrompt=lambda text: None)
    continuity = types.SimpleNamespace(G1_continuous="G1")
    names = {
        "Rhino": {"RhinoApp": app, "Geometry": types.SimpleNamespace(Mesh=Mesh, Continuity=continuity)},
        "rhinoscriptsyntax": {
            "GetObjects": lambda prompt, filter, preselect: list(document.picked),
            "GetString": lambda prompt, default, strings: document.answer(prompt, default),
            "GetReal": lambda prompt, default, minimum: document.answer(prompt, default),
            "GetUserText": lambda one, key: document.texts.get((one, key)),
            "SetUserText": document.set_text,
            "ObjectName": document.names.get,
            "ObjectsByType": lambda filter: list(document.objects),
            "DeleteObjects": document.delete,
            "AddLine": lambda a, b: add_line(document, a, b),
            "AddGroup": lambda: "group",
            "AddObjectsToGroup": lambda ids, group: len(ids),
            "coercecurve": lambda one: coercecurve(document, one),
        },
        "scriptcontext": {"doc": document, "escape_test": lambda throw: document.escape},
    }
    for name, contents in names.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(contents)
    return document
