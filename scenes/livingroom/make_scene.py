#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Writes scene.toml beside this script from the plan in layout/. --credits prints the models' table, --check compares."""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "layout"), str(HERE.parent / "layout")]

from dining import add_dining  # noqa: E402
from hearth import add_hearth  # noqa: E402
from materials import add_materials  # noqa: E402
from music import add_music  # noqa: E402
from plan import write_scene  # noqa: E402
from seating import add_seating  # noqa: E402
from shell import add_shell  # noqa: E402

HEAD = """# A living room of 6.6 m x 5.4 m x 2.85 m: x east, y north, z up. Written by make_scene.py: change the plan there.

name = "Living room"
ambient = [0.16, 0.165, 0.17]
exposure = 2.5
"""

if __name__ == "__main__":
    write_scene(HERE, HEAD, (add_materials, add_shell, add_hearth, add_seating, add_music, add_dining))
