# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The hall of the stairs: its walls, landings, windows and light. x from -5.9 to 0, y from -0.2 to 2.6, three storeys."""

import math

from pieces import framed
from writer import Place

WEST_X, LANDING_X, TURN_X = -5.9, -1.6, -4.4      # the hall's end; where flights start; where they turn
SOUTH_Y, NORTH_Y = -0.2, 2.6
STOREY, LOW, HIGH = 3.3, -3.3, 6.4
WALL = 0.2                                        # of the wall between hall and corridor
PORTAL = (0.25, 2.15, 2.45)                       # the opening in it: y from, y to, height
WINDOWS = ((-1.25, 1.1), (2.1, 4.55), (5.2, 6.1))  # z from, z to, in the west wall
WINDOW_Y = (0.3, 2.1)

NORTH = Place(WEST_X, NORTH_Y, 0, 0)              # walls as seen from inside: local x runs right, -y into the hall
SOUTH = Place(0, SOUTH_Y, 0, 180)
EAST = Place(0, NORTH_Y, 0, -90)
WEST = Place(WEST_X, SOUTH_Y, 0, 90)


def add_hall(scene):
    long_, wide, tall = -WEST_X, NORTH_Y - SOUTH_Y, HIGH - LOW
    scene.quad("hall wall north", "hall wall", NORTH, (0, 0, LOW), (long_, 0, 0), (0, 0, tall))
    scene.quad("hall wall south", "hall wall", SOUTH, (0, 0, LOW), (long_, 0, 0), (0, 0, tall))
    scene.table("quad", name="hall ceiling", material="ceiling", corner=(WEST_X, NORTH_Y, HIGH), u=(long_, 0, 0),
                v=(0, -wide, 0))
    scene.table("quad", name="cellar floor", material="floor", corner=(WEST_X, SOUTH_Y, LOW), u=(long_, 0, 0),
                v=(0, wide, 0))
    _east_wall(scene)
    _west_wall(scene)
    _landings(scene)
    _pictures(scene)
    _light(scene)


def _east_wall(scene):
    """Between hall and corridor, with the portal; the parts meet edge to edge."""
    y0, y1, top = PORTAL
    place = Place(WALL / 2, 0)
    for name, a, b, low, high in (("south", SOUTH_Y, y0, LOW, HIGH), ("north", y1, NORTH_Y, LOW, HIGH),
                                  ("above", y0, y1, top, HIGH),
                                  ("below", y0, y1, LOW, -0.2)):
        _pier(scene, f"hall wall east {name}", WALL, (a, b), (low, high), place)
    middle = (y0 + y1) / 2
    scene.box("threshold", "tread", (WALL, y1 - y0, 0.2), place, (0, middle, -0.2))
    for name, y in (("south", y0 + 0.04), ("north", y1 - 0.04)):
        scene.box(f"portal post {name}", "oak upright", (WALL + 0.08, 0.08, top + 0.01), place, (0, y, -0.01))
    scene.box("portal head", "oak", (WALL + 0.08, y1 - y0 - 0.16, 0.08), place, (0, middle, top - 0.08))
    scene.model("upper door", "door", EAST, (1.4, -0.02, STOREY),
                materials={"white-door": "door", "white-frame": "door frame", "metal-handle": "steel"})
    scene.model("exit sign", "emergencySign", EAST, (1.4, -0.02, top + 0.1))


def _pier(scene, name, thick, across, upright, place):
    """A tall part of a wall, in pieces as high as its picture, since light is stored coarsely on long thin faces."""
    (y0, y1), (low, high) = across, upright
    tile = 2.1
    for i in range(math.ceil((high - low) / tile)):
        z = low + i * tile
        scene.box(f"{name} {i}", "hall wall", (thick, y1 - y0, min(tile, high - z)), place, (0, (y0 + y1) / 2, z))


def _west_wall(scene):
    a, b = WINDOW_Y
    place = Place(WEST_X - 0.15, 0)
    edges = [LOW, *(z for pair in WINDOWS for z in pair), HIGH]
    for name, y0, y1 in (("south", SOUTH_Y, a), ("north", b, NORTH_Y)):
        _pier(scene, f"hall wall west {name}", 0.3, (y0, y1), (LOW, HIGH), place)
    for i in range(0, len(edges), 2):
        scene.box(f"hall wall west {i}", "hall wall", (0.3, b - a, edges[i + 1] - edges[i]), place,
                  (0, (a + b) / 2, edges[i]))
    for i, (z0, z1) in enumerate(WINDOWS):
        _sashes(scene, f"hall window {i}", Place(WEST_X - 0.12, (a + b) / 2, z0, 90), b - a, z1 - z0)
        scene.box(f"hall sill {i}", "tread", (b - a - 0.01, 0.34, 0.03), Place(WEST_X - 0.1, (a + b) / 2, z0, 90))
    scene.table("quad", "outside", name="town west", material="town", corner=(-22, -13, -12), u=(0, 28, 0),
                v=(0, 0, 21))


