#!/usr/bin/env python3
"""Writes models/: the generated families and the hard cases of the benchmark, as .csg files.

    generate.py [NAME N]      all models at the sizes of the suite; or to standard output a family at another size

grid N      N x N cells of pitch 10; in cell (i, j) a sphere of radius 4 if i + j is even, otherwise a cone of height 8
            with radii 4 and 3, both of 12 fragments; all united.
nested N    d(0) less the quadrant x > 0, y < 0, where d(k) = solid(k) less d(k + 1) and d(N) is empty. solid(k) is a
            cube of side 2r if k is even, otherwise a sphere of radius 1.2r of 16 fragments; r = 20 * 0.84^k.
tree N      t(N), where t(0) is a cube of side 24 and t(k) is t(k - 1) united with a rod (k mod 3 = 1), less a sphere
            (k mod 3 = 2), or intersected with a prism of 14 sides (k mod 3 = 0). They stand at the angle 137.5k degrees.

All solids but those of the grid are centred. Numbers have at most four decimals."""
import math
import sys
from pathlib import Path

SIZES = {"grid": 4, "nested": 10, "tree": 30}


def number(value):
    return f"{round(value, 4):g}" if abs(value) < 1000 else f"{value:.4f}"


def moved(x, y, z, solid):
    place = ", ".join(f"[{a}, {b}, {c}, {number(d)}]" for a, b, c, d in ((1, 0, 0, x), (0, 1, 0, y), (0, 0, 1, z), (0, 0, 0, 1)))
    return f"multmatrix([{place}]) {{ {solid} }}"


def cube(x, y, z, centred=True):
    return f"cube(size = [{number(x)}, {number(y)}, {number(z)}], center = {'true' if centred else 'false'});"


def box(low, high):
    return moved(*low, cube(*(b - a for a, b in zip(low, high)), centred=False))


def sphere(radius, fragments):
    return f"sphere($fn = {fragments}, $fa = 12, $fs = 2, r = {number(radius)});"


def cone(height, low, high, fragments, centred=True):
    return (f"cylinder($fn = {fragments}, $fa = 12, $fs = 2, h = {number(height)}, r1 = {number(low)}, "
            f"r2 = {number(high)}, center = {'true' if centred else 'false'});")


def joined(operation, *solids):
    return f"{operation}() {{\n" + "\n".join(solids) + "\n}"


def grid(n):
    cells = [moved(10 * i, 10 * j, 0, sphere(4, 12) if (i + j) % 2 == 0 else cone(8, 4, 3, 12))
             for j in range(n) for i in range(n)]
    return joined("union", *cells)


def nested(n):
    def solid(k):
        r = 20 * 0.84**k
        return cube(2 * r, 2 * r, 2 * r) if k % 2 == 0 else sphere(1.2 * r, 16)

    model = solid(n - 1)
    for k in reversed(range(n - 1)):
        model = joined("difference", solid(k), model)
    return joined("difference", model, box((0, -30, -30), (30, 0, 30)))


def tree(n):
    model = cube(24, 24, 24)
    for k in range(1, n + 1):
        angle = math.radians(137.5 * k)
        x, y, z = math.cos(angle), math.sin(angle), 10 - 20 * k / n
        if k % 3 == 1:
            model = joined("union", model, moved(9 * x, 9 * y, z, cone(18, 2.5, 2, 9)))
        elif k % 3 == 2:
            model = joined("difference", model, moved(12 * x, 12 * y, z, sphere(4, 10)))
        else:
            model = joined("intersection", model, moved(x, y, 0, cone(40, 17 - 4 * k / n, 17, 14)))
    return model


def coplanar_faces():
    """Boxes with common faces, cuts that end flush with a face, and holes whose ends are flush with both faces."""
    wall = joined("union", box((0, 0, 0), (10, 10, 10)), box((10, 0, 0), (20, 10, 10)), box((20, 3, 2), (26, 10, 10)))
    return joined("difference", wall, box((3, 0, 3), (7, 10, 7)), box((12, 0, 5), (18, 5, 10)), box((0, 0, 8), (3, 10, 10)),
                  moved(23, 6.5, 2, cone(8, 2, 2, 24, centred=False)))


def edge_on_faces():
    """Blocks, prisms and a tube whose side faces are parallel to the view axis, y."""
    return joined("union", box((-8, 0, 0), (0, 8, 8)), box((0, 2, 0), (8, 10, 8)),
                  joined("difference", box((-8, 0, 8), (8, 6, 16)), box((-4, 0, 10), (4, 6, 14))),
                  box((-6, 1, -6), (6, 4, 0)))


def thin_walls():
    """Walls and slits of 0.02 in a block of 20, and two nearly parallel faces."""
    walls = [box((2 + 3 * i, -12, -4), (2.02 + 3 * i, 12, 16)) for i in range(3)]
    slits = [box((11 + 3 * i, -12, 2), (11.02 + 3 * i, 12, 11)) for i in range(3)]
    wedge = ("multmatrix([[0.999998, 0, 0.002, -1], [0, 1, 0, -10], [-0.002, 0, 0.999998, 10], [0, 0, 0, 1]]) { "
             + cube(22, 20, 5, centred=False) + " }")
    block = joined("difference", box((0, -10, 0), (20, 10, 10)), *slits)
    return joined("union", block, *walls, wedge)


def models():
    """The texts of all models at the sizes of the suite, by name."""
    texts = {family: globals()[family](n) for family, n in SIZES.items()}
    texts |= {case.__name__: case() for case in (coplanar_faces, edge_on_faces, thin_walls)}
    return {name: text + "\n" for name, text in texts.items()}


def main():
    if len(sys.argv) == 3 and sys.argv[1] in SIZES:
        print(globals()[sys.argv[1]](int(sys.argv[2])))
        return
    if len(sys.argv) != 1:
        raise SystemExit(__doc__)
    for name, text in models().items():
        (Path(__file__).resolve().parent / f"models/{name}.csg").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
