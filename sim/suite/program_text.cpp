#include "sim/suite/program_text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <vector>

#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/operands.h"
#include "hw/isa/text.h"

namespace csgsim::suite {

namespace {

/// Directives that describe the model and its compilation, each with the blank that follows its name.
constexpr auto dropped =
    std::to_array<std::string_view>({".machine ", ".model ", ".compile ", ".primitive ", ".pruning "});

/// A copy without names of primitives, origins and facts about segments.
isa::Program without_facts(isa::Program program) {
  program.machine = {};
  isa::Facts facts;
  facts.fields = program.facts->fields;
  facts.depth_scale = program.facts->depth_scale;
  *program.facts = std::move(facts);
  for (isa::Segment& segment : program.segments) {
    *segment.facts = {};
    for (isa::Instruction& instruction : segment.instructions) instruction.origin = {};
  }
  return program;
}

/// Keys of a segment's facts, each with the value 0 that without_facts() leaves.
void remove_facts(std::string& line) {
  for (const std::string_view key : {"primitives", "halfspaces", "kept_primitives", "kept_halfspaces", "comparisons"}) {
    const std::string pair = " " + std::string(key) + "=0";
    if (const std::size_t place = line.find(pair); place != line.npos) line.erase(place, pair.size());
  }
}

}  // namespace

std::string text_of(const isa::Program& program) {
  std::ostringstream printed;
  isa::print(printed, without_facts(program));
  std::istringstream lines(printed.str());
  std::string text = "# csgsim program\n";
  for (std::string line; std::getline(lines, line);) {
    const bool is_instruction = line.starts_with("  ");
    const bool is_segment = line.starts_with(".segment ");
    if (line.starts_with('#')) continue;
    if (std::ranges::any_of(dropped, [&](std::string_view directive) { return line.starts_with(directive); })) continue;
    // Field names contain neither of these characters: the host names them.
    if (is_instruction || is_segment) line.erase(std::min(line.find_first_of(";#"), line.size()));
    if (is_segment) remove_facts(line);
    line.erase(line.find_last_not_of(' ') + 1);
    if (!line.empty()) text += (is_instruction ? line.substr(2) : line) + "\n";
  }
  return text;
}

std::uint32_t used_bits(const isa::Program& program) {
  std::vector<bool> used(program.shape.memory_bits);
  const auto use = [&](isa::Field field) {
    for (unsigned bit = field.base; bit < field.end(); ++bit) used.at(bit) = true;
  };
  use(program.colour);
  for (const isa::Segment& segment : program.segments) {
    for (const isa::Instruction& instruction : segment.instructions) {
      const isa::Operands& operands = isa::operands_of(instruction.opcode);
      for (std::size_t i = 0; i < isa::max_operands; ++i)
        if (isa::is_field(operands[i])) use(instruction.fields[i]);
    }
  }
  return static_cast<std::uint32_t>(std::ranges::count(used, true));
}

}  // namespace csgsim::suite
