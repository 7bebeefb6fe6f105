#include "hw/isa/opcodes.h"
#include "hw/machines/regions.h"
#include "hw/scan_line/figures.h"
#include "hw/scan_line/kind.h"
#include "hw/scan_line/timing.h"
#include "tests/support/test.h"

using namespace csgsim;
using isa::Field;
using isa::Instruction;
using isa::Opcode;
using scan_line::LineAccount;

namespace {

/// Clocks before the frame's first instruction enters: the host hands over the line, the link takes it, the line's
/// start crosses the link and is taken, and the instruction follows.
constexpr std::uint64_t first_entry = 5;

machines::Machine make_machine(machines::Size picture, std::uint32_t chains, std::uint32_t ports = 0) {
  machines::Machine machine = machines::blank_machine(scan_line::kind);
  machine.name = "test";
  machine.array = {picture.width, 1, 64};
  machine.picture = picture;
  machine.clock_hz = 1000;
  machine.own = scan_line::Figures{.words = 2, .word_bits = 32, .ports = ports, .chains = chains, .refresh_hz = 20};
  return machine;
}

/// Computes the timing of a frame with packets[i] copies of the instruction on line i.
scan_line::LineTiming time(const machines::Machine& machine, const std::vector<std::size_t>& packets,
                           const Instruction& instruction = {.opcode = Opcode::enable_all},
                           const std::vector<isa::RowExtent>& extents = {}) {
  isa::Program program;
  program.extents = extents;
  program.shape = {machine.picture.width, machine.picture.height, 64};
  for (const isa::Region& region : machines::regions(machine)) {
    const std::vector<Instruction> instructions(packets[program.segments.size()], instruction);
    program.segments.push_back({.region = region, .instructions = instructions});
  }
  return scan_line::time_lines(program, machine);
}

LineAccount account_of(const scan_line::LineTiming& timing) { return timing.account; }

const Instruction copy{.opcode = Opcode::copy, .fields = {Field{0, 8}, Field{8, 8}}};

}  // namespace

TEST_CASE("long lines stream back to back and the last crosses the cells and returns") {
  const scan_line::LineTiming timing = time(make_machine({4, 3}, 1), {10, 20, 30});
  CHECK(timing.clocks == first_entry + 11 + 22 + 32 + 2 * 4);
  CHECK(account_of(timing).refresh_clocks == 0);
  CHECK(account_of(timing).busy_cells == 60 * 4);
  CHECK(account_of(timing).link_words == 60 + 3 * 2);
}

TEST_CASE("lines with few packets wait for the refresh path") {
  const scan_line::LineTiming timing = time(make_machine({8, 3}, 1), {2, 1, 0});
  CHECK(timing.clocks == first_entry + 3 + 8 + 8 + 2 * 8);
  CHECK(account_of(timing).refresh_clocks == (8 - 3) + (8 - 2));
}

TEST_CASE("chains take lines in turn over separate links and the slowest ends the frame") {
  const scan_line::LineTiming timing = time(make_machine({4, 5}, 2), {10, 1, 10, 40, 10});
  const std::uint64_t handed_over = 1;  // delay relative to the first line
  CHECK(timing.clocks == handed_over + first_entry + 2 + 42 + 2 * 4);
  CHECK(account_of(timing).entry_clocks == 33 + 2 + 41);
  CHECK(account_of(timing).fill_clocks == first_entry + 1 + 3);
}

TEST_CASE("a packet's entry lasts until the cells' memory ports have done its accesses") {
  const scan_line::LineTiming timing = time(make_machine({4, 2}, 1, 1), {5, 6}, copy);
  CHECK(timing.clocks == first_entry + 2 * 5 + 1 + 1 + 2 * 6 + 1 + 2 * 4);
  CHECK(account_of(timing).fill_clocks == first_entry + 2 + 3);
  CHECK(account_of(timing).busy_cells == 2 * 11 * 4);
}

TEST_CASE("clearing a line of cells takes a packet at its beginning") {
  machines::Machine machine = make_machine({4, 2}, 1, 1);
  machine.clear_clocks = 3;
  CHECK(time(machine, {5, 6}, copy).clocks == first_entry - 1 + 3 + 2 * 5 + 1 + 3 + 2 * 6 + 1 + 2 * 4);
}

