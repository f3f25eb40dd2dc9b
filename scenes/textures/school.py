# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""What lines and hangs in the corridors of an old school: tiles, lockers, signs, timetables, a vending machine."""

import random

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

from lettering import font, paragraph, words
from noise import mix, smoothstep, spectral, tint, to_bytes
from paper import BLUE, INK, RED, sheet

GREEN = (0, 122, 70)


def _to_edge(n):
    i = np.arange(n)
    return np.minimum(i, n - 1 - i).astype(float)


def floor_tiles():
    """Marbled floor tiles in two colours, 1.2 m a side: four by four, worn along the middle of each."""
    size, per = 1024, 4
    n = size // per
    out = np.zeros((size, size, 3))
    cloud = spectral((size, size), 301, 1.3, (1.0, 1.6))
    fleck = spectral((size, size), 302, 0.5, low=24, high=220)
    for row in range(per):
        for column in range(per):
            light, dark = (((196, 186, 164), (158, 146, 126)), ((112, 88, 74), (74, 56, 50)))[(row + column) % 2]
            block = np.s_[row * n:(row + 1) * n, column * n:(column + 1) * n]
            part = np.roll(cloud, 61 * (row * per + column), axis=(row + column) % 2)[block]
            piece = mix(light, dark, smoothstep(-1.0, 1.6, part))
            piece = mix(piece, (222, 214, 196), 0.55 * smoothstep(1.5, 2.3, fleck[block]))
            piece = mix(piece, (52, 44, 42), 0.55 * smoothstep(1.5, 2.3, -fleck[block]))
            edge = np.minimum(_to_edge(n)[:, None], _to_edge(n)[None, :])
            out[block] = piece * (1 - 0.45 * np.exp(-edge / 1.5))[..., None]
    scuff = smoothstep(1.6, 2.6, spectral((size, size), 303, 0.8, (1.0, 0.3), 4, 90))
    return to_bytes(out * (1 - 0.12 * scuff + 0.02 * spectral((size, size), 304, 0.3, low=60))[..., None])


def glazed_tiles():
    """Hand-made wall tiles, 0.9 m a side: six by six, each fired a little differently; neutral, to be tinted."""
    size, per = 1020, 6
    n = size // per
    rng = np.random.RandomState(311)
    glaze = 1 + 0.05 * spectral((size, size), 312, 1.0, low=8) + 0.02 * spectral((size, size), 313, 0.2, low=80)
    craze = np.exp(-np.abs(spectral((size, size), 314, 0.9, low=20)) / 0.05)
    out = np.zeros((size, size))
    y = np.arange(n)[:, None] / n
    for row in range(per):
        for column in range(per):
            block = np.s_[row * n:(row + 1) * n, column * n:(column + 1) * n]
            edge = np.minimum(_to_edge(n)[:, None], _to_edge(n)[None, :])
            level = rng.uniform(0.84, 1.08) * glaze[block] * (1 + 0.05 * (0.5 - y)) * (1 - 0.10 * craze[block])
            level *= 1 - 0.20 * np.exp(-(edge - 3) / 3.0)
            out[block] = np.where(edge < 3, 0.66 + 0.04 * glaze[block], level)
    return tint(out, (222, 222, 222))


def old_wall():
    """Distempered plaster with cracks, stains and the marks of bags and shoulders, 2.4 m a side; neutral."""
    shape = (1024, 1024)
    level = 1 + 0.025 * spectral(shape, 321, 1.5) + 0.025 * spectral(shape, 322, 0.35, low=60, high=400)
    level += 0.02 * spectral(shape, 323, 0.9, low=5, high=60)
    crack = np.exp(-np.abs(spectral(shape, 324, 1.35, low=2)) / 0.008) * smoothstep(0.2, 1.2, spectral(shape, 325, 1.8))
    scuff = smoothstep(1.8, 2.8, spectral(shape, 326, 0.8, (1.0, 0.22), 4, 80))
    chips = smoothstep(2.2, 2.5, spectral(shape, 327, 0.6, low=10, high=90))
    return tint(level - 0.30 * crack - 0.08 * scuff - 0.16 * chips, (228, 226, 219))


