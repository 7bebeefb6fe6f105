#include "sim/functional/tiles.h"

#include "hw/isa/opcodes.h"
#include "sim/functional/tile.h"
#include "sim/reference/reference_array.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"
#include "tests/unit/functional/pixels.h"

using namespace csgsim;
using namespace csgsim::testing;

namespace {

constexpr std::uint32_t memory_bits = 24;

isa::Program program_of(const isa::Region& region) {
  isa::Program program;
  program.shape = {region.x + region.width, region.y + region.height, memory_bits};
  return program;
}

isa::Region any_region() {
  const auto side = [] { return *rc::gen::element<std::uint32_t>(1, 7, 63, 64, 65, 128, 129, between(1U, 200U)); };
  const std::uint32_t width = side();
  return {between(0U, 5U), between(0U, 5U), width, width < 10 ? side() : between(1U, 70U)};
}

std::vector<isa::Instruction> any_instructions(const isa::Region& region) {
  std::vector<isa::Instruction> instructions{{isa::Opcode::enable_all, {}, {}, 0, {}}};
  const int count = between(0, 20);
  for (int i = 0; i < count; ++i) {
    instructions.push_back(*test::arbitrary_instruction({region.width, region.height, memory_bits}, memory_bits, 1));
  }
  return instructions;
}

functional::Decide any_decide() {
  return *rc::gen::element(functional::Decide::by_block, functional::Decide::by_pixel);
}

struct State {
  std::vector<std::uint32_t> memory;
  std::vector<std::uint64_t> enable;

  bool operator==(const State&) const = default;
};

State state_of(const engine::PixelState& pixels) {
  const isa::Region region = pixels.region();
  State state;
  state.memory.resize(std::size_t{region.width} * region.height);
  state.enable.resize(std::size_t{(region.width + 63) / 64} * region.height, ~std::uint64_t{0});
  pixels.read_field({0, memory_bits}, state.memory);
  pixels.read_enable(state.enable);
  return state;
}

/// Checks that the tiles of a region execute instructions like individually processed pixels.
void check_run(functional::Tiles& tiles, const isa::Region& region) {
  tiles.begin(region);
  reference::ReferenceArray pixels(region, memory_bits);
  RC_ASSERT(tiles.region() == region);
  RC_ASSERT(state_of(tiles) == state_of(pixels));
  const std::vector<isa::Instruction> instructions = any_instructions(region);
  std::vector<std::uint64_t> enabled;
  for (const isa::Instruction& instruction : instructions) {
    enabled.push_back(pixels.enabled_pixels());
    pixels.execute(instruction);
  }
  std::vector<std::uint64_t> counted;
  std::uint64_t overflows = 0;
  for (std::span<const isa::Instruction> left = instructions; !left.empty();) {
    const functional::Stretch stretch(left, {});
    const functional::Tiles::Tally tally = tiles.execute(stretch);
    counted.insert(counted.end(), tally.enabled.begin(), tally.enabled.end());
    overflows += tally.overflows;
    left = left.subspan(stretch.size());
  }
  RC_ASSERT(counted == enabled);
  RC_ASSERT(overflows == pixels.overflows());
  RC_ASSERT(state_of(tiles) == state_of(pixels));
}

}  // namespace

TEST_CASE("pixels of a region do not depend on tiles and threads") {
  CHECK(rc::check([] {
    const isa::Region region = any_region();
    const isa::Program program = program_of(region);
    functional::Tiles tiles(program, between(1U, 8U), any_decide());
    check_run(tiles, region);
  }));
}

TEST_CASE("a segment starts with memory and enable 0 after any other segment") {
  CHECK(rc::check([] {
    const isa::Program program = program_of({0, 0, 200, 10});
    functional::Tiles tiles(program, between(1U, 4U), any_decide());
    const isa::Region region = any_region();
    check_run(tiles, region);
    check_run(tiles, {region.x + 1, region.y + 1, region.width, region.height});
    check_run(tiles, any_region());
  }));
}

TEST_CASE("clearing a tile discards pending squares") {
  const isa::Linear squares{.a = 1, .b = 0, .c = 0, .width = 12};
  const isa::Linear below_0{.a = 0, .b = 0, .c = -1, .width = 12};
  functional::Tile tile(0, 0, functional::TileShape(8, 8), memory_bits, functional::Decide::by_block);
  tile.execute({.opcode = isa::Opcode::enable_all});
  tile.execute({.opcode = isa::Opcode::squares, .linear = squares});
  tile.clear();
  tile.execute({.opcode = isa::Opcode::enable_all});
  tile.execute({.opcode = isa::Opcode::edge_negative, .linear = below_0});
  CHECK(tile.enabled() == 64);
}
