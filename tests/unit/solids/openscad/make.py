#!/usr/bin/env python3
"""Records how OpenSCAD 2021.01 triangulates non-planar faces, to judge host/solids/tessellation.h. Usage: ./make.py

faces.txt has one line per face: the corners as passed to polyhedron(), each x y z, then | and OpenSCAD's triangles,
each as three corner numbers. All faces belong to one polyhedron and keep their order in its STL."""

import math
import random
import struct
import subprocess
import tempfile
from pathlib import Path

HERE = Path(__file__).parent


def turned(points, rng):
    w, x, y, z = (rng.gauss(0, 1) for _ in range(4))
    size = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / size, x / size, y / size, z / size
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return [[round(sum(row[i] * point[i] for i in range(3)), 4) for row in rows] for point in points]


def grid_square(rng):
    """A square of a height field along any axis, starting at any corner; its diagonals have equal lengths."""
    x, y = rng.choice([0, 1, 2, 5]), rng.choice([0, 1, 2, 5])
    axis = rng.randrange(3)
    points = []
    for u, v in [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]:
        point = [0, 0, 0]
        point[axis] = rng.choice([0, 0.25, 0.5, round(rng.uniform(0, 0.7), 2)])
        point[(axis + 1) % 3], point[(axis + 2) % 3] = u, v
        points.append(point)
    start = rng.randrange(4)
    return points[start:] + points[:start]


def star(rng, corners, least, bend):
    angles = sorted(rng.uniform(0, 2 * math.pi) for _ in range(corners))
    radii = [10 * rng.uniform(least, 1) for _ in angles]
    return turned([[r * math.cos(a), r * math.sin(a), rng.gauss(0, bend)] for r, a in zip(radii, angles)], rng)


def faces(rng):
    for _ in range(150):
        yield grid_square(rng)
    for _ in range(150):
        yield star(rng, 4, 0.8, rng.choice([0.05, 0.5, 1]))
    for _ in range(100):
        yield star(rng, 4, 0.2, 0.2)
    for _ in range(100):
        yield star(rng, rng.randint(5, 9), 1, 0.2)
    for _ in range(100):
        yield star(rng, rng.randint(5, 8), 0.4, 0.2)


def printed(point):
    return tuple(float("%g" % struct.unpack("f", struct.pack("f", c))[0]) for c in point)


def triangles_of(all_faces):
    points = [point for face in all_faces for point in face]
    numbers, start = [], 0
    for face in all_faces:
        numbers.append(list(range(start, start + len(face))))
        start += len(face)
    with tempfile.TemporaryDirectory() as folder:
        model, mesh = Path(folder, "faces.csg"), Path(folder, "faces.stl")
        model.write_text(f"polyhedron(points = {points}, faces = {numbers}, convexity = 1);")
        subprocess.run(["openscad", "-q", "-o", mesh, model], check=True)
        corners = [tuple(map(float, line.split()[1:])) for line in mesh.read_text().splitlines() if "vertex" in line]
    return [corners[i:i + 3] for i in range(0, len(corners), 3)]


def main():
    rng = random.Random(20210101)
    all_faces = [face if rng.random() < 0.5 else face[::-1] for face in faces(rng)]
    left = triangles_of(all_faces)
    lines = []
    for face in all_faces:
        number = {printed(point): i for i, point in enumerate(face)}
        own = []
        while left and all(corner in number for corner in left[0]):
            own.append(" ".join(str(number[corner]) for corner in left.pop(0)))
        corners = " ".join(f"{c:g}" for point in face for c in point)
        lines.append(f"{corners} | {' '.join(own)}\n")
    assert not left
    HERE.joinpath("faces.txt").write_text("".join(lines))


if __name__ == "__main__":
    main()
