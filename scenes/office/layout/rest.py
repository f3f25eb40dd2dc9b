# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The other three sides and the second desk in the middle of the room."""

from pieces import binder_row, book_pile, book_row, bookshelf, drawers, framed, monitor, pinned
from room import EAST, SOUTH, WEST
from writer import Place

TOP = 0.751
DESK = Place(3.75, 2.25, 0, -90)    # one sits on its west side


def add_rest(scene):
    _second_desk(scene)
    _east(scene)
    _south(scene)
    _west(scene)


def _second_desk(scene):
    scene.model("second desk", "officeTable", DESK, yaw_deg=180,
                materials={"Material.001": "dark metal", "Material.003": "beech", "drawer_lock": "cabinet"})
    scene.model("second chair", "office_chair", Place(2.85, 2.2), yaw_deg=75,
                materials={"tela_sillon_azul": "red fabric", "plastico_negro": "dark plastic"})
    scene.model("visitor's chair", "osakaChair", Place(4.75, 2.55), yaw_deg=-70)
    top = DESK.child(0, 0, TOP)
    scene.model("laptop", "laptop", top, (0.05, -0.02, 0), materials={"Screen": "screen plots"})
    monitor(scene, "third monitor", top.child(-0.5, 0.14, 0, 18), "screen code", 0.5, 0.3)
    for i, (picture, x, y, yaw) in enumerate((("paper 2", 0.42, -0.2, 12), ("paper 5", 0.5, -0.12, -20),
                                              ("paper 3", 0.72, -0.18, 8), ("paper 6", -0.35, -0.24, -10),
                                              ("paper 4", -0.62, -0.2, 25), ("paper 8", 0.75, 0.15, 50))):
        scene.sheet(f"second desk sheet {i}", picture, (0.21, 0.297), top, (x, y, 0.0003 * (i + 1)), yaw)
    scene.model("book", "book", top, (0.52, 0.2, 0), 10)
    scene.model("red lamp", "desk_lamp2", top, (0.8, 0.28, 0), 160)
    scene.model("teapot", "teapot", top, (-0.15, 0.28, 0), 30)
    scene.model("second mug", "coffee-mug", top, (0.3, 0.05, 0), -50, materials={"White_ceramic": "glazed"})
    scene.model("camera", "reflex_camera", top, (-0.2, -0.3, 0), 30)
    scene.model("tablet", "tablet", top, (0.28, -0.26, 0.004), 12)
    scene.model("telephone 2", "wirelessOfficePhone3", top, (-0.78, 0.25, 0), 20)
    book_pile(scene, "second pile", top.child(-0.8, 0.02, 0, -12), 8, 3)
    book_pile(scene, "third pile", top.child(0.2, 0.3, 0, 20), 9, 2)


def _east(scene):
    scene.model("lockers", "office_box", EAST.child(1.55, -0.285),
                materials={"armario_beige.001": "locker", "taronja": "dark metal"})
    front = EAST.child(1.55, -0.5528)
    for i, (picture, x, z, w, h) in enumerate((
            ("paper 4", -0.82, 0.98, 0.21, 0.297), ("poster concert", -0.42, 0.72, 0.42, 0.6), ("sticky 1", -0.62, 1.36, 0.076, 0.076),
            ("paper 7", -0.08, 1.2, 0.21, 0.297), ("poster chart", 0.42, 0.98, 0.6, 0.427), ("sticky 3", 0.0, 1.03, 0.076, 0.076),
            ("paper 1", 0.03, 0.62, 0.21, 0.297), ("poster map", 0.55, 0.32, 0.62, 0.5), ("paper 5", 0.9, 1.1, 0.21, 0.297),
            ("sticky 2", 0.86, 0.95, 0.076, 0.076), ("paper 3", -0.2, 0.25, 0.21, 0.297))):
        scene.hung(f"locker sheet {i}", picture, (w, h), front, (x, 0, z))
        scene.sphere(f"locker magnet {i}", "pin blue" if i % 2 else "pin", 0.009, front, (x, -0.005, z + h - 0.02), 12)
    top = EAST.child(1.55, -0.285, 1.749)
    scene.model("locker carton", "cardboard-box", top, (-0.6, 0, 0), 8)
    scene.model("projector", "video-projector", top, (0.1, 0.02, 0), -10)
    scene.model("locker plant", "augalas", top, (0.72, 0, 0))
    framed(scene, "mountains", "print mountains", (0.75, 0.55), EAST, (3.2, 0, 1.45))
    low = EAST.child(3.75, -0.2)
    boards = bookshelf(scene, "low case", low, (1.9, 0.36, 0.86), 2)
    book_row(scene, "low row 0", low.child(-0.92, -0.14, boards[0]), 1.84, 61, 0.95)
    binder_row(scene, "low row 1", low.child(-0.92, -0.14, boards[1]), 14, 62, None)
    book_row(scene, "low row 2", low.child(0.22, -0.14, boards[1]), 0.66, 63)
    on_top = low.child(0, 0, 0.86)
    scene.model("stereo", "mini_stereo", on_top, (-0.55, 0, 0), 4)
    book_pile(scene, "low pile", on_top.child(0.1, 0, 0, 10), 14, 4)
    scene.model("jar", "jar", on_top, (0.7, 0, 0))
    pinned(scene, "planner", "planner", (1.0, 0.703), EAST, (4.2, 0, 1.4))
    scene.model("big plant", "plant", Place(5.62, 0.92), size=(0.62, 0.55, 1.0))


