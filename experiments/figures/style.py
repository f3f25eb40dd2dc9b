# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""How all figures look, and how they are written: the same bytes for the same results."""
import csv

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

plt.rcParams.update({
    "svg.hashsalt": "silt", "font.size": 10, "font.family": "DejaVu Sans",
    "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
    "grid.color": "#e3e7ec", "grid.linewidth": 0.8, "axes.edgecolor": "#8a94a3",
    "axes.axisbelow": True, "legend.frameon": False, "lines.linewidth": 1.4,
    "figure.constrained_layout.use": True})

RED, GREEN, BLUE, GRAY = "#c0392b", "#2e8b57", "#2c6fbb", "#6b7785"


def save(figure, folder, name):
    path = folder / "figures" / (name + ".svg")
    path.parent.mkdir(exist_ok=True)
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def legend_above(axes, columns=4):
    axes.legend(ncols=columns, loc="lower left", bbox_to_anchor=(0, 1))


def legend_above_all(figure, axes, columns=4):
    """One legend for several panels; it takes no room from any of them."""
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, ncols=columns, loc="upper left")
    inches = 0.15 + 0.2 * -(-len(labels) // columns)
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - inches / figure.get_figheight()))


def unique(values):
    """In the order of their first appearance."""
    return list(dict.fromkeys(values))


def read_table(path):
    """The rows of a CSV file as dictionaries; numbers are floats."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return {"true": True, "false": False}.get(text, text)
    with open(path, newline="") as lines:
        return [{key: value(text) for key, text in row.items()} for row in csv.DictReader(lines)]
