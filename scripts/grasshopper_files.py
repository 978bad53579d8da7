"""Writes a Grasshopper file (.ghx, text) for each component of Hops into clients/grasshopper.

Usage: PLATEAU_URL=http://… grasshopper_files.py [--check]. Each file has one component of Hops with the address of
Plateau's component on a server at localhost:8080. When Grasshopper opens the file, Hops asks that server for the inputs
and outputs, so a file never disagrees with its server. `--check` writes nothing and fails if a file is out of date.

The archive has the items that GH_IO writes (the samples of mcneel/compute.rhino3d), and the component those that
HopsComponent.Write writes there. The files were not opened in Grasshopper, which runs on Windows and macOS only.
"""

import json
import os
import sys
import urllib.request
import uuid
import xml.etree.ElementTree as ET
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "clients" / "grasshopper"
SERVER = "http://localhost:8080"
HOPS = "c69bb52c-88ba-4640-b69f-188d111029e8"
"""Identifier of Hops' component in every version."""
TYPES = {"gh_bool": 1, "gh_int32": 3, "gh_single": 5, "gh_guid": 9, "gh_string": 10, "gh_drawing_point": 30,
         "gh_drawing_pointf": 31, "gh_drawing_rectanglef": 35, "gh_version": 80}
"""Codes of the types of items in GH_IO."""
AT = (60.0, 40.0)
"""Place of the component on the canvas."""


def item(name, of, value):
    element = ET.Element("item", name=name, type_name=of, type_code=str(TYPES[of]))
    if isinstance(value, dict):
        for part, number in value.items():
            ET.SubElement(element, part).text = str(number)
    else:
        element.text = str(value).lower() if isinstance(value, bool) else str(value)
    return element


def chunk(name, items=(), chunks=(), index=None):
    element = ET.Element("chunk", {"name": name, **({} if index is None else {"index": str(index)})})
    return fill(element, items, chunks)


def fill(element, items, chunks):
    """Adds items and chunks with their numbers, which GH_IO compares with what it finds."""
    for name, parts in (("items", list(items)), ("chunks", list(chunks))):
        if parts:
            ET.SubElement(element, name, count=str(len(parts))).extend(parts)
    return element


def version(major, minor, revision):
    return {"Major": major, "Minor": minor, "Revision": revision}


def guid(name):
    return uuid.uuid5(uuid.NAMESPACE_URL, f"plateau/hops/{name}")


def component(described):
    """The object of a component of Hops. Its inputs and outputs are left to Hops."""
    address = SERVER + described["Uri"]
    width, height = 120.0, 44.0
    place = chunk("Attributes", [
        item("Bounds", "gh_drawing_rectanglef", {"X": AT[0], "Y": AT[1], "W": width, "H": height}),
        item("Pivot", "gh_drawing_pointf", {"X": AT[0] + width / 2, "Y": AT[1] + height / 2}),
    ])
    parameters = chunk("ParameterData", [item("InputCount", "gh_int32", 0), item("OutputCount", "gh_int32", 0)])
    container = chunk("Container", [
        item("CacheResultsInMemory", "gh_bool", True),
        item("CacheSolveResults", "gh_bool", True),
        item("Description", "gh_string", described["Description"]),
        item("InstanceGuid", "gh_guid", guid(described["Uri"])),
        item("Name", "gh_string", described["Name"]),
        item("NickName", "gh_string", described["Nickname"]),
        item("RemoteDefinitionLocation", "gh_string", address),
        item("RemoteSolveVersion", "gh_version", version(0, 1, 0)),
        item("ShowInput_Enabled", "gh_bool", False),
        item("ShowInput_Path", "gh_bool", False),
        item("SynchronousSolve", "gh_bool", True),
    ], [place, parameters])
    return chunk("Object", [item("GUID", "gh_guid", HOPS), item("Name", "gh_string", "Hops")], [container], index=0)


def archive(described):
    """The text of a file."""
    name = described["Uri"].rsplit("/", 1)[1]
    definition = chunk("Definition", [item("plugin_version", "gh_version", version(1, 0, 7))], [
        chunk("DocumentHeader", [
            item("DocumentID", "gh_guid", guid(name + ".ghx")),
            item("Preview", "gh_string", "Shaded"),
            item("PreviewMeshType", "gh_int32", 1),
        ]),
        chunk("DefinitionProperties", [
            item("Description", "gh_string", described["Description"]),
            item("Name", "gh_string", name + ".ghx"),
        ], [
            chunk("Revisions", [item("RevisionCount", "gh_int32", 0)]),
            chunk("Projection", [item("Target", "gh_drawing_point", {"X": 0, "Y": 0}), item("Zoom", "gh_single", 1)]),
            chunk("Views", [item("ViewCount", "gh_int32", 0)]),
        ]),
        chunk("RcpLayout", [item("GroupCount", "gh_int32", 0)]),
        chunk("GHALibraries", [item("Count", "gh_int32", 0)]),
        chunk("DefinitionObjects", [item("ObjectCount", "gh_int32", 1)], [component(described)]),
    ])
    root = fill(ET.Element("Archive", name="Root"), [item("ArchiveVersion", "gh_version", version(0, 2, 2))], [definition])
    ET.indent(root)
    return '<?xml version="1.0" encoding="utf-8" standalone="yes"?>\n' + ET.tostring(root, encoding="unicode") + "\n"


def files():
    """The texts of all files by their names, for the components that a release has."""
    with urllib.request.urlopen(os.environ["PLATEAU_URL"] + "/hops") as answer:
        described = json.load(answer)
    # Only builds for tests have this kind.
    released = [one for one in described if "/enlargement" not in one["Uri"]]
    return {one["Uri"].rsplit("/", 1)[1] + ".ghx": archive(one) for one in released}


def main():
    wanted = files()
    there = {path.name: path.read_text(encoding="utf-8") for path in FOLDER.glob("*.ghx")}
    if "--check" in sys.argv:
        different = sorted(name for name in wanted.keys() | there.keys() if wanted.get(name) != there.get(name))
        if different:
            sys.exit(f"out of date: {', '.join(different)}; refresh with python3 scripts/grasshopper_files.py")
        return
    FOLDER.mkdir(exist_ok=True)
    for name in there.keys() - wanted.keys():
        (FOLDER / name).unlink()
    for name, text in wanted.items():
        (FOLDER / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