def _south(scene):
    board = (1.6, 1.0)
    scene.hung("whiteboard", "whiteboard", board, SOUTH, (3.0, -0.02, 0.95))
    for name, x, z, w, h in (("left", 3.0 - 0.81, 0.93, 0.02, 1.04), ("right", 3.0 + 0.81, 0.93, 0.02, 1.04),
                             ("bottom", 3.0, 0.93, 1.64, 0.02), ("top", 3.0, 1.95, 1.64, 0.02)):
        scene.box(f"whiteboard frame {name}", "metal", (w, 0.025, h), SOUTH, (x, -0.0125, z))
    scene.box("whiteboard tray", "metal", (0.8, 0.07, 0.012), SOUTH, (3.0, -0.035, 0.915))
    scene.box("eraser", "blue fabric", (0.13, 0.05, 0.03), SOUTH, (2.8, -0.04, 0.927))
    for i, (x, material) in enumerate(((3.05, "pin"), (3.2, "pin blue"), (3.3, "dark plastic"))):
        scene.box(f"board marker {i}", material, (0.12, 0.014, 0.014), SOUTH, (x, -0.03 - 0.008 * i, 0.927))
    framed(scene, "map", "poster map", (1.1, 0.89), SOUTH, (4.75, 0, 1.15), "beech")
    scene.model("coats", "wall-hanger", SOUTH, (1.98, -0.031, 1.75))
    scene.model("jacket", "suit", SOUTH, (1.98, -0.1, 1.12), materials={"suit1": "suit fabric"})
    sofa = SOUTH.child(4.25, -0.5)
    scene.model("sofa", "couch", sofa, size=(1.9, 0.86, 0.8))
    scene.model("low table", "coffee-table2", SOUTH.child(4.3, -1.45))
    scene.model("table newspaper", "newspaper", SOUTH.child(4.3, -1.45, 0.478), (-0.25, 0.02, 0), 20)
    scene.model("apples", "apples", SOUTH.child(4.3, -1.45, 0.478), (0.3, 0, 0), size=(0.22, 0.22, 0.137))
    drawers(scene, "south cabinet", SOUTH.child(5.74, -0.31), (0.46, 0.6, 1.05), 4)
    scene.model("coffee machine", "coffee_machine", SOUTH.child(5.72, -0.3, 1.05), size=(0.42, 0.36, 0.33))


def _west(scene):
    place = WEST.child(1.25, -0.19)
    boards = bookshelf(scene, "west case", place, (1.0, 0.34, 1.9), 5)
    for i, z in enumerate(boards):
        row = place.child(-0.47, -0.14, z)
        if i % 2:
            binder_row(scene, f"west row {i}", row, 9, 70 + i, i)
        else:
            book_row(scene, f"west row {i}", row, 0.94, 80 + i, 0.85)
    scene.model("sill plant", "littlePlant", WEST, (3.1, 0.02, 0.935), 50, size=(0.22, 0.22, 0.21))
    scene.model("sill radio", "jar", WEST, (4.35, 0.02, 0.935), size=(0.13, 0.13, 0.21))
    book_pile(scene, "sill pile", WEST.child(2.62, 0.0, 0.935, 15), 21, 3)
    pinned(scene, "chart poster", "poster chart", (0.84, 0.6), WEST, (5.52, 0, 1.4))
