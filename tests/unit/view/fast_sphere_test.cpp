#include "host/view/fast_sphere.h"

#include <rapidcheck.h>

#include <glm/gtc/matrix_transform.hpp>

#include "host/csg/locate.h"
#include "host/facet/curved.h"
#include "host/facet/geometry.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

double real(double low, double high) { return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6; }
glm::dvec3 vector(double size) { return {real(-size, size), real(-size, size), real(-size, size)}; }

facet::Faceting fast() {
  facet::Faceting faceting;
  faceting.exact_curves = true;
  faceting.fast_spheres = true;
  return faceting;
}

model::Tree sphere(double radius, const glm::dmat4& place) {
  model::Tree tree;
  tree.primitives.push_back({model::Sphere{radius, {}}, place, std::nullopt, {}});
  tree.nodes.push_back({true, model::Operator::unite, 0, {}});
  tree.root = 0;
  return tree;
}

/// A random sphere and its picture in doubles: column and row, radius in pixels, middle and radius in depth steps.
struct Subject {
  facet::Geometry scene;
  view::View view;
  double column = 0;
  double row = 0;
  double radius = 0;
  double middle = 0;
  double half_depth = 0;
};

Subject random_subject(std::uint32_t most_side) {
  glm::dmat4 place = glm::translate(glm::dmat4(1.0), vector(20));
  place = glm::rotate(place, real(0, 6.28), glm::normalize(vector(1) + glm::dvec3(1e-3)));
  const double scale = std::exp2(real(-3, 3));
  place = glm::scale(place, glm::dvec3(scale));
  const double own = real(0.05, 4);
  const model::Tree tree = sphere(own, place);
  Subject subject{facet::make_geometry(tree, fast()), {}};
  view::Sampling sampling;
  sampling.width = static_cast<std::uint32_t>(*rc::gen::inRange(8, static_cast<int>(most_side)));
  sampling.height = static_cast<std::uint32_t>(*rc::gen::inRange(8, static_cast<int>(most_side)));
  sampling.z_bits = static_cast<unsigned>(*rc::gen::inRange(4, 24));
  const glm::dvec3 centre(place[3]);
  const glm::dvec3 look = centre + vector(own * scale);
  const glm::dvec3 back = glm::normalize(vector(1) + glm::dvec3(1e-3)) * own * scale * std::exp2(real(1.5, 6));
  const view::Camera camera{look + back, look, view::Projection::orthographic};
  subject.view = view::make_view(subject.scene, tree, camera, sampling);
  const view::EyeSpace space = view::eye_space(camera, sampling);
  const glm::dvec3 in_eye = space.to_eye(centre);
  subject.column = (sampling.width - 1.0) / 2.0 + in_eye.x / space.pixel;
  subject.row = (sampling.height - 1.0) / 2.0 - in_eye.y / space.pixel;
  subject.radius = own * scale / space.pixel;
  const double step = (subject.view.depth.far - subject.view.depth.near) / (std::exp2(sampling.z_bits) - 4.0);
  subject.middle = 1.0 + (in_eye.z - subject.view.depth.near) / step;
  subject.half_depth = own * scale / step;
  return subject;
}

struct Depths {
  std::int64_t near;
  std::int64_t far;
};

/// Depths by the rule of host/view/screen_quadric.h.
Depths depths_at(const view::View& view, const view::ScreenQuadric& quadric, std::int64_t value) {
  const std::int64_t middle = quadric.middle.c >> view.sampling.fraction_bits;
  const unsigned shift = quadric.discriminant_shift + quadric.factor.fraction();
  const std::int64_t part = quadric.factor.scaled() * value;
  return {middle + (-part >> shift), middle + (part >> shift) + 1};
}

}  // namespace

