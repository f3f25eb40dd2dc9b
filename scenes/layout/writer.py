# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Collects the parts of a scene and writes them as a scene file."""

import math

from catalogue import find


def _number(x):
    return f"{round(float(x), 5):g}" if x else "0"


def _value(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, dict):
        return "{ " + ", ".join(f'"{k}" = {_value(v)}' for k, v in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_number(v) for v in value) + "]"
    return _number(value)


class Place:
    """A frame on the floor plan: origin and turn about z. Local -y is the front."""

    def __init__(self, x, y, z=0.0, yaw_deg=0.0):
        self.x, self.y, self.z, self.yaw_deg = x, y, z, yaw_deg

    def point(self, x, y, z=0.0):
        vx, vy, _ = self.vector(x, y)
        return (self.x + vx, self.y + vy, self.z + z)

    def vector(self, x, y, z=0.0):
        c, s = math.cos(math.radians(self.yaw_deg)), math.sin(math.radians(self.yaw_deg))
        return (c * x - s * y, s * x + c * y, z)

    def child(self, x, y, z=0.0, yaw_deg=0.0):
        return Place(*self.point(x, y, z), self.yaw_deg + yaw_deg)


def walls(wide, deep):
    """North, south, east and west wall of a room as seen from inside: local x runs right, -y into the room."""
    return Place(0, deep), Place(wide, 0, 0, 180), Place(wide, deep, 0, -90), Place(0, 0, 0, 90)


class SceneWriter:
    def __init__(self, lift=0.0):
        self.lift = lift
        self.parts = []
        self.used = set()  # the keys of the catalogue's models
        self.meshes = {}   # file -> Mesh, our own

    def table(self, kind, comment=None, **keys):
        for key in ("at", "corner", "center"):
            if self.lift and key in keys:
                x, y, z = keys[key]
                keys[key] = (x, y, z + self.lift)
        self.parts.append((kind, comment, {k: v for k, v in keys.items() if v is not None}))

    def box(self, name, material, size, place, at=(0, 0, 0), yaw_deg=0.0, faces=None):
        self.table("box", name=name, material=material, faces=faces, size=size,
                   at=place.point(*at), yaw_deg=(place.yaw_deg + yaw_deg) or None)

    def quad(self, name, material, place, corner, u, v):
        self.table("quad", name=name, material=material, corner=place.point(*corner),
                   u=place.vector(*u), v=place.vector(*v))

    def sheet(self, name, material, size, place, at, yaw_deg=0.0):
        """A picture that lies face up, its centre at `at`."""
        turned = place.child(*at, yaw_deg)
        w, h = size
        self.quad(name, material, turned, (-w / 2, -h / 2, 0), (w, 0, 0), (0, h, 0))

    def hung(self, name, material, size, place, at):
        """A picture that faces local -y, the middle of its lower edge at `at`."""
        x, y, z = at
        self.quad(name, material, place, (x - size[0] / 2, y, z), (size[0], 0, 0), (0, 0, size[1]))

    def cylinder(self, name, material, radius, height, place, at=(0, 0, 0), segments=32):
        self.table("cylinder", name=name, material=material, at=place.point(*at), radius=radius,
                   height=height, segments=segments)

    def sphere(self, name, material, radius, place, at, segments=32):
        self.table("sphere", name=name, material=material, center=place.point(*at), radius=radius,
                   segments=segments)

    def model(self, name, key, place, at=(0, 0, 0), yaw_deg=0.0, size=None, materials=None):
        model = find(key)
        self.used.add(key)
        self.table("model", name=name, archive=model.archive, file=model.path, size=size or model.size,
                   rotation=model.rotation, at=place.point(*at),
                   yaw_deg=(place.yaw_deg + yaw_deg) or None, materials=materials)

    def mesh(self, name, mesh, place, materials, file=None, at=(0, 0, 0), yaw_deg=0.0, **keys):
        """A mesh of our own, its origin at `at`; kept as `file`.obj beside the scene."""
        file = f"{file or name}.obj".replace(" ", "_")
        self.meshes[file] = mesh
        (x0, x1), (y0, y1), (z0, _) = mesh.bounds()
        base = place.child(*at, yaw_deg)
        self.table("model", name=name, file=file, up="z", at=base.point((x0 + x1) / 2, (y0 + y1) / 2, z0),
                   yaw_deg=base.yaw_deg or None, materials=materials, **keys)

    def text(self):
        lines = []
        for kind, comment, keys in self.parts:
            if comment:
                lines.append(f"\n# {comment}")
            lines.append(f"\n[[{kind}]]")
            lines.extend(f"{key} = {_value(value)}" for key, value in keys.items())
        return "\n".join(lines) + "\n"
