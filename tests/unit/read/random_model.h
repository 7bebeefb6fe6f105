#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::read_test {

/// A statement of a random model. Its kind decides which members count.
struct RandomNode {
  enum class Kind { unite, subtract, intersect, place, paint, cube, sphere, cylinder, octahedron };
  Kind kind = Kind::unite;
  char modifier = ' ';   ///< one of " #%*"
  glm::dvec3 sizes{1};   ///< sides; or radius; or height and radii; or half axes
  glm::dvec3 shift{0};   ///< translation of a matrix
  glm::dvec3 scale{1};   ///< scale of a matrix, before its axes are permuted
  glm::dvec3 colour{0};  ///< includes values outside [0, 1]
  bool center = false;
  model::FacetControl facets;
  std::vector<RandomNode> children;
};

using RandomModel = std::vector<RandomNode>;

/// Returns a model with at least one statement; call it in a RapidCheck property.
RandomModel random_model();

/// Returns the tree of a model, built by the rules of read.h one node at a time.
model::Tree expected_tree(const RandomModel& model);

/// Prints like OpenSCAD 2021.01: all arguments by name, spaces, one node per line.
std::string print_named(const RandomModel& model);

/// Prints without spaces, with reordered or unnamed arguments, 17 digits, diameters and comments.
std::string print_packed(const RandomModel& model);

}  // namespace csgsim::read_test
