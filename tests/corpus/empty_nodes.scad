// Nodes without children, or with empty ones, beside a cube.
cube(8);
hull() {}
minkowski() {}
linear_extrude(9) {}
rotate_extrude() {}
linear_extrude(9) offset(3) {}
linear_extrude(9) projection() {}
resize([3, 3, 3]) {}
render() {}
polyhedron();
linear_extrude(9) polygon([]);
linear_extrude(9) polygon();
hull() { linear_extrude(3) square(0); }
difference() { translate([12, 0, 0]) cube(6); hull() {} rotate_extrude() circle(0); minkowski() {} }
