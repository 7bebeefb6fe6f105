#include "host/read/read.h"
#include "sim/software/tracing/trace.h"
#include "sim/software/tree/tree.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/ray_picture.h"
#include "tests/oracle/split_mix.h"
#include "tests/support/test.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;
using software::VisibleSurface;
using testing::Random;
using testing::Scene;

namespace {

struct Tally {
  std::uint64_t judged = 0;
  std::uint64_t pixels = 0;
  std::uint64_t dark = 0;       ///< in shadow, or facing away
  std::uint64_t mirrored = 0;   ///< pixels that show another surface
  std::uint64_t reflected = 0;  ///< pixels that show the background
};

/// A model of random primitives with distinct colours.
Scene colourful(Random& random, std::uint32_t side) {
  const std::string csg = testing::random_model(random.below(1U << 30U), 2 + static_cast<unsigned>(random.below(6)));
  model::Tree tree = read::read_csg_text(csg, "test");
  const auto primitives = static_cast<double>(tree.primitives.size());
  for (std::size_t i = 0; i < tree.primitives.size(); ++i) {
    const double part = (static_cast<double>(i) + 1) / (primitives + 1);
    tree.primitives[i].colour = {part, 1 - part, 0.5 + 0.5 * std::sin(7 * part)};
    tree.primitives[i].opacity = 1;
  }
  const auto projection = random.one_of({view::Projection::orthographic, view::Projection::perspective});
  const double turn = 2 * std::numbers::pi * random.unit();
  view::Sampling sampling;
  sampling.width = side;
  sampling.height = side;
  return testing::make_scene(std::move(tree), {{28 * std::cos(turn), 28 * std::sin(turn), 17}, {0, 0, 0}, projection},
                             sampling);
}

testing::RayShot shot_of(const Scene& scene) {
  return {scene.view.camera, scene.view.sampling.width, scene.view.sampling.height, scene.view.depth.near};
}

std::vector<software::TracedPixel> traced(const Scene& scene, const software::TraceOptions& options,
                                          const std::string& directory) {
  const software::Tree tree = software::make_tree(scene.tree, software::Shape::balanced);
  const software::TraceScene traced_scene(scene.tree, scene.geometry, scene.view, tree);
  const auto space = software::directory_of(directory).make(traced_scene.shapes(), {4});
  return software::trace(traced_scene, *space, options, false).pixels;
}

std::string a_directory(Random& random) {
  return std::string(software::directories()[random.below(software::directories().size())]->name);
}

/// Returns the fault in the shading by one light, at pixels that rounding cannot decide; empty if none.
std::string find_light_fault(const Scene& scene, const scene::Light& light, const software::TraceOptions& options,
                             const std::string& directory, Tally& tally) {
  scene::Scene look;
  look.ambient.intensity = 0;
  look.lights.push_back(light);
  look.background.colour = {0, 0, 0};
  testing::RayDoubt doubt;
  doubt.gap = 3 * scene.view.depth_step;
  testing::RayEffects effects;
  effects.has_shadows = true;
  const std::vector<testing::RayColour> expected =
      testing::ray_picture(scene.tree, scene.geometry, look, shot_of(scene), effects, doubt);
  const std::vector<software::TracedPixel> pixels = traced(scene, options, directory);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    ++tally.pixels;
    if (!expected[i].is_certain || expected[i].primitive == model::no_index) continue;
    ++tally.judged;
    const bool is_lit = expected[i].colour != glm::dvec3{0};
    tally.dark += is_lit ? 0U : 1U;
    if ((pixels[i].surface.lit != 0) != is_lit || pixels[i].surface.owner != expected[i].primitive)
      return fmt::format("{}: pixel {} is {}", directory, i, is_lit ? "lit" : "in shadow");
  }
  return "";
}

/// Whether a pixel shows a face that points upwards.
bool is_top(const Scene& scene, const software::TracedPixel& pixel) {
  const software::Facets facets = software::facets_of(scene.tree, scene.geometry);
  const facet::Halfspace halfspace = facets.facets[pixel.surface.facet].halfspace;
  const double up = scene.geometry.planes.planes()[halfspace.plane].normal.z;
  return std::abs(up) > 0.99 && facets.corners_of(pixel.surface.facet)[0].z + scene.geometry.planes.centre().z > -1.5;
}

/// Returns the fault in a random model lit by a single light; empty if none.
std::string find_shadow_fault(std::uint64_t seed, Tally& tally) {
  Random random(seed);
  const Scene scene = colourful(random, 40);
  scene::Light light;
  light.intensity = 1;
  const auto any = [&] { return 2 * random.unit() - 1; };
  software::TraceOptions options;
  options.has_shadows = true;
  options.item_pass = random.below(2) == 0 ? software::ItemPass::depth_lists : software::ItemPass::none;
  options.has_mailboxes = random.below(2) == 0;
  if (random.below(2) == 0) {
    light.direction = {any(), any(), any() - 0.5};
    options.lights.push_back({false, -light.direction});
  } else {
    light.kind = scene::LightKind::point;
    light.position = glm::dvec3{any(), any(), any()} * 20.0;
    options.lights.push_back({true, light.position - scene.geometry.planes.centre()});
  }
  const std::string fault = find_light_fault(scene, light, options, a_directory(random), tally);
  return fault.empty() ? fault : fmt::format("seed {}, {}", seed, fault);
}

