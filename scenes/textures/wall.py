# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""What hangs on the walls: posters, whiteboard, cork board, planner, clock, and the window's view."""

import math
import random

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

from lettering import font, paragraph
from noise import mix, relief, smoothstep, spectral, to_bytes
from paper import BLUE, INK, RED, SHEETS, bars, frustum, plot
from surfaces import cork

GREEN = (30, 130, 70)


def map_poster():
    """A topographic sheet: hill-shaded relief, contours, water, grid, roads and a legend."""
    height, width = 760, 1024
    z = spectral((height, width), 1001, 2.1)
    land = mix((176, 204, 150), (238, 226, 190), smoothstep(-0.8, 0.9, z))
    land = mix(land, (196, 160, 124), smoothstep(0.7, 1.8, z))
    land = mix(land, (250, 250, 250), smoothstep(1.8, 2.5, z))
    land = mix(land, (140, 188, 216), smoothstep(-0.85, -0.95, z))
    land *= np.clip(relief(z, 4.0), 0.6, 1.35)[..., None]
    step = z * 7.0
    slope = np.hypot(*np.gradient(step)) + 1e-6
    near = np.abs(step - np.rint(step)) / slope
    index = np.rint(step) % 5 == 0
    line = (near < np.where(index, 0.9, 0.5)) & (z > -0.9)
    land[line] = land[line] * 0.55 + np.array((130, 80, 40)) * 0.45
    image = Image.fromarray(to_bytes(land))
    draw = ImageDraw.Draw(image)
    _map_symbols(draw, z, width, height)
    framed = Image.new("RGB", (1064, 860), (248, 246, 238))
    framed.paste(image, (20, 20))
    draw = ImageDraw.Draw(framed)
    draw.rectangle((20, 20, 1043, 779), outline=INK, width=3)
    draw.text((24, 788), "NORDRE LIER  1 : 25 000", font=font("bold", 40), fill=INK)
    for i in range(10):
        box = (640 + 40 * i, 800, 680 + 40 * i, 814)
        draw.rectangle(box, fill=INK if i % 2 else (250, 250, 250), outline=INK)
        draw.text((640 + 40 * i, 820), str(i), font=font("sans", 14), fill=INK)
    return framed.resize((1024, 828), Image.LANCZOS)


def _map_symbols(draw, z, width, height):
    rng = random.Random(7)
    for i in range(0, width, 128):
        draw.line((i, 0, i, height), fill=(70, 90, 140))
    for i in range(0, height, 128):
        draw.line((0, i, width, i), fill=(70, 90, 140))
    for road in range(4):
        x, y, heading = 0.0, rng.uniform(100, height - 100), rng.uniform(-0.4, 0.4)
        points = []
        while 0 <= x < width and 0 <= y < height:
            points.append((x, y))
            heading += rng.gauss(0, 0.12) - 0.03 * heading
            x, y = x + 8 * math.cos(heading), y + 8 * math.sin(heading)
        draw.line(points, fill=(90, 30, 24), width=6)
        draw.line(points, fill=((240, 200, 70), (230, 120, 60))[road % 2], width=3)
    for name in ("Holm", "Vesle Tind", "Kvernes", "Brattli", "Sund", "Myra", "Askheim", "Lier"):
        x, y = rng.randint(40, width - 160), rng.randint(30, height - 40)
        for _ in range(14):
            a, b = x + rng.randint(-40, 40), y + rng.randint(14, 50)
            draw.rectangle((a, b, a + rng.randint(3, 8), b + rng.randint(3, 8)), fill=(60, 56, 60))
        draw.text((x, y), name, font=font("serif-bold", 21), fill=(20, 20, 30))
        draw.text((x + 40, y + 52), f"{int(400 + 150 * z[y, x])}", font=font("sans", 12), fill=INK)


