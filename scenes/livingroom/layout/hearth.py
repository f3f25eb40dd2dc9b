# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The west side: the fireplace on its chimney breast between two cases of books."""

from pieces import book_pile, book_row, bookshelf, framed
from shell import HEIGHT, WEST
from writer import Place

MIDDLE, BREAST = 2.9, 0.16               # y of the fireplace; how far the chimney breast stands out
MANTEL = 1.05


def add_hearth(scene):
    scene.box("chimney breast", "chimney", (1.75, BREAST, HEIGHT - 0.135), WEST, (MIDDLE, -BREAST / 2, 0))
    scene.model("fireplace", "fireplace1", WEST, (MIDDLE, -BREAST - 0.176, 0), size=(1.36, 0.351, MANTEL))
    scene.box("hearth stone", "marble", (1.7, 0.42, 0.025), WEST, (MIDDLE, -BREAST - 0.56, 0))
    front = WEST.child(MIDDLE, -BREAST)
    framed(scene, "sea", "painting sea", (0.98, 0.7), front, (0, 0, 1.36), "brass", 0.05)
    _mantel(scene, front.child(0, -0.17, MANTEL))
    _logs(scene)
    _case(scene, "south case", 1.12, 100)
    _case(scene, "north case", 4.56, 140)


def _mantel(scene, top):
    for i, (x, size) in enumerate(((-0.56, 1.0), (-0.43, 0.72), (0.58, 0.9))):
        scene.model(f"candle {i}", "candle", top, (x, 0.02, 0), size=(0.09 * size, 0.09 * size, 0.38 * size),
                    materials={"holder": "brass"})
    scene.box("clock case", "walnut", (0.2, 0.1, 0.24), top, (0, 0.05, 0))
    scene.hung("clock", "clock face", (0.17, 0.17), top, (0, -0.002, 0.05))
    scene.model("mantel photograph", "frame1", top, (0.25, 0.03, 0), -12)
    scene.model("mantel vase", "vase3", top, (-0.24, 0.03, 0), size=(0.13, 0.13, 0.28))
    scene.model("mantel jar", "pottery", top, (0.42, 0.04, 0), size=(0.12, 0.12, 0.1))


def _logs(scene):
    scene.model("log basket", "shopping-basket", WEST.child(MIDDLE + 1.02, -0.55), size=(0.46, 0.38, 0.44), yaw_deg=80)
    scene.model("logs", "wood_logs", WEST.child(MIDDLE + 1.02, -0.55), (0, 0, 0.1), 80, size=(0.26, 0.34, 0.22))
    stand = WEST.child(MIDDLE - 0.82, -0.42)
    scene.cylinder("tool stand", "iron", 0.1, 0.015, stand, segments=24)
    scene.cylinder("tool pole", "iron", 0.009, 0.68, stand, (0, 0, 0.015), 12)
    scene.sphere("tool knob", "brass", 0.022, stand, (0, 0, 0.7), 16)
    for i, (x, y) in enumerate(((-0.06, 0), (0.06, 0), (0, -0.06))):
        scene.cylinder(f"tool {i}", "iron", 0.006, 0.48, stand, (x, y, 0.1), 10)
        scene.box(f"tool head {i}", ("iron", "walnut", "iron")[i], (0.06, 0.03, 0.1), stand, (x, y, 0.03), 40 * i)
    scene.box("tool ring", "iron", (0.15, 0.02, 0.012), stand, (0, 0, 0.57))
    scene.box("tool ring 2", "iron", (0.02, 0.13, 0.012), stand, (0, -0.01, 0.572))


def _case(scene, name, y, seed):
    """A high case of books in an alcove, things between the rows."""
    size = (1.36, 0.32, 2.3)
    place = WEST.child(y, -0.17)
    boards = bookshelf(scene, name, place, size, 6, "walnut", "walnut back")
    for i, z in enumerate(boards):
        row = place.child(-0.65, -0.12, z)
        fill = (1.0, 0.93, 0.62, 0.97, 0.55, 0.9)[(i + seed // 20) % 6]
        end = book_row(scene, f"{name} row {i}", row, 1.3, seed + i, fill)
        if fill < 0.7:
            book_pile(scene, f"{name} pile {i}", row.child(end + 0.2, 0.12, 0, 8), seed + 10 + i, 4)
            _ornament(scene, f"{name} ornament {i}", row.child(end + 0.47, 0.1), i)
    top = place.child(0, 0, size[2])
    if seed == 100:
        scene.model(f"{name} top plant", "augalas", top, (-0.3, -0.02, 0), 20, size=(0.5, 0.3, 0.27))
        scene.model(f"{name} top carton", "cardboard-box", top, (0.3, 0, 0), 4, size=(0.42, 0.28, 0.22))
    else:
        scene.model(f"{name} top basket", "shopping-basket", top, (0.25, 0, 0), 10, size=(0.44, 0.28, 0.26))
        book_pile(scene, f"{name} top pile", top.child(-0.3, 0, 0, 5), seed + 19, 5)


def _ornament(scene, name, place, index):
    key, size = (("vase2", (0.16, 0.16, 0.2)), ("frame2", (0.145, 0.145, 0.199)), ("littlePlant", (0.2, 0.2, 0.2)),
                 ("frame1", None),
                 ("old_jar", (0.19, 0.16, 0.2)), ("littlePlant", (0.18, 0.18, 0.18)))[index % 6]
    scene.model(name, key, place, (0, -0.02, 0.001), -10, size=size)
