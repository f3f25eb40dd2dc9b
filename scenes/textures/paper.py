# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Sheets that lie on desks and hang on boards: articles, notes, sketches, tables, sticky notes."""

import math
import random

import numpy as np
from PIL import Image, ImageDraw

from lettering import font, paragraph, sentences
from noise import spectral, to_bytes

A4 = (512, 724)
INK, BLUE, RED = (34, 36, 44), (36, 66, 150), (186, 44, 40)


def sheet(size=A4, color=(244, 243, 238), seed=1):
    """Blank paper: faint fibres and a soft fold of light."""
    level = 1.0 + 0.010 * spectral((size[1], size[0]), seed, 1.3)
    level += 0.008 * spectral((size[1], size[0]), seed + 1, 0.2)
    image = Image.fromarray(to_bytes(level[..., None] * np.asarray(color, float)))
    return image, ImageDraw.Draw(image)


def curve(draw, box, seed, color, waves=3):
    """A plotted measurement in box."""
    left, top, right, bottom = box
    rng = random.Random(seed)
    phase = [rng.uniform(0, 6.28) for _ in range(waves)]
    points = []
    for i in range(left, right):
        t = (i - left) / (right - left)
        value = sum(math.sin(6.28 * (k + 1) * 1.3 * t + phase[k]) / (k + 1) for k in range(waves))
        value = 0.5 + 0.2 * value + 0.02 * rng.gauss(0, 1)
        points.append((i, bottom - (bottom - top) * min(max(value, 0.02), 0.98)))
    draw.line(points, fill=color, width=2)


def plot(draw, box, seed, title=""):
    """A small line chart with axes, grid and three series."""
    left, top, right, bottom = box
    for i in range(1, 5):
        y = top + (bottom - top) * i // 5
        draw.line((left, y, right, y), fill=(214, 214, 214))
    for i, color in enumerate(((196, 60, 50), (40, 90, 170), (46, 140, 80))):
        curve(draw, box, seed + i, color)
    draw.line((left, top, left, bottom, right, bottom), fill=INK, width=2)
    for i in range(6):
        x = left + (right - left) * i // 5
        draw.line((x, bottom, x, bottom + 4), fill=INK)
        draw.text((x - 4, bottom + 5), str(i * 2), font=font("sans", 8), fill=INK)
    if title:
        draw.text((left, top - 13), title, font=font("bold", 9), fill=INK)


def bars(draw, box, seed):
    left, top, right, bottom = box
    rng = random.Random(seed)
    step = (right - left) / 8
    for i in range(8):
        height = (bottom - top) * rng.uniform(0.2, 0.95)
        x = left + i * step
        color = ((70, 110, 160), (206, 132, 60))[i % 2]
        draw.rectangle((x + 3, bottom - height, x + step - 4, bottom), fill=color)
    draw.line((left, top, left, bottom, right, bottom), fill=INK, width=2)


def frustum(draw, center, scale, color=INK):
    """A pinhole camera with its image plane and axes."""
    cx, cy = center
    plane = [(cx + scale * x, cy + scale * y) for x, y in
             ((1.1, -0.75), (2.0, -0.45), (2.0, 0.75), (1.1, 0.45))]
    for point in plane:
        draw.line((cx, cy, *point), fill=color, width=2)
    draw.polygon(plane, outline=color)
    draw.line((cx, cy, cx + 3.4 * scale, cy - 0.15 * scale), fill=RED, width=2)
    draw.ellipse((cx - 4, cy - 4, cx + 4, cy + 4), fill=color)
    draw.ellipse((cx + 3.4 * scale - 4, cy - 0.15 * scale - 4, cx + 3.4 * scale + 4,
                  cy - 0.15 * scale + 4), fill=BLUE)


def article(seed, title):
    """The first page of a two-column article."""
    image, draw = sheet(seed=200 + seed)
    draw.text((256, 52), title, font=font("serif-bold", 19), fill=INK, anchor="mm")
    draw.text((256, 78), "A. Keller, M. Osei and R. Lindqvist", font=font("serif", 11), fill=INK,
              anchor="mm")
    draw.text((48, 104), "Abstract", font=font("serif-bold", 11), fill=INK)
    paragraph(draw, (48, 120, 464, 186), seed)
    figure_right = seed % 2 == 1
    for column, left in enumerate((48, 264)):
        if (column == 1) == figure_right:
            plot(draw, (left + 14, 216, left + 196, 330), seed * 7, f"Fig. {seed % 5 + 1}")
            paragraph(draw, (left, 356, left + 200, 500), seed + column)
            draw.text((left, 508), "2  Method", font=font("serif-bold", 12), fill=INK)
            paragraph(draw, (left, 526, left + 200, 690), seed + column + 9)
        else:
            draw.text((left, 200), "1  Introduction", font=font("serif-bold", 12), fill=INK)
            paragraph(draw, (left, 218, left + 200, 560), seed + column)
            bars(draw, (left + 10, 580, left + 196, 684), seed)
    return image


