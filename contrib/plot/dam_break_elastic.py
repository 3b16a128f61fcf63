"""The benchmark of the dam break against an elastic barrier (Franci & Zhang 2018, Section 5.1): its runs, table, figures."""

import numpy as np
from figure_style import WIDTH, plt, save, use_style
from lahar_output import column

CASE = "dam_break_elastic"
FILE = "prm/dam_break_barrier/elastic_2d.prm"
TIME, TIP = "Time (s)", "tip x (m)"
COARSE = (0.012, 0.010, 0.008, 0.006)
# Published curves and where they are from, shared/data/elastic_barrier_tip_newtonian.csv.
PUBLISHED = {"kratos": "Kratos PFEM–FEM", "meduri2018": "Meduri et al. 2018", "cerquaglia2019": "Cerquaglia et al. 2019",
             "ryzhakov": "Ryzhakov et al. 2010"}


def runs(make_run):
    """All runs. @p make_run(case, name, file, settings, label, tau0, h) makes one."""

    def make(tau0, h, degree, suffix="", more=(), label=""):
        step = ("Time step=5e-4",) if h < 0.003 else ()
        return make_run(CASE, f"tau{tau0}-h{h:g}-p{degree}{suffix}", FILE,
                        (f"Fluid/Bingham/Yield stress={tau0}", f"Mesh size={h}", f"Solids/Degree={degree}", *step, *more),
                        label or f"P{degree}", tau0, h)

    return ([make(0, 0.004, 2), make(0, 0.002, 1)]
            + [make(100, h, degree) for degree in (2, 1) for h in (*COARSE, 0.004)]
            + [make(100, 0.004, 2, f"-m{m:g}", (f"Fluid/Bingham/Regularization parameter={m}",), f"P2, m = {m:g} s")
               for m in (0.1, 1, 100)]
            + [make(tau0, 0.004, 2) for tau0 in (25, 50)]
            + [make(tau0, 0.002, 2) for tau0 in (100, 50, 25)] + [make(100, 0.002, 1)])


def report(all_results, doc):
    pass
