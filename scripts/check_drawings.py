"""Reads drawings and schedules with programs that people already have, and compares what they read with the mesh.

Usage: PLATEAU_URL=http://… scripts/check_drawings.py

Flat patterns of every strip of the examples, of closed strips, and of rails that end where they begin: areas and
lengths from SVG (svgelements), DXF (ezdxf) and PDF (pypdf) are those of the mesh, and a pattern that is bent about its
lines by their angles is the strip. Cloth passes ezdxf's audit, and LibreCAD draws it. Pieces on sheets neither overlap
nor lie beyond them (shapely). The scale bar of a PDF is 100 mm long (pdfplumber), and the tiles of its pages join. Two
jobs of one request give the same bytes.

Schedules of every lattice and net of the examples, and of domes: lengths, cut lengths, kinds, directions at the nodes,
and the drawing in space (ezdxf).

The readers: .tools/drawings/bin/pip install -r scripts/drawings.txt, and Debian's librecad.
"""

import csv
import io
import itertools
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import zipfile
from collections import Counter

import ezdxf
import numpy as np
import pdfplumber
import pypdf
import svgelements
from pypdf.generic import ContentStream
from shapely.geometry import LineString, Polygon, box

from service import examples, request, solve
from skips import skip

MILLIMETRES = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ft": 304.8}
# Points of a PDF in a millimetre.
POINTS = 72 / 25.4
# Tolerance of areas in mm² and of lengths in mm.
READ = 1e-6
# Tolerance of shapes that are bent again, as a fraction of their size, and of directions.
SHAPE = 1e-9

checked, faults = 0, []


def check(holds, what):
    global checked
    checked += 1
    if not holds:
        faults.append(what)


def near(found, expected, tolerance, what):
    apart = abs(found - expected)
    # A coordinate of 100 m has no digits beyond 1e-11 mm, so that areas of thousands of square metres have fewer than
    # 1e-6 mm² of them.
    check(apart <= max(tolerance, 1e-15 * abs(expected)), f"{what}: {found!r} for {expected!r}")
    return apart


# ---- Patterns as the readers show them. A piece has an outline and lines with angles, in millimetres with y up.


def from_svg(data):
    svg = svgelements.SVG.parse(io.BytesIO(data), reify=False)
    width = float(svg.values["width"].removesuffix("mm"))
    check(svg.viewbox.width == width, "a user unit of the SVG is a millimetre")
    pieces = []
    for element in svg.elements():
        layer = element.values.get("class") if hasattr(element, "values") else None
        if isinstance(element, svgelements.Path) and layer == "cut":
            points = [(segment.end.x, -segment.end.y) for segment in element if segment.end is not None]
            check(isinstance(element[-1], svgelements.Close), "the cut of the SVG is closed")
            pieces.append((np.array(points[:-1]), []))
        if isinstance(element, svgelements.SimpleLine) and (layer or "").startswith("fold_"):
            ends = [(element.x1, -element.y1), (element.x2, -element.y2)]
            angle = float(element.values["data-angle-deg"])
            pieces[-1][1].append((np.array(ends, float), angle, layer))
    return pieces


def drawing_of(data):
    drawing = ezdxf.read(io.StringIO(data.decode("ascii")))
    audit = drawing.audit()
    check(not audit.errors and not audit.fixes, f"ezdxf finds {audit.errors[:2]} {audit.fixes[:2]}")
    return drawing


def plane(point):
    return point.x, point.y


def from_dxf(data):
    drawing = drawing_of(data)
    check(drawing.header["$INSUNITS"] == 4, "the unit of the DXF is a millimetre")
    pieces = []
    for entity in drawing.modelspace():
        if entity.dxftype() == "LWPOLYLINE" and entity.dxf.layer == "CUT":
            check(entity.closed, "the cut of the DXF is closed")
            pieces.append((np.array(entity.get_points("xy")), []))
        if entity.dxftype() == "LINE" and entity.dxf.layer.startswith("FOLD_"):
            ends = np.array([plane(entity.dxf.start), plane(entity.dxf.end)])
            angle = next(value for code, value in entity.get_xdata("PLATEAU") if code == 1040)
            pieces[-1][1].append((ends, angle, entity.dxf.layer.lower()))
    return pieces


