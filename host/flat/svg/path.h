// SVG path data.
// Used by shapes.cpp.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "host/flat/area.h"
#include "host/flat/svg/stroke.h"

namespace csgsim::flat::svg {

/// The outlines of a path's data, as in OpenSCAD: a curve has 20 sides, an arc one side per 18 degrees plus four. A
/// subpath whose ends are more than 0.1 apart is drawn as its stroke; the last subpath is an exception if any subpath
/// is closed. Throws InputError for invalid data.
std::vector<Outline> read_path(std::string_view data, const Stroke& stroke, std::size_t max_corners);

/// An ellipse with 40 corners.
Outline ellipse(const glm::dvec2& centre, const glm::dvec2& radii);

/// A rectangle whose corners are rounded by quarter ellipses.
Outline rounded_rectangle(const glm::dvec2& low, const glm::dvec2& size, const glm::dvec2& radii);

}  // namespace csgsim::flat::svg
