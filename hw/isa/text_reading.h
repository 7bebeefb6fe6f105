// Semantic actions of the text form's grammar.
// Used by text_grammar.h and text_reading.cpp.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <variant>
#include <vector>

#include "hw/isa/field_role.h"
#include "hw/isa/operands.h"
#include "hw/isa/program.h"

namespace csgsim::isa {

/// Kinds of directives of the text form.
enum class Directive : std::uint8_t {
  record,
  field,
  primitive,
  extent,
  display_model,
  segment,
  step,
  preparation,
  model_preparation,
  pruning,
};

/// A value that is neither string nor list: a number, true or false.
struct BareValue {
  std::string text;
};

using Value = std::variant<BareValue, std::string, std::vector<std::string>>;

/// Builds a Program from its text form: the semantic actions of the grammar. Members throw InputError without a
/// position.
class Reading {
 public:
  // The values most recently read by the rules of the grammar.
  std::string text;  ///< a word, or a string without its quotes and escapes
  std::string key;
  Value value;
  Field field;
  Instruction instruction;
  Directive directive = Directive::record;

  void begin_directive(const std::string& name);
  void set_value();  ///< assigns `value` to the member named `key`
  void name_field() { named_.name = text; }
  void set_role(std::string_view name);
  void end_directive();

  void begin_instruction(std::string_view mnemonic);
  void refer_to_field(std::string_view name);
  void set_purpose(std::string_view name);
  void set_effect(std::string_view number);
  void end_instruction();
  /// Records the position of the instruction that has just ended.
  void set_instruction_position(std::size_t line, std::size_t column);

  /// Parts of the current term of a linear expression or of squares; end_term() or end_square_term() adds the term.
  void set_negative() { term_.negative = true; }
  void set_magnitude(std::uint64_t magnitude) { term_.magnitude = magnitude; }
  void set_variable(char variable) { term_.variable = variable; }
  void end_term();
  void set_square(char first, char second) { term_.variable = first == second ? first : 'b'; }
  void end_square_term();

  /// A decimal or hexadecimal number. Throws InputError if it does not fit Unsigned.
  template <class Unsigned>
  static Unsigned number(std::string_view digits, int base = 10) {
    Unsigned value{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
    if (error != std::errc{} || end != digits.data() + digits.size()) refuse_number(digits);
    return value;
  }

  /// The complete Program. Errors that only the whole text reveals are reported with `name` and the position.
  Program finish(std::string_view name);

  /// The number of a piece from its label: 4.2 for the third piece of primitive 4, or 4 if that has one piece.
  [[nodiscard]] std::uint32_t piece(std::string_view label) const;

 private:
  [[noreturn]] static void refuse_number(std::string_view digits);
  static std::uint32_t index(std::string_view digits);
  /// Adds `term_` to the instruction's expression. `variables`: those of A, B and C, as in `xy1`; `sum`: the form of
  /// the whole sum, for messages.
  void add_term(std::string_view variables, std::string_view sum);
  void set_pieces();
  void begin_step();
  void begin_preparation();
  /// The preparation of the current segment, or of the frame before the first segment.
  Preparation& preparation() {
    return program_.segments.empty() ? *program_.preparation : *program_.segments.back().preparation;
  }

  struct Term {
    bool negative = false;
    std::uint64_t magnitude = 1;
    char variable = '1';  ///< x, y, or '1' for the constant term; in squares x, y, or `b` for the product x*y
  };

  /// Position of an instruction whose validity depends on later instructions.
  struct InstructionPosition {
    std::size_t segment = 0;
    std::size_t index = 0;  ///< within the segment
    std::size_t line = 0;
    std::size_t column = 0;
  };

  Program program_;
  std::map<std::string, Field, std::less<>> fields_;  ///< the Program's fields by name
  std::vector<InstructionPosition> look_ahead_;
  std::set<std::string> records_seen_;
  std::set<std::size_t> prepared_;   ///< number of segments at each .prepare
  std::string name_;                 ///< name of the directive
  std::set<std::string> keys_seen_;  ///< keys of the directive
  NamedField named_;
  Term term_;
  std::vector<std::uint32_t> piece_counts_;  ///< pieces of each primitive read
  std::string terms_seen_;                   ///< variables of the expression's terms
};

}  // namespace csgsim::isa
