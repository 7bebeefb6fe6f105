#include "hw/division/model_sizes.h"
#include "hw/isa/host_counts.h"
#include "hw/kinds/load.h"
#include "hw/pixel_square/storage_check.h"
#include "hw/pixel_square/timing_division.h"
#include "tests/support/figure_ranges.h"
#include "tests/support/test.h"
#include "tests/unit/machines/square_timing.h"

// Tests of pixel-square figures by hand calculation: clocks of a divider's tests, rejected operands at their limits,
// and the memory of a machine.

using namespace csgsim;
using namespace csgsim::testing::squares;
using pixel_square::DivisionClocks;
using testing::error_of;

namespace {

/// Figures with a port of 16 bits: reading a primitive of the model takes 5 clocks, a half-space and its plane one
/// each.
Figures hand_calculated_figures() {
  Figures figures = dividing();
  figures.levels = 2;
  figures.list_entries = 100;
  figures.record_bits = 16;
  figures.box_clocks = 2;
  figures.halfspace_clocks = 3;
  figures.cell_clocks = 5;
  figures.node_clocks = 7;
  figures.linear_clocks = 4;
  return figures;
}

isa::Program with_model(std::vector<isa::Segment> segments = {square(2, {})}) {
  isa::Program program = make_program(3, std::move(segments));
  program.display_model = model_bytes();
  return program;
}

constexpr isa::DivisionStep step{.boxes = 3, .lists = 2, .halfspaces = 5, .cells = 7, .nodes = 4};

std::uint64_t tests_with(const Figures& figures, bool from_list = false) {
  const isa::Program program = with_model();
  const Machine machine = make_machine(2, figures);
  return DivisionClocks(program, machine).test_clocks(step, from_list);
}

std::uint64_t group_with(const Figures& figures) {
  const isa::DivisionCounts first{
      .steps = {}, .group_boxes = 3, .group_lists = 2, .group_halfspaces = 5, .group_cells = 7, .group_entries = 11};
  const isa::Program program = with_model();
  const Machine machine = make_machine(2, figures);
  return DivisionClocks(program, machine).group_clocks(first);
}

}  // namespace

TEST_CASE("a divider's surface tests take the sum of their steps and spills") {
  const Figures figures = hand_calculated_figures();
  // A box is read in 5 clocks and held in 2. Each half-space is read in 2 while its predecessor is tested in 3; the
  // read of the first in a list is not hidden.
  constexpr std::uint64_t boxes = 3 * (5 + 2);
  constexpr std::uint64_t lists = 5 * 3 + 2 * 2;
  constexpr std::uint64_t cells = 7 * 5;
  constexpr std::uint64_t nodes = 4 * 7;
  CHECK(tests_with(figures) == boxes + lists + cells + nodes);
  // Reading an entry of the list takes a clock more, so that reading takes as long as testing.
  CHECK(tests_with(figures, true) == 3 * (5 + 1 + 2) + 5 * 3 + 2 * 3 + cells + nodes);
  Figures small = figures;
  small.halfspaces = 5;
  small.nodes = 4;
  CHECK(tests_with(small) == tests_with(figures));
  // One more half-space: an entry of 251 bits and 15 places among 4, 281 bits, is written in 18 clocks and read for
  // each cell.
  small.halfspaces = 4;
  CHECK(tests_with(small) == tests_with(figures) + 18 + 7 * 18);
  small.halfspaces = 5;
  // A node of 98 bits is written and read in 7 clocks each.
  small.nodes = 3;
  CHECK(tests_with(small) == tests_with(figures) + 2 * 7);
  Figures quick = figures;
  quick.halfspace_clocks = 1;
  CHECK(tests_with(quick) == boxes + 5 * 2 + 2 * 1 + cells + nodes);
}