def _sashes(scene, name, place, wide, tall):
    """A window of iron bars, three panes wide."""
    for i in range(4):
        scene.box(f"{name} post {i}", "white paint", (0.05, 0.06, tall - 0.1), place,
                  ((i / 3 - 0.5) * (wide - 0.05), 0, 0.05))
    for i in range(max(2, round(tall / 0.6)) + 1):
        rows = max(2, round(tall / 0.6))
        heavy = i in (0, rows)
        z = i / rows * (tall - 0.05)
        for k in range(3):
            scene.box(f"{name} bar {i} {k}", "white paint", ((wide - 0.2) / 3, 0.06 if heavy else 0.04,
                                                             0.05 if heavy else 0.03), place,
                      ((k - 1) * (wide - 0.05) / 3, 0, z))
    scene.box(f"{name} lever", "steel", (0.02, 0.05, 0.14), place, (0.28, -0.055, tall * 0.45))


def _landings(scene):
    wide = NORTH_Y - SOUTH_Y
    middle = (NORTH_Y + SOUTH_Y) / 2
    for i, z in enumerate((0, STOREY)):
        scene.box(f"landing {i}", None, (-LANDING_X, wide, 0.2), Place(LANDING_X / 2, middle, z - 0.2), faces={
            "top": "floor", "bottom": "soffit", **{side: "riser" for side in ("front", "back", "left", "right")}})
    for i, z in enumerate((-STOREY / 2, STOREY / 2, 1.5 * STOREY)):
        scene.box(f"half landing {i}", None, (TURN_X - WEST_X, wide, 0.2),
                  Place((TURN_X + WEST_X) / 2, middle, z - 0.2), faces={
            "top": "floor", "bottom": "soffit", **{side: "riser" for side in ("front", "back", "left", "right")}})


def _pictures(scene):
    """Framed classes climb with the stairs; the directory hangs by the portal."""
    for i, (x, z, picture) in enumerate(((0.9, 2.95, "class photo 1"), (1.75, 2.75, "class photo 2"),
                                         (2.6, 2.25, "class photo 1"), (3.4, 1.75, "class photo 2"))):
        framed(scene, f"class {i}", picture, (0.54, 0.42), NORTH, (x, 0, z), "handrail", 0.025)
    framed(scene, "botany 1", "botanical 1", (0.36, 0.49), SOUTH, (2.1, 0, 1.5), "handrail", 0.02)
    framed(scene, "botany 2", "botanical 2", (0.36, 0.49), SOUTH, (2.7, 0, 1.2), "handrail", 0.02)
    framed(scene, "pupils' work", "painting abstract", (0.6, 0.6), SOUTH, (3.6, 0, 0.55), "white paint", 0.02)
    scene.box("directory back", "steel", (0.52, 0.02, 0.68), NORTH, (5.3, -0.01, 1.2))
    scene.hung("directory", "floors sign", (0.48, 0.64), NORTH, (5.3, -0.021, 1.22))
    framed(scene, "escape plan hall", "escape plan", (0.42, 0.297), SOUTH, (0.75, 0, 1.5), "steel", 0.012)
    scene.model("hall plant", "plant", Place(WEST_X + 0.42, 2.2, STOREY / 2), size=(0.6, 0.52, 0.95))
    scene.model("cellar plant", "maceta", Place(WEST_X + 0.45, 2.15, -STOREY / 2), size=(0.5, 0.55, 0.55))


def _light(scene):
    """The sky high over the west windows, globes on rods from the ceilings."""
    scene.table("light", "light", name="sky west", center=(-8.0, 1.2, 9.3), u=(0, 3, 0), v=(1.5, 0, 0.45),
                radiance=(105, 112, 124))
    globes = ((-0.8, 2.5, STOREY - 0.2), (-0.8, 5.7, HIGH), (-5.15, 1.05, STOREY / 2 - 0.2),
              (-5.15, 4.25, 1.5 * STOREY - 0.2))
    for i, (x, z, top) in enumerate(globes):
        place, radius = Place(x, 1.2, z), 0.13
        scene.sphere(f"globe {i}", "globe", radius, place, (0, 0, 0), 32)
        scene.cylinder(f"globe rod {i}", "iron", 0.01, top - z - radius + 0.005, place, (0, 0, radius - 0.005), 8)
        for side, v in (("down", -0.1), ("up", 0.1)):
            scene.table("light", name=f"globe light {i} {side}", center=(x, 1.2, z + 1.45 * v), u=(0.1, 0, 0),
                        v=(0, v, 0), radiance=(64, 57, 43))
