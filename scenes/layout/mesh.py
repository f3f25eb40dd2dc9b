# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Shapes that boxes cannot make, as OBJ files beside the scene: z up, metres, at their place in the model's frame."""

import math


class Mesh:
    """Triangles and quads by material, with picture coordinates."""

    def __init__(self):
        self.points, self.uvs, self.faces = [], [], []  # a face: material, [(point, uv), …], both from 1

    def face(self, material, corners, uvs=None):
        """A polygon, anticlockwise from its front; corners are (x, y, z), uvs (u, v) of each."""
        first = len(self.points) + 1
        self.points += corners
        self.uvs += uvs or [(0.0, 0.0)] * len(corners)
        self.faces.append((material, range(first, first + len(corners))))

    def grid(self, material, at, columns, rows):
        """The surface at(u, v), u and v in 0..1, as columns × rows quads that share their corners."""
        first = len(self.points) + 1
        for j in range(rows + 1):
            for i in range(columns + 1):
                u, v = i / columns, j / rows
                self.points.append(at(u, v))
                self.uvs.append((u, v))
        for j in range(rows):
            for i in range(columns):
                a = first + j * (columns + 1) + i
                self.faces.append((material, (a, a + 1, a + columns + 2, a + columns + 1)))

    def tube(self, material, path, radius, sides=12):
        """A round bar along straight stretches between the points of `path`, closed at both ends."""
        rings = [_ring(path, i, radius, sides) for i in range(len(path))]
        for low, high in zip(rings, rings[1:]):
            for k in range(sides):
                m = (k + 1) % sides
                self.face(material, [low[m], low[k], high[k], high[m]])
        self.face(material, rings[0])
        self.face(material, rings[-1][::-1])

    def bounds(self):
        return [(min(p[k] for p in self.points), max(p[k] for p in self.points)) for k in range(3)]

    def text(self):
        lines = ["# Written by make_scene.py"]
        lines += ["v " + " ".join(f"{round(c, 5):g}" for c in p) for p in self.points]
        lines += ["vt " + " ".join(f"{round(c, 5):g}" for c in t) for t in self.uvs]
        current = None
        for material, corners in self.faces:
            if material != current:
                lines.append(f"usemtl {material}")
                current = material
            lines.append("f " + " ".join(f"{c}/{c}" for c in corners))
        return "\n".join(lines) + "\n"


def _ring(path, i, radius, sides):
    """The circle at path[i], in the plane that halves the bend there."""
    before, after = path[max(i - 1, 0)], path[min(i + 1, len(path) - 1)]
    along = _unit([b - a for a, b in zip(before, after)])
    side = _unit(_cross(along, (0, 0, 1) if abs(along[2]) < 0.95 else (1, 0, 0)))
    up = _cross(side, along)
    if 0 < i < len(path) - 1:       # keep the bar's thickness where it bends
        leg = _unit([b - a for a, b in zip(before, path[i])])
        stretch = 1 / max(0.5, sum(a * b for a, b in zip(leg, along)))
    else:
        stretch = 1.0
    angles = [2 * math.pi * k / sides for k in range(sides)]
    return [tuple(p + radius * (math.cos(a) * s + math.sin(a) * stretch * u) for p, s, u in zip(path[i], side, up))
            for a in angles]


def _unit(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v)


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def cushion(width=0.45, thick=0.16):
    """A plump square cushion standing on an edge, its face to -y; material "cover"."""
    mesh = Mesh()
    for side in (-1, 1):
        def at(u, v, side=side):
            x, z = 2 * u - 1, 2 * v - 1
            bulge = ((1 - abs(x) ** 2.2) * (1 - abs(z) ** 2.2)) ** 0.55
            pull = 1 - 0.07 * (1 - x * x if abs(z) > abs(x) else 1 - z * z)
            return (-side * x * pull * width / 2, side * thick / 2 * bulge, z * pull * width / 2)
        mesh.grid("cover", at, 16, 16)
    return mesh
