# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The shell: 6.6 m x 5.4 m x 2.85 m. x east, y north. French window and window in the south, double door in the north."""

from writer import Place, walls

WIDE, DEEP, HEIGHT = 6.6, 5.4, 2.85
WALL_DEPTH = 0.3
FRENCH = (1.25, 3.95, 0.04, 2.4)        # openings in the south wall: x from, x to, z from, z to
WINDOW = (4.95, 6.05, 0.9, 2.4)

NORTH, SOUTH, EAST, WEST = walls(WIDE, DEEP)
HALL_DOOR = 3.35                        # x of its middle


def add_shell(scene):
    w, d, h = WIDE, DEEP, HEIGHT
    scene.table("quad", "the shell", name="floor", material="parquet", corner=(0, 0, 0), u=(w, 0, 0), v=(0, d, 0))
    scene.table("quad", name="ceiling", material="ceiling", corner=(0, d, h), u=(w, 0, 0), v=(0, -d, 0))
    scene.quad("wall north", "wall", NORTH, (0, 0, 0), (w, 0, 0), (0, 0, h))
    scene.quad("wall east", "wall", EAST, (0, 0, 0), (d, 0, 0), (0, 0, h))
    scene.quad("wall west", "wallpaper", WEST, (0, 0, 0), (d, 0, 0), (0, 0, h))
    _south_wall(scene)
    _trim(scene)
    for name, opening, lights in (("french", FRENCH, 4), ("window", WINDOW, 2)):
        _casements(scene, name, opening, lights)
        _curtains(scene, name, opening)
    _balcony(scene)
    scene.box("window sill", "marble", (1.25, 0.42, 0.03), Place(5.5, -0.06, WINDOW[2] - 0.03))
    scene.model("radiator", "radiator1", SOUTH, (WIDE - 5.5, -0.1, 0.12), size=(1.2, 0.11, 0.62))
    scene.model("hall door", "double_door_2", NORTH, (HALL_DOOR, -0.02, 0), size=(1.76, 0.175, 2.25),
                materials={"white-door": "cream paint", "white-frame": "white paint", "metal-handle": "brass"})
    scene.model("switch", "switch-whites", NORTH, (4.36, -0.006, 1.05))
    for i, (wall, x) in enumerate(((NORTH, 2.25), (EAST, 3.0), (WEST, 0.62))):
        scene.model(f"socket {i}", "plug-TypeE-whites", wall, (x, -0.004, 0.26))
    _light(scene)


def _south_wall(scene):
    t, h = WALL_DEPTH, HEIGHT
    place = Place(0, -t / 2)
    (a, b, f0, f1), (c, e, w0, w1) = FRENCH, WINDOW
    parts = (("west", 0, a, 0, h), ("middle", b, c, 0, h), ("east", e, WIDE, 0, h), ("threshold", a, b, 0, f0),
             ("over french", a, b, f1, h), ("under window", c, e, 0, w0 - 0.03), ("over window", c, e, w1, h))
    for name, x0, x1, z0, z1 in parts:
        scene.box(f"wall south {name}", "marble" if name == "threshold" else "wall", (x1 - x0, t, z1 - z0), place,
                  ((x0 + x1) / 2, 0, z0))


def _trim(scene):
    """Skirting, cornice and the rosette."""
    walls = (("north west", NORTH, 0, HALL_DOOR - 0.9), ("north east", NORTH, HALL_DOOR + 0.9, WIDE),
             ("east", EAST, 0, DEEP), ("west", WEST, 1.805, 2.02), ("west 2", WEST, 3.78, 3.875),
             ("west 3", WEST, 0, 0.435), ("west 4", WEST, 5.245, DEEP),
             ("south", SOUTH, 0, WIDE - FRENCH[1]), ("south west", SOUTH, WIDE - FRENCH[0], WIDE))
    for name, wall, x0, x1 in walls:
        for part, deep, tall, z in (("", 0.018, 0.13, 0), ("bead ", 0.011, 0.025, 0.13)):
            a = x0 + deep if wall in (EAST, WEST) and x0 == 0 else x0      # the others run into the corners
            b = x1 - deep if wall in (EAST, WEST) and x1 == DEEP else x1
            scene.box(f"skirting {part}{name}", "white paint", (b - a, deep, tall), wall, ((a + b) / 2, -deep / 2, z))
    for name, wall, length in (("north", NORTH, WIDE), ("south", SOUTH, WIDE), ("east", EAST, DEEP),
                               ("west", WEST, DEEP)):
        for i, (deep, tall, z) in enumerate(((0.13, 0.035, -0.035), (0.085, 0.05, -0.085), (0.04, 0.05, -0.135))):
            inset = deep if wall in (EAST, WEST) else 0
            scene.box(f"cornice {name} {i}", "ceiling", (length - 2 * inset, deep, tall), wall,
                      (length / 2, -deep / 2, HEIGHT + z))
    for i, radius in enumerate((0.42, 0.36, 0.2, 0.1)):
        scene.cylinder(f"rosette {i}", "ceiling", radius, 0.0125, Place(2.35, 2.9, HEIGHT - 0.0125 * (i + 1)),
                       segments=48)