TEST_CASE("a fast sphere is a circle within 1/256 pixel and 0.3 radius of the true sphere") {
  int fit = 0;
  int disc = 0;
  double worst = 0;
  for (int round = 0; round < 5; ++round) {
    CHECK(rc::check([&] {
      const Subject subject = random_subject(600);
      const view::ScreenQuadric& quadric = subject.view.quadrics.at(0);
      if (quadric.pixels.empty()) return;
      RC_ASSERT(quadric.kind == view::ScreenQuadricKind::paraboloid);
      ++fit;
      disc += quadric.factor.is_zero ? 1 : 0;
      for (int i = 0; i < 30; ++i) {
        const std::int32_t x = *rc::gen::inRange(quadric.pixels.x0, quadric.pixels.x1 + 1);
        const std::int32_t y = *rc::gen::inRange(quadric.pixels.y0, quadric.pixels.y1 + 1);
        const double away = std::hypot(x - subject.column, y - subject.row);
        const std::int64_t value = view::value_at(quadric.discriminant, x, y);
        if (subject.radius >= 1.0 / 3) {
          if (away < subject.radius - 1.0 / 256) RC_ASSERT(value >= 0);
          if (away > subject.radius + 1.0 / 256) RC_ASSERT(value < 0);
        }
        if (value < 0 || away > subject.radius) continue;
        const double true_half = subject.half_depth * std::sqrt(1.0 - away * away / subject.radius / subject.radius);
        const auto [near, far] = depths_at(subject.view, quadric, value);
        RC_ASSERT(near < far);
        // Rounding of the middle, rounding of a depth, and the step that keeps it inside.
        RC_ASSERT(static_cast<double>(near) >= subject.middle - subject.half_depth - 1e-6 * subject.half_depth - 1.0);
        RC_ASSERT(static_cast<double>(far) <= subject.middle + subject.half_depth + 1e-6 * subject.half_depth + 1.0);
        const double behind = static_cast<double>(near) - (subject.middle - true_half);
        const double before = subject.middle + true_half - static_cast<double>(far);
        // A sphere only a few steps deep may lose all of its depth.
        RC_ASSERT(std::max(behind, before) <= 0.3 * subject.half_depth + 4.0);
        RC_ASSERT(std::min(behind, before) >= -4.0);
        if (subject.half_depth > 1e4) worst = std::max(worst, behind / subject.half_depth);
      }
    }));
  }
  MESSAGE(fit, " in the picture, ", disc, " of them without depth; at most ", worst, " of the radius behind");
  CHECK((!testing::draws_usual_cases() || fit > 200));
  CHECK((!testing::draws_usual_cases() || worst > 0.2));
}

TEST_CASE("the ranges and blocks and extents of fast spheres contain their depths") {
  int in_blocks = 0;
  int out_blocks = 0;
  for (int round = 0; round < 5; ++round) {
    CHECK(rc::check([&] {
      const Subject subject = random_subject(40);
      const view::View& view = subject.view;
      const view::ScreenQuadric& quadric = view.quadrics.at(0);
      const view::Extent& extent = view.extents.at(0);
      if (extent.empty()) return;
      const std::int32_t x0 = *rc::gen::inRange(extent.pixels.x0, extent.pixels.x1 + 1);
      const std::int32_t y0 = *rc::gen::inRange(extent.pixels.y0, extent.pixels.y1 + 1);
      const view::PixelRect rect{x0, y0, std::min(extent.pixels.x1, x0 + *rc::gen::inRange(0, 8)),
                                 std::min(extent.pixels.y1, y0 + *rc::gen::inRange(0, 8))};
      const std::int64_t top = (std::int64_t{1} << view.sampling.z_bits) - 1;
      const std::int64_t z = *rc::gen::inRange<std::int64_t>(0, top);
      const csg::Block block{rect, z, std::min(top - 1, z + *rc::gen::inRange<std::int64_t>(0, 1 + top / 8))};
      const csg::Containment known = csg::locate(view, subject.scene, 0, block);
      in_blocks += known == csg::Containment::in ? 1 : 0;
      out_blocks += known == csg::Containment::out ? 1 : 0;
      const view::RootRanges ranges = view::ranges_over(quadric, view.sampling.fraction_bits, rect);
      for (std::int32_t y = 0; y < static_cast<std::int32_t>(view.sampling.height); ++y) {
        for (std::int32_t x = 0; x < static_cast<std::int32_t>(view.sampling.width); ++x) {
          const std::int64_t value = view::value_at(quadric.discriminant, x, y);
          const auto [near, far] = depths_at(view, quadric, value);
          const bool in_rect = x >= rect.x0 && x <= rect.x1 && y >= rect.y0 && y <= rect.y1;
          if (value >= 0) {
            const bool in_extent =
                x >= extent.pixels.x0 && x <= extent.pixels.x1 && y >= extent.pixels.y0 && y <= extent.pixels.y1;
            RC_ASSERT(in_extent);
            RC_ASSERT(std::max<std::int64_t>(0, near) >= extent.z_low);
            RC_ASSERT(std::min(top, far - 1) <= extent.z_high);
          }
          if (!in_rect) continue;
          if (value >= 0) {
            RC_ASSERT(near >= ranges.near.low);
            RC_ASSERT(near <= ranges.near.high);
            RC_ASSERT(far >= ranges.far.low);
            RC_ASSERT(far <= ranges.far.high);
          }
          const bool all_in = value >= 0 && near <= block.z_low && block.z_high < far;
          const bool all_out = value < 0 || near > block.z_high || far <= block.z_low;
          if (known == csg::Containment::in) RC_ASSERT(all_in);
          if (known == csg::Containment::out) RC_ASSERT(all_out);
        }
      }
    }));
  }
  MESSAGE("blocks in ", in_blocks, ", out ", out_blocks);
  CHECK((!testing::draws_usual_cases() || in_blocks > 5));
  CHECK((!testing::draws_usual_cases() || out_blocks > 50));
}

