#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::read_test {

/// A statement of a random model. What of it counts depends on its kind.
struct RandomNode {
  enum class Kind { unite, subtract, intersect, place, paint, cube, sphere, cylinder, octahedron };
  Kind kind = Kind::unite;
  char modifier = ' ';   ///< one of " #%*"
  glm::dvec3 sizes{1};   ///< sides; or radius; or height and radii; or half axes
  glm::dvec3 shift{0};   ///< of a matrix
  glm::dvec3 scale{1};   ///< of a matrix, before its axes are turned round
  glm::dvec3 colour{0};  ///< outside [0, 1] too
  bool center = false;
  model::FacetControl facets;
  std::vector<RandomNode> children;
};

using RandomModel = std::vector<RandomNode>;

/// A model with at least one statement; to be called in a RapidCheck property.
RandomModel random_model();

/// The tree that a model means, made by the rules of read.h one node at a time.
model::Tree meaning_of(const RandomModel& model);

/// As OpenSCAD 2021.01 prints: all arguments by name, spaces, one node a line.
std::string print_named(const RandomModel& model);

/// Without spaces, arguments in another order or without names, 17 digits, diameters, comments.
std::string print_packed(const RandomModel& model);

}  // namespace csgsim::read_test
