// PEGTL grammar of the text form.
// Used by text_parse.cpp.
#pragma once

#include <type_traits>

#include "hw/isa/grammar_parts.h"
#include "hw/isa/text_reading.h"

/// The grammar of the text form (hw/isa/text.h). Tables determine at parse time which operands an instruction has and
/// what a directive contains.
namespace csgsim::isa::grammar {

struct comment : seq<one<'#'>, until<at<eolf>>> {};
struct blanks : plus<blank> {};
struct line_end : seq<gap, opt<comment>, eolf> {};

struct escape_code : sor<one<'"', '\\'>, seq<one<'x'>, xdigit, xdigit>> {};
struct string_body : star<sor<if_must<one<'\\'>, escape_code>, not_one<'"', '\\', '\n', '\r'>>> {};
struct string_end : one<'"'> {};
struct quoted_string : if_must<one<'"'>, string_body, string_end> {};

// Operands
struct field_name : sor<word, quoted_string> {};
struct field_operand : sor<field_place, field_name> {};

struct minus_sign : one<'-'> {};
struct sign : sor<one<'+'>, minus_sign> {};
struct magnitude : number {};
struct variable : seq<one<'x', 'y'>, not_at<word_part>> {};
struct term : sor<variable, seq<magnitude, opt<if_must<seq<gap, one<'*'>>, gap, variable>>>> {};
struct linear_width : number {};
struct linear_shift : number {};
struct linear_end : seq<gap, one<')'>> {};
struct linear_bits : if_must<seq<one<'('>, gap, one<'w'>>, linear_width,
                             opt<if_must<seq<gap, string<'>', '>'>>, gap, linear_shift>>, linear_end> {};
struct linear_operand : seq<opt<sign, gap>, must<term>, star<gap, sign, gap, must<term>>, gap, must<linear_bits>> {};

struct square : sor<seq<one<'x'>, gap, one<'*'>, gap, one<'x', 'y'>>, seq<one<'y'>, gap, one<'*'>, gap, one<'y'>>> {};
struct square_variable : seq<square, not_at<word_part>> {};
struct square_term : sor<square_variable, seq<magnitude, gap, one<'*'>, gap, square_variable>> {};
struct squares_bits : if_must<seq<one<'('>, gap, one<'w'>>, linear_width, linear_end> {};
struct squares_operand
    : seq<opt<sign, gap>, must<square_term>, star<gap, sign, gap, must<square_term>>, gap, must<squares_bits>> {};

struct constant_operand : seq<constant> {};

struct instruction_count : seq<constant_operand> {};

struct comma : seq<gap, one<','>> {};

/// The operands listed in the instruction's row of the opcode table.
struct operands {
  using rule_t = operands;
  using subs_t =
      type_list<comma, gap, field_operand, linear_operand, squares_operand, constant_operand, instruction_count>;

  template <apply_mode A, rewind_mode M, template <typename...> class Action, template <typename...> class Control,
            typename ParseInput>
  [[nodiscard]] static bool match(ParseInput& in, Reading& reading) {
    const auto demand = [&]<class Rule>(std::type_identity<Rule>) {
      return Control<must<gap, Rule>>::template match<A, M, Action, Control>(in, reading);
    };
    for (std::size_t i = 0; i < max_operands; ++i) {
      const OperandKind kind = operands_of(reading.instruction.opcode)[i];
      if (i > 0 && kind != OperandKind::none) demand(std::type_identity<comma>{});
      switch (kind) {
        case OperandKind::none: break;
        case OperandKind::target:
        case OperandKind::source:
          demand(std::type_identity<field_operand>{});
          reading.instruction.fields[i] = reading.field;
          break;
        case OperandKind::linear: demand(std::type_identity<linear_operand>{}); break;
        case OperandKind::squares: demand(std::type_identity<squares_operand>{}); break;
        case OperandKind::constant: demand(std::type_identity<constant_operand>{}); break;
        case OperandKind::count: demand(std::type_identity<instruction_count>{}); break;
      }
    }
    return true;
  }
};

// Instructions
struct mnemonic : word {};
struct purpose : word {};
struct piece : seq<plus<digit>, opt<one<'.'>, plus<digit>>> {};
struct primitive : piece {};
struct node : piece {};
struct effect : number {};
struct against : seq<blanks, string<'a', 'g', 'a', 'i', 'n', 's', 't'>, blanks, one<'p'>> {};
struct serves : seq<blanks, string<'f', 'o', 'r'>, blanks, one<'e'>> {};
struct origin : if_must<one<';'>, gap, purpose, opt<blanks, one<'p'>, primitive>, opt<if_must<against, node>>,
                        opt<if_must<serves, effect>>> {};
struct instruction : seq<mnemonic, operands, gap, opt<origin>> {};

// Directives
struct key : word {};
struct equals : one<'='> {};
struct list_item : seq<quoted_string> {};
struct list_end : seq<gap, one<']'>> {};
struct list_begin : one<'['> {};
struct list_value
    : if_must<list_begin, gap, opt<list_item, star<if_must<seq<gap, one<','>>, gap, list_item>>>, list_end> {};
struct string_value : seq<quoted_string> {};
struct bare_value : plus<sor<word_part, one<'+', '-'>>> {};
struct value : sor<string_value, list_value, bare_value> {};
struct pair : if_must<key, equals, value> {};

struct new_field_name : sor<word, quoted_string> {};
struct role : word {};

/// The body of the directive whose name has been read.
struct directive_body {
  using rule_t = directive_body;
  using subs_t = type_list<blanks, new_field_name, field_place, role, quoted_string, pair>;

