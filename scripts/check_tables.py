#!/usr/bin/env python3
"""Holds the tables of the documents together with the commands that print them.

    PLATEAU_URL=http://127.0.0.1:8080 python3 scripts/check_tables.py [--write] [DOCUMENT …]

A table belongs to the line above it that begins with "Rebuilt by" and has the command in backquotes, and a tolerance
in per cent ("to 0.1%"); further tables of the document share it until the next such line. The command's output has a
table with the same first row. Its cells must be equal in their words, and its numbers within the tolerance or one unit
of the last digit in the document. Numbers with an exponent are orders of magnitude and may differ by a factor of three, those below 1e-7 by any.
Columns headed with time or seconds are not compared. Each command runs once, in the root of the project.
--write puts the output into the documents.
"""
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
REBUILT = re.compile(r"^Rebuilt by `([^`]+)`[^.]*?to ([\d.]+)%")
NUMBER = re.compile(r"[-+]?\d[\d,]*(?:\.\d+)?(?:e[-+]?\d+)?")
# Numbers with an exponent below this are rounding.
ROUNDING = 1e-7
# The longest command: nine seeds of fifteen boundaries by seven solvers.
PATIENCE = 900


def tables_of(lines):
    """Numbers of the first and the last line of each table, end excluded."""
    found, start = [], None
    for k, line in enumerate([*lines, ""]):
        if line.startswith("|"):
            start = k if start is None else start
        elif start is not None:
            found.append((start, k))
            start = None
    return found


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def value(text):
    return float(text.replace(",", ""))


def unit(text):
    """One unit of the last digit of a number."""
    mantissa, _, exponent = text.partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 10.0 ** (int(exponent or 0) - decimals)


def differs(document, output, tolerance):
    if NUMBER.sub("#", document) != NUMBER.sub("#", output):
        return True
    for a, b in zip(NUMBER.findall(document), NUMBER.findall(output)):
        x, y = value(a), value(b)
        if "e" in a or "e" in b:
            if max(abs(x), abs(y)) > ROUNDING and not (x * y > 0 and 1 / 3 <= x / y <= 3):
                return True
        elif abs(x - y) > max(tolerance * abs(x), 1.001 * max(unit(a), unit(b)) if "." in a else 0):
            return True
    return False


def compare(document, output, tolerance):
    """The differences between two tables with the same first row."""
    if len(document) != len(output):
        return [f"{len(document) - 2} rows in the document, {len(output) - 2} in the output"]
    columns, found = cells(document[0]), []
    for a, b in zip(document[2:], output[2:]):
        for name, x, y in zip(columns, cells(a), cells(b)):
            if not re.search("time|seconds", name) and differs(x, y, tolerance):
                found.append(f"{cells(a)[0]}, {name}: {x} in the document, {y} in the output")
    return found


def check(path, outputs, write):
    with open(path, encoding="utf-8") as file:
        lines = file.read().split("\n")
    faults, rule, read, changed, edits = [], None, 0, [], []
    for start, end in tables_of(lines):
        for line in lines[read:start]:
            rule = REBUILT.match(line) or rule
        read = end
        if rule is None:
            continue
        command, tolerance = rule.group(1), float(rule.group(2)) / 100
        if command not in outputs:
            done = subprocess.run(command, shell=True, cwd=ROOT, capture_output=True, text=True, timeout=PATIENCE)
            if done.returncode:
                raise SystemExit(f"{path}: {command} fails:\n{done.stderr[-2000:]}")
            printed = done.stdout.split("\n")
            outputs[command] = [printed[a:b] for a, b in tables_of(printed)]
        # Tables of the same first row follow each other in the document as in the output.
        same = [table for table in outputs[command] if cells(table[0]) == cells(lines[start])]
        before = sum(1 for name, head in changed if (name, head) == (command, cells(lines[start])))
        changed.append((command, cells(lines[start])))
        where = f"{os.path.relpath(path, ROOT)}:{start + 1}"
        if before >= len(same):
            faults.append(f"{where}: {command} prints no such table")
        elif write:
            edits.append((start, end, same[before]))
        else:
            faults += [f"{where}: {text}" for text in compare(lines[start:end], same[before], tolerance)]
    for start, end, table in reversed(edits):
        lines[start:end] = table
    if write:
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(lines))
    return faults, len(changed)


def documents():
    for folder, _, names in os.walk(os.path.join(ROOT, "docs")):
        yield from (os.path.join(folder, name) for name in sorted(names) if name.endswith(".md"))


def main():
    write = "--write" in sys.argv
    paths = [os.path.abspath(name) for name in sys.argv[1:] if name != "--write"] or sorted(documents())
    outputs, faults, count = {}, [], 0
    for path in paths:
        found, number = check(path, outputs, write)
        faults, count = faults + found, count + number
    for fault in faults:
        print(fault)
    print(f"{count} tables of {len(paths)} documents, {len(faults)} differences")
    sys.exit(1 if faults or not count else 0)


if __name__ == "__main__":
    main()
