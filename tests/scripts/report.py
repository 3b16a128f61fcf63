#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""contrib/report/lahar-report on short runs: a dam break against an elastic barrier, a softer one to compare, and a
block in space.

plain:   what stands in the page is what the runs' files say; wrong input is refused in one line with status 2.
browser: Chromium opens the pages: nothing is complained about or asked for elsewhere, and every snapshot, field and
         curve is drawn where it should be.

Usage: report.py GROUP LAHAR CHROMIUM. Exit status 77 (skipped) without numpy, matplotlib or plotly, for "browser" also
without Chromium.
"""
import base64
import gzip
import importlib.util
import json
import math
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, ".."))
sys.path.insert(0, HERE)
from browser import Browser  # noqa: E402
from program_test import ENVIRONMENT, barrier, check, failed, fluid, parts, section, wall, walls  # noqa: E402
from scripts import is_refused, last_and_first, run_script  # noqa: E402

REPORT = "report/lahar-report"
SKIPPED = 77
RUN = """
set Dimension        = %d
set Output directory = out
set End time         = %g
set Time step        = 4e-3
set Mesh size        = 0.02
set Output interval  = 0.012
set Gravity          = %s
"""
END, N_SNAPSHOTS = 0.048, 5
PLANE = RUN % (2, END, "0, -9.81") + fluid("0, 0 : 0.1, 0.14") + barrier(0.13, 0.15) + parts("Boundaries", {
    "ground": wall("0, 0.2 : 0, 0 : 0.5, 0"), "ceiling": wall("0, 0.3 : 0.5, 0.3")}) + section(
        "Postprocess", section("Point gauges", "set Points = foot: 0.05, 0.02"))
SIDES = "; ".join(["0, 0, 0 : 0.1, 0, 0 : 0.1, 0.08, 0 : 0, 0.08, 0",
                   *(f"{x}, 0, 0 : {x}, 0.08, 0 : {x}, 0.08, 0.1 : {x}, 0, 0.1" for x in (0, 0.1)),
                   *(f"0, {y}, 0 : 0.1, {y}, 0 : 0.1, {y}, 0.1 : 0, {y}, 0.1" for y in (0, 0.08))])
SPACE = RUN % (3, 0.012, "0, 0, -9.81") + fluid("0, 0, 0 : 0.06, 0.08, 0.08") + walls(SIDES)


def compute(lahar, directory, name, text, *options):
    """A run in the directory @p name; its output directory relative to @p directory."""
    folder = os.path.join(directory, name)
    os.mkdir(folder)
    with open(os.path.join(folder, "case.prm"), "w") as file:
        file.write(text)
    process = subprocess.run([lahar, "case.prm", *options], cwd=folder, env=ENVIRONMENT, stdin=subprocess.DEVNULL,
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    check(f"there is a run in {name}", process.returncode == 0, process.stderr)
    return os.path.join(name, "out")


class Page:
    """What stands in a report."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.text = file.read()
        self.data = json.loads(re.search(r'<script type="application/json" id="report">(.*?)</script>', self.text,
                                         re.S)[1])

    def block(self, name):
        return gzip.decompress(base64.b64decode(re.search(rf'id="{name}">([^<]*)<', self.text)[1]))

    def curve(self, run, column):
        data = base64.b64decode(self.data["runs"][run]["columns"][column]["y"])
        return struct.unpack(f"<{len(data) // 4}f", data)

    def walls(self, run, k):
        """The places of the walls' points in a snapshot."""
        flow = self.data["runs"][run]["flow"]
        n, dimension = flow["snapshots"][k].get("walls"), len(flow["lower"])
        block = self.block(f"snapshot-{run}-{k}") if n else base64.b64decode(self.data["runs"][run]["walls"]["points"])
        n = n or len(block) // (4 * dimension)
        numbers = struct.unpack_from(f"<{dimension * n}f", block, len(block) - 4 * dimension * n)
        return list(zip(*(numbers[d * n:(d + 1) * n] for d in range(dimension))))

    def cells(self):
        """The texts of all cells of tables, by row."""
        return [[re.sub(r"<[^>]*>", "", cell) for cell in re.findall(r"<t[dh][^>]*>(.*?)</t[dh]>", row)]
                for row in re.findall(r"<tr>(.*?)</tr>", self.text, re.S)]


