#include "host/read/read.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/ray_model.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

constexpr double step = 1.0 / 256;
constexpr int steps = 24 * 256;
constexpr double gap = 3 * step;
constexpr int models = 60;
constexpr int rays = 12;

/// A model evaluated point by point.
struct Points {
  explicit Points(const std::string& csg)
      : tree(read::read_csg_text(csg, "random")), facets(facet::make_geometry(tree)), rules(tree) {}

  [[nodiscard]] bool hold(const glm::dvec3& point) const {
    std::vector<bool> held;
    for (const facet::Convex& solid : facets.solids) {
      held.push_back(std::all_of(solid.halfspaces.begin(), solid.halfspaces.end(), [&](const facet::Halfspace& h) {
        const facet::Plane& plane = facets.planes.planes()[h.plane];
        const double value = glm::dot(plane.normal, point - facets.planes.centre()) + plane.offset;
        return h.positive ? value <= 0.0 : value >= 0.0;
      }));
    }
    return rules.holds(held);
  }

  /// Random rays, and the first step along a ray, up to a length, inside the model.
  [[nodiscard]] std::optional<double> first_along(const testing::Ray& ray, double length) const {
    for (int i = 1; i < steps && i * step < length; ++i) {
      if (hold(ray.origin + i * step * ray.direction)) return i * step;
    }
    return std::nullopt;
  }

  model::Tree tree;
  facet::Geometry facets;
  testing::TreeRules rules;
};

class Rays {
 public:
  /// Returns a ray from outside a random model around the origin through a point near the origin.
  testing::Ray next() {
    const glm::dvec3 from = 12.0 * glm::normalize(place());
    return {from, glm::normalize(0.4 * place() - from)};
  }
  double length() { return 24.0 * unit_(engine_); }

 private:
  glm::dvec3 place() { return glm::dvec3(part(), part(), part()); }
  double part() { return 20.0 * unit_(engine_) - 10.0; }

  std::mt19937_64 engine_{7};
  std::uniform_real_distribution<double> unit_{0, 1};
};

/// Calls `check` with points, the ray model and many rays for each model.
template <class Check>
void with_random_rays(Check check) {
  Rays random;
  for (std::uint64_t seed = 1; seed <= models; ++seed) {
    CAPTURE(seed);
    const Points points(testing::random_model(seed, 2 + static_cast<unsigned>(seed % 7)));
    if (points.tree.root == model::no_index) continue;
    const testing::RayModel model(points.tree, points.facets);
    for (int i = 0; i < rays; ++i) check(points, model, random.next(), random.length());
  }
}

}  // namespace

TEST_CASE("the nearest surface is where marching first meets the model") {
  int met = 0;
  int missed = 0;
  with_random_rays([&](const Points& points, const testing::RayModel& model, const testing::Ray& ray, double) {
    const auto surfaces = model.surfaces(ray, {-std::numeric_limits<double>::infinity()}, gap).points;
    const std::optional<double> first = points.first_along(ray, 24);
    if (surfaces.empty()) {
      CHECK_FALSE(first);
      ++missed;
    } else if (surfaces.front().is_clear) {
      REQUIRE(first);
      CHECK(surfaces.front().t <= *first);
      CHECK(surfaces.front().t > *first - step);
      ++met;
    }
  });
  CHECK(met > 50);
  CHECK(missed > 50);
}

TEST_CASE("a path to a light is blocked where marching meets the model") {
  int blocked = 0;
  int free = 0;
  with_random_rays([&](const Points& points, const testing::RayModel& model, const testing::Ray& ray, double length) {
    const testing::Occlusion found = model.occlusion(ray, length, gap);
    if (!found.is_clear) return;
    CHECK(found.is_blocked == points.first_along(ray, length).has_value());
    ++(found.is_blocked ? blocked : free);
  });
  CHECK(blocked > 50);
  CHECK(free > 50);
}

TEST_CASE("surfaces facing a ray's far end are where marching leaves the model") {
  int left = 0;
  with_random_rays([&](const Points& points, const testing::RayModel& model, const testing::Ray& ray, double) {
    const testing::Ray back{ray.origin + 24.0 * ray.direction, -ray.direction};
    for (const testing::SurfacePoint& point : model.surfaces(back, {0}, gap).points) {
      if (!point.is_clear) break;
      CHECK(points.hold(back.origin + (point.t + step) * back.direction));
      const glm::dvec3 out = model.normal(point.primitive, point.halfspace);
      CHECK(glm::dot(out, back.direction) < 0.0);
      ++left;
    }
  });
  CHECK(left > 50);
}
