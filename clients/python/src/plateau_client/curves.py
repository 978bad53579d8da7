"""Points from lists, numpy arrays, and curves of shapely, compas and rhino3dm. None of these libraries is imported."""

from __future__ import annotations

import json
import math
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np

from .errors import FieldError, InvalidRequest

CurveLike = Any
"""Points `[[x, y, z], …]` (lists or an array; without z: z = 0), or a curve of shapely, compas or rhino3dm."""

Points = List[List[float]]

# The words of the server for the same slips.
POINTS = "it must be a list of points [x, y, z], such as [[0, 0, 0], [4, 0, 1], [4, 3, 0]]"
CURVES = (
    "it must be a list of polylines, which are lists of points [x, y, z], such as [[[0, 0, 0], [4, 0, 1], [4, 3, 0]]]"
)
TOO_MANY = "has a level of brackets too many"
TOO_FEW = "lacks a level of brackets"

SAMPLES = 64
"""Number of points on a smooth curve of compas or rhino3dm unless `points` is told another."""


def points(curve: CurveLike, samples: int = SAMPLES) -> Points:
    """The points of a curve. Polylines keep their own points; a smooth curve gets `samples` at equal parameter steps.

    The last point of a closed curve of shapely, compas or rhino3dm is left out where it repeats the first.
    """
    library = type(curve).__module__.split(".")[0]
    if library == "shapely":
        return _without_repeat(_of_shapely(curve))
    if library in ("compas", "compas_occ", "compas_rhino"):
        return _without_repeat(_of_compas(curve, samples))
    if library == "rhino3dm":
        return _without_repeat(_of_rhino(curve, samples))
    return _of_array(curve)


def _of_array(values: Any) -> Points:
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InvalidRequest(
            "Not a curve", f"expected points as [[x, y, z], …], got {type(values).__name__}"
        ) from error
    if array.ndim == 1 and array.shape[0] in (2, 3):
        array = array[np.newaxis]
    if array.ndim == 3 and array.shape[2] in (2, 3):
        raise InvalidRequest("Not a curve", f"{TOO_MANY}: {POINTS}")
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        got = f"an array of shape {array.shape}" if array.ndim > 0 else type(values).__name__
        raise InvalidRequest("Not a curve", f"expected points as [[x, y, z], …], got {got}")
    if array.shape[1] == 2:
        array = np.column_stack([array, np.zeros(len(array))])
    result: Points = array.tolist()
    return result


def _without_repeat(found: Points) -> Points:
    return found[:-1] if len(found) > 2 and found[0] == found[-1] else found


def _of_shapely(geometry: Any) -> Points:
    if geometry.geom_type == "Polygon":
        if len(geometry.interiors) > 0:
            detail = "a polygon with holes is several curves: pass its exterior and its interiors"
            raise InvalidRequest("Not a curve", detail)
        geometry = geometry.exterior
    if geometry.geom_type not in ("LineString", "LinearRing", "Point"):
        raise InvalidRequest("Not a curve", f"a {geometry.geom_type} is not one curve")
    return _of_array(list(geometry.coords))


def _of_compas(curve: Any, samples: int) -> Points:
    kind = type(curve).__name__
    if kind in ("Point", "Vector"):
        return _of_array([list(curve)])
    if kind in ("Polyline", "Polygon"):
        return _of_array([list(point) for point in curve.points])
    if kind == "Line":
        return _of_array([list(curve.start), list(curve.end)])
    if not hasattr(curve, "point_at"):
        raise InvalidRequest("Not a curve", f"a {kind} of compas is not a curve")
    start, end = getattr(curve, "domain", None) or (0.0, 1.0)
    try:
        closed = bool(getattr(curve, "is_closed", False))
    except NotImplementedError:  # Bézier curves of compas do not say it.
        closed = bool(np.allclose(list(curve.point_at(start)), list(curve.point_at(end)), rtol=1e-12, atol=0.0))
    return _of_array([list(curve.point_at(t)) for t in _steps(start, end, samples, closed)])


def _of_rhino(curve: Any, samples: int) -> Points:
    kind = type(curve).__name__
    if hasattr(curve, "X") and hasattr(curve, "Z"):
        return [[curve.X, curve.Y, curve.Z]]
    if hasattr(curve, "Count") and hasattr(curve, "Add"):
        return [_xyz(curve[index]) for index in range(curve.Count)]
    if kind == "Line":
        return [_xyz(curve.From), _xyz(curve.To)]
    if not hasattr(curve, "Domain") and hasattr(curve, "ToNurbsCurve"):
        curve = curve.ToNurbsCurve()
    if not hasattr(curve, "PointAt") or not hasattr(curve, "Domain"):
        raise InvalidRequest("Not a curve", f"a {kind} of rhino3dm is not a curve")
    if hasattr(curve, "SegmentCount"):
        joined: Points = []
        for index in range(curve.SegmentCount):
            part = _of_rhino(curve.SegmentCurve(index), samples)
            joined += part[1:] if joined and joined[-1] == part[0] else part
        return joined
    if curve.IsLinear():
        return [_xyz(curve.PointAtStart), _xyz(curve.PointAtEnd)]
    polyline = curve.TryGetPolyline() if curve.IsPolyline() else None
    if polyline is not None:
        return [_xyz(polyline[index]) for index in range(polyline.Count)]
    steps = _steps(curve.Domain.T0, curve.Domain.T1, samples, bool(curve.IsClosed))
    return [_xyz(curve.PointAt(t)) for t in steps]


