#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::flat::dxf {

/// What the groups of an entity say; what a number means depends on its type.
struct Entity {
  std::string type;
  std::size_t line = 0;    ///< in the file
  std::string layer;       ///< 8
  std::string name;        ///< 2: of a block or section
  std::vector<double> xs;  ///< 10 and 11
  std::vector<double> ys;  ///< 20 and 21
  double size = 0;         ///< 40: radius, or ratio of an ellipse's radii
  double first = 0;        ///< 41: start of an ellipse, radians; scale along x
  double second = 0;       ///< 42: end of an ellipse, radians; scale along y; the last bulge
  double start = 0;        ///< 50: start of an arc, or a turn, degrees
  double stop = 0;         ///< 51: end of an arc, degrees
  int flags = 0;           ///< 70
};

using Segment = std::array<glm::dvec2, 2>;
using Draw = std::function<void(const Segment&)>;

/// Whether it is an entity that is drawn, other than INSERT.
bool is_drawn(const std::string& type);

/// Draws such an entity by segments. Throws InputError where it lacks points or takes too many segments.
void draw(const Entity& entity, const model::FacetControl& facets, const Draw& draw_segment);

/// A point that the entity must have. Throws InputError.
glm::dvec2 point(const Entity& entity, std::size_t index);

}  // namespace csgsim::flat::dxf
