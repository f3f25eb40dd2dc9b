# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Spines, covers and page edges of books and binders."""

import random

import numpy as np
from PIL import Image, ImageDraw

from lettering import font
from noise import spectral, to_bytes

_TITLES = ("MULTIPLE VIEWS", "LIE GROUPS", "OPTICS", "NUMERICAL RECIPES OF THE SEA", "Robust Estimates",
           "SENSORS AND SIGNALS", "Light", "MATRIX METHODS", "ROBOTS", "Small Motions", "GRAPHS",
           "PROBABILITY", "Cartography", "CURVES & SURFACES", "SIGNALS I", "SIGNALS II",
           "The Shutter", "FIELD GUIDE TO NOISE", "Parallel Machines", "GEOMETRY")
_NAMES = ("Keller", "Osei", "Lindqvist", "Moreau", "Tanaka", "Ferrer", "Novak", "Adeyemi")
_COLORS = ((152, 40, 36), (28, 62, 110), (226, 196, 92), (36, 92, 70), (232, 228, 214), (50, 48, 52),
           (196, 96, 40), (92, 60, 110), (120, 150, 170), (206, 212, 204), (98, 30, 48), (30, 110, 120))


def _cloth(size, color, seed):
    level = 1.0 + 0.05 * spectral((size[1], size[0]), seed, 0.3, low=20)
    level += 0.05 * spectral((size[1], size[0]), seed + 1, 1.4)
    return Image.fromarray(to_bytes(level[..., None] * np.asarray(color, float)))


def _ink(color):
    bright = sum(color) > 380
    return (44, 40, 40) if bright else (240, 228, 190)


def flat_spine(index):
    """One spine, 384 x 64, as it reads when the book lies on its back."""
    rng = random.Random(9000 + index)
    color = _COLORS[(index * 5) % len(_COLORS)]
    ink = _ink(color)
    strip = _cloth((384, 64), color, 800 + 3 * index)
    draw = ImageDraw.Draw(strip)
    accent = _COLORS[(index * 7 + 3) % len(_COLORS)]
    style = index % 4
    if style == 0:
        draw.rectangle((26, 0, 36, 64), fill=accent)
        draw.rectangle((344, 0, 352, 64), fill=accent)
    elif style == 1:
        draw.rectangle((40, 0, 250, 64), fill=accent)
        ink = _ink(accent)
    elif style == 2:
        for x in (14, 20, 26, 356, 362, 368):
            draw.line((x, 0, x, 64), fill=ink, width=2)
    else:
        draw.rectangle((300, 0, 384, 64), fill=accent)
    title = _TITLES[index % len(_TITLES)]
    size = 30
    while draw.textlength(title, font=font("bold", size)) > 196:
        size -= 1
    draw.text((48, 32), title, font=font("bold", size), fill=ink, anchor="lm")
    draw.text((262, 32), rng.choice(_NAMES)[:7], font=font("sans", 15), fill=_ink(color), anchor="lm")
    return strip


def spine(index):
    """The spine of a standing book: its title runs down, or up as on the continent."""
    return flat_spine(index).transpose(Image.ROTATE_270 if index % 5 else Image.ROTATE_90)


def cover(index):
    """A front cover, 300 x 420."""
    color = _COLORS[(index * 5) % len(_COLORS)]
    accent = _COLORS[(index * 7 + 3) % len(_COLORS)]
    image = _cloth((300, 420), color, 860 + 3 * index)
    draw = ImageDraw.Draw(image)
    rng = random.Random(index)
    for i in range(9):
        r = 26 + 15 * i
        box = (150 - r, 250 - r, 150 + r, 250 + r)
        if index % 3 == 0:
            draw.ellipse(box, outline=accent, width=5)
        elif index % 3 == 1:
            draw.polygon([(150, 250 - r), (150 + r, 250 + r // 2), (150 - r, 250 + r // 2)],
                         outline=accent)
        else:
            x, y = rng.randint(20, 260), rng.randint(150, 350)
            draw.rectangle((x, y, x + 40, y + 40), fill=accent if i % 2 else _ink(color))
    title = _TITLES[index % len(_TITLES)]
    for row, word in enumerate(title.split()[:3]):
        draw.text((22, 20 + 36 * row), word, font=font("serif-bold", 30), fill=_ink(color))
    draw.text((22, 388), _NAMES[index % len(_NAMES)], font=font("sans", 18), fill=_ink(color))
    return image


def pages():
    """The cut edge of a block of pages, leaves along x."""
    rng = np.random.RandomState(77)
    leaves = 1.0 + 0.10 * rng.standard_normal((128, 1)) * np.ones((1, 256))
    level = leaves + 0.03 * spectral((128, 256), 880, 0.8, (1.0, 12.0))
    return to_bytes(level[..., None] * np.asarray((222, 214, 194), float))


def binder(index):
    """The back of a lever-arch file, 128 x 512, with label and finger hole."""
    color = ((40, 44, 50), (32, 70, 128), (150, 36, 34), (46, 98, 62))[index]
    rng = np.random.RandomState(890 + index)
    marble = spectral((512, 128), 900 + index, 0.7, low=8)
    level = 1.0 + (0.22 if index == 0 else 0.06) * np.clip(marble, -1, 2)
    image = Image.fromarray(to_bytes(level[..., None] * np.asarray(color, float)))
    draw = ImageDraw.Draw(image)
    draw.rectangle((18, 60, 110, 300), fill=(240, 238, 230), outline=(90, 90, 90))
    draw.rectangle((18, 60, 110, 96), fill=color)
    label = Image.new("RGB", (190, 70), (240, 238, 230))
    text = ImageDraw.Draw(label)
    text.text((4, 4), ("Invoices", "Experiments", "Contracts", "Sensors")[index],
              font=font("bold", 25), fill=(30, 30, 36))
    text.text((4, 40), f"20{rng.randint(11, 25)} – A{index + 3}", font=font("sans", 20),
              fill=(40, 60, 130))
    image.paste(label.rotate(90, expand=True), (30, 104))
    draw.ellipse((40, 380, 88, 428), fill=(16, 16, 18), outline=(190, 190, 196), width=6)
    return image


BOOKS = {f"spine_{i:02d}": (lambda i=i: spine(i)) for i in range(20)}
BOOKS.update({f"flat_spine_{i}": (lambda i=i: flat_spine(i)) for i in range(6)})
BOOKS.update({f"flat_cover_{i}": (lambda i=i: cover(i).transpose(Image.ROTATE_90)) for i in range(6)})
BOOKS.update({f"binder_{i}": (lambda i=i: binder(i)) for i in range(4)})
BOOKS["pages"] = pages
