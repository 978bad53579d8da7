#!/usr/bin/env python3
"""Checks the laws of docs/ARCHITECTURE.md that no compiler and no lint knows, by reading the source.

    python3 scripts/check_arrows.py [ROOT]

In a crate and in src, no files form a circle, no file uses one of a later layer, and no module re-exports what belongs
to another one. Every loop of the geometry ends visibly. Only http/problem.rs names the status codes of failures.

An arrow leads from a file to each file that it names, in a `use` declaration or in a path that starts with `crate::`,
`super::`, `self::` or a child module. A re-exported name leads to the file that defines it. A module's re-exports of
its own descendants are its table of contents and no arrows. Items under `#[cfg(test)]` are not read.
"""
import os
import re
import sys

# The files and folders of each crate, earliest layer first. A file belongs to the longest entry that its path starts
# with. In a crate without an entry only circles are faults.
LAYERS = {
    "mesh": """
        execution codes error estimate random order disjoint_sets lib axis_box box_tree polyline topology measure check
        complex edit cut film structured self_intersections crossing sparse plane remesh""",
    "equilibrium": """
        dense energy support freedom constraint body contact newton residual motion normal_motion stability v_cycle
        relax settling form_finding lib""",
    "minimal-surface": """
        options cone estimate initial_mesh/first_point request run curvature extrapolation harmonic initial_mesh
        kept_film solved_film touching_boundaries solvers drivers junction_statistics statistics outcome
        triple_junction lib""",
    "tensile-structure": """
        options checks catenary weave mixing model remeshing taut_start form_finding travel ponding shape stress
        corners reactions warnings outcome lib""",
    "cable-net": "options shape loss step fitted fitting struts lib",
    "ruled-surface": "graph strip pattern stack lib",
    "drawing": """
        parameters options columns polygon piece label relief metal figure divide sheets kinds json drawing dxf astm svg pdf schedule lib""",
    "engine": """
        limits common resolution options report join mesh audit solved source checked blocks kind kinds components schema
        request lib""",
    "strict-json": "lib rejection json bounds strict explain",
    "plateau": """
        status threads test_hooks store config telemetry auth webhook wire hops jobs http app cli lib main""",
}
# These have no solvers. The loops of every other crate are read.
WITHOUT_SOLVERS = {"archive", "drawing", "engine", "opennurbs", "page", "plateau", "strict-json"}
SUCCESSES = {"OK", "ACCEPTED", "NO_CONTENT", "NOT_MODIFIED", "PARTIAL_CONTENT"}
NO_CODE = re.compile(
    r"""//[^\n]*|/\*.*?\*/|\bb?r(?P<hashes>#*)".*?"(?P=hashes)|"(?:\\.|[^"\\])*"|'(?:\\.[^']*|[^\\'])'""", re.S)
TEST = re.compile(r"#\s*\[\s*cfg\s*\(\s*test\s*\)\s*\]")
ITEM = re.compile(r"\b(?:fn|mod|impl|struct|enum|const|static|use|type|trait|unsafe|async)\b")
USE = re.compile(r"(\bpub\s*(?:\([^)]*\)\s*)?)?\buse\s+([^;]+);")
PATH = re.compile(r"\w+(?:\s*::\s*\w+)+")


def blank(text):
    return re.sub(r"[^\n]", " ", text)


def brackets(text, at):
    """Yields the places of the characters from `at` on, each with the depth of brackets before it."""
    depth = 0
    for k in range(at, len(text)):
        if text[k] in ")]}":
            depth -= 1
        yield k, depth
        if text[k] in "([{":
            depth += 1


def item_end(text, at):
    """Returns the end of the item or of the field that starts at `at`."""
    is_field = not ITEM.search(re.match(r"[^:,{};]*", text[at:])[0])
    for k, depth in brackets(text, at):
        if depth < 0:
            return k
        if depth == 0 and (text[k] in "};" or (is_field and text[k] == ",")):
            return k + 1
    return len(text)


