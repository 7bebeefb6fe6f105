#include "host/effects/rows.h"
#include "host/lighting/lighting.h"
#include "host/read/read.h"
#include "host/scene/read.h"
#include "hw/kinds/load.h"
#include "sim/software/tracing/trace.h"
#include "sim/software/tree/tree.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;
using software::VisibleSurface;

namespace {

constexpr std::uint32_t side = 400;

/// A model in a scene, drawn by a machine with some keys set.
struct Drawn {
  testing::Compiled compiled;
  scene::Scene scene;
  observe::Frame frame;
};

Drawn drawn(const std::string& csg, const view::Camera& camera, const std::string& text,
            const std::vector<std::string>& sets) {
  scene::Scene scene = scene::read_scene(text, "test.toml", sets, effects::sections());
  machines::Machine machine = kinds::load("pixel-planes-4");
  machines::set_picture_size(machine, {side, side});
  machine.array.memory_bits = 4096;
  view::Sampling sampling;
  sampling.width = side;
  sampling.height = side;
  emit::Options options;
  options.scene = scene;
  options.effects = effects::all();
  model::Tree tree = effects::reshape_model(read::read_csg_text(csg, "test"), scene);
  facet::Geometry facets = facet::make_geometry(tree);
  view::View view = view::make_view(facets, tree, camera, sampling);
  isa::Program program = emit::compile(tree, facets, view, machine, options);
  observe::Frame frame = testing::draw(program);
  return {
      {std::move(tree), std::move(facets), std::move(view), std::move(program)}, std::move(scene), std::move(frame)};
}

std::vector<software::TracedPixel> traced(const testing::Compiled& compiled, const scene::Scene& look,
                                          software::TraceOptions options) {
  const software::Tree tree = software::make_tree(compiled.tree, software::Shape::balanced);
  const software::TraceScene scene(compiled.tree, compiled.scene, compiled.view, tree);
  for (const lighting::CameraSpaceLight& light : lighting::make_lighting(look, compiled.view.camera).lights)
    options.lights.push_back(
        {light.is_point, light.is_point ? scene.place_of(light.where) : scene.direction_of(light.where)});
  if (options.mirrors.empty()) options.mirrors.assign(scene.facets().facets.size(), 0);
  const auto directory = software::directory_of("excell").make(scene.shapes(), {});
  return software::trace(scene, *directory, options, false).pixels;
}

/// Whether values of a picture differ within `within` pixels of a place.
template <class Value>
bool is_at_edge(const Value& value, std::size_t pixel, int within) {
  const int x = static_cast<int>(pixel % side);
  const int y = static_cast<int>(pixel / side);
  for (int v = std::max(0, y - within); v <= std::min(static_cast<int>(side) - 1, y + within); ++v) {
    for (int u = std::max(0, x - within); u <= std::min(static_cast<int>(side) - 1, x + within); ++u) {
      if (value(static_cast<std::size_t>(v) * side + static_cast<std::size_t>(u)) != value(pixel)) return true;
    }
  }
  return false;
}

struct Tally {
  std::size_t judged = 0;
  std::size_t dark = 0;
  std::size_t differ = 0;
  std::size_t neither = 0;  ///< neither as bright as with the light nor as dark as without it
};

/// Compares the machine's shadows, obtained from pictures without shadows and without the light, with ray-traced ones.
Tally judge_shadows(const std::string& csg, const view::Camera& camera, const std::string& light) {
  const std::string text = "[ambient]\nintensity = 0.3\n[[lights]]\n" + light + "\n[effects.shadows]\n";
  const Drawn with = drawn(csg, camera, text, {});
  const Drawn bright = drawn(csg, camera, text, {"effects.shadows.on=false"});
  const Drawn dark = drawn(csg, camera, text, {"effects.shadows.on=false", "lights.0.intensity=0"});
  software::TraceOptions options;
  options.has_shadows = true;
  const std::vector<software::TracedPixel> pixels = traced(with.compiled, with.scene, options);
  Tally tally;
  const auto is_lit = [&](std::size_t pixel) { return with.frame.colour[pixel] == bright.frame.colour[pixel]; };
  const auto facet = [&](std::size_t pixel) { return pixels[pixel].surface.facet; };
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (bright.frame.colour[i] == dark.frame.colour[i]) continue;  // the light does not affect the pixel
    ++tally.judged;
    tally.dark += is_lit(i) ? 0U : 1U;
    tally.neither += is_lit(i) || with.frame.colour[i] == dark.frame.colour[i] ? 0U : 1U;
    if (is_lit(i) == (pixels[i].surface.lit != 0)) continue;
    ++tally.differ;
    // Depth is quantized, so a shadow's edge may be off by a part of a pixel.
    CHECK((is_at_edge(is_lit, i, 1) || is_at_edge(facet, i, 1)));
  }
  return tally;
}

constexpr const char* things =
    "multmatrix([[1,0,0,-30],[0,1,0,-30],[0,0,1,-2],[0,0,0,1]]){cube(size=[60,60,2],center=false);}\n"
    "difference(){\n"
    "multmatrix([[0.8,-0.6,0,-8],[0.6,0.8,0,2],[0,0,1,1],[0,0,0,1]]){cube(size=[16,12,14],center=false);}\n"
    "multmatrix([[1,0,0,-8],[0,1,0,8],[0,0,1,15],[0,0,0,1]]){sphere($fn=18,r=6);}\n"
    "multmatrix([[1,0,0,-2],[0,0,-1,30],[0,1,0,6],[0,0,0,1]]){cylinder($fn=14,h=60,r1=3,r2=3,center=false);}\n"
    "}\n"
    "multmatrix([[1,0,0,14],[0,1,0,-12],[0,0,1,0],[0,0,0,1]]){cylinder($fn=9,h=18,r1=5,r2=1,center=false);}\n"
    "intersection(){\n"
    "multmatrix([[1,0,0,-18],[0,1,0,-16],[0,0,1,4],[0,0,0,1]]){sphere($fn=16,r=6);}\n"
    "multmatrix([[1,0,0,-18],[0,1,0,-16],[0,0,1,4],[0,0,0,1]]){cube(size=[9,9,9],center=true);}\n"
    "}\n";