# Colours of the strokes of folds in a PDF.
FOLDS = {(0.69, 0, 0.13): "fold_mountain", (0, 0.31, 0.69): "fold_valley", (0.5,): "fold_flat"}


def from_pdf(data):
    """The first page without its scale: one path for each piece, and lines by their colour."""
    reader = pypdf.PdfReader(io.BytesIO(data))
    pieces, path, colour, matrix = [], [], None, None
    for operands, operator in ContentStream(reader.pages[0].get_contents(), reader).operations:
        numbers = [float(operand) for operand in operands] if operator in (b"cm", b"G", b"RG", b"m", b"l") else []
        if operator == b"cm":
            matrix = numbers
        elif operator in (b"G", b"RG"):
            colour = tuple(numbers)
        elif operator == b"m":
            path = [numbers]
        elif operator == b"l":
            path.append(numbers)
        elif operator == b"s" and colour == (0,):
            pieces.append((np.array(path), []))
        elif operator == b"S" and colour in FOLDS:
            pieces[-1][1].append((np.array(path), None, FOLDS[colour]))
    check(matrix == [POINTS, 0, 0, POINTS, 0, 0], f"72 points of the PDF are 25.4 mm: {matrix}")
    return pieces


READERS = {"svg": from_svg, "dxf": from_dxf, "pdf": from_pdf}


def area(points):
    x, y = (points - points.mean(0)).T
    return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def perimeter(points):
    return float(np.linalg.norm(np.roll(points, -1, 0) - points, axis=1).sum())


# ---- bending


def bent(outline, lines):
    """The ends of the lines of a piece in space, bent by their angles: a mountain bends away from the reader."""

    # The corner of the outline beside the first and beside the last line that lies on neither.
    def beyond(ends, other):
        for k, corner in enumerate(outline):
            around = {tuple(outline[k - 1]), tuple(outline[(k + 1) % len(outline)])}
            if around == {tuple(ends[0]), tuple(ends[1])} and not any((corner == end).all() for end in other):
                return corner
        return None

    count = len(lines)
    corners = [beyond(lines[0][0], lines[1][0] if count > 1 else [])]
    for (ends, _, _), (following, _, _) in itertools.pairwise(lines):
        corners.append(next((point for point in following if not any((point == end).all() for end in ends)), None))
    corners.append(beyond(lines[-1][0], lines[-2][0] if count > 1 else [corners[0]]))
    turn, move, places = np.eye(3), np.zeros(3), []
    first = None if corners[0] is None else np.append(corners[0], 0.0)
    for (ends, angle, _), corner in zip(lines, corners[1:]):
        flat = np.c_[ends, [0.0, 0.0]]
        places.append(flat @ turn.T + move)
        if corner is None:
            break  # A triangle without area at the end of a strip.
        (p, q), along = ends, places[-1][1] - places[-1][0]
        left = (q - p)[0] * (corner - p)[1] - (q - p)[1] * (corner - p)[0] > 0
        own = rotation(along / np.linalg.norm(along), math.radians(-angle if left else angle))
        move = places[-1][0] + own @ (move - places[-1][0])
        turn = own @ turn
    last = None if corners[-1] is None else turn @ np.append(corners[-1], 0.0) + move
    return np.array(places), first, last


def rotation(axis, angle):
    x, y, z = axis
    across = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * across + (1 - math.cos(angle)) * across @ across


def apart(one, other):
    """The largest distance of two lists of points after the best motion, without a mirror."""
    a, b = one - one.mean(0), other - other.mean(0)
    u, _, v = np.linalg.svd(a.T @ b)
    flip = np.diag([1, 1, np.sign(np.linalg.det(u @ v))])
    return float(np.linalg.norm(a @ u @ flip @ v - b, axis=1).max())


