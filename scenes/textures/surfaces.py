# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Tiling building materials: what rooms and furniture are made of. All repeat without a seam."""

import numpy as np

from noise import mix, relief, smoothstep, spectral, tint, to_bytes


def carpet():
    """Four loop-pile carpet tiles of 0.5 m, laid quarter-turned, 1 m a side."""
    size, half = 1024, 512
    out = np.zeros((size, size, 3))
    for row in range(2):
        for col in range(2):
            seed = 10 + 2 * row + col
            along = (1.0, 0.16) if (row + col) % 2 else (0.16, 1.0)
            streaks = spectral((half, half), seed, 1.0, along)
            loops = spectral((half, half), seed + 40, 0.2, low=60, high=200)
            blotch = spectral((half, half), seed + 80, 1.6)
            fleck = spectral((half, half), seed + 120, 0.5, low=10, high=90)
            level = 1.0 + 0.085 * streaks + 0.11 * loops + 0.05 * blotch + 0.02 * ((row + col) % 2)
            base = tint(level, (92, 99, 110)).astype(float)
            base = mix(base, (150, 158, 166), 0.75 * smoothstep(1.35, 2.2, fleck))
            base = mix(base, (46, 60, 92), 0.7 * smoothstep(1.2, 2.0, -fleck))
            edge = np.minimum.outer(_to_edge(half), _to_edge(half))
            base *= (1.0 - 0.35 * np.exp(-edge / 1.6))[..., None]
            out[row * half:(row + 1) * half, col * half:(col + 1) * half] = base
    return to_bytes(out)


def _to_edge(n):
    i = np.arange(n)
    return np.minimum(i, n - 1 - i).astype(float)


def woodchip():
    """Painted woodchip wallpaper, 1.5 m a side: chips, roller nap, patchy paint and faint scuffs."""
    shape = (1024, 1024)
    chips = smoothstep(1.1, 2.0, spectral(shape, 21, 0.3, (0.55, 1.0), 20, 110))
    grains = smoothstep(1.3, 2.2, spectral(shape, 22, 0.2, low=60, high=220))
    nap = spectral(shape, 23, 0.4, low=90, high=400)
    height = 2.2 * chips + 0.9 * grains + 0.10 * nap
    level = relief(height, 0.105)
    level += 0.014 * spectral(shape, 24, 1.5) + 0.010 * spectral(shape, 25, 1.0, low=3, high=30)
    scuffs = smoothstep(2.1, 3.0, spectral(shape, 26, 0.8, (1.0, 0.25), 4, 80))
    return tint(level - 0.05 * scuffs, (226, 224, 217))


def ceiling():
    """Mineral-fibre ceiling, 2 x 2 tiles of 0.6 m in a white grid."""
    size, half = 1024, 512
    level = np.ones((size, size))
    fissures = spectral((size, size), 31, 0.5, (0.5, 1.0), 20, 120)
    pinholes = spectral((size, size), 32, 0.0, low=80, high=240)
    level -= 0.30 * smoothstep(1.5, 2.3, fissures) + 0.22 * smoothstep(1.9, 2.6, pinholes)
    level += 0.012 * spectral((size, size), 33, 1.4)
    for row in range(2):
        for col in range(2):
            level[row * half:(row + 1) * half, col * half:(col + 1) * half] += \
                0.02 * (((row * 2 + col) * 7) % 4 - 1.5)
    edge = np.minimum.outer(_to_edge(half), _to_edge(half))
    edge = np.tile(edge, (2, 2))
    level = np.where(edge < 9, 1.04 + 0.004 * spectral((size, size), 34, 1.0), level)
    level = np.where((edge >= 9) & (edge < 12), 0.72, level)
    return tint(level, (221, 220, 214))


def wood(seed, light, dark, size=(1024, 512), rings=9):
    """Veneer with the grain along x."""
    warp = spectral((size[1], size[0]), seed, 1.7, (1.0, 7.0))
    y = np.arange(size[1])[:, None] / size[1]
    ring = 0.5 + 0.5 * np.sin(2 * np.pi * (rings * y + 0.8 * warp))
    fibre = spectral((size[1], size[0]), seed + 1, 0.35, (1.0, 22.0), low=30)
    pores = smoothstep(1.4, 2.4, spectral((size[1], size[0]), seed + 2, 0.2, (1.0, 14.0), low=60))
    cloud = spectral((size[1], size[0]), seed + 3, 1.6, (1.0, 2.0))
    t = np.clip(0.25 + 0.45 * ring**1.6 + 0.09 * fibre + 0.07 * cloud + 0.28 * pores, 0, 1)
    return to_bytes(mix(light, dark, t))


