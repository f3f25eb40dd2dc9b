# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The middle: sofa and armchairs round a low table on the rug, lamps, and the television in the north-west."""

from mesh import cushion
from pieces import book_pile, book_row, bookshelf, framed
from shell import HEIGHT, NORTH
from writer import Place

RUG = Place(2.35, 2.9, 0, 90)
TABLE = Place(2.3, 2.9, 0.012, 90)
TABLE_TOP = 0.43
SOFA = Place(3.95, 2.9, 0, -90)


def add_seating(scene):
    scene.box("rug", None, (2.9, 2.0, 0.012), RUG, faces={"top": "rug", **{
        side: "rug edge" for side in ("bottom", "front", "back", "left", "right")}})
    _sofa(scene)
    scene.model("yellow armchair", "scopia/armchair2", Place(2.05, 4.5, 0, 12))
    scene.model("reading chair", "chair-ottoman", Place(2.15, 1.15, 0, 172), size=(0.7, 1.4, 0.95),
                materials={"Leather": "tan leather", "Chair_wood": "oak"})
    _table(scene)
    _lamps(scene)
    _television(scene)
    _plants(scene)


def _sofa(scene):
    scene.model("sofa", "winchesterSofa", SOFA, materials={k: "leather" for k in ("Surround", "Sit", "Back",
            "Buttons")} | {"Feet": "walnut"})
    pillow = cushion()
    for i, (x, cover, yaw) in enumerate(((-0.74, "kilim", 16), (-0.4, "velvet", -6), (0.72, "kilim", -20),
                                         (0.44, "blue cloth", 8))):
        scene.mesh(f"cushion {i}", pillow, SOFA.child(x, -0.02, 0.63, yaw), {"cover": cover}, "cushion")
    scene.box("plaid", "tartan", (0.5, 0.46, 0.02), SOFA, (0.02, -0.15, 0.412), 4)
    scene.box("plaid front", "tartan", (0.5, 0.02, 0.3), SOFA, (0.004, -0.42, 0.13), 4)
    scene.model("slippers", "slippers", SOFA.child(0.5, -0.72), (0, 0, 0.012), 20)
    low = SOFA.child(0, 0.7, 0, 180)
    boards = bookshelf(scene, "sofa case", low, (1.6, 0.3, 0.72), 2, "walnut", "walnut back")
    for i, z in enumerate(boards):
        book_row(scene, f"sofa case row {i}", low.child(-0.77, -0.12, z), 1.54, 170 + i, 0.95 - 0.2 * i)
    top = low.child(0, 0, 0.72)
    scene.model("sofa case lamp", "lamp", top, (-0.58, 0, 0))
    book_pile(scene, "sofa case pile", top.child(0.05, 0, 0, 7), 175, 4)
    scene.model("sofa case plant", "bonsai-tree", top, (0.55, 0, 0), 20, size=(0.4, 0.28, 0.36))
    scene.model("sofa case photograph", "frame2", top, (-0.28, 0, 0.001), 12)


def _table(scene):
    scene.box("table top", "oak", (1.15, 0.62, 0.035), TABLE, (0, 0, TABLE_TOP - 0.035))
    scene.box("table shelf", "oak", (1.03, 0.5, 0.02), TABLE, (0, 0, 0.13))
    for i, (x, y) in enumerate(((-0.53, -0.27), (0.53, -0.27), (-0.53, 0.27), (0.53, 0.27))):
        scene.box(f"table leg {i}", "walnut upright", (0.05, 0.05, TABLE_TOP - 0.035), TABLE, (x, y, 0))
    book_pile(scene, "table shelf pile", TABLE.child(-0.25, 0, 0.15, 4), 181, 4)
    book_pile(scene, "table shelf pile 2", TABLE.child(0.25, 0.02, 0.15, -8), 182, 3)
    top = TABLE.child(0, 0, TABLE_TOP)
    scene.model("fruit", "bowlWithFruits", top, (0.05, 0.06, 0))
    for i, (picture, x, y, yaw) in enumerate((("magazine 1", -0.36, -0.06, 14), ("magazine 2", -0.33, -0.03, -22))):
        scene.box(f"magazine {i}", "board", (0.21, 0.28, 0.006), top, (x, y, 0.006 * i), yaw)
        scene.sheet(f"magazine cover {i}", picture, (0.21, 0.28), top, (x, y, 0.006 * i + 0.0063), yaw)
    scene.model("open book", "book", top, (0.4, -0.1, 0), -14)
    scene.model("remote control", "tv-remote-control", top, (-0.12, -0.2, 0), 60)
    scene.model("mug", "coffee-mug", top, (-0.08, 0.22, 0), 30, materials={"White_ceramic": "glazed blue"})
    scene.model("espresso", "caffe_final", top, (0.27, -0.22, 0.001))
    scene.model("newspaper", "newspaper", top, (-0.38, 0.19, 0.001), 8, size=(0.27, 0.2, 0.012))


def _lamps(scene):
    scene.model("chandelier", "lamp2", Place(2.35, 2.9, HEIGHT - 0.05 - 0.62), size=(0.62, 0.6, 0.62),
                materials={"Glass": "bulb", "Lamp": "bulb"})
    floor = Place(3.55, 4.62)
    scene.model("floor lamp", "living_lamp", floor, yaw_deg=-90)
    scene.box("floor lamp book", "kilim", (0.15, 0.2, 0.02), floor, (-0.09, -0.05, 0.485), 30)
    scene.table("light", "lamps", name="floor lamp glow", center=(3.55, 4.62, 1.16), u=(0.1, 0, 0), v=(0, -0.1, 0),
                radiance=(40, 30, 18))
    scene.table("light", name="floor lamp up", center=(3.55, 4.62, 1.44), u=(0.07, 0, 0), v=(0, 0.07, 0),
                radiance=(40, 30, 18))


def _television(scene):
    stand = NORTH.child(1.2, -0.27)
    scene.model("television stand", "tvStand", stand)
    scene.model("television", "wall-flat-tv", NORTH, (1.2, -0.06, 0.86), size=(1.03, 0.109, 0.66),
                materials={"screen-tv": "film"})
    for i, (picture, x, z, w, h) in enumerate((("photo 1", 0.82, 1.84, 0.34, 0.27),
                                               ("poster map", 1.28, 1.78, 0.46, 0.37),
                                               ("photo 2", 1.74, 1.84, 0.34, 0.27))):
        framed(scene, f"over the television {i}", picture, (w, h), NORTH, (x, 0, z), "dark wood", 0.02)
    for x in (-0.86, 0.86):
        scene.model(f"speaker {x:+}", "speaker3", stand.child(x, 0.02), size=(0.22, 0.25, 0.72))
    top = stand.child(0, 0, 0.526)
    scene.model("player", "dvd", top, (-0.3, 0, 0.001))
    scene.model("console", "playstation4", top, (0.25, 0, 0), 6)
    scene.model("joystick", "ps4-joystick", top, (0.48, -0.1, 0), 40)


def _plants(scene):
    scene.model("yucca", "yuccaPlant", Place(0.52, 0.42, 0, 40), size=(0.85, 0.8, 1.75))
    scene.model("pot by the window", "maceta", Place(4.36, 0.5), size=(0.52, 0.56, 0.56))
    scene.model("bean bag", "puff", Place(3.05, 4.15, 0, 30), size=(0.75, 0.72, 0.5))
    scene.model("ball", "basketball", Place(2.75, 0.75))
