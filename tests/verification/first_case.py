#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The case of doc/first-case.md: the page has the file's lines; mud runs down a slope and meets a barrier, which feels
nothing before and no pull; the volume is kept.
"""

import re

from verification import CASES, Check, read_run, run_check, volume_changes

ROOT = CASES.parents[1]
MESH_SIZE, BARRIER = 0.04, 0.3


def check_page(check):
    """Blocks of the page that are lines of a parameter file stand in the case's file, and all of its lines on the page."""
    case = [line.strip() for line in (ROOT / "prm/first_case.prm").read_text(encoding="utf-8").splitlines()]
    blocks = re.findall(r"^```prm\n(.*?)^```", (ROOT / "doc/first-case.md").read_text(encoding="utf-8"), re.M | re.S)
    blocks = [[line.strip() for line in block.splitlines()] for block in blocks]
    strange = [block for block in blocks if not any(case[i:i + len(block)] == block for i in range(len(case)))]
    check.below("blocks of the page that the file does not have", len(strange), 0.)
    shown = {line for block in blocks for line in block}
    hidden = [line for line in case if line not in shown and not line.startswith("#")]
    check.below("lines of the file that the page does not have", len(hidden), 0., f"{hidden[:3]} ")


def check_run(check):
    statistics = read_run(check.run("../first_case.prm", f"Mesh size={MESH_SIZE}", "End time=0.95"))
    front, force = statistics["front (m)"], statistics["barrier force x (N)"]
    check.below("force on the barrier before the mud is there (N)", abs(force[front < BARRIER - 2. * MESH_SIZE]).max(), 0.)
    check.below("distance of the front from the barrier at the end, in mesh sizes", (BARRIER - front[-1]) / MESH_SIZE, 1.)
    check.below("pull on the barrier over the largest force", -force.min() / force.max(), 0.01)
    by_solver, by_remeshing = volume_changes(statistics)
    check.below("change of volume by the solver", by_solver, 1e-5)
    check.below("change of volume by remeshing", by_remeshing, 1e-2)


def main():
    check = Check(__doc__)
    check_page(check)
    check_run(check)
    check.finish()


if __name__ == "__main__":
    run_check(main)
