#pragma once

#include <fmt/format.h>
#include <rapidcheck.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "tests/lockstep/row.h"
#include "tests/support/drawing.h"
#include "tests/support/usual_cases.h"

/// The commands of a program that runs a SystemC machine and a Verilog machine in lockstep. Their Lockstep has
/// run(Programs, fault), which returns the first difference or an empty text, and clocks_compared().
namespace csgsim::rtl {

using Words = std::vector<std::string>;

/// Generates consecutive Programs with at most a number of instructions per segment.
using AnyFrames = std::function<rc::Gen<std::vector<isa::Program>>(const machines::Machine&, std::size_t instructions)>;

/// A random number from `least` to `most`, independent of rapidcheck's current size.
std::uint32_t random_between(std::uint32_t least, std::uint32_t most);

/// Sets parameters of the host: words from the third on are KEY=NUMBER.
void set_figures(const Words& words, const std::map<std::string, std::uint32_t*>& known);

/// Adds the opcodes that occur in the Programs.
void collect_opcodes(std::span<const isa::Program> programs, std::set<isa::Opcode>& sent);

/// Number of opcodes that a random Program for the machine may contain.
std::size_t possible_opcode_count(const machines::Machine& machine);

/// random SEQUENCES INSTRUCTIONS ...: draws SEQUENCES random sequences. Throws if a possible opcode never occurred.
template <class Lockstep>
int random_frames(const machines::Machine& machine, const AnyFrames& any_frames, const Words& words) {
  const auto sequences = static_cast<unsigned>(std::stoul(words.at(1)));
  const std::size_t instructions = std::stoul(words.at(2));
  Lockstep lockstep(machine);
  std::set<isa::Opcode> sent;
  const int code = test::property_exit_code(sequences, [&] {
    return rc::check("Verilog and SystemC have equal registers and memory in every clock", [&] {
      const std::vector<isa::Program> frames = *any_frames(machine, instructions);
      const std::string difference = lockstep.run(frames, 0);
      if (!difference.empty()) RC_FAIL(difference);
      collect_opcodes(frames, sent);
    });
  });
  constexpr unsigned many = 20;  ///< fewer sequences need not contain every opcode
  if (testing::draws_from_fixed_seed() && sequences >= many && code == 0 &&
      sent.size() != possible_opcode_count(machine))
    throw std::runtime_error(
        fmt::format("only {} of {} opcodes occurred; raise INSTRUCTIONS", sent.size(), possible_opcode_count(machine)));
  fmt::print("{} clocks compared\n", lockstep.clocks_compared());
  return code;
}

/// models MODEL...: draws test models.
template <class Lockstep>
int models(const machines::Machine& machine, const testing::Setup& setup, const Words& words) {
  Lockstep lockstep(machine);
  for (std::size_t i = 1; i < words.size(); ++i) {
    const testing::Compiled compiled =
        testing::compile_default_view(testing::model_path(words[i]), setup, view::Projection::perspective);
    const std::string difference = lockstep.run({&compiled.program, 1}, 0);
    if (!difference.empty()) throw std::runtime_error(words[i] + ": " + difference);
    fmt::print("{}: equal, {} clocks compared until now\n", words[i], lockstep.clocks_compared());
  }
  return 0;
}

/// The number of random sequences until one detects the fault; 0 if none does.
template <class Lockstep>
unsigned sequences_to_detect(Lockstep& lockstep, std::uint8_t fault, unsigned sequences,
                             const rc::Gen<std::vector<isa::Program>>& any_frames) {
  constexpr int size = 50;
  for (unsigned i = 1; i <= sequences; ++i) {
    const std::vector<isa::Program> frames = any_frames(rc::Random(i), size).value();
    if (!lockstep.run(frames, fault).empty()) return i;
  }
  return 0;
}

/// faults SEQUENCES INSTRUCTIONS NUMBER...: checks that all planted faults except those numbers are detected.
template <class Lockstep>
int faults(const machines::Machine& machine, const AnyFrames& any_frames, std::uint8_t planted, const Words& words) {
  const auto sequences = static_cast<unsigned>(std::stoul(words.at(1)));
  const rc::Gen<std::vector<isa::Program>> frames = any_frames(machine, std::stoul(words.at(2)));
  std::set<unsigned long> left_out;
  for (std::size_t i = 3; i < words.size(); ++i) left_out.insert(std::stoul(words[i]));
  Lockstep lockstep(machine);
  if (sequences_to_detect(lockstep, 0, sequences, frames) != 0)
    throw std::runtime_error("Verilog and SystemC differ without a planted fault");
  int code = 0;
  for (std::uint8_t fault = 1; fault <= planted; ++fault) {
    const unsigned sequence = sequences_to_detect(lockstep, fault, sequences, frames);
    fmt::print("fault {}: {}\n", fault,
               sequence == 0 ? "not detected" : fmt::format("detected by sequence {}", sequence));
    if ((sequence == 0) != left_out.contains(fault)) code = 1;
  }
  return code;
}

/// Exit code of main: the result of `run`, or 2 if it throws.
int exit_code(int count, char** words, const std::function<int(const Words&)>& run);

}  // namespace csgsim::rtl
