#!/usr/bin/env python3
"""write.py: writes the Programs of docs/performance.md into this folder; write.py --check: fails if they are outdated.

Pixels are 512 x 512 with centres at half-integers, y down. Distances along z are in pixels too, 0 to 512.
"""

import pathlib
import sys
from fractions import Fraction
from math import ceil, floor

SIDE = 512
COLOUR_BITS = 24
BACKGROUND = 0xFFFFFF
COMPONENTS = ("blue", "green", "red")  # bytes of the colour, from its low bits up


def component_field(colour, component):
    return f"[{colour + 8 * COMPONENTS.index(component)}+:8]"


def linear(a, b, c, width, shift=0):
    return f"{a}*x + {b}*y + {c} (w{width}{f' >> {shift}' if shift else ''})".replace("+ -", "- ")


class Program:
    def __init__(self, title, z_bits, fields, primitives):
        self.lines = [f"# {line}" for line in title]
        self.lines += [
            f".array width={SIDE} height={SIDE} memory_bits=72",
            '.machine name="pixel-planes-4"',
            f".frame colour_base={z_bits} colour_bits={COLOUR_BITS} background={BACKGROUND}",
            f".depth perspective=false near=0 far={SIDE}",
            f".compile z_bits={z_bits}",
        ]
        self.lines += [f".field {name} [{base}+:{width}] {role}" for name, base, width, role in fields]
        self.lines += [f'.primitive "{name}"  # p{i}' for i, name in enumerate(primitives)]
        self.lines += ["", f".segment x=0 y=0 width={SIDE} height={SIDE} primitives={len(primitives)}"]
        self.origin = "setup"

    def begin(self, origin, comment):
        self.origin = origin
        self.lines += ["", f"  # {comment}"]

    def add(self, *instructions):
        self.lines += [f"  {text:62}; {self.origin}" for text in instructions]

    def clear(self, z_bits):
        self.add("enable_all", f"set_constant Z, {2**z_bits - 1}", f"set_constant colour, {BACKGROUND}")

    def text(self):
        return "# csgsim program, written by tests/budgets/write.py\n" + "\n".join(self.lines) + "\n"


# ---- triangles ----------------------------------------------------------------------------------------------------

Z_BITS = 20
STEPS = Fraction(2**Z_BITS - 4, SIDE)  # depth steps per pixel
EDGE_WIDTH = 21  # 12 bits for a coefficient in quarters of a pixel, and log2 512
PLANE_WIDTH, PLANE_SHIFT = 33, 12  # 20 bits for depth, 12 for fraction, a sign
SHADE_WIDTH, SHADE_SHIFT = 19, 10  # 8 bits for a component, 10 for fraction, a sign

# Corners x, y, z, red, green, blue; x and y in whole quarters of a pixel.
TRIANGLES = (
    ("ground", ((30, 430, 120, 60, 140, 60), (490.25, 470.5, 150, 130, 210, 90), (300, 30.75, 420, 40, 90, 120))),
    ("wall", ((200.5, 60, 250, 220, 180, 60), (420, 180, 260, 240, 120, 40), (330, 420.25, 270, 150, 60, 30))),
    ("blade", ((120, 150.5, 60, 230, 40, 40), (300.75, 190, 80, 40, 60, 230), (190, 330, 50, 240, 230, 60))),
)
LIGHT = (Fraction(3, 5), Fraction(2, 5), Fraction(1))  # direction of the light


def exact(values):
    return [Fraction(value) for value in values]


