// Readers of the arguments of each node type.
// Used throughout host/read.
#pragma once

#include <string_view>

#include "host/flat/area.h"
#include "host/read/arguments.h"
#include "host/read/operands.h"

// Readers of node arguments, one per row in nodes.cpp; those of convex solids are beside their rows in solids.cpp.

namespace csgsim::read {

/// Returns a convex polyhedron without unused and duplicate points, with faces that run counter-clockwise as seen from
/// outside; any other polyhedron becomes convex pieces (host/solids/pieces.h). The result is empty if the polyhedron
/// has no faces, no volume, or a point that is not finite. Throws InputError at the face that prevents it from bounding
/// a solid.
Maker read_polyhedron(const Arguments& arguments);

// Nodes that are areas, or combine areas into one.
Maker read_square(const Arguments& arguments);
Maker read_circle(const Arguments& arguments);
Maker read_polygon(const Arguments& arguments);
Maker read_text(const Arguments& arguments);
Maker read_offset(const Arguments& arguments);

// Nodes that make a solid from an area.
Maker read_linear_extrude(const Arguments& arguments);
Maker read_rotate_extrude(const Arguments& arguments);

// Nodes that make a shape from all of their children.
Maker read_hull(const Arguments& arguments);
Maker read_minkowski(const Arguments& arguments);
Maker read_resize(const Arguments& arguments);
Maker read_projection(const Arguments& arguments);

// Nodes whose shape is in another file; see Arguments::file() for the errors.

/// import() of STL, OFF, AMF, 3MF, SVG and DXF files.
Maker read_import(const Arguments& arguments);

/// surface() of numbers and pictures.
Maker read_surface(const Arguments& arguments);

/// The area of a DXF file, read with the arguments `layer`, `origin`, $fn, $fa and $fs. Throws InputError without a
/// position.
flat::Area dxf_area(const Arguments& arguments, std::string_view bytes, double scale);

}  // namespace csgsim::read
