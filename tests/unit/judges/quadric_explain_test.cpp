#include <rapidcheck.h>

#include "host/view/projection.h"
#include "hw/isa/facts.h"
#include "sim/judges/errors.h"
#include "sim/judges/explain.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"
#include "tests/unit/judges/scenery.h"

using namespace csgsim;
using namespace csgsim::testing;
using view::Projection;

namespace {

constexpr Size size{48, 36};

/// One curved solid in the host's integer coefficients.
struct Trial {
  Scenery scenery;
  view::View view;
  isa::Program program;
  judges::Truth truth;
  observe::Frame frame;

  Trial(const std::string& csg, const view::Camera& camera, const view::Sampling& sampling)
      : scenery(make_curved_scenery(csg, camera, size)),
        view(view::make_view(scenery.scene, scenery.tree, camera, sampling)) {
    program.shape = {size.width, size.height, 128};
    program.facts->depth_scale = view.depth;
    program.facts->compile.z_bits = sampling.z_bits;
    program.facts->compile.fraction_bits = sampling.fraction_bits;
    program.facts->compile.edge_on_fraction = sampling.edge_on_fraction;
    truth = judges::exact_truth(scenery.tree, scenery.scene, camera, size.width, size.height, view.depth);
    frame = {size.width, size.height, {}, {}, {}};
    for (std::int32_t y = 0; y < static_cast<std::int32_t>(size.height); ++y) {
      for (std::int32_t x = 0; x < static_cast<std::int32_t>(size.width); ++x) add(x, y);
    }
  }
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  [[nodiscard]] bool fits() const {
    return view.quadrics.front().kind != view::ScreenQuadricKind::unfit &&
           std::all_of(view.planes.begin(), view.planes.end(), [](const auto& plane) { return plane.representable; });
  }

  [[nodiscard]] judges::Errors judge() const {
    return judges::judge(truth, frame, program,
                         judges::Explainer(scenery.tree, scenery.scene, scenery.camera, program));
  }

  [[nodiscard]] std::uint32_t farthest() const { return (1U << program.facts->compile.z_bits) - 1; }

 private:
  struct Interval {
    std::int64_t front;
    std::int64_t back;
    bool any = true;
  };

  void cut(Interval& in, const view::ScreenPlane& plane, facet::Halfspace halfspace, std::int32_t x,
           std::int32_t y) const {
    const std::int64_t value = plane.linear.a * x + plane.linear.b * y + plane.linear.c;
    const std::int64_t depth = value >> view.sampling.fraction_bits;
    switch (view::side_of(plane, halfspace)) {
      case view::Side::front: in.front = std::max(in.front, depth); break;
      case view::Side::back: in.back = std::min(in.back, depth); break;
      case view::Side::edge_positive: in.any = in.any && value >= 0; break;
      case view::Side::edge_negative: in.any = in.any && value < 0; break;
    }
  }

  void cut(Interval& in, const view::ScreenQuadric& quadric, facet::QuadricSide side, std::int32_t x,
           std::int32_t y) const {
    const std::int64_t d = view::value_at(quadric.discriminant, x, y) >> quadric.discriminant_shift;
    const view::QuadricRole role = view::role_of(quadric, side);
    if (d < 0) {
      in.any = in.any && role == view::QuadricRole::until;
      return;
    }
    const std::int64_t middle =
        (quadric.middle.a * x + quadric.middle.b * y + quadric.middle.c) >> view.sampling.fraction_bits;
    const std::int64_t root = view::floor_root(d);
    const std::int64_t near = middle - (root << quadric.unit);
    const std::int64_t far = middle + ((root + 1) << quadric.unit);
    switch (role) {
      case view::QuadricRole::between:
        in.front = std::max(in.front, near);
        in.back = std::min(in.back, far);
        break;
      case view::QuadricRole::until: in.back = std::min(in.back, near); break;
      case view::QuadricRole::from: in.front = std::max(in.front, far); break;
      case view::QuadricRole::edge: break;
    }
  }