def sketch(seed):
    """Handwritten notes: a camera, boxes and arrows, underlined remarks on squared paper."""
    image, draw = sheet(color=(246, 246, 240), seed=300 + seed)
    for i in range(0, A4[0], 16):
        draw.line((i, 0, i, A4[1]), fill=(204, 220, 232))
    for i in range(0, A4[1], 16):
        draw.line((0, i, A4[0], i), fill=(204, 220, 232))
    frustum(draw, (90, 170), 92, BLUE)
    frustum(draw, (130, 330), 74, INK)
    rng, stream = random.Random(seed), sentences(seed)
    for i in range(9):
        y = 440 + 28 * i
        draw.text((40 + rng.randint(0, 14), y), next(stream)[:34], font=font("sans", 17),
                  fill=(BLUE, INK, BLUE, RED)[rng.randint(0, 3)])
    draw.line((40, 92, 300, 88), fill=RED, width=4)
    draw.text((40, 54), ("T_cr = exp(ξ) T", "r = I(W) − I_r", "½ Σ r² → min")[seed % 3],
              font=font("bold", 28), fill=BLUE)
    draw.ellipse((330, 420, 490, 520), outline=RED, width=4)
    return image


def table(seed):
    """A ruled list of figures with a highlighted row."""
    image, draw = sheet(seed=400 + seed)
    rng = random.Random(seed)
    draw.text((44, 40), f"Measurements, series {seed}", font=font("bold", 20), fill=INK)
    for row in range(24):
        y = 92 + row * 25
        if row % 2 == 0:
            draw.rectangle((40, y, 472, y + 25), fill=(226, 232, 238))
        if row == 7:
            draw.rectangle((40, y, 472, y + 25), fill=(250, 236, 120))
        for col in range(5):
            text = f"#{row + 1:02d}" if col == 0 else f"{rng.uniform(-9, 99):.3f}"
            draw.text((50 + col * 86, y + 5), text, font=font("mono", 13), fill=INK)
    for col in range(6):
        draw.line((40 + col * 86.4, 92, 40 + col * 86.4, 692), fill=(120, 124, 130))
    draw.rectangle((40, 92, 472, 692), outline=INK, width=2)
    return image


def letter(seed):
    """A letter with a coloured letterhead, a stamp and a signature."""
    image, draw = sheet(seed=500 + seed)
    color = ((24, 92, 120), (140, 50, 40), (60, 110, 60))[seed % 3]
    draw.rectangle((0, 0, A4[0], 64), fill=color)
    draw.text((40, 16), ("Institute of Optics", "City Survey Office", "Norden Instruments")[seed % 3],
              font=font("bold", 25), fill=(250, 250, 246))
    draw.text((44, 96), "Reference 17/4-b", font=font("sans", 12), fill=INK)
    paragraph(draw, (44, 140, 470, 560), seed, size=13, leading=1.5)
    draw.arc((60, 585, 200, 680), 200, 500, fill=BLUE, width=3)
    draw.arc((120, 600, 290, 660), 160, 420, fill=BLUE, width=3)
    draw.ellipse((350, 580, 450, 680), outline=RED, width=5)
    draw.text((400, 630), "RECEIVED", font=font("bold", 15), fill=RED, anchor="mm")
    return image


def sticky(seed, color, lines):
    image, draw = sheet((192, 192), color, 600 + seed)
    draw.rectangle((0, 0, 192, 26), fill=tuple(int(0.94 * c) for c in color))
    for i, line in enumerate(lines):
        draw.text((14, 38 + 34 * i), line, font=font("sans", 25), fill=(BLUE, INK, RED)[seed % 3])
    return image


def notebook():
    """An open spiral notebook, two pages."""
    image, draw = sheet((724, 512), (246, 244, 234), 700)
    for y in range(40, 500, 20):
        draw.line((14, y, 710, y), fill=(170, 192, 214))
    stream = sentences(5)
    for page in range(2):
        left = 34 + 362 * page
        draw.line((left - 6, 8, left - 6, 504), fill=(220, 120, 120))
        for i in range(18 if page == 0 else 11):
            draw.text((left, 41 + 20 * i), next(stream)[:36], font=font("sans", 14), fill=BLUE)
    plot(draw, (420, 300, 690, 460), 12)
    for y in range(12, 508, 18):
        draw.ellipse((352, y, 372, y + 9), fill=(60, 60, 64))
    draw.line((362, 0, 362, 512), fill=(150, 148, 140), width=3)
    return image


SHEETS = {
    "paper_1": lambda: article(1, "Dense Alignment of Depth Images"),
    "paper_2": lambda: article(4, "Keyframes Considered Again"),
    "paper_3": lambda: sketch(1),
    "paper_4": lambda: table(3),
    "paper_5": lambda: letter(0),
    "paper_6": lambda: article(7, "On the Blur of Moving Cameras"),
    "paper_7": lambda: sketch(2),
    "paper_8": lambda: letter(1),
    "sticky_1": lambda: sticky(1, (250, 232, 108), ("call Eva", "14:30", "room 212", "!!")),
    "sticky_2": lambda: sticky(2, (250, 170, 186), ("α = 1e-3", "×10 / ÷10", "levels 4")),
    "sticky_3": lambda: sticky(3, (168, 222, 140), ("milk", "coffee", "filters", "stamps")),
    "sticky_4": lambda: sticky(4, (152, 208, 238), ("fx 481.2", "fy 480", "cx 319.5", "cy 239.5")),
    "notebook": notebook,
}
