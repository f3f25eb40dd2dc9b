#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Writes scene.toml beside this script from the plan in layout/. With --credits: the models' table."""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "layout"))

from catalogue import ARCHIVES, FOLDER, catalogue, credits  # noqa: E402
from desk import add_desk  # noqa: E402
from materials import add_materials  # noqa: E402
from rest import add_rest  # noqa: E402
from room import add_room  # noqa: E402
from writer import SceneWriter  # noqa: E402

HEAD = """# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
#
# An office of 6 m x 6 m x 2.7 m: x east, y north, z up. Written by make_scene.py: change the plan there.

name = "Office"
ambient = [0.2, 0.205, 0.215]
exposure = 1.45"""


def main():
    scene = SceneWriter(catalogue())
    for key, (file, _) in ARCHIVES.items():
        scene.table("archive", id=key, file=FOLDER + file)
    add_materials(scene)
    add_room(scene)
    add_desk(scene)
    add_rest(scene)
    if "--credits" in sys.argv:
        for row in credits(scene.used):
            print("| " + " | ".join(row) + " |")
    else:
        (HERE / "scene.toml").write_text(scene.text(HEAD))


if __name__ == "__main__":
    main()
