// offset by delta: sharp corners stay sharp, however far out they go; chamfered they are cut.
module shape() { polygon([[0, 0], [16, 0], [16, 4], [6, 4], [4, 14], [0, 12]]); }
linear_extrude(2) offset(delta = 1.5) shape();
translate([26, 0]) linear_extrude(3) offset(delta = 1.5, chamfer = true) shape();
translate([0, 24]) linear_extrude(4) offset(delta = -1.2) shape();
translate([26, 24]) linear_extrude(5) offset(delta = -1.2, chamfer = true) shape();