def write_report(directory, name, *arguments):
    process = run_script(directory, REPORT, *arguments, "-o", name)
    check(f"lahar-report writes {name}", process.returncode == 0 and not process.stderr, process.stdout, process.stderr)
    return Page(os.path.join(directory, name))


def area(page, run, k):
    """The area of the fluid's triangles in a snapshot in the plane, as a browser would decode it."""
    flow = page.data["runs"][run]["flow"]
    head, block = flow["snapshots"][k], page.block(f"snapshot-{run}-{k}")
    n, m = head["fluid"]["points"], head["fluid"]["triangles"]
    numbers, corners = struct.unpack_from(f"<{2 * n}H", block), struct.unpack_from(f"<{3 * m}I", block, 4
                                                                                   * math.ceil(n))
    x, y = ([flow["lower"][d] + flow["size"][d] * number / 65535. for number in numbers[d * n:(d + 1) * n]] for d
            in (0, 1))
    triangles = zip(corners[:m], corners[m:2 * m], corners[2 * m:])
    return sum(0.5 * abs((x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a])) for a, b, c in triangles)


def test_contents(lahar, directory):
    plane = compute(lahar, directory, "the_plane", PLANE)
    last, first, n_steps = last_and_first(os.path.join(directory, plane, "statistics"))
    page = write_report(directory, "plane.html", plane)
    run = page.data["runs"][0]
    check("it has all snapshots", len(run["flow"]["snapshots"]) == N_SNAPSHOTS, run["flow"]["snapshots"])
    check("the last snapshot's triangles cover the fluid's volume",
          abs(area(page, 0, N_SNAPSHOTS - 1) / last["Fluid volume (m^dim)"] - 1.) < 1e-3,
          area(page, 0, N_SNAPSHOTS - 1))
    numbers = [name for name in last if name not in ("Time step number", "Time (s)")]
    check("and all columns", sorted(run["columns"]) == sorted(numbers), set(numbers) ^ set(run["columns"]))
    check("of all steps", len(page.curve(0, "front (m)")) == n_steps)
    check("as the statistics have them", abs(page.curve(0, "front (m)")[-1] / last["front (m)"] - 1.) < 1e-6)
    check("but pressures are positive where they push", first["foot pressure (Pa)"] < 0.
          and abs(page.curve(0, "foot pressure (Pa)")[0] / first["foot pressure (Pa)"] + 1.) < 1e-6,
          first["foot pressure (Pa)"])
    drawn = [name for plot in page.data["plots"] for name in plot["columns"]]
    constant = re.findall(r'<p class="note">Constant: (.*?)\.</p>', page.text)
    check("every column has a curve or is said to be constant",
          all(name in drawn or any(name.split(" (")[0] in text for text in constant) for name in numbers), drawn,
          constant)
    check("the names stand in the sketch", {"fluid", "ground", "ceiling", "barrier", "foot"}
          <= {label["text"].split(" (")[0] for label in run["labels"]}, run["labels"])
    lines = run["walls"]["lines"]
    check("two walls are drawn", len(lines) == 2 and abs(page.walls(0, 0)[lines[1][0]][1] - 0.3) < 1e-6, run["walls"])
    rows = page.cells()
    check("entries that differ from the defaults are listed, with the defaults", ["Mesh size", "0.02", "0.01"] in rows,
          rows)
    check("and others are not", not any(row[0] == "Largest movement" for row in rows if row))
    check("nor where the run is kept", "Output directory" not in page.text)

    force = [dict(zip(next(r for r in rows if r[:1] == ["force"]), row)) for row in rows if len(row) == 8 and row[1]
             == "y"]
    with open(os.path.join(directory, plane, "statistics")) as file:
        names = [line.split(":", 1)[1].strip() for line in file if line.startswith("#")]
        file.seek(0)
        table = [dict(zip(names, map(float, line.split()))) for line in file if line.strip()
                 and not line.startswith("#")]
    values = [line["ground force y (N)"] for line in table]
    shown = [float(row["impulse (N s/m)"].replace("−", "-")) for row in force if row["force"] == ""]
    impulse = sum(line["ground force y (N)"] * line["Time step size (s)"] for line in table)
    check("the impulse on the ground is the sum of force times step", any(abs(x / impulse - 1.) < 1e-3 for x in shown),
          impulse, force)
    peaks = [float(row["peak (N/m)"].replace("−", "-")) for row in force]
    check("its peak the largest of the column", any(abs(x / max(values, key=abs) - 1.) < 1e-3 for x in peaks), force)
    check("times by phase are those of the log", any(row and row[0] == "Remesh" for row in rows), rows)

    soft = compute(lahar, directory, "soft", PLANE, "--set", "Fluids/fluid/Bingham/Yield stress=10")
    comparison = write_report(directory, "comparison.html", f"{plane}=a <stiff> one", f"{soft}=soft")
    check("two runs are compared over what differs", comparison.data["sweep"]["parameters"][0] ==
          {"name": "Fluids/fluid/Bingham/Yield stress", "values": ["100", "10"]},
          comparison.data["sweep"]["parameters"])
    ends = next(m["values"] for m in comparison.data["sweep"]["measures"] if m["name"] == "front: at the end")
    other, _, _ = last_and_first(os.path.join(directory, soft, "statistics"))
    check("by values at the end", [round(x, 9) for x in ends] == [round(x["front (m)"], 9) for x in (last, other)],
          ends)
    check("names are written as they are, not as tags", "<stiff>" not in comparison.text and "&lt;stiff&gt;"
          in comparison.text)

    space = compute(lahar, directory, "space", SPACE)
    page = write_report(directory, "space.html", space)
    surface = page.data["runs"][0]["flow"]["snapshots"][0]["fluid"]
    check("in space the outside is there: by Euler two triangles a point, less four",
          surface["triangles"] == 2 * surface["points"] - 4 and surface["triangles"] > 100, surface)
    page = write_report(directory, "few.html", plane, "--snapshots", "2")
    times = [s["time"] for s in page.data["runs"][0]["flow"]["snapshots"]]
    check("of few snapshots the first and the last remain", times == [0., END], times)
    return plane, space


