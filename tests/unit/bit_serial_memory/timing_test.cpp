#include "hw/bit_serial_memory/timing.h"

#include "tests/support/test.h"

using namespace csgsim;
using bit_serial_memory::Figures;
using bit_serial_memory::RankTiming;
using bit_serial_memory::RowCommand;
using bit_serial_memory::RowCommands;
using bit_serial_memory::RowOp;
using bit_serial_memory::Slots;
using bit_serial_memory::WordLines;

namespace {

/// About DDR4-2400; the sums below are of these figures, and figures_test.cpp has those of the machines.
Figures ddr4() {
  Figures figures;
  figures.chips = 1;
  figures.row_bits = 64;
  figures.banks = 16;
  figures.bus_bits = 16;
  figures.plane_bits = 16;
  figures.command = {.restore = 39, .precharge = 16, .second = 5, .logic = 4, .column = 32, .recovery = 19};
  figures.rank = {.activation_gap = 4, .window = 26};
  return figures;
}

const RowCommand copy{.op = RowOp::copy, .from = WordLines(0), .to = WordLines(1)};
const RowCommand activate{.op = RowOp::activate, .from = WordLines(0)};
const RowCommand read{.op = RowOp::read, .from = WordLines(0)};
const RowCommand write{.op = RowOp::write, .to = WordLines(0)};
const RowCommand logic{.op = RowOp::logic};
const RowCommand send{.op = RowOp::send, .from = WordLines(0)};

std::uint64_t clocks(const Figures& figures, std::uint64_t slots, const RowCommands& commands) {
  return RankTiming(figures, {slots * figures.row_bits, figures.row_bits, figures.banks}).clocks(commands);
}

}  // namespace

TEST_CASE("a copy of a row takes tRAS, tRP and the time to its second activation, an activation tRAS and tRP") {
  CHECK(clocks(ddr4(), 1, {}) == 0);
  CHECK(clocks(ddr4(), 1, {copy}) == 5 + 39 + 16);
  CHECK(clocks(ddr4(), 1, {activate}) == 39 + 16);
  CHECK(clocks(ddr4(), 1, {copy, copy, activate}) == 60 + 60 + 55);
  CHECK(clocks(ddr4(), 1, {read, logic, logic, write}) == 55 + 4 + 4 + 55);
}

TEST_CASE("banks work side by side as far as tRRD and tFAW allow") {
  Figures figures = ddr4();
  // Activations at 0, 4, 8, 12, and the fifth at 26.
  CHECK(clocks(figures, 4, {read}) == 12 + 55);
  CHECK(clocks(figures, 5, {read}) == 26 + 55);
  // Two for each copy: 0, 5, 9, 14, 26, 31.
  CHECK(clocks(figures, 2, {copy}) == 14 + 55);
  CHECK(clocks(figures, 3, {copy}) == 31 + 55);
  figures.rank.window = 0;
  CHECK(clocks(figures, 3, {copy}) == 23 + 55);
}

TEST_CASE("subarrays of one bank follow each other, but their gates work at once") {
  Figures figures = ddr4();
  figures.banks = 1;
  CHECK(clocks(figures, 3, {read, logic, write}) == 3 * 55 + 4 + 3 * 55);
}

TEST_CASE("a row goes to the host over one bus") {
  // 64 bits in 4 clocks, 32 after the activation; then the row is closed.
  CHECK(clocks(ddr4(), 1, {send}) == 32 + 4 + 19 + 16);
  CHECK(clocks(ddr4(), 3, {send}) == 32 + 3 * 4 + 19 + 16);
}

TEST_CASE("a refresh that is due waits until all banks are closed, and all else goes on later by as much") {
  Figures figures = ddr4();
  figures.rank.refresh_interval = 100;
  figures.rank.refresh = 40;
  RankTiming rank(figures, {4 * 64, 64, 16});
  const RowCommands reads(3, read);
  const std::uint64_t alone = rank.clocks(reads);
  // Reads of the first bank begin at 0 and 55; the third would at 110, when the last bank closes at 55 + 12 + 55.
  CHECK(rank.carry_out(reads, 0) == alone + 12 + 40);
  CHECK(rank.refreshing() == 52);
  CHECK(rank.refreshes() == 1);
  CHECK(rank.begin(300, 350) == 380);
}

