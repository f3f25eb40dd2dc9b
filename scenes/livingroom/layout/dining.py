# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The south-east corner: a round table and its chairs under a hanging lamp, by the small window."""

from pieces import framed
from shell import EAST, HEIGHT
from writer import Place

TABLE = Place(5.3, 1.5)
TOP = 0.741


def add_dining(scene):
    scene.model("dining table", "oakTable", TABLE)
    for i, (angle, pull) in enumerate(((20, 0.8), (110, 0.78), (205, 0.95), (290, 0.8))):
        seat = TABLE.child(0, 0, 0, angle).child(0, pull)
        scene.model(f"chair {i}", "plaidChair", seat, yaw_deg=(0, 8, -22, 0)[i])
    top = TABLE.child(0, 0, TOP)
    scene.sheet("runner", "tartan", (0.36, 1.1), top, (0, 0, 0.0008), 35)
    scene.model("table plant", "littlePlant", top, (0.02, 0.05, 0.001), 40)
    for i, angle in enumerate((20, 110, 290)):
        seat = top.child(0, 0, 0, angle)
        scene.model(f"setting {i}", "plate-and-ustensils", seat, (0, 0.38, 0.001), 180)
    scene.model("bread board", "choppingBoard", top, (-0.3, -0.2, 0), 30)
    scene.model("bread", "bread", top, (-0.3, -0.2, 0.045), 40)
    scene.model("bottle", "wine_bottle", top, (0.25, -0.12, 0))
    scene.model("dining newspaper", "newspaper", top, (-0.3, 0.25, 0.001), -30, size=(0.27, 0.24, 0.012))
    _lamp(scene)
    framed(scene, "field", "painting field", (0.9, 0.72), EAST, (3.95, 0, 1.3), "walnut", 0.04)
    framed(scene, "old map", "poster map", (0.52, 0.42), EAST, (4.85, 0, 1.42), "dark wood", 0.025)
    scene.model("corner plant", "maceta", Place(6.2, 0.45, 0, 70), size=(0.6, 0.62, 0.8))


def _lamp(scene):
    low = 1.5
    scene.model("hanging lamp", "hangingLight", TABLE.child(0, 0, low), size=(0.44, 0.44, 0.86),
                materials={"Light-lamp": "brass", "Lamp-inside": "lit shade"})
    scene.cylinder("hanging lamp cable", "iron", 0.006, HEIGHT - low - 0.86, TABLE, (0, 0, low + 0.86), 8)
    x, y, _ = TABLE.point(0, 0)
    scene.table("light", name="hanging glow", center=(x, y, low + 0.04), u=(0.13, 0, 0), v=(0, -0.13, 0),
                radiance=(26, 20, 12))