  template <apply_mode A, rewind_mode M, template <typename...> class Action, template <typename...> class Control,
            typename ParseInput>
  [[nodiscard]] static bool match(ParseInput& in, Reading& reading) {
    const auto demand = [&]<class Rule>(std::type_identity<Rule>) {
      return Control<Rule>::template match<A, M, Action, Control>(in, reading);
    };
    switch (reading.directive) {
      case Directive::field:
        return demand(std::type_identity<must<gap, new_field_name, gap, field_place, gap, role>>{});
      case Directive::primitive: return demand(std::type_identity<must<gap, quoted_string, star<blanks, pair>>>{});
      case Directive::display_model: return demand(std::type_identity<must<gap, quoted_string>>{});
      case Directive::record:
      case Directive::extent:
      case Directive::step:
      case Directive::preparation:
      case Directive::model_preparation:
      case Directive::pruning:
      case Directive::segment: return demand(std::type_identity<star<blanks, pair>>{});
    }
    return false;
  }
};

struct directive_name : word {};
struct directive : if_must<one<'.'>, directive_name, directive_body> {};

struct statement : sor<directive, instruction> {};
struct line : seq<gap, sor<seq<opt<comment>, eolf>, must<statement, line_end>>> {};
struct file : until<eof, line> {};

/// Error text where a rule must match but does not.
template <class Rule>
constexpr const char* message() {
  if (std::is_same_v<Rule, line_end>) return "unexpected text; end the line here, or begin a comment with #";
  if (std::is_same_v<Rule, escape_code>) return "unknown escape; write \\\", \\\\ or \\xNN";
  if (std::is_same_v<Rule, string_end>) return "the string does not end on its line; close it with \"";
  if (std::is_same_v<Rule, quoted_string>) return "expected a string in double quotes";
  if (std::is_same_v<Rule, field_place>) return "expected the place of a field: [bit] or [base+:width]";
  if (std::is_same_v<Rule, field_operand>) return "expected a field: its name, [bit] or [base+:width]";
  if (std::is_same_v<Rule, term>) return "expected a term of A*x + B*y + C";
  if (std::is_same_v<Rule, variable>) return "expected x or y";
  if (std::is_same_v<Rule, linear_bits>) return "expected the width of the linear expression, as in (w35 >> 12)";
  if (std::is_same_v<Rule, linear_width>) return "expected a width in bits, as in (w35 >> 12)";
  if (std::is_same_v<Rule, linear_shift>) return "expected a number of fraction bits, as in (w35 >> 12)";
  if (std::is_same_v<Rule, linear_end>) return "expected ) at the end of the width, as in (w35 >> 12)";
  if (std::is_same_v<Rule, linear_operand>) return "expected a linear expression, as in 12*x - 7*y + 991 (w35 >> 12)";
  if (std::is_same_v<Rule, square_term>) return "expected a term of A*x*x + B*x*y + C*y*y";
  if (std::is_same_v<Rule, squares_bits>) return "expected the width of the next instruction's expression, as in (w35)";
  if (std::is_same_v<Rule, squares_operand>) return "expected squares, as in 3*x*x - 2*x*y + 5*y*y (w35)";
  if (std::is_same_v<Rule, constant_operand>) return "expected a constant, as in 255 or 0xff";
  if (std::is_same_v<Rule, instruction_count>) return "expected a number of instructions, as in skip_if_none 12";
  if (std::is_same_v<Rule, comma>) return "expected a comma and one more operand";
  if (std::is_same_v<Rule, purpose>) return "expected a purpose, as in ; render p0";
  if (std::is_same_v<Rule, node>) return "expected the index of a primitive, as in against p1";
  if (std::is_same_v<Rule, equals>) return "expected = and a value after the key";
  if (std::is_same_v<Rule, value>) return "expected a number, true, false, a string or a list of strings";
  if (std::is_same_v<Rule, list_item>) return "expected one more string in double quotes";
  if (std::is_same_v<Rule, list_end>) return "expected ] at the end of the list, or a comma";
  if (std::is_same_v<Rule, new_field_name>) return "expected a name for the field: a word or a string";
  if (std::is_same_v<Rule, role>) return "expected the role of the field, as in .field Z2 [20+:20] depth";
  if (std::is_same_v<Rule, directive_name>) return "expected the name of a directive, as in .segment";
  if (std::is_same_v<Rule, statement>) return "expected an instruction, or a directive that begins with a dot";
  return message_of_part<Rule>();
}

struct Messages {
  template <typename Rule>
  static constexpr const char* message = grammar::message<Rule>();
  /// Raises errors only where a rule must match; elsewhere an alternative may match.
  template <typename Rule>
  static constexpr bool raise_on_failure = false;
};

template <typename Rule>
using Control = must_if<Messages, normal, false>::control<Rule>;

}  // namespace csgsim::isa::grammar