# ---- patterns


def circle(count, radius, height, turn=0.5, centre=(0.0, 0.0)):
    angles = [2 * math.pi * (k + turn) / count for k in range(count)]
    return [[centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a), height] for a in angles]


def strips():
    """Name and request of every strip."""
    found = [(name, body) for name, kind, body in examples() if kind == "ruled_surface"]
    bending = {"kind": "ruled_surface", "objective": "minimal_bending_energy"}
    rectangle = [[0, 0, 0], [12, 0, 0], [12, 5, 0], [0, 5, 0]]
    top = circle(16, 3, 10, 0.5, (6, 2.5))
    closed = {**bending, "closed": True}
    found.append(("duct", {**closed, "directrices": [rectangle, top]}))
    found.append(
        (
            "duct in mm",
            {
                **closed,
                "units": "mm",
                "directrices": [[[100 * x for x in p] for p in rail] for rail in (rectangle, top)],
            },
        )
    )
    found.append(("duct with caps", {**closed, "caps": "flat", "directrices": [rectangle, top]}))
    # The same duct as an open strip, whose rails end where they begin.
    seam = [[6, 0, 0], *rectangle[1:], rectangle[0], [6, 0, 0]]
    start = max(range(16), key=lambda k: (-abs(top[k][0] - 6.6), -top[k][1]))
    around = [top[(start + k) % 16] for k in range(16)]
    found.append(("duct with a seam", {**bending, "directrices": [seam, [*around, around[0]]]}))
    found.append(
        (
            "closed stack",
            {**closed, "directrices": [circle(12, 0.5, 0, 0), circle(9, 0.7, 1, 0.3), circle(14, 0.4, 1.8, 0.1)]},
        )
    )
    found.append(("cone", {**closed, "directrices": [circle(12, 0.5, 0, 0), [[0.05, 0, 1]]]}))
    return found


def mesh_of(job):
    mesh = json.loads(request(job["links"]["mesh"] + "?format=json"))
    scale = MILLIMETRES[mesh["unit"]]
    sets = {}
    for lines in mesh["lines"]:
        sets.setdefault(lines["name"].split()[0], []).extend(lines["paths"])
    return scale * (np.array(mesh["vertices"]) + np.array(mesh["origin"])), np.array(mesh["triangles"], int), sets


# Largest side of a page of a PDF in mm, and room for the notes.
LARGEST_PAGE = 5080 - 200


def check_pattern(name, body):
    """Reads the pattern from all formats. A drawing that is larger than a page of a PDF is read from a smaller one."""
    job = solve("ruled_surface", body)
    pattern = job["links"]["self"] + "/pattern"
    described = json.loads(request(f"{pattern}?format=json"))["pieces"]
    fits = (
        max(sum(piece["size"]["height"] for piece in described), *(piece["size"]["width"] for piece in described))
        < 0.8 * LARGEST_PAGE
    )
    worst = check_formats(name, job, described, body, ["svg", "dxf", *(["pdf"] if fits else [])])
    if not fits:
        small = solve("ruled_surface", {**body, "units": "cm"})
        smaller = json.loads(request(f"{small['links']['self']}/pattern?format=json"))["pieces"]
        others = check_formats(f"{name} in cm", small, smaller, body, ["pdf"])
        worst = {key: max(value, others[key]) for key, value in worst.items()}
    return pattern, described, worst


