#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// How an area is extruded along z.
struct LinearExtrude {
  double height = 100;
  bool center = false;       ///< from -height / 2, not from 0
  double twist = 0;          ///< degrees that the upper end is turned, clockwise as seen from above
  std::uint32_t slices = 0;  ///< 0 leaves their number to `facets`
  glm::dvec2 scale{1};       ///< of the upper end, after the turn; less than 0 counts as 0
  model::FacetControl facets{};
};

/// How an area of the x, z plane is turned around the z axis.
struct RotateExtrude {
  double angle = 360;  ///< degrees from the x axis, counter-clockwise; past a full turn either way it is one full turn
  model::FacetControl facets{};
};

/// The solid between an area and its turned and scaled copy, as OpenSCAD 2021.01 facets it: convex pieces that do not
/// overlap, whose faces say their planes. Straight sides: a piece a convex part of the area. Bent sides: each slice's
/// are two triangles a side of the outline, and what is between them is divided by planes of these triangles. None if
/// the height is not above 0. Throws InputError if there are too many slices or pieces, or they reach too far from the
/// origin (model/limits.h), and WorkError past the limit on work.
std::vector<model::Polyhedron> linear_extrude(const flat::Area& area, const LinearExtrude& extrusion,
                                              const Work& work = {});

/// A convex prism, frustum or pyramid less others.
struct HoledPrism {
  model::Polyhedron whole;
  std::vector<model::Polyhedron> holes;
};

/// linear_extrude() as a difference: if sides are straight, all outlines convex and all but one holes, and if convex
/// pieces would have twice as many half-spaces at least. The machine then draws the difference in fewer clocks.
std::optional<HoledPrism> holed_prism(const flat::Area& area, const LinearExtrude& extrusion);

/// The solid that an area turns through, as OpenSCAD 2021.01 facets it, in convex pieces as above: a convex part that
/// touches the axis along a side, and is nowhere narrower nearer to the axis, is one piece a half turn at most, or one
/// for a full turn; any other is one piece a fragment of the turn. None if the angle is 0. Throws InputError if the
/// area is on both sides of the axis, as OpenSCAD has it, or if there are too many pieces.
std::vector<model::Polyhedron> rotate_extrude(const flat::Area& area, const RotateExtrude& extrusion);

}  // namespace csgsim::solids
