// A profile that touches the axis at two corners and along none of its sides.
// (Alone: OpenSCAD cannot take a solid that touches itself into a union.)
rotate_extrude($fn = 16) polygon([[0, 0], [6, 2], [0, 4], [4, 6], [0, 8], [8, 9], [8, -1]]);
