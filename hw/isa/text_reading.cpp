#include "hw/isa/text_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <ranges>
#include <span>
#include <type_traits>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/isa/describe.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/pieces.h"
#include "hw/isa/quoting.h"
#include "hw/isa/validate.h"

namespace csgsim::isa {

namespace {

constexpr std::string_view field_directive = "field";
constexpr std::string_view primitive_directive = "primitive";
constexpr std::string_view extent_directive = "extent";
constexpr std::string_view model_directive = "display_model";
constexpr std::string_view segment_directive = "segment";
constexpr std::string_view step_directive = "step";
constexpr std::string_view preparation_directive = "prepare";
constexpr std::string_view model_preparation_directive = "prepare_model";
constexpr std::string_view pruning_directive = "pruning";

template <class... Args>
[[noreturn]] void refuse(fmt::format_string<Args...> format, Args&&... args) {
  throw InputError(fmt::format(format, std::forward<Args>(args)...));
}

[[noreturn]] void refuse_word(std::string_view what, std::string_view word, std::span<const std::string_view> known) {
  if (known.empty()) refuse("unknown {} '{}'; none is defined yet", what, word);
  refuse("unknown {} '{}'; the nearest is '{}'", what, word, nearest(word, known));
}

/// Index of the table row with that name.
template <class Table>
std::size_t index_in(const Table& table, std::string_view what, std::string_view word) {
  std::vector<std::string_view> names;
  for (const auto& row : table) {
    if constexpr (std::is_convertible_v<decltype(row), std::string_view>) {
      names.push_back(row);
    } else {
      names.push_back(row.name);
    }
  }
  const auto found = std::ranges::find(names, word);
  if (found == names.end()) refuse_word(what, word, names);
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<std::string_view> directive_names(Program& program) {
  std::vector<std::string_view> names{field_directive,       primitive_directive,         extent_directive,
                                      model_directive,       segment_directive,           step_directive,
                                      preparation_directive, model_preparation_directive, pruning_directive};
  describe_header(program, [&](std::string_view name, auto&) { names.push_back(name); });
  return names;
}

const std::string& bare(const Value& value, std::string_view key, std::string_view expected) {
  const BareValue* found = std::get_if<BareValue>(&value);
  if (found == nullptr) refuse("{} must be {}, without quotes or brackets", key, expected);
  return found->text;
}

template <class Number>
void assign(const Value& value, std::string_view key, Number& member) {
  const std::string& text = bare(value, key, "a number");
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), member);
  if (error == std::errc{} && end == text.data() + text.size()) return;
  if constexpr (std::is_floating_point_v<Number>) {
    refuse("{} must be a number in the range of doubles, not '{}'", key, text);
  } else {
    refuse("{} must be a whole number from 0 to {}, not '{}'", key, std::numeric_limits<Number>::max(), text);
  }
}

void assign(const Value& value, std::string_view key, bool& member) {
  const std::string& text = bare(value, key, "true or false");
  if (text != "true" && text != "false") refuse("{} must be true or false, not '{}'", key, text);
  member = text == "true";
}

void assign(const Value& value, std::string_view key, std::string& member) {
  const auto* found = std::get_if<std::string>(&value);
  if (found == nullptr) refuse("{} must be a string in double quotes", key);
  member = *found;
}

void assign(const Value& value, std::string_view key, std::vector<std::string>& member) {
  const auto* found = std::get_if<std::vector<std::string>>(&value);
  if (found == nullptr) refuse("{} must be a list of strings in brackets", key);
  member = *found;
}

template <class Record>
bool has_key(Record& record, std::string_view key) {
  bool has = false;
  describe(record, [&](std::string_view name, auto&) { has = has || name == key; });
  return has;
}

/// The name of the header record that has the key; empty if none has it.
std::string_view record_with(std::string_view key, Program& program) {
  std::string_view found;
  describe_header(program, [&](std::string_view name, auto& record) {
    if (has_key(record, key)) found = name;
  });
  return found;
}

template <class Record>
void assign_member(Record& record, const std::string& key, const Value& value) {
  std::vector<std::string_view> keys;
  bool known = false;
  describe(record, [&](std::string_view name, auto& member) {
    keys.push_back(name);
    if (name != key) return;
    assign(value, key, member);
    known = true;
  });
  if (!known) refuse_word("key", key, keys);
}

}  // namespace

void Reading::refuse_number(std::string_view digits) {
  refuse("{} is out of range here; use a smaller number", digits);
}