def fabric():
    """Coarse woven cloth, neutral, to be tinted by the material's colour."""
    n = 512
    y, x = np.mgrid[0:n, 0:n]
    period = 8
    warp_over = ((x // period) + (y // period)) % 2 == 0
    u = np.where(warp_over, x, y) % period / period
    thread = 0.72 + 0.28 * np.sin(np.pi * (u + 0.5 / period))
    irregular = np.where(warp_over, spectral((n, n), 41, 0.6, (4.0, 1.0)),
                         spectral((n, n), 42, 0.6, (1.0, 4.0)))
    level = thread * (1.0 + 0.07 * irregular) + 0.03 * spectral((n, n), 43, 1.2)
    return tint(level, (226, 226, 226))


def cork(shape=(512, 512), seed=51):
    """Granulated cork."""
    grains = spectral(shape, seed, 0.4, low=25, high=140)
    coarse = spectral(shape, seed + 1, 0.8, low=8, high=60)
    base = mix((203, 158, 104), (160, 112, 66), smoothstep(-1.5, 1.5, grains))
    base = mix(base, (102, 66, 38), 0.8 * smoothstep(1.5, 2.3, coarse))
    base = mix(base, (224, 188, 138), 0.7 * smoothstep(1.4, 2.2, -coarse))
    return to_bytes(base)


def cardboard():
    """Kraft board with its fluting faintly visible."""
    n = 512
    x = np.arange(n)[None, :]
    level = 1.0 + 0.014 * np.sin(2 * np.pi * 64 * x / n) + 0.03 * spectral((n, n), 61, 1.1)
    level = level + 0.03 * spectral((n, n), 62, 0.4, (1.0, 5.0), low=20)
    specks = smoothstep(2.4, 3.0, spectral((n, n), 63, 0.1, low=40))
    return tint(level - 0.18 * specks, (186, 148, 104))


def plastic():
    """Fine-grained moulded plastic or powder-coated metal with wear; neutral, to be tinted."""
    n = 512
    level = 1.0 + 0.035 * spectral((n, n), 71, 0.2, low=60) + 0.014 * spectral((n, n), 72, 1.4)
    wear = smoothstep(1.7, 2.6, spectral((n, n), 73, 0.9, (1.0, 3.0), low=3))
    return tint(level + 0.07 * wear, (215, 215, 215))


def concrete():
    """Sill and reveal stone: light terrazzo."""
    shape = (512, 512)
    chips = spectral(shape, 81, 0.6, low=14, high=70)
    small = spectral(shape, 82, 0.3, low=50, high=160)
    base = mix((206, 203, 196), (146, 141, 134), smoothstep(1.1, 1.35, chips))
    base = mix(base, (232, 229, 222), smoothstep(1.2, 1.5, -chips))
    base = mix(base, (112, 108, 104), 0.8 * smoothstep(1.8, 2.1, small))
    return to_bytes(base * (1.0 + 0.015 * spectral(shape, 83, 1.3))[..., None])


def marble():
    """Veined stone, used in the studio."""
    shape = (512, 512)
    vein = np.abs(spectral(shape, 91, 1.5))
    fine = np.abs(spectral(shape, 92, 1.1, low=4))
    base = mix((70, 84, 92), (214, 218, 212), np.exp(-9.0 * vein))
    base = mix(base, (182, 150, 110), 0.7 * np.exp(-12.0 * fine))
    return to_bytes(base * (1.0 + 0.04 * spectral(shape, 93, 0.5, low=20))[..., None])


SURFACES = {
    "carpet": carpet,
    "woodchip": woodchip,
    "ceiling": ceiling,
    "oak": lambda: wood(101, (214, 178, 128), (150, 104, 60)),
    "oak_upright": lambda: wood(101, (214, 178, 128), (150, 104, 60)).transpose(1, 0, 2),
    "walnut": lambda: wood(111, (128, 88, 58), (62, 38, 24), rings=7),
    "walnut_upright": lambda: wood(111, (128, 88, 58), (62, 38, 24), rings=7).transpose(1, 0, 2),
    "beech": lambda: wood(121, (226, 196, 154), (190, 146, 98), rings=12),
    "beech_upright": lambda: wood(121, (226, 196, 154), (190, 146, 98), rings=12).transpose(1, 0, 2),
    "fabric": fabric,
    "cork": cork,
    "cardboard": cardboard,
    "plastic": plastic,
    "terrazzo": concrete,
    "marble": marble,
}
