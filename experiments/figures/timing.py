# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Draws the figures of `silt experiment timing`: timing.py FOLDER.

Reads FOLDER/stages.csv and FOLDER/frames.csv, writes FOLDER/figures/*.svg."""
import pathlib
import sys
sys.dont_write_bytecode = True  # leave no __pycache__ beside the script

from style import (BLUE, GRAY, GREEN, RED, legend_above, legend_above_all, plt, read_table,
                   save)

STAGES = {"load_ms": ("load", GRAY), "pyramid_ms": ("pyramid", "#b9a44c"),
          "initial_estimate_ms": ("initial estimate", RED),
          "residual_ms": ("warps and residuals", BLUE), "jacobian_ms": ("Jacobians", GREEN),
          "update_ms": ("updates", "#444444")}


def stages(folder, rows):
    figure, axes = plt.subplots(figsize=(8, 3.8))
    places = range(len(rows))
    paper = [row["paper_ms"] if row["paper_ms"] != "" else 0 for row in rows]
    axes.barh([p - 0.2 for p in places], paper, 0.38, color=GRAY, label="paper")
    axes.barh([p + 0.2 for p in places], [row["median_ms"] for row in rows], 0.38, color=BLUE,
              label="silt, median")
    axes.set_yticks(list(places), [row["stage"] for row in rows])
    axes.invert_yaxis()
    axes.set_xscale("log")
    axes.set_xlabel("milliseconds")
    axes.grid(axis="y", visible=False)
    legend_above(axes)
    save(figure, folder, "timing_stages")


def frames(folder, rows):
    """Where each frame's time goes."""
    figure, axes = plt.subplots(figsize=(9, 3.2))
    numbers = range(len(rows))
    bottom = [0.0] * len(rows)
    for key, (label, colour) in STAGES.items():
        values = [row[key] for row in rows]
        axes.bar(numbers, values, 0.9, bottom, color=colour, label=label)
        bottom = [b + v for b, v in zip(bottom, values)]
    axes.set(xlabel="frame", ylabel="milliseconds")
    axes.margins(x=0.01)
    axes.grid(axis="x", visible=False)
    legend_above_all(figure, axes, 6)
    save(figure, folder, "timing_frames")


def main():
    folder = pathlib.Path(sys.argv[1])
    stages(folder, read_table(folder / "stages.csv"))
    frames(folder, read_table(folder / "frames.csv"))


main()
