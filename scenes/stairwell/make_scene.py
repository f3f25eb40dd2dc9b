#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Writes scene.toml beside this script from the plan in layout/. --credits prints the models' table, --check compares."""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "layout"), str(HERE.parent / "layout")]

from corridor import add_corridor  # noqa: E402
from fittings import add_fittings  # noqa: E402
from hall import add_hall  # noqa: E402
from materials import add_materials  # noqa: E402
from plan import write_scene  # noqa: E402
from stairs import add_stairs  # noqa: E402

HEAD = """# The stairs and first floor of an old school: a hall of 5.9 m x 2.8 m over three storeys, a corridor of 18 m x
# 2.4 m. x east, y north, z up, the lowest floor at z = 0, the corridor's at 3.3. Written by make_scene.py: change
# the plan there.

name = "Stairwell"
exposure = 2.2

[environment]
zenith = [0.09, 0.2, 0.43]
horizon = [0.3, 0.38, 0.5]
ground = [0.1, 0.1, 0.08]
"""

LIFT = 3.3  # the plan's z = 0 is the corridor's floor, the file's that of the cellar

if __name__ == "__main__":
    write_scene(HERE, HEAD, (add_materials, add_hall, add_stairs, add_corridor, add_fittings), LIFT)
