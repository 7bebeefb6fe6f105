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

/// Approximately DDR4-2400. The expected sums below use these values; figures_test.cpp has those of the machines.
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

TEST_CASE("a row copy takes tRAS + tRP + the delay of its second activation") {
  CHECK(clocks(ddr4(), 1, {}) == 0);
  CHECK(clocks(ddr4(), 1, {copy}) == 5 + 39 + 16);
  CHECK(clocks(ddr4(), 1, {activate}) == 39 + 16);
  CHECK(clocks(ddr4(), 1, {copy, copy, activate}) == 60 + 60 + 55);
  CHECK(clocks(ddr4(), 1, {read, logic, logic, write}) == 55 + 4 + 4 + 55);
}

TEST_CASE("banks overlap within the limits of tRRD and tFAW") {
  Figures figures = ddr4();
  // Activations are at 0, 4, 8 and 12, and the fifth is at 26.
  CHECK(clocks(figures, 4, {read}) == 12 + 55);
  CHECK(clocks(figures, 5, {read}) == 26 + 55);
  // Two activations per copy: 0, 5, 9, 14, 26, 31.
  CHECK(clocks(figures, 2, {copy}) == 14 + 55);
  CHECK(clocks(figures, 3, {copy}) == 31 + 55);
  figures.rank.window = 0;
  CHECK(clocks(figures, 3, {copy}) == 23 + 55);
}

TEST_CASE("subarrays of a bank run in sequence but share their gate operations") {
  Figures figures = ddr4();
  figures.banks = 1;
  CHECK(clocks(figures, 3, {read, logic, write}) == 3 * 55 + 4 + 3 * 55);
}

TEST_CASE("rows of all banks are sent to the host over a single bus") {
  // 64 bits take 4 clocks, starting 32 clocks after the activation; then the row closes.
  CHECK(clocks(ddr4(), 1, {send}) == 32 + 4 + 19 + 16);
  CHECK(clocks(ddr4(), 3, {send}) == 32 + 3 * 4 + 19 + 16);
}

TEST_CASE("a due refresh waits until all banks are closed and delays the rest") {
  Figures figures = ddr4();
  figures.rank.refresh_interval = 100;
  figures.rank.refresh = 40;
  RankTiming rank(figures, {4 * 64, 64, 16});
  const RowCommands reads(3, read);
  const std::uint64_t alone = rank.clocks(reads);
  // Reads of the first bank begin at 0 and 55. The third would begin at 110, but the last bank closes at 55 + 12 + 55.
  CHECK(rank.carry_out(reads, 0) == alone + 12 + 40);
  CHECK(rank.refreshing() == 52);
  CHECK(rank.refreshes() == 1);
  CHECK(rank.begin(300, 350) == 380);
}

TEST_CASE("banks close once for all due refreshes and frames make progress regardless") {
  Figures figures = ddr4();
  figures.rank.refresh_interval = 10;
  figures.rank.refresh = 4;
  RankTiming rank(figures, {4 * 64, 64, 16});
  const RowCommands reads(2, read);
  // The second read would begin at 55. All banks are closed at 67, when 6 refreshes are due; during their 24 clocks 3
  // more become due, and then one: the tenth, due at 100, ends at 107.
  CHECK(rank.carry_out(reads, 0) == rank.clocks(reads) + 12 + 10 * 4);
  CHECK(rank.refreshes() == 10);
}

namespace {

/// Bounds that do not depend on the order in which the controller processes slots and commands.
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

TEST_CASE("row commands take at least the busiest resource and at most their sum") {
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