def pinhole_poster():
    """A lecture poster on the pinhole camera."""
    image = Image.new("RGB", (640, 900), (24, 46, 84))
    draw = ImageDraw.Draw(image)
    draw.text((40, 34), "THE PINHOLE", font=font("bold", 72), fill=(244, 214, 110))
    draw.text((40, 116), "CAMERA", font=font("bold", 96), fill=(244, 240, 228))
    draw.rectangle((40, 240, 600, 560), fill=(240, 236, 222))
    frustum(draw, (90, 410), 132, INK)
    for i in range(7):
        draw.line((90, 410, 520 + 8 * i, 270 + 40 * i), fill=(190, 60, 50), width=2)
        draw.ellipse((514 + 8 * i, 264 + 40 * i, 526 + 8 * i, 276 + 40 * i), fill=BLUE)
    draw.text((60, 505), "u = fx X / Z + cx     v = fy Y / Z + cy", font=font("serif-bold", 24), fill=INK)
    paragraph(draw, (40, 590, 310, 830), 21, "sans", 15, (226, 230, 238), 1.4)
    for i in range(5):
        draw.rectangle((340 + 52 * i, 590, 384 + 52 * i, 634),
                       fill=((230, 90, 60), (244, 190, 80), (90, 180, 140), (90, 140, 220),
                             (200, 120, 190))[i])
    plot_box = (350, 680, 590, 820)
    draw.rectangle((336, 650, 604, 842), fill=(240, 236, 222))
    plot(draw, plot_box, 44, "resolution")
    draw.text((40, 850), "Institute of Optics · Summer lectures", font=font("sans", 22),
              fill=(244, 214, 110))
    return image


def concert_poster():
    """A typographic poster of overlapping shapes."""
    image = Image.new("RGB", (560, 800), (236, 226, 204))
    rng = random.Random(31)
    colors = ((214, 70, 48), (36, 60, 92), (232, 172, 60), (70, 140, 130), (30, 30, 34))
    for i in range(26):
        layer = Image.new("RGBA", image.size, (0, 0, 0, 0))
        draw = ImageDraw.Draw(layer)
        x, y, r = rng.randint(0, 560), rng.randint(120, 640), rng.randint(24, 120)
        color = (*colors[i % 5], 215)
        if i % 3 == 0:
            draw.pieslice((x - r, y - r, x + r, y + r), 90 * (i % 4), 90 * (i % 4) + 180, fill=color)
        elif i % 3 == 1:
            draw.polygon([(x, y - r), (x + r, y + r), (x - r, y + r)], fill=color)
        else:
            for k in range(0, 2 * r, 12):
                draw.line((x - r, y - r + k, x + r, y - r + k), fill=color, width=5)
        image.paste(layer, (0, 0), layer)
    draw = ImageDraw.Draw(image)
    draw.text((28, 20), "nordlys", font=font("bold", 108), fill=(30, 30, 34))
    draw.text((32, 660), "CHAMBER MUSIC FESTIVAL", font=font("bold", 33), fill=(30, 30, 34))
    draw.text((32, 706), "12 – 21 September   Harbour Hall", font=font("sans", 27), fill=(214, 70, 48))
    draw.text((32, 746), "strings · brass · voices · tape", font=font("sans", 24), fill=(36, 60, 92))
    return image


def mountains():
    """A framed print: ridges fading into haze under an evening sky."""
    height, width = 560, 800
    y = np.linspace(0, 1, height)[:, None] * np.ones((1, width))
    rgb = mix((70, 96, 150), (246, 190, 130), smoothstep(0.0, 0.75, y))
    cloud = spectral((height, width), 1101, 1.6, (1.0, 5.0))
    rgb = mix(rgb, (252, 224, 190), 0.5 * smoothstep(0.5, 2.0, cloud))
    rows = np.arange(height)[:, None]
    for i in range(6):
        ridge = spectral((1, width), 1110 + i, 1.45)[0]
        top = height * (0.36 + 0.1 * i) + (44 - 4 * i) * ridge
        color = np.array((118, 128, 160)) * (1 - i / 7.0) + np.array((14, 30, 36)) * (i / 7.0)
        texture = 1.0 + 0.13 * spectral((height, width), 1120 + i, 0.9, (0.5, 1.0), low=6)
        below = smoothstep(0, 2, rows - top[None, :])
        rgb = mix(rgb, color[None, None, :] * texture[..., None], below)
    image = Image.new("RGB", (900, 660), (244, 242, 236))
    image.paste(Image.fromarray(to_bytes(rgb)), (50, 50))
    return image


