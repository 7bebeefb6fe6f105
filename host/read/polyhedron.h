#pragma once

#include <optional>

#include "host/model/tree.h"
#include "host/read/arguments.h"

namespace csgsim::read {

/// The solid of a `polyhedron` node: points that no face uses are left out, equal points are one, faces run
/// counter-clockwise seen from outside. Nothing if it has no faces, no volume or a point that is not finite. Throws
/// InputError at the face that keeps it from being closed, convex and of flat faces.
std::optional<model::Polyhedron> read_polyhedron(const Arguments& arguments);

}  // namespace csgsim::read
