# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""What monitors show, the keyboard before them, and the town outside the window."""

import random

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

from lettering import font, paragraph
from noise import mix, smoothstep, spectral, to_bytes
from paper import plot
from wall import map_poster, mountains

_CODE = """// Levenberg-Marquardt on SE(3), coarse to fine
SE3d Align(const Pyramid& ref, const Pyramid& cur,
           SE3d current_from_keyframe) {
  for (int level = kLevels - 1; level >= 0; --level) {
    double alpha = 1e-3;
    auto sums = Reduce(ref[level], cur[level],
                       current_from_keyframe);
    for (int i = 0; i < kIterations[level]; ++i) {
      const Mat6d h = sums.jtj + alpha * Mat6d::Identity();
      const Vec6d step = -h.ldlt().solve(sums.jtr);
      const SE3d trial = SE3d::Exp(step) * current_from_keyframe;
      const auto next = Reduce(ref[level], cur[level], trial);
      if (next.cost < sums.cost) {
        current_from_keyframe = trial;
        sums = next;
        alpha /= 10;
      } else {
        alpha *= 10;
      }
      if (step.norm() < kSmallest) break;
    }
  }
  return current_from_keyframe;
}

TEST(Align, RecoversASmallMotion) {
  const Scene scene = Plane(2.0);
  for (int axis = 0; axis < 6; ++axis) {
    const SE3d truth = Perturb(axis, 0.01);
    EXPECT_LT(Error(Align(scene, truth), truth), 1e-4);
  }
}
""".splitlines()

_KEYWORDS = {"for", "const", "int", "double", "auto", "if", "else", "return", "break", "TEST"}


def code_screen():
    """A code editor with a file tree, line numbers and a terminal."""
    image = Image.new("RGB", (1024, 600), (30, 32, 40))
    draw = ImageDraw.Draw(image)
    draw.rectangle((0, 0, 1024, 26), fill=(52, 54, 64))
    draw.rectangle((170, 0, 330, 26), fill=(30, 32, 40))
    draw.text((184, 5), "alignment.cpp", font=font("sans", 13), fill=(230, 230, 236))
    draw.text((350, 5), "pyramid.h     se3.h", font=font("sans", 13), fill=(160, 164, 172))
    draw.rectangle((0, 26, 166, 600), fill=(40, 42, 52))
    for i in range(30):
        text = ("core", "  camera.h", "  frame.h", "  se3.h", "tracker", "  align.cpp", "  kernel", "sim")[i % 8]
        draw.text((10, 36 + 18 * i), text, font=font("sans", 13), fill=(170, 176, 190))
    y = 34
    for number, line in enumerate(_CODE):
        draw.text((178, y), f"{number + 11:3d}", font=font("mono", 12), fill=(100, 104, 116))
        x = 214.0
        for token in line.replace(" ", "\u00a0 ").split(" "):
            color = (206, 210, 220)
            bare = token.strip("\u00a0(){};,")
            if line.strip().startswith("//"):
                color = (110, 160, 110)
            elif bare in _KEYWORDS:
                color = (214, 130, 200)
            elif bare[:1].isdigit() or bare.startswith("k"):
                color = (226, 180, 110)
            elif bare[:1].isupper():
                color = (110, 190, 220)
            draw.text((x, y), token, font=font("mono", 13), fill=color)
            x += draw.textlength(token, font=font("mono", 13))
        y += 13.6
    draw.rectangle((170, 486, 1024, 600), fill=(16, 17, 22))
    for i, text in enumerate(("$ ctest --output-on-failure", "100% tests passed, 0 tests failed out of 212",
                              "$ silt track --scene office --trajectory desk",
                              "frame 0412  keyframes 31  inliers 284  8.1 ms",
                              "frame 0413  keyframes 31  inliers 279  8.3 ms", "frame 0414 ▏")):
        draw.text((180, 492 + 17 * i), text, font=font("mono", 13), fill=(150, 220, 150) if i != 1 else (240, 220, 120))
    rng = random.Random(3)
    for i in range(120):
        x = 950 + rng.randint(0, 16)
        draw.line((x, 34 + 3.6 * i, x + rng.randint(4, 44), 34 + 3.6 * i), fill=(90, 110, 130), width=2)
    return image


