#!/usr/bin/env python3
"""Runs the commands of the documents that talk to the service, as a reader types them.

    PLATEAU_URL=http://127.0.0.1:8080 python3 scripts/check_commands.py [DOCUMENT …]

The blocks marked `sh` that have a request for http://127.0.0.1:8080 run one after another, page by page, in an empty
folder that has a copy of api/examples. A block must end with status 0, and each file that it writes must hold the kind
of data that its ending names: a reader who follows a page ends with files that open.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PRINTED = "http://127.0.0.1:8080"
SERVICE = os.environ.get("PLATEAU_URL", PRINTED).rstrip("/")
BLOCK = re.compile(r"^```sh\n(.*?)^```", re.S | re.M)
DOCUMENTS = ["README.md", *(f"docs/{name}.md" for name in (
    "minimal-surfaces", "ruled-surfaces", "uniform-meshes", "tensile-structures", "cable-nets"))]
# Seconds; the longest wait that a command asks for is 60.
PATIENCE = 120


def blocks(text):
    """The commands that ask the service."""
    return [block for block in BLOCK.findall(text) if PRINTED in block or "$job" in block]


def fault(path):
    """Why a file does not hold what its ending names."""
    with open(path, "rb") as file:
        data = file.read()
    ending = path.rpartition(".")[2]
    if ending == "job":
        job = json.loads(data)
        return None if job.get("status") == "succeeded" else f"the job is {job.get('status')}: {job.get('error')}"
    opens = {
        "glb": lambda: data[:4] == b"glTF" and int.from_bytes(data[8:12], "little") == len(data),
        "obj": lambda: b"\nv " in data and (b"\nf " in data or b"\nl " in data),
        "dxf": lambda: b"SECTION" in data and data.rstrip().endswith(b"EOF"),
        "svg": lambda: b"<svg" in data and data.rstrip().endswith(b"</svg>"),
        "csv": lambda: len(data.splitlines()) > 1,
    }
    return None if ending not in opens or opens[ending]() else "it does not hold what its name says"


def check(document):
    """The number of commands of a document, and their faults."""
    with open(os.path.join(ROOT, document), encoding="utf-8") as file:
        commands, faults = blocks(file.read()), []
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(os.path.join(ROOT, "api/examples"), os.path.join(folder, "api/examples"))
        for number, command in enumerate(commands, 1):
            done = subprocess.run(["bash", "-e", "-c", command.replace(PRINTED, SERVICE)], cwd=folder, timeout=PATIENCE,
                                  capture_output=True, text=True)
            if done.returncode:
                faults.append(f"{document}: command {number} ends with {done.returncode}: {(done.stdout + done.stderr)[-500:]}")
        for name in sorted(os.listdir(folder)):
            path = os.path.join(folder, name)
            text = fault(path) if os.path.isfile(path) else None
            if text:
                faults.append(f"{document}: {name}: {text}")
    if not commands:
        faults.append(f"{document} has no command that asks the service")
    return len(commands), faults


def main():
    count, faults = 0, []
    for document in sys.argv[1:] or DOCUMENTS:
        number, found = check(document)
        count, faults = count + number, faults + found
    for text in faults:
        print(text)
    print(f"{count} commands, {len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