def locker():
    """The front of a steel locker, 0.3 m x 1.8 m: vents, handle, number plate, stickers; neutral."""
    width, height = 256, 1536
    level = 1 + 0.03 * spectral((height, width), 331, 0.3, low=40) + 0.05 * spectral((height, width), 332, 1.5)
    wear = smoothstep(1.7, 2.5, spectral((height, width), 333, 0.9, (0.4, 1.0), low=3))
    image = Image.fromarray(tint(level - 0.12 * wear, (205, 205, 205)))
    draw = ImageDraw.Draw(image)
    draw.rectangle((3, 3, width - 4, height - 4), outline=(88, 88, 90), width=5)
    for top in (120, 1330):
        for i in range(6):
            draw.rounded_rectangle((60, top + 22 * i, 196, top + 22 * i + 9), 4, fill=(46, 46, 48))
            draw.line((60, top + 22 * i + 10, 196, top + 22 * i + 10), fill=(236, 236, 236), width=2)
    draw.rectangle((196, 700, 226, 850), fill=(120, 120, 122), outline=(60, 60, 60), width=3)
    draw.ellipse((200, 800, 222, 822), fill=(40, 40, 42))
    draw.rectangle((88, 300, 168, 340), fill=(240, 238, 228), outline=(60, 60, 60), width=2)
    return image


def plate(number, name, names):
    """The sign beside a door: number, use, who works there."""
    image = Image.new("RGB", (240, 200), (236, 236, 232))
    draw = ImageDraw.Draw(image)
    draw.rectangle((0, 0, 240, 74), fill=(30, 64, 104))
    draw.text((14, 36), number, font=font("bold", 52), fill=(250, 250, 248), anchor="lm")
    draw.text((14, 100), name, font=font("bold", 25), fill=INK, anchor="lm")
    for i, line in enumerate(names):
        draw.text((14, 134 + 28 * i), line, font=font("sans", 19), fill=(70, 72, 80), anchor="lm")
    return image


_ROOMS = (("101", "Physics", ("M. Osei", "Laboratory")), ("102", "Classroom 7a", ("R. Lindqvist",)),
          ("103", "Chemistry", ("J. Moreau", "Goggles!")),
          ("104", "Classroom 8b", ("K. Tanaka",)), ("105", "Library", ("Mon–Thu 9–16",)),
          ("106", "Classroom 9a", ("I. Ferrer",)),
          ("107", "Music", ("P. Novak", "Choir Tue 14.00")), ("108", "Staff room", ("please knock",)))


def floors_sign():
    """The board on the landing that says what is where."""
    image = Image.new("RGB", (480, 640), (30, 64, 104))
    draw = ImageDraw.Draw(image)
    rows = (("2", ("Art room", "Assembly hall", "Computer room"), "↑"),
            ("1", ("Classrooms 7–9", "Physics, Chemistry", "Library, Music"), "→"),
            ("0", ("Office", "Classrooms 5–6", "Refectory"), "↓"), ("–1", ("Workshops", "Bicycles"), "↓"))
    for i, (floor, lines, arrow) in enumerate(rows):
        top = 16 + 154 * i
        draw.rectangle((14, top, 466, top + 142), fill=(236, 236, 232) if i == 1 else (60, 96, 140))
        ink = INK if i == 1 else (246, 246, 244)
        draw.text((66, top + 71), floor, font=font("bold", 76), fill=ink, anchor="mm")
        for k, line in enumerate(lines):
            draw.text((128, top + 34 + 38 * k), line, font=font("sans", 27), fill=ink, anchor="lm")
        draw.text((430, top + 71), arrow, font=font("bold", 54), fill=ink, anchor="mm")
    return image


