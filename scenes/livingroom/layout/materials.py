# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""The living room's own materials."""

from stock import add_books, add_pictures, add_surfaces

# name -> (texture, tile in metres or None, colour or None)
_SURFACES = {
    "parquet": ("parquet", (1.2, 1.2), None),
    "wall": ("plaster", (2, 2), "#ece6d8"),
    "chimney": ("plaster", (1.6, 1.6), "#b9c0ac"),
    "wallpaper": ("wallpaper", (0.8, 0.8), None),
    "ceiling": ("plaster", (1.5, 1.5), "#fbfaf5"),
    "brick": ("brick", (0.96, 0.96), None),
    "marble": ("marble", (0.6, 0.6), None),
    "terrazzo": ("terrazzo", (0.6, 0.6), None),
    "oak": ("oak", (0.9, 0.45), None),
    "walnut": ("walnut", (0.8, 0.4), None),
    "walnut upright": ("walnut_upright", (0.4, 0.8), None),
    "walnut back": ("walnut", (0.8, 0.4), "#b8b0a8"),
    "dark wood": ("walnut_upright", (0.4, 0.8), "#8c8480"),
    "leather": ("leather", (0.35, 0.35), "#a2603c"),
    "tan leather": ("leather", (0.3, 0.3), "#c08a52"),
    "green leather": ("leather", (0.3, 0.3), "#5c7058"),
    "black leather": ("leather", (0.3, 0.3), "#3a3634"),
    "curtain": ("linen", (0.8, 0.8), None),
    "tartan": ("tartan", (0.4, 0.4), None),
    "kilim": ("kilim", None, None),
    "velvet": ("fabric", (0.1, 0.1), "#c89a3c"),
    "blue cloth": ("fabric", (0.14, 0.14), "#4c6a86"),
    "shade": ("fabric", (0.1, 0.1), "#f2e2c0"),
    "rug edge": ("fabric", (0.1, 0.1), "#2a2c40"),
    "white paint": ("plastic", (0.6, 0.6), "#f8f6ee"),
    "cream paint": ("plastic", (0.6, 0.6), "#e6dcc0"),
    "black": ("plastic", (0.25, 0.25), "#343436"),
    "iron": ("plastic", (0.3, 0.3), "#4a4a4c"),
    "brass": ("plastic", (0.3, 0.3), "#b8924c"),
    "steel": ("plastic", (0.3, 0.3), "#b8babc"),
    "clay": ("cardboard", (0.3, 0.3), "#c87850"),
    "glazed blue": ("plastic", (0.2, 0.2), "#4c6e98"),
    "glazed": ("plastic", (0.2, 0.2), "#e6e0d0"),
    "board": ("cardboard", (0.4, 0.4), "#d8d4cc"),
}
# What shines, seen with --specular or --light path.
_COATS = {
    "parquet": {"specular": 0.04, "roughness": 0.35},
    "marble": {"specular": 0.05, "roughness": 0.2},
    "oak": {"specular": 0.04, "roughness": 0.45},
    "walnut": {"specular": 0.04, "roughness": 0.45},
    "dark wood": {"specular": 0.05, "roughness": 0.15},
    "leather": {"specular": 0.04, "roughness": 0.45},
    "glazed": {"specular": 0.05, "roughness": 0.15},
    "glazed blue": {"specular": 0.05, "roughness": 0.15},
    "brass": {"metallic": 1, "roughness": 0.35},
}
_PICTURES = ("rug", "painting_sea", "painting_field", "painting_still_life", "painting_abstract", "botanical_1",
             "botanical_2",
             "photo_1", "photo_2", "music", "magazine_1", "magazine_2", "poster_map", "notebook", "paper_4", "paper_8")


def add_materials(scene):
    add_surfaces(scene, _SURFACES, _COATS)
    add_pictures(scene, _PICTURES)
    add_books(scene)
    scene.table("material", name="looking glass", color="#c4c8c8", mirror=True)
    scene.table("material", name="clock face", texture="../textures/clock.png", cutout=True)
    for name, color, texture, glow in (("garden", "#000000", "garden", 0.4), ("film", "#202020", "film", 0.36)):
        scene.table("material", name=name, color=color, texture=f"../textures/{texture}.jpg",
                    emission=(glow, glow, glow))
    for name, glow in (("bulb", (2.2, 1.9, 1.4)), ("lit shade", (0.6, 0.46, 0.28))):
        scene.table("material", name=name, color="#f2e2c0", texture="../textures/fabric.jpg", tile_m=(0.1, 0.1),
                    emission=glow)