def check_formats(name, job, described, body, formats):
    pattern = job["links"]["self"] + "/pattern"
    vertices, triangles, sets = mesh_of(job)
    bridges = sets["bridges"]
    corners = vertices[triangles]
    areas = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    size = float(np.linalg.norm(vertices.max(0) - vertices.min(0)))
    worst = {"area": 0.0, "length": 0.0, "bent": 0.0}
    for kind in formats:
        pieces = READERS[kind](request(f"{pattern}?format={kind}"))
        what = f"{name}, {kind}"
        found = sum(area(outline) for outline, _ in pieces)
        worst["area"] = max(worst["area"], near(found, float(areas.sum()), READ, f"{what}: the area of all pieces"))
        check(len(pieces) == len(described), f"{what}: {len(pieces)} of {len(described)} pieces")
        for (outline, lines), piece in zip(pieces, described):
            own = f"{what}, {piece['name']}"
            cut = np.array(piece["outline"])
            worst["area"] = max(worst["area"], near(area(outline), area(cut), READ, f"{own}: area"))
            worst["length"] = max(worst["length"], near(perimeter(outline), perimeter(cut), READ, f"{own}: perimeter"))
            check(len(lines) == len(piece["lines"]), f"{own}: {len(lines)} of {len(piece['lines'])} lines")
            for (ends, angle, layer), line in zip(lines, piece["lines"]):
                p, q = vertices[bridges[line["bridge"]]]
                length, expected = (float(np.linalg.norm(b - a)) for a, b in (ends, (p, q)))
                worst["length"] = max(worst["length"], near(length, expected, READ, f"{own}: bridge {line['bridge']}"))
                check(layer == line["kind"], f"{own}: {layer} for {line['kind']}")
                check(
                    angle is None if kind == "pdf" else angle == line["angle_deg"],
                    f"{own}: {angle} for {line['angle_deg']}",
                )
            if kind != "pdf" and lines:
                error = bending_error(outline, lines, piece, vertices, bridges, body.get("closed", False)) / size
                worst["bent"] = max(worst["bent"], error)
                check(error <= SHAPE, f"{own}: bent again it is {error:.1e} of its size off the strip")
    return worst


def bending_error(outline, lines, piece, vertices, bridges, closed):
    # Vertices of the mesh are not rounded as the coordinates of the file are, so corners are compared after rounding.
    snapped = [
        (np.array([min(outline, key=lambda corner: np.abs(corner - end).sum()) for end in ends]), angle, layer)
        for ends, angle, layer in lines
    ]
    places, first, last = bent(outline, snapped)
    numbers = [line["bridge"] for line in piece["lines"]][: len(places)]
    expected = [vertices[bridges[number]] for number in numbers]
    points, solid = list(places.reshape(-1, 3)), list(np.array(expected).reshape(-1, 3))
    for corner, number, step in ((first, numbers[0], -1), (last, numbers[-1], 1)):
        ends = end_bridge(bridges, number, step, closed)
        new = [vertex for vertex in bridges[ends] if vertex not in bridges[number]]
        if corner is not None and len(new) == 1:
            points.append(corner)
            solid.append(vertices[new[0]])
    return apart(np.array(points), np.array(solid))


def end_bridge(bridges, number, step, closed):
    """The number of the bridge before or after one in the same strip."""
    other = number + step
    joined = 0 <= other < len(bridges) and len(set(bridges[other]) & set(bridges[number])) == 1
    if joined:
        return other
    # Over the end of a closed strip.
    assert closed, number
    while 0 <= number - step < len(bridges) and set(bridges[number - step]) & set(bridges[number]):
        number -= step
    return number


def unzipped(data):
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        return [archive.read(name) for name in archive.namelist()]


