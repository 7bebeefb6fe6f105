// Command lines of the debugger.

#include <string>

#include "hw/isa/facts.h"
#include "hw/isa/text.h"
#include "sim/debug/command.h"
#include "sim/debug/condition.h"
#include "tests/fuzz/property.h"

namespace debug = csgsim::debug;
namespace fuzz = csgsim::fuzz;
namespace isa = csgsim::isa;

namespace {

const isa::Program& program() {
  static const isa::Program one = isa::parse(
      ".array width=30 height=20 memory_bits=40\n.frame colour_base=20 colour_bits=8\n.field Z2 [0+:20] depth\n.field "
      "\"a \\\"b\" [20+:8] colour\n"
      ".field mask [30] mask\n.primitive \"cube@3:4\"\n.primitive \"odd one\"\n"
      ".segment x=0 y=0 width=30 height=20\n  enable_all\n",
      "fuzz");
  return one;
}

bool is_sound(const debug::Target& target) {
  if (const auto* at = std::get_if<debug::AtPrimitive>(&target))
    return at->primitive < program().facts->primitives.size();
  if (const auto* condition = std::get_if<debug::Condition>(&target))
    return condition->watched.x < 30 && condition->watched.y < 20 && condition->watched.field.end() <= 40;
  return true;
}

/// Checks that the printed form of a target is parsed as the same target.
void check_target(const debug::Target& target) {
  fuzz::require(is_sound(target), "a target exists in the Program");
  if (std::holds_alternative<debug::AtPrimitive>(target)) return;  // its index and its name
  const std::string text = "until " + debug::to_text(target, program());
  const debug::Command again = debug::parse_command(text, "again", 1, program());
  fuzz::require(std::get<debug::Until>(again).target == target, "a target is parsed as printed");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const debug::Command command = debug::parse_command(fuzz::text_of(data, size), "fuzz", 7, program());
    if (const auto* until = std::get_if<debug::Until>(&command)) check_target(until->target);
    if (const auto* set = std::get_if<debug::SetBreak>(&command)) check_target(set->target);
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz");
  }
  return 0;
}
