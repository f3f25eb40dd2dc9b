# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The shell: 6 m x 6 m x 2.7 m. x east, y north. Window in the west, door in the south."""

from writer import Place, walls

SIZE, HEIGHT = 6.0, 2.7
WINDOW_Y, WINDOW_Z = (2.3, 4.9), (0.92, 2.32)
WALL_DEPTH = 0.24

NORTH, SOUTH, EAST, WEST = walls(SIZE, SIZE)


def add_room(scene):
    s = SIZE
    scene.table("quad", "the shell", name="floor", material="carpet", corner=(0, 0, 0), u=(s, 0, 0), v=(0, s, 0))
    scene.table("quad", name="ceiling", material="ceiling", corner=(0, s, HEIGHT), u=(s, 0, 0), v=(0, -s, 0))
    scene.quad("wall north", "wall", NORTH, (0, 0, 0), (s, 0, 0), (0, 0, HEIGHT))
    scene.quad("wall south", "wall", SOUTH, (0, 0, 0), (s, 0, 0), (0, 0, HEIGHT))
    scene.quad("wall east", "wall accent", EAST, (0, 0, 0), (s, 0, 0), (0, 0, HEIGHT))
    _west_wall(scene)
    _skirting(scene)
    _window(scene)
    _daylight(scene)
    for i, (x, y) in enumerate(((1.8, 1.8), (4.2, 1.8), (1.8, 4.2), (4.2, 4.2))):
        _panel(scene, i, x, y)
    _door(scene)


def _west_wall(scene):
    (y0, y1), (z0, z1), d = WINDOW_Y, WINDOW_Z, WALL_DEPTH
    place = Place(-d / 2, 0)
    for name, low, high, bottom, top in (("south", 0, y0, 0, HEIGHT), ("north", y1, SIZE, 0, HEIGHT),
                                         ("below", y0, y1, 0, z0), ("above", y0, y1, z1, HEIGHT)):
        scene.box(f"wall west {name}", "wall", (d, high - low, top - bottom), place, (0, (low + high) / 2, bottom))


def _skirting(scene):
    t, h = 0.014, 0.075
    s = SIZE
    scene.box("skirting north", "oak", (s, t, h), Place(s / 2, s - t / 2))
    scene.box("skirting east", "oak", (s, t, h), Place(s - t / 2, s / 2, 0, 90))
    scene.box("skirting west", "oak", (s, t, h), Place(t / 2, s / 2, 0, 90))
    scene.box("skirting south west", "oak", (4.3, t, h), Place(2.15, t / 2))
    scene.box("skirting south east", "oak", (0.7, t, h), Place(5.65, t / 2))


def _window(scene):
    """Three casements in a white frame, terrazzo sill, blinds half down, curtains at the sides."""
    (y0, y1), (z0, z1) = WINDOW_Y, WINDOW_Z
    wide, tall = y1 - y0, z1 - z0
    place = WEST.child(y0 + wide / 2, 0.13, z0)
    for name, z in (("bottom", 0), ("top", tall - 0.06)):
        scene.box(f"window frame {name}", "white plastic", (wide, 0.07, 0.06), place, (0, 0, z))
    for i in range(4):
        x = (i / 3 - 0.5) * (wide - 0.07)
        scene.box(f"window post {i}", "white plastic", (0.07, 0.07, tall - 0.12), place, (x, 0, 0.06))
    pane = (wide - 0.07) / 3
    for i in range(3):
        x = (i - 1) * pane
        for part, dx, dz, w, h in (("left", -pane / 2 + 0.06, 0.06, 0.05, tall - 0.12),
                                   ("right", pane / 2 - 0.06, 0.06, 0.05, tall - 0.12),
                                   ("low", 0, 0.06, pane - 0.17, 0.05), ("high", 0, tall - 0.11, pane - 0.17, 0.05)):
            scene.box(f"casement {i} {part}", "white", (w, 0.05, h), place, (x + dx, -0.015, dz))
        scene.box(f"window handle {i}", "metal", (0.02, 0.05, 0.13), place, (x + pane / 2 - 0.06, -0.06, 0.6))
        scene.model(f"blind {i}", "window-blinds", place, (x, -0.075, tall - 0.5), size=(pane - 0.06, 0.05, 0.5))
    scene.box("sill", "sill", (wide + 0.1, 0.3, 0.035), WEST.child(y0 + wide / 2, 0, z0 - 0.02), (0, 0.0, 0))
    for side, x in (("south", y0 - 0.22), ("north", y1 + 0.22)):
        scene.model(f"curtain {side}", "curtain", WEST, (x, -0.13, 0.3), size=(0.52, 0.1, 2.2))
    scene.box("curtain rail", "metal", (wide + 1.1, 0.025, 0.025), WEST, (y0 + wide / 2, -0.13, 2.5))
    scene.model("radiator", "radiator1", WEST, (y0 + wide / 2, -0.09, 0.08), size=(2.163, 0.143, 0.68))


def _daylight(scene):
    """The town is a picture some way off; the sky is a light above what the window shows of it."""
    scene.table("quad", "outside", name="town", material="town", corner=(-5, -4.0, -4.3), u=(0, 15.2, 0), v=(0, 0, 11.4))
    scene.table("light", name="sky", center=(-1.6, 3.6, 3.9), u=(0, 2.4, 0), v=(0.62, 0, 0.62 * 1.2), radiance=(21, 22.5, 25))


def _panel(scene, number, x, y):
    scene.table("light", "ceiling panels" if number == 0 else None, name=f"panel {number}", center=(x, y, HEIGHT - 0.012),
                u=(0.58, 0, 0), v=(0, -0.28, 0), radiance=(9.2, 8.8, 8.1))
    for name, dx, dy, w, d in (("a", 0, 0.295, 1.2, 0.03), ("b", 0, -0.295, 1.2, 0.03), ("c", 0.59, 0, 0.02, 0.56),
                               ("d", -0.59, 0, 0.02, 0.56)):
        scene.box(f"panel {number} rim {name}", "white", (w, d, 0.02), Place(x + dx, y + dy, HEIGHT - 0.02))


def _door(scene):
    door = SOUTH.child(1.1, 0)
    scene.model("door", "door", door, (0, -0.02, 0), materials={"white-door": "beech upright", "white-frame": "white",
                                                                 "metal-handle": "metal"})
    scene.model("exit sign", "emergencySign", door, (0, -0.02, 2.2))
    scene.model("light switch", "switch-whites", SOUTH, (1.85, -0.006, 1.05))
    scene.model("extinguisher", "fireExtinguisher", SOUTH, (0.35, -0.1, 0.75))
