#!/usr/bin/env python3
"""Tests of the computations behind docs/lessons.md, on numbers calculated on paper."""

import unittest

import by_hand
from by_hand import BACKS, FRONTS, ByHand, Face, Plane
from tables import one_pixel_story

X12, Y8, Z4 = Face(0, True), Face(1, True), Face(2, True)


def rounded(box, face, fraction_bits=by_hand.FRACTION_BITS):
    """The plane of a face with each coefficient rounded, the constant for the middle of the picture."""
    exact = ByHand.__new__(ByHand)
    exact.z_bits = 8
    at = [exact.exact(box, face, x, y) * 2**fraction_bits for x, y in ((0, 0), (1, 0), (0, 1))]
    a, b = round(at[1] - at[0]), round(at[2] - at[0])
    middle = exact.exact(box, face, 7.5, 7.5) * 2**fraction_bits
    return Plane(a, b, round(middle - 7.5 * (a + b)), fraction_bits)


def hand():
    return ByHand([rounded(box, face) for box in by_hand.BOXES for face in by_hand.FACES])


class Camera(unittest.TestCase):
    def test_the_eye_is_50_units_from_the_centre(self):
        # The vector from 30,-24,36 to 6,6,4 is -24, 30, -32: 576 + 900 + 1024 is 50 squared.
        self.assertEqual(by_hand.DISTANCE, 50)
        for part, hundredths in zip(by_hand.FORWARD, (-48, 60, -64)):
            self.assertAlmostEqual(part, hundredths / 100)

    def test_depths_reach_from_a_corner_of_b_to_one_of_a(self):
        # -0.48 x + 0.6 y - 0.64 z is -51.84 at the eye, -8.32 at 4,0,10, and 7.2 at 0,12,0.
        self.assertAlmostEqual(by_hand.NEAR, 43.52)
        self.assertAlmostEqual(by_hand.FAR, 59.04)

    def test_the_centre_is_in_the_middle_of_the_picture(self):
        for seen, wanted in zip(by_hand.seen(by_hand.CENTRE), (8, 8, 50)):
            self.assertAlmostEqual(seen, wanted)

    def test_the_right_left_and_top_sides_face_the_eye(self):
        self.assertEqual(FRONTS, [Face(0, True), Face(1, False), Face(2, True)])
        self.assertEqual(BACKS, [Face(0, False), Face(1, True), Face(2, False)])


class Planes(unittest.TestCase):
    def test_an_expression_is_read_with_its_signs(self):
        self.assertEqual(by_hand.expression("keep_max Z1, 525*x + 269*y - 7503 (w14 >> 4)"), Plane(525, 269, -7503, 4))
        self.assertEqual(by_hand.expression("linear_gt Z1, -97*y + 1152 (w11 >> 2)"), Plane(0, -97, 1152, 2))
        self.assertIsNone(by_hand.expression("edge_not_negative x - 4 (w5)"))

    def test_a_shift_rounds_down(self):
        self.assertEqual(Plane(525, 269, -7503, 4).at(7, 5), -156)  # -2483 / 16 is -155.2

    def test_rejects_a_plane_that_differs_from_the_rounded_one(self):
        planes = [rounded(box, face) for box in by_hand.BOXES for face in by_hand.FACES]
        off = rounded("A", Z4)
        planes = [Plane(off.a, off.b + 1, off.c, off.shift) if plane == off else plane for plane in planes]
        with self.assertRaises(ValueError):
            ByHand(planes)


class Rules(unittest.TestCase):
    def test_integer_depths_are_within_1_1_steps_of_depths_in_doubles(self):
        judge = hand()
        for box, face in (("A", Z4), ("N", Y8), ("B", X12)):
            self.assertAlmostEqual(judge.depth(box, face, 7, 5), judge.exact(box, face, 7, 5), delta=1.1)

    def test_a_box_contains_its_front_but_not_its_back(self):
        judge = hand()
        front, back = judge.front("B", 7, 5), judge.back("B", 7, 5)
        self.assertEqual([judge.holds("B", z, 7, 5) for z in (front - 1, front, back - 1, back)], [False, True, True, False])

    def test_the_back_of_the_notch_replaces_two_fronts(self):
        steps = dict(hand().pixel(7, 5))
        self.assertEqual(steps["A shade"].z2, hand().front("A", 7, 5))
        self.assertFalse(steps["B mask"].mask)
        self.assertEqual(steps["N in B shade"].z2, hand().back("N", 7, 5))

    def test_a_pixel_outside_the_model_keeps_the_initial_depth_and_background(self):
        last = hand().pixel(0, 0)[-1][1]
        self.assertEqual((last.z2, last.colour), (255, by_hand.BACKGROUND))

    def test_an_unlit_facet_has_the_ambient_part_of_its_colour(self):
        self.assertEqual(by_hand.colour("B", X12, True), 0x493913)  # 0.3 of 0.95, 0.75, 0.25


class Held(unittest.TestCase):
    """Computed values are compared with the output of csgsim debug."""

    PRINTED = ("> print 0,0\n  E            1\n  Z2           166 (0xa6)\n  Z1           128 (0x80)\n"
               "  colour       5476311 (0x538fd7), #538fd7\n  mask         0\n")

    def test_reads_the_fields_that_the_debugger_prints(self):
        self.assertEqual(one_pixel_story.printed_states(self.PRINTED), [{(0, 0): {"E": 1, "Z2": 166, "Z1": 128, "colour": 5476311, "mask": 0}}])

    def test_reports_a_field_that_differs(self):
        machine = one_pixel_story.printed_states(self.PRINTED)[0][0, 0]
        same = by_hand.Pixel(True, 128, 166, False, 5476311)
        one_pixel_story.compare("a step", (0, 0), same, machine)
        for other in (by_hand.Pixel(False, 128, 166, False, 5476311), by_hand.Pixel(True, 127, 166, False, 5476311),
                      by_hand.Pixel(True, 128, 165, False, 5476311), by_hand.Pixel(True, 128, 166, True, 5476311),
                      by_hand.Pixel(True, 128, 166, False, 5476310)):
            with self.assertRaises(one_pixel_story.Differs):
                one_pixel_story.compare("a step", (0, 0), other, machine)

    def test_an_instruction_takes_the_clocks_of_its_bits(self):
        for text, wanted in (("enable_all", 1), ("keep_max Z1, -97*y + 1152 (w11 >> 2) <8>", 22), ("linear_gt Z1, 3*x (w14 >> 4) <8>", 14),
                             ("copy Z2, Z1 <8>", 8), ("field_lt Z1, Z2 <8>", 16), ("skip_if_none 20", 11)):
            self.assertEqual(by_hand.clocks(text, 8, 2), wanted, text)


if __name__ == "__main__":
    unittest.main()