def _casements(scene, name, opening, lights):
    """White casements with glazing bars; the panes themselves let everything through."""
    x0, x1, z0, z1 = opening
    wide, tall = x1 - x0, z1 - z0
    place = Place((x0 + x1) / 2, -0.16, z0)
    scene.box(f"{name} head", "white paint", (wide, 0.09, 0.07), place, (0, 0, tall - 0.07))
    scene.box(f"{name} foot", "white paint", (wide, 0.09, 0.05), place)
    for i in range(lights + 1):
        x = (i / lights - 0.5) * (wide - 0.06)
        scene.box(f"{name} post {i}", "white paint", (0.06, 0.09, tall - 0.12), place, (x, 0, 0.05))
    pane = (wide - 0.06) / lights
    for i in range(lights):
        x = (i + 0.5) * pane - (wide - 0.06) / 2
        for part, dx, dz, w, h in (("left", -pane / 2 + 0.055, 0.05, 0.05, tall - 0.12),
                                   ("right", pane / 2 - 0.055, 0.05, 0.05, tall - 0.12),
                                   ("low", 0, 0.05, pane - 0.16, 0.12 if z0 < 0.5 else 0.06),
                                   ("high", 0, tall - 0.13, pane - 0.16, 0.06),
                                   ("bar", 0, tall * 0.68, pane - 0.16, 0.03)):
            scene.box(f"{name} {i} {part}", "white paint", (w, 0.05, h), place, (x + dx, 0.012, dz))
        side = 1 if i % 2 == 0 else -1
        scene.box(f"{name} handle {i}", "brass", (0.018, 0.04, 0.12), place,
                  (x + side * (pane / 2 - 0.055), 0.055, tall * 0.42))


def _curtains(scene, name, opening):
    x0, x1, _, z1 = opening
    for side, x in (("left", x0 - 0.12), ("right", x1 + 0.12)):
        scene.model(f"{name} curtain {side}", "curtain", Place(x, 0.12, 0.03, 180), size=(0.62, 0.13, z1 + 0.13),
                    materials={"fabric": "curtain"})
    scene.box(f"{name} rail", "brass", (x1 - x0 + 0.9, 0.025, 0.025), Place((x0 + x1) / 2, 0.12, z1 + 0.17))
    for x in (x0 - 0.45, x1 + 0.45):
        scene.sphere(f"{name} knob", "brass", 0.03, Place(0, 0), (x, 0.12, z1 + 0.183), 16)


def _balcony(scene):
    """A narrow balcony; the park is a picture some way off."""
    middle = (FRENCH[0] + FRENCH[1]) / 2
    top = 0.02
    scene.box("balcony", "terrazzo", (3.4, 1.3, top), Place(middle, -0.96, 0))
    scene.model("balustrade", "iron-railing-2", Place(middle - 0.8, -1.5, top), size=(1.6, 0.09, 0.95),
                materials={"iron": "iron"})
    scene.model("balustrade 2", "iron-railing-2", Place(middle + 0.8, -1.5, top), size=(1.6, 0.09, 0.95),
                materials={"iron": "iron"})
    scene.model("balcony pot", "littlePlant", Place(middle + 1.35, -0.9, top), size=(0.36, 0.36, 0.34))
    scene.table("quad", "outside", name="park", material="garden", corner=(-14, -12, -7.2), u=(32, 0, 0), v=(0, 0, 22))


def _light(scene):
    """Sky and low sun through the windows; the chandelier."""
    scene.table("light", "light", name="sky", center=(3.3, -2.3, 4.6), u=(3.6, 0, 0), v=(0, -0.75, -0.95),
                radiance=(26, 28.5, 32))
    scene.table("light", name="sun", center=(0.3, -4.6, 4.3), u=(0.16, -0.08, 0), v=(-0.05, -0.1, -0.13),
                radiance=(2500, 2120, 1600))
    for side, z, v, glow in (("down", 2.24, -0.06, 1.0), ("up", 2.6, 0.06, 0.7)):
        scene.table("light", name=f"chandelier {side}", center=(2.35, 2.9, z), u=(0.06, 0, 0), v=(0, v, 0),
                    radiance=(120 * glow, 102 * glow, 76 * glow))
