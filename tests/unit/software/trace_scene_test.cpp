// Hand-calculated rays of pixels, facets that they pierce, and reported surfaces.

#include "sim/software/tracing/trace_scene.h"

#include <glm/vec3.hpp>

#include "host/read/read.h"
#include "host/view/eye_space.h"
#include "sim/software/coherences/sequences.h"
#include "sim/software/methods/counts.h"
#include "sim/software/tracing/piercing.h"
#include "sim/software/tracing/secondary_rays.h"
#include "sim/software/tracing/trace.h"
#include "sim/software/tree/tree.h"
#include "tests/support/test.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;
using software::SpaceRay;
using software::TraceScene;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A model in a picture of 64 by 48 pixels.
struct Staged {
  testing::Scene scene;
  software::Tree tree = software::make_tree(scene.tree, software::Shape::written);
  TraceScene traced{scene.tree, scene.geometry, scene.view, tree};

  [[nodiscard]] software::Traced pixels(const software::TraceOptions& options, bool counts = true) const {
    const auto space = software::directory_of("excell").make(traced.shapes(), {8});
    return software::trace(traced, *space, options, counts);
  }
};

testing::Scene stage(const std::string& csg, const view::Camera& camera, std::optional<double> near = std::nullopt,
                     unsigned z_bits = 20) {
  view::Sampling sampling;
  sampling.width = 64;
  sampling.height = 48;
  sampling.z_bits = z_bits;
  sampling.fraction_bits = 12;
  sampling.near = near;
  return testing::make_scene(read::read_csg_text(csg, "staged"), camera, sampling);
}

constexpr const char* block = "cube(size=[8,8,8],center=true);";
constexpr const char* block_aside =
    "multmatrix([[1,0,0,5],[0,1,0,3],[0,0,1,2],[0,0,0,1]]){cube(size=[8,8,8],center=true);}";
const view::Camera from_front{{0, -60, 0}, {0, 0, 0}, view::Projection::orthographic};
const view::Camera from_eye{{0, -60, 0}, {0, 0, 0}, view::Projection::perspective};

/// A billionth of the diagonal of the box around a block of 8, enlarged by twice the reach; the reach is 2^-14 of the
/// block's own diagonal.
const double slack_of_block = 1e-9 * std::sqrt(3.0) * (8 + 4 * 0x1p-14 * 8 * std::sqrt(3.0));

/// Faces of a convex solid, counter-clockwise as seen from outside.
using Faces = std::vector<std::vector<glm::dvec3>>;

/// The cube from -1 to 1 along each axis.
Faces cube_faces() {
  Faces faces;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      std::vector<glm::dvec3> face;
      for (const auto& corner : {std::array{-1, -1}, std::array{1, -1}, std::array{1, 1}, std::array{-1, 1}}) {
        glm::dvec3 place;
        place[axis] = side;
        place[(axis + 1) % 3] = corner[0];
        place[(axis + 2) % 3] = corner[1];
        face.push_back(place);
      }
      if (side < 0) std::ranges::reverse(face);
      faces.push_back(face);
    }
  }
  return faces;
}

/// The octahedron |x| + |y| + |z| <= 1.
Faces octahedron_faces() {
  Faces faces;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) {
        std::vector<glm::dvec3> face{{x, 0, 0}, {0, y, 0}, {0, 0, z}};
        if (x * y * z < 0) std::ranges::reverse(face);
        faces.push_back(face);
      }
    }
  }
  return faces;
}

/// Numbers of faces that a line enters and leaves through.
struct InAndOut {
  int in = 0;
  int out = 0;
};

InAndOut pierced_faces(const Faces& faces, const SpaceRay& ray) {
  const software::Piercing piercing(ray);
  software::Uncounted nothing;
  InAndOut faces_met;
  for (const std::vector<glm::dvec3>& face : faces) {
    const int side = piercing.through(face, nothing);
    faces_met.in += side < 0 ? 1 : 0;
    faces_met.out += side > 0 ? 1 : 0;
  }
  return faces_met;
}

}  // namespace

