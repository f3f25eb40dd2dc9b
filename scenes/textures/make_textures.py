#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Writes every texture of the scenes beside this script; the same bytes each time.

Needs Debian's python3-numpy, python3-pil and fonts-dejavu-core. Give names to write only those.
"""

import pathlib
import sys

import numpy as np
from PIL import Image

from books import BOOKS
from home import HOME
from paintings import PAINTINGS
from paper import SHEETS
from school import SCHOOL
from screens import SCREENS
from surfaces import SURFACES
from wall import WALL

HERE = pathlib.Path(__file__).resolve().parent


def save(name, image):
    """Pictures with transparency become PNG, all others JPEG."""
    if isinstance(image, np.ndarray):
        image = Image.fromarray(image)
    if image.mode == "RGBA":
        image.save(HERE / f"{name}.png", optimize=True)
    else:
        image.save(HERE / f"{name}.jpg", quality=86, subsampling=1, optimize=True)


def main(names):
    makers = {**SURFACES, **HOME, **SHEETS, **BOOKS, **WALL, **PAINTINGS, **SCHOOL, **SCREENS}
    unknown = sorted(set(names) - set(makers))
    if unknown:
        sys.exit(f"make_textures.py: no such texture: {', '.join(unknown)}")
    for name in names or makers:
        save(name, makers[name]())


if __name__ == "__main__":
    main(sys.argv[1:])
