#pragma once

#include <optional>
#include <string_view>

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "host/read/arguments.h"
#include "host/read/operands.h"

// Readers of the arguments of nodes, one a row in nodes.cpp.

namespace csgsim::read {

// Convex solids. Nothing if the solid is empty.
std::optional<model::Shape> read_cube(const Arguments& arguments);
std::optional<model::Shape> read_sphere(const Arguments& arguments);
std::optional<model::Shape> read_cylinder(const Arguments& arguments);

/// A convex polyhedron as it is, but points that no face uses are left out, equal points are one, and faces run
/// counter-clockwise seen from outside; any other in convex pieces (host/solids/pieces.h). Nothing if it has no faces,
/// no volume or a point that is not finite. Throws InputError at the face that keeps it from bounding a solid.
Maker read_polyhedron(const Arguments& arguments);

// Nodes that are areas, or make an area of others.
Maker read_square(const Arguments& arguments);
Maker read_circle(const Arguments& arguments);
Maker read_polygon(const Arguments& arguments);
Maker read_text(const Arguments& arguments);
Maker read_offset(const Arguments& arguments);

// Nodes that make a solid of an area.
Maker read_linear_extrude(const Arguments& arguments);
Maker read_rotate_extrude(const Arguments& arguments);

// Nodes that make a shape of what their children are together.
Maker read_hull(const Arguments& arguments);
Maker read_minkowski(const Arguments& arguments);
Maker read_resize(const Arguments& arguments);
Maker read_projection(const Arguments& arguments);

// Nodes that other files stand for, see Arguments::file().

/// import() of STL, OFF, AMF, 3MF, SVG and DXF files.
Maker read_import(const Arguments& arguments);

/// surface() of numbers and pictures.
Maker read_surface(const Arguments& arguments);

/// What a DXF file draws, as the arguments `layer`, `origin` and $fn, $fa, $fs say. Throws InputError without a place.
flat::Area dxf_area(const Arguments& arguments, std::string_view bytes, double scale);

}  // namespace csgsim::read