TEST_CASE("a line through an edge or corner enters one face and leaves one or misses") {
  std::vector<glm::dvec3> places;
  for (int i = 0; i < 125; ++i) places.emplace_back(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2);
  std::uint64_t within = 0;
  std::uint64_t beside = 0;
  for (const Faces& faces : {cube_faces(), octahedron_faces()}) {
    for (const glm::dvec3& from : places) {
      for (const glm::dvec3& to : places) {
        if (from == to) continue;
        const InAndOut met = pierced_faces(faces, {from, to - from, 0, 1});
        CHECK(met.in == met.out);
        CHECK(met.in <= 1);
        if (to == glm::dvec3{0}) CHECK(met.in == 1);  // through the middle
        (met.in == 1 ? within : beside) += 1;
      }
    }
  }
  CHECK(within > 1000);
  CHECK(beside > 1000);
}
TEST_CASE("a line pierces a cube's face with -1 if it enters there and 1 if it leaves") {
  const Faces faces = cube_faces();  // low x, high x, low y, high y, low z, high z
  const auto sides = [&](const glm::dvec3& origin, const glm::dvec3& direction) {
    const software::Piercing piercing({origin, direction, 0, 1});
    software::Uncounted nothing;
    std::vector<int> all;
    for (const std::vector<glm::dvec3>& face : faces) all.push_back(piercing.through(face, nothing));
    return all;
  };
  CHECK(sides({-5, 0.5, 0.25}, {1, 0, 0}) == std::vector<int>{-1, 1, 0, 0, 0, 0});
  CHECK(sides({-5, 0.5, 0.25}, {-1, 0, 0}) == std::vector<int>{1, -1, 0, 0, 0, 0});
  CHECK(sides({0.5, 9, 0.25}, {0, 2, 0}) == std::vector<int>{0, 0, -1, 1, 0, 0});
  CHECK(sides({0.5, 9, 0.25}, {0, -2, 0}) == std::vector<int>{0, 0, 1, -1, 0, 0});
  CHECK(sides({0.5, 0.25, 0}, {0, 0, 3}) == std::vector<int>{0, 0, 0, 0, -1, 1});
  CHECK(sides({0.5, 0.25, 0}, {0, 0, -3}) == std::vector<int>{0, 0, 0, 0, 1, -1});
  CHECK(sides({1.5, 0.25, 0}, {0, 0, 3}) == std::vector<int>(6));
  // Near a corner of the cube, the line enters by one face and leaves by an adjacent one.
  CHECK(sides({0.5, 0.5, 0}, {3, -2, 0}) == std::vector<int>{0, 1, 0, -1, 0, 0});
  CHECK(sides({0.5, 0, 0.5}, {-3, 0, 2.5}) == std::vector<int>{0, -1, 0, 0, 0, 1});
  CHECK(sides({0, -0.5, 0.5}, {0, 2, 3}) == std::vector<int>{0, 0, -1, 0, 0, 1});
}
TEST_CASE("a pixel's ray passes through the pixel and exceeds the depth range by slack()") {
  for (const view::Camera& camera : {from_front, from_eye}) {
    const bool is_perspective = camera.projection == view::Projection::perspective;
    CAPTURE(is_perspective);
    const Staged staged{stage(block_aside, camera)};
    const double near = staged.scene.view.depth.near;
    const double far = staged.scene.view.depth.far;
    CHECK(staged.traced.slack() == doctest::Approx(slack_of_block).epsilon(1e-9));
    // Between near and far are 2^20 - 4 steps, and depths range from one step before near to two steps after far.
    constexpr double step = 1.0 / 1048572;
    double least = near - step * (far - near);
    double most = far + 2 * step * (far - near);
    if (is_perspective) {
      least = 1 / (1 / near + step * (1 / near - 1 / far));
      most = 1 / (1 / far - 2 * step * (1 / near - 1 / far));
    }
    const view::EyeSpace eye = view::eye_space(staged.scene.view.camera, staged.scene.view.sampling);
    for (const std::int32_t column : {0, 31, 40, 63}) {
      for (const std::int32_t row : {0, 20, 47}) {
        const SpaceRay ray = staged.traced.ray_of(column, row);
        CHECK(std::abs(ray.begin - (least - slack_of_block)) < 1e-11);
        CHECK(std::abs(ray.end - (most + slack_of_block)) < 1e-11);
        for (const double t : {50.0, 61.5}) {
          const glm::dvec3 seen = eye.to_picture(eye.to_eye(ray.at(t) + staged.scene.geometry.planes.centre()));
          CHECK(seen.x == doctest::Approx(column).scale(1));
          CHECK(seen.y == doctest::Approx(row).scale(1));
          CHECK(seen.z == doctest::Approx(t));
        }
      }
    }
  }
}
TEST_CASE("a pixel's ray has no end if the last depth is beyond infinity") {
  // With 4 bits there are 12 steps from near to far, and depths extend two steps further: to 14/12 of the range. With
  // the model from 56 to 64, 1/8 - 14/12 (1/8 - 1/64) is negative; with the near plane at the model it is not.
  CHECK(Staged{stage(block, from_eye, 8.0, 4)}.traced.ray_of(3, 4).end == infinite);
  const double near = 50;
  const Staged staged{stage(block, from_eye, near, 4)};
  const double far = staged.scene.view.depth.far;
  const double last = 1 / (1 / near - 14.0 / 12 * (1 / near - 1 / far));
  CHECK(staged.traced.ray_of(3, 4).end == doctest::Approx(last + slack_of_block).epsilon(1e-12));
  CHECK(staged.traced.ray_of(3, 4).end > last);
}
TEST_CASE("depths of a ray are final up to a slack before its settled position") {
  for (const view::Camera& camera : {from_front, from_eye}) {
    const bool is_perspective = camera.projection == view::Projection::perspective;
    CAPTURE(is_perspective);
    const Staged staged{stage(block, camera)};
    const double near = staged.scene.view.depth.near;
    const double far = staged.scene.view.depth.far;
    CHECK(staged.traced.depth_at(infinite) == infinite);
    // A depth is 1 at the near plane, and 2^20 - 4 more at the far plane.
    const double steps_per_unit = 1048572 / (is_perspective ? near * (far - near) / far : far - near);
    CHECK(std::abs(staged.traced.depth_at(near + slack_of_block) - 1) < 1e-6);
    CHECK(staged.traced.depth_at(near) == doctest::Approx(1 - slack_of_block * steps_per_unit).epsilon(1e-8));
    CHECK(std::abs(staged.traced.depth_at(near) - 1) > 5e-4);
    CHECK(std::abs(staged.traced.depth_at(far + slack_of_block) - 1048573) < 1e-6);
    if (is_perspective) {
      // At the eye no depth is settled.
      for (const double t : {-1.0, 0.0, staged.traced.slack()}) CHECK(staged.traced.depth_at(t) == 0);
      CHECK(staged.traced.depth_at(2 * staged.traced.slack()) < 0);
      CHECK(staged.traced.depth_at(0.5) < 0);
    } else {
      CHECK(staged.traced.depth_at(0) == doctest::Approx(1 - near * 1048572 / (far - near)));
      CHECK(staged.traced.depth_at(-1) < staged.traced.depth_at(0));
    }
  }
}
TEST_CASE("places and directions are converted from camera axes to model axes") {
  // The camera looks along y; its right is x, and its up is z.
  const Staged staged{stage(block_aside, {{3, -60, 2}, {3, 0, 2}, view::Projection::perspective})};
  const glm::dvec3 centre = staged.scene.geometry.planes.centre();
  CHECK(glm::length(staged.traced.direction_of({1, 2, 3}) - glm::dvec3{1, 3, 2}) < 1e-12);
  CHECK(glm::length(staged.traced.place_of({1, 2, 3}) - (glm::dvec3{4, -57, 4} - centre)) < 1e-12);
  CHECK(glm::length(centre) > 1);
}
TEST_CASE("ray tracing of an empty model gives an empty picture") {
  const Staged staged{stage("union(){}", from_front)};
  REQUIRE(staged.tree.is_constant());
  CHECK(staged.traced.slack() == 1e-9);
  CHECK(staged.traced.loose() == 0);
  const software::Traced traced = staged.pixels({});
  REQUIRE(traced.pixels.size() == 64 * 48);
  CHECK(traced.counts.primary.rays == 0);
  CHECK(traced.counts.words == 0);
  for (const software::TracedPixel& pixel : traced.pixels) {
    CHECK(pixel.seen == software::VisibleSurface{(1U << 20U) - 1, software::VisibleSurface::nothing_seen});
    CHECK(pixel.surface.owner == software::VisibleSurface::nothing_seen);
    CHECK(pixel.surface.facet == TraceScene::none);
  }
  CHECK(software::picture_of(traced).seen.size() == 64 * 48);
  const auto space = software::directory_of("excell").make(staged.traced.shapes(), {8});
  CHECK(software::measure_trace_seconds(staged.traced, *space, {}) == 0);
}
TEST_CASE("ray tracing accepts 32 lights and rejects 33") {
  const Staged staged{stage(block, from_front)};
  const auto space = software::directory_of("excell").make(staged.traced.shapes(), {8});
  software::TraceOptions options;
  options.has_shadows = true;
  // All lights illuminate the face in front.
  options.lights.assign(32, {false, {0, -1, 0}});
  const software::Traced traced = software::trace(staged.traced, *space, options, false);
  CHECK(std::ranges::count(traced.pixels, 0xffffffffU, [](const auto& pixel) { return pixel.surface.lit; }) ==
        std::ranges::count(traced.pixels, 0U, [](const auto& pixel) { return pixel.seen.owner; }));
  const double seconds = software::measure_trace_seconds(staged.traced, *space, options);
  CHECK(seconds > 0);
  CHECK(seconds < 60);
  options.lights.push_back({false, {0, -1, 0}});
  CHECK_THROWS_WITH_AS(software::trace(staged.traced, *space, options, false), doctest::Contains("33 lights"),
                       InputError);
  CHECK_THROWS_WITH_AS(software::measure_trace_seconds(staged.traced, *space, options), doctest::Contains("33 lights"),
                       InputError);
}
TEST_CASE("a pixel reports its facet and its lights and mirrors only if requested") {
  const Staged staged{stage(block, from_front)};
  software::TraceOptions with_mirrors;
  with_mirrors.mirror_depth = 2;
  with_mirrors.mirrors.assign(6, 1);
  software::TraceOptions with_light;
  with_light.has_shadows = true;
  with_light.lights = {{false, {0, 1, 0}}, {false, {0.5, -1, 0}}};  // lights behind the face and in front of it
  for (const software::TraceOptions& options : {software::TraceOptions{}, with_mirrors, with_light}) {
    std::uint64_t seen = 0;
    for (const software::TracedPixel& pixel : staged.pixels(options).pixels) {
      const bool is_seen = pixel.seen.owner == 0;
      seen += is_seen ? 1U : 0U;
      CHECK(pixel.surface.owner == pixel.seen.owner);
      CHECK(pixel.surface.lit == (is_seen && options.has_shadows ? 2U : 0U));
      // The mirror shows the background.
      REQUIRE(pixel.mirrored.size() == (is_seen && options.mirror_depth > 0 ? 1U : 0U));
      if (!pixel.mirrored.empty()) {
        CHECK(pixel.mirrored[0].owner == software::VisibleSurface::nothing_seen);
        CHECK(pixel.mirrored[0].facet == TraceScene::none);
        CHECK(pixel.mirrored[0].lit == 0);
      }
      if (!is_seen) {
        CHECK(pixel.surface.facet == TraceScene::none);
        continue;
      }
      const facet::Halfspace halfspace = staged.traced.facets().facets[pixel.surface.facet].halfspace;
      const double sign = halfspace.positive ? 1 : -1;
      CHECK((staged.scene.geometry.planes.planes()[halfspace.plane].normal * sign) == glm::dvec3{0, -1, 0});
    }
    CHECK(seen > 100);
  }
}
TEST_CASE("a camera ray that starts in a solid has no facet or light or mirror") {
  // The camera is in a block of 80, and looks along y.
  const Staged staged{
      stage("cube(size=[80,80,80],center=true);", {{0, 0, 0}, {0, 1, 0}, view::Projection::perspective}, 1.0)};
  software::TraceOptions options;
  options.has_shadows = true;
  options.lights = {{false, {0, -1, 0}}};
  options.mirror_depth = 1;
  options.mirrors.assign(6, 1);
  for (const software::ItemPass pass : {software::ItemPass::none, software::ItemPass::depth_lists}) {
    options.item_pass = pass;
    const software::Traced traced = staged.pixels(options);
    for (const software::TracedPixel& pixel : traced.pixels) {
      CHECK(pixel.seen == software::VisibleSurface{0, 0});
      CHECK(pixel.surface.owner == 0);
      CHECK(pixel.surface.facet == TraceScene::none);
      CHECK(pixel.surface.lit == 0);
      CHECK(pixel.mirrored.empty());
    }
    CHECK(traced.counts.primary.hits == 64 * 48);
    CHECK(traced.counts.shadow.rays == 0);
    CHECK(traced.counts.mirror.rays == 0);
  }
}
TEST_CASE("counts of ray tracing start at zero and its options have defaults") {
  const software::TraceCounts counts;
  for (const software::RaysMet& met : {counts.primary, counts.shadow, counts.mirror}) {
    CHECK(met.rays + met.cells + met.tested + met.loose + met.met + met.repeats + met.hits == 0);
    CHECK(met.rays_by_cells.empty());
  }
  CHECK(counts.items == 0);
  CHECK(counts.words == 0);
  const software::PriorityPass pass;
  CHECK(pass.events + pass.words == 0);
  const software::TraceOptions options;
  CHECK(options.item_pass == software::ItemPass::none);
  CHECK(options.facet_test == software::FacetTest::space);
  CHECK(options.has_mailboxes);
  CHECK(!options.has_shadows);
  CHECK(options.mirror_depth == 0);
  CHECK(!software::TraceLight{}.is_point);
  CHECK(software::TraceLight{}.where == glm::dvec3{0});
  CHECK(software::TracedSurface{}.lit == 0);
  software::RaysMet met;
  met.add_cells(3);
  met.add_cells(0);
  met.add_cells(3);
  CHECK(met.cells == 6);
  CHECK(met.rays_by_cells == std::vector<std::uint64_t>{1, 0, 0, 2});
}

