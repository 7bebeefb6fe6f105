#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/isa/quoting.h"
#include "sim/debug/command.h"
#include "sim/debug/grammar.h"

namespace csgsim::debug {

namespace {

template <class Unsigned>
Unsigned number_in(std::string_view digits, int base = 10) {
  Unsigned value{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (error != std::errc{} || end != digits.data() + digits.size())
    throw InputError(fmt::format("{} is out of range; use a smaller number", digits));
  return value;
}

/// Partial result of parsing a line.
struct Reading {
  explicit Reading(const isa::Program& of) : program(of) {}

  const isa::Program& program;
  Command command;
  Target target;
  WatchedField watched;
  std::string text;  ///< a quoted name or a file name
  Relation relation{};
  std::uint64_t number = 1;
  bool has_number = false;

  void name_field(const std::string& name) {
    if (name == "E") {
      watched.field = {};
      return;
    }
    std::vector<std::string_view> names;
    names.reserve(program.facts->fields.size());
    for (const isa::NamedField& named : program.facts->fields) {
      names.emplace_back(named.name);
      if (named.name != name) continue;
      watched.field = named.field;
      return;
    }
    const std::string_view near = nearest(name, names);
    throw InputError(fmt::format("there is no field '{}'{}", name,
                                 near.empty() ? "; the Program has no named fields, use [base+:width]"
                                              : fmt::format("; the nearest is '{}'", near)));
  }

  void check_place() const {
    const isa::Field field = watched.field;
    const bool fits =
        field.width >= 1 && field.width <= isa::max_field_width && field.end() <= program.shape.memory_bits;
    if (!fits) {
      throw InputError(fmt::format("no such field; a pixel has {} bits of memory, and a field has 1 to {} bits",
                                   program.shape.memory_bits, isa::max_field_width));
    }
  }

  void check_pixel() const {
    if (watched.x >= program.shape.width || watched.y >= program.shape.height) {
      throw InputError(fmt::format("there is no pixel {},{} in a picture of {} x {}", watched.x, watched.y,
                                   program.shape.width, program.shape.height));
    }
  }

  void set_value(std::string_view digits, int base) {
    const auto value = number_in<std::uint32_t>(digits, base);
    target = Condition{watched, relation, value};
  }

  void name_primitive(const std::string& name) {
    const std::vector<std::string>& names = program.facts->primitives;
    const std::string_view digits = name.starts_with('p') ? std::string_view(name).substr(1) : std::string_view(name);
    const bool is_index = !digits.empty() && std::all_of(digits.begin(), digits.end(),
                                                         [](char letter) { return letter >= '0' && letter <= '9'; });
    if (is_index) {
      target = AtPrimitive{number_in<std::uint32_t>(digits)};
      if (std::get<AtPrimitive>(target).primitive < names.size()) return;
      throw InputError(
          fmt::format("there is no primitive {}: the Program has {}, counted from 0", digits, names.size()));
    }
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      const std::vector<std::string_view> candidates(names.begin(), names.end());
      const std::string_view near = nearest(name, candidates);
      throw InputError(fmt::format("there is no primitive '{}'{}", name,
                                   near.empty() ? "" : fmt::format("; the nearest is '{}'", near)));
    }
    target = AtPrimitive{static_cast<std::uint32_t>(found - names.begin())};
    if (std::find(found + 1, names.end(), name) != names.end())
      throw InputError(fmt::format("several primitives are named '{}'; give the index", name));
  }
};

template <typename Rule>
struct Action : tao::pegtl::nothing<Rule> {};

CSGSIM_WHEN(count) { reading.number = number_in<std::uint64_t>(matched); }
CSGSIM_WHEN(instruction_number) {
  reading.number = number_in<std::uint64_t>(matched);
  reading.has_number = true;
}
CSGSIM_WHEN(clock_number) { reading.number = number_in<std::uint64_t>(matched); }
CSGSIM_WHEN(breakpoint_number) { reading.number = number_in<std::uint64_t>(matched); }
CSGSIM_WHEN(column) { reading.watched.x = number_in<std::uint32_t>(matched); }
CSGSIM_WHEN(row) {
  reading.watched.y = number_in<std::uint32_t>(matched);
  reading.check_pixel();
}
CSGSIM_WHEN(quoted_body) { reading.text = isa::unescaped(matched); }

CSGSIM_WHEN(field_base) { reading.watched.field = {number_in<std::uint16_t>(matched), 1}; }
CSGSIM_WHEN(field_width) { reading.watched.field.width = number_in<std::uint16_t>(matched); }
CSGSIM_WHEN(field_place) { reading.check_place(); }
CSGSIM_WHEN(field_word) { reading.name_field(std::string(matched)); }
CSGSIM_WHEN(field_quoted) { reading.name_field(reading.text); }

CSGSIM_WHEN(watched) { reading.target = Condition{reading.watched, Relation::not_equal, 0}; }
CSGSIM_WHEN(less) { reading.relation = Relation::less; }
CSGSIM_WHEN(not_greater) { reading.relation = Relation::not_greater; }
CSGSIM_WHEN(equal) { reading.relation = Relation::equal; }
CSGSIM_WHEN(not_equal) { reading.relation = Relation::not_equal; }
CSGSIM_WHEN(not_less) { reading.relation = Relation::not_less; }
CSGSIM_WHEN(greater) { reading.relation = Relation::greater; }
CSGSIM_WHEN(hexadecimal) { reading.set_value(matched, 16); }
CSGSIM_WHEN(decimal) { reading.set_value(matched, 10); }
CSGSIM_WHEN(changes) { reading.target = Condition{reading.watched, Relation::changes, 0}; }
CSGSIM_WHEN(is_not) { reading.target = Condition{reading.watched, Relation::equal, 0}; }
CSGSIM_WHEN(at_instruction) { reading.target = AtInstruction{reading.number}; }
CSGSIM_WHEN(at_clock) { reading.target = AtClock{reading.number}; }
CSGSIM_WHEN(primitive_word) { reading.name_primitive(std::string(matched)); }
CSGSIM_WHEN(primitive_quoted) { reading.name_primitive(reading.text); }
CSGSIM_WHEN(file_word) { reading.text = matched; }

CSGSIM_WHEN(run) { reading.command = RunOn{}; }
CSGSIM_WHEN(step) { reading.command = StepOn{reading.number}; }
CSGSIM_WHEN(until_target) { reading.command = Until{reading.target}; }
CSGSIM_WHEN(back) { reading.command = Back{reading.number}; }
CSGSIM_WHEN(breakpoints) { reading.command = ListBreaks{}; }
CSGSIM_WHEN(set_break) { reading.command = SetBreak{reading.target}; }
CSGSIM_WHEN(delete_break) { reading.command = DeleteBreak{reading.number}; }
CSGSIM_WHEN(lone_enable) { reading.command = PrintEnable{}; }
CSGSIM_WHEN(lone_pixel) { reading.command = PrintPixel{reading.watched.x, reading.watched.y}; }
CSGSIM_WHEN(print) {
  if (std::holds_alternative<Nothing>(reading.command)) reading.command = PrintValue{reading.watched};
}
CSGSIM_WHEN(where) { reading.command = Where{}; }
CSGSIM_WHEN(list_around) {
  reading.command = ListAround{reading.has_number ? std::optional(reading.number) : std::nullopt};
}
CSGSIM_WHEN(picture) { reading.command = TakePicture{reading.watched.field, reading.text}; }
CSGSIM_WHEN(checkpoint) { reading.command = WriteCheckpoint{reading.text}; }
CSGSIM_WHEN(resume) { reading.command = ReadCheckpoint{reading.text}; }
CSGSIM_WHEN(help) { reading.command = Help{}; }
CSGSIM_WHEN(quit) { reading.command = Quit{}; }

#undef CSGSIM_WHEN

/// A command of other debuggers, and what to write instead.
struct OtherCommand {
  std::string_view word;
  std::string_view instead;
};

constexpr OtherCommand other_commands[] = {
    {"watch", "break change FIELD[x,y]"},
    {"tbreak", "until"},
    {"advance", "until"},
    {"finish", "until"},
    {"info", "breakpoints"},
    {"i", "breakpoints"},
    {"display", "print"},
    {"x", "print"},
    {"inspect", "print"},
    {"reverse-continue", "back N"},
    {"rc", "back N"},
    {"reverse-next", "back"},
    {"save", "checkpoint FILE"},
    {"load", "resume FILE"},
    {"restart", "back N"},
    {"start", "run"},
    {"frame", "where"},
    {"screenshot", "picture FIELD FILE.png"},
};

/// The known command nearest to an unknown one; empty if none is similar.
std::string_view nearest_command(std::string_view word) {
  for (const OtherCommand& other : other_commands)
    if (other.word == word) return other.instead;
  std::vector<std::string_view> known;
  for (const CommandInfo& one : command_table) known.push_back(one.word);
  return nearest_similar(word, known);
}

/// The message of a parse error, with the word at its position.
std::string message_about(std::string_view message, std::string_view rest) {
  const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
  if (message.starts_with("unknown command")) {
    const std::string_view near = nearest_command(word);
    const std::string question = near.empty() ? ";" : fmt::format("; did you mean {}?", near);
    return fmt::format("unknown command '{}'{} help lists the commands", word, question);
  }
  if (message.starts_with("unexpected text"))
    return fmt::format("unexpected text '{}'; end the line before it, or start a comment with #", word);
  if (!message.starts_with("expected")) return std::string(message);
  return word.empty() ? fmt::format("the line ends; {}", message) : fmt::format("found '{}'; {}", word, message);
}

}  // namespace

Command parse_command(std::string_view text, std::string_view name, std::size_t line, const isa::Program& program) {
  tao::pegtl::memory_input<> in(text.data(), text.data() + text.size(), std::string(name), 0, line, 1);
  Reading reading(program);
  try {
    tao::pegtl::parse<grammar::line, Action, grammar::Control>(in, reading);
  } catch (const tao::pegtl::parse_error& error) {
    const tao::pegtl::position& place = error.positions().front();
    throw InputError(fmt::format("{}:{}:{}: {}", name, place.line, place.column,
                                 message_about(error.message(), text.substr(std::min(place.byte, text.size())))));
  }
  return reading.command;
}

}  // namespace csgsim::debug