def planner():
    """A year planner with filled-in days."""
    image = Image.new("RGB", (1024, 720), (248, 248, 246))
    draw = ImageDraw.Draw(image)
    draw.rectangle((0, 0, 1024, 70), fill=(176, 40, 44))
    draw.text((24, 8), "YEAR PLANNER", font=font("bold", 46), fill=(255, 255, 255))
    rng = random.Random(12)
    months = "JAN FEB MAR APR MAY JUN JUL AUG SEP OCT NOV DEC".split()
    for m, month in enumerate(months):
        top = 84 + m * 52
        draw.rectangle((10, top, 86, top + 48), fill=(54, 84, 124) if m % 2 else (84, 120, 160))
        draw.text((20, top + 11), month, font=font("bold", 22), fill=(255, 255, 255))
        for day in range(31):
            left = 90 + day * 30
            weekend = (day + m * 3) % 7 in (5, 6)
            fill = (222, 228, 234) if weekend else (250, 250, 248)
            draw.rectangle((left, top, left + 28, top + 48), fill=fill, outline=(168, 172, 178))
            draw.text((left + 3, top + 2), str(day + 1), font=font("sans", 11), fill=INK)
        for _ in range(rng.randint(1, 3)):
            start, span = rng.randint(0, 24), rng.randint(1, 6)
            color = ((240, 214, 90), (130, 196, 130), (236, 140, 130), (140, 180, 226))[rng.randint(0, 3)]
            box = (90 + start * 30, top + 22, 90 + (start + span) * 30, top + 42)
            draw.rectangle(box, fill=color)
            draw.text((box[0] + 3, top + 23), ("trial", "leave", "review", "lab")[m % 4],
                      font=font("sans", 14), fill=INK)
    return image


def whiteboard():
    """A worn whiteboard in use: diagrams, formulae, a list, ghosts of what was wiped off."""
    width, height = 1024, 640
    level = 1.0 + 0.012 * spectral((height, width), 1201, 1.4) + 0.006 * spectral((height, width), 1202, 0.3)
    ghosts = Image.new("L", (width, height), 0)
    draw = ImageDraw.Draw(ghosts)
    for i in range(26):
        draw.text((37 * i % 900, 61 * i % 600), "∑ J r α Δ"[i % 7:], font=font("sans", 40), fill=255)
    smear = np.asarray(ghosts.filter(ImageFilter.GaussianBlur(5))) / 255.0
    image = Image.fromarray(to_bytes((level - 0.16 * smear)[..., None] * np.array((240, 241, 242))))
    draw = ImageDraw.Draw(image)
    frustum(draw, (70, 210), 86, BLUE)
    frustum(draw, (150, 420), 86, RED)
    draw.line((130, 250, 160, 360), fill=GREEN, width=4)
    draw.polygon([(160, 372), (148, 348), (172, 350)], fill=GREEN)
    draw.text((64, 286), "T_cr", font=font("sans", 34), fill=GREEN)
    for i, text in enumerate(("r = I_c(W(ξ)) − I_r", "(JᵀJ + αI) δξ = −Jᵀr", "T ← exp(δξ) T")):
        draw.text((440, 48 + 58 * i), text, font=font("serif", 40), fill=(BLUE, INK, RED)[i])
    draw.rectangle((430, 36, 940, 216), outline=RED, width=5)
    _flow(draw)
    plot(draw, (470, 400, 680, 590), 91)
    for i, text in enumerate(("TODO", "– calibrate depth", "– 60 fps run", "– buy coffee!", "– ask Mia re. lens")):
        draw.text((740, 380 + 42 * i), text, font=font("bold" if i == 0 else "sans", 28), fill=GREEN)
    draw.line((738, 484, 930, 478), fill=RED, width=4)
    return image


def _flow(draw):
    for i, text in enumerate(("render", "match", "refine", "map")):
        left = 420 + 145 * i
        draw.rounded_rectangle((left, 262, left + 110, 326), 12, outline=BLUE, width=4)
        draw.text((left + 55, 294), text, font=font("sans", 25), fill=INK, anchor="mm")
        if i < 3:
            draw.line((left + 112, 294, left + 143, 294), fill=INK, width=4)


