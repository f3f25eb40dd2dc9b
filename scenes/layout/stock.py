# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Materials that any scene may have: tiling surfaces, pictures, and those of books and pinned paper."""

from pieces import BINDERS, COVERS, SPINES

_CLOTHS = ("#982824", "#1c3e6e", "#e2c45c", "#245c46", "#e8e4d6", "#323034", "#c46028", "#5c3c6e",
           "#7896aa", "#ced4cc", "#621e30", "#1e6e78")


def add_surfaces(scene, surfaces, coats=None):
    """surfaces: name -> (texture, tile in metres or None, colour or None); coats: name -> keys of what shines."""
    for name, (texture, tile, color) in surfaces.items():
        scene.table("material", name=name, color=color, texture=f"../textures/{texture}.jpg", tile_m=tile,
                    **(coats or {}).get(name, {}))


def add_pictures(scene, textures):
    """Pictures that cover a face once; the material's name is the texture's with blanks."""
    for name in textures:
        scene.table("material", name=name.replace("_", " "), texture=f"../textures/{name}.jpg")


def add_books(scene):
    """What book_row, book_pile and binder_row ask for."""
    add_pictures_as(scene, "spine {}", "spine_{:02d}", SPINES)
    for i in range(COVERS):
        add_pictures_as(scene, "flat spine {}", "flat_spine_{}", 1, i)
        add_pictures_as(scene, "flat cover {}", "flat_cover_{}", 1, i)
    add_pictures_as(scene, "binder {}", "binder_{}", BINDERS)
    for i, color in enumerate(_CLOTHS):
        scene.table("material", name=f"cloth {i}", color=color, texture="../textures/fabric.jpg", tile_m=(0.06, 0.06))
    scene.table("material", name="page edges", texture="../textures/pages.jpg", tile_m=(0.12, 0.06))


def add_pictures_as(scene, name, texture, count, first=0):
    for i in range(first, first + count):
        scene.table("material", name=name.format(i), texture=f"../textures/{texture.format(i)}.jpg")


def add_pins(scene):
    scene.table("material", name="pin", color="#c8322c")
    scene.table("material", name="pin blue", color="#2c5cb4")
