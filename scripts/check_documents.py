"""Checks that every file that documents and migrations name exists, and that each paper's page names the command that
prints its tables. The changelog may name what is gone. `npm run links` checks the links."""
import os
import re
import subprocess
import sys

ELSEWHERE = {"cablenet.md", "film.ts", "src/hops/RemoteDefinition.cs", "HopsComponent.cs"}
FILE = re.compile(r"(?:.*/)?[^/]+\.(?:rs|md|py|sql|mjs|ts|toml|jsonl|txt|json|css|html|yml|yaml|sh|cs|png)")
os.chdir(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
listed = subprocess.check_output(["git", "ls-files", "-co", "--exclude-standard"], text=True)
files = [path for path in listed.split("\n") if os.path.isfile(path)]
paths = {*files, *(path[:k] for path in files for k, c in enumerate(path) if c == "/")}
every, folders = "\n".join(sorted(paths)), {path.partition("/")[0] for path in files if "/" in path}


def expanded(word):
    found = re.match(r"(.*?)\{(.*?,.*?)\}(.*)", word)
    return [more for part in found[2].split(",") for more in expanded(found[1] + part + found[3])] if found else [word]


def exists(word, document):
    beside = re.escape(os.path.normpath(os.path.join(os.path.dirname(document), word)))
    return re.search(rf"^((.*/)?{re.escape(word)}|{beside})$".replace(r"\*", "[^/\n]*"), every, re.M)


faults = []
for document in files:
    if not re.fullmatch(r"(?!CHANGELOG).*\.md|migrations/.*\.sql", document):
        continue
    text = open(document, encoding="utf-8").read()
    for word in {more.split("#")[0].rstrip(".,:/") for more in re.split(r"[\s`()\[\]\"'<>;|=]+", text)}:
        for name in expanded(word) if "://" not in word and (word[:3] == "../" or word[:1] not in "/-$.@") else []:
            named = FILE.fullmatch(name) or "/" in name and name.split("/")[0] in folders
            if named and re.fullmatch(r"[\w./*+-]+", name) and name not in ELSEWHERE and not exists(name, document):
                faults.append(f"{document} names {name}, and there is no such file")
    paper = re.fullmatch(r"docs/papers/(?!README)(.*)\.md", document)
    if paper and f"\nRebuilt by `python3 benches/papers/tables.py {paper[1]}`" not in text.split("\n| --- |")[0]:
        faults.append(f"{document} does not name the command that prints its tables")
sys.exit("\n".join(sorted(faults)) or 0)
