#include "host/effects/rows.h"
#include "host/read/read.h"
#include "tests/support/test.h"
#include "tests/unit/effects/effect_picture.h"

using namespace csgsim;

namespace {

constexpr std::uint32_t width = 48;
constexpr std::uint32_t height = 40;
constexpr double hatch = 9;  // pixels between lines

/// Position of a point of the picture within a period of the hatching, from 0 to 1.
double phase(const glm::dvec2& place, double angle) {
  const double turn = angle * std::numbers::pi / 180;
  const double periods = (place.y * std::cos(turn) - place.x * std::sin(turn)) / hatch;
  return periods - std::floor(periods);
}

/// Draws with the cuts of the scene.
observe::Frame drawn(const std::string& csg, const testing::Setup& setup) {
  const model::Tree tree = effects::reshape_model(read::read_csg_text(csg, "box"), setup.options.scene);
  const facet::Geometry facets = facet::make_geometry(tree);
  const view::View view = view::make_view(facets, tree, setup.camera, setup.sampling);
  return testing::draw(
      emit::compile(tree, facets, view, testing::machine_of({width, height, setup.memory_bits}), setup.options));
}

}  // namespace

TEST_CASE("hatching lines fill the third quarter of each period at any angle and offset") {
  const std::string box = testing::box_text({0, 0, -40}, {48, 9, 0});
  for (const double angle : {0.0, 30.0, 45.0, -70.0, 90.0}) {
    for (const glm::dvec2& aside : {glm::dvec2{0, 0}, glm::dvec2{0.25, -0.375}, {-0.5, -0.125}, {0.3125, 0.4375}}) {
      CAPTURE(angle);
      CAPTURE(aside.x);
      testing::Setup setup = testing::front_view(
          width, height,
          testing::scene_of(testing::plain_colours +
                            fmt::format("[[effects.cuts]]\nnormal = [0, -1, 0]\npoint = [0, 3, 0]\ncolour = [0, 0, 1]\n"
                                        "hatch = {}\nangle = {}\nhatch_colour = [1, 0, 0]\n",
                                        hatch, angle)));
      setup.sampling.offset = aside;
      const observe::Frame frame = drawn(box, setup);
      int wrong = 0;
      int lines = 0;
      for (std::uint32_t y = 1; y + 1 < height; ++y) {
        for (std::uint32_t x = 1; x + 1 < width; ++x) {
          // Lines are the third quarter of each period, with an error of at most 1/128 of it.
          const double at = phase(glm::dvec2(x, y) + aside, angle);
          if (std::abs(at - 0.5) < 0.01 || std::abs(at - 0.75) < 0.01) continue;
          const bool is_line = at > 0.5 && at < 0.75;
          lines += is_line ? 1 : 0;
          wrong += frame.colour[std::size_t{y} * width + x] == (is_line ? 0xff0000U : 0x0000ffU) ? 0 : 1;
        }
      }
      CHECK(wrong == 0);
      CHECK(lines > 200);
    }
  }
}