void Reading::begin_directive(const std::string& name) {
  const std::vector<std::string_view> names = directive_names(program_);
  if (std::ranges::find(names, name) == names.end()) refuse_word("directive", name, names);
  name_ = name;
  keys_seen_.clear();
  if (directive == Directive::primitive && name != primitive_directive) set_pieces();
  directive = name == field_directive               ? Directive::field
              : name == primitive_directive         ? Directive::primitive
              : name == extent_directive            ? Directive::extent
              : name == model_directive             ? Directive::display_model
              : name == segment_directive           ? Directive::segment
              : name == step_directive              ? Directive::step
              : name == preparation_directive       ? Directive::preparation
              : name == model_preparation_directive ? Directive::model_preparation
              : name == pruning_directive           ? Directive::pruning
                                                    : Directive::record;
  if (records_seen_.empty() && name != "array") refuse(".{} comes before .array; begin with .array", name);
  if (directive == Directive::extent) program_.extents.emplace_back();
  if (directive == Directive::step) return begin_step();
  if (directive == Directive::preparation) return begin_preparation();
  if (directive == Directive::segment) {
    program_.segments.emplace_back();
  } else if (!program_.segments.empty()) {
    refuse(".{} comes after a .segment; put it before the first", name);
  }
  if (directive == Directive::pruning) program_.facts->prunings.emplace_back();
  const bool is_once = directive == Directive::record || directive == Directive::model_preparation;
  if (is_once && !records_seen_.insert(name).second) refuse(".{} appears twice; keep one of them", name);
}

void Reading::begin_step() {
  if (program_.display_model.empty()) refuse(".step requires a .display_model; put one before the segments");
  if (program_.segments.empty()) refuse(".step is in no segment; put a .segment before it");
  Segment& segment = program_.segments.back();
  if (!segment.instructions.empty()) refuse(".step comes after an instruction; put it after its .segment line");
  segment.division->steps.emplace_back();
}

void Reading::begin_preparation() {
  if (!prepared_.insert(program_.segments.size()).second)
    refuse(".prepare appears twice for {}; keep one of them", program_.segments.empty() ? "the frame" : "this segment");
  if (!program_.segments.empty() && !program_.segments.back().instructions.empty())
    refuse(".prepare comes after an instruction; put it after its .segment line");
}

/// Applies the piece counts of the .primitive directives.
void Reading::set_pieces() {
  std::uint64_t all = 0;
  for (const std::uint32_t count : piece_counts_) all += count;
  if (all > max_pieces) refuse("the primitives have {} pieces; at most {} are possible", all, max_pieces);
  set_piece_counts(piece_counts_, *program_.facts);
}

std::uint32_t Reading::index(std::string_view digits) {
  const auto value = number<std::uint32_t>(digits);
  if (value == no_primitive) refuse_number(digits);
  return value;
}

std::uint32_t Reading::piece(std::string_view label) const {
  const std::size_t point = label.find('.');
  const std::uint32_t primitive = index(label.substr(0, point));
  const Facts& facts = *program_.facts;
  if (point == std::string_view::npos && facts.primitive_of_piece.empty()) return primitive;
  const PieceRange range = pieces_of(facts, primitive);
  const bool is_one = point == std::string_view::npos;
  const std::uint32_t number = is_one ? 0 : index(label.substr(point + 1));
  if (primitive >= facts.primitives.size() || number >= range.count)
    refuse("the Program lists no piece p{}, which this origin names; name a listed one", label);
  if (is_one && range.count > 1)
    refuse("p{0} has {1} pieces; name one of p{0}.0 to p{0}.{2}", primitive, range.count, range.count - 1);
  return range.first + number;
}

void Reading::set_value() {
  if (!keys_seen_.insert(key).second) refuse("{} is given twice; keep one of them", key);
  if (directive == Directive::primitive) {
    if (key != "pieces") refuse("a primitive has no key {}; its only key is pieces", key);
    piece_counts_.resize(program_.facts->primitives.size() + 1, 1);
    std::uint32_t& count = piece_counts_.back();
    assign(value, key, count);
    if (count == 0) refuse("a primitive has at least one piece; set pieces to 1 or more");
    return;
  }
  if (directive == Directive::extent) return assign_member(program_.extents.back(), key, value);
  if (directive == Directive::step) return assign_member(program_.segments.back().division->steps.back(), key, value);
  if (directive == Directive::preparation) return assign_member(preparation(), key, value);
  if (directive == Directive::model_preparation) return assign_member(*program_.model_preparation, key, value);
  if (directive == Directive::pruning) return assign_member(program_.facts->prunings.back(), key, value);
  if (directive == Directive::segment) {
    const DividedSegment<Segment> segment{program_.segments.back()};
    if (program_.display_model.empty()) return assign_member(segment.segment, key, value);
    return assign_member(segment, key, value);
  }
  describe_header(program_, [&](std::string_view name, auto& record) {
    if (name != name_) return;
    const std::string_view other = has_key(record, key) ? "" : record_with(key, program_);
    if (!other.empty()) refuse("{} is a key of .{}, not of .{}; put it there", key, other, name);
    assign_member(record, key, value);
  });
}

