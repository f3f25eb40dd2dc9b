# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The north side: the desk around which the desk trajectory moves, and what stands beside it."""

from pieces import binder_row, book_pile, book_row, bookshelf, drawers, framed, monitor, pinned
from room import NORTH
from writer import Place

TOP = 0.754
DESK = Place(2.45, 5.47, 0)
BOOKCASE_GAPS = (0.101, 0.446, 1.132)  # boards that the model leaves empty


def add_desk(scene):
    scene.model("desk", "wooden_office_alder_table", DESK)
    scene.model("chair", "office-chair", Place(1.12, 4.6), yaw_deg=120,
                materials={"Office_CH_fabric": "blue fabric", "Office_CH_plastic": "dark plastic"})
    top = DESK.child(0, 0, TOP)
    _screens(scene, top)
    _papers(scene, top)
    _things(scene, top)
    _wall(scene)
    _beside(scene)


def _screens(scene, top):
    monitor(scene, "left monitor", top.child(-0.25, 0.2, 0, 12), "screen code")
    monitor(scene, "right monitor", top.child(0.34, 0.22, 0, -13), "screen plots")
    scene.box("keyboard", None, (0.45, 0.15, 0.018), top, (-0.02, -0.22, 0), 3, faces={
        "top": "keyboard", **{side: "dark plastic" for side in ("bottom", "front", "back", "left", "right")}})
    scene.box("mouse mat", "gray fabric", (0.24, 0.2, 0.003), top, (0.38, -0.22, 0), -4)
    scene.sphere("mouse", "dark plastic", 0.03, top, (0.37, -0.21, 0.006), 32)
    scene.box("cable tray", "dark plastic", (0.5, 0.03, 0.012), top, (0.05, 0.4, 0))


def _papers(scene, top):
    sheets = (("paper 1", -0.42, -0.2, 14), ("paper 4", -0.57, -0.25, -9), ("paper 3", -0.36, -0.22, 27),
              ("paper 6", 0.62, -0.15, -17), ("paper 2", 0.6, -0.08, 8), ("paper 7", -0.6, 0.05, 38),
              ("paper 8", 0.63, 0.05, -32), ("paper 5", 0.15, -0.13, 5))
    for i, (picture, x, y, yaw) in enumerate(sheets):
        scene.sheet(f"sheet {i}", picture, (0.21, 0.297), top, (x, y, 0.0003 * (i + 1)), yaw)
    scene.sheet("notebook", "notebook", (0.29, 0.205), top, (-0.38, -0.1, 0.008), 9)
    scene.box("notebook body", "board", (0.29, 0.205, 0.0072), top, (-0.38, -0.1, 0), 9)
    stickies = ((0.02, -0.1, 12), (0.11, -0.115, -8), (0.5, -0.24, 20), (-0.2, -0.31, -25), (0.69, -0.2, 15))
    for i, (x, y, yaw) in enumerate(stickies):
        scene.sheet(f"note {i}", f"sticky {i % 4 + 1}", (0.076, 0.076), top, (x, y, 0.003 + 0.0002 * i), yaw)
    scene.model("newspaper", "newspaper", top, (0.62, -0.02, 0.0025), 12, size=(0.27, 0.24, 0.012))


def _things(scene, top):
    scene.model("desk lamp", "desk_lamp1", top, (-0.7, 0.3, 0), 35)
    book_pile(scene, "pile left", top.child(-0.66, 0.12, 0, 6), 3, 5)
    book_pile(scene, "pile right", top.child(0.66, 0.3, 0, -8), 5, 4)
    scene.model("mug", "coffee-mug", top, (-0.13, -0.13, 0), 40, materials={"White_ceramic": "glazed blue"})
    scene.model("espresso", "caffe_final", top, (0.53, 0.02, 0.0145))
    scene.model("paper cup", "coffee_cup", top, (0.08, 0.06, 0))
    scene.model("pens", "penbox", top, (-0.46, 0.34, 0))
    scene.model("calendar", "kalender", top, (0.04, 0.28, 0), 4)
    scene.model("stapler", "stapler", top, (0.27, -0.06, 0), 65)
    scene.model("scissors", "cissors_swap", top, (-0.32, -0.29, 0.0025), 28)
    scene.model("text marker", "textMarker", top, (-0.44, -0.33, 0.003), 70)
    scene.model("cube", "rubix2", top, (0.24, 0.05, 0), 25)
    scene.model("succulent", "succulentPlant", top, (-0.03, 0.39, 0))
    scene.model("photograph", "frame1", top, (0.44, 0.4, 0), -15)
    scene.model("telephone", "phone", top, (-0.6, -0.1, 0.003), 22)
    scene.model("glasses", "glasses", top, (-0.32, -0.13, 0.009), 160)
    scene.model("keys", "keys", top, (0.43, 0.12, 0))
    for i, (x, y, yaw) in enumerate(((0.21, -0.3, 80), (0.56, -0.22, 110), (-0.4, -0.12, 20), (-0.5, -0.36, 85))):
        scene.model(f"pen {i}", "pencil1", top, (x, y, 0.003 if y < -0.15 else 0.0078), yaw)


