# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""What hangs and stands in a living room: paintings, prints, photographs, music, and the garden outside."""

import math
import random

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

from lettering import font
from noise import mix, smoothstep, spectral, to_bytes
from wall import mountains


def brushed(image, seed, strokes=9000, length=26):
    """The picture painted anew in short strokes that follow its contours, on a weave of canvas."""
    pixels = np.asarray(image.filter(ImageFilter.GaussianBlur(2))).astype(float)
    height, width = pixels.shape[:2]
    gray = np.asarray(image.convert("L").filter(ImageFilter.GaussianBlur(5))).astype(float)
    gy, gx = np.gradient(gray)
    swirl = 0.7 * spectral((height, width), seed, 1.6)
    out = image.filter(ImageFilter.GaussianBlur(6))
    draw, rng = ImageDraw.Draw(out), random.Random(seed)
    for i in range(strokes):
        x, y = rng.randrange(width), rng.randrange(height)
        angle = math.atan2(gx[y, x], -gy[y, x]) if gx[y, x] ** 2 + gy[y, x] ** 2 > 0.5 else swirl[y, x]
        reach = length * rng.uniform(0.4, 1.0) * (1.4 if i < strokes // 3 else 0.7)
        dx, dy = reach / 2 * math.cos(angle), reach / 2 * math.sin(angle)
        shade = rng.gauss(1.0, 0.07)
        color = tuple(int(min(max(c * shade + rng.gauss(0, 5), 0), 255)) for c in pixels[y, x])
        draw.line((x - dx, y - dy, x + dx, y + dy), fill=color, width=rng.randint(3, 6))
    weave = 1.0 + 0.03 * spectral((height, width), seed + 1, 0.2, low=80)
    return Image.fromarray(to_bytes(np.asarray(out) * weave[..., None]))


def _sky(height, width, top, low, seed):
    y = np.linspace(0, 1, height)[:, None] * np.ones((1, width))
    cloud = spectral((height, width), seed, 1.5, (1.0, 3.0))
    return mix(mix(top, low, y), (250, 242, 230), 0.8 * smoothstep(0.1, 1.8, cloud) * (1 - 0.5 * y)), y


def sea():
    """Boats before a coast in the evening."""
    height, width = 600, 840
    rgb, y = _sky(height, width, (86, 122, 172), (242, 196, 140), 1401)
    wave = spectral((height, width), 1402, 0.9, (2.5, 0.7), low=6)
    water = mix((40, 84, 104), (196, 170, 132), smoothstep(0.2, 1.8, wave) * (1.3 - y))
    rgb = mix(rgb, water, smoothstep(0.50, 0.505, y))
    coast = 0.5 - 0.09 * smoothstep(0.45, 1.0, np.linspace(0, 1, width)) + 0.012 * spectral((1, width), 1403, 1.2)[0]
    rgb = mix(rgb, (96, 94, 96), smoothstep(0, 0.006, y - coast[None, :]) * smoothstep(0.512, 0.505, y))
    image = Image.fromarray(to_bytes(rgb))
    draw = ImageDraw.Draw(image)
    for x, foot, size, hull in ((190, 420, 150, (120, 40, 34)), (430, 370, 90, (40, 46, 60)),
                                (640, 460, 190, (52, 70, 60)),
                                (330, 330, 40, (60, 40, 40)), (760, 335, 36, (60, 40, 40))):
        draw.polygon([(x - size * 0.5, foot), (x + size * 0.5, foot), (x + size * 0.34, foot + size * 0.16),
                      (x - size * 0.36, foot + size * 0.16)], fill=hull)
        draw.line((x, foot, x, foot - size), fill=(60, 44, 34), width=4)
        draw.polygon([(x + 4, foot - size), (x + 4, foot - 8), (x + size * 0.46, foot - 10)], fill=(240, 228, 200))
        draw.polygon([(x - 4, foot - size * 0.9), (x - 4, foot - 8), (x - size * 0.36, foot - 8)], fill=(220, 160, 96))
    return brushed(image, 1404)


def field():
    """A path between poppies and wheat under poplars."""
    height, width = 640, 800
    rgb, y = _sky(height, width, (96, 148, 206), (226, 226, 206), 1411)
    x = np.linspace(-1, 1, width)[None, :] * np.ones((height, 1))
    tufts = spectral((height, width), 1412, 0.6, low=10)
    wheat = mix((206, 176, 84), (146, 150, 70), smoothstep(-1, 1.4, tufts))
    poppies = smoothstep(1.2, 1.6, spectral((height, width), 1413, 0.5, low=14)) * smoothstep(0.55, 0.8, y) * (x < 0.25)
    wheat = mix(wheat, (206, 52, 36), poppies)
    path = np.abs(x - 0.35 * (1 - y) - 0.12 * np.sin(6 * y)) < 0.22 * (y - 0.48)
    wheat = mix(wheat, (214, 190, 156), path.astype(float))
    rgb = mix(rgb, wheat, smoothstep(0.5, 0.507, y))
    image = Image.fromarray(to_bytes(rgb))
    draw, rng = ImageDraw.Draw(image), random.Random(1414)
    for i in range(9):
        cx, tall = 40 + 90 * i + rng.randint(-20, 20), rng.randint(70, 210)
        draw.ellipse((cx - tall * 0.14, 330 - tall, cx + tall * 0.14, 336),
                     fill=(46 + 8 * (i % 3), 84 + 6 * (i % 4), 52))
    draw.polygon([(560, 330), (560, 276), (604, 240), (648, 276), (648, 330)], fill=(226, 208, 186))
    draw.polygon([(548, 280), (604, 232), (660, 280)], fill=(160, 72, 52))
    return brushed(image, 1415, 11000)


def still_life():
    """A jug and fruit on a table before a dark wall."""
    height, width = 560, 680
    y, x = np.mgrid[0:height, 0:width].astype(float)
    rgb = mix((66, 54, 46), (30, 26, 28), np.clip(np.hypot(x - 200, y - 160) / 520, 0, 1))
    cloth = mix((206, 200, 186), (120, 118, 120), smoothstep(-1, 1.5, spectral((height, width), 1421, 1.3, (1.0, 2.0))))
    rgb = mix(rgb, cloth, smoothstep(380, 386, y + 14 * np.sin(x / 70)))
    for cx, cy, rx, ry, color in ((250, 270, 92, 128, (70, 96, 126)), (250, 150, 40, 60, (70, 96, 126)),
                                  (400, 360, 62, 60, (196, 70, 40)),
                                  (500, 376, 56, 52, (214, 166, 50)), (448, 416, 58, 54, (140, 152, 60)),
                                  (330, 430, 50, 46, (190, 90, 46)),
                                  (570, 420, 44, 40, (120, 36, 50))):
        d = ((x - cx) / rx) ** 2 + ((y - cy) / ry) ** 2
        light = np.clip(1.25 - 0.75 * np.hypot(x - cx + 0.4 * rx, y - cy + 0.4 * ry) / max(rx, ry), 0.25, 1.3)
        glint = 110 * np.exp(-(((x - cx + 0.4 * rx) / (0.2 * rx)) ** 2 + ((y - cy + 0.45 * ry) / (0.2 * ry)) ** 2))
        body = np.asarray(color, float) * light[..., None] + glint[..., None]
        rgb = mix(rgb, body, smoothstep(1.03, 0.97, d))
    return brushed(Image.fromarray(to_bytes(rgb)), 1422, 8000, 22)


def abstract():
    """A composition of planes, arcs and bars."""
    size = 720
    rng = random.Random(1431)
    colors = ((226, 216, 192), (204, 84, 52), (38, 60, 84), (226, 172, 70), (110, 140, 130), (40, 36, 38),
              (176, 130, 120))
    image = Image.new("RGB", (size, size), colors[0])
    draw = ImageDraw.Draw(image)
    for i in range(34):
        x, y, r = rng.randint(0, size), rng.randint(0, size), rng.randint(30, 190)
        color = colors[1 + i % 6]
        if i % 4 == 0:
            draw.pieslice((x - r, y - r, x + r, y + r), rng.randint(0, 3) * 90, rng.randint(4, 6) * 90, fill=color)
        elif i % 4 == 1:
            draw.rectangle((x, y, x + r, y + rng.randint(20, 120)), fill=color)
        elif i % 4 == 2:
            draw.arc((x - r, y - r, x + r, y + r), rng.randint(0, 180), rng.randint(200, 360), fill=color, width=9)
        else:
            draw.line((x, y, x + rng.randint(-200, 200), y + rng.randint(-200, 200)), fill=color,
                      width=rng.randint(4, 14))
    paint = 1.0 + 0.06 * spectral((size, size), 1432, 0.7, (1.0, 3.0)) + 0.03 * spectral((size, size), 1433, 0.2,
            low=90)
    return Image.fromarray(to_bytes(np.asarray(image) * paint[..., None]))


def botanical(seed, name):
    """An engraved plate: a fern or a branch with its Latin name."""
    image = Image.new("RGB", (400, 540), (238, 230, 208))
    draw, rng = ImageDraw.Draw(image), random.Random(seed)
    points = [(200 + 40 * math.sin(2.4 * t + seed), 450 - 360 * t) for t in np.linspace(0, 1, 26)]
    draw.line(points, fill=(70, 84, 50), width=4)
    for i, (x, y) in enumerate(points[3:], 3):
        reach = 110 * (1 - i / 27) + 10
        for side in (-1, 1):
            tip = (x + side * reach, y - 0.5 * reach)
            green = (60 + rng.randint(0, 50), 96 + rng.randint(0, 40), 56)
            for k in range(8):
                px, py = x + (tip[0] - x) * k / 8, y + (tip[1] - y) * k / 8
                w = 0.15 * reach * (1 - k / 9)
                draw.polygon([(px, py), (px + side * w, py - 2.2 * w), (px + 2.0 * side * w, py)], fill=green)
                draw.polygon([(px, py), (px + side * w, py + 1.6 * w), (px + 2.0 * side * w, py)],
                             fill=tuple(int(0.8 * c) for c in green))
            draw.line((x, y, *tip), fill=(60, 70, 44), width=2)
    draw.text((200, 496), name, font=font("serif", 22), fill=(60, 52, 44), anchor="mm")
    draw.rectangle((14, 14, 386, 526), outline=(120, 104, 80), width=2)
    stain = 1.0 - 0.05 * smoothstep(0.6, 2.2, spectral((540, 400), seed + 1, 1.4)) + 0.012 * spectral((540, 400),
            seed + 2, 0.3)
    return Image.fromarray(to_bytes(np.asarray(image) * stain[..., None]))


def photograph(seed):
    """A print in black and white with a white margin: hills, a lake and a tree."""
    height, width = 300, 400
    y = np.linspace(0, 1, height)[:, None] * np.ones((1, width))
    level = 235 - 60 * y + 16 * spectral((height, width), seed, 1.5, (1.0, 2.5))
    for i in range(4):
        ridge = 0.4 + 0.1 * i + (0.09 - 0.015 * i) * spectral((1, width), seed + 10 + i, 1.6)[0]
        slope = 150 - 32 * i + 26 * spectral((height, width), seed + 20 + i, 0.8, low=5)
        level = np.where(y > ridge[None, :], slope, level)
    image = Image.fromarray(to_bytes(np.repeat(level[..., None], 3, 2) * np.array((1.0, 0.97, 0.9))))
    draw, rng = ImageDraw.Draw(image), random.Random(seed)
    x = rng.randint(80, 320)
    draw.line((x, 290, x, 170), fill=(24, 22, 20), width=9)
    for _ in range(700):
        a, b = x + rng.gauss(0, 36), 130 + rng.gauss(0, 30)
        draw.ellipse((a - 4, b - 3, a + 4, b + 3), fill=(rng.randint(20, 110),) * 3)
    framed = Image.new("RGB", (480, 380), (242, 240, 234))
    framed.paste(image, (40, 40))
    return framed


def music():
    """A page of piano music."""
    image = Image.new("RGB", (420, 560), (240, 234, 216))
    draw, rng = ImageDraw.Draw(image), random.Random(1461)
    draw.text((210, 34), "NOCTURNE", font=font("serif-bold", 26), fill=(30, 28, 26), anchor="mm")
    for system in range(4):
        for staff in range(2):
            top = 74 + 122 * system + 52 * staff
            for i in range(5):
                draw.line((30, top + 7 * i, 390, top + 7 * i), fill=(70, 66, 60))
            x = 56
            while x < 380:
                note = top + 3.5 * rng.randint(-2, 9)
                draw.ellipse((x - 5, note - 3, x + 4, note + 4), fill=(24, 22, 22))
                stem = -24 if note > top + 14 else 24
                draw.line((x + (4 if stem < 0 else -5), note, x + (4 if stem < 0 else -5), note + stem),
                          fill=(24, 22, 22), width=2)
                if rng.random() < 0.4:
                    draw.line((x + 4, note + stem, x + 20, note + stem + rng.randint(-4, 4)), fill=(24, 22, 22),
                              width=4)
                x += rng.choice((14, 18, 18, 26))
        for bar in (30, 150, 270, 390):
            draw.line((bar, 74 + 122 * system, bar, 154 + 122 * system), fill=(40, 38, 36), width=2)
    return image


def magazine(seed, title, color):
    """A cover: a big title over a picture, headlines below."""
    image = {0: sea, 1: still_life, 2: field}[seed % 3]().resize((420, 560), Image.LANCZOS)
    draw = ImageDraw.Draw(image)
    draw.rectangle((0, 0, 420, 96), fill=color)
    draw.text((210, 48), title, font=font("bold", 62), fill=(250, 248, 240), anchor="mm")
    for i, line in enumerate(("SLOW WEEKENDS", "42 gardens to visit", "The light of the north", "Bread at home")):
        draw.rectangle((18, 388 + 40 * i, 250, 420 + 40 * i), fill=(250, 248, 240))
        draw.text((26, 392 + 40 * i), line, font=font("bold" if i == 0 else "sans", 19), fill=(34, 32, 36))
    return image


def garden():
    """A park seen from a first floor: lawn, a path, shrubs, big trees, sky."""
    size = 1024
    y = np.linspace(0, 1, size)[:, None] * np.ones((1, size))
    rgb, _ = _sky(size, size, (120, 164, 220), (226, 234, 238), 1471)
    rows = np.linspace(0, 1, size)[:, None]
    layers = ((0.40, 0.055, (110, 136, 124)), (0.46, 0.05, (84, 116, 80)), (0.52, 0.06, (60, 96, 50)))
    for i, (level, swing, color) in enumerate(layers):
        top = level + swing * spectral((1, size), 1472 + i, 1.2, low=2)[0]
        leaf = 1 + 0.3 * spectral((size, size), 1480 + i, 0.55, low=10) + 0.15 * spectral((size, size), 1490 + i, 1.4)
        ragged = top[None, :] + 0.012 * spectral((size, size), 1500 + i, 0.6, low=12)
        rgb = mix(rgb, np.asarray(color, float) * np.clip(leaf, 0.3, 1.9)[..., None],
                  smoothstep(0, 0.004, rows - ragged))
    blades = 1 + 0.12 * spectral((size, size), 1510, 0.4, (0.6, 1.4), low=20) + 0.10 * spectral((size, size), 1511,
            1.4, (3.0, 1.0))
    lawn = mix((118, 148, 70), (86, 120, 52), smoothstep(0.6, 1.0, y)) * blades[..., None]
    rgb = mix(rgb, lawn, smoothstep(0.635, 0.645, y + 0.01 * spectral((size, size), 1512, 1.0, low=6)))
    x = np.linspace(-1, 1, size)[None, :] * np.ones((size, 1))
    path = np.abs(x + 0.45 - 1.1 * (y - 0.64)) < 0.03 + 0.28 * np.clip(y - 0.64, 0, 1)
    gravel = np.asarray((204, 190, 164), float) * (1 + 0.08 * spectral((size, size), 1513, 0.3, low=40))[..., None]
    rgb = mix(rgb, gravel, (path & (y > 0.645)).astype(float))
    image = Image.fromarray(to_bytes(rgb))
    for foot, tall, seed in (((210, 720), 560, 1), ((840, 760), 690, 2), ((560, 680), 330, 3)):
        _tree(image, foot, tall, seed)
    return image


def _tree(image, foot, tall, seed):
    draw, rng = ImageDraw.Draw(image), random.Random(1520 + seed)
    x, y = foot
    draw.polygon([(x - 0.035 * tall, y), (x + 0.035 * tall, y), (x + 0.014 * tall, y - 0.55 * tall),
                  (x - 0.014 * tall, y - 0.55 * tall)],
                 fill=(74, 60, 48))
    boughs = [(rng.gauss(0, 0.11), rng.gauss(-0.66, 0.10), rng.uniform(0.12, 0.2)) for _ in range(14)]
    for _ in range(9000):
        bx, by, reach = rng.choice(boughs)
        r, a = reach * math.sqrt(rng.random()), rng.uniform(0, 2 * math.pi)
        px, py = x + tall * (bx + r * math.cos(a)), y + tall * (by + 0.8 * r * math.sin(a))
        lit = 0.72 - 0.5 * r * math.sin(a) / reach + rng.gauss(0, 0.16)
        color = tuple(int(min(max(c * lit, 0), 255)) for c in (96, 128, 58))
        s = tall * rng.uniform(0.003, 0.009)
        draw.ellipse((px - s, py - s, px + s, py + s), fill=color)


def film():
    """A still on the television: mountains over a lake, with a subtitle."""
    image = mountains().crop((50, 50, 850, 500)).resize((960, 540), Image.LANCZOS)
    mirror = image.crop((0, 180, 960, 400)).transpose(Image.FLIP_TOP_BOTTOM).filter(ImageFilter.GaussianBlur(3))
    image.paste(Image.blend(mirror, Image.new("RGB", mirror.size, (40, 70, 90)), 0.35), (0, 400))
    draw = ImageDraw.Draw(image)
    for i in range(60):
        y = 402 + (i * 37) % 136
        draw.line(((i * 173) % 960, y, (i * 173) % 960 + 30 + y // 8, y), fill=(190, 200, 206))
    draw.text((480, 500), "— and in the valley the snow was gone.", font=font("bold", 26), fill=(250, 246, 220),
              anchor="mm")
    return image


PAINTINGS = {
    "painting_sea": sea,
    "painting_field": field,
    "painting_still_life": still_life,
    "painting_abstract": abstract,
    "botanical_1": lambda: botanical(1441, "Dryopteris filix-mas"),
    "botanical_2": lambda: botanical(1444, "Salix viminalis"),
    "photo_1": lambda: photograph(1451),
    "photo_2": lambda: photograph(1456),
    "music": music,
    "magazine_1": lambda: magazine(0, "COAST", (30, 84, 110)),
    "magazine_2": lambda: magazine(2, "LAND", (150, 60, 40)),
    "film": film,
    "garden": garden,
}
