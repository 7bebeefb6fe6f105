// OpenSCAD's linear_extrude() and rotate_extrude() of 2-D areas.
// Used throughout host/solids and by host/read.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// Parameters of an extrusion along z.
struct LinearExtrude {
  double height = 100;
  bool center = false;       ///< whether the extrusion starts at -height / 2 instead of 0
  double twist = 0;          ///< rotation of the upper end in degrees, clockwise as seen from above
  std::uint32_t slices = 0;  ///< number of slices; 0 if it is derived from `facets`
  glm::dvec2 scale{1};       ///< scale of the upper end, applied after the rotation; negative values are treated as 0
  model::FacetControl facets{};
};

/// Parameters of a rotation of an area in the x, z plane around the z axis.
struct RotateExtrude {
  double angle = 360;  ///< degrees from the x axis, counter-clockwise; limited to one full turn either way
  model::FacetControl facets{};
};

/// The solid between an area and its rotated and scaled copy, faceted as in OpenSCAD 2021.01: convex pieces that do not
/// overlap, with the planes of their faces. Straight sides give one piece per convex part of the area. Bent sides give
/// two triangles per slice and side of the outline; the space between them is divided by the planes of these triangles.
/// Empty if the height is not above 0. Throws InputError if there are too many slices or pieces, or if they reach too
/// far from the origin (model/limits.h), and WorkError if the work limit is exceeded.
std::vector<model::Polyhedron> linear_extrude(const flat::Area& area, const LinearExtrude& extrusion,
                                              const Work& work = {});

/// A convex prism, frustum or pyramid from which other such solids are subtracted.
struct HoledPrism {
  model::Polyhedron whole;
  std::vector<model::Polyhedron> holes;
};

/// linear_extrude() as a difference. Requires straight sides and convex outlines, all but one of which are holes. The
/// convex pieces must have at least twice the half-spaces of the difference: the machine then draws the difference in
/// fewer clocks. Empty if a requirement is not met.
std::optional<HoledPrism> make_holed_prism(const flat::Area& area, const LinearExtrude& extrusion);

/// The solid that an area sweeps around the z axis, faceted as in OpenSCAD 2021.01, in convex pieces as above. A convex
/// part that touches the axis along a side, and never narrows towards the axis, becomes at most one piece per half
/// turn, or one piece for a full turn; any other part becomes one piece per fragment of the turn. Empty if the angle is
/// 0. Throws InputError if the area is on both sides of the axis, as OpenSCAD does, or if there are too many pieces.
std::vector<model::Polyhedron> rotate_extrude(const flat::Area& area, const RotateExtrude& extrusion);

}  // namespace csgsim::solids
