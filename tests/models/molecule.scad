// Adamantane, C10 H16, as a space-filling model: 26 spheres that run into each other. Lengths in tenths of an angstrom:
// bonds of 15.4 and 10.9, at tetrahedral angles, and the van der Waals radii of carbon and hydrogen.

bond_c = 15.4 / sqrt(3);  // along each axis
bond_h = 10.9 / sqrt(3);

module carbon(place) {
    color([0.4, 0.4, 0.45]) translate(place) sphere(r = 17);
}

module hydrogen(place) {
    color([0.95, 0.95, 0.95]) translate(place) sphere(r = 12);
}

// Four carbons with one hydrogen each.
for (corner = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) {
    carbon(bond_c * corner);
    hydrogen((bond_c + bond_h) * corner);
}

// Six with two, between them.
for (side = [-1, 1], axis = [0 : 2]) {
    // Unit vectors along the axis and the next two.
    u = [for (i = [0 : 2]) i == axis ? side : 0];
    v = [for (i = [0 : 2]) i == (axis + 1) % 3 ? 1 : 0];
    w = [for (i = [0 : 2]) i == (axis + 2) % 3 ? 1 : 0];
    carbon(2 * bond_c * u);
    hydrogen(2 * bond_c * u + bond_h * (u + v - side * w));
    hydrogen(2 * bond_c * u + bond_h * (u - v + side * w));
}