TEST_CASE("a group's tests reread half-spaces per cell and list the rest as far as it fits") {
  Figures figures = hand_calculated_figures();
  constexpr std::uint64_t tests = 3 * (5 + 2) + (5 * 3 + 2 * 2) + 7 * (5 + 3);
  CHECK(group_with(figures) == tests + 11);
  figures.list_entries = 4;
  CHECK(group_with(figures) == tests + 4);
  figures.list_entries = 100;
  figures.halfspace_clocks = 1;
  CHECK(group_with(figures) == 3 * (5 + 2) + (5 * 2 + 2 * 1) + 7 * (5 + 2) + 11);
}

TEST_CASE("a divider takes clocks for its tree and for linear instructions") {
  const isa::Program program = with_model();
  Machine machine = make_machine(2, hand_calculated_figures());
  const DivisionClocks clocks(program, machine);
  CHECK(clocks.tree_clocks() == 3 * 7);
  CHECK(clocks.instruction_clocks(enable) == 0);
  CHECK(clocks.instruction_clocks({.opcode = Opcode::edge_negative}) == 4);
  CHECK(clocks.is_listed(100));
  CHECK_FALSE(clocks.is_listed(101));
  machines::kind_figures<Figures>(machine).levels = 1;
  CHECK_FALSE(DivisionClocks(program, machine).is_listed(0));
}

TEST_CASE("dividers take groups in turn, or single squares if there is one level") {
  isa::Program program = with_model(std::vector<isa::Segment>(6, square(2, {})));
  const std::array<isa::Region, 6> regions{
      isa::Region{0, 0, 2, 2}, {2, 0, 2, 2}, {4, 0, 2, 2}, {6, 0, 2, 2}, {0, 4, 2, 2}, {0, 6, 2, 2}};
  for (std::size_t i = 0; i < regions.size(); ++i) program.segments[i].region = regions[i];
  Machine machine = make_machine(2, hand_calculated_figures());
  auto& figures = machines::kind_figures<Figures>(machine);
  figures.group_side = 2;
  figures.dividers = 2;
  CHECK(pixel_square::divider_of_each_square(program, machine) == std::vector<std::size_t>{0, 0, 1, 1, 0, 0});
  figures.levels = 1;
  CHECK(pixel_square::divider_of_each_square(program, machine) == std::vector<std::size_t>{0, 1, 0, 1, 0, 1});
  figures.dividers = 3;
  CHECK(pixel_square::divider_of_each_square(program, machine) == std::vector<std::size_t>{0, 1, 2, 0, 1, 2});
}

TEST_CASE("each count of a divider's tests may be 2^36 and no more") {
  constexpr std::uint64_t most = std::uint64_t{1} << 36U;
  using Counts = isa::DivisionCounts;
  const std::vector<std::function<void(Counts&, std::uint64_t)>> operands{
      [](Counts& counts, std::uint64_t number) { counts.group_boxes = number; },
      [](Counts& counts, std::uint64_t number) { counts.group_lists = number; },
      [](Counts& counts, std::uint64_t number) { counts.group_halfspaces = number; },
      [](Counts& counts, std::uint64_t number) { counts.group_cells = number; },
      [](Counts& counts, std::uint64_t number) { counts.steps.back().boxes = number; },
      [](Counts& counts, std::uint64_t number) { counts.steps.back().lists = number; },
      [](Counts& counts, std::uint64_t number) { counts.steps.back().halfspaces = number; },
      [](Counts& counts, std::uint64_t number) { counts.steps.back().cells = number; },
      [](Counts& counts, std::uint64_t number) { counts.steps.back().nodes = number; },
  };
  for (std::size_t operand = 0; operand < operands.size(); ++operand) {
    CAPTURE(operand);
    // The last step of the last square has this count.
    isa::Program program = with_model({square(2, {}), square(2, {})});
    isa::DivisionCounts& counts = *program.segments.back().division;
    counts.steps.resize(2);
    operands[operand](counts, most);
    CHECK_NOTHROW(pixel_square::check_countable(program, make_machine(2, dividing())));
    operands[operand](counts, most + 1);
    CHECK(error_of([&] {
            pixel_square::check_countable(program, make_machine(2, dividing()));
          }).starts_with("the divider would test for more than 1152921504606846976 clocks; use a smaller model"));
  }
}

