#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Test what a stranger sees of the repository: links in Markdown files lead to files and headings that exist, changes are
told in three lines, and CITATION.cff and the files under .github can be read.

Usage: repository.py
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))

from program_test import check, failed  # noqa: E402

# A link or a picture that is neither an address nor in a line of code.
LINK = re.compile(r"\]\(<?([^)<>\s]+)>?\)")


def without_code(text):
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S))


def anchors(path):
    """The headings as they stand in links: lower case, words joined by -, no punctuation."""
    text = re.sub(r"^```.*?^```", "", path.read_text(encoding="utf-8"), flags=re.M | re.S)
    return {re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")
            for heading in re.findall(r"^#+ (.*)$", text, re.M)}


def check_links():
    pages = [path for folder in (".", "doc", ".github") for path in
             ((ROOT / folder).glob("*.md") if folder == "." else (ROOT / folder).rglob("*.md"))]
    check("pages are found", len(pages) > 20)
    broken = []
    for page in sorted(pages):
        for link in LINK.findall(without_code(page.read_text(encoding="utf-8"))):
            if re.match(r"[a-z]+:", link):
                continue
            name, _, anchor = link.partition("#")
            target = (page.parent / name) if name else page
            if not target.exists():
                broken.append(f"{page.relative_to(ROOT)}: {link}: no such file")
            elif anchor and target.suffix == ".md" and anchor not in anchors(target):
                broken.append(f"{page.relative_to(ROOT)}: {link}: no such heading")
    check("links lead somewhere", not broken, *broken)


def check_changes():
    """A change is told in three lines at most; what was tried and measured for it stands in the notebook."""
    long = [path.name for path in sorted((ROOT / "doc/changes").glob("2*.md"))
            if len([line for line in path.read_text(encoding="utf-8").splitlines() if line.strip()]) > 4]
    check("changes are a heading and three lines", not long, *long)


def check_yaml():
    try:
        import yaml
    except ImportError:
        print("no python3-yaml: CITATION.cff and .github are not read")
        return
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    version = re.search(r"project\(Lahar VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
    check("CITATION.cff: the program's version", str(citation["version"]) == version, citation["version"], version)
    check("CITATION.cff: who and what", citation["cff-version"] == "1.2.0" and citation["authors"] and citation["title"]
          and citation["references"])
    workflow = yaml.safe_load((ROOT / ".github/workflows/ci.yml").read_text(encoding="utf-8"))
    check("the workflow has steps", all(job["steps"] for job in workflow["jobs"].values()))
    for path in sorted((ROOT / ".github/ISSUE_TEMPLATE").glob("*.md")):
        head = yaml.safe_load(path.read_text(encoding="utf-8").split("---")[1])
        check(f"{path.name}: name and purpose", head["name"] and head["about"])


def check_scripts():
    for path in [ROOT / ".ci/run", *(ROOT / "contrib").glob("*"), *(ROOT / "contrib/utilities").glob("*")]:
        if path.is_file() and path.read_bytes().startswith(b"#!/usr/bin/env bash"):
            result = subprocess.run(["bash", "-n", str(path)], capture_output=True, text=True)
            check(f"{path.relative_to(ROOT)}: bash reads it", result.returncode == 0, result.stderr)


def check_rooms():
    """Folders of the library include each other without a circle, and those that doc/architecture.md has."""
    includes = {}
    for path in [*(ROOT / "include/lahar").glob("*/*.h"), *(ROOT / "source").glob("*/*.cc")]:
        room = includes.setdefault(path.parent.name, set())
        room |= set(re.findall(r"#include <lahar/(\w+)/", path.read_text(encoding="utf-8"))) - {path.parent.name}
    check("rooms are found", len(includes) > 8)
    left = dict(includes)
    while any(not (below & left.keys()) for below in left.values()):
        left = {room: below for room, below in left.items() if below & left.keys()}
    check("no circle among the rooms", not left, left)
    page = (ROOT / "doc/architecture.md").read_text(encoding="utf-8").split("## Rooms")[1].split("##")[0]
    rows = [set(re.findall(r"`(\w+)`", row.split("|")[1])) for row in page.splitlines() if row.startswith("| `")]
    check("doc/architecture.md has all rooms", set().union(*rows) == includes.keys(), set().union(*rows) ^ includes.keys())
    above, wrong = set(), []
    for row in rows:
        wrong += [(room, other) for room in row for other in includes.get(room, set()) if other in above]
        above |= row
    check("... and arrows go down only", not wrong, wrong)
    check("no file has more than 400 lines", not (long := [
        path.name for path in [*(ROOT / "include").rglob("*.h"), *(ROOT / "source").rglob("*.cc")]
        if path.read_text(encoding="utf-8").count("\n") > 400]), long)


def arguments_of_functions(text):
    """The names of the functions that a C++ text declares, with the numbers of their arguments."""
    text = re.sub(r'//[^\n]*|/\*.*?\*/|"(\\.|[^"\\])*"', "", text, flags=re.S)
    for name in re.finditer(r"(?<=[\w>&*:\s])(\w+)\s*\(", text):
        depth, angles, arguments, i = 1, 0, [""], name.end()
        while depth > 0 and i < len(text):
            character = text[i]
            depth += (character in "([{") - (character in ")]}")
            angles = max(0, angles + (character == "<") - (character == ">"))
            if depth == 1 and angles == 0 and character == ",":
                arguments.append("")
            elif depth > 0:
                arguments[-1] += character
            i += 1
        # In a declaration each has a type and a name.
        if all(re.fullmatch(r"\s*(const\s+)?[\w:]+(<.*>)?(::\w+)?(\s+[&*]*\w+|\s*[&*]+\s*\w+)(\s*=.*)?", argument, re.S)
               for argument in arguments):
            yield name.group(1), len(arguments)


def check_arguments():
    found = [(path.name, *function) for path in [*(ROOT / "include").rglob("*.h"), *(ROOT / "source").rglob("*.cc")]
             for function in arguments_of_functions(path.read_text(encoding="utf-8"))]
    check("functions are found", len(found) > 1500, len(found))
    check("no function has more than six arguments", not (many := [f for f in found if f[2] > 6]), many)


def members(header, name):
    """Data members of a class: what remains of its declarations without functions and types."""
    text = re.sub(r"//.*|/\*(.|\n)*?\*/", "", header.read_text(encoding="utf-8"))
    text = text[re.search(rf"\b(class|struct) {name}\s*{{", text).end():].split("\n  };")[0]
    text = re.sub(r"=\s*{[^{}]*}", "", text)
    while (without := re.sub(r"{[^{}]*}", ";", text)) != text:
        text = without
    while (without := re.sub(r"<[^<>]*>", "", text)) != text:
        text = without
    found = []
    for declaration in re.sub(r"\b(public|private|protected):", "", text).split(";"):
        names = re.sub(r"=[^,]*", "", declaration)
        if names.strip() and "(" not in names and not re.match(r"\s*(using|template|friend|static|enum)\b", names):
            found += [part.split()[-1] for part in names.split(",")]
    return found


def check_members():
    """The time step stays on one page only if what it works with are few things."""
    header = ROOT / "include/lahar/simulator/simulator.h"
    found = members(header, "Simulator")
    check("Simulator's members are found", {"&prm", "input", "problem", "time", "checkpoint"} <= set(found), found)
    check("Simulator has at most 20 members", len(found) <= 20, found)


check_links()
check_changes()
check_yaml()
check_rooms()
check_arguments()
check_members()
check_scripts()
sys.exit(1 if failed else 0)