def _xyz(point: Any) -> List[float]:
    return [float(point.X), float(point.Y), float(point.Z)]


def _steps(start: float, end: float, samples: int, closed: bool) -> List[float]:
    return [float(t) for t in np.linspace(start, end, samples, endpoint=not closed)]


def curve_at(pointer: str, given: Any) -> Points:
    """The points of a curve of a request; the error leads to the curve."""
    try:
        return points(given)
    except InvalidRequest as error:
        raise InvalidRequest(error.title, error.detail, errors=[FieldError(pointer, error.detail)]) from None


def curves(field: str, given: Any) -> List[Points]:
    """A list of curves for a field of a request; the pointers of errors lead to the curve."""
    if getattr(given, "geom_type", None) in ("Polygon", "MultiPolygon", "MultiLineString"):
        parts = "[polygon.exterior, *polygon.interiors]" if given.geom_type == "Polygon" else "list(shape.geoms)"
        raise _slip(f"/{field}", f"must be a list of curves, not a {given.geom_type} of shapely: pass {parts}")
    if not isinstance(given, (list, tuple, np.ndarray)):
        library = type(given).__module__.split(".")[0]
        if library in ("shapely", "compas", "compas_occ", "compas_rhino", "rhino3dm"):
            raise _slip(f"/{field}", f"{TOO_FEW}: it must be a list of curves, not one {_name(given)}")
        raise _slip(f"/{field}", f"must be a list of curves, not {_name(given)}")
    if len(given) > 0 and all(_is_point(one) for one in given):
        raise _slip(f"/{field}", f"{TOO_FEW}: {CURVES}")
    if len(given) > 0 and all(_levels(one) > 2 for one in given):
        raise _slip(f"/{field}", f"{TOO_MANY}: {CURVES}")
    return [curve_at(f"/{field}/{index}", curve) for index, curve in enumerate(given)]


def _is_point(value: Any) -> bool:
    """Whether a value is x y z, and not a list of points."""
    if isinstance(value, np.ndarray):
        return value.ndim == 1 and value.shape[0] in (2, 3)
    numbers = (int, float, np.number)
    return isinstance(value, (list, tuple)) and len(value) in (2, 3) and all(isinstance(one, numbers) for one in value)


def _levels(value: Any) -> int:
    """Number of levels of brackets around the first number of a value, or around its first curve of a library."""
    if isinstance(value, np.ndarray):
        return value.ndim
    if not isinstance(value, (list, tuple)):
        return 0
    return 1 + (_levels(value[0]) if len(value) > 0 else 0)


def _slip(pointer: str, detail: str) -> InvalidRequest:
    return InvalidRequest("The request is invalid", "", errors=[FieldError(pointer, detail)])


def _name(value: Any) -> str:
    return type(value).__name__


def check_units(request: Any, pointer: str = "") -> None:
    """Membranes and nets have a unit of force too, so that the unit of length alone is not enough."""
    units = request.get("units")
    if request.get("kind") in ("tensile_structure", "cable_net") and isinstance(units, str):
        raise _slip(f"{pointer}/units", f'must be an object, such as {{"force":"kN","length":"{units}"}}')


def domain(given: Any) -> Dict[str, Any]:
    """The domain of a uniform mesh from the API's own mapping, a shapely polygon with holes, or one closed curve."""
    if isinstance(given, dict):
        made = dict(given)
        if made.get("polygon") is not None:
            made["polygon"] = curve_at("/domain/polygon", made["polygon"])
        for field in ("holes", "boundaries"):
            if made.get(field):
                made[field] = curves(f"domain/{field}", made[field])
        return made
    if getattr(given, "geom_type", None) == "Polygon":
        return {"polygon": points(given.exterior), "holes": [points(ring) for ring in given.interiors]}
    return {"polygon": curve_at("/domain/polygon", given)}


def to_json(request: Any) -> bytes:
    """The body of a request. Arrays and curves may stand anywhere in it; a number that is not finite is an error."""
    try:
        return json.dumps(request, default=_plain, allow_nan=False, separators=(",", ":")).encode()
    except ValueError:
        found = _not_finite(json.loads(json.dumps(request, default=_plain)), "")
        if found is None:
            raise
        pointer, value = found
        detail = f"{value} is not a finite number"
        raise InvalidRequest("A number is not finite", detail, errors=[FieldError(pointer, detail)]) from None


def _plain(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    return points(value)


def _not_finite(value: Any, pointer: str) -> Optional[Tuple[str, float]]:
    if isinstance(value, float) and not math.isfinite(value):
        return pointer, value
    parts: List[Tuple[Union[str, int], Any]] = []
    if isinstance(value, dict):
        parts = list(value.items())
    elif isinstance(value, list):
        parts = list(enumerate(value))
    for key, part in parts:
        escaped = str(key).replace("~", "~0").replace("/", "~1")
        found = _not_finite(part, f"{pointer}/{escaped}")
        if found is not None:
            return found
    return None
