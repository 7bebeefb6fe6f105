#include "hw/bit_serial_memory/figures.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program.h"
#include "hw/kinds/load.h"
#include "hw/machines/timing.h"
#include "tests/support/test.h"

using namespace csgsim;

// Bounds on the clocks of whole frames, derived from published command counts (counts_test.cpp) and the timing in the
// machine file (checked against its source in figures_test.cpp), without the compiler of row commands.

namespace {

/// Timing parameters in clocks of the machine.
struct Timing {
  double row = 0;                ///< tRAS + tRP: from one activation to the next in the same bank
  double second_activation = 0;  ///< second activation of a copy
  double gate = 0;
  double faw = 0;
  double refi = 0;
  double rfc = 0;
};

Timing timing_of(const std::string& machine) {
  const auto loaded = kinds::load(machine);
  const auto& figures = machines::kind_figures<bit_serial_memory::Figures>(loaded);
  const auto number = [](std::uint32_t figure) { return static_cast<double>(figure); };
  return {.row = number(figures.command.restore + figures.command.precharge),
          .second_activation = number(figures.command.second),
          .gate = number(figures.command.logic),
          .faw = number(figures.rank.window),
          .refi = number(figures.rank.refresh_interval),
          .rfc = number(figures.rank.refresh)};
}

constexpr std::uint32_t side = 512;
constexpr double slots = side * side / (8.0 * 8192);  // one row of each of eight chips
constexpr std::uint16_t memory_bits = 256;

/// Bounds in clocks of a bank.
struct Bounds {
  double least = 0;
  double most = 0;

  Bounds& operator+=(const Bounds& more) {
    least += more.least;
    most += more.most;
    return *this;
  }
};

/// Bounds for commands with one or two activations; the activations of all slots are issued before the bank closes
/// again.
Bounds of_rows(double fewest, double greatest, const Timing& timing) {
  return {fewest * timing.row, greatest * (timing.row + timing.second_activation)};
}

/// Bounds for reads, writes and gates.
Bounds of_gates(double fewest_rows, double fewest_gates, double most_rows, double most_gates, const Timing& timing) {
  return {fewest_rows * timing.row + fewest_gates * timing.gate, most_rows * timing.row + most_gates * timing.gate};
}

/// Bounds for an instruction on fields of n bits; the upper bound also covers combining the result with E, by AND or by
/// a read.
Bounds majority(isa::Opcode opcode, double n, const Timing& timing) {
  if (opcode == isa::Opcode::field_lt) return of_rows(3 * n + 2, 3 * n + 2 + 4, timing);
  if (opcode == isa::Opcode::field_eq) return of_rows(4 * n + 3, 4 * n + 3 + 4, timing);
  return of_rows(8 * n + 1, 8 * n + 1 + 4 * n + 4, timing);  // a masked sum
}

Bounds gates(isa::Opcode opcode, double n, const Timing& timing) {
  if (opcode == isa::Opcode::add) return of_gates(3 * n, 3 * n + 1, 3 * n + 2, 4 * n + 1 + 4, timing);
  return of_gates(2 * n + 1, 2 * n, 2 * n + 3, 3 * n + 2 + 4, timing);
}

/// Adds the activations of the last slots, the clocks that accept an instruction, and the refreshes.
Bounds of_frame(const Bounds& work, double instructions, const Timing& timing) {
  const double last_slots = 2 * slots / 4 * timing.faw;
  const double longest_refresh = timing.rfc + timing.row + timing.second_activation + last_slots;
  const double most =
      work.most + (instructions + 1) * (last_slots + 2) + 200;  // the first words overlap with the clear
  return {(work.least - timing.rfc) / (1 - timing.rfc / timing.refi),
          (most + longest_refresh) / (1 - longest_refresh / timing.refi)};
}

isa::Instruction instruction(isa::Opcode opcode, std::uint16_t a, std::uint16_t b, std::uint16_t width) {
  return {.opcode = opcode, .fields = {{{a, width}, {b, width}}}};
}

double clocks_of(const std::string& machine, const std::vector<isa::Instruction>& instructions) {
  isa::Program program;
  program.shape = {side, side, memory_bits};
  program.segments.push_back({.region = {0, 0, side, side}, .instructions = instructions});
  return static_cast<double>(machines::time_frame(program, kinds::load(machine)).clocks);
}

}  // namespace

TEST_CASE("a frame's clocks on a memory are within bounds from published counts") {
  const Timing simdram = timing_of("simdram-ddr4");
  const Timing digital = timing_of("digital-bit-serial-ddr4");
  for (std::uint16_t n = 4; n <= 32; n += 7) {
    const std::vector<isa::Instruction> instructions{
        instruction(isa::Opcode::field_lt, 0, 40, n),  instruction(isa::Opcode::add, 80, 0, n),
        instruction(isa::Opcode::field_eq, 80, 40, n), instruction(isa::Opcode::add, 40, 80, n),
        instruction(isa::Opcode::field_lt, 80, 0, n),  instruction(isa::Opcode::field_eq, 0, 80, n)};
    Bounds of_majorities = of_rows(memory_bits, memory_bits + 1, simdram);
    Bounds of_latches = of_gates(memory_bits, 0, memory_bits + 1, memory_bits + 1, digital);
    for (const isa::Instruction& one : instructions) {
      of_majorities += majority(one.opcode, n, simdram);
      of_latches += gates(one.opcode, n, digital);
    }
    const auto check = [&](const std::string& machine, const Bounds& work, const Timing& timing) {
      CAPTURE(machine);
      CAPTURE(n);
      const Bounds bounds = of_frame(work, static_cast<double>(instructions.size()), timing);
      const double taken = clocks_of(machine, instructions);
      CHECK(taken >= bounds.least);
      CHECK(taken <= bounds.most);
      CHECK(bounds.most < 1.5 * bounds.least);
    };
    check("simdram-ddr4", of_majorities, simdram);
    check("digital-bit-serial-ddr4", of_latches, digital);
  }
}