void Reading::set_role(std::string_view name) {
  named_.role = static_cast<FieldRole>(index_in(field_role_names, "field role", name));
}

void Reading::end_directive() {
  switch (directive) {
    case Directive::record: return validate_header(program_);
    case Directive::primitive:
      program_.facts->primitives.push_back(text);
      piece_counts_.resize(program_.facts->primitives.size(), 1);
      return;
    case Directive::display_model: {
      const auto bytes = parse_hexadecimal(text);
      if (!bytes) refuse("the display model is not in hexadecimal; write two hexadecimal digits per byte");
      program_.display_model.insert(program_.display_model.end(), bytes->begin(), bytes->end());
      return;
    }
    case Directive::extent: return validate_extent(program_.extents.back(), program_.shape);
    case Directive::step: return;
    case Directive::preparation: return validate_preparation(preparation());
    case Directive::model_preparation: return validate_preparation(*program_.model_preparation);
    case Directive::pruning: return;
    case Directive::segment: return validate_region(program_.segments.back().region, program_.shape);
    case Directive::field:
      named_.field = field;
      validate_field(named_, program_);
      if (!fields_.emplace(named_.name, named_.field).second)
        refuse("field {} is named twice; give each field its own name", quote_text(named_.name));
      program_.facts->fields.push_back(named_);
      return;
  }
}

void Reading::begin_instruction(std::string_view mnemonic) {
  instruction = Instruction{};
  terms_seen_.clear();
  instruction.opcode = opcode_table[index_in(opcode_table, "instruction", mnemonic)].opcode;
  if (program_.segments.empty()) refuse("the instruction is in no segment; put a .segment before it");
}

void Reading::refer_to_field(std::string_view name) {
  const auto found = fields_.find(name);
  field = found != fields_.end() ? found->second
                                 : program_.facts->fields[index_in(program_.facts->fields, "field", name)].field;
}

void Reading::set_purpose(std::string_view name) {
  instruction.origin.purpose = static_cast<Purpose>(index_in(purpose_table, "purpose", name));
}

void Reading::set_effect(std::string_view number) {
  const std::uint32_t named = index(number);
  if (named >= no_effect) refuse("effect e{} is out of range; effects are e0 to e{}", named, no_effect - 1);
  instruction.origin.effect = static_cast<std::uint8_t>(named);
}

void Reading::end_term() { add_term("xy1", "A*x + B*y + C"); }

void Reading::end_square_term() { add_term("xby", "A*x*x + B*x*y + C*y*y"); }

void Reading::add_term(std::string_view variables, std::string_view sum) {
  const Term term = std::exchange(term_, Term{});
  if (terms_seen_.find(term.variable) != std::string::npos)
    refuse("two terms of one kind; add their coefficients: {} has each term once", sum);
  terms_seen_ += term.variable;
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (term.magnitude > most) refuse("coefficient {} is out of range; keep it below 2^62", term.magnitude);
  const auto magnitude = static_cast<std::int64_t>(term.magnitude);
  Linear& linear = instruction.linear;
  (term.variable == variables[0]   ? linear.a
   : term.variable == variables[1] ? linear.b
                                   : linear.c) = term.negative ? -magnitude : magnitude;
}

void Reading::end_instruction() {
  Segment& segment = program_.segments.back();
  validate_in_segment(instruction, segment.region, program_);
  segment.instructions.push_back(instruction);
}

void Reading::set_instruction_position(std::size_t line, std::size_t column) {
  const std::vector<Instruction>& instructions = program_.segments.back().instructions;
  if (needs_lookahead(instructions.back().opcode))
    look_ahead_.push_back({program_.segments.size() - 1, instructions.size() - 1, line, column});
}

Program Reading::finish(std::string_view name) {
  if (records_seen_.empty())
    refuse("{}: there is no .array; begin with .array width=... height=... memory_bits=...", name);
  if (directive == Directive::primitive) set_pieces();
  for (const InstructionPosition& placed : look_ahead_) {
    try {
      validate_with_successors(program_.segments[placed.segment], placed.index);
    } catch (const InputError& error) {
      refuse("{}:{}:{}: {}", name, placed.line, placed.column, error.what());
    }
  }
  try {
    validate_preparations(program_);
  } catch (const InputError& error) {
    refuse("{}: sum of all .prepare: {}", name, error.what());
  }
  for (std::size_t s = 0; s < program_.segments.size(); ++s) {
    try {
      validate_steps(program_.segments[s], program_);
    } catch (const InputError& error) {
      refuse("{}: segment {}: {}", name, s, error.what());
    }
  }
  return std::move(program_);
}

}  // namespace csgsim::isa