def check_cloth(name, pattern, described, librecad):
    data = request(f"{pattern}?profile=astm-d6673&allowance=10&notches=300")
    drawing = drawing_of(data)
    # ezdxf takes R13 for the next version that it writes.
    check(b"$ACADVER\n  1\nAC1012\n" in data, f"{name}: cloth is a file of R13")
    check(b"$INSUNITS" not in data and b"LWPOLYLINE" not in data, f"{name}: R13 knows neither")
    inserted = [insert.dxf.name for insert in drawing.modelspace().query("INSERT")]
    check(len(set(inserted)) == len(inserted), f"{name}: {inserted}")
    blocks = [drawing.blocks[block] for block in inserted]
    check(len(blocks) == len(described), f"{name}: {len(blocks)} of {len(described)} blocks")
    cut = json.loads(request(f"{pattern}?format=json&allowance=10"))["pieces"]
    for block, piece in zip(blocks, cut):
        outlines = {
            polyline.dxf.layer: np.array([plane(vertex.dxf.location) for vertex in polyline.vertices])
            for polyline in block.query("POLYLINE")
        }
        near(area(outlines["1"]), area(np.array(piece["outline"])), READ, f"{name}, {block.name}: area of layer 1")
        near(area(outlines["14"]), area(np.array(piece["sew"])), READ, f"{name}, {block.name}: area of layer 14")
        check(len(block.query("LINE[layer=='8']")) == len(piece["lines"]), f"{name}, {block.name}: lines of layer 8")
    if librecad:
        drawn_by_librecad(name, data)


