# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""What stands and hangs along the corridor: boards, lockers, benches, coats, radiators, a vending machine."""

import random

from corridor import END, HEIGHT, NORTH, SOUTH, WIDE
from pieces import framed, pinned
from writer import Place


def add_fittings(scene):
    _boards(scene)
    _lockers(scene, "lockers north", NORTH.child(8.55, -0.2), 5)
    _lockers(scene, "lockers south", SOUTH.child(-14.8, -0.2), 6)
    for i, (wall, x) in enumerate(((SOUTH, -6.75), (NORTH, 13.1), (SOUTH, -2.35))):
        scene.model(f"bench {i}", "cc0/bench", wall.child(x, -0.26), size=(1.5, 0.4, 0.46))
    _coats(scene, SOUTH.child(-6.75, 0))
    for i, x in enumerate((-3.5, -11.2)):
        scene.model(f"radiator {i}", "radiator1", SOUTH.child(x, -0.085), (0, 0, 0.14), size=(0.95, 0.12, 0.64))
    _safety(scene)
    _machine(scene, NORTH.child(17.2, -0.42))
    _odds(scene)


def _board(scene, name, picture, size, wall, x, z):
    """A board in an oak frame."""
    framed(scene, name, picture, size, wall, (x, 0, z), "oak", 0.035)


def _boards(scene):
    _board(scene, "notices 1", "notices", (1.6, 0.97), NORTH, 4.7, 1.42)
    _board(scene, "cork", "corkboard", (1.3, 0.81), SOUTH, -10.9, 1.42)
    _board(scene, "notices 2", "notices", (1.4, 0.85), NORTH, 13.1, 1.45)
    _board(scene, "planner", "planner", (0.9, 0.63), SOUTH, -2.3, 1.48)
    for i, (wall, picture, w, h, x, z) in enumerate((
            (NORTH, "poster concert", 0.5, 0.714, 1.35, 1.5), (SOUTH, "poster map", 0.95, 0.77, -6.75, 1.85),
            (NORTH, "timetable", 0.6, 0.43, 5.85, 1.6),
            (SOUTH, "poster pinhole", 0.5, 0.7, -9.75, 1.5), (NORTH, "poster chart", 0.84, 0.6, 9.9, 1.95),
            (SOUTH, "timetable", 0.6, 0.43, -3.2, 1.55),
            (NORTH, "poster concert", 0.5, 0.714, 12.1, 1.5), (NORTH, "poster map", 0.74, 0.6, 14.3, 1.55),
            (SOUTH, "poster chart", 0.5, 0.357, -11.88, 1.55),
            (NORTH, "paper 3", 0.21, 0.297, 3.55, 1.6), (SOUTH, "paper 6", 0.21, 0.297, -7.75, 1.55),
            (SOUTH, "paper 1", 0.21, 0.297, -5.45, 1.6),
            (NORTH, "paper 8", 0.21, 0.297, 7.75, 1.55), (NORTH, "escape plan", 0.42, 0.297, 16.3, 1.55))):
        pinned(scene, f"poster {i}", picture, (w, h), wall, (x, 0, z))
    framed(scene, "year 1", "class photo 1", (0.54, 0.42), NORTH, (0.78, 0, 2.4), "handrail", 0.025)
    framed(scene, "year 2", "class photo 2", (0.54, 0.42), SOUTH, (-13.0, 0, 2.35), "handrail", 0.025)
    for i, (wall, x) in enumerate(((NORTH, 2.6), (SOUTH, -4.6), (NORTH, 6.8), (SOUTH, -8.8), (NORTH, 11.0),
                                   (NORTH, 15.2))):
        sheet = f"paper {i + 1}"
        pinned(scene, f"on door {i}", sheet, (0.21, 0.297), wall.child(x, -0.062),
               (0.08 * (i % 3 - 1), 0, 1.35 + 0.1 * (i % 2)))


def _lockers(scene, name, place, count):
    rng = random.Random(len(name) + count)
    for i in range(count):
        x = (i - (count - 1) / 2) * 0.305
        tint = rng.randrange(3)
        scene.box(f"{name} {i}", None, (0.3, 0.4, 1.85), place, (x, 0, 0.08), faces={
            "front": f"locker {tint}", **{side: "locker side" for side in ("top", "bottom", "back", "left", "right")}})
    scene.box(f"{name} plinth", "iron", (count * 0.305 - 0.02, 0.36, 0.08), place)
    scene.model(f"{name} carton", "cardboard-box", place, (0.3, 0.02, 1.93), 6, size=(0.45, 0.3, 0.26))
    if count > 5:
        scene.model(f"{name} ball", "basketball", place, (-0.3, 0, 1.93))