def test_refused(directory, plane, space):
    def refused(what, words, *arguments):
        process = run_script(directory, REPORT, *arguments, "-o", "refused.html")
        check(f"{what} is refused", is_refused(process, *words), process.returncode, process.stderr)
        check("... and nothing is written", not os.path.exists(os.path.join(directory, "refused.html")))

    def changed(name, change):
        shutil.copytree(os.path.join(directory, plane), os.path.join(directory, name))
        change(os.path.join(directory, name))
        return name

    def damage(name, keep):
        def change(folder):
            with open(os.path.join(folder, name), "r+") as file:
                text = file.read()
                file.seek(0)
                file.truncate()
                file.write(keep(text))
        return change

    refused("a directory that is not there", ["nowhere", "allowed"], "nowhere")
    refused("one without a run", ["parameters.prm", "allowed"], ".")
    refused("a run without a step", ["statistics", "step"], changed("no_step", damage("statistics", lambda text: "")))
    refused("a run without statistics", ["statistics"], changed("no_statistics",
                                                                lambda f: os.remove(os.path.join(f, "statistics"))))
    refused("a run without snapshots", ["solution.pvd", "allowed"], changed("no_snapshot", damage(
        "solution.pvd", lambda text: re.sub("<DataSet.*\n", "", text))))
    refused("a snapshot that is gone", ["solution-00002.vtu"],
            changed("gone", lambda folder: os.remove(os.path.join(folder, "solution-00002.vtu"))))
    for name, keep in (("half", lambda text: text[:len(text) // 2]), ("empty", lambda text: ""),
                       ("changed", overwritten),
                       ("cells", lambda text: text.replace('NumberOfCells="', 'NumberOfCells="1'))):
        refused(f"a snapshot that is damaged ({name})", ["solution-00001.vtu"],
                changed("damaged_" + name, damage("solution-00001.vtu", keep)))
    refused("damaged walls", ["walls.vtu"], changed("damaged_walls", damage("walls.vtu", lambda text: text[:300])))
    refused("runs in the plane and in space", ["Dimension", "allowed"], plane, space)
    refused("one name twice", ["same", "allowed"], f"{plane}=same", "soft/out=same")
    refused("one run twice", ["the_plane/out", "allowed"], plane, plane)
    refused("one snapshot", ["--snapshots"], plane, "--snapshots", "1")
    process = run_script(directory, REPORT, plane, "-o", "report.pdf")
    check("a report that is no page is refused", is_refused(process, "report.pdf", "html"), process.stderr)

    def goes_on(folder):
        with open(os.path.join(folder, "lock"), "w") as file:
            file.write("host here\nprocess 1\nsince today\n")
        with open(os.path.join(folder, "statistics"), "a") as file:
            file.write("     13  5.2e-02")
    page = write_report(directory, "unfinished.html", changed("unfinished", goes_on))
    check("a run that goes on has a report of what is there, and it says so", "unfinished"
          in page.text.split("<main>")[0])


def overwritten(text):
    """A snapshot whose points are not what was compressed."""
    begin = text.index('format="binary">') + 60
    return text[:begin] + "A" * 40 + text[begin + 40:]


def colours(path):
    """How many colours a picture has, and the share of the commonest one."""
    import matplotlib.image
    import numpy as np
    pixels = (matplotlib.image.imread(path)[..., :3] * 255).round().astype(np.int64) @ [65536, 256, 1]
    counts = np.unique(pixels, return_counts=True)[1]
    return len(counts), counts.max() / counts.sum()


def show(browser, k, field):
    """Moves the slider and the menu as a user does, and waits until the flow is drawn."""
    browser.evaluate(f"""(() => {{
      const slider = document.getElementById("slider"), menu = document.getElementById("field");
      menu.value = "{field}"; menu.dispatchEvent(new Event("change"));
      slider.value = {k}; slider.dispatchEvent(new Event("input")); }})()""")
    check(f"snapshot {k}, {field}, is drawn",
          browser.wait_for(f'document.getElementById("look").dataset.drawn === "{k} {field}"'))


def test_page(browser, path, view, what_is_drawn, n_snapshots):
    name = os.path.basename(path)
    check(f"{name} opens", browser.open(path) is not None, browser.errors)
    pictures, drawn, labels = {}, {}, set()
    for field in ("speed", "pressure", "yielded"):
        for k in (0, n_snapshots - 1):
            show(browser, k, field)
            drawn[k, field] = browser.evaluate(what_is_drawn)
            labels.add(browser.evaluate('document.getElementById("time").textContent'))
            browser.evaluate('document.getElementById("look").scrollIntoView()')
            picture = path + f"-{k}-{field}.png"
            browser.screenshot(picture)
            with open(picture, "rb") as file:
                pictures[k, field] = file.read()
            n, share = colours(picture)
            check(f"{name}: something is to be seen", n > (20 if field == "yielded" else 150) and share < 0.97, n,
                  share)
    check(f"{name}: the label says which time it is", len(labels) == 2 and any("t = 0 s" in text for text in labels),
          labels)
    last = n_snapshots - 1
    check(f"{name}: the flow moves", drawn[0, "speed"] != drawn[last, "speed"])
    check(f"{name}: pictures differ by time and field", len(set(pictures.values())) >= 5, len(set(pictures.values())))
    check(f"{name}: it opens at the place in its address", browser.open(path, "#snapshot=1&field=pressure") is not None
          and browser.evaluate('document.getElementById("slider").value + document.getElementById("field").value')
          == "1pressure")
    browser.evaluate('document.querySelectorAll("[data-plot], .sketch").forEach(d => d.scrollIntoView())')
    n_frames = browser.evaluate('document.querySelectorAll("[data-plot]").length')
    curves = ('[...document.querySelectorAll("[data-plot]")].filter(d => d.querySelector(".scatterlayer .js-line"))'
              '.length')
    for i in range(n_frames):
        browser.evaluate(f'document.querySelectorAll("[data-plot]")[{i}].scrollIntoView()')
        browser.wait_for(f'!!document.querySelectorAll("[data-plot]")[{i}].querySelector(".scatterlayer .js-line")')
    check(f"{name}: every frame has a curve", n_frames > 5 and browser.evaluate(curves) == n_frames, n_frames,
          browser.evaluate(curves))
    browser.evaluate('document.querySelector(".sketch").scrollIntoView()')
    check(f"{name}: the case is sketched with names", browser.wait_for(
        '[...document.querySelectorAll(".sketch .annotation-text, .sketch .annotation text")]'
        '.some(text => text.textContent.includes("no slip"))'))
    for width in (1900, 620):
        browser.resize(width, 900)
        picture = f"document.getElementById('{view}').querySelector('.svg-container')"
        fits = f"document.documentElement.scrollWidth <= {width} && {picture}.clientWidth <= {width}"
        check(f"{name}: it fits into {width} pixels", browser.wait_for(fits),
              browser.evaluate("document.documentElement.scrollWidth"))
    browser.resize(1280, 900)
    check(f"{name}: nobody complains", not browser.errors
          and browser.evaluate('document.getElementById("complaint").hidden'), browser.errors)


def test_browser(lahar, chromium, directory):
    plane = compute(lahar, directory, "the_plane", PLANE)
    soft = compute(lahar, directory, "soft", PLANE, "--set", "Fluids/fluid/Bingham/Yield stress=10")
    space = compute(lahar, directory, "space", SPACE)
    write_report(directory, "plane.html", plane, soft)
    write_report(directory, "space.html", space)
    with Browser(chromium) as browser:
        test_page(browser, os.path.join(directory, "plane.html"), "flow-0",
                  'document.getElementById("flow-0").data[0].x.slice(0, 50).join()', N_SNAPSHOTS)
        sweep = 'document.getElementById("sweep").data[0].y.join()'
        before = browser.evaluate(sweep)
        browser.evaluate('(() => { const menu = document.getElementById("sweep-measure"); '
                         'menu.selectedIndex = menu.length - 3; menu.dispatchEvent(new Event("change")); })()')
        check("another value is compared", browser.wait_for(f"{sweep} !== {json.dumps(before)}"))
        test_page(browser, os.path.join(directory, "space.html"), "flow-0",
                  'Array.from(document.getElementById("flow-0").data[0].z).join()', 2)

        # What the test would say of a page that cannot be drawn.
        broken = os.path.join(directory, "broken.html")
        with open(os.path.join(directory, "plane.html"), encoding="utf-8") as file:
            text = file.read()
        with open(broken, "w", encoding="utf-8") as file:
            file.write(re.sub(r'(id="snapshot-0-0">)[^<]{40}', r"\1" + "A" * 40,
                              text).replace("Math.floor(0.4 *", "Math.floor(0. *"))
        check("a page with damaged data complains", browser.open(broken) is None
              and not browser.evaluate('document.getElementById("complaint").hidden'))


def skip_without(*modules):
    for module in modules:
        if not importlib.util.find_spec(module):
            print(f"not tested: {module} is missing")
            sys.exit(SKIPPED)


def run_tests(test, chromium, *modules):
    """Call test(directory, browser), with None where there is no Chromium, and exit with 1 if a check has failed."""
    skip_without(*modules)
    with tempfile.TemporaryDirectory() as directory:
        if os.path.isfile(chromium):
            with Browser(chromium) as browser:
                test(directory, browser)
        else:
            test(directory, None)
    sys.exit(1 if failed else 0)


def main():
    group, lahar, chromium = sys.argv[1], os.path.abspath(sys.argv[2]), sys.argv[3]
    skip_without("numpy", "matplotlib", "plotly")
    if group == "browser" and not os.path.isfile(chromium):
        print("not tested in a browser: there is no Chromium")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as directory:
        if group == "plain":
            test_refused(directory, *test_contents(lahar, directory))
        else:
            test_browser(lahar, chromium, directory)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
