# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures that the reports of the benchmarks have made by render.py and section.py."""

import pathlib
import shutil
import subprocess
import sys

FOLDER = pathlib.Path(__file__).resolve().parent


def draw_views(results, times, path, *options):
    """Rendered views; without VTK or a display there is a message and no picture."""
    if not shutil.which("xvfb-run"):
        print(f"Left out: {path} (no xvfb-run; Debian: apt install xvfb xauth)")
        return
    subprocess.run(["xvfb-run", "-a", sys.executable, str(FOLDER / "render.py"), str(results.directory), "--times",
                    *map(str, times), "--to", str(path), *options], check=False)


def draw_sections(results, plane, times, path, *options):
    """Sections by a plane such as 'y=0'; without VTK there is a message and no picture."""
    subprocess.run([sys.executable, str(FOLDER / "section.py"), str(results.directory), "--plane", plane, "--times",
                    *map(str, times), "--to", str(path), *options], check=False)
