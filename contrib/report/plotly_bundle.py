# SPDX-License-Identifier: GPL-3.0-or-later
"""plotly's JavaScript for the page: of Debian's, which is one file of many modules, those that the page needs.

That makes the page a third as long and open twice as fast. A file of another form is taken as a whole.
"""

import importlib.util
import json
import pathlib
import re

from lahar_output import OutputError

DEBIAN = pathlib.Path("/usr/share/python3-plotly/plotly.js")
KEPT = ("scatter3d", "mesh3d")  # plots besides scatter, which is always there
# The end of a module, which names what it requires, and the beginning of the next one.
BORDER = re.compile(r"^\},(\{[^\n]*\})\],(\d+):\[function\(_dereq_,module,exports\)\{$", re.M)
FIRST = re.compile(r"\{1:\[function\(_dereq_,module,exports\)\{$", re.M)
LAST = re.compile(r"^\},(\{[^\n]*\})\]\},\{\},\[(\d+)\]\)\(\2\)\n\}\);\s*\Z", re.M)
REQUIRED_PLOT = re.compile(r"^    _dereq_\('\./(\w+)'\),\n", re.M)


def plotly_script():
    """plotly's JavaScript, where Debian's package python3-plotly has it, or where plotly for Python brings it."""
    places = [DEBIAN]
    found = importlib.util.find_spec("plotly")
    if found is not None and found.origin:
        places.append(pathlib.Path(found.origin).parent / "package_data/plotly.min.js")
    for place in places:
        if place.is_file():
            text = place.read_text(encoding="utf-8")
            return needed_modules(text) or text
    raise OutputError("plotly is missing (Debian: apt install python3-plotly)")


def needed_modules(text):
    """The bundle of the modules that are needed; None if the text does not have the form that is known."""
    first, last = FIRST.search(text), LAST.search(text)
    if not first or not last:
        return None
    modules, begin, number = {}, first.end(), 1
    for border in BORDER.finditer(text, first.end()):
        if int(border[2]) == number + 1:  # bundles in modules count otherwise
            modules[number] = text[begin:border.start()], json.loads(border[1])
            begin, number = border.end(), number + 1
    modules[number] = text[begin:last.start()], json.loads(last[1])
    entry = int(last[2])
    if entry not in modules or not all(f"./{plot}" in modules[entry][1] for plot in (*KEPT, "core")):
        return None
    body = REQUIRED_PLOT.sub(lambda plot: plot[0] if plot[1] in KEPT else "", modules[entry][0])
    modules[entry] = body, {name: other for name, other in modules[entry][1].items() if f"'{name}'" in body}

    reached, new = set(), [entry]
    while new:
        module = new.pop()
        if module not in modules:
            return None
        if module not in reached:
            reached.add(module)
            new += modules[module][1].values()
    parts = [f"{module}:[function(_dereq_,module,exports){{{modules[module][0]}}},{json.dumps(modules[module][1])}]"
             for module in sorted(reached)]
    return text[:first.start()] + "{" + ",\n".join(parts) + f"}},{{}},[{entry}])({entry})\n}});\n"