namespace {

/// Two cubes of 2 along y, at 0 and at 10, and rays between them.
class Between {
 public:
  Between()
      : staged_{stage("cube(size=[2,2,2],center=true);multmatrix([[1,0,0,0],[0,1,0,10],[0,0,1,0],[0,0,0,1]]){cube(size="
                      "[2,2,2],center=true);}",
                      {{0, -60, 5}, {0, 5, 0}, view::Projection::orthographic})},
        sequences_(staged_.tree, meters_.classification) {}

  /// Number of the facet in the plane across an axis at this distance from the centre.
  [[nodiscard]] std::uint32_t facet_across(int axis, double at) const {
    const software::Facets& facets = staged_.traced.facets();
    for (std::uint32_t i = 0; i < facets.facets.size(); ++i) {
      const auto corners = facets.corners_of(i);
      if (std::ranges::all_of(corners, [&](const glm::dvec3& one) { return std::abs(one[axis] - at) < 1e-9; }))
        return i;
    }
    return TraceScene::none;
  }

  software::RealHit ray(const glm::dvec3& from, const glm::dvec3& direction, double end,
                        const std::string& name = "none", bool is_any = false, bool has_mailboxes = true) {
    const auto directory = software::directory_of(name).make(staged_.traced.shapes(), {4});
    software::SecondaryRays<software::UncountedMethod> rays(staged_.traced, *directory, has_mailboxes, sequences_,
                                                            meters_);
    const software::Start start{from, facet_across(1, direction.y > 0 ? -4 : 4), TraceScene::none};
    met = {};
    return rays.trace(start, direction, end, is_any, met);
  }