def plot_screen():
    """A desktop with plots, a map window and a text window."""
    image = mountains().crop((50, 50, 850, 610)).resize((1024, 600), Image.LANCZOS)
    draw = ImageDraw.Draw(image)
    _window(draw, (36, 30, 560, 372), "error.svg")
    for i in range(4):
        left, top = 80 + 250 * (i % 2), 86 + 150 * (i // 2)
        plot(draw, (left, top, left + 200, top + 100), 30 + 4 * i, f"run {i + 1}")
    _window(draw, (590, 60, 996, 396), "trajectory")
    image.paste(map_poster().resize((400, 308), Image.LANCZOS), (593, 86))
    _window(draw, (200, 330, 700, 572), "notes.txt")
    paragraph(draw, (214, 364, 690, 566), 71, "mono", 13, (30, 32, 40), 1.3)
    draw.rectangle((0, 576, 1024, 600), fill=(34, 40, 56))
    for i in range(9):
        draw.rounded_rectangle((12 + 34 * i, 579, 34 + 34 * i, 597), 4,
                               fill=((220, 90, 70), (90, 160, 220), (240, 190, 80), (110, 190, 120))[i % 4])
    draw.text((948, 579), "10:08", font=font("sans", 16), fill=(240, 240, 244))
    return image


def _window(draw, box, title):
    left, top, right, bottom = box
    draw.rectangle((left + 6, top + 8, right + 6, bottom + 8), fill=(26, 30, 44))
    draw.rectangle(box, fill=(248, 248, 250), outline=(70, 74, 84))
    draw.rectangle((left, top, right, top + 24), fill=(214, 218, 226))
    draw.text((left + 10, top + 4), title, font=font("bold", 13), fill=(40, 44, 54))
    for i, color in enumerate(((236, 100, 90), (240, 190, 80), (110, 200, 110))):
        draw.ellipse((right - 20 - 18 * i, top + 6, right - 8 - 18 * i, top + 18), fill=color)


def keyboard():
    """A dark keyboard from above, five rows and a number pad."""
    image = Image.new("RGB", (1024, 340), (36, 38, 42))
    draw = ImageDraw.Draw(image)
    rows = ("^1234567890ß´", "QWERTZUIOPÜ+", "ASDFGHJKLÖÄ#", "<YXCVBNM,.-")
    for i in range(16):
        _key(draw, 20 + 46.5 * i, 18, 40, 34, ("Esc" if i == 0 else f"F{i}") if i < 13 else "•")
    for row, letters in enumerate(rows):
        for i, letter in enumerate(letters):
            _key(draw, 20 + 26 * row + 50 * i, 70 + 50 * row, 44, 44, letter)
    for left, width, label in ((20, 64, "Ctrl"), (90, 50, "Alt"), (146, 310, ""), (462, 60, "Gr"),
                               (528, 64, "Ctrl")):
        _key(draw, left, 272, width, 46, label)
    _key(draw, 672, 70, 74, 44, "←")
    _key(draw, 648, 170, 98, 44, "↵")
    for i, label in enumerate("←↓→"):
        _key(draw, 640 + 40 * i, 280, 34, 38, label)
    for row in range(5):
        for col in range(4):
            _key(draw, 796 + 52 * col, 70 + 50 * row, 46, 44, "789/456*123-0.=+NL()"[row * 4 + col])
    return image.filter(ImageFilter.GaussianBlur(0.5))


def _key(draw, left, top, width, height, label):
    draw.rounded_rectangle((left, top + 3, left + width, top + height + 3), 6, fill=(14, 15, 17))
    draw.rounded_rectangle((left, top, left + width, top + height), 6, fill=(62, 65, 71))
    draw.rounded_rectangle((left + 4, top + 2, left + width - 4, top + height - 7), 5, fill=(82, 86, 93))
    draw.text((left + 8, top + 3), label, font=font("bold", 17), fill=(226, 228, 232))


def window_view():
    """A quiet town in the morning: sky, hills, facades, trees."""
    height, width = 768, 1024
    y = np.linspace(0, 1, height)[:, None] * np.ones((1, width))
    sky = mix((126, 168, 222), (222, 232, 240), smoothstep(0.0, 0.6, y))
    cloud = spectral((height, width), 1301, 1.5, (1.0, 3.0))
    sky = mix(sky, (252, 252, 252), 0.85 * smoothstep(0.2, 1.9, cloud) * smoothstep(0.62, 0.3, y))
    rows = np.arange(height)[:, None]
    for i in range(3):
        top = height * (0.46 + 0.05 * i) + (40 - 8 * i) * spectral((1, width), 1310 + i, 1.75)[0]
        color = np.array(((150, 172, 190), (120, 150, 140), (92, 124, 88))[i])
        field = color * (1 + 0.12 * spectral((height, width), 1320 + i, 0.8, low=12))[..., None]
        sky = mix(sky, field, smoothstep(0, 2, rows - top[None, :]))
    image = Image.fromarray(to_bytes(sky))
    _houses(image)
    _trees(image)
    return image


def _houses(image):
    draw, rng = ImageDraw.Draw(image), random.Random(8)
    x = -30
    while x < 1024:
        width, floors = rng.randint(90, 170), rng.randint(3, 6)
        top = 700 - floors * 52
        wall = ((206, 180, 148), (190, 120, 96), (222, 212, 196), (168, 160, 150), (214, 196, 130))[rng.randint(0, 4)]
        draw.rectangle((x, top, x + width, 768), fill=wall)
        draw.polygon([(x - 6, top), (x + width + 6, top), (x + width - 16, top - 46), (x + 16, top - 46)],
                     fill=((140, 66, 50), (92, 84, 84), (118, 74, 58))[rng.randint(0, 2)])
        for k in range(6):
            draw.line((x - 2 + k * 3, top - 8 * k, x + width + 2 - 3 * k, top - 8 * k), fill=(74, 50, 44))
        for floor in range(floors):
            for column in range(width // 30):
                a, b = x + 10 + 30 * column, top + 12 + 52 * floor
                draw.rectangle((a - 2, b - 2, a + 18, b + 30), fill=(240, 238, 232))
                shade = rng.randint(50, 130)
                draw.rectangle((a, b, a + 16, b + 28), fill=(shade, shade + 14, shade + 26))
                draw.line((a + 8, b, a + 8, b + 28), fill=(240, 238, 232), width=2)
        x += width + rng.choice((0, 0, 14))


def _trees(image):
    pixels = np.asarray(image).astype(float)
    height, width = pixels.shape[:2]
    leaf = spectral((height, width), 1341, 0.5, low=18)
    crown = spectral((height, width), 1342, 1.5, low=2)
    rows = np.linspace(0, 1, height)[:, None]
    mask = smoothstep(0.1, 0.35, crown + 0.35 * leaf + 9.0 * (rows - 0.9))
    color = mix((44, 78, 38), (136, 164, 80), smoothstep(-1.2, 1.6, leaf + 0.5 * crown))
    image.paste(Image.fromarray(to_bytes(mix(pixels, color, mask))))


SCREENS = {
    "screen_code": code_screen,
    "screen_plots": plot_screen,
    "keyboard": keyboard,
    "window_view": window_view,
}
