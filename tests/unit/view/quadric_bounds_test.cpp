#include <rapidcheck.h>

#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "host/view/screen_quadric.h"
#include "tests/support/test.h"
#include "tests/unit/view/quadric_subject.h"

using namespace csgsim;
using namespace csgsim::test;

namespace {

/// A subject's scene and view.
struct Seen {
  facet::Geometry scene;
  view::View view;

  explicit Seen(const Subject& subject)
      : scene(facet::make_geometry(subject.tree, exact())),
        view(view::make_view(scene, subject.tree, subject.camera, subject.sampling)) {}
};

/// Whether middle and discriminant at a pixel are those of the scene's quadric within their bounds.
bool are_within_bounds(const Seen& seen, std::int32_t x, std::int32_t y) {
  const view::ScreenQuadric& quadric = seen.view.quadrics[0];
  const view::Sampling& sampling = seen.view.sampling;
  const Met met = meet(seen.scene.quadrics.quadrics()[0], seen.scene.quadrics.centre(),
                       view::eye_space(seen.view.camera, sampling), x, y);
  const Truth truth = truth_of(seen.view, met);
  const Real middle = ldexp(Real(quadric.middle.a * x + quadric.middle.b * y + quadric.middle.c),
                            -static_cast<int>(sampling.fraction_bits));
  const Real d = ldexp(Real(view::value_at(quadric.discriminant, x, y)), -static_cast<int>(quadric.discriminant_shift));
  const Real true_d = ldexp(truth.discriminant, -2 * static_cast<int>(quadric.unit));
  // Numbers of 113 bits lose 2^-113 of each term. Terms of the eye's place in the quadric, some 1e8 if it is far away,
  // leave a difference of 1e-6 or more: D, which is divided by its square, is below 2^60.
  const Real size = sqrt(abs(true_d)) + abs(truth.middle) + isa::depth_steps(sampling.z_bits);
  const Real noise = size * 1e-18;
  return abs(middle - truth.middle) <= quadric.middle_error + noise &&
         abs(d - true_d) <= quadric.discriminant_error + noise * size;
}

}  // namespace

TEST_CASE("a quadric's middle and discriminant are within their bounds of the true values") {
  int fit = 0;
  int inside = 0;
  const auto bounded = [&] {
    const Seen seen(random_subject());
    RC_ASSERT(seen.view.quadrics.size() == 1U);
    const view::ScreenQuadric& quadric = seen.view.quadrics[0];
    if (quadric.kind != view::ScreenQuadricKind::roots || quadric.pixels.empty()) return;
    ++fit;
    inside += quadric.eye_inside ? 1 : 0;
    for (int i = 0; i < 10; ++i) {
      const std::int32_t x = *rc::gen::inRange(quadric.pixels.x0, quadric.pixels.x1 + 1);
      const std::int32_t y = *rc::gen::inRange(quadric.pixels.y0, quadric.pixels.y1 + 1);
      RC_ASSERT(are_within_bounds(seen, x, y));
    }
  };
  for (int round = 0; round < 10; ++round) CHECK(rc::check(bounded));
  MESSAGE("with roots ", fit, ", of these from inside ", inside);
  CHECK((!testing::draws_usual_cases() || fit > 600));
  CHECK((!testing::draws_usual_cases() || inside > 0));
}

// The quadric's value at the eye, the common divisor, is 1e-9 of the terms whose difference it is, so that D would
// change by 20,000 with the model's last binary digits: its bound is relative to the scene's quadric.
TEST_CASE("a quadric's middle and discriminant are within bounds near the eye") {
  glm::dmat4 place(1.0);
  place[0] = {-0.30222739025581363, 0.40350680047607401, -2.9425074762668277, 0};
  place[1] = {-2.25547666596781, -1.9555056512303737, -0.036497104244834308, 0};
  place[2] = {-1.9323542623420134, 2.219389396053133, 0.50281914724184862, 0};
  place[3] = {3114.0615659411806, 12855.165030835014, -8836.9266018673898, 1};
  Subject subject;
  subject.tree = single(model::Cylinder{3.614, 3.209, 3.209, false, {}}, place);
  subject.camera = {{3118.9544076261927, 12848.747218806413, -8828.503509795994},
                    {3113.354030260497, 12854.10223462268, -8832.994852958274},
                    view::Projection::perspective};
  subject.sampling.width = 20;
  subject.sampling.height = 36;
  subject.sampling.z_bits = 21;
  subject.sampling.fraction_bits = 14;
  const Seen seen(subject);
  REQUIRE(seen.view.quadrics[0].kind == view::ScreenQuadricKind::roots);
  int beyond = 0;
  for (std::int32_t y = 0; y < 36; ++y) {
    for (std::int32_t x = 0; x < 20; ++x) beyond += are_within_bounds(seen, x, y) ? 0 : 1;
  }
  CHECK(beyond == 0);
}
