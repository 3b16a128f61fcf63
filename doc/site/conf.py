# SPDX-License-Identifier: GPL-3.0-or-later
"""The manual as a site. contrib/build-docs runs Sphinx with this file; the pages are the Markdown files of doc/ and of
the top of the repository, which stay as a forge shows them.

What a forge knows and Sphinx does not:

* Index pages are lists of links; they become the tree of the navigation. Folders with an entry a date (notebook,
  changes) are listed by themselves, the last one first.
* Links to files that are no pages lead to copies of these files in the site, headers and sources to the API.
* Symbols in sentences, such as v_n, get their subscripts.
* `Names` of classes, functions and headers lead to the API, and each class there leads back (LAHAR_BACKLINKS).
"""
import os
import pathlib
import posixpath
import re
import sys
import xml.etree.ElementTree as ElementTree

from docutils import nodes
from pygments import lexer, token
from sphinx.util import logging

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "doc" / "site"))

project = "Lahar"
version = release = re.search(r"project\(Lahar VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
copyright = "the authors of Lahar"
html_title = f"Lahar {version}"

extensions = ["myst_parser", "sphinx.ext.mathjax"]
include_patterns = ["README.md", "CONTRIBUTING.md", "CODE_OF_CONDUCT.md", "doc/**/*.md", "doc/*.md"]
exclude_patterns = ["build*", "output*", "tests", "contrib", "source", "include", "prm", ".*"]
root_doc = "doc/index"
nitpicky = True
smartquotes = False  # d' is a deviator

myst_enable_extensions = ["dollarmath"]
myst_url_schemes = ["http", "https", "mailto", "repository"]
myst_heading_anchors = 4
myst_update_mathjax = False

html_theme = "furo"
html_copy_source = html_show_sourcelink = False
html_static_path = ["site.css"]
html_css_files = ["site.css"]
templates_path = ["."]
html_sidebars = {"**": ["sidebar/scroll-start.html", "sidebar/brand.html", "sidebar/search.html",
                        "sidebar/navigation.html", "api_link.html", "sidebar/scroll-end.html"]}
# MathJax 2 as Debian has it, in the site; its SVG output needs no fonts, so pages work from a disk, too.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {"tex2jax": {"processClass": "tex2jax_process|mathjax_process|math"}, "showMathMenu": False,
                   "messageStyle": "none"}

logger = logging.getLogger(__name__)
# The order of a page's links is that of the navigation.
INDEX_PAGES = {"doc/index", "doc/theory/index", "doc/benchmarks/index"}
DATED_PAGES = {"doc/notebook/index", "doc/changes/index"}
API_PAGES = re.compile(r"doc/(theory/|architecture|extending|forces|performance)")


def is_orphan(docname):
    """Tables, which other pages show or link, and what the forge asks for."""
    return docname.endswith("_table") or docname == "CODE_OF_CONDUCT"


# ---------------------------------------------------------------------------------------------------------------------
# Links

LINK = re.compile(r"\]\(<?([^)<>\s]+)>?\)")


def outside_code(text, change):
    """The text with @p change applied to what is neither in a fenced block nor in a line of code."""
    parts = re.split(r"(^```.*?^```[ ]*$|`[^`\n]+`)", text, flags=re.M | re.S)
    # A link's text may be code, so that the brackets stand in two parts.
    return "".join(part if i % 2 else change(part) for i, part in enumerate(parts))


def navigation(docname, text):
    """Trees of the pages that the items of lists begin with, one a section."""
    trees = ""
    for section in re.split(r"^(?=## )", text, flags=re.M):
        caption = re.match(r"## (.*)", section) if docname == root_doc else None
        entries = [f"{title} </{posixpath.normpath(posixpath.join(posixpath.dirname(docname), page))}>"
                   for title, page in re.findall(r"^\* \[([^\]]+)\]\(([^):#]+)\.md\)", section, flags=re.M)]
        if entries:
            trees += "\n```{toctree}\n:hidden:\n" + (f":caption: {caption.group(1)}\n" if caption else "") + "\n"
            trees += "\n".join(entries) + "\n```\n"
    return trees


