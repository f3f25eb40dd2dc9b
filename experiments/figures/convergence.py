# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Draws the figures of `silt experiment convergence`: convergence.py FOLDER.

Reads FOLDER/iterations.csv and FOLDER/success_rates.csv, writes FOLDER/figures/*.svg."""
import pathlib
import sys
sys.dont_write_bytecode = True  # leave no __pycache__ beside the script

from style import BLUE, GRAY, RED, legend_above_all, plt, read_table, save, unique

COLOURS = {"four-level pyramid": BLUE, "full resolution only": RED}


def shade_levels(axes, rows):
    """A band for every other level, with its number."""
    for i, level in enumerate(unique(row["level"] for row in rows)):
        places = [k + 1 for k, row in enumerate(rows) if row["level"] == level]
        if i % 2 == 0:
            axes.axvspan(places[0] - 0.5, places[-1] + 0.5, color="#f1f4f7", zorder=0)
        text = f"level {level:.0f}" if i == 0 else f"{level:.0f}"
        axes.annotate(text, ((places[0] + places[-1]) / 2, 1), xycoords=("data", "axes fraction"),
                      ha="center", va="bottom", fontsize=8, color=GRAY)


def convergence(folder, rows):
    """Fig. 4: cost per pixel and norm of the update, without and with the pyramid."""
    schemes = unique(row["scheme"] for row in rows)
    figure, grid = plt.subplots(2, len(schemes), figsize=(9, 5), sharex="col", squeeze=False)
    for (upper, lower), scheme in zip(grid.T, schemes):
        mine = [row for row in rows if row["scheme"] == scheme]
        solves = range(1, len(mine) + 1)
        colour = COLOURS.get(scheme, GRAY)
        upper.semilogy(solves, [row["cost"] / max(row["pixels"], 1) for row in mine], ".-",
                       color=colour)
        lower.semilogy(solves, [max(row["update_norm"], 1e-12) for row in mine], ".-",
                       color=colour)
        rejected = [(k, row["update_norm"]) for k, row in zip(solves, mine)
                    if not row["accepted"]]
        if rejected:
            lower.semilogy(*zip(*rejected), "x", color=GRAY, label="not accepted")
            lower.legend(loc="upper right")
        shade_levels(upper, mine)
        upper.set_title(scheme, pad=18)
        upper.set_ylabel("cost per pixel")
        lower.set(xlabel="solve", ylabel="norm of the update")
    save(figure, folder, "convergence")


def success(folder, rows):
    """The share of random starts that ends at the truth, with its 95 % interval."""
    series = unique(row["series"] for row in rows)
    figure, grid = plt.subplots(1, len(series), figsize=(9, 3.2), sharey=True, squeeze=False)
    for axes, name in zip(grid[0], series):
        key, unit = ("angle_deg", "deg") if name == "angle" else ("distance_m", "cm")
        scale = 100 if unit == "cm" else 1
        for scheme in unique(row["scheme"] for row in rows):
            mine = [r for r in rows if r["series"] == name and r["scheme"] == scheme]
            x = [scale * row[key] for row in mine]
            colour = COLOURS.get(scheme, GRAY)
            axes.plot(x, [row["rate"] for row in mine], "o-", ms=4, color=colour, label=scheme)
            axes.fill_between(x, [row["rate_low"] for row in mine],
                              [row["rate_high"] for row in mine], color=colour, alpha=0.12, lw=0)
        label = {"distance": "distance [cm]", "angle": "angle [deg]",
                 "chosen": "distance [cm], angles as chosen"}
        axes.set(xlabel=label.get(name, "distance [cm], with 0.5 deg/cm"), ylim=(-0.03, 1.03))
    grid[0][0].set_ylabel("recovered to 1 mm and 0.1 deg")
    legend_above_all(figure, grid[0][0])
    save(figure, folder, "success_rate")


def main():
    folder = pathlib.Path(sys.argv[1])
    convergence(folder, read_table(folder / "iterations.csv"))
    success(folder, read_table(folder / "success_rates.csv"))


main()