def code_of(text):
    """Returns the text without comments, strings and items under #[cfg(test)], and the names of their modules. Every
    other character keeps its place."""
    code, modules = NO_CODE.sub(lambda found: blank(found[0]), text), []
    while found := TEST.search(code):
        end = item_end(code, found.end())
        item = code[found.start():end]
        modules += re.findall(r"\bmod\s+(\w+)", item)[:1]
        code = code[:found.start()] + blank(item) + code[end:]
    return code, modules


def use_tree(tree):
    """Returns the paths of a use tree, each with the name that it is bound to."""
    tree = tree.strip()
    head, brace, rest = tree.partition("{")
    if not brace:
        path, _, name = re.sub(r"\s+", " ", tree).partition(" as ")
        path = [part.strip() for part in path.split("::") if part.strip()]
        path = path[:-1] if path[1:] and path[-1] == "self" else path
        return [(path, name or path[-1])]
    prefix = [part.strip() for part in head.split("::") if part.strip()]
    inside, start, found = rest[:rest.rindex("}")] + ",", 0, []
    for k, depth in brackets(inside, 0):
        if inside[k] == "," and depth == 0:
            if inside[start:k].strip():
                found += [(prefix + path, prefix[-1] if path == ["self"] and name == "self" else name)
                          for path, name in use_tree(inside[start:k])]
            start = k + 1
    return [(path[:-1] if path[1:] and path[-1] == "self" else path, name) for path, name in found]


class Contents:
    """What a file names: its use declarations (path, name, whether exported), paths in its code, child modules."""

    def __init__(self, file):
        with open(file, encoding="utf-8") as source:
            self.file, self.text = file, source.read()
        self.code, self.test_children = code_of(self.text)
        self.uses = []
        for found in USE.finditer(self.code):
            self.uses += [(path, name, bool(found[1])) for path, name in use_tree(found[2])]
        # The path of a visibility, `pub(in …)`, uses nothing.
        rest = re.sub(r"\bpub\s*\(\s*in\b[^)]*\)", "", USE.sub(";", self.code))
        self.paths = [re.split(r"\s*::\s*", path) for path in PATH.findall(rest)]
        self.children = set(re.findall(r"\bmod\s+(\w+)\s*;", self.code))


def read_crate(folder):
    """Returns the contents of each file of a crate by the path of its module, without files of test modules."""
    files = {}
    for where, _, names in os.walk(folder):
        for name in names:
            if name.endswith(".rs"):
                path = os.path.relpath(os.path.join(where, name), folder)[:-3].replace(os.sep, "/").split("/")
                path = path[:-1] if path[-1] == "mod" or path == ["lib"] else path
                files[tuple(path)] = Contents(os.path.join(where, name))
    tests = [(*path, child) for path, contents in files.items() for child in contents.test_children]
    return {path: own for path, own in files.items() if not any(path[:len(test)] == test for test in tests)}


def resolve(files, start, path, depth=0):
    """Returns the module that defines what `path` names in the module `start`, or None outside of the crate."""
    module, rest = list(start), list(path)
    if rest[0] == "crate":
        module, rest = [], rest[1:]
    elif rest[0] == "self":
        rest = rest[1:]
    elif rest[0] == "super":
        while rest and rest[0] == "super":
            module, rest = module[:-1], rest[1:]
    elif rest[0] not in files[start].children:
        return None
    while rest:
        if (*module, rest[0]) in files:
            module.append(rest.pop(0))
            continue
        uses = files[tuple(module)].uses if tuple(module) in files else []
        exports = [path for path, name, exported in uses if exported and name == rest[0]]
        if exports and depth < 8:
            return resolve(files, tuple(module), exports[0] + rest[1:], depth + 1)
        break
    return tuple(module)


