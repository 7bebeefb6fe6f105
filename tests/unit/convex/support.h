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

/// A model faceted twice: the scene has the canonical planes under test, and each solid its own planes for the judge.
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

/// Whether the model contains the point, according to the tree's operators. Empty if the point is too close to a plane
/// to decide.
std::optional<bool> contains_point(const TestModel& model, const glm::dvec3& point);

/// Longest stretch inside the model between crossings of planes, in parameters of the segment; 0 if there is none.
double longest_segment_inside(const TestModel& model, const glm::dvec3& from, const glm::dvec3& to);

/// normal . p + offset of a half-space's outward plane; the point is in model space.
double signed_distance(const facet::Geometry& scene, facet::Halfspace halfspace, const glm::dvec3& point);

/// Maximum signed distance from the faces; negative inside.
double signed_distance(const facet::Geometry& scene, const convex::Polytope& polytope, const glm::dvec3& point);

/// First fault of a polytope as a structure: edges without exactly two faces, vertices off their faces' planes or
/// beyond others, or a violation of Euler's formula. Empty if there is none. `slack` is in tolerances.
std::string describe_flaws(const facet::Geometry& scene, const convex::Polytope& polytope, double slack = 1.01);

/// Random points and numbers that are the same on every platform.
class RandomPoints {
 public:
  explicit RandomPoints(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high);
  std::size_t below(std::size_t limit) { return engine_() % limit; }
  /// Random point in a box that is enlarged by half its size on all sides.
  glm::dvec3 around(const facet::Box& box);
  glm::dvec3 direction();

 private:
  std::mt19937_64 engine_;
};

}  // namespace csgsim::testing
