#include "tests/rtl/commands.h"

#include <algorithm>
#include <cstdio>
#include <exception>

#include "hw/isa/opcodes.h"
#include "hw/machines/regions.h"
#include "tests/support/properties.h"

namespace csgsim::rtl {

std::uint32_t random_between(std::uint32_t least, std::uint32_t most) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, most + 1));
}

void set_figures(const Words& words, const std::map<std::string, std::uint32_t*>& known) {
  for (std::size_t i = 3; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    *known.at(words[i].substr(0, equals)) = static_cast<std::uint32_t>(std::stoul(words[i].substr(equals + 1)));
  }
}

void collect_opcodes(std::span<const isa::Program> programs, std::set<isa::Opcode>& sent) {
  for (const isa::Program& program : programs)
    for (const isa::Segment& segment : program.segments)
      for (const isa::Instruction& instruction : segment.instructions) sent.insert(instruction.opcode);
}

std::size_t possible_opcode_count(const machines::Machine& machine) {
  const auto fits = [&](const isa::OpcodeInfo& row) {
    if (isa::needs_global_or(row.opcode)) return machines::has_global_or(machine);
    return machine.evaluator_degree > 1 || row.opcode != isa::Opcode::squares;
  };
  return static_cast<std::size_t>(std::count_if(isa::opcode_table.begin(), isa::opcode_table.end(), fits));
}

int exit_code(int count, char** words, const std::function<int(const Words&)>& run) {
  try {
    testing::begin_program(count, words);
    return run({words + 1, words + count});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}

}  // namespace csgsim::rtl
