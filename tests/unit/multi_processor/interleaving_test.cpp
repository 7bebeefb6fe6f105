#include <rapidcheck.h>

#include "hw/machines/regions.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/kind.h"
#include "hw/multi_processor/regions.h"
#include "tests/support/coverage.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

machines::Machine make_machine(isa::ArrayShape nodes, machines::Size picture, std::uint32_t levels) {
  machines::Machine machine = machines::blank_machine(multi_processor::kind);
  machine.array = nodes;
  machine.picture = picture;
  machines::kind_figures<multi_processor::Figures>(machine).levels = levels;
  return machine;
}

}  // namespace

TEST_CASE("subsegments cover every pixel once for any levels and nodes") {
  CHECK(rc::check([] {
    const auto side = [](std::uint32_t most) { return *rc::gen::inRange<std::uint32_t>(1, most); };
    const machines::Size picture{side(50), side(50)};
    const machines::Machine machine =
        make_machine({side(6), side(6), 8}, picture, *rc::gen::inRange<std::uint32_t>(0, 13));
    testing::assert_covered_once(machines::regions(machine), picture);
  }));
}

TEST_CASE("subsegments are listed segment by segment with one per node") {
  const machines::Machine machine = make_machine({4, 3, 8}, {256, 256}, 5);
  const std::vector<isa::Region> all = machines::regions(machine);
  REQUIRE(multi_processor::picture_segments({256, 256}, 5).size() == 32);
  REQUIRE(all.size() == 32 * 12);
  CHECK(multi_processor::picture_segments({256, 256}, 5)[1] == isa::Region{32, 0, 32, 64});
  CHECK(all[0] == isa::Region{0, 0, 8, 22});
  CHECK(all[11] == isa::Region{24, 44, 8, 20});
  CHECK(all[12] == isa::Region{32, 0, 8, 22});
}

TEST_CASE("a node holds exactly the pixels of its remainder") {
  CHECK(rc::check([] {
    const auto below = [](std::uint32_t most) { return *rc::gen::inRange<std::uint32_t>(0, most); };
    const isa::ArrayShape nodes{1 + below(5), 1 + below(5), 8};
    const isa::Region region{below(20), below(20), 1 + below(12), 1 + below(12)};
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
    for (std::uint32_t row = 0; row < nodes.height; ++row) {
      for (std::uint32_t column = 0; column < nodes.width; ++column) {
        const multi_processor::NodePixels own = multi_processor::pixels_of_node(region, nodes, row, column);
        for (std::uint32_t i = 0; i < own.rows; ++i) {
          for (std::uint32_t j = 0; j < own.columns; ++j) {
            const std::uint32_t x = own.first_x + j * nodes.width;
            const std::uint32_t y = own.first_y + i * nodes.height;
            RC_ASSERT(x < region.width && y < region.height);
            RC_ASSERT((region.x + x) % nodes.width == column && (region.y + y) % nodes.height == row);
            RC_ASSERT(seen.insert({x, y}).second);
          }
        }
      }
    }
    RC_ASSERT(seen.size() == std::size_t{region.width} * region.height);
  }));
}
