# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Shows the ground truth of one frame: truth.py SEQUENCE PICTURE.png [FRAME].

SEQUENCE is a folder that `silt render --truth all` wrote in TUM's layout."""
import pathlib
import sys
sys.dont_write_bytecode = True  # leave no __pycache__ beside the script

import numpy
from matplotlib.colors import hsv_to_rgb

from rgb_and_depth import PNG_STEPS, depth_picture
from style import plt

NO_FLOW = 1e9
GOLDEN = 0.618034  # successive ids get hues far apart


def id_picture(ids):
    """A colour for each id; black where there is nothing."""
    hue, value = ids * GOLDEN % 1, numpy.where(ids > 0, 0.55 + 0.45 * (ids * 0.7548777 % 1), 0)
    return hsv_to_rgb(numpy.stack([hue, numpy.full_like(hue, 0.65), value], -1))


def read_flow(path):
    width, height = numpy.fromfile(path, "<i4", 2, offset=4)
    return numpy.fromfile(path, "<f4", offset=12).reshape(height, width, 2)


def flow_picture(flow, largest):
    """Hue is the direction, saturation the length: white where nothing moves."""
    u, v = flow[..., 0], flow[..., 1]
    hue = numpy.arctan2(v, u) / (2 * numpy.pi) % 1
    length = numpy.clip(numpy.hypot(u, v) / largest, 0, 1)
    return hsv_to_rgb(numpy.stack([hue, length, numpy.ones_like(hue)], -1))


def color_wheel(size=81):
    v, u = numpy.mgrid[-1:1:size * 1j, -1:1:size * 1j]
    picture = flow_picture(numpy.stack([u, v], -1), 1)
    return numpy.dstack([picture, numpy.hypot(u, v) <= 1])


def occlusion_picture(states):
    """Seen light, hidden red, outside blue, nothing black."""
    colors = {0: (.93, .93, .93), 85: (.17, .44, .73), 170: (.75, .22, .17), 255: (0, 0, 0)}
    picture = numpy.zeros(states.shape + (3,))
    for state, color in colors.items():
        picture[states == state] = color
    return picture


def read_ids(path):
    return numpy.rint(plt.imread(path) * PNG_STEPS).astype(int)


def panels(sequence, frame):
    """Titles and pictures of what is known about a frame."""
    truth = sequence / "truth"
    flow = read_flow(truth / "flow_forward" / f"{frame}.flo")
    known = numpy.hypot(flow[..., 0], flow[..., 1]) < NO_FLOW
    largest = numpy.percentile(numpy.hypot(flow[..., 0], flow[..., 1])[known], 99)
    yield "image", plt.imread(sequence / "rgb" / f"{frame}.png")[..., :3]
    yield "depth (near is bright)", depth_picture(numpy.load(truth / "depth_z" / f"{frame}.npy"))
    for axes in "camera", "world":
        normal = numpy.load(truth / f"normal_{axes}" / f"{frame}.npy")
        yield f"normals, {axes} axes", numpy.clip((normal + 1) / 2, 0, 1)
    for kind in "instance", "material":
        yield kind + "s", id_picture(read_ids(truth / kind / f"{frame}.png"))
    picture = numpy.where(known[..., None], flow_picture(flow, largest), 0)
    wheel = color_wheel()
    size = len(wheel)
    corner = picture[-size:, -size:]
    picture[-size:, -size:] = corner + wheel[..., 3:] * (wheel[..., :3] - corner)
    yield f"flow to the next frame (wheel: {largest:.1f} px)", picture
    states = numpy.rint(plt.imread(truth / "occlusion_forward" / f"{frame}.png") * 255).astype(int)
    yield "hidden (red) or outside (blue) in it", occlusion_picture(states)


def main(sequence, picture, frame="000000"):
    figure, grid = plt.subplots(4, 2, figsize=(9, 14))
    for axes, (title, image) in zip(grid.flat, panels(sequence, frame)):
        axes.imshow(image, interpolation="nearest")
        axes.set_title(title, fontsize=9)
        axes.axis("off")
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), *sys.argv[3:])
