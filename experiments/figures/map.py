# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Draws a map as the paper's Fig. 7 does, from cloud.ply and cameras.ply: map.py FOLDER.

Left from obliquely above, right from straight above; whatever lies above the cameras is left out
there, as it would hide them."""
import pathlib
import sys
sys.dont_write_bytecode = True  # leave no __pycache__ beside the script

import numpy

from style import plt

VERTEX = numpy.dtype([("p", "<f4", 3), ("c", "u1", 3)])
SHOWN = 150000  # points of the cloud
PANEL_POINTS = 400  # typographic ones, of a panel's width


def read_ply(path):
    """Points, colours from 0 to 1, and edges."""
    data = path.read_bytes()
    head, body = data.split(b"end_header\n", 1)
    counts = {words[1]: int(words[2]) for words in
              (line.split() for line in head.decode().splitlines()) if words[0] == "element"}
    vertices = numpy.frombuffer(body, VERTEX, counts["vertex"])
    edges = numpy.zeros((0, 2), int)
    if "edge" in counts:
        edges = numpy.frombuffer(body, "<i4", 2 * counts["edge"], vertices.nbytes).reshape(-1, 2)
    return vertices["p"].astype(float), vertices["c"] / 255, edges


def looking(direction, up):
    """Rows: right, up and depth of a picture taken along a direction."""
    depth = numpy.array(direction, float) / numpy.linalg.norm(direction)
    right = numpy.cross(depth, up)
    right /= numpy.linalg.norm(right)
    return numpy.array([right, numpy.cross(right, depth), depth])


def draw(axes, view, cloud, cameras):
    points, colors, _ = cloud
    seen = points @ view.T
    order = numpy.argsort(-seen[:, 2])
    # As large as the points lie apart, were they spread evenly, so that surfaces close.
    width, height = numpy.ptp(seen[:, :2], axis=0)
    size = max(0.5, (PANEL_POINTS / max(width, height)) ** 2 * width * height / len(seen))
    axes.scatter(seen[order, 0], seen[order, 1], s=size, c=colors[order], linewidths=0,
                 marker="s", rasterized=True)
    points, colors, edges = cameras
    flat = points @ view.T
    for a, b in edges:
        axes.plot(flat[[a, b], 0], flat[[a, b], 1], color=colors[a], linewidth=0.7)
    axes.set_aspect("equal")
    axes.grid(False)
    axes.set_xlabel("m")


def main(folder):
    points, colors, _ = read_ply(folder / "cloud.ply")
    step = max(1, len(points) // SHOWN)
    points, colors = points[::step], colors[::step]
    cameras = read_ply(folder / "cameras.ply")
    figure, (left, right) = plt.subplots(1, 2, figsize=(12, 5.5))
    below = points[:, 2] < cameras[0][:, 2].max() + 0.1
    cloud = points[below], colors[below], None
    draw(left, looking([0.5, 1, -0.9], [0, 0, 1]), cloud, cameras)
    draw(right, looking([0, 0, -1], [0, 1, 0]), cloud, cameras)
    path = folder / "figures" / "map.png"
    path.parent.mkdir(exist_ok=True)
    figure.savefig(path, dpi=150, metadata={"Software": None})
    plt.close(figure)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
