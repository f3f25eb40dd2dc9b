# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Draws the figures of `silt experiment accuracy`: accuracy.py FOLDER.

Reads FOLDER/accuracy.json and FOLDER/errors/*.csv, writes FOLDER/figures/*.svg."""
import json
import pathlib
import sys
sys.dont_write_bytecode = True  # leave no __pycache__ beside the script

from style import BLUE, GRAY, GREEN, RED, legend_above, plt, read_table, save

ORANGE = "#e67e22"
SEQUENCES = {  # colour and line of each
    "60fps": (RED, "-"), "60fps-blur": (BLUE, "--"), "20fps": (GRAY, ":")}
AXES = {"x": RED, "y": GREEN, "z": BLUE}


def read_errors(folder, run):
    rows = read_table(folder / "errors" / (pathlib.Path(run["trajectory"]).stem + ".csv"))
    return {key: [row[key] for row in rows] for key in rows[0]}


def keyframes(errors, x, y):
    """The points of two columns at which a keyframe was made."""
    chosen = [i for i, flag in enumerate(errors["keyframe"]) if flag]
    return [x[i] for i in chosen], [y[i] for i in chosen]


def position_error(folder, runs):
    """Fig. 6a: one line a sequence."""
    figure, axes = plt.subplots(figsize=(9, 3.6))
    for sequence, (colour, line) in SEQUENCES.items():
        if sequence not in runs:
            continue
        e = runs[sequence]
        axes.plot(e["time_s"], e["position_error_cm"], line, color=colour, label=sequence)
        axes.plot(*keyframes(e, e["time_s"], e["position_error_cm"]), "o", color=colour, ms=4.5,
                  mec="white", mew=0.6)
    axes.plot([], [], "o", color="#444", ms=4.5, label="keyframe")
    axes.set(xlabel="time [s]", ylabel="position error [cm]")
    axes.set_ylim(bottom=0)
    axes.margins(x=0.01)
    legend_above(axes, 4)
    save(figure, folder, "position_error")


def per_axis(folder, name, errors, column, label):
    """Figs. 5b, 6b and 6c: three lines."""
    figure, axes = plt.subplots(figsize=(9, 3.2))
    for axis, colour in AXES.items():
        axes.plot(errors["time_s"], errors[column.format(axis)], color=colour,
                  label="about " + axis)
    axes.axhline(0, color="#8a94a3", linewidth=0.8)
    axes.set(xlabel="time [s]", ylabel=label)
    axes.margins(x=0.01)
    legend_above(axes, 3)
    save(figure, folder, name)


def trajectory(folder, name, e):
    """Fig. 5a, from above and from the side."""
    figure, both = plt.subplots(1, 2, figsize=(9, 4.2))
    for axes, (across, up) in zip(both, (("x", "y"), ("x", "z"))):
        estimate = e[across + "_m"], e[up + "_m"]
        axes.plot(e["true_" + across + "_m"], e["true_" + up + "_m"], color=GREEN,
                  linewidth=3, alpha=0.55, label="true")
        axes.plot(*estimate, color=ORANGE, label="estimated")
        axes.plot(*keyframes(e, *estimate), "o", color=BLUE, ms=5, mec="white", mew=0.6,
                  label="keyframe")
        axes.set(xlabel=across + " [m]", ylabel=up + " [m]")
        axes.set_aspect("equal", adjustable="datalim")
    legend_above(both[0], 3)
    save(figure, folder, name)


def main():
    folder = pathlib.Path(sys.argv[1])
    results = json.loads((folder / "accuracy.json").read_text())["runs"]
    # The first preset and seed of each sequence.
    first = {}
    for run in results:
        first.setdefault(run["sequence"], run)
    runs = {sequence: read_errors(folder, run) for sequence, run in first.items()}
    position_error(folder, runs)
    for sequence, errors in runs.items():
        per_axis(folder, "orientation_error_" + sequence, errors, "error_{}_deg",
                 "orientation error [deg]")
        trajectory(folder, "trajectory_" + sequence, errors)
        per_axis(folder, "turns_" + sequence, errors, "turn_{}_deg", "turn [deg]")


main()
