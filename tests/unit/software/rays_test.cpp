#include "host/read/read.h"
#include "sim/software/rays/caster.h"
#include "tests/oracle/split_mix.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_scenes.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;
using software::Event;
using software::Interval;
using testing::Scene;

namespace {

__extension__ using Wide = __int128;

Wide floor_shifted(Wide number, unsigned bits) {
  const Wide unit = Wide{1} << bits;
  return number >= 0 ? number / unit : -((-number + unit - 1) / unit);
}

Wide value(const view::FixedLinear& linear, Wide x, Wide y) { return linear.a * x + linear.b * y + linear.c; }

Wide value(const view::FixedQuadratic& quadratic, Wide x, Wide y) {
  return quadratic.xx * x * x + quadratic.xy * x * y + quadratic.yy * y * y + value(quadratic.linear, x, y);
}

/// Integer square root by bisection.
Wide whole_root(Wide square) {
  Wide low = 0;
  Wide high = Wide{1} << 32;
  while (high - low > 1) {
    const Wide middle = (low + high) / 2;
    (middle * middle <= square ? low : high) = middle;
  }
  return low;
}

/// The depths front <= z < back of a primitive along a ray, by docs/numbers.md.
struct Depths {
  Wide front = 0;
  Wide back = 0;

  void begin(Wide depth) { front = std::max(front, depth); }
  void end(Wide depth) { back = std::min(back, depth); }
  void clear() { back = front; }
};

void cut_by_plane(Depths& depths, const view::View& view, const facet::Halfspace& halfspace, Wide x, Wide y) {
  const view::ScreenPlane& plane = view.planes[halfspace.plane];
  const Wide f = value(plane.linear, x, y);
  const bool is_positive = plane.positive == halfspace.positive;
  if (plane.kind == view::PlaneKind::edge) {
    if ((f >= 0) != is_positive) depths.clear();
    return;
  }
  const Wide z = floor_shifted(f, view.sampling.fraction_bits);
  if (is_positive) {
    depths.begin(z);
  } else {
    depths.end(z);
  }
}

/// Returns the depths at which a ray meets a quadric; none if it misses.
std::optional<Depths> met(const view::ScreenQuadric& quadric, unsigned fraction_bits, Wide x, Wide y) {
  const Wide v = value(quadric.discriminant, x, y);
  const Wide middle = floor_shifted(value(quadric.middle, x, y), fraction_bits);
  if (quadric.kind == view::ScreenQuadricKind::paraboloid) {
    if (v < 0) return std::nullopt;
    // Exact: k v is scaled by the fraction bits of the factor and the value.
    const unsigned bits = quadric.discriminant_shift + quadric.factor.fraction();
    const Wide half = quadric.factor.scaled() * v;
    return Depths{middle + floor_shifted(-half, bits), middle + floor_shifted(half, bits) + 1};
  }
  const Wide d = floor_shifted(v, quadric.discriminant_shift);
  if (d < 0) return std::nullopt;
  const Wide root = whole_root(d);
  const Wide unit = Wide{1} << quadric.unit;
  return Depths{middle - root * unit, middle + (root + 1) * unit};
}

void cut_by_quadric(Depths& depths, const view::View& view, const facet::QuadricSide& side, Wide x, Wide y) {
  const view::ScreenQuadric& quadric = view.quadrics[side.quadric];
  const view::QuadricRole role = view::role_of(quadric, side);
  if (role == view::QuadricRole::edge) {
    if (value(quadric.discriminant, x, y) < 0) depths.clear();
    return;
  }
  const std::optional<Depths> found = met(quadric, view.sampling.fraction_bits, x, y);
  if (role == view::QuadricRole::until) {
    if (found) depths.end(found->front);
  } else if (!found) {
    depths.clear();
  } else if (role == view::QuadricRole::from) {
    depths.begin(found->back);
  } else {
    depths.begin(found->front);
    depths.end(found->back);
  }
}

std::vector<Interval> intervals_at(const Scene& scene, std::int32_t x, std::int32_t y) {
  std::vector<Interval> intervals;
  for (std::uint32_t primitive = 0; primitive < scene.tree.primitives.size(); ++primitive) {
    const view::PixelRect& rectangle = scene.view.extents[primitive].pixels;
    if (x < rectangle.x0 || x > rectangle.x1 || y < rectangle.y0 || y > rectangle.y1) continue;
    Depths depths{0, (Wide{1} << scene.view.sampling.z_bits) - 1};
    const facet::Convex& solid = scene.geometry.solids[primitive];
    for (const facet::Halfspace& halfspace : solid.halfspaces) cut_by_plane(depths, scene.view, halfspace, x, y);
    for (const facet::QuadricSide& side : solid.quadrics) cut_by_quadric(depths, scene.view, side, x, y);
    if (depths.front < depths.back)
      intervals.push_back(
          {primitive, static_cast<std::uint32_t>(depths.front), static_cast<std::uint32_t>(depths.back)});
  }
  return intervals;
}

/// Ends of intervals in order, without those in front of the background.
std::vector<Event> events_of(const std::vector<Interval>& intervals, std::uint32_t farthest) {
  std::vector<Event> events;
  for (const Interval& interval : intervals) {
    events.push_back({interval.front, 2 * interval.primitive});
    if (interval.back != farthest) events.push_back({interval.back, 2 * interval.primitive + 1});
  }
  std::ranges::stable_sort(events, [](const Event& a, const Event& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.primitive() < b.primitive();
  });
  return events;
}

struct Tally {
  std::uint64_t scenes = 0;
  std::uint64_t refused = 0;
  std::uint64_t rays = 0;
  std::uint64_t intervals = 0;
  std::uint64_t events = 0;
};

/// Returns the fault in the rays of a scene; empty if none.
std::string find_fault(const Scene& scene, Tally& tally) {
  const software::RayCaster rays(scene.tree, scene.geometry, scene.view);
  software::RayCounts counts;
  Tally here;
  software::RayBand band;
  software::RayBand uncounted;
  for (std::uint32_t row = 0; row < rays.height(); row += software::band_rows) {
    rays.cast(row, band, &counts);
    rays.cast(row, uncounted);
    if (band.intervals != uncounted.intervals || band.events != uncounted.events)
      return "counted rays differ from uncounted ones";
    const std::uint32_t rows = std::min(software::band_rows, rays.height() - row);
    if (band.first_row != row || band.rows != rows || band.width != rays.width()) return "a band";
    for (std::uint32_t ray = 0; ray < rows * rays.width(); ++ray) {
      const auto x = static_cast<std::int32_t>(ray % rays.width());
      const auto y = static_cast<std::int32_t>(row + ray / rays.width());
      const std::vector<Interval> intervals = intervals_at(scene, x, y);
      const std::vector<Event> events = events_of(intervals, rays.farthest());
      if (!std::ranges::equal(band.intervals_of(ray), intervals)) return fmt::format("intervals at {}, {}", x, y);
      if (!std::ranges::equal(band.events_of(ray), events)) return fmt::format("events at {}, {}", x, y);
      ++here.rays;
      here.intervals += intervals.size();
      here.events += events.size();
    }
  }
  tally.rays += here.rays;
  tally.intervals += here.intervals;
  tally.events += here.events;
  if (counts.intervals != here.intervals || counts.events != here.events) return "counts";
  return "";
}

}  // namespace

