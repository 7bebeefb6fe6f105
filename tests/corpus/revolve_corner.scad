// A profile that touches the axis at one corner, part of the way around.
rotate_extrude(angle = 250, $fn = 20) polygon([[0, 4], [7, 0], [7, 8]]);
