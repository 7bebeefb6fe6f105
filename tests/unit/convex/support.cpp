#include "tests/unit/convex/support.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "host/convex/clip.h"
#include "host/read/read.h"
#include "places.h"

namespace csgsim::testing {

TestModel::TestModel(model::Tree from)
    : tree(std::move(from)), scene(facet::make_geometry(tree)), positive(csg::make_positive_tree(tree)) {
  for (const model::Primitive& primitive : tree.primitives) solids.push_back(facet::make_solid(primitive));
}

TestModel::TestModel(const std::string& text) : TestModel(read::read_csg_text(text, "test")) {}

TestModel demo_model(const std::string& name) {
  return TestModel(read::read_csg_file(std::filesystem::path(CSGSIM_SOURCE_DIR) / "tests/models" / (name + ".csg")));
}

namespace {

/// A point closer than this to a plane, relative to the diagonal, is not judged; far above the tolerance.
constexpr double doubtful = 1e-8;

bool evaluate(const model::Tree& tree, const std::vector<bool>& held) {
  std::vector<bool> value(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const model::Node& node = tree.nodes[i];
    value[i] = node.is_leaf ? held[node.primitive] : value[node.children.front()];
    for (std::size_t c = 1; c < node.children.size(); ++c) {
      const bool other = value[node.children[c]];
      switch (node.op) {
        case model::Operator::unite: value[i] = value[i] || other; break;
        case model::Operator::intersect: value[i] = value[i] && other; break;
        case model::Operator::subtract: value[i] = value[i] && !other; break;
      }
    }
  }
  return tree.root != model::no_index && value[tree.root];
}

/// Whether the model contains the point, and the point's distance from the nearest plane.
std::pair<bool, double> examine(const TestModel& model, const glm::dvec3& point) {
  std::vector<bool> held;
  double nearest = 1e300;
  for (const facet::Solid& solid : model.solids) {
    double highest = -1e300;
    for (const facet::Face& face : solid.faces) {
      const double signed_distance = glm::dot(face.plane.normal, point) + face.plane.offset;
      highest = std::max(highest, signed_distance);
      nearest = std::min(nearest, std::abs(signed_distance));
    }
    held.push_back(highest < 0.0);
  }
  return {evaluate(model.tree, held), nearest};
}

}  // namespace

std::optional<bool> contains_point(const TestModel& model, const glm::dvec3& point) {
  const auto [inside, nearest] = examine(model, point);
  if (nearest < doubtful * model.scene.planes.diagonal()) return std::nullopt;
  return inside;
}

double longest_segment_inside(const TestModel& model, const glm::dvec3& from, const glm::dvec3& to) {
  std::vector<double> crossings{0.0, 1.0};
  for (const facet::Solid& solid : model.solids) {
    for (const facet::Face& face : solid.faces) {
      const double here = glm::dot(face.plane.normal, from) + face.plane.offset;
      const double there = glm::dot(face.plane.normal, to) + face.plane.offset;
      if ((here < 0.0) != (there < 0.0)) crossings.push_back(here / (here - there));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  double longest = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const double middle = (crossings[i] + crossings[i + 1]) / 2.0;
    if (crossings[i + 1] - crossings[i] <= longest) continue;
    if (examine(model, from + middle * (to - from)).first) longest = crossings[i + 1] - crossings[i];
  }
  return longest;
}

double signed_distance(const facet::Geometry& scene, facet::Halfspace halfspace, const glm::dvec3& point) {
  const facet::Plane& plane = scene.planes.planes()[halfspace.plane];
  const double value = glm::dot(plane.normal, point - scene.planes.centre()) + plane.offset;
  return halfspace.positive ? value : -value;
}

double signed_distance(const facet::Geometry& scene, const convex::Polytope& polytope, const glm::dvec3& point) {
  double highest = -1e300;
  for (const convex::Face& face : polytope.faces)
    highest = std::max(highest, signed_distance(scene, face.halfspace, point));
  return highest;
}

std::string describe_flaws(const facet::Geometry& scene, const convex::Polytope& polytope, double slack) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
  std::vector<int> degrees(polytope.vertices.size(), 0);
  if (polytope.empty()) return polytope.vertices.empty() ? "" : "vertices without faces";
  const double near = slack * convex::tolerance(scene.planes);
  for (const convex::Face& face : polytope.faces) {
    if (std::set(face.corners.begin(), face.corners.end()).size() != face.corners.size())
      return "repeated corner in a face";
    if (face.corners.size() < 3) return "face with fewer than three corners";
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      ++directed[{face.corners[i], face.corners[(i + 1) % face.corners.size()]}];
      ++degrees[face.corners[i]];
      const glm::dvec3 corner = polytope.vertices[face.corners[i]] + scene.planes.centre();
      const double off = std::abs(signed_distance(scene, face.halfspace, corner));
      if (off > near) return fmt::format("corner {} off the plane of its face", off);
    }
    for (const glm::dvec3& vertex : polytope.vertices) {
      const double beyond = signed_distance(scene, face.halfspace, vertex + scene.planes.centre());
      if (beyond > near) return fmt::format("vertex {} outside a face", beyond);
    }
  }
  for (const auto& [edge, times] : directed) {
    const auto back = directed.find({edge.second, edge.first});
    if (times != 1 || back == directed.end()) return "edge without exactly two faces";
  }
  for (const int degree : degrees) {
    if (degree < 3) return "vertex with fewer than three faces";
  }
  if (polytope.vertices.size() + polytope.faces.size() != directed.size() / 2 + 2) return "Euler's formula is violated";
  return convex::edges(polytope).size() == directed.size() / 2 ? "" : "edges() finds others";
}

double RandomPoints::between(double low, double high) {
  return low + (high - low) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
}

glm::dvec3 RandomPoints::around(const facet::Box& box) {
  const glm::dvec3 half = (box.high - box.low) / 2.0;
  const glm::dvec3 low = box.low - half;
  const glm::dvec3 high = box.high + half;
  return {between(low.x, high.x), between(low.y, high.y), between(low.z, high.z)};
}

glm::dvec3 RandomPoints::direction() {
  for (;;) {
    const glm::dvec3 candidate{between(-1, 1), between(-1, 1), between(-1, 1)};
    const double length = glm::length(candidate);
    if (length > 0.1 && length <= 1.0) return candidate / length;
  }
}

}  // namespace csgsim::testing