def arrow_faults(files, layers):
    arrows, found = {}, []
    name = lambda module: "/".join(module) or "lib"
    for start, contents in files.items():
        used = [(path, False) for path in contents.paths] + [(path, exported) for path, _, exported in contents.uses]
        for path, exported in used:
            end = resolve(files, start, path)
            own = end is not None and end[:len(start)] == start
            if exported and not own and (end is not None or path[0].startswith("plateau_")):
                found.append(f"{name(start)} re-exports {'::'.join(path)}, which belongs elsewhere")
            if end not in (None, start) and not (own and exported):
                arrows.setdefault(name(start), set()).add(name(end))
    found += [] if arrows else ["no arrows were found"]

    def reached(file):
        seen, stack = set(), [file]
        while stack:
            more = arrows.get(stack.pop(), set()) - seen
            seen |= more
            stack += more
        return seen

    reach = {file: reached(file) for file in arrows}
    circles = {tuple(sorted(other for other in reach[file] if file in reach.get(other, ()))) for file in arrows}
    found += [f"a circle: {' <-> '.join(circle)}" for circle in sorted(circles - {()})]

    def layer(file):
        fitting = [entry for entry in layers if file == entry or file.startswith(entry + "/")]
        return layers.index(max(fitting, key=len)) if fitting else None

    for start in sorted(arrows if layers else ()):
        for end in sorted(arrows[start]):
            if layer(start) is None or layer(end) is None:
                found.append(f"{start} or {end} belongs to no layer: add it to LAYERS")
            elif layer(end) > layer(start):
                found.append(f"{start} uses the later {end}")
    return found


def ends_visibly(head, body, comment):
    """Returns whether a loop looks at the signal, counts in its head what each pass steps, or states its bound."""
    if re.search(r"\b(?:look|exec|execution|counter)\b", body):
        return True
    outer = "".join(body[k] for k, depth in brackets(body, 0) if depth == 0)
    # A pass that continues early may leave the step out.
    for number, sign in [] if re.search(r"\bcontinue\b", body) else re.findall(r"(\w+)\s*([+-])=\s*[1-9]\s*;", outer):
        if re.search(rf"\b{number}\b", head) and ("<" if sign == "+" else ">") in head:
            return True
    return bool(re.search(r"at most|\bends\b", comment, re.I) and re.search(r"\bbecause\b", comment, re.I))


def loop_faults(contents):
    lines = contents.text.split("\n")
    for found in re.finditer(r"\b(?:loop|while)\b", contents.code):
        start = next(k for k, depth in brackets(contents.code, found.end()) if contents.code[k] == "{" and depth == 0)
        line, above = contents.code.count("\n", 0, found.start()), []
        while line > len(above) and (comment := re.match(r"\s*//(.*)", lines[line - 1 - len(above)])):
            above.insert(0, comment[1])
        head, body = contents.code[found.start():start], contents.code[start + 1:item_end(contents.code, start) - 1]
        if not ends_visibly(head, body, " ".join(above)):
            yield f"line {line + 1}: let the loop look at the signal, or say above it `at most … because …`"


def main():
    root = sys.argv[1] if sys.argv[1:] else os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    crates = sorted(os.listdir(os.path.join(root, "crates")))
    folders = {name: os.path.join(root, "crates", name, "src") for name in crates if not name.endswith(".toml")}
    folders["plateau"] = os.path.join(root, "src")
    faults = [f"this script names {name}, which is no crate" for name in {*LAYERS, *WITHOUT_SOLVERS} - {*folders}]
    for name, folder in folders.items():
        files = read_crate(folder)
        faults += [f"{name}: {fault}" for fault in arrow_faults(files, LAYERS.get(name, "").split())]
        for contents in files.values():
            place = os.path.relpath(contents.file, root)
            faults += [f"{place}, {fault}" for fault in loop_faults(contents) if name not in WITHOUT_SOLVERS]
            codes = {*re.findall(r"\bStatusCode\s*::\s*([A-Z_]+)", contents.code)} - SUCCESSES
            if name == "plateau" and codes and not place.endswith("http/problem.rs"):
                faults.append(f"{place}: use a Failure of http/problem.rs instead of {', '.join(sorted(codes))}")
    print("\n".join(faults) or "no circle, no arrow back, no loop without its bound")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
