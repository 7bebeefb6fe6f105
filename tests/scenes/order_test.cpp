#include "host/effects/rows.h"
#include "host/scene/read.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

std::string at(double x, double y, double z, const std::string& solid) {
  return "multmatrix([[1,0,0," + std::to_string(x) + "],[0,1,0," + std::to_string(y) + "],[0,0,1," + std::to_string(z) +
         "],[0,0,0,1]]){" + solid + "}\n";
}

/// Parts of a scene without coplanar surfaces.
const std::vector<std::string> parts{
    "color([0.8,0.8,0.7,1]){" + at(-20, -20, -3, "cube(size=[40,40,2.5],center=false);") + "}",
    "color([0.2,0.5,0.9,0.4]){" + at(-6, -9, 0, "cube(size=[9,2,11],center=false);") + "}",
    "color([0.9,0.3,0.2,0.5]){" + at(2.3, -3.1, 4.2, "sphere($fn=12,$fa=12,$fs=2,r=4.6);") + "}",
    "difference(){color([0.3,0.7,0.3,1]){" + at(-8.2, 2.7, -0.2, "cube(size=[13,5,9],center=false);") +
        "}color([0.9,0.9,0.2,1]){" + at(-4.1, 1.3, 2.2, "cube(size=[4.4,8.2,5.1],center=false);") + "}}",
    "color([0.7,0.2,0.8,0.6]){" + at(5.7, -6.6, -0.4, "cylinder($fn=10,$fa=12,$fs=2,h=8.3,r1=3,r2=2,center=false);") +
        "}"};

constexpr const char* all_effects = R"(
[[lights]]
direction = [-1, 2, -2]
intensity = 0.6
[[materials]]
of_colour = [0.8, 0.8, 0.7]
mirror = 0.4
[effects.smooth]
[effects.shadows]
[effects.edges]
[effects.antialias]
samples = 2
)";

std::vector<std::uint32_t> picture_of(const std::vector<std::string>& some) {
  testing::Setup setup;
  setup.camera = {{38, -52, 41}, {0, 0, 2}, view::Projection::perspective};
  setup.sampling.width = 96;
  setup.sampling.height = 72;
  setup.memory_bits = 1024;
  setup.options.effects = effects::all();
  setup.options.scene = scene::read_scene(all_effects, "all.toml", {}, effects::sections());
  std::string text;
  for (const std::string& one : some) text += one + "\n";
  return testing::draw(testing::compile_text(text, setup).program).colour;
}

}  // namespace

TEST_CASE("a picture with effects does not depend on the order of parts in the file") {
  std::vector<std::string> turned = parts;
  const std::vector<std::uint32_t> first = picture_of(parts);
  for (std::size_t turn = 1; turn < parts.size(); ++turn) {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    CHECK(picture_of(turned) == first);
  }
  std::reverse(turned.begin(), turned.end());
  CHECK(picture_of(turned) == first);
}
