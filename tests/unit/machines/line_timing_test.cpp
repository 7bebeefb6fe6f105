#include <doctest/doctest.h>

#include <variant>
#include <vector>

#include "hw/machines/regions.h"
#include "hw/machines/timing.h"

using namespace csgsim;
using isa::Field;
using isa::Instruction;
using isa::Opcode;
using machines::LineAccount;

namespace {

machines::Machine machine_of(machines::Size picture, std::uint32_t chains, std::uint32_t interval) {
  machines::Machine machine;
  machine.name = "test";
  machine.kind = machines::Kind::scan_line;
  machine.array = {picture.width, 1, 64};
  machine.picture = picture;
  machine.clock_hz = 1000;
  machine.scan_line = {.words = 2, .word_bits = 32, .chains = chains, .packet_interval = interval, .refresh_hz = 20};
  return machine;
}

/// As many packets of one word on each line as the numbers say.
machines::FrameTiming time(const machines::Machine& machine, const std::vector<std::size_t>& packets) {
  isa::Program program;
  program.shape = {machine.picture.width, machine.picture.height, 64};
  for (const isa::Region& region : machines::regions(machine)) {
    const std::vector<Instruction> instructions(packets[program.segments.size()], {.opcode = Opcode::enable_all});
    program.segments.push_back({.region = region, .instructions = instructions});
  }
  return machines::time_lines(program, machine);
}

LineAccount account_of(const machines::FrameTiming& timing) { return std::get<LineAccount>(timing.account); }

}  // namespace

TEST_CASE("lines of many packets follow back to back, and the last has its way through the cells and back") {
  const machines::FrameTiming timing = time(machine_of({4, 3}, 1, 1), {10, 20, 30});
  CHECK(timing.clocks == 11 + 21 + 31 + 2 * 4);
  CHECK(account_of(timing).refresh_clocks == 0);
  CHECK(account_of(timing).busy_cells == 60 * 4);
}

TEST_CASE("lines of few packets wait for the refresh path") {
  const machines::FrameTiming timing = time(machine_of({8, 3}, 1, 1), {2, 1, 0});
  CHECK(timing.clocks == 3 + 8 + 8 + 2 * 8);
  CHECK(account_of(timing).refresh_clocks == (8 - 2) + (8 - 1));
}

TEST_CASE("chains take lines in turn, and the frame ends with the chain that ends last") {
  const machines::FrameTiming timing = time(machine_of({4, 5}, 2, 1), {10, 1, 10, 30, 10});
  CHECK(timing.clocks == 3 * 11 + 2 * 4);
  CHECK(account_of(timing).entry_clocks == 33 + 2 + 31);
  CHECK(account_of(timing).fill_clocks == 1 + 3);
}

TEST_CASE("each word takes the packet interval to enter") {
  const machines::FrameTiming timing = time(machine_of({4, 2}, 1, 3), {5, 6});
  CHECK(timing.clocks == 3 * (6 + 7) + 2 * 4);
  CHECK(account_of(timing).fill_clocks == 3 + 3);
}

TEST_CASE("the refresh gives each line of a field an equal share of its time, times the chains") {
  machines::Machine machine = machine_of({4, 7}, 1, 1);
  CHECK(machines::line_budget(machine, 7) == 7);  // 1000 / (20 * 7)
  machine.scan_line.chains = 3;
  CHECK(machines::line_budget(machine, 7) == 21);
  machine.scan_line.interlaced = true;
  CHECK(machines::line_budget(machine, 7) == 3 * 12);  // 1000 / (20 * 4)
}

TEST_CASE("a line is late from the first packet on that its budget does not hold") {
  const LineAccount account = account_of(time(machine_of({4, 5}, 1, 1), {9, 10, 0, 11, 8}));
  CHECK(account.line_budget == 10);
  CHECK(account.late_lines == 2);
  CHECK(account.packets == 38);
  CHECK(account.most_packets == 11);
}
