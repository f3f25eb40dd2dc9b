# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Furniture and things built of boxes and pictures: books, shelves, binders, monitors, frames."""

import random

SPINES, COVERS, BINDERS = 20, 6, 4


def book_row(scene, name, place, width, seed, fill=1.0):
    """Books upright from local x = 0 to fill · width, spines to -y at y = 0."""
    rng = random.Random(seed)
    x, number = 0.0, 0
    while True:
        thick, tall, deep = rng.uniform(0.016, 0.048), rng.uniform(0.185, 0.275), rng.uniform(0.13, 0.19)
        if x + thick > fill * width:
            return x
        spine, setback = rng.randrange(SPINES), rng.uniform(0.0, 0.025)
        scene.box(f"{name} book {number}", None, (thick, deep, tall), place,
                  (x + thick / 2, deep / 2 + setback, 0),
                  faces=book_faces(f"spine {spine}", f"cloth {spine % 12}", "front"))
        x += thick + rng.choice((0.0005, 0.0005, 0.002))
        number += 1


def book_faces(spine, cover, where):
    faces = {side: "page edges" for side in ("top", "bottom", "front", "back", "left", "right")}
    if where == "front":
        faces.update(front=spine, left=cover, right=cover)
    else:
        faces.update(front=spine, top=cover, bottom=cover)
    return faces


def book_pile(scene, name, place, seed, count):
    """Books lying on each other, spines roughly to -y. Returns the height."""
    rng = random.Random(seed)
    z = 0.0
    for i in range(count):
        shrink = 1.0 - 0.05 * i
        size = (rng.uniform(0.22, 0.28) * shrink, rng.uniform(0.16, 0.2) * shrink, rng.uniform(0.018, 0.046))
        index = rng.randrange(COVERS)
        scene.box(f"{name} {i}", None, size, place, (rng.uniform(-0.01, 0.01), rng.uniform(-0.01, 0.01), z),
                  rng.uniform(-13, 13), faces=book_faces(f"flat spine {index}", f"flat cover {index}", "top"))
        z += size[2]
    return z


def binder_row(scene, name, place, count, seed, first=0):
    """Lever-arch files from local x = 0, backs to -y."""
    rng = random.Random(seed)
    for i in range(count):
        index = rng.randrange(BINDERS) if first is None else (first + i // 3) % BINDERS
        faces = {side: "board" for side in ("top", "bottom", "back", "left", "right")}
        faces["front"] = f"binder {index}"
        scene.box(f"{name} binder {i}", None, (0.075, 0.285, 0.315), place,
                  (0.04 + 0.0785 * i, 0.1425 + rng.uniform(0, 0.02), 0), faces=faces)


def bookshelf(scene, name, place, size, boards, material="oak", back="oak back"):
    """An open case, its foot at the place's origin, open to -y. Returns the heights of its boards."""
    w, d, h = size
    t = 0.022
    for side, x in (("left", -w / 2 + t / 2), ("right", w / 2 - t / 2)):
        scene.box(f"{name} {side}", f"{material} upright", (t, d, h), place, (x, 0, 0))
    scene.box(f"{name} back", back, (w - 2 * t, 0.008, h), place, (0, d / 2 - 0.004, 0))
    heights = [0.06 + (h - 0.082) * i / boards for i in range(boards + 1)]
    for i, z in enumerate(heights):
        scene.box(f"{name} board {i}", material, (w - 2 * t, d - 0.01, t), place, (0, -0.005, z))
    return [z + t for z in heights[:-1]]


def drawers(scene, name, place, size, rows, material="cabinet"):
    """A steel cabinet with drawer fronts, grips and label holders, front to -y."""
    w, d, h = size
    scene.box(name, material, (w, d - 0.02, h), place, (0, 0.01, 0))
    step = (h - 0.04) / rows
    for i in range(rows):
        z = 0.03 + step * i
        scene.box(f"{name} front {i}", f"{material} front", (w - 0.02, 0.02, step - 0.012), place,
                  (0, -d / 2 + 0.01, z))
        scene.box(f"{name} grip {i}", "dark metal", (0.14, 0.025, 0.014), place,
                  (0, -d / 2 - 0.0125, z + 0.62 * step))
        scene.hung(f"{name} label {i}", f"sticky {i % 4 + 1}", (0.075, 0.045), place,
                   (0, -d / 2 - 0.001, z + 0.74 * step))


def monitor(scene, name, place, picture, width=0.55, height=0.325):
    """A flat screen on its stand, facing -y."""
    scene.box(f"{name} foot", "dark plastic", (0.25, 0.19, 0.014), place)
    scene.box(f"{name} neck", "dark plastic", (0.06, 0.035, 0.2), place, (0, 0.05, 0.014))
    scene.box(f"{name} case", "dark plastic", (width, 0.04, height), place, (0, 0.012, 0.115))
    scene.box(f"{name} rear", "dark plastic", (0.6 * width, 0.03, 0.6 * height), place, (0, 0.046, 0.17))
    edge = 0.014
    scene.hung(f"{name} picture", picture, (width - 2 * edge, height - 2 * edge - 0.008), place,
               (0, -0.0085, 0.115 + edge + 0.008))
    scene.hung(f"{name} badge", "board", (0.03, 0.005), place, (0, -0.0085, 0.121))


def framed(scene, name, picture, size, place, at, frame="walnut", border=0.028):
    """A picture in a frame on the wall behind it; `at` is the middle of its lower edge."""
    x, y, z = at
    w, h = size
    for part, dx, dz, bw, bh in (("top", 0, h, w + 2 * border, border), ("bottom", 0, -border, w + 2 * border, border),
                                 ("left", -(w + border) / 2, 0, border, h), ("right", (w + border) / 2, 0, border, h)):
        scene.box(f"{name} frame {part}", frame, (bw, 0.022, bh), place, (x + dx, y - 0.011, z + dz))
    scene.hung(name, picture, size, place, (x, y - 0.006, z))


def pinned(scene, name, picture, size, place, at):
    """An unframed poster with four pins."""
    x, y, z = at
    scene.hung(name, picture, size, place, (x, y - 0.0004, z))
    for i, (dx, dz) in enumerate(((-1, 0), (1, 0), (-1, 1), (1, 1))):
        scene.sphere(f"{name} pin {i}", "pin", 0.007, place,
                     (x + dx * (size[0] / 2 - 0.02), y - 0.006, z + 0.02 + dz * (size[1] - 0.04)), 12)
