#!/usr/bin/env python3
"""Draws the results that the documents show: solves the examples through a running service and writes docs/pictures.

    python3 scripts/draw_results.py [http://127.0.0.1:8080]

Each picture is an SVG of the mesh seen from above at an angle, far triangles first. Needs no package.
"""
import json
import math
import os
import sys
import urllib.request

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
# Picture, its examples with the size of each part and what is drawn over the triangles.
PICTURES = {
    "four-kinds": [("tent", 240, ("mesh",)), ("wavy-strip", 240, ("bridges",)), ("latticed-roof", 240, ("members")),
                   ("four-point-sail", 240, ("mesh", "cables"))],
    "film": [("tent", 420, ("mesh",))],
    "strip": [("wavy-strip", 420, ("bridges",))],
    "lattice": [("latticed-roof", 420, ("members"))],
    "sail": [("four-point-sail", 420, ("mesh", "cables"))],
    "net": [("cable-net-by-targets", 420, ("all",))],
}
LIGHT = (0.35, -0.35, 0.87)
# Shades of grey-blue, each a class of the picture: the file says a letter for a colour.
SHADES = 16
DARK, BRIGHT = (88, 132, 176), (238, 244, 250)


def call(url, body=None):
    headers = {"Content-Type": "application/json", "Prefer": "wait=60"}
    request = urllib.request.Request(url, json.dumps(body).encode() if body else None, headers if body else {})
    with urllib.request.urlopen(request, timeout=120) as answer:
        return answer.read()


def read_obj(text):
    vertices, faces, lines, name = [], [], [], ""
    for row in text.splitlines():
        words = row.split()
        if not words:
            continue
        if words[0] == "v":
            vertices.append(tuple(map(float, words[1:4])))
        elif words[0] == "f":
            faces.append([int(word) - 1 for word in words[1:]])
        elif words[0] == "o":
            name = words[1]
        elif words[0] == "l":
            ends = [int(word) - 1 for word in words[1:]]
            lines += [(name, a, b) for a, b in zip(ends, ends[1:])]
    return vertices, faces, lines


def draw(vertices, faces, lines, size, shift, over):
    turn, tilt = math.radians(-35), math.radians(32)
    def project(p):
        x = math.cos(turn) * p[0] - math.sin(turn) * p[1]
        y = math.sin(turn) * p[0] + math.cos(turn) * p[1]
        return x, -(math.sin(tilt) * y + math.cos(tilt) * p[2]), math.cos(tilt) * y - math.sin(tilt) * p[2]

    places = [project(p) for p in vertices]
    low = [min(p[k] for p in places) for k in range(2)]
    high = [max(p[k] for p in places) for k in range(2)]
    scale = 0.9 * size / max(high[0] - low[0], high[1] - low[1])
    at = lambda v: (shift + size / 2 + scale * (places[v][0] - (low[0] + high[0]) / 2),
                    size / 2 + scale * (places[v][1] - (low[1] + high[1]) / 2))
    text = lambda points: " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    parts = []
    for face in sorted(faces, key=lambda f: -sum(places[v][2] for v in f)):
        a, b, c = (vertices[v] for v in face[:3])
        u, w = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
        n = (u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0])
        length = math.sqrt(sum(x * x for x in n)) or 1
        shade = round((SHADES - 1) * abs(sum(x * y for x, y in zip(n, LIGHT))) / length)
        edges = ' stroke="#6f93b5"' if "mesh" in over else ""
        parts.append(f'<path class="{chr(97 + shade)}" d="M{text(at(v) for v in face)}Z"{edges}/>')
    drawn = [f"M{text((at(a), at(b)))}" for name, a, b in lines if "all" in over or name.split("_")[0] in over]
    if drawn:
        width = 0.3 if "bridges" in over else 0.5 if len(drawn) > 400 else 0.9
        parts.append(f'<path d="{"".join(drawn)}" stroke="#1d3348" stroke-width="{width}"/>')
    return parts


def style():
    def rule(shade):
        color = "".join(f"{round(d + shade / (SHADES - 1) * (b - d)):02x}" for d, b in zip(DARK, BRIGHT))
        return f".{chr(97 + shade)}{{fill:#{color}}}.{chr(97 + shade)}:not([stroke]){{stroke:#{color}}}"

    return "<style>" + "".join(rule(shade) for shade in range(SHADES)) + "</style>"


def main():
    service = (sys.argv[1] if len(sys.argv) > 1 else os.environ.get("PLATEAU_URL", "http://127.0.0.1:8080")).rstrip("/")
    for picture, examples in PICTURES.items():
        parts, shift = [], 0
        for name, size, over in examples:
            with open(os.path.join(ROOT, "api", "examples", f"{name}.json"), encoding="utf-8") as file:
                request = json.load(file)
            if "triangles" in request.get("resolution", {}):
                # Enough for a picture of this size.
                request["resolution"] = {"triangles": 600}
            path = request["kind"].replace("_", "-") + ("es" if request["kind"].endswith("mesh") else "s")
            job = json.loads(call(f"{service}/v1/{path}", request))
            mesh = read_obj(call(service + job["links"]["mesh"] + "?format=obj").decode())
            parts += draw(*mesh, size, shift, over)
            shift += size
        height = max(size for _, size, _ in examples)
        with open(os.path.join(ROOT, "docs", "pictures", f"{picture}.svg"), "w", encoding="utf-8") as file:
            file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {shift} {height}" width="{shift}" '
                       f'stroke-width=".3" stroke-linejoin="round"><rect width="100%" height="100%" fill="#fff"/>{style()}')
            file.write("\n".join(parts) + "</svg>\n")
        print(picture)


if __name__ == "__main__":
    main()
