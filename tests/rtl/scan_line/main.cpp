// rtl_chain_NAME random SEQUENCES INSTRUCTIONS [KEY=NUMBER...]
//   Runs SEQUENCES sequences of random pictures, with at most INSTRUCTIONS per line, through the chain in SystemC and
//   through the Verilog, in lockstep. link= is the number of bits of a link word. RC_PARAMS overrides seed and number.
// rtl_chain_NAME models MODEL...
//   Draws test models on both, as high as the chain is long.
// rtl_chain_NAME faults SEQUENCES INSTRUCTIONS NUMBER...
//   Every planted fault except those NUMBERs must be detected within SEQUENCES random sequences.

#include <rapidcheck.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "hw/scan_line/kind.h"
#include "tests/rtl/commands.h"
#include "tests/rtl/scan_line/chain_lockstep.h"
#include "tests/support/random_program.h"

namespace csgsim::rtl {

namespace {

constexpr std::uint8_t planted_faults = 36;  ///< number of faults in hw/rtl/scan_line/faults.vh

machines::Machine machine_with(const Words& words) {
  machines::Machine machine = chain_of_parameters();
  set_figures(words, {{"link", &machine.link.width}});
  return machine;
}

/// Pictures of one to three lines, mostly of the same width.
rc::Gen<std::vector<isa::Program>> arbitrary_pictures(const machines::Machine& machine, std::size_t instructions) {
  return rc::gen::exec([=] {
    machines::Machine part = machine;
    const auto any_width = [&] {
      return random_between(0, 2) > 0 ? machine.array.width : random_between(1, machine.array.width);
    };
    part.picture.width = any_width();
    std::vector<isa::Program> frames(random_between(1, 3));
    for (isa::Program& frame : frames) {
      if (random_between(0, 3) == 0) part.picture.width = any_width();
      part.picture.height = random_between(1, 3);
      frame = *test::arbitrary_program_in_parts(part, instructions / frames.size(), machine.evaluator_degree);
    }
    return frames;
  });
}

testing::Setup setup_of(const machines::Machine& machine) {
  testing::Setup setup;
  setup.kind = &scan_line::kind;
  setup.has_global_or = false;
  setup.sampling.width = machine.array.width;
  setup.sampling.height = machine.array.width;
  setup.memory_bits = machine.array.memory_bits;
  return setup;
}

int run(const Words& words) {
  const machines::Machine machine = chain_of_parameters();
  if (words.at(0) == "random") return random_frames<ChainLockstep>(machine_with(words), arbitrary_pictures, words);
  if (words.at(0) == "models") return models<ChainLockstep>(machine, setup_of(machine), words);
  if (words.at(0) == "faults") return faults<ChainLockstep>(machine, arbitrary_pictures, planted_faults, words);
  throw std::invalid_argument("unknown test: " + words.at(0));
}

}  // namespace

}  // namespace csgsim::rtl

int main(int count, char** words) { return csgsim::rtl::exit_code(count, words, csgsim::rtl::run); }
