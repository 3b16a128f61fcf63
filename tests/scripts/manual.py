#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""contrib/build-docs makes the site without a warning, and what its pages refer to is there: pages and headings,
figures, scripts and styles, all of them in the site itself. Manual and API lead to each other.

Usage: manual.py
"""
import html.parser
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))

from program_test import ENVIRONMENT, check, failed  # noqa: E402

SKIPPED = 77
NEEDED = ("doxygen", "furo", "myst_parser", "sphinx", "/usr/share/javascript/mathjax/MathJax.js")


def missing():
    """What of the site's tools is not there; the test installs nothing."""
    return [name for name in NEEDED if not (pathlib.Path(name).exists() if name.startswith("/") else
                                            shutil.which(name) or importlib.util.find_spec(name))]


class Page(html.parser.HTMLParser):
    """Names of a page's places, what it links to and what it loads."""

    def __init__(self, text):
        super().__init__()
        self.places, self.links, self.parts = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.places |= {attributes[name] for name in ("id", "name") if attributes.get(name)}
        if tag in ("a", "area") and attributes.get("href"):
            self.links.append(attributes["href"])
        if tag == "link" and "stylesheet" in (attributes.get("rel") or ""):
            self.parts.append(attributes["href"])
        if tag in ("script", "img", "iframe", "object") and attributes.get("src"):
            self.parts.append(attributes["src"])


def read_pages(site):
    return {path: Page(path.read_text(encoding="utf-8")) for path in site.rglob("*.html") if "mathjax" not in path.parts}


def check_references(site, pages):
    broken, far = [], []
    for path, page in pages.items():
        for reference in page.links + page.parts:
            url = urllib.parse.urlsplit(reference)
            if url.scheme or url.netloc:
                if url.netloc and reference in page.parts:
                    far.append(f"{path.relative_to(site)}: {reference}")
                continue
            # Links that scripts fill; Doxygen's summary of a class whose nested classes are private.
            if reference in ("#", "#nested-classes"):
                continue
            target = (path.parent / urllib.parse.unquote(url.path)).resolve() if url.path else path
            place = urllib.parse.unquote(url.fragment)
            if not target.exists():
                broken.append(f"{path.relative_to(site)}: {reference}: no such file")
            elif place and target in pages and place not in pages[target].places:
                broken.append(f"{path.relative_to(site)}: {reference}: no such place")
    check("links, figures and scripts lead somewhere", not broken, len(broken), *broken[:20])
    check("nothing is loaded from a network", not far, *far[:20])


def check_contents(site, pages):
    manual = [page for path, page in pages.items() if site / "doc" in path.parents]
    check("all pages of the manual are there", len(manual) == len(list((ROOT / "doc").rglob("*.md"))), len(manual))
    to_api = {link.partition("#")[0] for page in manual for link in page.links if "/api/class" in link}
    check("the manual names classes of the API", len(to_api) > 60, len(to_api))
    back = [path for path, page in pages.items() if path.parent.name == "api" and path.name.startswith(("class", "struct"))
            and any(link.startswith("../doc/") and "#" in link for link in page.links)]
    check("and the API names places of the manual", len(back) > 60, len(back))
    formulas = (site / "doc/theory/time-integration.html").read_text(encoding="utf-8")
    check("formulas are marked for MathJax, which is there", len(re.findall(r'<div class="math', formulas)) > 3
          and "_static/mathjax/MathJax.js" in formulas and (site / "_static/mathjax/jax/output/SVG/jax.js").exists())
    index = (site / "searchindex.js").read_text(encoding="utf-8")
    check("the search knows the pages", "doc/theory/stabilisation" in index and "papanastas" in index)


def check_wrong_page(directory):
    """A link into the void does not pass: the site of a copy of the pages with one."""
    copy = pathlib.Path(directory) / "copy"
    for name in ("doc", "contrib", "include", "source", "prm", "tests"):
        shutil.copytree(ROOT / name, copy / name, ignore=shutil.ignore_patterns("*.vtu", "__pycache__"))
    for path in ROOT.glob("*"):
        if path.is_file():
            shutil.copy(path, copy)
    with open(copy / "doc/limits.md", "a", encoding="utf-8") as file:
        file.write("\nA [link](theory/volume.md#no-such-heading).\n")
    process = build(copy, pathlib.Path(directory) / "wrong")
    check("a link to a heading that is not there ends it with status 1", process.returncode == 1 and
          "no-such-heading" in process.stderr, process.returncode, process.stderr[-2000:])


def build(root, directory):
    return subprocess.run([root / "contrib/build-docs", directory], env=ENVIRONMENT, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def main():
    if missing():
        print("not tested, as these are missing:", *missing())
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as directory:
        process = build(ROOT, pathlib.Path(directory) / "docs")
        check("the site is made without a warning", process.returncode == 0 and not process.stderr, process.stderr[-4000:])
        site = (pathlib.Path(directory) / "docs/site").resolve()
        pages = read_pages(site)
        check_references(site, pages)
        check_contents(site, pages)
        check_wrong_page(directory)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