TEST_CASE("banks are closed once for all refreshes that are due, and a frame goes on however often they are") {
  Figures figures = ddr4();
  figures.rank.refresh_interval = 10;
  figures.rank.refresh = 4;
  RankTiming rank(figures, {4 * 64, 64, 16});
  const RowCommands reads(2, read);
  // The second read would begin at 55; all are closed at 67, when 6 are due; while they take 24 clocks, 3 more are,
  // and then one: the tenth, due at 100, ends at 107.
  CHECK(rank.carry_out(reads, 0) == rank.clocks(reads) + 12 + 10 * 4);
  CHECK(rank.refreshes() == 10);
}

namespace {

/// Bounds that know nothing of the order in which the controller goes through slots and commands.
struct Bounds {
  std::uint64_t least = 0;
  std::uint64_t most = 0;
};

Bounds bounds_of(const RowCommands& commands, std::uint64_t slots, const Figures& figures) {
  std::uint64_t activations = 0;
  std::uint64_t of_a_bank = 0;
  std::uint64_t bus = 0;
  std::uint64_t serial = 0;
  const std::uint64_t slots_of_bank = (slots + figures.banks - 1) / figures.banks;
  for (const RowCommand& command : commands) {
    const std::uint64_t cycle = figures.command.restore + figures.command.precharge;
    std::uint64_t took = cycle;
    if (command.op == RowOp::logic) took = figures.command.logic;
    if (command.op == RowOp::copy) took += figures.command.second;
    const std::uint64_t transfer = figures.row_bits / figures.bus_bits;
    if (command.op == RowOp::send) {
      bus += slots * transfer;
      took = std::max<std::uint64_t>(figures.command.restore,
                                     figures.command.column + transfer + figures.command.recovery) +
             figures.command.precharge;
    }
    const std::uint64_t times = command.op == RowOp::logic ? 1 : slots_of_bank;
    activations += command.op == RowOp::logic ? 0 : (command.op == RowOp::copy ? 2 : 1) * slots;
    of_a_bank += times * took;
    serial += (command.op == RowOp::logic ? 1 : slots) *
              (took + transfer + 2ULL * (figures.rank.activation_gap + figures.rank.window));
  }
  const std::uint64_t apart = activations == 0 ? 0 : (activations - 1) * figures.rank.activation_gap;
  const std::uint64_t windows = activations == 0 ? 0 : (activations - 1) / 4 * figures.rank.window;
  return {std::max({of_a_bank, bus, apart, windows}), serial + figures.rank.activation_gap + figures.rank.window};
}

}  // namespace

TEST_CASE(
    "row commands take no less than the busiest bank, the bus or the supply, and no more than one after the other") {
  std::mt19937_64 random(8);
  const auto upto = [&](std::uint32_t most) { return static_cast<std::uint32_t>(random() % most) + 1; };
  for (int round = 0; round < 2000; ++round) {
    Figures figures = ddr4();
    figures.banks = upto(20);
    figures.bus_bits = upto(64);
    while (figures.row_bits % figures.bus_bits != 0) --figures.bus_bits;
    figures.plane_bits = figures.bus_bits;
    figures.command = {.restore = upto(60),
                       .precharge = upto(30),
                       .second = upto(20),
                       .logic = upto(9),
                       .column = upto(40),
                       .recovery = upto(30)};
    figures.rank = {.activation_gap = upto(12), .window = upto(90) - 1};
    const std::uint64_t slots = upto(40);
    RowCommands commands;
    const RowCommand* const all[] = {&copy, &activate, &read, &write, &logic, &send};
    for (std::uint32_t i = upto(30); i > 0; --i) commands.push_back(*all[random() % 6]);
    const Bounds bounds = bounds_of(commands, slots, figures);
    const std::uint64_t taken = clocks(figures, slots, commands);
    CAPTURE(round);
    CHECK(taken >= bounds.least);
    CHECK(taken <= bounds.most);
  }
}
