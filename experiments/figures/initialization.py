# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Draws the figures of `silt experiment initialization`: initialization.py FOLDER.

Reads FOLDER/summary.csv, writes FOLDER/figures/*.svg."""
import pathlib
import sys
sys.dont_write_bytecode = True  # leave no __pycache__ beside the script

from style import (BLUE, GRAY, GREEN, RED, legend_above, legend_above_all, plt, read_table, save,
                   unique)

COLOURS = {"identity": GRAY, "previous": GREEN, "surf": RED, "constant-velocity": "#0f766e",
           "rotation": "#9333ea", "sift": "#ea580c", "orb": "#ca8a04", "akaze": "#be185d"}


def panels(rows, height):
    """One panel per condition, and the rows of each."""
    conditions = unique(row["condition"] for row in rows)
    figure, grid = plt.subplots(1, len(conditions), figsize=(9, height), sharey=True,
                                squeeze=False)
    for axes, condition in zip(grid[0], conditions):
        axes.set_title(condition, loc="right", fontsize=10)
        axes.set_xlabel("frames from the keyframe")
    return figure, list(zip(grid[0], ([r for r in rows if r["condition"] == c]
                                      for c in conditions)))


def success(folder, rows):
    figure, each = panels(rows, 3.2)
    for axes, mine in each:
        for method in unique(row["method"] for row in mine):
            points = [row for row in mine if row["method"] == method]
            gaps, colour = [row["gap"] for row in points], COLOURS.get(method, BLUE)
            axes.plot(gaps, [row["rate"] for row in points], "o-", ms=4, color=colour,
                      label=method)
            axes.fill_between(gaps, [row["rate_low"] for row in points],
                              [row["rate_high"] for row in points], color=colour, alpha=0.12,
                              lw=0)
        axes.set_ylim(-0.03, 1.03)
    each[0][0].set_ylabel("refined to 1 cm and 0.5 deg")
    legend_above_all(figure, each[0][0])
    save(figure, folder, "initialization_success")


def errors(folder, rows):
    """Where the refinement starts, and where it ends."""
    figure, each = panels(rows, 3.6)
    for axes, mine in each:
        for method in unique(row["method"] for row in mine):
            points = [row for row in mine if row["method"] == method and row["available"] > 0]
            gaps, colour = [row["gap"] for row in points], COLOURS.get(method, BLUE)
            for key, line, what in (("start", "--", ", start"), ("end", "-", ", refined")):
                axes.semilogy(gaps, [max(100 * row[key + "_distance_m"], 1e-4) for row in points],
                              line, marker="o", ms=3.5, color=colour, label=method + what)
    each[0][0].set_ylabel("median position error [cm]")
    legend_above_all(figure, each[0][0], 3)
    save(figure, folder, "initialization_error")


def inliers(folder, rows):
    figure, axes = plt.subplots(figsize=(5.5, 3.2))
    lines = {"sharp": "-", "noisy": "--", "blurred": ":"}
    for condition in unique(row["condition"] for row in rows):
        points = [row for row in rows
                  if row["condition"] == condition and row["method"] == "surf"]
        axes.plot([row["gap"] for row in points], [row["inliers"] for row in points], "o", ms=4,
                  color=RED, linestyle=lines.get(condition, "-."), label=condition)
    axes.set(xlabel="frames from the keyframe", ylabel="inliers of the pose from SURF, median")
    axes.set_ylim(bottom=0)
    legend_above(axes)
    save(figure, folder, "initialization_inliers")


def main():
    folder = pathlib.Path(sys.argv[1])
    rows = read_table(folder / "summary.csv")
    success(folder, rows)
    errors(folder, rows)
    inliers(folder, rows)


main()