  void add(std::int32_t x, std::int32_t y) {
    const facet::Convex& solid = scenery.scene.solids.front();
    const view::PixelRect& rect = view.extents.front().pixels;
    Interval in{0, farthest()};
    for (const facet::Halfspace& one : solid.halfspaces) cut(in, view.planes[one.plane], one, x, y);
    for (const facet::QuadricSide& one : solid.quadrics) cut(in, view.quadrics[one.quadric], one, x, y);
    const bool in_rect = rect.x0 <= x && x <= rect.x1 && rect.y0 <= y && y <= rect.y1;
    const bool seen = in.any && in_rect && in.front < in.back;
    frame.depth.push_back(seen ? static_cast<std::uint32_t>(in.front) : farthest());
    frame.owner.push_back(seen ? 0 : observe::no_owner);
    frame.colour.push_back(0);
  }
};

double number(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0; }

std::string any_solid() {
  const double r = number(1, 4);
  const double h = number(1, 6);
  const int kind = *rc::gen::inRange(0, 4);
  std::string part = ball({0, 0, 0}, r, 64);
  if (kind == 1) part = cylinder({0, 0, -h / 2}, h, r, r, 64);
  if (kind == 2) part = cylinder({0, 0, -h / 2}, h, r, number(0, 4), 64);
  if (kind == 3) part = cylinder({0, 0, -h / 2}, h, 0, r, 64);
  const std::string wide = with_transform(scaling({number(1, 3) / 2, number(1, 3), number(1, 2)}), part);
  const std::string turned = with_transform(rotation(number(-180, 180), number(-180, 180)), wide);
  return with_transform(translation({number(-3, 3), number(-3, 3), number(-3, 3)}), turned);
}

const view::Camera oblique{{15, -22, 17}, {0, 0, 0}, Projection::orthographic};
const view::Camera near_by{{15, -22, 17}, {0, 0, 0}, Projection::perspective};
const view::Camera from_before{{0, -30, 0}, {0, 0, 0}, Projection::orthographic};
const view::Camera amid{{0.25, -1, 0.5}, {0, 3, 0}, Projection::perspective};

view::Sampling picture(unsigned z_bits, unsigned fraction_bits) {
  view::Sampling sampling;
  sampling.width = size.width;
  sampling.height = size.height;
  sampling.z_bits = z_bits;
  sampling.fraction_bits = fraction_bits;
  return sampling;
}

/// An Explainer for a square picture with the given side and a depth range of twice `reach`.
judges::Explainer straight_explainer(const Scenery& scenery, std::uint32_t side, double reach, unsigned z_bits,
                                     unsigned fraction_bits) {
  isa::Program program;
  program.shape = {side, side, 128};
  program.facts->depth_scale = {false, straight_distance(side) - reach, straight_distance(side) + reach};
  program.facts->compile.z_bits = z_bits;
  program.facts->compile.fraction_bits = fraction_bits;
  program.facts->compile.edge_on_fraction = 1.0 / 256;
  return {scenery.tree, scenery.scene, scenery.camera, program};
}

}  // namespace

TEST_CASE("a curved solid in integer coefficients has no unexplained pixels") {
  std::uint64_t covered = 0;
  std::uint64_t wrong = 0;
  CHECK(rc::check([&] {
    const unsigned fraction_bits = *rc::gen::element(2U, 6U, 12U);
    const unsigned z_bits = *rc::gen::element(8U, 12U, 20U, 26U);
    const Trial trial(any_solid(), *rc::gen::element(oblique, near_by, from_before, amid),
                      picture(z_bits, fraction_bits));
    RC_PRE(trial.fits());
    const judges::Errors errors = trial.judge();
    RC_ASSERT(errors.unexplained == 0U);
    if (fraction_bits < 12 || z_bits < 12) return;
    covered += errors.covered;
    wrong += errors.wrong();
  }));
  // Coarse coefficients may give a quarter of a solid's pixels wrong values, fine ones hardly any.
  CHECK((!testing::draws_usual_cases() || covered > 1000));
  CHECK((!testing::draws_usual_cases() || wrong <= covered / 20));
}

