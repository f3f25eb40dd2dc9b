# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Periodic noise and small helpers of colour on which the textures are built."""

import numpy as np


def spectral(shape, seed, beta, stretch=(1.0, 1.0), low=0.0, high=1e9):
    """Periodic Gaussian noise with amplitude ~ 1/f^beta between two frequencies (cycles per image).

    stretch lengthens the features along (y, x). Mean 0, standard deviation 1.
    """
    height, width = shape
    rng = np.random.RandomState(seed)
    fy = np.fft.fftfreq(height)[:, None] * height * stretch[0]
    fx = np.fft.fftfreq(width)[None, :] * width * stretch[1]
    f = np.hypot(fy, fx)
    f[0, 0] = 1.0
    gain = f**-beta * (f >= low) * (f <= high)
    gain[0, 0] = 0.0
    field = np.fft.ifft2(np.fft.fft2(rng.standard_normal(shape)) * gain).real
    return field / field.std()


def relief(height_field, strength):
    """Lambertian shading of a height field lit from the upper left, around 1."""
    dy = np.roll(height_field, -1, 0) - np.roll(height_field, 1, 0)
    dx = np.roll(height_field, -1, 1) - np.roll(height_field, 1, 1)
    return 1.0 + strength * (dx + dy)


def smoothstep(low, high, x):
    t = np.clip((x - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def tint(level, color):
    """A gray field (1 = the colour itself) times an sRGB colour 0..255 -> uint8 RGB."""
    return to_bytes(level[..., None] * np.asarray(color, float)[None, None, :])


def mix(a, b, t):
    """Per-pixel blend of two sRGB colours or images."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    return a + (b - a) * t[..., None]


def to_bytes(rgb):
    return np.clip(np.rint(rgb), 0, 255).astype(np.uint8)
