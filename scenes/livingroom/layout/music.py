# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The north-east corner and the east wall: the piano, the sideboard under a wall of pictures."""

from pieces import book_pile, framed
from shell import EAST, NORTH
from writer import Place

PIANO = NORTH.child(5.5, -0.3)


def add_music(scene):
    scene.model("piano", "piano", PIANO, materials={"klavierlack": "dark wood"})
    _stool(scene, PIANO.child(0, -0.62))
    scene.hung("score", "music", (0.22, 0.3), PIANO.child(-0.12, -0.06, 1.0), (0, 0, 0))
    scene.hung("score 2", "music", (0.22, 0.3), PIANO.child(0.11, -0.06, 1.0), (0, 0, 0))
    top = PIANO.child(0, 0.08, 1.384)
    scene.model("piano lamp", "desklamp", top, (-0.5, 0, 0), materials={})
    book_pile(scene, "piano scores", top.child(0.4, 0, 0, 4), 191, 3)
    scene.model("piano photograph", "frame1", top, (0.05, 0, 0), -8)
    scene.model("piano photograph 2", "frame2", top, (-0.15, 0.02, 0), 14)
    framed(scene, "still life", "painting still life", (0.62, 0.51), NORTH, (5.5, 0, 1.85), "brass", 0.045)
    framed(scene, "photograph by the door", "photo 1", (0.33, 0.26), NORTH, (4.66, 0, 1.62), "dark wood", 0.02)
    framed(scene, "photograph by the door 2", "photo 2", (0.33, 0.26), NORTH, (4.66, 0, 1.28), "dark wood", 0.02)
    _sideboard(scene)


def _sideboard(scene):
    place = EAST.child(2.15, -0.27)
    scene.model("sideboard", "dresserWithDrawers", place, materials={"white_wood": "chimney", "drawer_handle": "brass"})
    top = place.child(0, 0, 0.81)
    scene.model("sideboard lamp", "little_lamp2", top, (-0.62, 0.02, 0),
                materials={"lampshade_multilamps.jpg": "lit shade"})
    scene.table("light", name="sideboard glow", center=(*place.point(-0.62, 0.02)[:2], 1.04), u=(0.09, 0, 0),
                v=(0, -0.09, 0), radiance=(17, 13, 8))
    scene.model("sideboard stereo", "mini_stereo", top, (0.42, 0, 0), -4)
    scene.model("sideboard vase", "vase1", top, (0.02, 0.04, 0), size=(0.16, 0.16, 0.26))
    book_pile(scene, "sideboard pile", top.child(-0.28, 0, 0, -6), 193, 5)
    for i, (picture, x, z, w, h, frame) in enumerate((
            ("painting abstract", 2.15, 1.52, 0.62, 0.62, "walnut"),
            ("botanical 1", 1.55, 1.72, 0.28, 0.38, "dark wood"),
            ("botanical 2", 1.55, 1.26, 0.28, 0.38, "dark wood"), ("photo 2", 2.72, 1.86, 0.33, 0.26, "walnut"),
            ("photo 1", 2.72, 1.5, 0.33, 0.26, "dark wood"), ("painting sea", 0.95, 1.5, 0.56, 0.4, "brass"))):
        framed(scene, f"gallery {i}", picture, (w, h), EAST, (x, 0, z), frame, 0.022)
    framed(scene, "looking glass", "looking glass", (0.3, 0.95), EAST, (3.2, 0, 0.95), "brass", 0.03)
    scene.model("tall plant", "plant", Place(6.15, 4.4 - 0.02), size=(0.5, 0.45, 1.0))


def _stool(scene, place):
    """A piano stool: an upholstered seat on four legs."""
    scene.box("stool seat", "black leather", (0.56, 0.34, 0.07), place, (0, 0, 0.43))
    scene.box("stool apron", "dark wood", (0.52, 0.3, 0.06), place, (0, 0, 0.37))
    for i, (x, y) in enumerate(((-0.23, -0.12), (0.23, -0.12), (-0.23, 0.12), (0.23, 0.12))):
        scene.box(f"stool leg {i}", "dark wood", (0.045, 0.045, 0.37), place, (x, y, 0))
