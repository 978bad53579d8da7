"""Writes the drawings of this folder with other programs: ezdxf, GDAL, geopandas, pandas, trimesh, OpenSCAD, pstoedit,
potrace, assimp, Gnumeric and FreeCAD. The files are committed, and files.json says what the studio must find in each.

    pip install ezdxf geopandas trimesh networkx
    apt-get install openscad pstoedit potrace assimp-utils gnumeric libfreecad-python3-0.20
    python3 make.py

librecad-arch.dxf was drawn in LibreCAD 2.2 in mm by these commands, and saved as DXF 2007: line 0,0 8000,0 8000,6000;
arc 8000,6000 4000,8000 0,6000; line 0,6000 0,0; circle 4000,3000 500.
"""

import json
import math
import pathlib
import subprocess

import ezdxf
import geopandas
import pandas
import shapely
import trimesh

here = pathlib.Path(__file__).parent
SAIL = [(0, 0, 0), (12.4, 0, 2.5), (12.4, 6.1, 0), (0, 6.1, 2.5)]
PLAN = [(x, y) for x, y, _ in SAIL]


def scaled(points, factor, shift=(0, 0, 0)):
    return [tuple(round(value * factor + shift[axis], 6) for axis, value in enumerate(point)) for point in points]


def dxf(name, units, draw, version="R2010"):
    drawing = ezdxf.new(version)
    drawing.header["$INSUNITS"] = units
    draw(drawing.modelspace(), drawing)
    drawing.saveas(here / name)


# Sails as polylines in space, in five units.
for name, units, factor in [("m", 6, 1), ("cm", 5, 100), ("mm", 4, 1000), ("inch", 1, 1 / 0.0254), ("feet", 2, 1 / 0.3048)]:
    dxf(f"ezdxf-sail-{name}.dxf", units, lambda space, _, f=factor: space.add_polyline3d(scaled(SAIL, f), close=True))
dxf("ezdxf-sail-unitless.dxf", 0, lambda space, _: space.add_polyline3d(scaled(SAIL, 1000), close=True))
dxf("ezdxf-sail-r12.dxf", 0, lambda space, _: space.add_polyline3d(SAIL, close=True), "R12")
dxf("ezdxf-survey-feet.dxf", 21, lambda space, _: space.add_lwpolyline(scaled(PLAN, 3937 / 1200, (2083120, 700123)), close=True))
dxf("ezdxf-survey-mm.dxf", 4, lambda space, _: space.add_polyline3d(scaled(SAIL, 1000, (2683120956, 1247321123, 410250)), close=True))
# A stadium: its ends are half circles, as bulges of 1. The straight sides are 8 m long and 6 m apart.
dxf("ezdxf-bulges.dxf", 6, lambda space, _: space.add_lwpolyline([(0, 0, 0), (8, 0, 1), (8, 6, 0), (0, 6, 1)], format="xyb", close=True))
dxf("ezdxf-spline.dxf", 6, lambda space, _: space.add_spline().set_closed([(0, 0, 0), (10, 0, 2), (10, 6, 0), (0, 6, 2)]))
dxf("ezdxf-spline-through.dxf", 6, lambda space, _: space.add_spline(fit_points=[(0, 0, 0), (5, -1, 0), (10, 0, 0), (10, 6, 0), (0, 6, 0)]))


def rational(space, _):
    # A quarter of a circle of radius 10 as a rational spline, closed by two lines.
    space.add_rational_spline([(10, 0, 0), (10, 10, 0), (0, 10, 0)], weights=[1, math.sqrt(0.5), 1], degree=2, knots=[0, 0, 0, 1, 1, 1])


dxf("ezdxf-rational-spline.dxf", 6, rational)
dxf("ezdxf-ellipse.dxf", 6, lambda space, _: space.add_ellipse((0, 0, 3), major_axis=(6, 0, 0), ratio=0.5))


def layers(space, drawing):
    for layer, points in {"SITE": scaled(PLAN, 5, (0, 0)), "SAIL": PLAN}.items():
        drawing.layers.add(layer)
        space.add_lwpolyline(points, close=True, dxfattribs={"layer": layer})
    space.add_text("not to scale", dxfattribs={"layer": "TEXT"})


def lines(space, _):
    for a, b in zip(SAIL, SAIL[1:] + SAIL[:1]):
        space.add_line(a, b)


def blocks(space, drawing):
    block = drawing.blocks.new("SAIL")
    block.add_lwpolyline([(0, 0), (6, 0), (6, 4), (0, 4)], close=True)
    space.add_blockref("SAIL", (0, 0))
    space.add_blockref("SAIL", (20, 0), dxfattribs={"rotation": 90, "xscale": 2, "yscale": 2})


dxf("ezdxf-layers.dxf", 6, layers)
dxf("ezdxf-lines.dxf", 6, lines)
dxf("ezdxf-blocks.dxf", 6, blocks)
dxf("ezdxf-mirrored.dxf", 6, lambda space, _: space.add_lwpolyline([(0, 0, 0), (-8, 0, 1), (-8, 6, 0), (0, 6, 1)], format="xyb", close=True, dxfattribs={"extrusion": (0, 0, -1), "elevation": -2}))

