# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
"""Flights of ten steps, their handrails and balusters, as meshes in world coordinates."""

from hall import LANDING_X, LOW, NORTH_Y, SOUTH_Y, STOREY, TURN_X, WEST_X
from mesh import Mesh
from writer import Place

STEPS = 10
RISE, GOING = STOREY / 2 / STEPS, (LANDING_X - TURN_X) / STEPS
THICK = 0.17                              # of the slab under the steps, upright
SOUTH_HALF, NORTH_HALF = (SOUTH_Y, 1.05), (1.35, NORTH_Y)
RAIL = 0.9                                # of the handrail above the noses of the steps
ORIGIN = Place(0, 0)


class Flight:
    """Ten steps from the edge at x = start, height z, towards `way` (-1: west); y from … to."""

    def __init__(self, start, z, way, half):
        self.start, self.z, self.way, (self.y0, self.y1) = start, z, way, half

    def x(self, i):
        return self.start + self.way * GOING * i

    def tread(self, i):
        return self.z + RISE * (i + 1)

    def nose_line(self, x):
        """Height of the line through the noses."""
        return self.z + RISE + (x - self.start) * self.way * RISE / GOING


def add_stairs(scene):
    half = STOREY / 2
    flights = {}
    for i, z in enumerate((-STOREY, 0, STOREY)):
        flights[f"north {i}"] = Flight(LANDING_X, z, -1, NORTH_HALF)
        flights[f"south {i}"] = Flight(TURN_X, z + half, 1, SOUTH_HALF)
    del flights["south 2"]                # it would end above the ceiling
    materials = {name: name for name in ("tread", "riser", "soffit")}
    for name, flight in flights.items():
        scene.mesh(f"flight {name}", _flight(flight), ORIGIN, materials, f"flight_{name.replace(' ', '_')}")
        _strips(scene, name, flight)
        _balusters(scene, name, flight)
    scene.mesh("handrails", _handrails(flights), ORIGIN, {"wood": "handrail", "iron": "iron"})
    scene.mesh("hall dado", _dado(flights), ORIGIN, {"dado": "hall dado", "band": "tile band"}, "dado")


def _flight(f):
    mesh = Mesh()

    def face(material, corners):    # anticlockwise from outside for a flight to the east
        mesh.face(material, corners if f.way > 0 else corners[::-1])

    def under(i):
        return max(f.nose_line(f.x(i)) - RISE - THICK, LOW)     # the lowest flight ends on the floor

    for i in range(STEPS):
        a, b, low, high = f.x(i), f.x(i + 1), f.tread(i) - RISE, f.tread(i)
        face("riser", [(a, f.y0, low), (a, f.y0, high), (a, f.y1, high), (a, f.y1, low)])
        face("tread", [(a, f.y0, high), (b, f.y0, high), (b, f.y1, high), (a, f.y1, high)])
        for y, order in ((f.y0, 1), (f.y1, -1)):
            face("riser", [(a, y, under(i)), (b, y, under(i + 1)), (b, y, high), (a, y, high)][::order])
    knees = [0, STEPS] if under(0) > LOW else [1, 2, STEPS]     # the line under the steps bends there
    for i, k in zip(knees, knees[1:]):
        a, b, low, high = f.x(i), f.x(k), under(i), under(k)
        face("soffit", [(a, f.y0, low), (a, f.y1, low), (b, f.y1, high), (b, f.y0, high)])
    return mesh


def _strips(scene, name, f):
    for i in range(STEPS):
        x = f.x(i) + f.way * 0.035
        scene.box(f"strip {name} {i}", "rubber", (0.045, f.y1 - f.y0 - 0.1, 0.004),
                  Place(x, (f.y0 + f.y1) / 2, f.tread(i)))


def _well_side(f):
    return f.y0 + 0.05 if f.y0 > 1 else f.y1 - 0.05


def _balusters(scene, name, f):
    y = _well_side(f)
    for i in range(STEPS):
        for k, part in enumerate((0.3, 0.8)):
            x = f.x(i + part)
            tall = f.nose_line(x) + RAIL - f.tread(i)
            scene.box(f"baluster {name} {i} {k}", "iron", (0.016, 0.016, tall), Place(x, y, f.tread(i)))


def _handrails(flights):
    """Wood over the balusters, round the turns from flight to flight, and on brackets along the walls."""
    mesh = Mesh()
    for f in flights.values():
        y, wall = _well_side(f), (f.y1 - 0.07 if f.y0 > 1 else f.y0 + 0.07)
        a, b = f.x(-0.3), f.x(STEPS + 0.3)
        ends = ((a, f.nose_line(f.x(0)) + RAIL), (f.x(0), f.nose_line(f.x(0)) + RAIL),
                (f.x(STEPS), f.nose_line(f.x(STEPS)) + RAIL),
                (b, f.nose_line(f.x(STEPS)) + RAIL))
        mesh.tube("wood", [(x, y, z) for x, z in ends], 0.027)
        mesh.tube("iron", [(f.x(0), y, f.nose_line(f.x(0)) + 0.12), (f.x(STEPS), y, f.nose_line(f.x(STEPS)) + 0.12)],
                  0.009, 8)
        mesh.tube("wood", [(x, wall, z) for x, z in ends[1:3]], 0.022)
        for i in (1, 5, 9):
            x = f.x(i)
            z, back = f.nose_line(x) + RAIL, wall + (0.068 if f.y0 > 1 else -0.068)
            mesh.tube("iron", [(x, wall, z - 0.02), (x, wall, z - 0.07), (x, back, z - 0.07)], 0.008, 8)
    for x, levels in ((LANDING_X + 0.3 * GOING, (0, STOREY)), (TURN_X - 0.3 * GOING, (-STOREY / 2, STOREY / 2))):
        for z in levels:
            rail = z + RISE + RAIL
            mesh.tube("wood", [(x, SOUTH_HALF[1] - 0.077, rail), (x, NORTH_HALF[0] + 0.077, rail)], 0.027)
            for y in (1.0, 1.2, 1.4):
                mesh.tube("iron", [(x, y, z - 0.01), (x, y, rail - 0.02)], 0.012, 8)
    return mesh


def _dado(flights):
    """Painted up to shoulder height, the edge of the paint following the steps along the walls."""
    mesh, tall, band = Mesh(), 1.25, 0.05

    def paint(material, y, ends):
        """Between two upright lines (x, z from, z to), facing the hall."""
        (a, a0, a1), (b, b0, b1) = sorted(ends)
        corners = [(a, y, a0), (b, y, b0), (b, y, b1), (a, y, a1)]
        mesh.face(material, corners if y > 1 else corners[::-1])

    for f in flights.values():
        y = f.y1 - 0.003 if f.y0 > 1 else f.y0 + 0.003
        ends = ((f.x(0), f.z), (f.x(STEPS), f.z + RISE * STEPS))
        paint("dado", y, [(x, max(z - THICK, LOW), z + tall) for x, z in ends])
        paint("band", y, [(x, z + tall, z + tall + band) for x, z in ends])
    for y in (SOUTH_Y + 0.003, NORTH_Y - 0.003):
        for x0, x1, z in ((LANDING_X, 0, 0), (LANDING_X, 0, STOREY), (WEST_X, TURN_X, -STOREY / 2),
                          (WEST_X, TURN_X, STOREY / 2)):
            paint("dado", y, [(x, z, z + tall) for x in (x0, x1)])
            paint("band", y, [(x, z + tall, z + tall + band) for x in (x0, x1)])
    return mesh