def resolve_links(app, docname, source):
    folder = posixpath.dirname(docname)

    def resolve(match):
        target, _, anchor = match.group(1).partition("#")
        if not target or re.match(r"[a-z]+:", target):
            return match.group(0)
        path = posixpath.normpath(posixpath.join(folder, target))
        anchor = "#" + anchor if anchor else ""
        if (ROOT / path).is_dir() and f"{path}/index" in app.env.found_docs:
            path, target = f"{path}/index.md", target.rstrip("/") + "/index.md"
        if path.endswith(".md") and path[:-3] in app.env.found_docs:
            return f"]({target}{anchor})"
        if re.search(r"\.(png|svg)$", path) or not (ROOT / path).exists():
            return match.group(0)
        return f"](repository:{path}{anchor})"

    text = outside_code(source[0], lambda part: LINK.sub(resolve, part))
    if docname in INDEX_PAGES:
        text += navigation(docname, text)
    if docname in DATED_PAGES:
        text += "\n```{toctree}\n:glob:\n:reversed:\n:maxdepth: 1\n\n2*\n```\n"
    if is_orphan(docname):
        text = "---\norphan: true\n---\n\n" + text
    source[0] = text


# ---------------------------------------------------------------------------------------------------------------------
# API

def read_api():
    """Addresses in the API by names, and the classes' full names."""
    addresses, classes = {}, {}
    tag_file = os.environ.get("LAHAR_TAG_FILE")
    if not tag_file:
        return addresses, classes
    ambiguous = set()

    def add(name, address):
        if addresses.setdefault(name, address) != address:
            ambiguous.add(name)

    for compound in ElementTree.parse(tag_file).getroot():
        kind, name, page = compound.get("kind"), compound.findtext("name"), compound.findtext("filename")
        if kind == "file":
            path = pathlib.Path(compound.findtext("path")).resolve() / name
            if ROOT in path.parents:
                path = path.relative_to(ROOT).as_posix()
                addresses[path] = "api/" + page
                if path.endswith(".h"):
                    add(name, "api/" + page)
                    add(path.replace("include/lahar/", ""), "api/" + page)
        elif kind in ("class", "struct", "namespace"):
            short = re.sub(r"<.*", "", name).replace("Lahar::", "")
            if kind != "namespace":
                if "<" in name:
                    continue
                add(short, "api/" + page)
                classes[short] = name
            for member in compound.findall("member"):
                if member.get("kind") in ("function", "variable", "typedef", "enumeration"):
                    address = f"api/{member.findtext('anchorfile')}#{member.findtext('anchor')}"
                    if kind == "namespace":
                        addresses.setdefault(member.findtext("name") + "()", address)
                    else:
                        addresses.setdefault(f"{short}::{member.findtext('name')}", address)
    # A name of two classes is none of either.
    return {name: address for name, address in addresses.items() if name not in ambiguous}, classes


ADDRESSES, CLASSES = read_api()
BACKLINKS = {}
FILES = set()


def relative(docname, address):
    page, _, anchor = address.partition("#")
    return posixpath.relpath(page, posixpath.dirname(docname) or ".") + ("#" + anchor if anchor else "")


def api_address(docname, text):
    name = re.sub(r"<.*?>", "", text).removesuffix("(...)")
    if name.endswith("()") and name not in ADDRESSES:
        name = name[:-2]
    if name not in ADDRESSES or "/" in name and name not in ADDRESSES:
        return None
    # One capital letter: a class, or the name of an entry; only some pages speak of classes.
    if re.fullmatch(r"[A-Z][a-z]*|[a-z_]+", name) and not (API_PAGES.match(docname) and name[0].isupper()):
        return None
    return name


def link_code(app, doctree, docname):
    for node in list(doctree.findall(nodes.reference)):
        address = node.get("refuri", "")
        if address.startswith("repository:"):
            path = address.partition(":")[2].partition("#")[0]
            if path == "include/lahar":
                node["refuri"] = relative(docname, "api/index.html")
            elif path in ADDRESSES:
                node["refuri"] = relative(docname, ADDRESSES[path])
            else:
                FILES.add(path)
                node["refuri"] = relative(docname, f"files/{path}.html")
            node["internal"] = True
    for node in list(doctree.findall(nodes.literal)):
        parents, parent = [], node.parent
        while parent is not None:
            parents.append(parent)
            parent = parent.parent
        if any(isinstance(parent, (nodes.reference, nodes.title)) for parent in parents):
            continue
        name = api_address(docname, node.astext())
        if not name:
            continue
        section = next((parent for parent in parents if isinstance(parent, nodes.section)), None)
        owner = name.partition("::")[0]
        if owner in CLASSES and section is not None and docname.startswith("doc/") and not docname.startswith("doc/changes"):
            title = section.next_node(nodes.title).astext()
            page_title = next(doctree.findall(nodes.title)).astext()
            label = page_title if title == page_title else f"{page_title}: {title}"
            BACKLINKS.setdefault(owner, {})[f"{docname}.html#{section['ids'][0]}"] = label
        link = nodes.reference("", "", internal=True, refuri=relative(docname, ADDRESSES[name]), classes=["api"])
        node.replace_self(link)
        link += node


