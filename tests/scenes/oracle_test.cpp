#include "host/effects/antialias.h"
#include "host/lighting/lighting.h"
#include "hw/isa/colour_format.h"
#include "tests/oracle/ray_picture.h"
#include "tests/scenes/scene_file.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

constexpr std::uint32_t side = 40;  // width and height of a picture in pixels

/// Effects without a model in the ray tracer, which have separate tests: switched off, so that all others are checked.
const std::vector<std::string> not_judged{"effects.smooth.on=false", "effects.equalise.on=false",
                                          "effects.edges.on=false", "effects.depth_cue.on=false",
                                          "effects.antialias.adaptive=false"};

bool names(const testing::SceneFile& file, const std::string& effect) {
  return file.text.find("[effects." + effect + "]") != std::string::npos;
}

/// The number of a key in the file; scenes contain each key at most once.
unsigned number_of(const testing::SceneFile& file, const std::string& key, unsigned otherwise) {
  const std::size_t at = file.text.find("\n" + key + " = ");
  return at == std::string::npos ? otherwise : static_cast<unsigned>(std::stoul(file.text.substr(at + key.size() + 4)));
}

std::vector<std::string> sets_for(const testing::SceneFile& file) {
  std::vector<std::string> sets;
  for (const std::string& one : not_judged) {
    const bool is_samples = one.find("antialias") != std::string::npos;
    if (!is_samples || names(file, "antialias")) sets.push_back(one);
  }
  for (std::size_t i = 0, at = 0; (at = file.text.find("[[effects.textures]]", at)) != std::string::npos; ++i, ++at)
    sets.push_back("effects.textures." + std::to_string(i) + ".on=false");
  if (names(file, "cuts")) sets.emplace_back("effects.cuts.0.hatch=0");
  if (file.text.find("screen-door") != std::string::npos) sets.emplace_back("effects.transparency.on=false");
  return sets;
}

/// Flat faces of mirror materials, without those of balls, cylinders and cones.
std::vector<testing::RayMirror> mirrors_of(const testing::DrawnScene& drawn) {
  std::vector<testing::RayMirror> mirrors;
  for (std::uint32_t i = 0; i < drawn.compiled.tree.primitives.size(); ++i) {
    const model::Primitive& primitive = drawn.compiled.tree.primitives[i];
    const double reflectance = lighting::make_finish(drawn.scene, primitive, false).material.mirror;
    const bool is_flat = std::holds_alternative<model::Cube>(primitive.shape) ||
                         std::holds_alternative<model::Polyhedron>(primitive.shape);
    if (reflectance > 0 && is_flat) mirrors.push_back({i, std::nullopt, reflectance});
  }
  return mirrors;
}

testing::RayEffects effects_of(const testing::SceneFile& file, const testing::DrawnScene& drawn) {
  testing::RayEffects effects;
  effects.has_shadows = names(file, "shadows");
  if (file.text.find("screen-door") == std::string::npos) {
    for (const model::Primitive& one : drawn.compiled.tree.primitives)
      effects.opacity.push_back(lighting::make_finish(drawn.scene, one, false).opacity);
  }
  effects.layers = number_of(file, "layers", 16);
  effects.mirrors = mirrors_of(drawn);
  effects.reflections = effects.mirrors.empty() ? 0 : number_of(file, "depth", 1);
  return effects;
}

/// Tolerance for rounding in levels: one for each blended layer and each reflection (host/effects/layers.h,
/// mirrors.cpp), one for the mean of samples, and one half.
double bound_of(const testing::RayEffects& effects, std::size_t samples) {
  const bool blends = std::any_of(effects.opacity.begin(), effects.opacity.end(), [](double one) { return one < 1; });
  return 0.51 + (blends ? effects.layers : 0) + effects.reflections * (blends ? effects.layers : 1.0) +
         (samples > 1 ? 1 : 0);
}

}  // namespace

TEST_CASE("every scene matches its ray-traced picture except where rounding decides") {
  const std::vector<testing::SceneFile> files = testing::scene_files();
  CHECK(files.size() >= 12);
  const auto step = testing::cases<std::size_t>(1, 2);
  for (std::size_t at = 0; at < files.size(); at += step) {
    const testing::SceneFile& file = files[at];
    CAPTURE(file.name);
    const testing::DrawnScene drawn = testing::compile_scene(file, side, side, sets_for(file));
    const testing::RayEffects effects = effects_of(file, drawn);
    testing::RayShot shot{file.camera, side, side, drawn.compiled.view.depth.near};
    if (names(file, "antialias")) shot.samples = effects::sample_offsets(number_of(file, "samples", 4));
    testing::RayDoubt doubt;
    // Models are in millimetres or centimetres; the tolerance is three depth steps.
    doubt.gap = 3 * drawn.compiled.view.depth_step;
    const auto expected =
        testing::ray_picture(drawn.compiled.tree, drawn.compiled.scene, drawn.scene, shot, effects, doubt);
    const observe::Frame frame = testing::draw(drawn.compiled.program);
    std::size_t judged = 0;
    std::size_t wrong = 0;
    double worst = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (!expected[i].is_certain) continue;
      ++judged;
      const double off = testing::colour_error(frame.colour[i], expected[i].colour);
      worst = std::max(worst, off);
      if (off > bound_of(effects, shot.samples.size())) {
        if (++wrong < 4) MESSAGE("column ", i % side, " row ", i / side, ": error ", off);
      }
    }
    MESSAGE(file.name, ": ", judged, " of ", expected.size(), " pixels checked, error at most ", worst, " levels");
    CHECK(wrong == 0);
    CHECK(judged > expected.size() / 2);
  }
}