TEST_CASE("depths two steps off and missing spheres are not explained") {
  for (const view::Camera& camera : {oblique, near_by}) {
    Trial trial(ball({1, 0, 0}, 4, 64), camera, picture(20, 12));
    const std::size_t middle = 18 * size.width + 24;
    REQUIRE(trial.judge().unexplained == 0);
    REQUIRE(trial.truth.owner[middle] == 0);
    const std::uint32_t right = trial.frame.depth[middle];
    for (const std::uint32_t depth : {right - 2, right + 2}) {
      trial.frame.depth[middle] = depth;
      CHECK(trial.judge().depth == 1);
      CHECK(trial.judge().unexplained == 1);
    }
    trial.frame.depth[middle] = trial.farthest();
    trial.frame.owner[middle] = observe::no_owner;
    CHECK(trial.judge().unexplained == 1);
    // Background must not show a primitive.
    trial.frame.depth[middle] = right;
    trial.frame.owner[middle] = trial.frame.owner[0] = 0;
    trial.frame.depth[0] = right;
    CHECK(trial.judge().unexplained == 1);
  }
}

TEST_CASE("a sphere shifted by a twentieth of a pixel is not explained") {
  const double aside = 0.05 * 2.0 * view::half_height(oblique) / size.height;
  const glm::dvec3 by = view::basis(oblique).right * aside;
  const std::string model = ball({1, 0, 0}, 4, 64);
  Trial trial(model, oblique, picture(20, 12));
  const Trial other(model, {oblique.eye + by, oblique.centre + by, Projection::orthographic}, picture(20, 12));
  trial.frame = other.frame;
  CHECK(trial.judge().unexplained > 100);
}

TEST_CASE("only a ray exactly on a sphere's outline may hit or miss it") {
  // The middle column of an odd picture is on the left side.
  const Scenery scenery = make_curved_scenery(ball({4, 0, 0}, 4, 64), straight_camera(21), {21, 21});
  const judges::Explainer explainer = straight_explainer(scenery, 21, 4, 20, 12);
  // Half of the 2^20 - 4 steps after the first.
  constexpr std::uint32_t half_way = (1U << 19) - 1;
  CHECK(explainer.may_show(10, 10, 0, half_way));
  CHECK(explainer.may_show(10, 10, judges::nothing, (1 << 20) - 1));
  CHECK_FALSE(explainer.may_show(11, 10, judges::nothing, (1 << 20) - 1));
  CHECK_FALSE(explainer.may_show(9, 10, 0, half_way));
  CHECK_FALSE(explainer.may_show(10, 10, 0, half_way - 2000));
}

TEST_CASE("a primitive never appears outside the rectangle of its vertices") {
  const Scenery scenery = make_curved_scenery(ball({0, 0, 0}, 4, 64), straight_camera(41), {41, 41});
  const judges::Explainer explainer = straight_explainer(scenery, 41, 4, 4, 0);
  CHECK(explainer.may_show(20, 20, 0, 1));
  for (const std::uint32_t column : {27U, 13U, 0U, 40U}) {
    for (std::uint32_t depth = 0; depth < 15; ++depth) CHECK_FALSE(explainer.may_show(column, 20, 0, depth));
    CHECK(explainer.may_show(column, 20, judges::nothing, 15));
  }
}

TEST_CASE("a cone seen along its axis has its depths around the middle of the range") {
  const std::string cone = with_transform(rotation(-90, 0), cylinder({0, 0, 0}, 8, 0, 6, 64));
  const Scenery scenery = make_curved_scenery(cone, straight_camera(21), {21, 21});
  const judges::Explainer explainer = straight_explainer(scenery, 21, 8, 20, 12);
  // Three pixels from the axis the surface is 4 units behind the apex.
  constexpr std::uint32_t there = 1 + ((1U << 20) - 4) / 4 * 3;
  CHECK((explainer.may_show(13, 10, 0, there) || explainer.may_show(13, 10, 0, there - 1)));
  CHECK_FALSE(explainer.may_show(13, 10, 0, there + 100));
  CHECK_FALSE(explainer.may_show(13, 10, 0, 0));
  CHECK_FALSE(explainer.may_show(13, 10, judges::nothing, (1 << 20) - 1));
}
