# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The corridor: x from 0.2 to 18, y from 0 to 2.4, 3.1 m high; eight doors, tiles to shoulder height, a window at its end."""

import math

from hall import PORTAL, WALL
from mesh import Mesh
from writer import Place

START, END, WIDE, HEIGHT = WALL, 18.0, 2.4, 3.1
DADO = 1.35
PIPES = ((0.09, HEIGHT - 0.16), (0.17, HEIGHT - 0.1))                # y, z of the heating pipes
NORTH_DOORS = ((2.6, 101), (6.8, 103), (11.0, 105), (15.2, 107))    # x of the middle, the room
SOUTH_DOORS = ((4.6, 102), (8.8, 104), (13.0, 106), (16.6, 108))
BUILT_IN = {"north": [(7.78, 9.32), (9.85, 10.45)], "south": [(13.88, 15.72)]}   # what else stands against the tiles

NORTH = Place(0, WIDE, 0, 0)             # walls as seen from inside: local x is x
SOUTH = Place(0, 0, 0, 180)              # local x is -x
EAST = Place(END, WIDE, 0, -90)          # local x is WIDE - y


def add_corridor(scene):
    long_ = END - START
    for i, (x, step) in enumerate(_fields(START, long_, 2.4)):
        scene.table("quad", "the corridor" if i == 0 else None, name=f"floor {i}", material="floor", corner=(x, 0, 0),
                    u=(step, 0, 0), v=(0, WIDE, 0))
    for i, (x, step) in enumerate(_fields(START, long_, 3)):
        scene.table("quad", name=f"ceiling {i}", material="ceiling", corner=(x, WIDE, HEIGHT), u=(step, 0, 0),
                    v=(0, -WIDE, 0))
    for name, wall, left in (("north", NORTH, START), ("south", SOUTH, -END)):
        for i, (x, step) in enumerate(_fields(left, long_, 1.8)):
            scene.quad(f"tiles {name} {i}", "tiles", wall, (x, 0, 0), (step, 0, 0), (0, 0, DADO))
        for i, (x, step) in enumerate(_fields(left, long_, 2.4)):
            scene.quad(f"wall {name} {i}", "wall", wall, (x, 0, DADO), (step, 0, 0), (0, 0, HEIGHT - DADO))
    for name, y, doors in (("north", WIDE - 0.006, NORTH_DOORS), ("south", 0.006, SOUTH_DOORS)):
        gaps = sorted([(x - 0.5, x + 0.5) for x, _ in doors] + BUILT_IN[name])
        edges = [START + 0.01, *(edge for gap in gaps for edge in gap), END]
        for i in range(0, len(edges), 2):
            a, b = edges[i], edges[i + 1]
            scene.box(f"tile band {name} {i}", "tile band", (b - a, 0.016, 0.04), Place((a + b) / 2, y, DADO - 0.02))
            scene.box(f"skirting {name} {i}", "tile band", (b - a, 0.016, 0.102), Place((a + b) / 2, y, -0.002))
    for wall, sign, list_ in ((NORTH, 1, NORTH_DOORS), (SOUTH, -1, SOUTH_DOORS)):
        for x, room in list_:
            _door(scene, wall.child(sign * x, 0), room)
    _end_wall(scene)
    _portal_leaves(scene)
    _lamps(scene)
    scene.mesh("pipes", _pipes(), Place(0, 0), {"pipe": "pipe", "iron": "iron"})


def _fields(start, long_, step):
    """(start, length) of fields of `step` metres, a whole number of repeats of their picture; the last one shorter."""
    count = math.ceil(long_ / step)
    return [(start + i * step, min(step, long_ - i * step)) for i in range(count)]


def _door(scene, place, room):
    name = f"door {room}"
    scene.model(name, "door", place, (0, -0.02, 0), size=(1.0, 0.175, 2.15),
                materials={"white-door": "door", "white-frame": "door frame", "metal-handle": "steel"})
    scene.box(f"{name} plate back", "steel", (0.25, 0.008, 0.21), place, (0.68, -0.004, 1.5))
    scene.hung(f"{name} plate", f"plate {room}", (0.24, 0.2), place, (0.68, -0.0085, 1.505))
    scene.model(f"{name} switch", "switch-whites", place, (0.68, -0.006, 1.1))


