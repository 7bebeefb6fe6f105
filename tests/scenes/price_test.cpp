#include "host/effects/rows.h"
#include "host/scene/read.h"
#include "hw/kinds/load.h"
#include "hw/machines/clocks.h"
#include "sim/engine/engine.h"
#include "sim/observe/stats.h"
#include "tests/scenes/scene_file.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

constexpr std::uint32_t side = 256;  // width and height of a picture in pixels
constexpr std::size_t every = 3;     // measures every third primitive

testing::SceneFile vehicle(const std::string& scene) {
  return {"vehicle",
          scene,
          testing::model_path("terrain_vehicle"),
          {{560, -590, 420}, {-5, 0, 68}, view::Projection::orthographic}};
}

observe::Stats run(const testing::Compiled& compiled) {
  machines::Machine machine = kinds::load("pixel-planes-4");
  machines::adopt_shape(machine, compiled.program);
  observe::StatsObserver stats(compiled.program);
  const std::array<engine::Observer*, 1> observers{&stats};
  engine::make_functional_engine(machine)->run(compiled.program, observers);
  return stats.stats();
}

/// Clocks for the surfaces of all primitives with pixels in the rectangle of this one.
std::uint64_t work_in_rectangle(const testing::Compiled& compiled, const observe::Stats& stats, std::size_t primitive) {
  std::uint64_t clocks = 0;
  const view::PixelRect& own = compiled.view.extents[primitive].pixels;
  for (std::size_t i = 0; i < compiled.tree.primitives.size(); ++i) {
    if (!common(compiled.view.extents[i].pixels, own).empty()) clocks += stats.by_primitive[i].clocks;
  }
  return clocks;
}

std::string only_line(const model::Primitive& primitive) {
  return "from_line = " + std::to_string(primitive.location.line) + "\n";
}

/// Highest price of an effect on one primitive, relative to the work of its rectangle, where `price` gives one.
template <class Price>
double worst_ratio(const std::string& effect, const Price& price) {
  const testing::DrawnScene plain = testing::compile_scene(vehicle(""), side, side);
  const observe::Stats stats = run(plain.compiled);
  double worst = 0;
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < plain.compiled.tree.primitives.size(); i += every) {
    const std::uint64_t clocks = price(plain.compiled, i);
    const std::uint64_t work = work_in_rectangle(plain.compiled, stats, i);
    if (clocks == 0 || work == 0) continue;
    const double ratio = static_cast<double>(clocks) / static_cast<double>(work);
    worst = std::max(worst, ratio);
    sum += ratio;
    ++count;
  }
  MESSAGE(effect, ": ", count, " primitives, ", worst, " times the clocks of overlapping surfaces at most, ",
          sum / count, " on average");
  return worst;
}

/// Clocks charged to the second effect of a scene; the first is flat shading.
std::uint64_t charged(const std::string& scene) {
  const observe::Stats stats = run(testing::compile_scene(vehicle(scene), side, side).compiled);
  return stats.by_effect.size() < 3 ? 0 : stats.by_effect[1].clocks;
}

constexpr double most = 1.2;

}  // namespace

TEST_CASE("glass on a primitive takes at most 1.2 times the clocks of overlapping surfaces") {
  CHECK(worst_ratio("transparency", [](const testing::Compiled& compiled, std::size_t i) {
          return charged("[[materials]]\n" + only_line(compiled.tree.primitives[i]) + "opacity = 0.5\n");
        }) <= most);
}

TEST_CASE("a primitive's shadow takes at most 1.2 times the clocks of overlapping surfaces") {
  CHECK(worst_ratio("shadows", [](const testing::Compiled& compiled, std::size_t i) {
          return charged("[[lights]]\ndirection = [-0.5, 0.75, -0.9]\n[effects.shadows]\n" +
                         only_line(compiled.tree.primitives[i]));
        }) <= most);
}

TEST_CASE("a primitive's smoothness takes at most 1.2 times overlapping surfaces' clocks") {
  const testing::DrawnScene smooth = testing::compile_scene(vehicle("[effects.smooth]\n"), side, side);
  const machines::Machine machine = kinds::load("pixel-planes-4");
  CHECK(worst_ratio("smooth", [&](const testing::Compiled& /*compiled*/, std::size_t i) {
          std::uint64_t clocks = 0;
          for (const isa::Segment& segment : smooth.compiled.program.segments)
            for (const isa::Instruction& one : segment.instructions)
              if (one.origin.effect == 1 && one.origin.primitive == i) clocks += machines::clocks(one, machine);
          return clocks;
        }) <= most);
}

namespace {

/// A floor below thin triangular plates, which neither hide nor shade one another.
std::string plates(int count) {
  std::string text = "multmatrix([[1,0,0,-60],[0,1,0,-60],[0,0,1,-2],[0,0,0,1]]){cube(size=[120,120,2],center=false);}";
  for (int i = 0; i < count; ++i) {
    text +=
        "multmatrix([[1,0,0," + std::to_string(-40 + 25 * i) +
        "],[0,1,0,-20],[0.1,0.2,1,12],[0,0,0,1]]){polyhedron(points=[[0,0,0],[11,2,0],[3,13,0],[0,0,0.5],[11,2,0.5],"
        "[3,13,0.5]],faces=[[0,1,2],[5,4,3],[0,3,4,1],[1,4,5,2],[2,5,3,0]],convexity=1);}";
  }
  return text;
}

/// Clocks of all instructions for a number of plates.
std::uint64_t clocks_of_plates(int count, const std::string& scene) {
  testing::Setup setup;
  setup.camera = {{90, -140, 110}, {0, 0, 0}, view::Projection::orthographic};
  setup.memory_bits = 256;
  setup.options.effects = effects::all();
  setup.options.scene = scene::read_scene(scene, "plates.toml", {}, effects::sections());
  return run(testing::compile_text(plates(count), setup)).total.clocks;
}

}  // namespace

TEST_CASE("an extra triangle with its shadow costs at most twice the published estimate") {
  const std::string lit = "[[lights]]\ndirection = [0.2, 0.4, -1]\n";
  const std::uint64_t plain = clocks_of_plates(3, lit) - clocks_of_plates(2, lit);
  const std::string shadows = lit + "[effects.shadows]\n";
  const std::uint64_t shadowed = clocks_of_plates(3, shadows) - clocks_of_plates(2, shadows);
  MESSAGE(plain, " clocks, ", shadowed, " with shadow; published: 333 and 476");
  CHECK(plain > 200);
  CHECK(plain < 2 * 333);
  CHECK(shadowed > plain);
  CHECK(shadowed < 2 * 476);
}