def corkboard():
    """A cork board with pinned sheets, photographs and notes."""
    width, height = 1024, 640
    image = Image.fromarray(np.tile(cork(), (2, 2, 1))[:height, :width])
    rng = random.Random(41)
    items = (("paper_1", 40, 40, 196), ("sticky_1", 262, 52, 96), ("paper_4", 384, 34, 176),
             ("sticky_4", 590, 60, 96), ("map", 600, 190, 300), ("paper_7", 830, 36, 150),
             ("sticky_2", 286, 190, 92), ("print", 60, 356, 230), ("paper_5", 330, 326, 180),
             ("sticky_3", 700, 44, 100), ("poster", 560, 420, 140), ("paper_8", 734, 436, 130),
             ("sticky_1", 898, 300, 88), ("sticky_3", 890, 476, 92), ("planner", 296, 560, 0))
    for name, x, y, size in items:
        if size == 0:
            continue
        maker = {"map": map_poster, "print": mountains, "poster": concert_poster}.get(name)
        picture = maker() if maker else SHEETS[name]()
        picture = picture.resize((size, size * picture.height // picture.width), Image.LANCZOS)
        turned = picture.convert("RGBA").rotate(rng.uniform(-5, 5), expand=True, resample=Image.BICUBIC)
        shadow = Image.new("RGBA", turned.size, (40, 24, 10, 120))
        image.paste(shadow, (x + 4, y + 5), turned.getchannel("A").point(lambda a: a // 2))
        image.paste(turned, (x, y), turned)
        pin = (x + turned.width // 2, y + 8)
        draw = ImageDraw.Draw(image)
        color = ((200, 40, 40), (40, 90, 180), (240, 200, 50), (50, 140, 80))[rng.randint(0, 3)]
        draw.ellipse((pin[0] - 5, pin[1] - 3, pin[0] + 9, pin[1] + 11), fill=(50, 34, 20))
        draw.ellipse((pin[0] - 7, pin[1] - 7, pin[0] + 7, pin[1] + 7), fill=color)
        draw.ellipse((pin[0] - 3, pin[1] - 5, pin[0] + 1, pin[1] - 1), fill=(250, 240, 240))
    return image


def clock():
    """A wall clock's face, ten past ten; transparent outside the rim."""
    n = 384
    image = Image.new("RGBA", (n, n), (0, 0, 0, 0))
    draw = ImageDraw.Draw(image)
    draw.ellipse((2, 2, n - 3, n - 3), fill=(44, 46, 50, 255))
    draw.ellipse((16, 16, n - 17, n - 17), fill=(246, 245, 240, 255))
    for i in range(60):
        a = math.radians(6 * i)
        inner = 150 if i % 5 else 138
        draw.line((n / 2 + inner * math.sin(a), n / 2 - inner * math.cos(a),
                   n / 2 + 162 * math.sin(a), n / 2 - 162 * math.cos(a)), fill=INK, width=3 if i % 5 else 6)
    for i in range(1, 13):
        a = math.radians(30 * i)
        draw.text((n / 2 + 116 * math.sin(a), n / 2 - 116 * math.cos(a)), str(i), font=font("bold", 30),
                  fill=INK, anchor="mm")
    for degrees, length, width in ((305, 84, 10), (60, 126, 7)):
        a = math.radians(degrees)
        draw.line((n / 2, n / 2, n / 2 + length * math.sin(a), n / 2 - length * math.cos(a)), fill=INK,
                  width=width)
    draw.line((n / 2, n / 2, n / 2 - 60, n / 2 + 120), fill=RED, width=3)
    draw.ellipse((n / 2 - 9, n / 2 - 9, n / 2 + 9, n / 2 + 9), fill=INK)
    return image


def chart_poster():
    """A results poster of plots, bars and a picture."""
    image = Image.new("RGB", (900, 640), (250, 250, 248))
    draw = ImageDraw.Draw(image)
    draw.rectangle((0, 0, 900, 96), fill=(20, 84, 92))
    draw.text((30, 14), "How far does a start converge?", font=font("bold", 42), fill=(255, 255, 255))
    draw.text((32, 66), "Keller, Osei, Lindqvist — Institute of Optics", font=font("sans", 19),
              fill=(210, 230, 232))
    for i in range(2):
        plot(draw, (50 + 300 * i, 150, 290 + 300 * i, 330), 60 + 5 * i, ("position error, cm", "orientation, deg")[i])
    bars(draw, (650, 140, 870, 330), 66)
    image.paste(mountains().resize((240, 176), Image.LANCZOS), (40, 400))
    image.paste(map_poster().resize((250, 202), Image.LANCZOS), (620, 396))
    paragraph(draw, (300, 390, 600, 600), 61, "sans", 14, INK, 1.35)
    return image


WALL = {
    "poster_map": map_poster,
    "poster_pinhole": pinhole_poster,
    "poster_concert": concert_poster,
    "poster_chart": chart_poster,
    "print_mountains": mountains,
    "planner": planner,
    "whiteboard": whiteboard,
    "corkboard": corkboard,
    "clock": clock,
}