TEST_CASE("rays meet the primitives of random scenes at the depths of the view's integers") {
  Tally tally;
  CHECK(testing::holds_in_random_scenes(
      tally, [](const Scene&) { return true; },
      [&](const Scene& scene, std::uint64_t /*seed*/) { return find_fault(scene, tally); }));
  MESSAGE(tally.scenes, " scenes, ", tally.refused, " refused, ", tally.rays, " rays, ", tally.intervals,
          " intervals, ", tally.events, " events");
  if (!testing::draws_usual_cases()) return;
  CHECK(tally.refused < tally.scenes / 10);
  CHECK(tally.intervals > tally.rays / 4);
  CHECK(tally.events < 2 * tally.intervals);  // some intervals end at the background
}
TEST_CASE("rays meet the thesis's objects at the depths of the view's integers") {
  Tally tally;
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    for (const testing::ThesisObject& one : testing::thesis_objects(projection)) {
      CAPTURE(one.name);
      CHECK(find_fault(testing::thesis_scene(one, 130, 45), tally) == "");
    }
  }
}
TEST_CASE("rays meet fast spheres at the depths of their integers") {
  Tally tally;
  std::uint64_t spheres = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    testing::Random random(seed);
    std::string csg;
    for (int i = 0; i < 5; ++i) {
      const auto at = [&] { return random.unit() * 16 - 8; };
      const double x = at();
      const double y = at();
      csg += fmt::format("multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,{}],[0,0,0,1]]){{sphere($fn=40,r={});}}\n", x, y,
                         at(), 1 + random.below(5));
    }
    view::Sampling sampling;
    sampling.width = 37;
    sampling.height = 29;
    sampling.z_bits = random.one_of({4U, 7U, 12U, 20U});
    const view::Camera camera{
        {24, -45, 35}, {0, 0, 0}, random.one_of({view::Projection::orthographic, view::Projection::perspective})};
    const Scene scene = testing::make_scene(read::read_csg_text(csg, "test"), camera, sampling,
                                            {.exact_curves = true, .fast_spheres = true});
    for (const view::ScreenQuadric& quadric : scene.view.quadrics)
      spheres += quadric.kind == view::ScreenQuadricKind::paraboloid ? 1U : 0U;
    CAPTURE(seed);
    CHECK(find_fault(scene, tally) == "");
  }
  CHECK(spheres > 100);
  CHECK(tally.intervals > 1000);
}
TEST_CASE("rays that meet more than 32 surfaces return them in order") {
  std::string csg;
  for (int i = 0; i < 40; ++i)
    csg += fmt::format("multmatrix([[1,0,0,0],[0,1,0,{}],[0,0,1,0],[0,0,0,1]]){{cube(size=[4,{},4],center=true);}}",
                       i * 7 % 40, 1 + i % 3);
  view::Sampling sampling;
  sampling.width = 21;
  sampling.height = 19;
  sampling.z_bits = 6;
  Tally tally;
  const Scene scene = testing::make_scene(read::read_csg_text(csg, "test"),
                                          {{0, -60, 1}, {0, 0, 0}, view::Projection::orthographic}, sampling);
  CHECK(find_fault(scene, tally) == "");
  CHECK(tally.events > 70);
}
