#include "sim/debug/show.h"

#include <fmt/format.h>

#include <algorithm>

#include "hw/base/text.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/facts.h"
#include "hw/isa/pieces.h"
#include "hw/isa/text.h"

namespace csgsim::debug {

namespace {

constexpr std::uint64_t around = 5;  ///< instructions on either side

/// Names and meanings of an instruction's origin.
std::string served_text(const isa::Origin& origin, const isa::Program& program) {
  std::string text = fmt::format("  {}", isa::info(origin.purpose).name);
  if (origin.primitive != isa::no_primitive) text += " " + isa::piece_name(*program.facts, origin.primitive);
  if (origin.node != isa::no_node) text += " against " + isa::piece_name(*program.facts, origin.node);
  if (origin.effect != isa::no_effect)
    text += fmt::format(" for {}", printable(program.facts->compile.effects[origin.effect]));
  return text + fmt::format(": {}\n", isa::info(origin.purpose).meaning);
}

std::string clocks_text(engine::Place place, Clocks& clocks) {
  const machines::ClockSpan span = clocks.issue_span(place);
  if (span.empty()) return "";
  return fmt::format("  issued in clocks {}..{}\n", span.begin, span.end - 1);
}

/// Place of the next instruction; nothing if the run has ended.
std::optional<engine::Place> next_of(const engine::Run& run, const engine::Numbers& numbers) {
  if (numbers.count() == 0) return std::nullopt;
  const std::uint64_t number = numbers.of(run.place());
  if (number == numbers.count()) return std::nullopt;
  return numbers.place(number);
}

const isa::Instruction& instruction_at(engine::Place place, const isa::Program& program) {
  return program.segments[place.segment].instructions[place.index];
}

}  // namespace

FieldMeaning field_meaning(isa::Field field, const isa::Program& program) {
  using enum isa::FieldRole;
  const auto named = std::ranges::find(program.facts->fields, field, &isa::NamedField::field);
  if (named == program.facts->fields.end()) return {};
  const bool is_colour = named->role == colour || named->role == candidate_colour || named->role == shown;
  return {is_colour && field.width >= isa::minimum_colour_bits && field.width <= isa::max_colour_bits,
          named->role == depth || named->role == candidate_depth || named->role == stored};
}

std::string value_text(isa::Field field, std::uint32_t value, const isa::Program& program) {
  const FieldMeaning meaning = field_meaning(field, program);
  std::string text = fmt::format("{}", value);
  if (field.width > 4) text += fmt::format(" ({:#x})", value);
  if (meaning.is_depth && value == (std::uint64_t{1} << field.width) - 1) text += ", nothing";
  if (!meaning.is_colour) return text;
  const auto [red, green, blue] = isa::unpack_colour(value, field.width);
  return text + fmt::format(", #{:02x}{:02x}{:02x}", red, green, blue);
}

std::string place_text(const engine::Run& run, const isa::Program& program) {
  const engine::Numbers numbers(program);
  const std::optional<engine::Place> next = next_of(run, numbers);
  if (numbers.count() == 0) return "the Program has no instructions\n";
  if (!next) return fmt::format("at the end, after i{}\n", numbers.count() - 1);
  return fmt::format("i{} of {}: {}\n", numbers.of(*next), numbers.count(),
                     isa::text_of(instruction_at(*next, program), program.facts->fields));
}

std::string where_text(const engine::Run& run, const isa::Program& program, Clocks& clocks) {
  std::string text = place_text(run, program);
  const std::optional<engine::Place> next = next_of(run, engine::Numbers(program));
  if (!next) return text;
  const isa::Region& region = program.segments[next->segment].region;
  text += served_text(instruction_at(*next, program).origin, program);
  text += clocks_text(*next, clocks);
  return text + fmt::format("  segment {} of {}: {} x {} pixels at {},{}\n", next->segment, program.segments.size(),
                            region.width, region.height, region.x, region.y);
}

std::string list_text(std::uint64_t number, const isa::Program& program) {
  const engine::Numbers numbers(program);
  const std::uint64_t end = std::min(numbers.count(), number + around + 1);
  std::string text;
  for (std::uint64_t i = number - std::min(number, around); i < end; ++i) {
    const isa::Instruction& one = instruction_at(numbers.place(i), program);
    text += fmt::format("{} {:<8} {:<54}  ; {}\n", i == number ? '>' : ' ', fmt::format("i{}", i),
                        isa::text_of(one, program.facts->fields), isa::text_of(one.origin, *program.facts));
  }
  return text.empty() ? "no instructions\n" : text;
}

std::string help_text() {
  std::string text;
  for (const CommandInfo& one : command_table) text += fmt::format("  {:<26} {}\n", one.form, one.meaning);
  text += "and, as in gdb: continue, c, r; next, n, s, stepi, nexti; b, d, p, l, u, h, q, bt; where STOP is one of\n";
  for (const CommandInfo& one : stop_table) text += fmt::format("  {:<26} {}\n", one.form, one.meaning);
  return text;
}

}  // namespace csgsim::debug