# Symbols as they stand in sentences: v_n, R_p,I, μ_eff, τ0.
SUBSCRIPT = re.compile(r"(?<![\w/])([^\W\d_]{1,2}[\u0300-\u036f]?)_([A-Za-zρ∞0-9]+(?:,[A-Za-z]\b)?)(?!\w)|τ(0)(?!\w)")


def set_subscripts(app, doctree, docname):
    if not docname.startswith("doc/"):
        return
    for text in list(doctree.findall(nodes.Text)):
        parent = text.parent
        while parent is not None and not isinstance(parent, (nodes.literal, nodes.literal_block, nodes.math, nodes.math_block,
                                                             nodes.raw)):
            parent = parent.parent
        if parent is not None or not SUBSCRIPT.search(text):
            continue
        pieces, end = [], 0
        for match in SUBSCRIPT.finditer(text):
            pieces.append(nodes.Text(text[end:match.start()] + (match.group(1) or "τ")))
            pieces.append(nodes.subscript("", match.group(2) or match.group(3)))
            end = match.end()
        pieces.append(nodes.Text(text[end:]))
        text.parent.replace(text, [piece for piece in pieces if piece.astext()])


def write_backlinks(app, exception):
    """A page of Doxygen's that adds the manual's pages to the classes that they name."""
    path = os.environ.get("LAHAR_BACKLINKS")
    if exception or not path:
        return
    with open(path, "w", encoding="utf-8") as file:
        for name, links in sorted(BACKLINKS.items()):
            file.write(f"/** @class {CLASSES[name]}\n@par In the manual\n")
            file.write(",\n".join(f'<a href="../{address}">{label}</a>' for address, label in links.items()))
            file.write("\n*/\n\n")


# ---------------------------------------------------------------------------------------------------------------------
# Copies of files

class ParameterFile(lexer.RegexLexer):
    """Files of parameters in colours."""
    name = "prm"
    aliases = ["prm"]
    filenames = ["*.prm"]
    tokens = {"root": [
        (r"#.*$", token.Comment),
        (r"^(\s*)(subsection)(.*)$", lexer.bygroups(token.Text, token.Keyword, token.Name.Class)),
        (r"^(\s*)(end)\b", lexer.bygroups(token.Text, token.Keyword)),
        (r"^(\s*)(set)([^=\n]*)(=)", lexer.bygroups(token.Text, token.Keyword, token.Name.Attribute, token.Operator)),
        (r"^(\s*)(include)", lexer.bygroups(token.Text, token.Keyword)),
        (r"[^#\n]+|\n", token.Text)]}


def file_pages(app):
    from pygments.lexers import get_lexer_for_filename
    from pygments.util import ClassNotFound

    waiting, done = sorted(FILES), set()
    while waiting:
        path = waiting.pop()
        if path in done:
            continue
        done.add(path)
        here = f"files/{path}"
        if (ROOT / path).is_dir():
            names = sorted(child.name for child in (ROOT / path).iterdir() if not child.name.startswith((".", "__")))
            waiting += [f"{path}/{name}" for name in names]
            links = (f'<li><a href="{relative(here, f"files/{path}/{name}.html")}">{name}</a></li>' for name in names)
            body = "<ul>" + "\n".join(links) + "</ul>"
        else:
            try:
                text = (ROOT / path).read_text(encoding="utf-8")
            except UnicodeDecodeError:
                text = "(binary)"
            try:
                language = "prm" if path.endswith(".prm") else get_lexer_for_filename(path).aliases[0]
            except ClassNotFound:
                language = "python" if text.startswith("#!/usr/bin/python") else "bash" if text.startswith("#!") else "text"
            # Files that programs write may have hundreds of thousands of lines.
            lines = text.splitlines(keepends=True)
            text = "".join(lines[:2000]) + ("...\n" if len(lines) > 2000 else "")
            body = app.builder.highlighter.highlight_block(text, language, opts={}, force=True)
        yield here, {"title": path, "body": f"<h1>{path}</h1>\n{body}", "parents": []}, "page.html"


def setup(app):
    app.add_lexer("prm", ParameterFile)
    app.connect("source-read", resolve_links)
    app.connect("doctree-resolved", link_code)
    app.connect("doctree-resolved", set_subscripts)
    app.connect("html-collect-pages", file_pages)
    app.connect("build-finished", write_backlinks)
    return {"parallel_read_safe": False, "parallel_write_safe": False}