def minus(a, b):
    return [p - q for p, q in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def at_centres(a, b, c):
    """The plane a*X + b*Y + c at pixel centres X, Y as an expression of the pixel x, y."""
    return a, b, c + (a + b) / 2


def solve(corners, values):
    """Coefficients a, b, c with a*x + b*y + c = value at the three corners."""
    normal = cross(
        minus([*corners[1][:2], values[1]], [*corners[0][:2], values[0]]),
        minus([*corners[2][:2], values[2]], [*corners[0][:2], values[0]]),
    )
    a, b = -normal[0] / normal[2], -normal[1] / normal[2]
    return a, b, values[0] - a * corners[0][0] - b * corners[0][1]


def rounded(plane, width, shift):
    """Rounds A and B to the nearest, and C so that the plane is most exact in the middle of the picture."""
    a, b, c = at_centres(*plane)
    middle = SIDE // 2
    scaled_a, scaled_b = round(a * 2**shift), round(b * 2**shift)
    scaled_c = round((c + (a + b) * middle) * 2**shift) - (scaled_a + scaled_b) * middle
    return linear(scaled_a, scaled_b, scaled_c, width, shift)


def edges(corners):
    """An edge that is not negative inside and on the boundary: rounding C down preserves the sign at pixels."""
    (x, y), (p, q) = minus(corners[1], corners[0])[:2], minus(corners[2], corners[0])[:2]
    inside = 1 if x * q > y * p else -1
    for start, end in zip(corners, corners[1:] + corners[:1]):
        a, b = -(end[1] - start[1]) * 4 * inside, (end[0] - start[0]) * 4 * inside
        a, b, c = at_centres(a, b, -(a * start[0] + b * start[1]))
        assert -(2**11) <= a < 2**11 and -(2**11) <= b < 2**11
        yield linear(int(a), int(b), floor(c), EDGE_WIDTH)


def depth(corners):
    return rounded(solve(corners, [1 + corner[2] * STEPS for corner in corners]), PLANE_WIDTH, PLANE_SHIFT)


def draw_triangle(program, index, name, corners):
    program.begin(f"render p{index}", f"{name}: three edges, depth compare")
    program.add("enable_all", *[f"edge_not_negative {edge}" for edge in edges(corners)])
    program.add(f"linear_lt Z, {depth(corners)}")
    program.begin(f"merge p{index}", "depth load")
    program.add(f"load_linear Z, {depth(corners)}")
    program.begin(f"shade p{index}", "a linear expression a component")
    for component, column in zip(COMPONENTS, (5, 4, 3)):
        plane = solve(corners, [corner[column] for corner in corners])
        field = component_field(Z_BITS, component)
        program.add(f"load_linear {field}, {rounded(plane, SHADE_WIDTH, SHADE_SHIFT)}")


def side_plane(start, end, inside):
    """The depth at which a line of sight passes the plane through an edge and along the light; with as many fraction
    bits as fit into 33 bits at every pixel."""
    normal = cross(minus(end, start), LIGHT)
    if dot(minus(inside, start), normal) < 0:
        normal = [-part for part in normal]
    a, b = -normal[0] / normal[2], -normal[1] / normal[2]
    plane = [a * STEPS, b * STEPS, 1 + (start[2] - a * start[0] - b * start[1]) * STEPS]
    most = max(abs(plane[0] * x + plane[1] * y + plane[2]) for x in (0, SIDE) for y in (0, SIDE))
    shift = min(PLANE_SHIFT, PLANE_WIDTH - 1 - (int(most) + 1).bit_length())
    return ("linear_le" if normal[2] > 0 else "linear_ge") + f" Z, {rounded(plane, PLANE_WIDTH, shift)}"


def cast_shadow(program, index, name, corners):
    a, b, _ = solve(corners, [corner[2] for corner in corners])
    assert dot((-a, -b, 1), LIGHT) > 0  # points behind the triangle for the eye are behind it for the light
    program.begin(f"effect p{index}", f"{name}: what is behind it as the light sees it is in its shadow")
    program.add("enable_all", f"linear_lt Z, {depth(corners)}")
    ends = corners[1:] + corners[:1]
    others = corners[2:] + corners[:2]
    program.add(*[side_plane(*sides) for sides in zip(corners, ends, others)])
    program.add("enable_or shadow", "enable_store shadow")


def triangles(shadows):
    colour = Z_BITS
    fields = [("Z", 0, Z_BITS, "depth"), ("colour", colour, COLOUR_BITS, "colour")]
    title = ["Smooth-shaded, Z-buffered triangles; docs/performance.md has what each costs."]
    if shadows:
        fields.append(("shadow", colour + COLOUR_BITS, 1, "mask"))
        title = ["Smooth-shaded, Z-buffered triangles with shadows; docs/performance.md has what each costs."]
    program = Program(title, Z_BITS, fields, [name for name, _ in TRIANGLES])
    program.clear(Z_BITS)
    shapes = [(name, [exact(corner) for corner in corners]) for name, corners in TRIANGLES]
    for index, (name, corners) in enumerate(shapes):
        draw_triangle(program, index, name, corners)
    if shadows:
        for index, (name, corners) in enumerate(shapes):
            cast_shadow(program, index, name, corners)
        program.begin("effect", "once a frame: half the light where there is something in shadow")
        program.add("enable_load shadow", f"linear_gt Z, {2**Z_BITS - 1} (w{Z_BITS + 1})")
        for i in range(len(COMPONENTS)):
            first = colour + 8 * i
            program.add(*[f"copy [{bit}], [{bit + 1}]" for bit in range(first, first + 7)])
            program.add(f"set_constant [{first + 7}], 0")
    return program


# ---- spheres ------------------------------------------------------------------------------------------------------

SPHERE_Z_BITS = 15
QUADRATIC, QUADRATIC_BITS = 39, 16
DISK = 55
SUM = 56
DISK_WIDTH, SUM_WIDTH = 20, 18
MIDDLE = SIDE // 2

# Centre in pixels from the picture's middle (column, row), depth of the front in pixels, log2 of r/s, log2 of s times
# the number of levels by which the limb is darker than the middle in red, green and blue, without the light from one
# side; and s, if the radius r is no power of two: a sum of powers of two, as their logarithms.
SPHERES = (
    ("large", (-80, 40), 100, 7, (6, 6, 7)),
    ("red", (50, -60), 120, 6, (7, 6, 5)),
    ("blue", (100, 20), 105, 6, (5, 6, 7)),
    ("small", (10, 30), 95, 5, (6, 7, 5)),
)
SPHERE_OF_ANOTHER_RADIUS = ("radius 51.2", (20, -30), 100, 6, (7, 6, 5), (0, -2))
LEVEL_AT_FRONT = {5: 62, 6: 120, 7: 225}  # level of a component, by the log2 of how much darker the limb is


def add_bits(program, carry, addend, mask=None):
    """Adds the bits of pixel memory at the places `addend` (None: a 0) to the field of equal width that begins at
    carry + 1; with a `mask`, only at pixels where that bit is 1. The sum begins at `carry`, whose bit must be 0 before.
    Works at every pixel; enable is overwritten.

    Where the two bits differ, the carry propagates and the sum is its inverse; where they are equal, the next carry is
    the field's bit, which is already in the next carry's place, and the sum is the carry."""
    for bit, place in enumerate(addend):
        own = carry + bit + 1
        if place is None:
            program.add(f"enable_load [{own}]")
        else:
            program.add(f"enable_load [{place}]")
            if mask is not None:
                program.add(f"enable_and [{mask}]")
            program.add(f"enable_xor [{own}]")
        if bit + 1 < len(addend):
            program.add(f"copy [{own}], [{own - 1}]")
        program.add(f"xor_constant [{own - 1}], 1")


def multiply(program, place, factor, next_factor):
    """Computes m * (m + 1) from the fields m of 8 bits at `factor` and m + 1 of 9 bits at `next_factor`, from the
    highest bit of m down: doubles the sum, and adds m + 1 where the bit is 1. Begins at `place`, moves down by 14 bits;
    returns where the product's 16 bits begin."""
    addend = [next_factor + i for i in range(9)]
    program.add("enable_all", f"set_constant [{place}+:9], 0", f"enable_load [{factor + 7}]")
    program.add(f"copy [{place}+:9], [{next_factor}+:9]")
    for bit in reversed(range(7)):
        addend.append(None)
        place -= 2  # the carry, and above it the 0 from doubling
        program.add("enable_all", f"set_constant [{place}+:2], 0")
        add_bits(program, place, addend, factor + bit)
    return place


def set_up_quadratic(program):
    """Sets the field `quadratic` to m(m + 1)/2 + n(n + 1)/2, where m and n are the whole pixels between a pixel and the
    middle of the picture, by column and by row."""
    factor, next_factor = 55, 63
    for axis in ("x", "y"):
        program.begin("setup", f"m, pixels from the middle in {axis}; and m + 1")
        program.add("enable_all", f"edge_not_negative {axis} - {MIDDLE} (w10)")
        program.add(f"load_linear [{factor}+:8], {axis} - {MIDDLE} (w10)")
        program.add(f"load_linear [{next_factor}+:9], {axis} - {MIDDLE - 1} (w10)")
        program.add("enable_all", f"edge_negative {axis} - {MIDDLE} (w10)")
        program.add(f"load_linear [{factor}+:8], -{axis} + {MIDDLE - 1} (w10)")
        program.add(f"load_linear [{next_factor}+:9], -{axis} + {MIDDLE} (w10)")
        program.begin("setup", "m * (m + 1)")
        place = multiply(program, 14, factor, next_factor)
        if axis == "x":
            program.begin("setup", "half of it is kept")
            program.add("enable_all", f"copy [{QUADRATIC}+:15], [{place + 1}+:15]")
    program.begin("setup", "and half of the other added")
    program.add("enable_all", f"set_constant [{place}], 0", f"set_constant [{place + 16}], 0")
    add_bits(program, place, [QUADRATIC + i for i in range(QUADRATIC_BITS - 1)] + [None])
    program.add("enable_all", f"copy quadratic, [{place}+:{QUADRATIC_BITS}]")


def shifted(bits, shift):
    """Bits of the quadratic field, times 2^shift, that overlap a sum of a number of bits."""
    places = [QUADRATIC + i - shift for i in range(bits)]
    return [place if QUADRATIC <= place < QUADRATIC + QUADRATIC_BITS else None for place in places]


def load_sum(program, expression, bits, shifts):
    """Stores the expression plus the quadratic field times 2^shift for each shift at SUM, for any enable."""
    program.add(f"set_constant [{SUM}], 0", f"load_linear [{SUM + 1}+:{bits}], {expression}")
    for further, shift in enumerate(shifts):
        if further:  # shift up by a bit to make room for the carry
            program.add("enable_load disk", *[f"copy [{SUM + i + 1}], [{SUM + i}]" for i in reversed(range(bits))])
            program.add(f"set_constant [{SUM}], 0")
        add_bits(program, SUM, shifted(bits, shift))


def draw_sphere(program, index, name, centre, front, log_size, darker, terms=(0,)):
    """Draws a sphere: d^2 = 2Q + a*x + b*y + c, with the quadratic field Q and the pixel's distance d from its axis."""
    column, row = MIDDLE + centre[0], MIDDLE + centre[1]
    a, b = 2 * MIDDLE - 1 - 2 * column, 2 * MIDDLE - 1 - 2 * row
    c = column**2 + row**2 - 2 * MIDDLE * (MIDDLE - 1)
    fraction = -min(terms)  # fraction bits of s
    s = sum(2 ** (term + fraction) for term in terms)  # in units of its last bit
    radius = Fraction(2 ** (log_size + fraction), s)
    width = SUM_WIDTH + (s - 1).bit_length()

    program.begin(f"render p{index}", f"{name}: inside the circle Q < (r^2 - a*x - b*y - c) / 2")
    program.add("enable_all", f"linear_gt quadratic, {linear(-a, -b, ceil(radius**2) - c + 1, DISK_WIDTH, 1)}")
    program.add("enable_store disk")
    program.begin(f"render p{index}", "depth of a paraboloid: front + d^2 / r pixels, 64 steps each")
    scale = 6 - log_size  # log2 of depth steps per unit of d^2, without s
    above, below = s * 2 ** max(scale, 0), fraction + max(-scale, 0)
    base = (1 + 64 * front) * 2**below
    plane = linear(a * above, b * above, c * above + base, width + max(scale, 0), below)
    load_sum(program, plane, SPHERE_Z_BITS, [term + scale + 1 for term in terms])
    program.begin(f"merge p{index}", "depth compare and copy")
    depth_sum = f"[{SUM}+:{SPHERE_Z_BITS}]"
    program.add("enable_load disk", f"field_lt {depth_sum}, Z", f"copy Z, {depth_sum}", "enable_store disk")
    program.begin(f"shade p{index}", "a component is 255 - (L + Q * 2^k), lit from the upper left")
    for component, log_drop in zip(COMPONENTS, reversed(darker)):
        drop = log_drop - 2 * log_size  # log2 of levels per unit of d^2, without s
        # A component gains half of that per radius to the left, and to the top.
        tilt = 2 ** (log_size - 1 + fraction)
        at_centre = (255 - LEVEL_AT_FRONT[log_drop]) * 2 ** (fraction - drop) - tilt * (column + row)
        program.add("enable_load disk")
        plane = linear(a * s + tilt, b * s + tilt, c * s + at_centre, width, fraction - drop)
        load_sum(program, plane, 8, [term + drop + 1 for term in terms])
        program.add("enable_load disk", f"bit_not {component_field(SPHERE_Z_BITS, component)}, [{SUM}+:8]")


def draw_spheres(*spheres):
    fields = [("Z", 0, SPHERE_Z_BITS, "depth"), ("colour", SPHERE_Z_BITS, COLOUR_BITS, "colour")]
    fields += [("quadratic", QUADRATIC, QUADRATIC_BITS, "scratch"), ("disk", DISK, 1, "mask"), ("sum", SUM, 16, "scratch")]
    title = ["Shaded, Z-buffered spheres by a quadratic field; docs/performance.md has what each costs."]
    program = Program(title, SPHERE_Z_BITS, fields, [sphere[0] for sphere in spheres])
    set_up_quadratic(program)
    program.begin("setup", "clear")
    program.clear(SPHERE_Z_BITS)
    for index, sphere in enumerate(spheres):
        draw_sphere(program, index, *sphere)
    return program


def main():
    programs = {
        "triangle": triangles(shadows=False),
        "shadow": triangles(shadows=True),
        "sphere": draw_spheres(*SPHERES),
        "sphere_radius": draw_spheres(SPHERE_OF_ANOTHER_RADIUS),
    }
    for name, program in programs.items():
        path = pathlib.Path(__file__).with_name(name + ".csgt")
        if sys.argv[1:] != ["--check"]:
            path.write_text(program.text())
        elif path.read_text() != program.text():
            sys.exit(f"{path} is outdated; run tests/budgets/write.py")


if __name__ == "__main__":
    main()