const view::Camera above{{70, -90, 75}, {0, 0, 3}, view::Projection::perspective};

}  // namespace

TEST_CASE("the machine's shadows equal ray-traced ones except at their edges") {
  const view::Camera beside{{60, -110, 60}, {0, 0, 3}, view::Projection::orthographic};
  for (const auto& [camera, light] :
       {std::pair{above, "direction = [0.4, 0.7, -1]"}, std::pair{above, "direction = [-0.7, 0.2, -0.6]"},
        std::pair{beside, "direction = [-1, 0.3, -0.5]"},
        std::pair{above, "kind = \"point\"\nposition = [20, -30, 50]"},
        std::pair{beside, "kind = \"point\"\nposition = [-40, -10, 30]"}}) {
    const std::string said(light);
    CAPTURE(said);
    const Tally tally = judge_shadows(things, camera, light);
    MESSAGE(tally.judged, " lit pixels, ", tally.dark, " in shadow, ", tally.differ, " differ");
    CHECK(tally.neither == 0);
    CHECK(tally.judged > 50'000);
    CHECK(tally.dark > tally.judged / 60);
    CHECK(tally.differ * 20'000 <= tally.judged);
  }
}
TEST_CASE("shadows on the thesis's models equal ray-traced ones except at their edges") {
  for (const testing::ThesisObject& one : testing::thesis_objects(view::Projection::perspective)) {
    if (one.name != "terrain_vehicle" && one.name != "carburettor") continue;
    CAPTURE(one.name);
    std::ifstream file(testing::model_path(one.name));
    std::ostringstream csg;
    csg << file.rdbuf();
    const Tally tally = judge_shadows(csg.str(), one.camera, "direction = [0.4, 0.7, -1]");
    MESSAGE(tally.judged, " lit pixels, ", tally.dark, " in shadow, ", tally.differ, " differ");
    CHECK(tally.dark > tally.judged / 60);
    CHECK(tally.neither == 0);
    CHECK(tally.differ * 10'000 <= tally.judged);
  }
}
TEST_CASE("the machine's mirrors equal ray-traced ones except at their edges") {
  // Each primitive's line has a colour and the only light is ambient, so the colour identifies the visible surface.
  constexpr std::array<std::array<double, 3>, 10> palette{{{1, 0, 0},
                                                           {0, 0, 0},
                                                           {0, 1, 0},
                                                           {0, 0, 1},
                                                           {1, 1, 0},
                                                           {0, 0, 0},
                                                           {0, 1, 1},
                                                           {0, 0, 0},
                                                           {1, 0, 1},
                                                           {0.5, 0.5, 0.5}}};
  std::string text =
      "[background]\ncolour = [1, 1, 1]\n[ambient]\nintensity = 1\n[[lights]]\ndirection = [0, 0, -1]\nintensity = 0\n";
  for (std::size_t i = 0; i < palette.size(); ++i)
    text += fmt::format("[[materials]]\nfrom_line = {}\ncolour = [{}, {}, {}]\n{}", i + 1, palette[i][0], palette[i][1],
                        palette[i][2], i == 0 ? "mirror = 1\n" : "");
  const Drawn with = drawn(things, above, text, {});
  software::TraceOptions options;
  options.mirror_depth = 1;
  options.mirrors.assign(with.compiled.scene.halfspaces(), 0);
  for (std::size_t i = 0; i < with.compiled.scene.solids[0].halfspaces.size(); ++i) options.mirrors[i] = 1;
  const std::vector<software::TracedPixel> pixels = traced(with.compiled, with.scene, options);
  const auto expected = [&](std::size_t pixel) {
    const software::TracedPixel& one = pixels[pixel];
    return one.mirrored.empty() ? one.surface.owner : one.mirrored.back().owner;
  };
  const auto facet = [&](std::size_t pixel) {
    const software::TracedPixel& one = pixels[pixel];
    return one.mirrored.empty() ? one.surface.facet : one.mirrored.back().facet;
  };
  std::size_t mirrored = 0;
  std::size_t differ = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (pixels[i].mirrored.empty()) continue;
    mirrored += expected(i) == VisibleSurface::nothing_seen ? 0U : 1U;
    std::array<double, 3> colour{1, 1, 1};
    if (expected(i) != VisibleSurface::nothing_seen)
      colour = palette[with.compiled.tree.primitives[expected(i)].location.line - 1];
    int off = 0;
    for (int channel = 0; channel < 3; ++channel) {
      const int shown = static_cast<int>(with.frame.colour[i] >> (8 * static_cast<unsigned>(channel)) & 255U);
      const int in_order = static_cast<int>(colour[static_cast<std::size_t>(2 - channel)] * 255.0 + 0.5);
      off = std::max(off, std::abs(shown - in_order));
    }
    if (off <= 3) continue;
    ++differ;
    CHECK((is_at_edge(expected, i, 1) || is_at_edge(facet, i, 1)));
  }
  MESSAGE(mirrored, " pixels show a surface in a mirror, ", differ, " differ");
  CHECK(mirrored > 10'000);
  CHECK(differ * 2000 <= mirrored);
}