/// Colour at the end of a chain of mirrors.
glm::dvec3 shown(const Scene& scene, const software::TracedPixel& pixel) {
  const std::uint32_t owner = pixel.mirrored.empty() ? pixel.surface.owner : pixel.mirrored.back().owner;
  return owner == VisibleSurface::nothing_seen ? glm::dvec3{0} : *scene.tree.primitives[owner].colour;
}

/// Returns the fault in a random model with all facets mirroring; empty if none.
std::string find_mirror_fault(std::uint64_t seed, Tally& tally) {
  Random random(seed);
  const Scene scene = colourful(random, 40);
  scene::Scene look;
  look.ambient.intensity = 1;
  scene::Light none;
  none.intensity = 0;
  none.direction = {0, 0, -1};
  look.lights.push_back(none);
  look.background.colour = {0, 0, 0};
  testing::RayEffects effects;
  effects.reflections = 1 + static_cast<unsigned>(random.below(3));
  for (std::uint32_t i = 0; i < scene.tree.primitives.size(); ++i) effects.mirrors.push_back({i, std::nullopt, 1});
  software::TraceOptions options;
  options.mirror_depth = effects.reflections;
  options.mirrors.assign(scene.geometry.halfspaces(), 1);
  options.item_pass = random.below(2) == 0 ? software::ItemPass::depth_lists : software::ItemPass::none;
  options.has_mailboxes = random.below(2) == 0;
  testing::RayDoubt doubt;
  doubt.gap = 3 * scene.view.depth_step;
  const std::vector<testing::RayColour> expected =
      testing::ray_picture(scene.tree, scene.geometry, look, shot_of(scene), effects, doubt);
  const std::string directory = a_directory(random);
  const std::vector<software::TracedPixel> pixels = traced(scene, options, directory);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    ++tally.pixels;
    if (!expected[i].is_certain || expected[i].primitive == model::no_index) continue;
    ++tally.judged;
    const bool shows_another = pixels[i].mirrored.size() == effects.reflections &&
                               pixels[i].mirrored.back().owner != VisibleSurface::nothing_seen;
    tally.mirrored += shows_another ? 1U : 0U;
    tally.reflected += shows_another ? 0U : 1U;
    const glm::dvec3 off = glm::abs(shown(scene, pixels[i]) - expected[i].colour);
    if (std::max({off.x, off.y, off.z}) > 0.01)
      return fmt::format("seed {}, {}: pixel {}, of owner {}, shows another colour", seed, directory, i,
                         pixels[i].surface.owner);
  }
  return "";
}

}  // namespace

TEST_CASE("shadow rays agree with the oracle's wherever rounding cannot decide") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    try {
      CHECK(find_shadow_fault(seed, tally) == "");
    } catch (const InputError&) {
      continue;  // the model is empty
    }
  }
  MESSAGE(tally.judged, " of ", tally.pixels, " pixels judged, ", tally.dark, " dark");
  CHECK(tally.judged > tally.pixels / 20);
  CHECK(tally.dark > tally.judged / 10);
}
TEST_CASE("objects in front of a point light block it and objects behind it do not") {
  const auto floor_with = [](double z) {
    model::Tree tree = read::read_csg_text(
        fmt::format("multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,-1],[0,0,0,1]]){{cube(size=[40,40,2],center=true);}}"
                    "multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,{}],[0,0,0,1]]){{cube(size=[6,6,1],center=true);}}",
                    z),
        "floor");
    tree.primitives[0].colour = {1, 1, 1};
    tree.primitives[1].colour = {1, 0, 0};
    view::Sampling sampling;
    sampling.width = 60;
    sampling.height = 60;
    return testing::make_scene(std::move(tree), {{0, -50, 30}, {0, 0, 2}, view::Projection::perspective}, sampling);
  };
  for (const bool is_behind : {false, true}) {
    CAPTURE(is_behind);
    const Scene scene = floor_with(is_behind ? 16 : 4);
    scene::Light light;
    light.intensity = 1;
    light.kind = scene::LightKind::point;
    light.position = {0.3, 0.2, 9};
    software::TraceOptions options;
    options.has_shadows = true;
    options.lights.push_back({true, light.position - scene.geometry.planes.centre()});
    for (const char* const directory : {"excell", "kd-tree", "bvh", "none"}) {
      CAPTURE(directory);
      Tally tally;
      CHECK(find_light_fault(scene, light, options, directory, tally) == "");
      CHECK(tally.judged > 1000);
      // The floor of 40 by 40 has a shadow of about 11 by 11 if the plate is halfway to the light, else none; sides of
      // plates are dark too.
      std::uint64_t dark_floor = 0;
      for (const software::TracedPixel& pixel : traced(scene, options, directory))
        dark_floor += pixel.seen.owner == 0 && pixel.surface.lit == 0 && is_top(scene, pixel) ? 1U : 0U;
      if (is_behind) CHECK(dark_floor == 0);
      if (!is_behind) CHECK(dark_floor > 50);
    }
  }
}
TEST_CASE("mirror rays agree with the oracle's wherever rounding cannot decide") {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    try {
      CHECK(find_mirror_fault(seed, tally) == "");
    } catch (const InputError&) {
      continue;
    }
  }
  MESSAGE(tally.judged, " of ", tally.pixels, " pixels judged, ", tally.mirrored, " show another surface, ",
          tally.reflected, " none");
  CHECK(tally.judged > tally.pixels / 20);
  CHECK(tally.mirrored > tally.judged / 100);
}
