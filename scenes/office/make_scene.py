#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Writes scene.toml beside this script from the plan in layout/. --credits prints the models' table, --check compares."""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE / "layout"), str(HERE.parent / "layout")]

from desk import add_desk  # noqa: E402
from materials import add_materials  # noqa: E402
from plan import write_scene  # noqa: E402
from rest import add_rest  # noqa: E402
from room import add_room  # noqa: E402

HEAD = """# An office of 6 m x 6 m x 2.7 m: x east, y north, z up. Written by make_scene.py: change the plan there.

name = "Office"
ambient = [0.2, 0.205, 0.215]
exposure = 1.45
"""

if __name__ == "__main__":
    write_scene(HERE, HEAD, (add_materials, add_room, add_desk, add_rest))
