// DXF entities, and their conversion to segments.
// Used by dxf.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::flat::dxf {

/// The groups of an entity. The meaning of each number depends on the entity's type.
struct Entity {
  std::string type;
  std::size_t line = 0;    ///< line number in the file
  std::string layer;       ///< group 8
  std::string name;        ///< group 2: name of a block or section
  std::vector<double> xs;  ///< groups 10 and 11
  std::vector<double> ys;  ///< groups 20 and 21
  double size = 0;         ///< group 40: radius, or ratio of the radii of an ellipse
  double first = 0;        ///< group 41: start of an ellipse in radians, or scale along x
  double second = 0;       ///< group 42: end of an ellipse in radians, scale along y, or the last bulge
  double start = 0;        ///< group 50: start of an arc, or a rotation, in degrees
  double stop = 0;         ///< group 51: end of an arc, in degrees
  int flags = 0;           ///< group 70
};

using Segment = std::array<glm::dvec2, 2>;
using Draw = std::function<void(const Segment&)>;

/// Whether entities of this type other than INSERT are drawn.
bool is_drawn(const std::string& type);

/// Draws an entity as segments. Throws InputError if it lacks points or needs too many segments.
void draw(const Entity& entity, const model::FacetControl& facets, const Draw& draw_segment);

/// A required point of the entity. Throws InputError if it is missing.
glm::dvec2 point(const Entity& entity, std::size_t index);

}  // namespace csgsim::flat::dxf
