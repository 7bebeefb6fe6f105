#pragma once

#include <tao/pegtl.hpp>
#include <type_traits>

#include "hw/isa/text_reading.h"

/// The grammar of the text form, of which hw/isa/text.h tells. What operands an instruction takes, and what a directive
/// holds, the tables decide while it is read.
namespace csgsim::isa::grammar {

using namespace tao::pegtl;  // the vocabulary of rules

struct comment : seq<one<'#'>, until<at<eolf>>> {};
struct blanks : plus<blank> {};
struct gap : star<blank> {};
struct line_end : seq<gap, opt<comment>, eolf> {};

struct word_part : ranges<'a', 'z', 'A', 'Z', '0', '9', '_', '_', '.', '.'> {};
struct word : seq<ranges<'a', 'z', 'A', 'Z', '_', '_'>, star<word_part>> {};
struct number : plus<digit> {};

struct escape_code : sor<one<'"', '\\'>, seq<one<'x'>, xdigit, xdigit>> {};
struct string_body : star<sor<if_must<one<'\\'>, escape_code>, not_one<'"', '\\', '\n', '\r'>>> {};
struct string_end : one<'"'> {};
struct quoted_string : if_must<one<'"'>, string_body, string_end> {};

// Operands.
struct field_base : number {};
struct field_width : number {};
struct field_end : seq<gap, one<']'>> {};
struct field_place
    : if_must<one<'['>, gap, field_base, opt<if_must<seq<gap, string<'+', ':'>>, gap, field_width>>, field_end> {};
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

struct hexadecimal : plus<xdigit> {};
struct decimal : number {};
struct constant_operand : sor<if_must<string<'0', 'x'>, hexadecimal>, decimal> {};

struct instruction_count : seq<constant_operand> {};

struct comma : seq<gap, one<','>> {};

/// The operands that the instruction's row in the opcode table asks for.
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

// Instructions.
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

// Directives.
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

/// What the directive holds whose name has been read.
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

/// What is said where a rule that has to match does not.
template <typename>
inline constexpr const char* message = nullptr;
template <>
inline constexpr const char* message<line_end> = "unexpected text; end the line here, or begin a comment with #";
template <>
inline constexpr const char* message<escape_code> = "unknown escape; write \\\", \\\\ or \\xNN";
template <>
inline constexpr const char* message<string_end> = "the string does not end on its line; close it with \"";
template <>
inline constexpr const char* message<quoted_string> = "expected a string in double quotes";
template <>
inline constexpr const char* message<field_base> = "expected the number of a bit, as in [12] or [12+:20]";
template <>
inline constexpr const char* message<field_width> = "expected a width in bits, as in [12+:20]";
template <>
inline constexpr const char* message<field_end> = "expected ] at the end of the field, as in [12] or [12+:20]";
template <>
inline constexpr const char* message<field_place> = "expected the place of a field: [bit] or [base+:width]";
template <>
inline constexpr const char* message<field_operand> = "expected a field: its name, [bit] or [base+:width]";
template <>
inline constexpr const char* message<term> = "expected a term of A*x + B*y + C";
template <>
inline constexpr const char* message<variable> = "expected x or y";
template <>
inline constexpr const char* message<linear_bits> = "expected the width of the linear expression, as in (w35 >> 12)";
template <>
inline constexpr const char* message<linear_width> = "expected a width in bits, as in (w35 >> 12)";
template <>
inline constexpr const char* message<linear_shift> = "expected a number of fraction bits, as in (w35 >> 12)";
template <>
inline constexpr const char* message<linear_end> = "expected ) at the end of the width, as in (w35 >> 12)";
template <>
inline constexpr const char* message<linear_operand> =
    "expected a linear expression, as in 12*x - 7*y + 991 (w35 >> 12)";
template <>
inline constexpr const char* message<square_term> = "expected a term of A*x*x + B*x*y + C*y*y";
template <>
inline constexpr const char* message<squares_bits> =
    "expected the width of the next instruction's expression, as in (w35)";
template <>
inline constexpr const char* message<squares_operand> = "expected squares, as in 3*x*x - 2*x*y + 5*y*y (w35)";
template <>
inline constexpr const char* message<hexadecimal> = "expected hexadecimal digits after 0x";
template <>
inline constexpr const char* message<constant_operand> = "expected a constant, as in 255 or 0xff";
template <>
inline constexpr const char* message<instruction_count> = "expected a number of instructions, as in skip_if_none 12";
template <>
inline constexpr const char* message<comma> = "expected a comma and one more operand";
template <>
inline constexpr const char* message<purpose> = "expected a purpose, as in ; render p0";
template <>
inline constexpr const char* message<node> = "expected the index of a primitive, as in against p1";
template <>
inline constexpr const char* message<equals> = "expected = and a value after the key";
template <>
inline constexpr const char* message<value> = "expected a number, true, false, a string or a list of strings";
template <>
inline constexpr const char* message<list_item> = "expected one more string in double quotes";
template <>
inline constexpr const char* message<list_end> = "expected ] at the end of the list, or a comma";
template <>
inline constexpr const char* message<new_field_name> = "expected a name for the field: a word or a string";
template <>
inline constexpr const char* message<role> = "expected the role of the field, as in .field Z2 [20+:20] depth";
template <>
inline constexpr const char* message<directive_name> = "expected the name of a directive, as in .segment";
template <>
inline constexpr const char* message<statement> = "expected an instruction, or a directive that begins with a dot";

struct Messages {
  template <typename Rule>
  static constexpr const char* message = grammar::message<Rule>;
  /// Only where it has to match; elsewhere another rule may.
  template <typename Rule>
  static constexpr bool raise_on_failure = false;
};

template <typename Rule>
using Control = must_if<Messages, normal, false>::control<Rule>;

}  // namespace csgsim::isa::grammar
