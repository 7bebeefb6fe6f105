#include <rapidcheck.h>

#include "host/csg/locate.h"
#include "host/csg/separation.h"
#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "tests/support/test.h"
#include "tests/unit/view/held.h"

using namespace csgsim;
using csg::Containment;

namespace {

double real(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0; }
glm::dvec3 vector(int low, int high) { return {real(low, high), real(low, high), real(low, high)}; }

model::Tree random_solid() {
  model::Tree tree;
  const double r1 = real(0, 4);
  const double r2 = *rc::gen::element(0.0, r1, real(1, 4));
  model::Shape shape = model::Sphere{real(1, 4), {}};
  if (*rc::gen::inRange(0, 3) > 0 && r1 + r2 > 0.0) shape = model::Cylinder{real(1, 9), r1, r2, true, {}};
  glm::dmat4 place(1.0);
  for (int i = 0; i < 3; ++i) place[i] += glm::dvec4(vector(-1, 1) * 0.8, 0.0);
  tree.primitives.push_back({shape, place, std::nullopt, {}});
  tree.nodes.push_back({true, model::Operator::unite, 0, {}});
  tree.root = 0;
  return tree;
}

}  // namespace

TEST_CASE("blocks of curved solids are classified correctly and extents contain them") {
  int classes_in_cell = 0;
  int known_out = 0;
  int held = 0;
  for (int round = 0; round < 5; ++round) {
    CHECK(rc::check([&] {
      const model::Tree tree = random_solid();
      facet::Faceting exact;
      exact.exact_curves = true;
      const facet::Geometry scene = facet::make_geometry(tree, exact);
      view::Sampling sampling;
      sampling.width = 14;
      sampling.height = 12;
      sampling.z_bits = static_cast<unsigned>(*rc::gen::inRange(4, 8));
      const glm::dvec3 look = vector(-3, 3);
      view::Camera camera{look + glm::normalize(vector(-4, 4) + glm::dvec3(0.0005)) * *rc::gen::element(2.0, 9.0, 60.0),
                          look,
                          *rc::gen::arbitrary<bool>() ? view::Projection::perspective : view::Projection::orthographic};
      if (camera.projection == view::Projection::orthographic) camera.eye = look + 5.0 * (camera.eye - look);
      const view::View view = view::make_view(scene, tree, camera, sampling);
      const view::Extent& extent = view.extents[0];
      if (extent.empty() || view.quadrics[0].kind == view::ScreenQuadricKind::unfit) return;
      const std::int64_t top = (std::int64_t{1} << sampling.z_bits) - 1;
      for (int i = 0; i < 20; ++i) {
        const std::int32_t x = *rc::gen::inRange(0, 14);
        const std::int32_t y = *rc::gen::inRange(0, 12);
        const std::int64_t z = *rc::gen::inRange<std::int64_t>(0, top);
        const csg::Block block{
            {x, y, std::min(13, x + *rc::gen::inRange(0, 4)), std::min(11, y + *rc::gen::inRange(0, 4))},
            z,
            std::min(top - 1, z + *rc::gen::inRange(0, 9))};
        int in = 0;
        int count = 0;
        for (std::int32_t py = block.pixels.y0; py <= block.pixels.y1; ++py) {
          for (std::int32_t px = block.pixels.x0; px <= block.pixels.x1; ++px) {
            for (std::int64_t pz = block.z_low; pz <= block.z_high; ++pz) {
              ++count;
              const view::PixelRect& own = extent.pixels;
              const bool is_inside = px >= own.x0 && px <= own.x1 && py >= own.y0 && py <= own.y1 &&
                                     test::is_held(view, scene.solids[0], px, py, pz);
              if (!is_inside) continue;
              ++in;
              const std::vector<glm::dvec3> place{glm::dvec3(px, py, static_cast<double>(pz))};
              if (!extent.corners.empty()) RC_ASSERT(!csg::separated(place, extent.corners));
            }
          }
        }
        const Containment known = csg::locate(view, scene, 0, block);
        if (known == Containment::in) RC_ASSERT(in == count);
        if (known == Containment::out) RC_ASSERT(in == 0);
        RC_ASSERT(csg::holds(view, scene, 0, block) == (known == Containment::in));
        classes_in_cell += known == Containment::in ? 1 : 0;
        known_out += known == Containment::out && in == 0 ? 1 : 0;
        held += in;
      }
    }));
  }
  MESSAGE("blocks in: ", classes_in_cell, ", blocks out: ", known_out, ", points inside: ", held);
  CHECK((!testing::draws_usual_cases() || classes_in_cell > 10));
  CHECK((!testing::draws_usual_cases() || known_out > 100));
  CHECK((!testing::draws_usual_cases() || held > 1000));
}
