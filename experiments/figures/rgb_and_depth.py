# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Shows the first frame of a sequence beside its depth: rgb_and_depth.py SEQUENCE PICTURE.png.

Near is bright. SEQUENCE is a folder that `silt render` wrote."""
import pathlib
import sys
sys.dont_write_bytecode = True  # leave no __pycache__ beside the script

import numpy

from style import plt

PNG_STEPS, STEPS_PER_METRE = 65535, 5000


def depth_picture(depth_m):
    """Inverse depth as a colour, stretched over what the frame holds; black where not measured."""
    measured = depth_m > 0
    inverse = numpy.where(measured, 1 / numpy.maximum(depth_m, 1e-3), 0)
    low, high = numpy.percentile(inverse[measured], [0.5, 99.5])
    picture = plt.get_cmap("magma")(numpy.clip((inverse - low) / (high - low), 0, 1))[..., :3]
    return numpy.where(measured[..., None], picture, 0)


def main(sequence, picture):
    rgb = plt.imread(sequence / "rgb" / "000000.png")[..., :3]
    depth_m = plt.imread(sequence / "depth" / "000000.png") * PNG_STEPS / STEPS_PER_METRE
    plt.imsave(picture, numpy.hstack([rgb, depth_picture(depth_m)]))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