  software::RaysMet met;

 private:
  Staged staged_;
  software::TraceMeters<software::UncountedMethod> meters_;
  software::Sequences<software::UncountedMethod> sequences_;
};

}  // namespace

TEST_CASE("a ray from a face ends on the next solid if that is within its length") {
  Between between;
  // Relative to the centre, at y = 5, the cubes extend from -6 to -4 and from 4 to 6.
  REQUIRE(between.facet_across(1, -4) < 6);
  REQUIRE(between.facet_across(1, 4) >= 6);
  for (const double size : {1.0, 2.0, 64.0}) {
    CAPTURE(size);
    const software::RealHit hit = between.ray({0.25, -4, 0.5}, {0, size, 0}, infinite);
    CHECK(hit.t == doctest::Approx(8 / size).epsilon(1e-12));
    CHECK(hit.is_in_solid());
    CHECK(hit.owner == 1);
    CHECK(hit.facet == between.facet_across(1, 4));
    CHECK(between.met.rays == 1);
    CHECK(between.met.hits == 1);
    CHECK(between.met.met == 2);  // the front and the back of the cube
    CHECK(between.met.tested == 12);
    CHECK(between.met.cells == 1);
    CHECK(between.ray({0.25, -4, 0.5}, {0, size, 0}, 8 / size + 1e-6).is_in_solid());
    CHECK(between.met.met == 1);
    CHECK(!between.ray({0.25, -4, 0.5}, {0, size, 0}, 8 / size - 1e-6).is_in_solid());
    CHECK(between.met.hits == 0);
    CHECK(between.met.met == 0);
  }
  // A ray in the opposite direction, and one that passes the cube.
  CHECK(between.ray({0.25, 4, 0.5}, {0, -1, 0}, infinite).facet == between.facet_across(1, -4));
  const software::RealHit past = between.ray({0.25, -4, 0.5}, {0, 1, 1}, infinite);
  CHECK(past.t == infinite);
  CHECK(past.owner == software::VisibleSurface::nothing_seen);
  CHECK(past.facet == TraceScene::none);
  // With `is_any`, the obstacle's owner and facet are not reported.
  const software::RealHit any = between.ray({0.25, -4, 0.5}, {0, 1, 0}, infinite, "none", true);
  CHECK(any.t == doctest::Approx(8));
  CHECK(any.owner == software::VisibleSurface::nothing_seen);
  CHECK(any.facet == TraceScene::none);
}
TEST_CASE("a ray parallel to an axis except for a subnormal number is treated as parallel") {
  Between between;
  // The ray starts on the walls that halve the model across both other axes.
  for (const software::DirectoryRow* const row : software::directories()) {
    for (const bool has_mailboxes : {false, true}) {
      CAPTURE(row->name);
      CAPTURE(has_mailboxes);
      for (const double least : {0.0, 1e-310, -1e-310, 5e-324}) {
        const std::string name(row->name);
        CHECK(between.ray({0, -4, 0}, {least, 1, 0}, infinite, name, false, has_mailboxes).t == doctest::Approx(8));
        CHECK(between.ray({0, -4, 0}, {0, 1, least}, infinite, name, false, has_mailboxes).t == doctest::Approx(8));
        CHECK(between.ray({0, 4, 0}, {least, -1, least}, infinite, name, false, has_mailboxes).t == doctest::Approx(8));
      }
    }
  }
}
