# SPDX-License-Identifier: GPL-3.0-or-later
"""The look that Lahar's figures share."""

import pathlib

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt

from lahar_output import OutputError

WIDTH = 7.2  # inches, the text width of a page
INK = "0.15"


def use_style():
    plt.rcParams.update({
        "font.size": 9, "axes.titlesize": 9, "axes.labelsize": 9, "xtick.labelsize": 8, "ytick.labelsize": 8,
        "legend.fontsize": 8, "legend.frameon": False, "axes.linewidth": 0.7, "axes.edgecolor": INK,
        "xtick.direction": "in", "ytick.direction": "in", "xtick.color": INK, "ytick.color": INK,
        "lines.linewidth": 1.5, "savefig.dpi": 200, "mathtext.fontset": "dejavusans",
        # Okabe and Ito's colours, which colour-blind readers can tell apart
        "axes.prop_cycle": plt.cycler(color=["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]),
    })


def finish_axes(axes, legend="best", **labels):
    """Labels, grid, ticks and, where curves have names, legend of a plot."""
    axes.set(**labels)
    axes.grid(linewidth=0.4, color="0.88")
    axes.margins(x=0)
    axes.tick_params(top=True, right=True)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc=legend)


def save(figure, path):
    """Write @p figure in the format that the ending of @p path names; the folder is made if need be."""
    pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
    try:
        figure.savefig(path, bbox_inches="tight", pad_inches=0.05)
    except ValueError as error:
        raise OutputError(f"{path}: {str(error).splitlines()[0]}") from None
    print(f"Wrote {pathlib.Path(path)}")
