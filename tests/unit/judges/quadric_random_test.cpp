#include <rapidcheck.h>

#include "tests/numerics/solids.h"
#include "tests/support/test.h"
#include "tests/unit/judges/scenery.h"

using namespace csgsim;
using namespace csgsim::testing;
using judges::Truth;
using view::Projection;

namespace {

constexpr Size size{40, 30};

double number(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0; }

/// A sphere, cylinder, frustum or cone around the origin, stretched, sheared, rotated and moved.
std::string any_solid() {
  const double r = number(1, 4);
  const double h = number(1, 6);
  const int kind = *rc::gen::inRange(0, 5);
  std::string part;
  if (kind <= 1) part = ball({0, 0, 0}, r, 64);
  if (kind == 2) part = cylinder({0, 0, -h / 2}, h, r, r, 64);
  if (kind == 3) part = cylinder({0, 0, -h / 2}, h, r, number(0, 4), 64);
  if (kind == 4) part = cylinder({0, 0, -h / 2}, h, 0, r, 64);
  const std::string linear = fmt::format("[[{},{},{},0],[{},{},{},0],[{},{},{},0],[0,0,0,1]]", number(1, 2),
                                         number(-1, 1) / 4, number(-1, 1) / 4, number(-1, 1) / 4, number(1, 2),
                                         number(-1, 1) / 4, number(-1, 1) / 4, number(-1, 1) / 4, number(1, 2));
  const std::string turned =
      with_transform(rotation(number(-180, 180), number(-180, 180)), with_transform(linear, part));
  return with_transform(translation({number(-3, 3), number(-3, 3), number(-3, 3)}), turned);
}

std::string any_model() {
  std::vector<std::string> parts;
  const int count = *rc::gen::inRange(1, 5);
  for (int i = 0; i < count; ++i) parts.push_back(any_solid());
  const int how = *rc::gen::inRange(0, 3);
  if (how == 0) return unite(parts);
  return how == 1 ? subtract(parts) : intersect(parts);
}

view::Camera moved(const view::Camera& camera, double right, double up) {
  const view::Basis basis = view::basis(camera);
  const glm::dvec3 by = (basis.right * right + basis.up * up) * (2.0 * view::half_height(camera) / size.height);
  return {camera.eye + by, camera.centre + by, camera.projection, camera.up};
}

struct Agreement {
  int seen = 0;
  int clear = 0;
  int grazed = 0;
  int wrong = 0;
};

/// The exact picture must match the true one wherever that is stable under camera moves of a fraction of a pixel.
Agreement compare(const std::string& model, const view::Camera& camera, double near) {
  constexpr double little = 1e-5;
  const Scenery scenery = make_curved_scenery(model, camera, size, near);
  INFO(model);
  REQUIRE(scenery.scene.quadrics.quadrics().size() > 0);
  const Truth ours = exact(scenery);
  const Truth theirs = analytic(scenery);
  std::vector<Truth> moves;
  for (const double by : {-little, little}) {
    for (const auto& other : {moved(camera, by, by / 3), moved(camera, -by / 3, by)}) {
      moves.push_back(analytic({scenery.tree, scenery.scene, other, size.width, size.height, near}));
    }
  }
  Agreement agreement;
  for (std::size_t i = 0; i < ours.owner.size(); ++i) {
    if (ours.owner[i] != judges::nothing) ++agreement.seen;
    bool clear = true;
    double spread = 0;
    for (const Truth& move : moves) {
      clear = clear && move.owner[i] == theirs.owner[i] &&
              !(std::abs(move.distance[i] - theirs.distance[i]) > 1e-2 * theirs.distance[i]);
      if (clear && theirs.owner[i] != judges::nothing) {
        spread = std::max(spread, std::abs(move.distance[i] - theirs.distance[i]));
      }
    }
    if (!clear) {
      ++agreement.grazed;
      continue;
    }
    ++agreement.clear;
    // Analytic rays are moved by 1e-9 pixels, a ten-thousandth of the camera's move.
    const bool same_depth = ours.distance[i] == theirs.distance[i] || std::abs(ours.distance[i] - theirs.distance[i]) <=
                                                                          1e-10 * theirs.distance[i] + 1e-3 * spread;
    if (ours.owner[i] != theirs.owner[i] || !same_depth) ++agreement.wrong;
  }
  return agreement;
}

void check_models(const view::Camera& camera, double near) {
  Agreement total;
  CHECK(rc::check([&] {
    const Agreement one = compare(any_model(), camera, near);
    total.seen += one.seen;
    total.clear += one.clear;
    total.grazed += one.grazed;
    RC_ASSERT(one.wrong == 0);
  }));
  CHECK((!testing::draws_usual_cases() || total.seen > 5000));
  CHECK(total.grazed < total.clear / 500);
}

}  // namespace

TEST_CASE("the exact picture of random quadrics matches rays in long doubles") {
  check_models({{15, -22, 17}, {0, 0, 0}, Projection::orthographic}, 1);
  check_models({{15, -22, 17}, {0, 0, 0}, Projection::perspective}, 0.5);
}

TEST_CASE("the exact picture of quadrics along an axis matches rays in long doubles") {
  check_models({{0, -30, 0}, {0, 0, 0}, Projection::orthographic}, 1);
  check_models({{0, 0, 30}, {0, 0, 0}, Projection::perspective}, 1);
}

TEST_CASE("the exact picture of quadrics around the eye matches rays in long doubles") {
  check_models({{0.25, -1, 0.5}, {0, 3, 0}, Projection::perspective}, 0.125);
}
