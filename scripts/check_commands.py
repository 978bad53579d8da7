#!/usr/bin/env python3
"""Runs the commands of the documents, as a reader types them.

    PLATEAU_URL=http://127.0.0.1:8080 python3 scripts/check_commands.py [DOCUMENT …]
    python3 scripts/check_commands.py --programs [DOCUMENT …]

Commands that talk to the service: the blocks marked `sh` that have a request for it run one after another in one shell,
page by page, in an empty folder that has copies of api/examples, benches/papers and scripts/check_certificate.py. A
block must end with status 0, and each file that it writes must hold the kind of data that its ending names: a reader
who follows a page ends with files that open. Git must ignore these files, because the reader is in a checkout.

Programs (--programs): the commands in the text that print figures, which are `cargo run` with an example, `cargo test`
with a test and `cargo bench`, run in the root of the project. Each must end with status 0, and must leave the files of
docs/ as they are: the pictures there are those that the commands draw.
"""
import glob
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import zipfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PRINTED = "http://127.0.0.1:8080"
SERVICE = os.environ.get("PLATEAU_URL", PRINTED).rstrip("/")
BLOCK = re.compile(r"^```sh\n(.*?)^```", re.S | re.M)
ASKS = (PRINTED, "$PLATEAU_URL", "$job")
DOCUMENTS = ["README.md", *(f"docs/{name}.md" for name in (
    "minimal-surfaces", "ruled-surfaces", "uniform-meshes", "tensile-structures", "cable-nets", "certificates",
    "clients", "workshop")), "benches/papers/README.md"]
COPIED = ("api/examples", "benches/papers", "scripts/check_certificate.py")
# Seconds for a page; the longest wait that a command asks for is 60, and the papers' examples take a minute in all.
PATIENCE = 300
PROGRAM = re.compile(r"`(cargo (?:run [^`]*--example|test [^`]*--test|bench) [^`>]*)`")
# Seconds. The longest program draws the pictures, and compiles the solvers before.
PATIENCE_WITH_PROGRAMS = 3600


def blocks(text):
    """The commands that ask the service."""
    return [block for block in BLOCK.findall(text) if any(word in block for word in ASKS)]


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
        "pdf": lambda: data.startswith(b"%PDF-") and data.rstrip().endswith(b"%%EOF"),
        "zip": lambda: zipfile.ZipFile(path).testzip() is None,
    }
    return None if ending not in opens or opens[ending]() else "it does not hold what its name says"


def check(document):
    """The number of commands of a document, and their faults."""
    with open(os.path.join(ROOT, document), encoding="utf-8") as file:
        commands, faults = blocks(file.read()), []
    with tempfile.TemporaryDirectory() as folder:
        for name in COPIED:
            copy = shutil.copytree if os.path.isdir(os.path.join(ROOT, name)) else shutil.copy
            os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
            copy(os.path.join(ROOT, name), os.path.join(folder, name))
        before = set(os.listdir(folder))
        script = "".join(f"block={number}\n{command}\n" for number, command in enumerate(commands, 1))
        script = "trap 'echo in command $block' EXIT\n" + script.replace(PRINTED, SERVICE)
        done = subprocess.run(["bash", "-e", "-c", script], cwd=folder, timeout=PATIENCE,
                              capture_output=True, text=True, env={**os.environ, "PLATEAU_URL": SERVICE})
        if done.returncode:
            faults.append(f"{document}: ends with {done.returncode}: {(done.stderr + done.stdout)[-500:]}")
        for name in sorted(set(os.listdir(folder)) - before):
            if subprocess.run(["git", "check-ignore", "--quiet", "--no-index", name], cwd=ROOT).returncode:
                faults.append(f"{document}: {name} is left in the checkout")
            path = os.path.join(folder, name)
            text = fault(path) if os.path.isfile(path) else None
            if text:
                faults.append(f"{document}: {name}: {text}")
    if not commands:
        faults.append(f"{document} has no command that asks the service")
    return len(commands), faults


def documents():
    """Every document of the project's users and maintainers."""
    found = [os.path.relpath(path, ROOT) for path in glob.glob(os.path.join(ROOT, "docs", "**", "*.md"), recursive=True)]
    return ["README.md", "CONTRIBUTING.md", *sorted(found)]


def changed():
    return subprocess.run(["git", "diff", "--stat", "--", "docs"], cwd=ROOT, capture_output=True, text=True, check=True).stdout


def check_programs(names):
    """The number of programs, and their faults."""
    commands, faults = {}, []
    for document in names:
        with open(os.path.join(ROOT, document), encoding="utf-8") as file:
            for command in PROGRAM.findall(file.read()):
                # A command that writes a file anew is for the maintainer who has changed what it holds.
                if "PLATEAU_WRITE" not in command and "UPDATE_FROZEN" not in command:
                    commands.setdefault(command, document)
    for command, document in commands.items():
        print(f"{document}: {command}", flush=True)
        before = changed()
        try:
            done = subprocess.run(shlex.split(command), cwd=ROOT, timeout=PATIENCE_WITH_PROGRAMS, capture_output=True, text=True)
        except subprocess.TimeoutExpired:
            faults.append(f"{document}: {command} does not end in {PATIENCE_WITH_PROGRAMS} s")
            continue
        if done.returncode:
            faults.append(f"{document}: {command} ends with {done.returncode}: {(done.stdout + done.stderr)[-2000:]}")
        elif changed() != before:
            faults.append(f"{document}: {command} changes files:\n{changed()}")
    return len(commands), faults


def main():
    arguments = sys.argv[1:]
    programs = "--programs" in arguments
    names = [name for name in arguments if name != "--programs"]
    if programs:
        count, faults = check_programs(names or documents())
    else:
        checked = [check(document) for document in names or DOCUMENTS]
        count, faults = sum(count for count, _ in checked), [fault for _, found in checked for fault in found]
    for text in faults:
        print(text)
    print(f"{count} commands, {len(faults)} faults")
    sys.exit(1 if faults or count == 0 else 0)


if __name__ == "__main__":
    main()
