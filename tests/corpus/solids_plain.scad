// The solids that csgsim has always drawn: cubes, spheres, cylinders, cones, a convex polyhedron; those of no size are nothing.
cube([8, 5, 3]);
translate([14, 2, 3]) sphere(3);
translate([22, 0, 0]) cylinder(6, 3, 1);
translate([30, 2, 0]) cylinder(h = 6, r = 2, $fn = 5, center = true);
translate([0, 12, 0]) cylinder(5, 4, 0);
translate([12, 10, 0]) polyhedron([[0, 0, 0], [6, 0, 0], [6, 6, 0], [0, 6, 0], [3, 3, 7]], [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [3, 2, 1, 0]]);
translate([22, 10, 0]) multmatrix([[1, 0.4, 0, 0], [0, -1, 0.3, 0], [0, 0, 1.5, 0]]) cube(4);
sphere(0);
cylinder(h = 0, r = 9);
cube([9, 0, 30]);
