#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "hw/isa/describe.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/operands.h"
#include "hw/isa/pieces.h"
#include "hw/isa/quoting.h"
#include "hw/isa/text.h"

namespace csgsim::isa {

namespace {

constexpr std::size_t origin_column = 56;
constexpr std::size_t number_column = 84;
constexpr std::size_t model_line = 48;  ///< bytes of a display model per line

using Buffer = fmt::memory_buffer;

template <class... Args>
void put(Buffer& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Args>(args)...);
}

template <class Number>
std::string show(const Number& number) {
  return fmt::format("{}", number);
}

std::string show(const std::string& text) { return quote_text(text); }

std::string show(const std::vector<std::string>& list) {
  std::string out;
  for (const std::string& element : list) out += (out.empty() ? "" : ", ") + quote_text(element);
  return '[' + out + ']';
}

template <class Record>
void put_record(Buffer& out, std::string_view name, const Record& record, std::string_view comment = "") {
  put(out, ".{}", name);
  describe(record, [&](std::string_view key, const auto& value) { put(out, " {}={}", key, show(value)); });
  put(out, "{}\n", comment);
}

/// Names of fields; if a field has several names, the first one.
class FieldNames {
 public:
  explicit FieldNames(std::span<const NamedField> fields) {
    for (const NamedField& named : fields) names_.emplace(key_of(named.field), named.name);
  }

  void put(Buffer& out, Field field) const {
    const auto named = names_.find(key_of(field));
    if (named == names_.end()) {
      out.append(text_of(field));
    } else {
      out.append(word_or_quoted(named->second));
    }
  }

 private:
  using Key = std::pair<std::uint16_t, std::uint16_t>;
  static Key key_of(Field field) { return {field.base, field.width}; }

