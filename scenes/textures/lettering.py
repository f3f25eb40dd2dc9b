# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Fonts and sentences for everything printed in the scenes."""

import functools
import random

from PIL import ImageFont

_FOLDER = "/usr/share/fonts/truetype/dejavu/"
_FILES = {
    "sans": "DejaVuSans.ttf",
    "bold": "DejaVuSans-Bold.ttf",
    "mono": "DejaVuSansMono.ttf",
    "mono-bold": "DejaVuSansMono-Bold.ttf",
    "serif": "DejaVuSerif.ttf",
    "serif-bold": "DejaVuSerif-Bold.ttf",
}

_SUBJECTS = ("The camera", "A keyframe", "Each residual", "The warp", "Our estimate", "The depth map",
             "Every pixel", "This interpolant", "The pyramid", "A patch", "The sensor", "Noise")
_VERBS = ("is aligned with", "depends on", "converges to", "is compared with", "explains", "follows",
          "is sampled from", "constrains", "is reprojected into", "limits", "reveals", "improves")
_OBJECTS = ("the reference frame", "a small rotation", "the image gradient", "its neighbours",
            "the exposure time", "six degrees of freedom", "the inverse depth", "a coarse level",
            "the nearest surface", "the rolling shutter", "a robust weight", "the epipolar line")
_TAILS = ("when motion is slow.", "in every iteration.", "at sixty frames a second.",
          "as Table 2 shows.", "without any marker.", "under constant light.",
          "up to a scale.", "and stops early.", "on four levels.", "in closed form.")


@functools.lru_cache(maxsize=None)
def font(face, size):
    return ImageFont.truetype(_FOLDER + _FILES[face], size)


def sentences(seed):
    """An endless stream of plausible sentences."""
    rng = random.Random(seed)
    while True:
        yield " ".join(rng.choice(part) for part in (_SUBJECTS, _VERBS, _OBJECTS, _TAILS))


def words(seed):
    for sentence in sentences(seed):
        yield from sentence.split()


def paragraph(draw, box, seed, face="serif", size=9, fill=(40, 40, 44), leading=1.32):
    """Sets justified-left text into box = (left, top, right, bottom)."""
    left, top, right, bottom = box
    stream, type_ = words(seed), font(face, size)
    line, y = "", top
    rng = random.Random(seed + 1)
    while y + size <= bottom:
        word = next(stream)
        candidate = f"{line} {word}".strip()
        if draw.textlength(candidate, font=type_) > right - left:
            draw.text((left, y), line, font=type_, fill=fill)
            y += size * leading
            line = word
            if rng.random() < 0.09:
                y += size * 0.6
        else:
            line = candidate