def _coats(scene, wall):
    scene.box("coat rail", "oak", (1.6, 0.025, 0.12), wall, (0, -0.0125, 1.6))
    for i in range(7):
        x = -0.69 + 0.23 * i
        scene.box(f"hook {i}", "iron", (0.02, 0.07, 0.02), wall, (x, -0.06, 1.64))
        scene.sphere(f"hook knob {i}", "iron", 0.014, wall, (x, -0.1, 1.655), 12)
    for i, (x, material) in enumerate(((-0.69, "coat blue"), (0.23, "coat red"), (0.69, "coat green"))):
        scene.model(f"coat {i}", "suit", wall, (x, -0.1, 1.0), materials={"*": material}, size=(0.42, 0.13, 0.62))


def _safety(scene):
    scene.box("hose cabinet", None, (0.6, 0.16, 0.72), NORTH.child(10.15, -0.078), (0, 0, 0.75), faces={
        "front": "hose cabinet", **{side: "red" for side in ("top", "bottom", "back", "left", "right")}})
    scene.model("extinguisher", "fireExtinguisher", NORTH.child(1.75, -0.1), (0, 0, 0.55))
    scene.model("extinguisher 2", "fireExtinguisher", SOUTH.child(-15.95, -0.1), (0, 0, 0.55))
    for i, (wall, x) in enumerate(((NORTH, 3.7), (SOUTH, -13.74))):
        scene.box(f"alarm {i}", "red", (0.09, 0.04, 0.09), wall.child(x, -0.02), (0, 0, 1.42))
        scene.sphere(f"alarm knob {i}", "white paint", 0.018, wall.child(x, -0.04), (0, 0, 1.465), 16)
    for i, x in enumerate((5.4, 12.0)):
        for side, yaw in (("west", -90), ("east", 90)):
            offset = -0.022 if side == "west" else 0.022
            scene.model(f"exit sign {i} {side}", "emergencySign", Place(x + offset, WIDE / 2, 2.62, yaw),
                        size=(0.36, 0.035, 0.12))
        for y in (-0.14, 0.14):
            scene.cylinder(f"exit rod {i} {y:+}", "steel", 0.005, HEIGHT - 2.74, Place(x, WIDE / 2 + y, 2.74),
                           (0, 0, 0), 8)
    for i, x in enumerate((3.4, 9.4, 15.4)):
        scene.model(f"smoke detector {i}", "smoke-detector", Place(x, WIDE / 2 + 0.3, HEIGHT - 0.045),
                    size=(0.12, 0.12, 0.045))


def _machine(scene, place):
    scene.box("vending machine", None, (0.95, 0.8, 1.85), place, (0, 0, 0.03), faces={
        "front": "vending", **{side: "machine" for side in ("top", "bottom", "back", "left", "right")}})
    scene.model("bin", "dustbin", place.child(-0.75, -0.15))
    scene.model("cone", "cone", Place(16.0, 0.4), size=(0.3, 0.3, 0.5))


def _odds(scene):
    scene.box("clock arm", "iron", (0.03, 0.35, 0.03), NORTH.child(9.45, -0.175), (0, 0, 2.62))
    case = Place(9.45, WIDE - 0.45, 2.63)
    scene.box("clock case", "iron", (0.05, 0.34, 0.34), case, (0, 0, -0.17))
    for side, yaw in (("west", -90), ("east", 90)):
        scene.hung(f"clock {side}", "clock face", (0.32, 0.32),
                   case.child(0.0255 if side == "east" else -0.0255, 0, 0, yaw), (0, 0, -0.16))
    for i, (y0, yaw) in enumerate(((0.0, 8), (0.0, 188))):
        board = Place(7.7, 1.75, 0, 100 + yaw)
        scene.table("quad", name=f"wet floor {i}", material="wet floor", corner=board.point(-0.13, -0.14, 0.0),
                    u=board.vector(0.26, 0), v=(*board.vector(0, 0.125)[:2], 0.56))
    scene.model("water cooler", "water_cooler", SOUTH.child(-17.45, -0.2))
    scene.model("end plant", "yuccaPlant", Place(END - 0.42, 0.45, 0, 30), size=(0.62, 0.6, 1.35))
    scene.model("umbrella", "umbrellaFolded", SOUTH.child(-7.85, -0.12), size=(0.14, 0.14, 0.8))
    scene.model("broom", "broom", NORTH.child(16.45, -0.06), size=(0.3, 0.07, 1.45))
    scene.model("backpack", "shopping-basket", NORTH.child(12.1, -0.26), (0, 0, 0), 20, size=(0.3, 0.24, 0.26))
    scene.model("forgotten ball", "ballonFoot", Place(4.05, 0.32))