def escape_plan():
    """The plan of the floor with escape routes, and what to do in case of fire."""
    image, draw = sheet((640, 452), (246, 246, 242), 341)
    draw.rectangle((0, 0, 640, 46), fill=GREEN)
    draw.text((16, 23), "ESCAPE PLAN   1st floor", font=font("bold", 26), fill=(255, 255, 255), anchor="lm")
    for i in range(8):
        x = 70 + 64 * i
        for top, bottom in ((76, 146), (186, 256)):
            draw.rectangle((x, top, x + 64, bottom), outline=INK, width=3)
            draw.text((x + 32, (top + bottom) // 2), str(101 + i if top == 76 else 109 + i), font=font("sans", 15),
                      fill=INK, anchor="mm")
    draw.rectangle((10, 76, 70, 256), outline=INK, width=3)
    for i in range(9):
        draw.line((12 + 6 * i, 90, 12 + 6 * i, 160), fill=INK)
    for x in range(100, 580, 60):
        draw.polygon([(x, 166), (x + 26, 158), (x + 26, 174)], fill=GREEN)
        draw.line((x + 26, 166, x + 50, 166), fill=GREEN, width=5)
    for x, y in ((330, 166), (96, 150), (560, 150)):
        draw.rectangle((x, y, x + 14, y + 14), fill=RED)
    draw.ellipse((204, 158, 222, 176), fill=BLUE)
    for column in range(2):
        draw.text((18 + 310 * column, 276), ("In case of fire", "In case of an accident")[column],
                  font=font("bold", 16), fill=RED)
        paragraph(draw, (18 + 310 * column, 300, 310 + 310 * column, 444), 342 + column, "sans", 12, INK, 1.35)
    return image


def timetable():
    """A week of lessons."""
    image, draw = sheet((620, 440), (248, 247, 240), 351)
    draw.text((20, 14), "TIMETABLE 8b", font=font("bold", 34), fill=INK)
    rng, subjects = random.Random(352), ("Maths", "Physics", "German", "French", "Music", "Art", "Sport", "History",
                                         "Biology")
    colors = ((236, 200, 120), (150, 190, 224), (220, 150, 140), (160, 206, 160), (206, 170, 214), (240, 226, 150),
              (170, 216, 212), (216, 196, 170), (188, 214, 140))
    for day, name in enumerate(("Mon", "Tue", "Wed", "Thu", "Fri")):
        draw.text((90 + 104 * day, 66), name, font=font("bold", 18), fill=BLUE)
        lesson = 0
        while lesson < 7:
            k, long_ = rng.randrange(9), rng.choice((1, 1, 2))
            bottom = 92 + 48 * min(lesson + long_, 7) - 3
            draw.rectangle((84 + 104 * day, 92 + 48 * lesson, 182 + 104 * day, bottom), fill=colors[k],
                           outline=(120, 120, 120))
            draw.text((92 + 104 * day, 100 + 48 * lesson), subjects[k], font=font("sans", 16), fill=INK)
            draw.text((92 + 104 * day, 119 + 48 * lesson), f"R {rng.randint(101, 108)}", font=font("sans", 12),
                      fill=INK)
            lesson += long_
    for lesson in range(7):
        draw.text((16, 104 + 48 * lesson), f"{8 + lesson}.15", font=font("sans", 17), fill=INK)
    return image


def notices():
    """A felt board full of leaflets."""
    width, height = 1024, 620
    rng = random.Random(361)
    felt = 1 + 0.10 * spectral((height, width), 362, 0.3, low=60) + 0.05 * spectral((height, width), 363, 1.3)
    image = Image.fromarray(tint(felt, (62, 84, 70)))
    stream = words(364)
    for i in range(21):
        w, h = rng.choice(((120, 166), (150, 110), (96, 96), (180, 130), (130, 180)))
        color = rng.choice(((246, 244, 236), (250, 226, 120), (170, 214, 240), (244, 170, 160), (190, 226, 170),
                            (244, 244, 240)))
        leaf, draw = sheet((w, h), color, 370 + i)
        draw.rectangle((0, 0, w, 26), fill=rng.choice((RED, BLUE, GREEN, INK, (200, 110, 30))))
        draw.text((6, 13), next(stream).upper()[:9], font=font("bold", 17), fill=(255, 255, 255), anchor="lm")
        if i % 3 == 0:
            draw.ellipse((w // 2 - 26, 40, w // 2 + 26, 92), fill=rng.choice((RED, BLUE, GREEN)))
        paragraph(draw, (8, 34 + 62 * (i % 3 == 0), w - 8, h - 6), 380 + i, "sans", 10, INK, 1.3)
        turned = leaf.convert("RGBA").rotate(rng.uniform(-6, 6), expand=True, resample=Image.BICUBIC)
        x, y = 20 + (i % 7) * 142 + rng.randint(-14, 14), 18 + (i // 7) * 198 + rng.randint(-12, 12)
        image.paste((20, 30, 24), (x + 4, y + 5), turned.getchannel("A").point(lambda a: a // 2))
        image.paste(turned, (x, y), turned)
        pin = ImageDraw.Draw(image)
        px, py = x + turned.width // 2, y + 9
        pin.ellipse((px - 6, py - 6, px + 6, py + 6), fill=rng.choice(((210, 50, 40), (240, 200, 60), (60, 110, 200))))
    return image


def vending():
    """The lit front of a vending machine, 0.9 m x 1.8 m."""
    width, height = 480, 960
    image = Image.new("RGB", (width, height), (150, 26, 34))
    draw, rng = ImageDraw.Draw(image), random.Random(391)
    draw.text((24, 20), "SNACK · DRINK", font=font("bold", 46), fill=(252, 240, 210))
    draw.rectangle((24, 90, 356, 800), fill=(30, 32, 38))
    for row in range(6):
        y = 96 + 117 * row
        draw.rectangle((30, y + 96, 350, y + 106), fill=(170, 172, 176))
        for column in range(6):
            x = 36 + 52 * column
            color = tuple(rng.randint(60, 240) for _ in range(3))
            dark = tuple(int(0.6 * c) for c in color)
            if row < 3:
                draw.rounded_rectangle((x, y + 14, x + 42, y + 94), 6, fill=color, outline=dark, width=2)
                draw.rectangle((x + 4, y + 40, x + 38, y + 62), fill=(250, 246, 236))
            else:
                draw.rectangle((x + 14, y + 8, x + 28, y + 26), fill=dark)
                draw.rounded_rectangle((x + 4, y + 24, x + 38, y + 94), 8, fill=color, outline=dark, width=2)
                draw.rectangle((x + 4, y + 48, x + 38, y + 70), fill=(246, 242, 230))
            draw.text((x + 8, y + 96), f"{row + 1}{column + 1}", font=font("bold", 9), fill=INK)
    draw.rectangle((376, 120, 460, 300), fill=(24, 26, 30))
    for i in range(12):
        x, y = 384 + 24 * (i % 3), 180 + 28 * (i // 3)
        draw.rectangle((x, y, x + 20, y + 22), fill=(190, 194, 200))
        draw.text((x + 10, y + 11), "123456789*0#"[i], font=font("bold", 13), fill=INK, anchor="mm")
    draw.text((418, 146), "0.80", font=font("mono-bold", 26), fill=(120, 240, 140), anchor="mm")
    draw.rectangle((396, 330, 440, 344), fill=(10, 10, 10))
    draw.rectangle((60, 830, 330, 920), fill=(20, 20, 24), outline=(90, 90, 94), width=5)
    return image.filter(ImageFilter.GaussianBlur(0.6))


def hose_cabinet():
    """The door of a fire hose cabinet."""
    level = 1 + 0.03 * spectral((480, 400), 401, 0.3, low=30) + 0.04 * spectral((480, 400), 402, 1.4)
    image = Image.fromarray(tint(level, (196, 34, 30)))
    draw = ImageDraw.Draw(image)
    draw.rectangle((8, 8, 391, 471), outline=(120, 16, 16), width=6)
    draw.rectangle((110, 60, 290, 240), fill=(246, 246, 242))
    draw.rectangle((120, 70, 280, 230), fill=(196, 34, 30))
    draw.ellipse((150, 100, 250, 200), outline=(246, 246, 242), width=14)
    draw.line((240, 190, 262, 214), fill=(246, 246, 242), width=14)
    draw.text((200, 290), "FIRE HOSE", font=font("bold", 44), fill=(250, 248, 244), anchor="mm")
    draw.text((200, 340), "break the seal, open,", font=font("sans", 22), fill=(250, 248, 244), anchor="mm")
    draw.text((200, 368), "unroll, turn the wheel", font=font("sans", 22), fill=(250, 248, 244), anchor="mm")
    draw.rounded_rectangle((350, 200, 376, 290), 8, fill=(210, 210, 212), outline=(60, 60, 60), width=3)
    return image


def class_photo(seed, year):
    """Rows of pupils before a wall, in sepia."""
    width, height = 520, 360
    rng = random.Random(seed)
    image = Image.fromarray(tint(1 + 0.08 * spectral((height, width), seed, 1.0), (150, 140, 124)))
    draw = ImageDraw.Draw(image)
    for row in range(4):
        for column in range(11 - row % 2):
            x, y = 44 + 43 * column + 20 * (row % 2) + rng.randint(-3, 3), 96 + 58 * row + rng.randint(-4, 4)
            cloth = rng.randint(30, 210)
            draw.ellipse((x - 21, y + 16, x + 21, y + 90), fill=(cloth, cloth - 6, int(cloth * 0.88)))
            draw.ellipse((x - 14, y - 20, x + 14, y + 18), fill=(rng.randint(180, 226), 190, 164))
            hair = rng.randint(20, 150)
            draw.pieslice((x - 15, y - 23, x + 15, y + 12), 180, 360, fill=(hair, hair - 8, hair - 14))
            draw.point([(x - 5, y), (x + 5, y)], fill=(40, 30, 30))
            draw.line((x - 5, y + 9, x + 5, y + 9), fill=(120, 70, 60), width=2)
    framed = Image.new("RGB", (width + 60, height + 90), (238, 234, 222))
    framed.paste(image, (30, 30))
    ImageDraw.Draw(framed).text(((width + 60) // 2, height + 58), f"Class of {year}", font=font("serif", 30),
                                fill=INK, anchor="mm")
    return framed


def wet_floor():
    """The yellow board on a freshly mopped floor."""
    image = Image.new("RGB", (220, 440), (246, 204, 30))
    draw = ImageDraw.Draw(image)
    draw.text((110, 54), "CAUTION", font=font("bold", 38), fill=INK, anchor="mm")
    draw.polygon([(110, 96), (190, 240), (30, 240)], outline=INK, width=9)
    draw.text((110, 190), "!", font=font("bold", 90), fill=INK, anchor="mm")
    for i, line in enumerate(("WET", "FLOOR")):
        draw.text((110, 290 + 54 * i), line, font=font("bold", 48), fill=INK, anchor="mm")
    draw.line((30, 400, 190, 400), fill=INK, width=6)
    return image


SCHOOL = {
    "floor_tiles": floor_tiles,
    "glazed_tiles": glazed_tiles,
    "old_wall": old_wall,
    "locker": locker,
    "floors_sign": floors_sign,
    "escape_plan": escape_plan,
    "timetable": timetable,
    "notices": notices,
    "vending": vending,
    "hose_cabinet": hose_cabinet,
    "class_photo_1": lambda: class_photo(411, 1987),
    "class_photo_2": lambda: class_photo(421, 1994),
    "wet_floor": wet_floor,
}
SCHOOL.update({f"plate_{room[0]}": (lambda room=room: plate(*room)) for room in _ROOMS})
