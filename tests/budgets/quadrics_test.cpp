#include "host/convex/extent.h"
#include "host/csg/positive_tree.h"
#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/kinds/load.h"
#include "hw/machines/clocks.h"
#include "sim/engine/engine.h"
#include "sim/observe/stats.h"
#include "tests/budgets/page.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

// Spheres and a part without facets, on Pixel-Powers. As in counts_test.cpp, totals are checked against a sum by hand
// where possible.

namespace {

struct Drawn {
  isa::Program program;
  machines::Machine machine;
  std::uint64_t clocks;  ///< clocks of the array, with clearing, latency, and waiting for the link
  observe::Stats stats;
};

/// Draws like `csgsim render tests/models/NAME.csg --machine MACHINE --view-all`.
Drawn draw(const std::string& name, const std::string& machine, unsigned z_bits = 20) {
  const model::Tree tree = read::read_csg_file(testing::model_path(name));
  const facet::Box box = convex::extent(facet::make_geometry(tree), csg::make_positive_tree(tree));
  testing::Setup setup;
  setup.exact_curves = true;
  setup.machine = machine;
  setup.memory_bits = 128;
  setup.sampling.z_bits = z_bits;
  setup.camera = view::default_camera(box, setup.sampling.width, setup.sampling.height);
  Drawn drawn{testing::compile_file(testing::model_path(name), setup).program, kinds::load(machine), 0, {}};
  observe::StatsObserver stats(drawn.program);
  const std::array<engine::Observer*, 1> observers{&stats};
  const engine::RunResult result = engine::make_functional_engine(drawn.machine)->run(drawn.program, observers);
  REQUIRE(result.overflows == 0);
  drawn.clocks = result.clocks;
  drawn.stats = stats.stats();
  return drawn;
}

std::uint64_t clocks_for(const Drawn& drawn, isa::Purpose purpose) {
  return drawn.stats.by_purpose.at(static_cast<std::size_t>(purpose)).clocks;
}

std::size_t count(const isa::Program& program, isa::Opcode opcode) {
  const auto& all = program.segments.at(0).instructions;
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [&](const isa::Instruction& one) { return one.opcode == opcode; }));
}

constexpr std::uint64_t enable = 1;
constexpr std::uint64_t depth = 20;
constexpr std::uint64_t root = 19;  // bits: the radius is 2^19 - 2 depth steps

/// Clocks of enable, squares, the discriminant, its root, and the middle minus the root, whose top bit is 0.
constexpr std::uint64_t surface(std::uint64_t root_clocks) {
  constexpr std::uint64_t discriminant = 42;
  return enable + 1 + discriminant + root_clocks + 1 + (depth + 1);
}

}  // namespace

TEST_CASE("a sphere without facets takes 993 clocks of Pixel-Powers and 88 bits") {
  const Drawn sphere = draw("sphere", "pixel-powers");
  static_assert(root * root + 2 * root == 399);
  static_assert(surface(399) == 465);
  CHECK(clocks_for(sphere, isa::Purpose::setup) == enable + depth + 24);
  CHECK(clocks_for(sphere, isa::Purpose::render) == surface(399));
  CHECK(clocks_for(sphere, isa::Purpose::merge) == 2 * depth + enable + depth);
  CHECK(clocks_for(sphere, isa::Purpose::shade) == 247);
  CHECK(sphere.stats.by_primitive.at(0).clocks == 465 + 61 + 247);
  CHECK(sphere.clocks == 993);  // the budget is 1,000; a decrease needs an explanation too
  unsigned bits = 0;
  for (const isa::NamedField& one : sphere.program.facts->fields)
    bits = std::max<unsigned>(bits, one.field.base + one.field.width);
  CHECK(bits == 88);
}

TEST_CASE("a second read port saves 246 clocks of a sphere including 171 of its root") {
  static_assert((root * root + 5 * root) / 2 == 399 - 171);
  const Drawn sphere = draw("sphere", "pixel-powers+memory.reads=2");
  CHECK(clocks_for(sphere, isa::Purpose::render) == surface(399 - 171));
  CHECK(clocks_for(sphere, isa::Purpose::merge) == depth + enable + depth);
  CHECK(clocks_for(sphere, isa::Purpose::shade) == 192);
  CHECK(sphere.clocks == 993 - 246);
}

TEST_CASE("docs/performance.md states the measured clocks of spheres without facets") {
  const auto own = [](const Drawn& drawn) { return drawn.stats.by_primitive.at(0).clocks; };
  budgets::check_row("sphere without facets", budgets::published_sphere, own(draw("sphere", "pixel-powers")));
  const std::string two = "pixel-powers+memory.reads=2";
  budgets::check_row("the same, two read ports", budgets::published_sphere, own(draw("sphere", two)));
  budgets::check_row("the same, 14 bits of depth", budgets::published_sphere, own(draw("sphere", two, 14)));
}

TEST_CASE("docs/performance.md states the measured clocks of the connecting rod") {
  const Drawn rod = draw("connecting_rod", "pixel-powers");
  CHECK(rod.program.facts->primitives.size() == 24);
  CHECK(count(rod.program, isa::Opcode::squares) == 132);
  budgets::check_row("connecting rod", 75'000, rod.clocks);
}
