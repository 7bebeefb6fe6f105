// Sweeps compared with OpenSCAD; make.sh renders each by its name.
name = "l_prism";

module l() polygon([[-2, -1], [6, -1], [6, 2], [1, 2], [1, 5], [-2, 5]]);
module star() polygon([[10, 0], [4, 3], [3, 9.5], [-1.5, 5], [-8, 6], [-5, 0], [-8, -6], [-1.5, -5], [3, -9.5], [4, -3]]);
module nest() polygon([[-8, -8], [8, -8], [8, 8], [-8, 8], [-5, -5], [-5, 5], [5, 5], [6, 0], [5, -5], [-2, -2], [2, -2], [0, 3]],
                      [[0, 1, 2, 3], [4, 5, 6, 7, 8], [9, 10, 11]]);
module hooked() polygon([[-3, -3], [7, -3], [7, 1], [4, 1], [4, 6], [-3, 6], [-1, -1], [-1, 2], [2, 2], [2, -1]],
                        [[0, 1, 2, 3, 4, 5], [6, 7, 8, 9]]);
module far() polygon([[3, 0], [4, -1], [6, -1.5], [8, -1], [9, 0], [9.5, 2], [9, 4], [8, 5], [6, 5.5], [4, 5], [3, 4], [2.5, 2]]);
module box() polygon([[-3, -2], [3, -2], [3, 2], [-3, 2]]);

module pawn() polygon([[0, 0], [5, 0], [5, 1], [3, 2], [2, 4], [2, 7], [3.5, 7.5], [3.5, 8.5], [2, 9], [2.5, 10.5], [2, 12], [0, 13]]);
module cup() polygon([[0, 0], [5, 0], [7, 9], [6, 9], [4.25, 1], [0, 1]]);
module goblet() polygon([[0, 0], [5, 0], [8, 4], [8, 9], [6, 9], [6.5, 5], [4.25, 1], [0, 1]]);
module ring() polygon([[5, -2], [6, -3], [8, -3], [9, -1], [9, 1], [7, 3], [5, 2]]);
module left_ring() polygon([[-5, 2], [-7, 3], [-9, 1], [-9, -1], [-8, -3], [-6, -3], [-5, -2]]);
module left_cup() polygon([[0, 1], [-4.25, 1], [-6, 9], [-7, 9], [-5, 0], [0, 0]]);
module tipped() polygon([[0, 2], [4, 0], [6, 4], [3, 3]]);
module spool() polygon([[0, 1], [3, -1], [4, 5], [1, 6], [0, 4]]);

if (name == "l_prism") linear_extrude(height = 7) l();
if (name == "l_center") linear_extrude(height = 7, center = true, slices = 3) l();
if (name == "l_none") linear_extrude(height = -7) l();
if (name == "nest_prism") linear_extrude(height = 3) nest();
if (name == "star_half") linear_extrude(height = 5, scale = 0.5, center = true) star();
if (name == "star_point") linear_extrude(height = 5, scale = 0) star();
if (name == "hooked_grown") linear_extrude(height = 5, scale = 1.5) hooked();
if (name == "l_turned_point") linear_extrude(height = 9, twist = 360, scale = 0) l();
if (name == "hooked_twist") linear_extrude(height = 8, twist = 90) hooked();
if (name == "hooked_twist_fn") linear_extrude(height = 8, twist = 90, $fn = 30) hooked();
if (name == "star_wide") linear_extrude(height = 6, scale = [2, 0.5]) star();
if (name == "star_wide_fn") linear_extrude(height = 6, scale = [2, 0.5], $fn = 2) star();
if (name == "box_wide") linear_extrude(height = 6, scale = [2, 0.5]) box();
if (name == "l_ridge") linear_extrude(height = 6, scale = [0, 1]) l();
if (name == "l_ridge_turned") linear_extrude(height = 6, twist = 40, scale = [0.5, 0]) l();
if (name == "box_one_slice") linear_extrude(height = 6, twist = 60, slices = 1) box();
if (name == "l_one_slice") linear_extrude(height = 6, twist = 30, slices = 1) l();
if (name == "nest_one_slice") linear_extrude(height = 6, twist = 20, slices = 1) nest();
if (name == "star_back") linear_extrude(height = 10, twist = -120, center = true, $fa = 20) star();
if (name == "far_helix") linear_extrude(height = 30, twist = 360, $fs = 4) far();
if (name == "far_cone") linear_extrude(height = 30, twist = 200, scale = 0.25, $fs = 3, $fa = 5) far();
if (name == "far_grown") linear_extrude(height = 2, twist = 100, scale = 1.2, $fs = 3) far();
if (name == "far_spread") linear_extrude(height = 4, twist = -45, scale = [1.5, 0.75], $fs = 1) far();
if (name == "star_grown") linear_extrude(height = 10, twist = 100, scale = 2, $fs = 3) star();
// Sides on lines through the axis with equal diagonals.
module corner() polygon([[0, 0], [8, 0], [8, 6], [0, 6], [2, 2], [2, 5], [5, 5]], [[0, 1, 2, 3], [4, 5, 6]]);
if (name == "corner_turned") linear_extrude(height = 8, twist = 50, $fn = 20) corner();
if (name == "corner_back") linear_extrude(height = 8, twist = -50, $fn = 20) corner();
if (name == "corner_spread") linear_extrude(height = 8, scale = [1.5, 1], $fn = 2) corner();

// Sides cross each other here.
if (name == "quad_crossed") linear_extrude(height = 4, twist = 90, scale = [0.5, 0], $fn = 6) polygon([[5.75, -6], [7, 1.375], [-1.125, 8], [-7.75, -2.125]]);
if (name == "frame_crossed") linear_extrude(height = 5, twist = 10, $fs = 5) polygon([[-5, -7.375], [-10.125, 11.625], [-19.25, 0.875], [-7.375, -0.125], [-9.875, -0.375], [-11.875, 1.5], [-11.125, 3.625], [-8.125, 2.875]], [[0, 1, 2], [3, 4, 5, 6, 7]]);

if (name == "pawn_full") rotate_extrude($fn = 12) pawn();
if (name == "pawn_default") rotate_extrude() pawn();
if (name == "pawn_quarter") rotate_extrude(angle = 90, $fn = 16) pawn();
if (name == "pawn_back") rotate_extrude(angle = -135, $fn = 16) pawn();
if (name == "pawn_most") rotate_extrude(angle = 290, $fn = 11) pawn();
if (name == "goblet_full") rotate_extrude($fn = 10) goblet();
if (name == "cup_full") rotate_extrude($fn = 10) cup();
if (name == "ring_full") rotate_extrude($fn = 9) ring();
if (name == "ring_most") rotate_extrude(angle = 250.5, $fs = 3) ring();
if (name == "ring_left") rotate_extrude($fn = 7) left_ring();
if (name == "cup_left_back") rotate_extrude(angle = -100, $fn = 20) left_cup();
if (name == "ring_past_half") rotate_extrude(angle = 230, $fn = 3) ring();
if (name == "ring_past_full") rotate_extrude(angle = 500, $fn = 5) ring();
if (name == "tipped_full") rotate_extrude($fn = 8) tipped();
if (name == "spool_full") rotate_extrude($fn = 8) spool();
if (name == "spool_most") rotate_extrude(angle = 200, $fn = 8) spool();
