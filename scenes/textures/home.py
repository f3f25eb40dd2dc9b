# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""What a home is lined and covered with: parquet, plaster, wallpaper, brick, leather, rugs, tartan."""

import math

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

from noise import mix, relief, smoothstep, spectral, tint, to_bytes
from surfaces import wood


def parquet():
    """Oak in herringbone, 1.2 m a side: staves of 0.30 m x 0.075 m, each of its own piece of veneer.

    The cell (x, y) of one stave's width belongs to a lying stave where (x - y) mod 8 < 4, else to an upright one.
    """
    size, pitch = 1024, 64
    stock = [wood(140 + i, (206, 164, 110), (146, 100, 58), (1024, 256), rings=3) for i in range(4)]
    out = np.zeros((size, size, 3))
    rng = np.random.RandomState(150)
    for y in range(size // pitch):
        for x in range(size // pitch):
            if (x - y) % 8 in (0, 7):
                _stave(out, (pitch * x, pitch * y), (x - y) % 8 == 7, stock, rng)
    return to_bytes(out)


def _stave(out, corner, upright, stock, rng):
    size, long_, wide = out.shape[0], 256, 64
    veneer = stock[rng.randint(len(stock))]
    x, y = rng.randint(veneer.shape[1] - long_), rng.randint(veneer.shape[0] - wide)
    piece = veneer[y:y + wide, x:x + long_].astype(float) * rng.uniform(0.84, 1.1)
    edge = np.minimum(_to_edge(wide)[:, None], _to_edge(long_)[None, :])
    piece *= (1.0 - 0.5 * np.exp(-edge / 1.1))[..., None]
    if upright:
        piece = piece.transpose(1, 0, 2)
    rows = (corner[1] + np.arange(piece.shape[0])) % size
    columns = (corner[0] + np.arange(piece.shape[1])) % size
    out[np.ix_(rows, columns)] = piece


def _to_edge(n):
    i = np.arange(n)
    return np.minimum(i, n - 1 - i).astype(float)


def plaster():
    """Hand-trowelled plaster under matt paint, 2 m a side; neutral, to be tinted."""
    shape = (1024, 1024)
    sweeps = spectral(shape, 161, 1.1, (1.0, 0.45), 5, 90)
    ridges = np.abs(spectral(shape, 162, 0.9, (0.5, 1.0), 8, 120))
    nap = spectral(shape, 163, 0.25, low=70, high=330)
    level = relief(0.9 * sweeps - 1.3 * ridges + 0.16 * nap, 0.066)
    level += 0.014 * spectral(shape, 164, 1.5) + 0.012 * spectral(shape, 165, 0.9, low=4, high=40)
    return tint(level, (226, 225, 221))


def wallpaper():
    """A printed paper of leaves and stems on a pale ground, 0.64 m a side."""
    size = 1024
    image = Image.new("RGB", (size, size), (214, 206, 182))
    draw = ImageDraw.Draw(image)
    rng = np.random.RandomState(171)
    for column in range(4):
        _stem(draw, size, 128 + 256 * column, rng)
    ground = np.asarray(image.filter(ImageFilter.GaussianBlur(0.7))).astype(float)
    grain = 1.0 + 0.02 * spectral((size, size), 172, 0.3, (1.0, 4.0), low=50) + 0.012 * spectral((size, size), 173, 1.3)
    return to_bytes(ground * grain[..., None])


def _stem(draw, size, x0, rng):
    """One climbing stem with its leaves and berries, periodic in y and drawn across the borders in x."""
    phase = rng.uniform(0, 6.28)

    def at(y):
        return x0 + 46 * math.sin(2 * math.pi * y / size * 2 + phase)

    greens = ((96, 118, 96), (126, 142, 112), (70, 96, 88), (150, 152, 116))
    for dx in (-size, 0, size):
        draw.line([(at(y) + dx, y) for y in range(0, size + 8, 8)], fill=(112, 104, 80), width=7)
    for i in range(18):
        y, side = size * i / 18, 1 if i % 2 else -1
        angle, length = side * rng.uniform(0.5, 1.0), rng.uniform(78, 116)
        color = greens[rng.randint(4)]
        berry = rng.uniform() < 0.3
        for dx in (-size, 0, size):
            for dy in (-size, 0, size):
                _leaf(draw, (at(y) + dx, y + dy), angle, length, color)
                if berry:
                    _berries(draw, at(y) + dx - side * 24, y + dy - 26)


def _leaf(draw, foot, angle, length, color):
    ax, ay = math.sin(angle), -math.cos(angle)
    outline = []
    for side in (1, -1):
        half = [(foot[0] + ax * length * t - side * ay * 0.24 * length * math.sin(math.pi * t) ** 0.8,
                 foot[1] + ay * length * t + side * ax * 0.24 * length * math.sin(math.pi * t) ** 0.8)
                for t in np.linspace(0, 1, 12)]
        outline += half if side == 1 else half[::-1]
    dark = tuple(int(0.72 * c) for c in color)
    draw.polygon(outline, fill=color, outline=dark)
    tip = (foot[0] + ax * length, foot[1] + ay * length)
    draw.line((*foot, *tip), fill=dark, width=3)
    for t in (0.3, 0.5, 0.7):
        x, y = foot[0] + ax * length * t, foot[1] + ay * length * t
        for side in (1, -1):
            draw.line((x, y, x + 0.16 * length * (ax - side * ay), y + 0.16 * length * (ay + side * ax)), fill=dark,
                      width=2)


def _berries(draw, x, y):
    for dx, dy in ((0, 0), (15, 7), (4, 17)):
        draw.ellipse((x + dx - 8, y + dy - 8, x + dx + 8, y + dy + 8), fill=(178, 92, 70), outline=(120, 56, 48))


def brick(seed=181, light=(182, 104, 76), dark=(110, 54, 42)):
    """A wall of brick, 0.96 m a side: eight stretchers by sixteen courses, laid in half bond."""
    size, courses, per = 1024, 12, 4
    rng = np.random.RandomState(seed)
    out = np.zeros((size, size, 3))
    tall, wide = size / courses, size / per
    mortar = tint(1.0 + 0.06 * spectral((size, size), seed + 1, 0.4, low=20), (178, 170, 158)).astype(float)
    skin = 1.0 + 0.09 * spectral((size, size), seed + 2, 0.5, low=10) + 0.05 * spectral((size, size), seed + 3, 1.4)
    pits = smoothstep(1.7, 2.4, spectral((size, size), seed + 4, 0.3, low=30))
    out[:] = mortar
    for course in range(courses):
        for i in range(per):
            t, shade = rng.uniform(0, 1), rng.uniform(0.82, 1.12)
            color = mix(light, dark, np.full((1, 1), t))
            y0, y1 = int(course * tall) + 5, int((course + 1) * tall) - 5
            x0 = int((i + 0.5 * (course % 2)) * wide) + 5
            columns = np.arange(x0, x0 + int(wide) - 10) % size
            block = np.ix_(np.arange(y0, y1), columns)
            edge = np.minimum.outer(_to_edge(y1 - y0), _to_edge(len(columns)))
            level = shade * skin[block] * (1 - 0.4 * pits[block]) * (1 - 0.3 * np.exp(-edge / 2.0))
            out[block] = color * level[..., None]
    return to_bytes(out)


def leather():
    """Worn leather: cells between creases; neutral, to be tinted."""
    n = 512
    rng = np.random.RandomState(191)
    y, x = np.mgrid[0:n, 0:n]
    points = rng.uniform(0, n, (1500, 2))
    first, second = np.full((n, n), 1e9), np.full((n, n), 1e9)
    for py, px in points:
        dy, dx = np.abs(y - py), np.abs(x - px)
        d = np.hypot(np.minimum(dy, n - dy), np.minimum(dx, n - dx))
        second = np.minimum(second, np.maximum(first, d))
        first = np.minimum(first, d)
    crease = np.exp(-(second - first) / 1.1)
    level = 1.0 - 0.16 * crease + 0.05 * spectral((n, n), 192, 0.5, low=30) + 0.07 * spectral((n, n), 193, 1.5)
    return tint(level, (206, 206, 206))


def tartan():
    """A woollen plaid, 0.4 m a side."""
    n = 512
    sett = [((136, 30, 34), 90), ((30, 52, 44), 60), ((18, 26, 54), 46), ((30, 52, 44), 60), ((136, 30, 34), 90),
            ((226, 214, 180), 8), ((136, 30, 34), 40), ((18, 26, 54), 64), ((214, 176, 60), 6), ((18, 26, 54), 48)]
    stripe = np.concatenate([np.tile(np.array(color, float), (width, 1)) for color, width in sett])
    stripe = np.asarray(Image.fromarray(stripe[None].astype(np.uint8)).resize((n, 1), Image.NEAREST))[0].astype(float)
    y, x = np.mgrid[0:n, 0:n]
    over = ((x + y) % 8 < 4)[..., None]
    cloth = np.where(over, stripe[None, :, :], stripe[:, None, :])
    return to_bytes(cloth * (1.0 + 0.10 * spectral((n, n), 201, 0.3, low=40))[..., None])


def rug():
    """A knotted rug of 2.9 m x 2.0 m: field with medallion, main border and guard stripes, fringes left and right."""
    width, height = 1160, 800
    y, x = np.mgrid[0:height, 0:width].astype(float)
    u, v = (x - width / 2) / 4.0, (y - height / 2) / 4.0     # in knots
    inside = np.minimum(width / 8 - np.abs(u), height / 8 - np.abs(v))
    out = np.zeros((height, width, 3))
    out[:] = (128, 34, 36)
    _field(out, u, v)
    for low, high, color in ((0, 26, (34, 40, 70)), (3, 5, (206, 178, 120)), (21, 23, (206, 178, 120)),
                             (25, 27, (206, 178, 120))):
        out[(inside >= low) & (inside < high)] = color
    _border(out, u, v, inside)
    knots = np.asarray(Image.fromarray(to_bytes(out)).resize((width // 4, height // 4),
                                                             Image.BOX).resize((width, height), Image.NEAREST))
    pile = 1.0 + 0.10 * spectral((height, width), 211, 0.2, low=60) + 0.05 * spectral((height, width), 212, 1.3,
            (4.0, 1.0))
    abrash = 1.0 + 0.05 * np.sin(v / 9.0 + 1.5 * spectral((height, width), 213, 1.8))
    rug_ = knots * (pile * abrash)[..., None]
    fringe = np.abs(u) > width / 8 - 5
    threads = tint(0.9 + 0.25 * (np.sin(2 * np.pi * y / 6.5) > -0.2), (216, 204, 174)).astype(float)
    rug_[fringe] = threads[fringe]
    return to_bytes(rug_)


def _field(out, u, v):
    """Medallion, corner pieces and strewn flowers; everything mirrored about both axes."""
    a, b = np.abs(u), np.abs(v)
    r = np.hypot(a / 1.35, b)
    angle = np.arctan2(b, a / 1.35)
    flower = np.cos(a * 0.52) * np.cos(b * 0.52) + 0.5 * np.cos(0.27 * (a + 2 * b))
    out[flower > 1.08] = (222, 192, 132)
    out[(flower > 0.92) & (flower <= 1.08)] = (40, 62, 82)
    petal = 1 + 0.10 * np.cos(8 * angle)
    for radius, color in ((52, (34, 40, 70)), (48, (206, 178, 120)), (46, (34, 40, 70)), (32, (176, 92, 60)),
                          (29, (222, 204, 160)),
                          (20, (128, 34, 36)), (12, (40, 62, 82)), (6, (222, 192, 132))):
        out[r * petal < radius] = color
    dots = (np.cos(16 * angle) > 0.6) & (np.abs(r * petal - 39) < 3.0)
    out[dots] = (222, 192, 132)
    corner = np.hypot((118 - a) / 1.2, 73 - b) * (1 + 0.08 * np.cos(10 * np.arctan2(73 - b, 118 - a)))
    out[corner < 44] = (40, 62, 82)
    out[(corner < 44) & (corner > 40)] = (206, 178, 120)
    out[(corner < 38) & (np.cos(a * 0.8) * np.cos(b * 0.8) > 0.55)] = (196, 120, 76)


def _border(out, u, v, inside):
    """Rosettes alternating with bars in the main border, which runs along the nearer edge."""
    half_u, half_v = out.shape[1] / 8, out.shape[0] / 8
    along = np.where(half_u - np.abs(u) < half_v - np.abs(v), v, u)
    across = inside - 13.0
    s = (np.abs(along) + 9) % 18 - 9
    d = np.hypot(s, across)
    main = (inside >= 5) & (inside < 21)
    out[main & (d < 6.5)] = (178, 60, 46)
    out[main & (d < 3.6)] = (222, 192, 132)
    out[main & (d < 1.8)] = (34, 40, 70)
    out[main & (np.abs(np.abs(s) - 9) < 1.3) & (np.abs(across) < 6)] = (112, 140, 120)
    guard = ((inside >= 5) & (inside < 6)) | ((inside >= 23) & (inside < 25))
    out[guard & (np.abs(along) % 6 < 3)] = (178, 60, 46)


def kilim():
    """A flat-woven cushion cover: rows of stepped lozenges."""
    n, step = 480, 6
    y, x = np.mgrid[0:n, 0:n] // step
    colors = np.array(((196, 156, 84), (150, 52, 40), (36, 62, 84), (224, 208, 176), (70, 96, 84)), float)
    band = y // 20
    d = np.abs((x + 10 * (band % 2)) % 20 - 10) + np.abs(y % 20 - 10)
    index = np.where(d < 3, 3, np.where(d < 6, 1, np.where(d < 8, 0, np.where(band % 2 == 0, 2, 4))))
    index = np.where(y % 20 == 0, 3, index)
    thread = 1.0 + 0.10 * spectral((n, n), 221, 0.3, (1.0, 3.0), low=50) + 0.05 * spectral((n, n), 222, 1.3)
    return to_bytes(colors[index] * thread[..., None])


def linen():
    """Curtain cloth of 0.8 m a side: woven stripes and sprigs on a light ground."""
    n = 512
    y, x = np.mgrid[0:n, 0:n].astype(float)
    level = 1.0 + 0.06 * spectral((n, n), 231, 0.3, (3.0, 1.0), low=40) + 0.05 * spectral((n, n), 232, 0.3,
            (1.0, 3.0), low=40)
    rgb = tint(level, (222, 210, 184)).astype(float)
    for center, wide, color in ((64, 20, (150, 84, 64)), (92, 4, (150, 84, 64)), (36, 4, (150, 84, 64)),
                                (320, 10, (92, 112, 104))):
        rgb = mix(rgb, color, 0.8 * (np.abs(x - center) < wide))
    sprig = np.hypot((x - 200) / 1.0, (y % 128 - 64) / 2.2)
    rgb = mix(rgb, (92, 112, 104), 0.85 * (sprig < 11) + 0.85 * (np.hypot((x - 440) / 1.6, (y + 64) % 128 - 64) < 10))
    return to_bytes(rgb * level[..., None])


HOME = {
    "parquet": parquet,
    "plaster": plaster,
    "wallpaper": wallpaper,
    "brick": brick,
    "leather": leather,
    "tartan": tartan,
    "rug": rug,
    "kilim": kilim,
    "linen": linen,
}
