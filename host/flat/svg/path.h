#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "host/flat/area.h"
#include "host/flat/svg/stroke.h"

namespace csgsim::flat::svg {

/// The outlines of a path's data, as OpenSCAD takes them: curves of 20 sides, arcs of one side an 18 degrees and four
/// more; subpaths that end more than 0.1 from where they began as what their stroke covers, but for the last one if any
/// subpath is closed. Throws InputError.
std::vector<Outline> read_path(std::string_view data, const Stroke& stroke, std::size_t max_corners);

/// An ellipse of 40 corners.
Outline ellipse(const glm::dvec2& centre, const glm::dvec2& radii);

/// A rectangle with corners rounded by quarters of ellipses.
Outline rounded_rectangle(const glm::dvec2& low, const glm::dvec2& size, const glm::dvec2& radii);

}  // namespace csgsim::flat::svg