TEST_CASE("keeps_balls() accepts rotations and reflections and uniform scales to 6 digits") {
  CHECK(rc::check([] {
    glm::dmat4 place = glm::translate(glm::dmat4(1.0), vector(20));
    place = glm::rotate(place, real(0, 6.28), glm::normalize(vector(1) + glm::dvec3(1e-3)));
    const double scale = std::exp2(real(-2, 3)) * *rc::gen::element(-1.0, 1.0);
    place = glm::scale(place, glm::dvec3(scale));
    RC_ASSERT(facet::keeps_balls(place));
    glm::dmat4 written = place;
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row) written[column][row] = std::round(place[column][row] * 1e6) / 1e6;
    if (std::abs(scale) >= 0.5) RC_ASSERT(facet::keeps_balls(written));
    glm::dmat4 longer = place;
    longer[*rc::gen::inRange(0, 3)] *= 1.001;
    RC_ASSERT(!facet::keeps_balls(longer));
    glm::dmat4 askew = place;
    askew[0] += 0.001 * place[1];
    RC_ASSERT(!facet::keeps_balls(askew));
  }));
}

TEST_CASE("only uniformly scaled spheres in orthographic views become fast spheres") {
  const glm::dmat4 longer = glm::scale(glm::dmat4(1.0), {1, 1, 2});
  CHECK(facet::make_geometry(sphere(1, glm::dmat4(1.0)), fast()).quadrics.quadrics().size() == 1);
  CHECK(facet::make_geometry(sphere(1, longer), fast()).quadrics.quadrics().empty());
  model::Tree cylinder = sphere(1, glm::dmat4(1.0));
  cylinder.primitives[0].shape = model::Cylinder{1, 1, 1, false, {}};
  CHECK(facet::make_geometry(cylinder, fast()).quadrics.quadrics().empty());
  model::Tree cube = sphere(1, glm::dmat4(1.0));
  std::get<model::Sphere>(cube.primitives[0].shape).facets.fn = 6;
  CHECK(facet::make_geometry(cube, fast()).quadrics.quadrics().empty());
  const model::Tree ball = sphere(1, glm::dmat4(1.0));
  const view::Camera camera{{0, -9, 0}, {0, 0, 0}, view::Projection::perspective};
  CHECK(view::make_view(facet::make_geometry(ball, fast()), ball, camera, {}).quadrics[0].kind ==
        view::ScreenQuadricKind::unfit);
}