TEST_CASE("a frame's tests may take 2^60 clocks in total") {
  constexpr std::uint64_t many = std::uint64_t{1} << 36U;
  Figures figures = dividing();
  figures.cell_clocks = 1'000'000;
  // 2^36 cells of a million clocks each: 16 of them take less than 2^60 clocks, 17 take more.
  const auto check = [&](std::size_t steps, std::size_t groups) {
    isa::Program program = with_model(std::vector<isa::Segment>(steps + groups, square(2, {})));
    for (std::size_t i = 0; i < steps; ++i) program.segments[i].division->steps = {{.cells = many}};
    for (std::size_t i = steps; i < steps + groups; ++i) program.segments[i].division->group_cells = many;
    return error_of([&] { pixel_square::check_countable(program, make_machine(2, figures)); });
  };
  CHECK(check(16, 0) == "");
  CHECK_FALSE(check(17, 0).empty());
  CHECK(check(0, 16) == "");
  CHECK_FALSE(check(0, 17).empty());
  CHECK_FALSE(check(9, 8).empty());
}

TEST_CASE("a model and its spills must fit the divider's memory to the bit") {
  isa::Program program = with_model();
  const std::uint64_t model_bits = 8 * program.display_model.size();
  const std::uint64_t planes = division::read_model_sizes(program.display_model).planes;
  REQUIRE(planes > 0);
  Figures figures = dividing();
  figures.halfspaces = 2;
  figures.nodes = 5;
  const auto refusal = [&](std::uint64_t bits) {
    figures.model_bits = static_cast<std::uint32_t>(bits);
    return error_of([&] { pixel_square::check_storage(program, make_machine(2, figures)); });
  };
  CHECK(refusal(model_bits) == "");
  // If one bit is missing the planes of 8 bits stay with the host.
  CHECK(refusal(model_bits - 1) == "");
  CHECK(refusal(model_bits - 8 * planes) == "");
  CHECK(refusal(model_bits - 8 * planes - 1).starts_with("the display model has "));
  // A half-space beyond the two takes 251 bits and 15 places among two; a node beyond the five takes 98.
  const auto spilling = [&](std::uint64_t halfspaces, std::uint64_t nodes, std::uint64_t bits) {
    program.segments[0].division->steps = {{.halfspaces = halfspaces, .nodes = nodes}};
    CHECK(refusal(model_bits + bits) == "");
    if (bits > 0) CHECK(refusal(model_bits + bits - 1).starts_with("the square at 0,0 needs ") == (bits > 8 * planes));
  };
  spilling(2, 5, 0);
  spilling(3, 5, 266);
  spilling(2, 6, 98);
  spilling(4, 7, 2 * 266 + 2 * 98);
}

TEST_CASE("a machine's memory includes its pixels and pictures and stores and dividers") {
  Figures figures = dividing();
  figures.renderers = 3;
  figures.backing_bits = 5;
  figures.pictures = 2;
  figures.dividers = 2;
  figures.levels = 2;
  figures.list_entries = 10;
  figures.model_bits = 1000;
  figures.halfspaces = 4;
  figures.nodes = 6;
  figures.store_words = 7;
  Machine machine = make_machine(2, figures);
  isa::FrameHeader header;
  header.shape = {4, 4, 16};
  header.colour = {0, 3};
  const auto resources = [&] { return machine.kind->resources(machine, header); };
  // 12 pixels of 16 and 5 bits; two pictures of 16 pixels; for each divider the model, 10 entries of 32 bits, 4
  // half-spaces of 281 bits, 6 nodes of 98, 7 words of 256.
  constexpr std::uint64_t of_pixels = 12 * (16 + 5) + 2 * 16 * 3;
  constexpr std::uint64_t of_divider = 1000 + 10 * 32 + 4 * 281 + 6 * 98 + 7 * 256;
  CHECK(resources().processors == 12);
  CHECK(resources().memory_bits == of_pixels + 2 * of_divider);
  machines::kind_figures<Figures>(machine).levels = 1;
  CHECK(resources().memory_bits == of_pixels + 2 * (of_divider - 320));
  machines::kind_figures<Figures>(machine).divider = pixel_square::DividerKind::host;
  CHECK(resources().memory_bits == of_pixels);
}

