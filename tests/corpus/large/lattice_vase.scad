// A large part: a vase of a honeycomb that is out of order, as a Voronoi diagram looks. Each strut is the hull of two small spheres.
columns = 54;  // even: the honeycomb closes around the vase
rows = 56;
rise = 2.75;   // height between rows
thick = 0.75;  // radius of a strut
disorder = 0.28;

noise = rands(-disorder, disorder, 2 * columns * rows, 1987);
function radius(z) = 36 + 13 * sin(z * 1.9 + 20) + z * 0.05;
function is_even(i, j) = (i + j) % 2 == 0;

// Where strut ends meet: zigzag columns, whose peaks are joined to those of the next one.
function node(i, j) =
  let (n = 2 * ((i % columns) * rows + j),
       inside = j == 0 || j == rows - 1 ? 0 : 1,
       a = 360 / columns * (i + (is_even(i, j) ? 1 : -1) / 6 + inside * noise[n]),
       z = 6 + rise * (j + inside * noise[n + 1]))
  [radius(z) * cos(a), radius(z) * sin(a), z];

module strut(a, b) {
  hull() {
    translate(a) sphere(thick, $fn = 6);
    translate(b) sphere(thick, $fn = 6);
  }
}

color("ivory") for (i = [0:columns - 1], j = [0:rows - 1]) {
  if (j < rows - 1) strut(node(i, j), node(i, j + 1));
  if (is_even(i, j)) strut(node(i, j), node(i + 1, j));
}

function ring(z, inward, outward) = [[radius(z) - inward, z - 1.5], [radius(z) + outward, z - 1.5], [radius(z) + outward, z + 1.5], [radius(z) - inward, z + 1.5]];
color("sienna") {
  rotate_extrude($fn = 108) polygon([[0, 0], [radius(6) + 3, 0], [radius(6) + 3, 6], [radius(6) - 3, 6], [radius(6) - 4, 3], [0, 3]]);
  rotate_extrude($fn = 108) polygon(ring(6 + rise * (rows - 1), 2, 2));
}

// Letters around the foot.
words = "CONSTRUCTIVE SOLID GEOMETRY  1987  ";
color("gold") for (k = [0:len(words) - 1]) rotate(360 / len(words) * k) translate([radius(6) + 2.9, 0, 1.2]) rotate([90, 0, 90])
  linear_extrude(0.8) text(words[k], size = 4, font = "DejaVu Sans:style=Bold", halign = "center");