  std::map<Key, std::string_view> names_;
};

/// Prints A, B and C, each with its variables.
void put_sum(Buffer& out, const Linear& linear, const std::array<std::string_view, 3>& variables,
             std::string_view if_zero) {
  bool first = true;
  const auto put_term = [&](std::int64_t coefficient, std::string_view variable) {
    if (coefficient == 0) return;
    const bool negative = coefficient < 0;
    const auto bits = static_cast<std::uint64_t>(coefficient);
    const std::uint64_t magnitude = negative ? 0U - bits : bits;
    put(out, "{}", first ? (negative ? "-" : "") : (negative ? " - " : " + "));
    if (variable.empty()) {
      put(out, "{}", magnitude);
    } else if (magnitude == 1) {
      put(out, "{}", variable);
    } else {
      put(out, "{}*{}", magnitude, variable);
    }
    first = false;
  };
  put_term(linear.a, variables[0]);
  put_term(linear.b, variables[1]);
  put_term(linear.c, variables[2]);
  put(out, "{} (w{}", first ? if_zero : "", linear.width);
  if (linear.shift > 0) put(out, " >> {}", linear.shift);
  put(out, ")");
}

void put_linear(Buffer& out, const Linear& linear) { put_sum(out, linear, {"x", "y", ""}, "0"); }
void put_squares(Buffer& out, const Linear& squares) { put_sum(out, squares, {"x*x", "x*y", "y*y"}, "0*x*x"); }

void put_operand(Buffer& out, const Instruction& instruction, std::size_t operand, const FieldNames& names) {
  const OperandKind kind = operands_of(instruction.opcode)[operand];
  if (kind != OperandKind::none) put(out, "{}", operand == 0 ? " " : ", ");
  switch (kind) {
    case OperandKind::none: break;
    case OperandKind::target:
    case OperandKind::source: names.put(out, instruction.fields[operand]); break;
    case OperandKind::linear: put_linear(out, instruction.linear); break;
    case OperandKind::squares: put_squares(out, instruction.linear); break;
    case OperandKind::constant:
    case OperandKind::count: put(out, "{}", instruction.constant); break;
  }
}

void put_origin(Buffer& out, const Origin& origin, const Facts& facts) {
  put(out, "{}", info(origin.purpose).name);
  if (origin.primitive != no_primitive) put(out, " {}", piece_label(facts, origin.primitive));
  if (origin.node != no_node) put(out, " against {}", piece_label(facts, origin.node));
  if (origin.effect != no_effect) put(out, " for e{}", origin.effect);
}

void put_operation(Buffer& out, const Instruction& instruction, const FieldNames& names) {
  put(out, "{}", name_of(instruction.opcode));
  for (std::size_t i = 0; i < max_operands; ++i) put_operand(out, instruction, i, names);
}

/// Pads the line that begins at `begin` with blanks up to `column`, but with at least two.
void put_blanks(Buffer& out, std::size_t begin, std::size_t column) {
  const std::size_t length = out.size() - begin;
  put(out, "{:{}}", "", length + 2 < column ? column - length : 2);
}

void put_instruction(Buffer& out, const Instruction& instruction, std::uint64_t number, const FieldNames& names,
                     const Facts& facts) {
  const std::size_t begin = out.size();
  put(out, "  ");
  put_operation(out, instruction, names);
  put_blanks(out, begin, origin_column);
  put(out, "; ");
  put_origin(out, instruction.origin, facts);
  put_blanks(out, begin, number_column);
  put(out, "# i{}\n", number);
}

void put_display_model(Buffer& out, std::span<const std::uint8_t> bytes) {
  for (; !bytes.empty(); bytes = bytes.subspan(std::min(bytes.size(), model_line)))
    put(out, ".display_model \"{}\"\n", hexadecimal(bytes.first(std::min(bytes.size(), model_line))));
}

void put_preparation(Buffer& out, const Preparation& preparation, std::string_view name = "prepare") {
  if (preparation != Preparation{}) put_record(out, name, preparation);
}

void put_header(Buffer& out, const Program& program) {
  put(out, "# csgsim program\n");
  describe_header(program, [&](std::string_view name, const auto& record) {
    if (name != "machine" || program.machine != MachineRecord{}) put_record(out, name, record);
  });
  for (const NamedField& named : program.facts->fields) {
    put(out, ".field {} {} {}\n", word_or_quoted(named.name), text_of(named.field), name_of(named.role));
  }
  for (std::uint32_t i = 0; i < program.facts->primitives.size(); ++i) {
    put(out, ".primitive {}", quote_text(program.facts->primitives[i]));
    if (const std::uint32_t pieces = pieces_of(*program.facts, i).count; pieces > 1) put(out, " pieces={}", pieces);
    put(out, "  # p{}\n", i);
  }
  for (const RowExtent& extent : program.extents) put_record(out, "extent", extent);
  put_display_model(out, program.display_model);
  for (const PruningFacts& pruning : program.facts->prunings) put_record(out, "pruning", pruning);
  put_preparation(out, *program.model_preparation, "prepare_model");
  put_preparation(out, *program.preparation);
}

void flush(Buffer& buffer, std::ostream& out) {
  out.write(buffer.data(), static_cast<std::streamsize>(buffer.size()));
  buffer.clear();
}

}  // namespace

void print(std::ostream& out, const Program& program) {
  const FieldNames names(program.facts->fields);
  Buffer buffer;
  put_header(buffer, program);
  std::uint64_t number = 0;
  for (std::size_t s = 0; s < program.segments.size(); ++s) {
    const Segment& segment = program.segments[s];
    const std::string comment = fmt::format("  # s{}", s);
    put(buffer, "\n");
    if (program.display_model.empty()) {
      put_record(buffer, "segment", segment, comment);
    } else {
      put_record(buffer, "segment", DividedSegment<const Segment>{segment}, comment);
    }
    for (const DivisionStep& step : segment.division->steps) put_record(buffer, "step", step);
    put_preparation(buffer, *segment.preparation);
    for (const Instruction& instruction : segment.instructions)
      put_instruction(buffer, instruction, number++, names, *program.facts);
    flush(buffer, out);
  }
  flush(buffer, out);
}

std::string text_of(const Instruction& instruction, std::span<const NamedField> fields) {
  Buffer buffer;
  put_operation(buffer, instruction, FieldNames(fields));
  return fmt::to_string(buffer);
}

std::string text_of(const Linear& linear) {
  Buffer buffer;
  put_linear(buffer, linear);
  return fmt::to_string(buffer);
}

std::string text_of(Field field) {
  return field.width == 1 ? fmt::format("[{}]", field.base) : fmt::format("[{}+:{}]", field.base, field.width);
}

std::string text_of(const Origin& origin, const Facts& facts) {
  Buffer buffer;
  put_origin(buffer, origin, facts);
  return fmt::to_string(buffer);
}

}  // namespace csgsim::isa
