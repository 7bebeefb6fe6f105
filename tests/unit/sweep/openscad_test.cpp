#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>

#include "tests/unit/sweep/given.h"
#include "tests/unit/sweep/judge.h"

using namespace csgsim;

namespace {

/// Tolerance: OpenSCAD writes surfaces with 6 digits.
constexpr double printed = 1e-4;

const std::vector<std::string>& shapes() {
  static const std::vector<std::string> names = {
      "l_prism",        "l_center",       "nest_prism",      "star_half",      "star_point",     "hooked_grown",
      "l_turned_point", "hooked_twist",   "hooked_twist_fn", "star_wide",      "star_wide_fn",   "box_wide",
      "l_ridge",        "l_ridge_turned", "box_one_slice",   "l_one_slice",    "nest_one_slice", "star_back",
      "far_helix",      "far_cone",       "far_spread",      "star_grown",     "pawn_full",      "pawn_default",
      "pawn_quarter",   "pawn_back",      "pawn_most",       "cup_full",       "ring_full",      "ring_most",
      "ring_left",      "cup_left_back",  "ring_past_half",  "ring_past_full", "tipped_full",    "spool_full",
      "goblet_full",    "far_grown",      "corner_turned",   "corner_back",    "corner_spread",  "spool_most"};
  return names;
}

struct Box {
  glm::dvec3 low{1e300};
  glm::dvec3 high{-1e300};

  void add(const glm::dvec3& point) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
};

Box box_of(const testing::Mesh& mesh) {
  Box box;
  for (const glm::dvec3& point : mesh.points) box.add(point);
  return box;
}

glm::dvec3 random_point(std::mt19937& random, const Box& box) {
  const auto real = [&] { return static_cast<double>(random() % 1'000'003U) / 1'000'002.0; };
  const glm::dvec3 share(real(), real(), real());
  return box.low + share * (box.high - box.low);
}

/// Shapes with crossing sides, which enclose space twice or from the wrong side.
const std::vector<std::string>& crossed() {
  static const std::vector<std::string> names = {"quad_crossed", "frame_crossed"};
  return names;
}

/// Calls check(given, pieces) for each of the shapes.
template <class Check>
void for_each(const std::vector<std::string>& names, const Check& check) {
  for (const std::string& name : names) {
    CAPTURE(name);
    const testing::Given given = testing::read_given(name);
    check(given, testing::swept(given));
  }
}

}  // namespace

TEST_CASE("each piece of an extrusion is a closed convex polyhedron on its stated planes") {
  for_each(shapes(), [](const testing::Given&, const std::vector<model::Polyhedron>& pieces) {
    CHECK(!pieces.empty());
    for (const model::Polyhedron& piece : pieces) CHECK(testing::fault(piece) == "");
  });
}

TEST_CASE("the volumes of an extrusion's pieces add up to that of OpenSCAD's solid") {
  for_each(shapes(), [](const testing::Given& given, const std::vector<model::Polyhedron>& pieces) {
    double sum = 0;
    for (const model::Polyhedron& piece : pieces) sum += testing::volume(piece);
    const double expected = std::abs(testing::volume(given.surface));
    CHECK(sum == doctest::Approx(expected).epsilon(5e-5));
  });
}

TEST_CASE("an extrusion's pieces have the bounding box and corners of OpenSCAD's solid") {
  for_each(shapes(), [](const testing::Given& given, const std::vector<model::Polyhedron>& pieces) {
    const auto* linear = std::get_if<solids::LinearExtrude>(&given.sweep);
    Box box;
    std::vector<glm::dvec3> corners;
    for (const model::Polyhedron& piece : pieces)
      corners.insert(corners.end(), piece.points.begin(), piece.points.end());
    for (const glm::dvec3& corner : corners) box.add(corner);
    const Box expected = box_of(given.surface);
    CHECK(glm::length(box.low - expected.low) < printed);
    CHECK(glm::length(box.high - expected.high) < printed);
    // Slices of an unbent shape have corners inside its sides, and the sides below a line fold back on each other.
    const bool to_line =
        linear != nullptr && linear->scale.x * linear->scale.y == 0.0 && linear->scale.x != linear->scale.y;
    const auto is_between = [&](const glm::dvec3& point) {
      return point.z > expected.low.z + printed && point.z < expected.high.z - printed;
    };
    const bool is_sliced = linear == nullptr || std::any_of(corners.begin(), corners.end(), is_between);
    const auto is_hidden = [&](const glm::dvec3& point) {
      return (!is_sliced && is_between(point)) || (to_line && point.z > expected.high.z - printed);
    };
    for (const glm::dvec3& point : given.surface.points) {
      if (is_hidden(point)) continue;
      const bool is_corner = std::any_of(corners.begin(), corners.end(), [&](const glm::dvec3& corner) {
        return glm::length(corner - point) < printed;
      });
      CHECK_MESSAGE(is_corner, point.x, " ", point.y, " ", point.z);
    }
  });
}

namespace {

void check_points(const testing::Given& given, const std::vector<model::Polyhedron>& pieces) {
  std::mt19937 random(1);
  const Box box = box_of(given.surface);
  int tested = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 point = random_point(random, box);
    int times = 0;
    double nearest = 1e300;
    for (const model::Polyhedron& piece : pieces) {
      const testing::Membership membership = testing::membership(piece, point);
      times += membership.inside ? 1 : 0;
      nearest = std::min(nearest, membership.nearest);
    }
    if (nearest < printed) continue;
    ++tested;
    CHECK(times == (std::lround(testing::winding(given.surface, point)) == 0 ? 0 : 1));
  }
  CHECK(tested > 1000);
}

}  // namespace

TEST_CASE("a point inside OpenSCAD's extrusion is in exactly one piece and others in none") {
  for_each(shapes(), check_points);
}

TEST_CASE("an extrusion's pieces match OpenSCAD's surface where its sides cross") { for_each(crossed(), check_points); }

TEST_CASE("a wall between pieces of an extrusion is the identical plane on both sides") {
  for_each(shapes(), [](const testing::Given&, const std::vector<model::Polyhedron>& pieces) {
    for (const model::Polyhedron& piece : pieces) {
      for (std::size_t i = 0; i < piece.faces.size(); ++i) {
        glm::dvec3 middle(0);
        for (const std::uint32_t corner : piece.faces[i]) middle += piece.points[corner];
        middle /= static_cast<double>(piece.faces[i].size());
        const glm::dvec4& plane = piece.planes[i];
        const glm::dvec3 beyond = middle + 0.5 * printed * glm::dvec3(plane);
        const auto is_beyond = [&](const model::Polyhedron& other) {
          return &other != &piece && testing::membership(other, beyond).inside;
        };
        const auto other = std::find_if(pieces.begin(), pieces.end(), is_beyond);
        if (other == pieces.end()) continue;
        CHECK(std::find(other->planes.begin(), other->planes.end(), -plane) != other->planes.end());
      }
    }
  });
}
