#include "host/csg/locate.h"

#include <rapidcheck.h>

#include "tests/support/test.h"

using namespace csgsim;
using csg::Containment;

TEST_CASE("an unrepresentable plane decides a block only where rounding cannot matter") {
  CHECK(rc::check([] {
    const double scale = *rc::gen::element(0.01, 1.0, 1e3, 1e9);
    const auto real = [&](int most) { return scale * *rc::gen::inRange(-most, most) / 16.0; };
    view::View view;
    view.sampling.width = 64;
    view.sampling.height = 47;
    view::ScreenPlane plane;
    plane.representable = false;
    plane.kind = *rc::gen::element(view::PlaneKind::surface, view::PlaneKind::edge);
    plane.real = {real(100), real(100), real(2000)};
    view.planes.push_back(plane);
    const facet::Halfspace halfspace{0, *rc::gen::arbitrary<bool>()};
    csg::Block block{{*rc::gen::inRange(0, 32), *rc::gen::inRange(0, 24), *rc::gen::inRange(32, 64), 46}, 0, 0};
    block.z_low = *rc::gen::inRange(0, 1 << 12);
    block.z_high = block.z_low + *rc::gen::inRange(0, 1 << 12);

    const auto at = [&](int x, int y) {
      return plane.real.at_centre + plane.real.a * (x - 31.5) + plane.real.b * (y - 23.0);
    };
    const view::PixelRect& pixels = block.pixels;
    const std::array<double, 4> corners{at(pixels.x0, pixels.y0), at(pixels.x1, pixels.y0), at(pixels.x0, pixels.y1),
                                        at(pixels.x1, pixels.y1)};
    const auto [low, high] = std::minmax_element(corners.begin(), corners.end());
    // Depths up to z_low are in front of the block for a surface, and depths beyond z_high behind it.
    const bool edge = plane.kind == view::PlaneKind::edge;
    const double before = edge ? 0.0 : static_cast<double>(block.z_low);
    const double behind = edge ? 0.0 : static_cast<double>(block.z_high);
    const double doubt = 3.0 + 1e-8 * std::max(std::abs(*low), std::abs(*high));
    const bool same = plane.positive == halfspace.positive;
    // The half-space is behind a front face, or on the positive side of an edge.
    const Containment low_side = edge != same ? Containment::in : Containment::out;
    const Containment high_side = edge != same ? Containment::out : Containment::in;
    const Containment known = csg::locate(view, halfspace, block);
    if (*high > before + 1) RC_ASSERT(known != low_side);
    if (*low < behind) RC_ASSERT(known != high_side);
    if (*high < before - doubt) RC_ASSERT(known == low_side);
    if (*low > behind + doubt) RC_ASSERT(known == high_side);
  }));
}