# Sites as geopandas and GDAL write them. UTM zone 32 and Web Mercator name their systems.
utm = geopandas.GeoDataFrame({"name": ["roof", "yard"]}, geometry=[shapely.Polygon(scaled(PLAN, 1, (465000, 5247300))), shapely.Polygon(scaled(PLAN, 3, (465030, 5247300)))], crs=25832)
utm.to_file(here / "geopandas-utm.geojson", driver="GeoJSON")
utm.to_crs(4326).to_file(here / "geopandas-degrees.geojson", driver="GeoJSON")
utm.to_crs(4326).to_file(here / "gdal-rfc7946.geojson", driver="GeoJSON", RFC7946="YES")
utm.to_crs(3857).to_file(here / "geopandas-web-mercator.geojson", driver="GeoJSON")
utm.boundary.to_file(here / "gdal-lines.dxf", driver="DXF")
(here / "shapely-plan.geojson").write_text(shapely.to_geojson(shapely.Polygon(scaled(PLAN, 100))))
ring = geopandas.GeoSeries([shapely.Point(8.5417, 47.3769)], crs=4326).to_crs(2056).buffer(20, quad_segs=6).to_crs(4326)
frame = pandas.DataFrame([(y, x, 410) for x, y in ring.iloc[0].exterior.coords], columns=["latitude", "longitude", "elevation"])
frame.to_csv(here / "pandas-degrees.csv", index=False)

# Tables of points.
table = pandas.DataFrame(SAIL, columns=["x", "y", "z"])
table.to_csv(here / "pandas-comma.csv", index=False)
table.to_csv(here / "pandas-semicolon.csv", index=False, sep=";", decimal=",")
(table * 1000).round().astype(int).rename(columns=lambda axis: f"{axis} [mm]").to_csv(here / "pandas-mm.csv", index=False, sep="\t")
survey = pandas.DataFrame(scaled(SAIL, 1, (2683120.956, 1247321.123, 410.25)), columns=["Easting (m)", "Northing (m)", "Height (m)"])
survey.insert(0, "Point", ["P1", "P2", "P3", "P4"])
survey.to_csv(here / "pandas-survey.csv", index=False, sep=";")
(here / "table.tmp.csv").write_text(table.to_csv(index=False))
subprocess.run(["ssconvert", "-O", "separator=; format=raw", "-T", "Gnumeric_stf:stf_assistant", here / "table.tmp.csv", here / "gnumeric-semicolon.txt"], check=True)
(here / "table.tmp.csv").unlink()

# Meshes and lines as OBJ.
path = trimesh.Trimesh(vertices=SAIL, faces=[[0, 1, 2], [0, 2, 3]], process=False)
path.export(here / "trimesh-sail.obj")
subprocess.run(["assimp", "export", here / "trimesh-sail.obj", here / "assimp-sail.obj"], check=True, stdout=subprocess.DEVNULL)
for leftover in here.glob("*.mtl"):
    leftover.unlink()

# Drawings of programs that write no unit.
(here / "plan.tmp.scad").write_text("difference() { square([124, 61]); translate([30, 30]) circle(r = 10, $fn = 24); }")
subprocess.run(["openscad", "-o", here / "openscad-plan.dxf", here / "plan.tmp.scad"], check=True, stderr=subprocess.DEVNULL)
(here / "plan.tmp.scad").unlink()
(here / "curve.tmp.ps").write_text("%!PS\n0 0 moveto 200 -50 300 150 400 100 curveto 300 300 lineto 0 200 lineto closepath stroke showpage\n")
subprocess.run(["pstoedit", "-q", "-f", "dxf:-splineasbspline", here / "curve.tmp.ps", here / "pstoedit-curve.dxf"], check=True, stderr=subprocess.DEVNULL)
(here / "curve.tmp.ps").unlink()
rows = "\n".join(" ".join("1" if (x - 60) ** 2 / 50**2 + (y - 40) ** 2 / 30**2 < 1 else "0" for x in range(120)) for y in range(80))
(here / "disc.tmp.pbm").write_text(f"P1\n120 80\n{rows}\n")
subprocess.run(["potrace", "-b", "dxf", "-o", here / "potrace-disc.dxf", here / "disc.tmp.pbm"], check=True)
subprocess.run(["potrace", "-b", "geojson", "-o", here / "potrace-disc.geojson", here / "disc.tmp.pbm"], check=True)
(here / "disc.tmp.pbm").unlink()

# Wires of FreeCAD, which writes each edge as an entity of its own: a stadium of lines and arcs, a leaf of a spline and
# a line, and a sail. Debian's FreeCAD belongs to Debian's Python.
FREECAD = """
import sys
sys.path.append("/usr/lib/freecad-python3/lib")
import FreeCAD, Import, Part
from FreeCAD import Vector
line, arc = (lambda *ends: Part.makeLine(*(Vector(*end) for end in ends))), (lambda *points: Part.Arc(*(Vector(*point) for point in points)).toShape())
spline = Part.BSplineCurve()
spline.interpolate([Vector(0, 0, 0), Vector(5000, 4000, 0), Vector(10000, 0, 0)])
sail = [Vector(0, 0, 0), Vector(12400, 0, 2500), Vector(12400, 6100, 0), Vector(0, 6100, 2500)]
document = FreeCAD.newDocument()
for name, shape in {
    "Stadium": Part.Wire([line((0, 0, 0), (8000, 0, 0)), arc((8000, 0, 0), (11000, 3000, 0), (8000, 6000, 0)), line((8000, 6000, 0), (0, 6000, 0)), arc((0, 6000, 0), (-3000, 3000, 0), (0, 0, 0))]),
    "Leaf": Part.Wire([spline.toShape(), line((10000, 0, 0), (0, 0, 0))]),
    "Sail": Part.makePolygon([*sail, sail[0]]),
}.items():
    part = document.addObject("Part::Feature", name)
    part.Shape = shape
    document.recompute()
    Import.writeDXFObject([part], f"freecad-{name.lower()}.dxf")
"""
subprocess.run(["/usr/bin/python3", "-c", FREECAD], check=True, cwd=here)