def drawn_by_librecad(name, data):
    """LibreCAD opens the file and prints it. Its page has a stroke for each edge of the outlines and for each line."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "cloth.dxf"), "wb") as file:
            file.write(data)
        environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "HOME": folder, "XDG_RUNTIME_DIR": folder}
        command = ["librecad", "dxf2pdf", "-a", "cloth.dxf"]
        ran = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=120)
        page = os.path.join(folder, "cloth.pdf")
        if not os.path.exists(page):
            check(False, f"{name}: LibreCAD draws nothing: {ran.stdout[-200:]} {ran.stderr[-200:]}")
            return
        with pdfplumber.open(page) as printed:
            strokes = len(printed.pages[0].lines)
    drawing = drawing_of(data)
    blocks = [drawing.blocks[insert.dxf.name] for insert in drawing.modelspace().query("INSERT")]
    edges = sum(len(polyline.vertices) for block in blocks for polyline in block.query("POLYLINE"))
    expected = edges + sum(len(block.query("LINE")) for block in blocks)
    check(strokes >= expected, f"{name}: LibreCAD draws {strokes} of {expected} lines")


def check_sheets(name, pattern, sheet, gap):
    length, width = sheet
    value = json.loads(request(f"{pattern}?format=json&sheet={length},{width}&gap={gap}"))
    on_sheets = {}
    for piece in value["pieces"]:
        check(piece["turned_deg"] in (0, 180), f"{name}: {piece['name']} is turned by {piece['turned_deg']}")
        on_sheets.setdefault(piece["sheet"], []).append(Polygon(piece["outline"]))
    used = 0.0
    for number, pieces in on_sheets.items():
        used += sum(piece.area for piece in pieces)
        for piece in pieces:
            check(
                piece.is_valid and box(-1e-6, -1e-6, length + 1e-6, width + 1e-6).contains(piece),
                f"{name}: sheet {number}",
            )
        for one, other in itertools.combinations(pieces, 2):
            check(
                one.distance(other) >= gap - 1e-6, f"{name}: {one.distance(other)} mm between pieces of sheet {number}"
            )
    near(value["utilisation"], used / (length * width * len(on_sheets)), 1e-12, f"{name}: utilisation")
    # Each grain line lies along its sheet and inside its piece.
    drawing = drawing_of(request(f"{pattern}?format=dxf&sheet={length},{width}&gap={gap}"))
    cuts = [Polygon(entity.get_points("xy")) for entity in drawing.modelspace().query("LWPOLYLINE[layer=='CUT']")]
    grains = drawing.modelspace().query("LINE[layer=='GRAIN']")
    check(len(grains) == len(cuts), f"{name}: {len(grains)} grain lines of {len(cuts)}")
    for grain in grains:
        check(grain.dxf.start.y == grain.dxf.end.y, f"{name}: a grain line across the sheet")
        line = LineString([plane(grain.dxf.start), plane(grain.dxf.end)])
        check(any(cut.contains(line) for cut in cuts), f"{name}: a grain line outside its piece")


def check_pages(name, pattern):
    """The scale bar is 100 mm long, and the frames of neighbouring pages join."""
    whole = request(f"{pattern}?format=pdf")
    with pdfplumber.open(io.BytesIO(whole)) as opened:
        lengths = [
            math.hypot(line["x1"] - line["x0"], line["top"] - line["bottom"]) / POINTS for line in opened.pages[0].lines
        ]
    check(any(abs(length - 100) < 0.01 for length in lengths), f"{name}: no line of 100 mm")
    outlines = from_pdf(whole)
    for paper, size in (("a4", (210, 297)), ("a3", (297, 420))):
        tile = np.array(size) - 20
        reader = pypdf.PdfReader(io.BytesIO(request(f"{pattern}?format=pdf&paper={paper}")))
        seen = set()
        for page in reader.pages:
            title = re.search(r"row (\d+) of (\d+), column (\d+) of", page.extract_text())
            row, rows, column = (int(number) for number in title.groups())
            low = np.array([column - 1, rows - row]) * tile
            writer = pypdf.PdfWriter()
            writer.add_page(page)
            data = io.BytesIO()
            writer.write(data)
            for outline, _ in from_pdf(data.getvalue()):
                moved = outline + low
                found = [
                    k
                    for k, (own, _) in enumerate(outlines)
                    if own.shape == moved.shape and np.abs(own - moved).max() < 1e-9
                ]
                check(found, f"{name}, {paper}: row {row}, column {column}: a piece is not where it is on one page")
                seen.update(found)
        check(seen == set(range(len(outlines))), f"{name}, {paper}: {len(seen)} of {len(outlines)} pieces")


def check_bytes(name, body):
    """Two jobs of one request give the same bytes in every format."""
    queries = [
        "format=svg",
        "format=dxf&angles=true",
        "format=pdf&paper=a4",
        "format=json&notches=30",
        "profile=cut&format=dxf&kerf=0.2",
        "profile=cut&sheet=500,400",
        "profile=sheet-metal&thickness=1&format=pdf",
        "profile=astm-d6673",
        "split=pieces",
    ]
    jobs = [solve("ruled_surface", body)["links"]["self"] for _ in range(2)]
    for query in queries:
        one, other = (request(f"{job}/pattern?{query}") for job in jobs)
        check(one == other, f"{name}: {query} has other bytes the second time")
    one, other = (request(f"{job}/schedule?part=bends") for job in jobs)
    check(one == other, f"{name}: the bends have other bytes the second time")


# ---- schedules


def table(data):
    return list(csv.DictReader(io.StringIO(data.decode(), newline="")))


def unit_of(rows, column):
    return next(name for name in rows[0] if name.startswith(column + "_")).removeprefix(column + "_")


def check_schedule(name, kind, body):
    job = solve(kind, body)
    schedule = job["links"]["self"] + "/schedule"
    vertices, triangles, sets = mesh_of(job)
    members = sets["members"] if len(triangles) else sets["cables"]
    rows = table(request(f"{schedule}?part=members"))
    unit = unit_of(rows, "length")
    vertices = vertices / MILLIMETRES[unit]
    check(len(rows) == len(members), f"{name}: {len(rows)} of {len(members)} members")
    pairs = Counter(tuple(sorted((int(row["from"]), int(row["to"])))) for row in rows)
    check(pairs == Counter(tuple(sorted(member)) for member in members), f"{name}: other members")
    lengths = np.linalg.norm(
        vertices[[int(row["from"]) for row in rows]] - vertices[[int(row["to"]) for row in rows]], axis=1
    )
    total = sum(float(row[f"cut_length_{unit}"]) for row in rows)
    near(total, float(lengths.sum()), 1e-9 * total, f"{name}: the sum of the cut lengths")
    # With setbacks: of members of this width, half of it over the tangent of half the least angle at the node.
    width = 0.05 * float(lengths.min())
    at_node = {}
    for number, row in enumerate(rows):
        for end in (row["from"], row["to"]):
            at_node.setdefault(int(end), []).append(number)
    expected = float(lengths.sum())
    for node, own in at_node.items():
        far = [int(rows[k]["to"]) if int(rows[k]["from"]) == node else int(rows[k]["from"]) for k in own]
        directions = vertices[far] - vertices[node]
        directions /= np.linalg.norm(directions, axis=1)[:, None]
        for k in range(len(own)):
            others = np.delete(directions, k, 0)
            chord = np.linalg.norm(others - directions[k], axis=1).min() if len(others) else None
            expected -= 0.0 if chord is None else 0.5 * width / math.tan(math.asin(min(1.0, 0.5 * chord)))
    narrow = table(request(f"{schedule}?part=members&member_width={width!r}"))
    total = sum(float(row[f"cut_length_{unit}"]) for row in narrow)
    near(total, expected, 1e-9 * total, f"{name}: the sum of the cut lengths with setbacks")
    worst = check_directions(name, table(request(f"{schedule}?part=nodes")), vertices)
    check_space(name, request(f"{schedule}?format=dxf&tolerance={0.01 * float(lengths.max())!r}"), vertices, members)
    return len(rows), worst


def check_directions(name, rows, vertices):
    worst = 0.0
    for row in rows:
        axis, zero = (np.array([float(row[f"{of}_{x}"]) for x in "xyz"]) for of in ("axis", "zero"))
        azimuth, elevation = (math.radians(float(row[f"{of}_deg"])) for of in ("azimuth", "elevation"))
        flat = math.cos(azimuth) * zero + math.sin(azimuth) * np.cross(axis, zero)
        rebuilt = math.cos(elevation) * flat + math.sin(elevation) * axis
        direction = vertices[int(row["to"])] - vertices[int(row["node"])]
        worst = max(worst, float(np.linalg.norm(rebuilt - direction / np.linalg.norm(direction))))
    check(worst <= SHAPE, f"{name}: directions are off by {worst:.1e}")
    return worst


def check_space(name, data, vertices, members):
    drawing = drawing_of(data)
    space = drawing.modelspace()
    place = {tuple(vertex): number for number, vertex in enumerate(vertices)}

    def number_at(point):
        found = place.get(tuple(point))
        return int(np.linalg.norm(vertices - np.array(point), axis=1).argmin()) if found is None else found

    lines = [tuple(sorted((number_at(line.dxf.start), number_at(line.dxf.end)))) for line in space.query("LINE")]
    expected = [tuple(sorted(member)) for member in members]
    check(lines == expected, f"{name}: the drawing in space has {len(lines)} lines for {len(expected)} members")
    check(len(set(lines)) == len(set(expected)), f"{name}: a member is drawn twice")
    texts = space.query("TEXT[layer=='MEMBER_NUMBERS']")
    check([text.dxf.text for text in texts] == [str(k) for k in range(len(members))], f"{name}: numbers of members")
    for text, member in zip(texts, members):
        middle = vertices[member].mean(0)
        check(
            np.abs(np.array(text.dxf.align_point) - middle).max() < 1e-9 * (1 + np.abs(middle).max()),
            f"{name}: number {text.dxf.text}",
        )


# Lengths of the members of whole geodesic spheres of radius 1, with their number, and numbers of the kinds of nodes.
DOMES = {
    2: ([(0.546533, 60), (0.618034, 60)], [12, 30]),
    3: ([(0.348615, 60), (0.403548, 90), (0.412411, 120)], [12, 20, 60]),
    4: (
        [(0.253185, 60), (0.294531, 120), (0.295242, 60), (0.298588, 60), (0.312869, 120), (0.324920, 60)],
        [12, 30, 60, 60],
    ),
}


def dome(frequency):
    """A whole sphere: every side of an icosahedron divided into `frequency` parts."""
    golden = (1 + math.sqrt(5)) / 2
    corners = [np.roll([0, a, b * golden], shift) for a in (-1, 1) for b in (-1, 1) for shift in range(3)]
    nodes, edges = [], set()

    def number(point):
        point = point / np.linalg.norm(point)
        for k, node in enumerate(nodes):
            if np.linalg.norm(node - point) < 1e-9:
                return k
        nodes.append(point)
        return len(nodes) - 1

    for a, b, c in itertools.combinations(corners, 3):
        if any(abs(np.linalg.norm(one - other) - 2) > 1e-9 for one, other in ((a, b), (b, c), (c, a))):
            continue
        at = {
            (u, v): number(a * (frequency - u - v) + b * u + c * v)
            for u in range(frequency + 1)
            for v in range(frequency + 1 - u)
        }
        for (u, v), node in at.items():
            for step in ((1, 0), (0, 1), (-1, 1)):
                other = at.get((u + step[0], v + step[1]))
                if other is not None:
                    edges.add((min(node, other), max(node, other)))
    return [list(map(float, node)) for node in nodes], [list(edge) for edge in sorted(edges)]


def check_dome(frequency):
    nodes, edges = dome(frequency)
    body = {
        "kind": "cable_net",
        "vertices": nodes,
        "edges": edges,
        "supports": list(range(len(nodes))),
        "cables": [{"force_density": 1}],
    }
    name = f"dome {frequency}V"
    check_schedule(name, "cable_net", body)
    schedule = solve("cable_net", body)["links"]["self"] + "/schedule"
    rows = table(request(f"{schedule}?part=members&tolerance=0.0001"))
    unit = unit_of(rows, "length")
    lengths, kinds = DOMES[frequency]
    found = Counter(row["kind"] for row in rows)
    means = {kind: np.mean([float(row[f"length_{unit}"]) for row in rows if row["kind"] == kind]) for kind in found}
    for kind, (length, count) in zip(sorted(means, key=means.get), lengths):
        near(means[kind], length, 1e-6, f"{name}: length of kind {kind}")
        check(found[kind] == count, f"{name}: {found[kind]} members of kind {kind}")
    check(len(found) == len(lengths), f"{name}: {len(found)} kinds of members")
    at_nodes = {row["node"]: row["kind"] for row in table(request(f"{schedule}?part=nodes&tolerance=0.001"))}
    counts = sorted(Counter(at_nodes.values()).values())
    check(counts == kinds, f"{name}: {counts} nodes of each kind")


def main():
    started = time.monotonic()
    librecad = shutil.which("librecad")
    if not librecad:
        skip("cloth in LibreCAD", "it is not installed")
    for name, body in strips():
        pattern, described, worst = check_pattern(name, body)
        check_cloth(name, pattern, described, librecad)
        print(
            f"{name}: {len(described)} pieces; apart by "
            + ", ".join(f"{key} {value:.1e}" for key, value in worst.items()),
            flush=True,
        )
        if name in ("duct in mm", "closed stack"):
            check_pages(name, pattern)
        if name in ("duct with caps", "closed stack", "wang-tang-i"):
            largest = max(max(piece["size"].values()) for piece in described)
            check_sheets(name, pattern, (math.ceil(1.5 * largest), math.ceil(1.2 * largest)), 7)
    check_bytes("duct with caps in cm", {**dict(strips())["duct with caps"], "units": "cm"})
    for name, kind, body in examples():
        if kind in ("uniform_mesh", "cable_net"):
            count, worst = check_schedule(name, kind, body)
            print(f"{name}: {count} members, directions apart by {worst:.1e}", flush=True)
    for frequency in DOMES:
        check_dome(frequency)
    for fault in faults[:40]:
        print(f"FAILED: {fault}")
    print(f"{checked} checks, {len(faults)} failed, {time.monotonic() - started:.0f} s")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
