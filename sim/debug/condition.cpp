#include "sim/debug/condition.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/isa/quoting.h"
#include "hw/isa/text.h"

namespace csgsim::debug {

namespace {

std::string_view sign_of(Relation relation) {
  constexpr auto signs = std::to_array<std::string_view>({"<", "<=", "==", "!=", ">=", ">", ""});
  return signs.at(static_cast<std::size_t>(relation));
}

/// An instruction writes E if its meaning contains `E := ...`.
constexpr auto enable_changers = [] {
  std::array<bool, isa::opcode_numbers> changers{};
  for (const isa::OpcodeInfo& row : isa::opcode_table)
    changers.at(static_cast<std::size_t>(row.opcode)) = row.meaning.find("E := ") != std::string_view::npos;
  return changers;
}();

}  // namespace

bool changes_enable(isa::Opcode opcode) { return enable_changers.at(static_cast<std::size_t>(opcode)); }

bool can_change(const isa::Instruction& instruction, isa::Field watched) {
  return watched.width == 0 ? changes_enable(instruction.opcode) : isa::may_write(instruction, watched);
}

std::uint32_t read_value(const WatchedField& watched, const engine::Run& run) {
  const isa::Region region = run.region();
  const std::uint32_t x = watched.x - region.x;
  const std::uint32_t y = watched.y - region.y;
  if (watched.field.width == 0) return run.is_enabled(x, y) ? 1 : 0;
  return run.value(watched.field, x, y);
}

bool holds(const Condition& condition, std::uint32_t value, std::uint32_t previous_value) {
  switch (condition.relation) {
    case Relation::less: return value < condition.value;
    case Relation::not_greater: return value <= condition.value;
    case Relation::equal: return value == condition.value;
    case Relation::not_equal: return value != condition.value;
    case Relation::not_less: return value >= condition.value;
    case Relation::greater: return value > condition.value;
    case Relation::changes: return value != previous_value;
  }
  return false;
}

std::string to_text(isa::Field field, const isa::Program& program) {
  if (field.width == 0) return "E";
  for (const isa::NamedField& named : program.facts->fields)
    if (named.field == field) return isa::word_or_quoted(named.name);
  return isa::text_of(field);
}

std::string to_text(const WatchedField& watched, const isa::Program& program) {
  return fmt::format("{}[{},{}]", to_text(watched.field, program), watched.x, watched.y);
}

std::string to_text(const Target& target, const isa::Program& program) {
  if (const auto* at = std::get_if<AtInstruction>(&target)) return fmt::format("i{}", at->number);
  if (const auto* at = std::get_if<AtClock>(&target)) return fmt::format("clock {}", at->clock);
  if (const auto* at = std::get_if<AtPrimitive>(&target)) {
    return fmt::format("primitive p{} {}", at->primitive,
                       isa::word_or_quoted(program.facts->primitives[at->primitive]));
  }
  const auto& condition = std::get<Condition>(target);
  const std::string watched = to_text(condition.watched, program);
  if (condition.relation == Relation::changes) return "change " + watched;
  return fmt::format("{} {} {}", watched, sign_of(condition.relation), condition.value);
}

}  // namespace csgsim::debug
