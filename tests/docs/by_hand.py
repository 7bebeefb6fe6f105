"""Recomputes docs/lessons.md with independent code: boxes, a camera and the CSG rules, at every pixel, in integers.

It uses only the planes' coefficients of csgsim, and checks that each is as close to the exact plane as docs/numbers.md
states. It involves no pruning and no instructions: the state of a pixel after a step of the algorithm follows from the
definitions."""

import math
import re
from dataclasses import dataclass, replace

SIDE = 16
FRACTION_BITS = 4
EYE, CENTRE = (30, -24, 36), (6, 6, 4)
FIELD_OF_VIEW = math.radians(22.5)
BOXES = {"A": ((0, 0, 0), (12, 12, 4)), "B": ((0, 0, 0), (4, 12, 10)), "N": ((2, 4, 2), (14, 8, 12))}
COLOURS = {"A": (0.35, 0.6, 0.9), "B": (0.95, 0.75, 0.25), "N": (0.9, 0.4, 0.35)}
BACKGROUND = 0xFFFFE5
LIGHT = (0.36, -0.56, 0.75)  # right, up and forward of the camera, as in tests/oracle/ray_light.cpp
AMBIENT, DIFFUSE = 0.3, 0.7


def dot(a, b):
    return sum(left * right for left, right in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return tuple(each / math.sqrt(dot(a, a)) for each in a)


FORWARD = unit(tuple(to - at for to, at in zip(CENTRE, EYE)))
RIGHT = unit(cross(FORWARD, (0, 0, 1)))
UP = cross(RIGHT, FORWARD)
DISTANCE = math.dist(EYE, CENTRE)
PIXEL = 2 * DISTANCE * math.tan(FIELD_OF_VIEW / 2) / SIDE  # in model units


def corners(box):
    low, high = BOXES[box]
    return [tuple((low, high)[n >> axis & 1][axis] for axis in range(3)) for n in range(8)]


def seen(point):
    """Column and row of a point, with pixel centres at half-integers, and its distance along the view."""
    away = tuple(at - eye for at, eye in zip(point, EYE))
    return SIDE / 2 + dot(away, RIGHT) / PIXEL, SIDE / 2 - dot(away, UP) / PIXEL, dot(away, FORWARD)


@dataclass(frozen=True)
class Face:
    """A side of a box: the axis perpendicular to it, and whether it is at the far end of that axis."""

    axis: int
    is_high: bool

    def place(self, box):
        return BOXES[box][self.is_high][self.axis]

    def normal(self):
        return tuple((1 if self.is_high else -1) if axis == self.axis else 0 for axis in range(3))

    def is_forward(self):
        return dot(self.normal(), FORWARD) < 0


FACES = [Face(axis, is_high) for axis in range(3) for is_high in (False, True)]
FRONTS = [face for face in FACES if face.is_forward()]
BACKS = [face for face in FACES if not face.is_forward()]
NEAR, FAR = (end(seen(corner)[2] for box in "AB" for corner in corners(box)) for end in (min, max))  # range of solids


@dataclass(frozen=True)
class Plane:
    """(ax + by + c) >> shift"""

    a: int
    b: int
    c: int
    shift: int

    def sum_at(self, x, y):
        return self.a * x + self.b * y + self.c

    def at(self, x, y):
        return self.sum_at(x, y) >> self.shift


def expression(text):
    """The plane of an instruction, or None."""
    found = re.search(r", (.*) \(w\d+(?: >> (\d+))?\)", text)
    if not found:
        return None
    of = {"x": 0, "y": 0, "": 0}
    for sign, number, name in re.findall(r"([+-]?) ?(\d+)(?:\*([xy]))?", found[1]):
        of[name] += int(sign + number)
    return Plane(of["x"], of["y"], of[""], int(found[2] or 0))


@dataclass(frozen=True)
class Pixel:
    """The state of a pixel. z1 is None for a disabled pixel, which keeps its previous value."""

    enabled: bool
    z1: int | None
    z2: int
    mask: bool
    colour: int


class ByHand:
    """The model's picture with a number of bits of depth, and the state of each pixel after each step."""

    def __init__(self, expressions, z_bits=8):
        self.z_bits = z_bits
        self.nothing = 2**z_bits - 1
        self.planes = {(box, face): self.only(box, face, set(expressions)) for box in BOXES for face in FACES}
        self.rectangles = {box: rectangle(box) for box in BOXES}

    def steps(self, distance):
        """A distance as depth in steps: 1 at the near end, 2^n - 3 at the far end."""
        return 1 + (distance - NEAR) * (2**self.z_bits - 4) / (FAR - NEAR)

    def exact(self, box, face, x, y):
        """The intersection of a pixel's ray with the plane of a face, in steps."""
        right, up = (x + 0.5 - SIDE / 2) * PIXEL, (SIDE / 2 - y - 0.5) * PIXEL
        begin = tuple(eye + right * r + up * u for eye, r, u in zip(EYE, RIGHT, UP))
        return self.steps((face.place(box) - begin[face.axis]) / FORWARD[face.axis])

    def only(self, box, face, expressions):
        """The only plane of the stream that is within the bound of docs/numbers.md of the exact one all over the
        picture."""
        found = [plane for plane in expressions if all(self.is_near(plane, box, face, x, y) for x in range(SIDE) for y in range(SIDE))]
        if len(found) != 1:
            raise ValueError(f"{len(found)} planes of the stream are {face} of box {box}")
        return found[0]

    def is_near(self, plane, box, face, x, y):
        aside = abs(x + 0.5 - SIDE / 2) + abs(y + 0.5 - SIDE / 2)
        bound = (1 + aside) * 2.0 ** -(FRACTION_BITS + 1) + 2.0**-plane.shift - 2.0**-FRACTION_BITS  # without factors of two
        return abs(plane.sum_at(x, y) / 2**plane.shift - self.exact(box, face, x, y)) <= bound

    def depth(self, box, face, x, y):
        return self.planes[box, face].at(x, y)

    def covers(self, box, x, y):
        left, top, right, bottom = self.rectangles[box]
        return left <= x <= right and top <= y <= bottom

    def front(self, box, x, y):
        return max([0] + [self.depth(box, face, x, y) for face in FRONTS])

    def back(self, box, x, y):
        return min([self.nothing] + [self.depth(box, face, x, y) for face in BACKS])

    def is_met(self, box, x, y):
        return self.covers(box, x, y) and self.front(box, x, y) < self.back(box, x, y)

    def holds(self, box, z, x, y):
        """Whether depth z of the pixel is inside the box."""
        return self.covers(box, x, y) and all(self.depth(box, face, x, y) <= z for face in FRONTS) and all(
            z < self.depth(box, face, x, y) for face in BACKS)

    def facet(self, box, faces, z, x, y):
        """The first of the faces at that depth; a depth without a plane has the last face's colour."""
        return next((face for face in faces if self.depth(box, face, x, y) == z), faces[-1])

    def pixel(self, x, y):
        """The state of the pixel after each step: (step, Pixel)."""
        steps = [("setup", Pixel(True, 0, self.nothing, False, BACKGROUND))]
        for box in "AB":
            met = self.is_met(box, x, y)
            now = replace(steps[-1][1], enabled=met, z1=self.front(box, x, y) if met else None)
            steps += [(f"{box} render", now), *self.surface(box, now, box, "N", x, y)]
        z1 = self.back("N", x, y) if self.is_met("N", x, y) else self.nothing
        steps.append(("N render", replace(steps[-1][1], enabled=True, z1=z1)))
        for other in "AB":
            now = replace(steps[-1][1], enabled=True, z1=z1)
            steps += self.surface("N", now, f"N in {other}", other, x, y)
        return steps

    def surface(self, box, now, named, other, x, y):
        """Depth test, classification against the other box, merge and shading of the contents of Z1."""
        is_back = box == "N"  # the visible surface of a subtracted box is its back, inside the remaining solid
        is_left = now.enabled and now.z1 < now.z2
        tested = replace(now, enabled=is_left, mask=is_left)
        inside = is_left and self.holds(other, now.z1, x, y)
        is_left = is_left and inside == is_back
        masked = replace(tested, enabled=is_left, mask=is_left)
        merged = replace(masked, z2=now.z1 if is_left else now.z2)
        shaded = merged
        if is_left:
            faces = BACKS if is_back else FRONTS
            face = self.facet(box, faces, now.z1, x, y)
            is_last = face == faces[-1]  # the other faces remove their pixels from the mask
            shaded = replace(merged, enabled=is_last, mask=is_last, colour=colour(box, face, not is_back))
        return [(f"{named} test", tested), (f"{named} classify", replace(tested, enabled=inside)), (f"{named} mask", masked),
                (f"{named} merge", merged), (f"{named} shade", shaded)]


def rectangle(box):
    """First column and row, last column and row, of the pixels whose centres are between the box's corners."""
    columns, rows = ([seen(corner)[axis] - 0.5 for corner in corners(box)] for axis in (0, 1))
    return math.ceil(min(columns)), math.ceil(min(rows)), math.floor(max(columns)), math.floor(max(rows))


def colour(box, face, is_front):
    """The colour of a facet; a subtracted box is seen from inside."""
    normal = tuple(each if is_front else -each for each in face.normal())
    shines = tuple(LIGHT[0] * r + LIGHT[1] * u + LIGHT[2] * f for r, u, f in zip(RIGHT, UP, FORWARD))
    light = AMBIENT + DIFFUSE * max(0, -dot(normal, unit(shines)))
    red, green, blue = (int(part * light * 255 + 0.5) for part in COLOURS[box])
    return red << 16 | green << 8 | blue


def clocks(text, latency, or_levels):
    """Clocks of an instruction on one-bit ALUs, by the table of docs/instruction-set.md; `text` gives widths for
    fields."""
    name = text.split()[0]
    width = re.search(r"\(w(\d+)", text)
    if width:
        return int(width[1]) * (2 if name.startswith("keep") else 1)
    if name == "skip_if_none":
        return 1 + latency + or_levels
    if name.startswith("enable"):
        return 1
    bits = int(re.search(r"<(\d+)>", text)[1])
    return bits * (2 if name.startswith("field") else 1)
