#include <rapidcheck.h>

#include "tests/numerics/solids.h"
#include "tests/support/test.h"
#include "tests/unit/judges/scenery.h"

using namespace csgsim;
using namespace csgsim::testing;
using judges::Truth;
using view::Projection;

namespace {

/// Coordinates on a grid of halves, so that many faces coincide.
double on_grid(int low, int high) { return 0.5 * *rc::gen::inRange(2 * low, 2 * high + 1); }

glm::dvec3 any_corner() { return {on_grid(-3, 2), on_grid(-3, 2), on_grid(-3, 2)}; }
glm::dvec3 any_extent() { return {on_grid(1, 4), on_grid(1, 4), on_grid(1, 4)}; }

/// A wedge with quadrilateral upright faces.
std::string wedge(const glm::dvec3& at, const glm::dvec3& extent) {
  const std::string unit =
      "polyhedron(points=[[0,0,0],[1,0,0],[1,1,0],[0,1,0],[0,0,1],[0,1,1]],"
      "faces=[[0,1,2,3],[0,4,1],[3,2,5],[0,3,5,4],[1,4,5,2]],convexity=1);";
  return with_transform(translation(at), with_transform(scaling(extent), unit));
}

std::string any_box() {
  const glm::dvec3 at = any_corner();
  return box(at, at + any_extent());
}

std::string any_solid() {
  const glm::dvec3 at = any_corner();
  const glm::dvec3 extent = any_extent();
  switch (*rc::gen::inRange(0, 4)) {
    case 0: return wedge(at, extent);
    case 1:
      return tetrahedron(at, at + glm::dvec3(extent.x, 0, 0), at + glm::dvec3(0, extent.y, 0),
                         at + glm::dvec3(0, 0, extent.z));
    default: return any_box();
  }
}

/// One of three exact orientations.
std::string any_placed(const std::string& solid) {
  switch (*rc::gen::inRange(0, 5)) {
    case 0: return with_transform(std::string(turns::right_angle), solid);
    case 1: return with_transform("[[1,0,0,0],[0,0,-1,0],[0,1,0,0],[0,0,0,1]]", solid);
    default: return solid;
  }
}

std::string any_tree(const std::function<std::string()>& solid, int primitives) {
  if (primitives == 1) return any_placed(solid());
  std::vector<std::string> parts;
  while (primitives > 0) {
    const int next = *rc::gen::inRange(1, parts.empty() ? primitives : primitives + 1);
    parts.push_back(any_tree(solid, next));
    primitives -= next;
  }
  switch (*rc::gen::inRange(0, 3)) {
    case 0: return unite(parts);
    case 1: return intersect(parts);
    default: return subtract(parts);
  }
}

/// A model that is not empty.
std::string any_model(const std::function<std::string()>& solid) {
  return unite({any_tree(solid, *rc::gen::inRange(1, 9)), any_placed(solid())});
}

/// Whether the pictures agree: owners everywhere, and distances to eight digits, except for a few rays that graze a
/// face, which agree to five.
bool agree(const std::string& csg, const view::Camera& camera, Size size, double near = 1) {
  const Scenery scenery = make_scenery(csg, camera, size, near);
  const Truth truth = analytic(scenery);
  const Truth flat = exact(scenery);
  if (truth.owner != flat.owner) return false;
  // An orthographic view may show surfaces at the eye.
  const double least = camera.projection == Projection::perspective ? 0 : glm::length(camera.centre - camera.eye);
  int grazing = 0;
  for (std::size_t i = 0; i < flat.owner.size(); ++i) {
    const double expected = flat.distance[i];
    if (flat.owner[i] == judges::nothing) continue;
    const double off = std::abs(truth.distance[i] - expected) / std::max(std::abs(expected), least);
    if (!(off <= 1e-5)) return false;
    grazing += off > 1e-8 ? 1 : 0;
  }
  constexpr int most_grazing = 2;
  return grazing <= most_grazing;
}

std::size_t covered(const std::string& csg, const view::Camera& camera, Size size) {
  std::size_t count = 0;
  for (const std::uint32_t owner : exact(make_scenery(csg, camera, size)).owner) {
    if (owner != judges::nothing) ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("flat solids look the same to the judges with and without facets") {
  CHECK(rc::check([] {
    const std::string model = with_transform(
        rotation(*rc::gen::inRange(0, 3600) / 10.0, *rc::gen::inRange(0, 3600) / 10.0), any_model(any_solid));
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
      RC_ASSERT(agree(model, {{19, -28, 21}, {0.3, 0.1, 0.2}, projection}, {40, 30}));
    }
  }));
}

TEST_CASE("boxes with edge-on faces through pixel centres look the same without facets") {
  // Only boxes are used: at oblique planes that end at a pixel centre the last bits of doubles decide.
  CHECK(rc::check([] {
    const std::string model = any_model(any_box);
    for (const glm::dvec3& eye : {glm::dvec3(0, -32, 0), glm::dvec3(32, 0, 0), glm::dvec3(0, 0, 32)}) {
      for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        RC_ASSERT(agree(model, {eye, {0, 0, 0}, projection}, {41, 31}));
      }
    }
  }));
}

TEST_CASE("flat solids around the eye look the same with and without facets") {
  CHECK(rc::check([] {
    const std::string model = any_model(any_solid);
    RC_ASSERT(agree(model, {{0.27, -1.13, 0.41}, {0, 3, 0}, Projection::perspective}, {40, 30}, 0.3));
    RC_ASSERT(agree(model, {{0.27, -1.13, 0.41}, {4, 13, -8}, Projection::orthographic}, {40, 30}));
  }));
}

TEST_CASE("the analytic judge gives faces within the plane tolerance one owner at any angle") {
  // The second front is nearer by less than the tolerance; half a degree from edge-on its depth difference is 100 times
  // as large.
  const std::string first = box({-5, 0, -5}, {5, 5, 5});
  for (const double nearer : {1e-15, 1e-13, 1e-11, 1e-10}) {
    CAPTURE(nearer);
    const std::string both = unite({first, box({-5, -nearer, -5}, {5, 4, 5})});
    for (const double degrees : {90.0, 20.0, 3.0}) {
      CAPTURE(degrees);
      const double angle = degrees * 0.017453292519943295;
      for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
        const view::Camera camera{{50 * std::cos(angle), -50 * std::sin(angle), 1}, {0, 0, 0}, projection};
        CHECK(agree(both, camera, {64, 48}));
        CHECK(covered(both, camera, {64, 48}) > 300);
      }
    }
  }
}

TEST_CASE("the analytic judge gives coincident faces at the eye's distance one owner") {
  const std::string first = box({-5, 0, -5}, {5, 5, 5});
  for (const double degrees : {0.0, 33.3, 111.1}) {
    CAPTURE(degrees);
    const std::string turn = rotation(degrees, 41.9);
    const std::string both =
        unite({with_transform(turn, first), with_transform(turn, box({-5, -1e-13, -5}, {5, 4, 5}))});
    const double angle = (41.9 - 90) * 0.017453292519943295;
    const glm::dvec3 along(-std::cos(angle), -std::sin(angle), 0);
    CHECK(agree(both, {{0, 0, 0}, 50.0 * along, Projection::orthographic}, {64, 48}));
  }
}
