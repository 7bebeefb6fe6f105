// More than two turns of a shape beside the axis: a spring of few slices.
linear_extrude(height = 20, twist = 800, slices = 60) translate([6, 0]) circle(1.5, $fn = 8);
