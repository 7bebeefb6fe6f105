// lockstep_scan_line CELLS WIDTH HEIGHT WORDS WORD_BITS PORTS CLEAR_CLOCKS CHAINS INTERLACED LINK_WIDTH WORD_CLOCKS
// FIFO_DEPTH LATENCY BUCKET_CLOCKS ACTIVE_CLOCKS INSTRUCTION_CLOCKS ALU_BITS SHIFT_BITS TREE_BITS PROGRAMS
// INSTRUCTIONS: compares PROGRAMS random Programs of at most INSTRUCTIONS per line, clocked in SystemC, with the
// reference engine, and the picture with that of the functional engine. PORTS, ALU_BITS and SHIFT_BITS 0 are ideal,
// TREE_BITS 0 is a chain. One machine per process, as SystemC elaborates once. RC_PARAMS overrides the seed and the
// number of Programs.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <span>
#include <string>
#include <vector>

#include "hw/scan_line/figures.h"
#include "hw/scan_line/kind.h"
#include "tests/lockstep/agree.h"
#include "tests/support/properties.h"

namespace csgsim::test {

namespace {

machines::Machine scan_line_machine(std::span<const std::uint32_t> figures) {
  machines::Machine machine = machines::blank_machine(scan_line::kind);
  machine.name = "test";
  machine.array = {figures[0], 1, figures[3] * figures[4]};
  machine.picture = {figures[1], figures[2]};
  machine.clock_hz = 20'000;  // some lines are late, others are not
  machine.own = scan_line::Figures{.words = figures[3],
                                   .word_bits = figures[4],
                                   .alu_bits = figures[16],
                                   .shift_bits = figures[17],
                                   .ports = figures[5],
                                   .network = figures[18] == 0 ? scan_line::Network::chain : scan_line::Network::trees,
                                   .tree_bits = figures[18],
                                   .chains = figures[7],
                                   .bucket_clocks = figures[13],
                                   .active_clocks = figures[14],
                                   .instruction_clocks = figures[15],
                                   .refresh_hz = 60,
                                   .interlaced = figures[8] != 0};
  machine.evaluator_degree = 2;
  machine.clear_clocks = figures[6];
  machine.link = {.width = figures[9], .word_clocks = figures[10], .fifo_depth = figures[11], .latency = figures[12]};
  return machine;
}

int run(std::span<const std::uint32_t> figures) {
  const machines::Machine machine = scan_line_machine(figures);
  testing::add_parameters(fmt::format("max_success={}", figures[19]));
  const bool agree = scan_line_agrees(machine, figures[20]);
  return agree && scan_line_agrees_in_sequences(machine, figures[20]) ? 0 : 1;
}

}  // namespace

}  // namespace csgsim::test

int main(int argc, char** argv) {
  try {
    csgsim::testing::begin_program(argc, argv);
    std::vector<std::uint32_t> figures;
    for (int i = 1; i < argc; ++i) figures.push_back(static_cast<std::uint32_t>(std::stoul(argv[i])));
    if (figures.size() == 21) return csgsim::test::run(figures);
    fmt::print(
        stderr,
        "usage: {} CELLS WIDTH HEIGHT WORDS WORD_BITS PORTS CLEAR_CLOCKS CHAINS INTERLACED LINK_WIDTH "
        "WORD_CLOCKS FIFO_DEPTH LATENCY BUCKET_CLOCKS ACTIVE_CLOCKS INSTRUCTION_CLOCKS ALU_BITS SHIFT_BITS TREE_BITS "
        "PROGRAMS INSTRUCTIONS\n",
        argv[0]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}