def _end_wall(scene):
    """The east end: a tall window over a radiator."""
    t, (a, b), (z0, z1) = 0.3, (0.55, 1.85), (0.95, 2.65)
    place = Place(END + t / 2, 0)
    for name, y0, y1, low, high in (("south", 0, a, 0, HEIGHT), ("north", b, WIDE, 0, HEIGHT), ("below", a, b, 0, z0),
                                    ("above", a, b, z1, HEIGHT)):
        scene.box(f"end wall {name}", "tiles" if name == "below" else "wall", (t, y1 - y0, high - low), place,
                  (0, (y0 + y1) / 2, low))
    frame = Place(END + 0.14, (a + b) / 2, z0, -90)
    for i in range(3):
        scene.box(f"end window post {i}", "white paint", (0.06, 0.07, z1 - z0 - 0.12), frame,
                  ((i - 1) * (b - a - 0.06) / 2, 0, 0.06))
    for i, z in enumerate((0, 1.1, z1 - z0 - 0.06)):
        for k in (-1, 1):
            scene.box(f"end window bar {i} {k}", "white paint", ((b - a - 0.18) / 2, 0.07, 0.06 if i != 1 else 0.04),
                      frame, (k * (b - a - 0.06) / 4, 0, z))
    scene.box("end sill", "tread", (b - a - 0.01, 0.4, 0.03), Place(END + 0.08, (a + b) / 2, z0, -90))
    scene.model("end radiator", "radiator1", EAST, (WIDE / 2, -0.09, 0.14), size=(1.3, 0.12, 0.66))
    scene.table("quad", "outside", name="town east", material="town", corner=(32, 13, -7.6), u=(0, -24, 0),
                v=(0, 0, 18))
    scene.table("light", name="sky east", center=(20.6, 1.2, 4.7), u=(0, -2.2, 0), v=(-0.5, 0, 0.7),
                radiance=(50, 53, 57))


def _portal_leaves(scene):
    """Two glazed leaves, hooked open against the corridor's walls."""
    _, _, top = PORTAL
    wide, tall = 0.86, top - 0.1
    for name, y in (("north", WIDE - 0.12), ("south", 0.12)):
        place = Place(START + 0.06 + wide / 2, y)
        for part, x in (("hinge", -wide / 2 + 0.05), ("lock", wide / 2 - 0.05)):
            scene.box(f"leaf {name} {part}", "oak upright", (0.1, 0.045, tall), place, (x, 0, 0.01))
        for i, (z, h) in enumerate(((0.01, 0.2), (0.85, 0.12), (tall - 0.11, 0.12))):
            scene.box(f"leaf {name} rail {i}", "oak", (wide - 0.2, 0.045, h), place, (0, 0, z))
        scene.box(f"leaf {name} panel", "oak upright", (wide - 0.2, 0.018, 0.64), place, (0, 0, 0.21))
        scene.box(f"leaf {name} bar", "oak", (wide - 0.2, 0.03, 0.03), place, (0, 0, 1.55))
        scene.box(f"leaf {name} pull", "steel", (0.03, 0.13, 0.3), place, (wide / 2 - 0.05, 0, 1.02))


def _lamps(scene):
    for i in range(6):
        x = 1.9 + 3.0 * i
        scene.box(f"lamp case {i}", "white paint", (1.3, 0.22, 0.07), Place(x, WIDE / 2, HEIGHT - 0.07))
        scene.table("light", "lamps" if i == 0 else None, name=f"lamp {i}", center=(x, WIDE / 2, HEIGHT - 0.075),
                    u=(0.6, 0, 0), v=(0, -0.08, 0), radiance=(20, 19.5, 18))


def _pipes():
    """Heating pipes under the ceiling along the south wall, with clamps, and one that drops at each radiator."""
    mesh = Mesh()
    for y, z in PIPES:
        mesh.tube("pipe", [(START + 0.01, y, z), (END - 0.01, y, z)], 0.026, 10)
    for i in range(12):
        x = 0.9 + 1.5 * i
        for y, z in PIPES:
            mesh.tube("iron", [(x, y, z), (x + 0.03, y, z)], 0.031, 10)
        mesh.tube("iron", [(x + 0.015, 0.002, HEIGHT - 0.13), (x + 0.015, 0.22, HEIGHT - 0.13)], 0.007, 6)
    for x in (3.66, 11.4):
        mesh.tube("pipe", [(x, 0.06, 0.75), (x, 0.06, HEIGHT - 0.19)], 0.016, 8)
    return mesh
