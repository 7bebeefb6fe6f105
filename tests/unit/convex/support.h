#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "host/convex/pieces.h"
#include "host/csg/positive_tree.h"
#include "host/facet/geometry.h"
#include "host/facet/solid.h"
#include "host/model/tree.h"

namespace csgsim::testing {

/// A model, faceted twice: the scene's canonical planes for what is tested, each solid's own planes for the judge.
struct TestModel {
  explicit TestModel(model::Tree from);
  explicit TestModel(const std::string& text);

  model::Tree tree;
  facet::Geometry scene;
  csg::PositiveTree positive;
  std::vector<facet::Solid> solids;

  [[nodiscard]] std::vector<convex::Piece> pieces() const { return convex::pieces(scene, positive); }
};

TestModel demo_model(const std::string& name);

/// Whether the model holds the point, by the tree's own operators. Nothing if the point is too near to a plane to say.
std::optional<bool> holds(const TestModel& model, const glm::dvec3& point);

/// Lengths, as parameters of the segment, of the stretches between crossings of planes that the model holds; the
/// longest. 0 if it holds none.
double longest_inside(const TestModel& model, const glm::dvec3& from, const glm::dvec3& to);

/// normal . p + offset of a half-space's outward plane, point in model space.
double height(const facet::Geometry& scene, facet::Halfspace halfspace, const glm::dvec3& point);

/// The greatest height above the faces; below 0 inside.
double height(const facet::Geometry& scene, const convex::Polytope& polytope, const glm::dvec3& point);

/// What is wrong with a polytope by its own description: edges of other than two faces, vertices off their faces'
/// planes or beyond others, Euler's formula. Empty if nothing. `slack` in tolerances.
std::string flaws(const facet::Geometry& scene, const convex::Polytope& polytope, double slack = 1.01);

/// Points and numbers that are the same everywhere.
class RandomPoints {
 public:
  explicit RandomPoints(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high);
  std::size_t below(std::size_t limit) { return engine_() % limit; }
  /// In a box grown by half its size to all sides.
  glm::dvec3 around(const facet::Box& box);
  glm::dvec3 direction();

 private:
  std::mt19937_64 engine_;
};

}  // namespace csgsim::testing