TEST_CASE("a second buffer holds one waiting square and a backing store as many as fit") {
  CHECK(pixel_square::waiting_square_capacity({.buffers = 1}, 24) == 0);
  CHECK(pixel_square::waiting_square_capacity({.buffers = 2}, 24) == 1);
  CHECK(pixel_square::waiting_square_capacity({.buffers = 1, .backing_bits = 48}, 24) == 2);
  CHECK(pixel_square::waiting_square_capacity({.buffers = 1, .backing_bits = 47}, 24) == 1);
  CHECK(pixel_square::waiting_square_capacity({.buffers = 2, .backing_bits = 23}, 24) == 0);
  CHECK(pixel_square::waiting_square_capacity({.buffers = 2, .backing_bits = 5}, 0) == 5);
}

TEST_CASE("queries take one clock per level of a renderer's OR") {
  Figures figures = dividing();
  figures.divider = pixel_square::DividerKind::host;
  figures.has_global_or = true;
  Machine machine = make_machine(8, figures);
  const isa::Instruction query{.opcode = Opcode::skip_if_none, .constant = 1};
  const auto clocks = [&](std::uint32_t fan_in) {
    machines::kind_figures<Figures>(machine).or_fan_in = fan_in;
    return machine.kind->clocks(query, machine);
  };
  const std::uint64_t at_once = clocks(0);
  CHECK(clocks(64) == at_once + 1);  // 64 pixels
  CHECK(clocks(63) == at_once + 2);
  CHECK(clocks(8) == at_once + 2);
  CHECK(clocks(7) == at_once + 3);
  CHECK(clocks(2) == at_once + 6);
  CHECK(machine.kind->clocks(enable, machine) == 1);
}

TEST_CASE("each parameter of a pixel-square machine is accepted up to its limits") {
  constexpr std::int64_t million = 1'000'000;
  constexpr auto ranges = std::to_array<testing::FigureRange>({
      {"global_or.present", 0, 1},
      {"global_or.fan_in", 2, 65'536},
      {"renderers.count", 1, 1024},
      {"renderers.buffers", 1, 2},
      {"renderers.move_bits", 1, 32},
      {"renderers.latch_bits", 1, 32},
      {"backing.bits", 0, 1 << 20},
      {"backing.width", 1, 1 << 20},
      {"port.width", 1, 65'536},
      {"port.fifo_depth", 1, million},
      {"frame_buffer.banks", 1, 1024},
      {"frame_buffer.pictures", 1, 2},
      {"refresh.rate", 1, 1000},
      {"refresh.bits", 1, 1 << 24},
      {"refresh.clocks", 1, 1000},
      {"processors.count", 1, 1024},
      {"ring.channels", 1, 4096},
      {"ring.width", 1, 256},
      {"ring.word_clocks", 1, million},
      {"divider.count", 1, 64},
      {"divider.levels", 1, 2},
      {"divider.group", 1, 1024},
      {"divider.list", 0, 1000 * million},
      {"divider.memory", 1, 4000 * million},
      {"divider.port", 1, 256},
      {"divider.halfspaces", 1, 1000 * million},
      {"divider.nodes", 1, 1000 * million},
      {"divider.store", 1, 1000 * million},
      {"divider.box_clocks", 0, million},
      {"divider.halfspace_clocks", 0, million},
      {"divider.cell_clocks", 0, million},
      {"divider.node_clocks", 0, million},
      {"divider.linear_clocks", 0, million},
  });
  testing::check_figure_ranges("pixel-square", ranges, [](const std::string& machine) { return kinds::load(machine); });
}