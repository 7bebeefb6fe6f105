// PEGTL grammar of debugger commands.
// Used by parse.cpp.
#pragma once

#include <type_traits>

#include "hw/isa/grammar_parts.h"

/// Grammar of the debugger's commands (sim/debug/command.h).
namespace csgsim::debug::grammar {

using namespace isa::grammar;

template <typename Word>
struct whole : seq<Word, not_at<word_part>> {};

struct count : seq<number, not_at<word_part>> {};
struct instruction_number : seq<number, not_at<word_part>> {};
struct breakpoint_number : seq<number, not_at<word_part>> {};
struct column : number {};
struct row : number {};
struct comma : seq<gap, one<','>> {};

struct quoted_body : star<sor<seq<one<'\\'>, any>, not_one<'"', '\\'>>> {};
struct quote_end : one<'"'> {};
struct quoted : if_must<one<'"'>, quoted_body, quote_end> {};

struct field_word : word {};
struct field_quoted : seq<quoted> {};
struct field : sor<field_place, field_quoted, field_word> {};

struct pixel_begin : seq<gap, one<'['>> {};
struct pixel_end : seq<gap, one<']'>> {};
struct pixel_of_field : must<pixel_begin, gap, column, comma, gap, row, pixel_end> {};
struct watched : seq<field, pixel_of_field> {};

struct less : one<'<'> {};
struct not_greater : string<'<', '='> {};
struct equal : sor<string<'=', '='>, one<'='>> {};
struct not_equal : string<'!', '='> {};
struct not_less : string<'>', '='> {};
struct greater : one<'>'> {};
struct relation : sor<not_greater, less, equal, not_equal, not_less, greater> {};
struct value : seq<constant, not_at<word_part>> {};

struct change : whole<TAO_PEGTL_STRING("change")> {};
struct negation : whole<TAO_PEGTL_STRING("not")> {};
struct changes : if_must<change, gap, watched> {};
struct is_not : if_must<negation, gap, watched> {};
struct compared : seq<watched, opt<if_must<seq<gap, relation>, gap, value>>> {};
struct condition : sor<changes, is_not, compared> {};

struct at_instruction : seq<one<'i'>, instruction_number> {};
struct clock_number : seq<number, not_at<word_part>> {};
struct at_clock : if_must<whole<TAO_PEGTL_STRING("clock")>, gap, clock_number> {};
struct primitive_word : plus<not_one<' ', '\t', '\r', '\n', '#', '"'>> {};
struct primitive_quoted : seq<quoted> {};
struct primitive : sor<primitive_quoted, primitive_word> {};
struct at_primitive : if_must<whole<TAO_PEGTL_STRING("primitive")>, gap, primitive> {};
struct target : sor<at_instruction, at_clock, at_primitive, condition> {};

struct file_word : plus<not_one<' ', '\t', '\r', '\n', '#', '"'>> {};
struct file_quoted : seq<quoted> {};
struct file : sor<file_quoted, file_word> {};

struct lone_pixel : seq<column, must<comma, gap, row>> {};
struct lone_enable : seq<one<'E'>, not_at<word_part>, not_at<gap, one<'['>>> {};
struct printed : sor<lone_enable, lone_pixel, watched> {};

template <typename Word, typename... Rest>
struct command : if_must<whole<Word>, Rest...> {};

// Each command also has the abbreviations of other debuggers (command.h).
struct run : command<sor<TAO_PEGTL_STRING("run"), TAO_PEGTL_STRING("continue"), one<'r', 'c'>>> {};
struct step : command<sor<TAO_PEGTL_STRING("stepi"), TAO_PEGTL_STRING("step"), TAO_PEGTL_STRING("nexti"),
                          TAO_PEGTL_STRING("next"), TAO_PEGTL_STRING("si"), TAO_PEGTL_STRING("ni"), one<'s', 'n'>>,
                      opt<gap, count>> {};
struct until_target : command<sor<TAO_PEGTL_STRING("until"), one<'u'>>, gap, target> {};
struct back : command<sor<TAO_PEGTL_STRING("back"), TAO_PEGTL_STRING("reverse-step"), TAO_PEGTL_STRING("rs")>,
                      opt<gap, count>> {};
struct breakpoints : command<TAO_PEGTL_STRING("breakpoints")> {};
struct set_break : command<sor<TAO_PEGTL_STRING("break"), one<'b'>>, gap, target> {};
struct delete_break : command<sor<TAO_PEGTL_STRING("delete"), one<'d'>>, gap, breakpoint_number> {};
struct print : command<sor<TAO_PEGTL_STRING("print"), one<'p'>>, gap, printed> {};
struct where : command<sor<TAO_PEGTL_STRING("where"), TAO_PEGTL_STRING("bt"), one<'w'>>> {};
struct list_around : command<sor<TAO_PEGTL_STRING("list"), one<'l'>>, opt<gap, one<'i'>, instruction_number>> {};
struct picture : command<TAO_PEGTL_STRING("picture"), gap, field, gap, file> {};
struct checkpoint : command<TAO_PEGTL_STRING("checkpoint"), gap, file> {};
struct resume : command<TAO_PEGTL_STRING("resume"), gap, file> {};
struct help : command<sor<TAO_PEGTL_STRING("help"), one<'h', '?'>>> {};
struct quit : command<sor<TAO_PEGTL_STRING("quit"), TAO_PEGTL_STRING("exit"), one<'q'>>> {};

struct any_command : sor<run, step, until_target, back, breakpoints, set_break, delete_break, print, where, list_around,
                         picture, checkpoint, resume, help, quit> {};
struct comment : seq<one<'#'>, until<eof>> {};
struct line_end : seq<gap, opt<one<'\r'>>, sor<comment, eof>> {};
struct known_command : seq<any_command> {};
struct line : seq<gap, sor<line_end, seq<must<known_command>, must<line_end>>>> {};

/// The message if a mandatory rule does not match.
template <class Rule>
constexpr const char* message() {
  if (std::is_same_v<Rule, known_command>) return "unknown command; help lists the commands";
  if (std::is_same_v<Rule, line_end>) return "unexpected text; end the line here or start a comment with #";
  if (std::is_same_v<Rule, quote_end>) return "unterminated name; close it with \"";
  if (std::is_same_v<Rule, quoted_body>) return "expected a name in double quotes";
  if (std::is_same_v<Rule, field>) return "expected a field: its name, [base+:width] or E";
  if (std::is_same_v<Rule, watched>) return "expected a field of a pixel, as in Z2[100,20]";
  if (std::is_same_v<Rule, pixel_begin>) return "expected a pixel of the field, as in Z2[100,20]";
  if (std::is_same_v<Rule, pixel_end>) return "expected ] after the pixel, as in Z2[100,20]";
  if (std::is_same_v<Rule, column>) return "expected the pixel's column, as in Z2[100,20]";
  if (std::is_same_v<Rule, row>) return "expected the pixel's row, as in Z2[100,20]";
  if (std::is_same_v<Rule, comma>) return "expected a comma and the pixel's row, as in 100,20";
  if (std::is_same_v<Rule, value>) return "expected a number to compare with, as in 5000 or 0xff";
  if (std::is_same_v<Rule, clock_number>) return "expected the number of a clock, as in clock 12000";
  if (std::is_same_v<Rule, primitive>) return "expected a primitive: its index or its name";
  if (std::is_same_v<Rule, target>)
    return "expected a place to stop: i123, clock N, primitive P, or a condition such as Z2[100,20] < 5000";
  if (std::is_same_v<Rule, breakpoint_number>) return "expected the number of a breakpoint; breakpoints lists them";
  if (std::is_same_v<Rule, printed>) return "expected a value, a pixel or E to print, as in Z2[100,20], 100,20 or E";
  if (std::is_same_v<Rule, file>) return "expected the name of a file";
  return message_of_part<Rule>();
}

struct Messages {
  template <typename Rule>
  static constexpr const char* message = grammar::message<Rule>();
  /// Reported only for mandatory rules; elsewhere an alternative may match.
  template <typename Rule>
  static constexpr bool raise_on_failure = false;
};

template <typename Rule>
using Control = must_if<Messages, normal, false>::control<Rule>;

}  // namespace csgsim::debug::grammar