def _wall(scene):
    scene.hung("cork board", "corkboard", (1.2, 0.75), NORTH, (1.95, -0.018, 1.34))
    for name, x, z, w, h in (("left", 1.34, 1.32, 0.025, 0.79), ("right", 2.56, 1.32, 0.025, 0.79),
                             ("bottom", 1.95, 1.315, 1.245, 0.025), ("top", 1.95, 2.09, 1.245, 0.025)):
        scene.box(f"cork board frame {name}", "oak", (w, 0.03, h), NORTH, (x, -0.015, z))
    pinned(scene, "concert poster", "poster concert", (0.5, 0.714), NORTH, (0.92, 0, 1.36))
    scene.hung("clock", "clock face", (0.3, 0.3), NORTH, (2.95, -0.02, 2.2))
    for i, x in enumerate((2.9, 3.5)):
        scene.box(f"bracket {i}", "dark metal", (0.02, 0.2, 0.02), NORTH, (x, -0.1, 1.46))
        scene.box(f"bracket leg {i}", "dark metal", (0.02, 0.02, 0.16), NORTH, (x, -0.01, 1.32))
    scene.box("wall shelf", "oak", (1.1, 0.24, 0.025), NORTH, (3.2, -0.12, 1.48))
    shelf = NORTH.child(2.68, -0.215, 1.505)
    end = book_row(scene, "wall shelf", shelf, 1.0, 11, 0.7)
    scene.model("shelf plant", "littlePlant", shelf, (end + 0.16, 0.11, 0), 15, size=(0.2, 0.2, 0.2))
    pinned(scene, "pinhole poster", "poster pinhole", (0.42, 0.59), NORTH, (3.42, 0, 1.82))
    scene.model("socket", "plug-TypeE-whites", NORTH, (3.32, -0.0035, 0.3))
    scene.model("network socket", "RJ-45-whites", NORTH, (3.42, -0.003, 0.3))


def _beside(scene):
    drawers(scene, "filing cabinet", Place(3.56, 5.68), (0.42, 0.6, 0.76), 3)
    scene.model("printer", "inkjet_and_scanner_printer", Place(3.56, 5.7, 0.76))
    scene.sheet("printed page", "paper 2", (0.21, 0.297), Place(3.55, 5.62, 0.9505), (0, 0, 0), 6)
    scene.model("bookcase", "full-bookcase", Place(4.3, 5.81))
    for i, z in enumerate(BOOKCASE_GAPS):
        row = Place(4.3 - 0.41, 5.81 - 0.13, z)
        if i < 2:
            binder_row(scene, f"bookcase row {i}", row, (10, 7)[i], 50 + i, 2 * i)
        else:
            book_row(scene, f"bookcase row {i}", row, 0.82, 52, 0.75)
    book_pile(scene, "bookcase pile", Place(4.57, 5.82, BOOKCASE_GAPS[1]), 53, 5)
    place = Place(5.25, 5.8)
    boards = bookshelf(scene, "binder case", place, (0.95, 0.34, 2.05), 5)
    for i, z in enumerate(boards):
        row = place.child(-0.45, -0.14, z)
        if i < 3:
            binder_row(scene, f"case row {i}", row, 11 - i, 30 + i, i)
        else:
            book_row(scene, f"case row {i}", row, 0.88, 40 + i, 0.9)
    scene.model("carton", "cardboard-box", Place(5.25, 5.8, 2.05), size=(0.5, 0.3, 0.27))
    _corner(scene)
    scene.model("bin", "dustbin", Place(3.2, 4.98))
    _computer(scene, Place(2.95, 5.55))
    scene.model("open carton", "open-cardboard-box", Place(4.05, 5.1), yaw_deg=25, size=(0.6, 0.46, 0.34))


def _corner(scene):
    """Between desk and window: a low case under small pictures, the yucca before it."""
    scene.model("yucca", "yuccaPlant", Place(0.56, 5.3))
    place = Place(1.26, 5.84)
    boards = bookshelf(scene, "corner case", place, (0.7, 0.3, 0.78), 2)
    book_row(scene, "corner row 0", place.child(-0.32, -0.12, boards[0]), 0.64, 55)
    binder_row(scene, "corner row 1", place.child(-0.32, -0.14, boards[1]), 5, 56, 3)
    book_pile(scene, "corner shelf pile", place.child(0.19, 0.02, boards[1], 5), 57, 4)
    top = place.child(0, 0, 0.78)
    book_pile(scene, "corner pile", top.child(-0.2, 0, 0, 12), 58, 4)
    scene.model("corner plant", "bonsai-tree", top, (0.12, 0, 0), 30, size=(0.36, 0.3, 0.34))
    framed(scene, "small map", "poster map", (0.34, 0.275), NORTH, (0.42, 0, 1.15), "walnut", 0.02)
    framed(scene, "small print", "print mountains", (0.34, 0.25), NORTH, (0.42, 0, 0.72), "walnut", 0.02)


def _computer(scene, place):
    """The tower under the desk."""
    scene.box("computer", "dark plastic", (0.19, 0.44, 0.42), place, (0, 0, 0.012))
    for i, (z, h) in enumerate(((0.36, 0.045), (0.305, 0.045), (0.25, 0.045))):
        scene.box(f"computer bay {i}", "gray plastic", (0.16, 0.006, h), place, (0, -0.222, z))
    scene.box("computer button", "metal", (0.025, 0.008, 0.025), place, (0.05, -0.222, 0.19))
    for i in range(6):
        scene.box(f"computer grille {i}", "dark metal", (0.15, 0.006, 0.008), place, (0, -0.222, 0.04 + 0.02 * i))
    for x in (-0.07, 0.07):
        scene.box("computer foot", "dark metal", (0.03, 0.36, 0.012), place, (x, 0, 0))
