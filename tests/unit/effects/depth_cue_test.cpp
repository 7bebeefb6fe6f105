#include "hw/isa/depth_scale.h"
#include "hw/scan_line/kind.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/ray_picture.h"
#include "tests/support/test.h"
#include "tests/unit/effects/effect_picture.h"

using namespace csgsim;

namespace {

constexpr std::uint32_t width = 59;
constexpr std::uint32_t height = 45;

testing::Setup random_view(view::Projection projection, const std::string& scene) {
  testing::Setup setup = testing::front_view(width, height, testing::scene_of(scene));
  setup.camera = {{40, -90, 35}, {0, 0, 0}, projection};
  return setup;
}

int level(std::uint32_t colour, int channel) { return static_cast<int>(colour >> (16 - 8 * channel) & 255U); }

/// Maximum error in levels of a channel: half a step of fading over the full range, half a level, and one step of
/// depth.
double bound(int bits, double depths) { return 255 * (std::ldexp(0.5, -bits) + 1 / depths) + 0.5; }

}  // namespace

TEST_CASE("a depth cue fades each pixel by its depth within half a step and half a level") {
  int models_changed = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const std::string csg = testing::random_model(seed, 6);
    const auto projection = seed % 2 == 0 ? view::Projection::orthographic : view::Projection::perspective;
    const int bits = 1 + static_cast<int>(seed % 6);
    const double near = seed % 3 == 0 ? 60 : 85;
    const double far = seed % 3 == 0 ? 200 : 115;
    const std::array cue{40, 160, 255};
    CAPTURE(seed);
    const testing::Setup plain = random_view(projection, "");
    const testing::Compiled without = testing::compile_text(csg, plain);
    const observe::Frame before = testing::draw(without.program);
    const testing::Setup setup = random_view(
        projection, fmt::format("[effects.depth_cue]\nnear = {}\nfar = {}\ncolour = [{}, {}, {}]\nbits = {}\n", near,
                                far, cue[0] / 255.0, cue[1] / 255.0, cue[2] / 255.0, bits));
    const observe::Frame after = testing::draw(testing::compile_text(csg, setup).program);
    CHECK(before.depth == after.depth);
    const isa::DepthScale& scale = without.view.depth;
    const double begin = isa::depth_of(scale, 20, near);
    const double end = isa::depth_of(scale, 20, far);
    const double allowed = bound(bits, end - begin);
    double worst = 0;
    int changed = 0;
    for (std::size_t i = 0; i < before.colour.size(); ++i) {
      if (before.depth[i] == (1U << 20) - 1) {
        CHECK(after.colour[i] == before.colour[i]);
        continue;
      }
      const double faded = std::clamp((before.depth[i] - begin) / (end - begin), 0.0, 1.0);
      for (int c = 0; c < 3; ++c) {
        const double from = level(before.colour[i], c);
        const double exact = from + (cue.at(static_cast<std::size_t>(c)) - from) * faded;
        worst = std::max(worst, std::abs(level(after.colour[i], c) - exact));
      }
      changed += before.colour[i] != after.colour[i];
    }
    CHECK(worst <= allowed);
    models_changed += changed > 0;
  }
  // Some models are empty.
  CHECK(models_changed >= 9);
}

TEST_CASE("a depth cue in orthographic views fades colours with distance like rays") {
  for (std::uint64_t seed = 30; seed < 36; ++seed) {
    const std::string csg = testing::random_model(seed, 5);
    CAPTURE(seed);
    const testing::Setup setup =
        random_view(view::Projection::orthographic, "[effects.depth_cue]\nnear = 80\nfar = 130\ncolour = [0, 0, 0]\n");
    const testing::Compiled compiled = testing::compile_text(csg, setup);
    const observe::Frame picture = testing::draw(compiled.program);
    testing::RayEffects effects;
    effects.cue = testing::RayCue{80, 130, {0, 0, 0}};
    const testing::RayShot shot{setup.camera, width, height};
    const auto seen = testing::ray_picture(compiled.tree, compiled.scene, setup.options.scene, shot, effects);
    int certain = 0;
    double worst = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (!seen[i].is_certain) continue;
      ++certain;
      for (int c = 0; c < 3; ++c)
        worst = std::max(worst, std::abs(level(picture.colour[i], c) - seen[i].colour[c] * 255));
    }
    // The ray's colour was rounded once more, before or after fading.
    CHECK(worst <= bound(5, 1000) + 0.5);
    CHECK(certain > static_cast<int>(seen.size()) / 2);
  }
}

TEST_CASE("a depth cue at its far end shows the background and at its near end the colour") {
  const std::string boxes = testing::tinted({1, 0, 0}, 1, testing::box_text({2, 0, -12}, {10, 1, -2})) +
                            testing::tinted({0, 1, 0}, 1, testing::box_text({14, 40, -12}, {22, 41, -2}));
  testing::Setup setup = testing::front_view(24, 14, {});
  const double to_middle = glm::length(setup.camera.eye - setup.camera.centre);
  const std::string black = testing::plain_colours;
  const auto draw = [&](double near, double far) {
    setup.options.scene = testing::scene_of(
        black + fmt::format("[effects.depth_cue]\nnear = {}\nfar = {}\n", to_middle + near, to_middle + far));
    return testing::draw(testing::compile_text(boxes, setup).program);
  };
  const std::size_t first = 7 * 24 + 6;
  const std::size_t second = 7 * 24 + 18;
  const observe::Frame between = draw(1, 39);
  CHECK(between.colour[first] == 0xff0000U);
  CHECK(between.colour[second] == 0x000000U);
  const observe::Frame half = draw(0, 80);
  CHECK(half.colour[first] == 0xff0000U);
  CHECK(std::abs(level(half.colour[second], 1) - 127.5) <= bound(5, 1e5));
}

TEST_CASE("a depth cue gives the same colours on scan-line as on Pixel-planes") {
  testing::Setup setup = random_view(view::Projection::perspective, "[effects.depth_cue]\n");
  const std::string csg = testing::random_model(7, 6);
  const observe::Frame whole = testing::draw(testing::compile_text(csg, setup).program);
  setup.kind = &scan_line::kind;
  CHECK(whole.colour == testing::draw(testing::compile_text(csg, setup).program).colour);
}

TEST_CASE("a depth cue with an empty range is rejected") {
  const auto error = [](view::Projection projection, const std::string& settings) {
    return testing::error_of([&] {
      testing::compile_text(testing::random_model(7, 3), random_view(projection, "[effects.depth_cue]\n" + settings));
    });
  };
  CHECK(error(view::Projection::orthographic, "near = 90\nfar = 80").find("set far above near") != std::string::npos);
  CHECK(error(view::Projection::perspective, "near = -1\nfar = 80").find("set near above 0") != std::string::npos);
  CHECK(error(view::Projection::orthographic, "near = -1\nfar = 80").empty());
}
