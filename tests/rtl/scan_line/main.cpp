// rtl_chain_NAME random SEQUENCES INSTRUCTIONS [KEY=NUMBER...]
//   So many sequences of random pictures, with so many instructions a line at most, through the chain in SystemC and
//   through the Verilog, in lockstep. link= are the bits of a link's word. RC_PARAMS overrides seed and number.
// rtl_chain_NAME models MODEL...
//   Test models, drawn by both, as high as the chain is long.
// rtl_chain_NAME faults SEQUENCES INSTRUCTIONS NUMBER...
//   Every planted fault but those is noticed within so many random sequences, and those are not.

#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "hw/isa/opcodes.h"
#include "hw/scan_line/kind.h"
#include "tests/lockstep/row.h"
#include "tests/rtl/scan_line/chain_lockstep.h"
#include "tests/support/drawing.h"
#include "tests/support/random_program.h"

namespace csgsim::rtl {

namespace {

constexpr std::uint8_t planted_faults = 36;  ///< in hw/rtl/scan_line/faults.vh

using Words = std::vector<std::string>;

machines::Machine machine_with(const Words& words, std::size_t first) {
  machines::Machine machine = chain_of_parameters();
  const std::map<std::string, std::uint32_t*> known{{"link", &machine.link.width}};
  for (std::size_t i = first; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    *known.at(words[i].substr(0, equals)) = static_cast<std::uint32_t>(std::stoul(words[i].substr(equals + 1)));
  }
  return machine;
}

/// Any number of `least` to `most`, whatever the size that rapidcheck has come to.
std::uint32_t pick(std::uint32_t least, std::uint32_t most) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, most + 1));
}

/// Of one width mostly, and one to three lines each.
rc::Gen<std::vector<isa::Program>> arbitrary_pictures(const machines::Machine& machine, std::size_t instructions) {
  return rc::gen::exec([=] {
    machines::Machine part = machine;
    const auto any_width = [&] { return pick(0, 2) > 0 ? machine.array.width : pick(1, machine.array.width); };
    part.picture.width = any_width();
    std::vector<isa::Program> frames(pick(1, 3));
    for (isa::Program& frame : frames) {
      if (pick(0, 3) == 0) part.picture.width = any_width();
      part.picture.height = pick(1, 3);
      frame = *test::arbitrary_program_in_parts(part, instructions / frames.size(), machine.evaluator_degree);
    }
    return frames;
  });
}

/// Those that there are, without questions, and of degree 1 without squares.
std::size_t possible_instructions(const machines::Machine& machine) {
  const auto fits = [&](const isa::OpcodeInfo& row) {
    return !isa::is_question(row.opcode) && (machine.evaluator_degree > 1 || row.opcode != isa::Opcode::squares);
  };
  return static_cast<std::size_t>(std::count_if(isa::opcode_table.begin(), isa::opcode_table.end(), fits));
}

int random_pictures(const Words& words) {
  const auto sequences = static_cast<unsigned>(std::stoul(words.at(1)));
  const std::size_t instructions = std::stoul(words.at(2));
  const machines::Machine machine = machine_with(words, 3);
  ChainLockstep lockstep(machine);
  std::set<isa::Opcode> sent;
  const int code = test::exit_code_of(sequences, [&] {
    return rc::check("cells in Verilog have the registers and the memory of those in SystemC in every clock", [&] {
      const std::vector<isa::Program> frames = *arbitrary_pictures(machine, instructions);
      const std::string difference = lockstep.run(frames);
      if (!difference.empty()) RC_FAIL(difference);
      for (const isa::Program& frame : frames)
        for (const isa::Segment& line : frame.segments)
          for (const isa::Instruction& instruction : line.instructions) sent.insert(instruction.opcode);
    });
  });
  constexpr unsigned many = 20;  ///< fewer need not have every instruction
  if (sequences >= many && code == 0 && sent.size() != possible_instructions(machine))
    throw std::runtime_error(
        fmt::format("{} instructions were sent of {}", sent.size(), possible_instructions(machine)));
  fmt::print("{} clocks compared\n", lockstep.clocks_compared());
  return code;
}

int models(const Words& words) {
  const machines::Machine machine = chain_of_parameters();
  ChainLockstep lockstep(machine);
  testing::Setup setup;
  setup.kind = &scan_line::kind;
  setup.has_global_or = false;
  setup.sampling.width = machine.array.width;
  setup.sampling.height = machine.array.width;
  setup.memory_bits = machine.array.memory_bits;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const testing::Compiled compiled =
        testing::compile_default_view(testing::model_path(words[i]), setup, view::Projection::perspective);
    const std::string difference = lockstep.run({&compiled.program, 1});
    if (!difference.empty()) throw std::runtime_error(words[i] + ": " + difference);
    fmt::print("{}: equal, {} clocks compared so far\n", words[i], lockstep.clocks_compared());
  }
  return 0;
}

/// The number of sequences until one notices the fault; 0 if none of so many does.
unsigned noticed_by(ChainLockstep& lockstep, std::uint8_t fault, unsigned sequences, std::size_t instructions) {
  const auto any_pictures = arbitrary_pictures(chain_of_parameters(), instructions);
  constexpr int size = 50;
  for (unsigned i = 1; i <= sequences; ++i) {
    const std::vector<isa::Program> frames = any_pictures(rc::Random(i), size).value();
    if (!lockstep.run(frames, fault).empty()) return i;
  }
  return 0;
}

int faults(const Words& words) {
  const auto sequences = static_cast<unsigned>(std::stoul(words.at(1)));
  const std::size_t instructions = std::stoul(words.at(2));
  std::set<unsigned long> left_out;
  for (std::size_t i = 3; i < words.size(); ++i) left_out.insert(std::stoul(words[i]));
  ChainLockstep lockstep(chain_of_parameters());
  if (noticed_by(lockstep, 0, sequences, instructions) != 0) throw std::runtime_error("a difference without any fault");
  int code = 0;
  for (std::uint8_t fault = 1; fault <= planted_faults; ++fault) {
    const unsigned noticed = noticed_by(lockstep, fault, sequences, instructions);
    fmt::print("fault {}: {}\n", fault, noticed == 0 ? "not noticed" : fmt::format("noticed by sequence {}", noticed));
    if ((noticed == 0) != left_out.contains(fault)) code = 1;
  }
  return code;
}

int run(const Words& words) {
  if (words.at(0) == "random") return random_pictures(words);
  if (words.at(0) == "models") return models(words);
  if (words.at(0) == "faults") return faults(words);
  throw std::invalid_argument("no such test: " + words.at(0));
}

}  // namespace

}  // namespace csgsim::rtl

int main(int count, char** words) {
  try {
    return csgsim::rtl::run({words + 1, words + count});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}
