# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The office's own materials."""

from stock import add_books, add_pictures, add_pins, add_surfaces

# name -> (texture, tile in metres or None, colour or None)
_SURFACES = {
    "carpet": ("carpet", (1, 1), None),
    "wall": ("woodchip", (1.5, 1.5), None),
    "wall accent": ("woodchip", (1.5, 1.5), "#9db4bd"),
    "ceiling": ("ceiling", (1.2, 1.2), None),
    "sill": ("terrazzo", (0.6, 0.6), None),
    "oak": ("oak", (0.9, 0.45), None),
    "oak upright": ("oak_upright", (0.45, 0.9), "#f4ece0"),
    "oak back": ("oak", (0.9, 0.45), "#c8b8a4"),
    "walnut": ("walnut", (0.8, 0.4), None),
    "beech": ("beech", (0.9, 0.45), None),
    "beech upright": ("beech_upright", (0.45, 0.9), None),
    "white": ("plastic", (0.5, 0.5), "#fafaf6"),
    "dark plastic": ("plastic", (0.25, 0.25), "#3c3e44"),
    "gray plastic": ("plastic", (0.25, 0.25), "#a8aaac"),
    "white plastic": ("plastic", (0.25, 0.25), "#f4f2ea"),
    "dark metal": ("plastic", (0.3, 0.3), "#505358"),
    "metal": ("plastic", (0.3, 0.3), "#c4c6c8"),
    "cabinet": ("plastic", (0.5, 0.5), "#b4b8b0"),
    "cabinet front": ("plastic", (0.7, 0.7), "#c6cac2"),
    "locker": ("plastic", (0.6, 0.6), "#c8c6b0"),
    "blue fabric": ("fabric", (0.2, 0.2), "#46628e"),
    "red fabric": ("fabric", (0.2, 0.2), "#9a4c40"),
    "gray fabric": ("fabric", (0.22, 0.22), "#7c8084"),
    "suit fabric": ("fabric", (0.12, 0.12), "#4a5058"),
    "cushion": ("fabric", (0.15, 0.15), "#c89850"),
    "cardboard": ("cardboard", (0.5, 0.5), None),
    "board": ("cardboard", (0.4, 0.4), "#d8d4cc"),
    "cork": ("cork", (0.5, 0.5), None),
    "glazed": ("plastic", (0.2, 0.2), "#e6e0d0"),
    "glazed blue": ("plastic", (0.2, 0.2), "#5478a0"),
}
_PICTURES = ("poster_map", "poster_pinhole", "poster_concert", "poster_chart", "print_mountains", "planner",
             "whiteboard", "corkboard", "keyboard", "notebook", *(f"paper_{i}" for i in range(1, 9)),
             *(f"sticky_{i}" for i in range(1, 5)))


def add_materials(scene):
    add_surfaces(scene, _SURFACES)
    add_pictures(scene, _PICTURES)
    add_books(scene)
    add_pins(scene)
    scene.table("material", name="clock face", texture="../textures/clock.png", cutout=True)
    for name, glow in (("screen_code", 0.68), ("screen_plots", 0.58)):
        scene.table("material", name=name.replace("_", " "), color="#303030", texture=f"../textures/{name}.jpg",
                    emission=(glow, glow, glow))
    scene.table("material", name="town", color="#000000", texture="../textures/window_view.jpg",
                emission=(0.9, 0.9, 0.9), two_sided=False)