TEST_CASE("the host sorts and updates its list and prepares lines while the link transfers") {
  machines::Machine machine = make_machine({2, 3}, 1);
  machine.own = scan_line::Figures{.words = 2,
                                   .word_bits = 32,
                                   .chains = 1,
                                   .bucket_clocks = 7,
                                   .active_clocks = 5,
                                   .instruction_clocks = 3,
                                   .refresh_hz = 20};
  const scan_line::LineTiming timing = time(machine, {2, 2, 0}, {.opcode = Opcode::enable_all}, {{0, 1}});
  const std::uint64_t second_handed_over = 7 + 2 * (5 + 2 * 3 + 1);
  const std::uint64_t third_handed_over = second_handed_over + 5 + 1;  // the primitive leaves the list
  CHECK(timing.clocks == third_handed_over - 1 + first_entry + 1 + 2 * 2);
  CHECK(account_of(timing).host.of(scan_line::LineActivity::sorting) == 7);
  CHECK(account_of(timing).host.of(scan_line::LineActivity::updating) == 3 * 5);
  CHECK(account_of(timing).host.of(scan_line::LineActivity::preparing) == 4 * 3);
  CHECK(account_of(timing).host.of(scan_line::LineActivity::waiting_for_link) == 0);
}

TEST_CASE("the host's clocks depend on row extents and not on instruction purposes") {
  machines::Machine machine = make_machine({2, 3}, 1);
  machines::kind_figures<scan_line::Figures>(machine).bucket_clocks = 7;
  machines::kind_figures<scan_line::Figures>(machine).active_clocks = 5;
  const Instruction plain{.opcode = Opcode::enable_all};
  const Instruction serving{.opcode = Opcode::enable_all, .origin = {.primitive = 0, .node = 1}};
  CHECK(time(machine, {2, 2, 0}, plain).clocks == time(machine, {2, 2, 0}, serving).clocks);
  CHECK(time(machine, {2, 2, 0}, plain, {{0, 1}, {1, 2}}).clocks > time(machine, {2, 2, 0}, plain, {{0, 1}}).clocks);
}

TEST_CASE("a frame of cells below trees ends when the last mark has passed tree and shifts") {
  machines::Machine machine = make_machine({20, 3}, 1);
  const std::uint64_t chained = time(machine, {30, 20, 30}).clocks;
  machines::kind_figures<scan_line::Figures>(machine).network = scan_line::Network::trees;
  machines::kind_figures<scan_line::Figures>(machine).tree_bits = 32;
  const scan_line::LineTiming timing = time(machine, {30, 20, 30});
  CHECK(timing.clocks == first_entry + 31 + 22 + 32 + (5 + 1) + 20);  // 20 cells below 5 levels
  CHECK(timing.clocks == chained - (19 - 5));
  CHECK(account_of(timing).fill_clocks == first_entry + 1 + 5);
  const Instruction wide{.opcode = Opcode::edge_negative, .linear = {.width = 24}};
  machines::kind_figures<scan_line::Figures>(machine).tree_bits = 1;
  CHECK(time(machine, {1, 1, 1}, wide).account.busy_cells == 3 * 24 * 20);
  machines::kind_figures<scan_line::Figures>(machine).tree_bits = 5;
  CHECK(time(machine, {1, 1, 1}, wide).account.busy_cells == 3 * 5 * 20);
}

TEST_CASE("a narrow link transfers a command of a line in several words") {
  machines::Machine machine = make_machine({4, 1}, 1);
  machine.link = {.width = 8, .word_clocks = 3, .fifo_depth = 16, .latency = 10};
  const std::uint64_t words = 9 + 3 + 1;  // the line's start command has 70 bits
  CHECK(time(machine, {3}).clocks == 2 + 10 + 3 * words + 2 + 2 * 4);
}

TEST_CASE("a FIFO of one word before a chain passes a word every other clock") {
  machines::Machine machine = make_machine({4, 1}, 1);
  machine.link.fifo_depth = 1;
  CHECK(time(machine, {3}).clocks == first_entry + 4 + 4 + 2 * 4);
}

TEST_CASE("each line of a field gets an equal share of the refresh time times the chains") {
  machines::Machine machine = make_machine({4, 7}, 1);
  CHECK(scan_line::line_budget(machine, 7) == 7);  // 1000 / (20 * 7)
  machines::kind_figures<scan_line::Figures>(machine).chains = 3;
  CHECK(scan_line::line_budget(machine, 7) == 21);
  machines::kind_figures<scan_line::Figures>(machine).interlaced = true;
  CHECK(scan_line::line_budget(machine, 7) == 3 * 12);  // 1000 / (20 * 4)
}

TEST_CASE("a line is late from the first clock beyond its budget") {
  // The first line includes the link latency before it; the start and the mark of each other line take two clocks.
  const LineAccount account = account_of(time(make_machine({4, 5}, 1), {9, 9, 0, 11, 8}));
  CHECK(account.line_budget == 10);
  CHECK(account.late_lines == 3);
  CHECK(account.packets == 37);
  CHECK(account.max_packets == 11);
}

TEST_CASE("the next frame starts after the last mark unless its first mark would wait") {
  CHECK(time(make_machine({4, 3}, 1), {10, 20, 30}).interval_clocks == first_entry + 11 + 22 + 32);
  const std::uint64_t first_mark = first_entry + 3;
  CHECK(time(make_machine({20, 2}, 1), {2, 2}).interval_clocks == first_mark + 20 + (20 - first_mark));
}
