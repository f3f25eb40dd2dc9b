# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The school's own materials."""

from stock import add_pictures, add_pins, add_surfaces

# name -> (texture, tile in metres or None, colour or None)
_SURFACES = {
    "floor": ("floor_tiles", (1.2, 1.2), None),
    "wall": ("old_wall", (2.4, 2.4), "#f2ecdc"),
    "hall wall": ("old_wall", (2.1, 2.1), "#ece4cc"),
    "ceiling": ("old_wall", (3, 3), "#fbfaf4"),
    "tiles": ("glazed_tiles", (0.9, 0.9), "#7fa08c"),
    "tile band": ("glazed_tiles", (0.9, 0.9), "#3c4c48"),
    "hall dado": ("old_wall", (1.7, 1.7), "#8c9c86"),
    "tread": ("terrazzo", (0.6, 0.6), "#d8d0c4"),
    "riser": ("terrazzo", (0.6, 0.6), "#8e8a86"),
    "soffit": ("old_wall", (2, 2), "#f4f0e4"),
    "brick": ("brick", (0.96, 0.96), None),
    "oak": ("oak", (0.9, 0.45), "#c89a62"),
    "oak upright": ("oak_upright", (0.45, 0.9), "#c89a62"),
    "handrail": ("walnut", (0.8, 0.4), None),
    "door": ("oak_upright", (0.45, 0.9), "#b98c5c"),
    "door frame": ("plastic", (0.5, 0.5), "#5e6c62"),
    "white paint": ("plastic", (0.6, 0.6), "#f4f2ea"),
    "iron": ("plastic", (0.3, 0.3), "#3c4644"),
    "steel": ("plastic", (0.3, 0.3), "#b8babc"),
    "rubber": ("plastic", (0.2, 0.2), "#2c2c2e"),
    "pipe": ("plastic", (0.4, 0.4), "#d8d4c4"),
    "red": ("plastic", (0.3, 0.3), "#b4241e"),
    "machine": ("plastic", (0.5, 0.5), "#7c1a20"),
    "locker side": ("plastic", (0.5, 0.5), "#6a8496"),
    "yellow": ("plastic", (0.3, 0.3), "#e8c020"),
    "clay": ("cardboard", (0.3, 0.3), "#b86c48"),
    "coat blue": ("fabric", (0.12, 0.12), "#3c5a80"),
    "coat red": ("fabric", (0.12, 0.12), "#8c3a34"),
    "coat green": ("fabric", (0.12, 0.12), "#56704e"),
    "cardboard": ("cardboard", (0.5, 0.5), None),
}
# What shines, seen with --specular or --light path.
_COATS = {
    "floor": {"specular": 0.04, "roughness": 0.3},
    "tiles": {"specular": 0.05, "roughness": 0.2},
    "tile band": {"specular": 0.05, "roughness": 0.2},
    "tread": {"specular": 0.04, "roughness": 0.35},
    "handrail": {"specular": 0.04, "roughness": 0.3},
    "door": {"specular": 0.04, "roughness": 0.4},
    "machine": {"specular": 0.04, "roughness": 0.3},
    "steel": {"metallic": 1, "roughness": 0.4},
}
_PICTURES = ("floors_sign", "escape_plan", "timetable", "notices", "hose_cabinet", "class_photo_1", "class_photo_2",
             "wet_floor", "corkboard",
             "planner", "poster_map", "poster_concert", "poster_pinhole", "poster_chart", "botanical_1",
             "botanical_2", "painting_abstract",
             *(f"plate_{n}" for n in range(101, 109)), *(f"paper_{i}" for i in range(1, 9)))
LOCKERS = ("#6f93ac", "#c8a24c", "#7d9a74")


def add_materials(scene):
    add_surfaces(scene, _SURFACES, _COATS)
    add_pictures(scene, _PICTURES)
    add_pins(scene)
    for i, color in enumerate(LOCKERS):
        scene.table("material", name=f"locker {i}", color=color, texture="../textures/locker.jpg")
    scene.table("material", name="clock face", texture="../textures/clock.png", cutout=True)
    for name, color, texture, glow in (("vending", "#303030", "vending", 0.4),
                                       ("town", "#000000", "window_view", 0.62)):
        scene.table("material", name=name, color=color, texture=f"../textures/{texture}.jpg",
                    emission=(glow, glow, glow))
    scene.table("material", name="globe", color="#fff4e0", emission=(0.75, 0.68, 0.52))
