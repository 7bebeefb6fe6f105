// PEGTL rules and error handling shared by two grammars.
// Used by sim/debug.
#pragma once

#include <string_view>
#include <tao/pegtl.hpp>
#include <type_traits>

#include "hw/base/error.h"

/// Grammar rules shared by the text form of a Program and the debugger's commands.
namespace csgsim::isa::grammar {

using namespace tao::pegtl;

struct gap : star<blank> {};
struct word_part : ranges<'a', 'z', 'A', 'Z', '0', '9', '_', '_', '.', '.'> {};
struct word : seq<ranges<'a', 'z', 'A', 'Z', '_', '_'>, star<word_part>> {};
struct number : plus<digit> {};

struct hexadecimal : plus<xdigit> {};
struct decimal : number {};
struct constant : sor<if_must<string<'0', 'x'>, hexadecimal>, decimal> {};

struct field_base : number {};
struct field_width : number {};
struct field_end : seq<gap, one<']'>> {};
struct field_place
    : if_must<one<'['>, gap, field_base, opt<if_must<seq<gap, string<'+', ':'>>, gap, field_width>>, field_end> {};

/// Error text where one of these rules must match but does not; null for other rules.
template <class Rule>
constexpr const char* message_of_part() {
  if (std::is_same_v<Rule, hexadecimal>) return "expected hexadecimal digits after 0x";
  if (std::is_same_v<Rule, field_base>) return "expected the number of a bit, as in [12] or [12+:20]";
  if (std::is_same_v<Rule, field_width>) return "expected a width in bits, as in [12+:20]";
  if (std::is_same_v<Rule, field_end>) return "expected ] at the end of the field, as in [12] or [12+:20]";
  return nullptr;
}

/// An action that calls Does::read(text, reading) and adds the position to an InputError.
template <class Does>
struct Located {
  template <typename ActionInput, class Reading>
  static void apply(const ActionInput& in, Reading& reading) {
    try {
      Does::read(in.string_view(), reading);
    } catch (const InputError& error) {
      throw parse_error(error.what(), in);
    }
  }
};

/// Parses the input. Throws InputError of the form `name:line:column: what is wrong; what to do`.
template <class Rule, template <typename...> class Action, template <typename...> class Control, class Input,
          class Reading>
void read(Input& in, Reading& reading) {
  try {
    tao::pegtl::parse<Rule, Action, Control>(in, reading);
  } catch (const parse_error& error) {
    throw InputError(error.what());
  }
}

}  // namespace csgsim::isa::grammar

/// Begins the body of the action for a rule; `matched` is the text that the rule has matched.
#define CSGSIM_WHEN(rule)                                                                 \
  template <>                                                                             \
  struct Action<grammar::rule> : ::csgsim::isa::grammar::Located<Action<grammar::rule>> { \
    static void read([[maybe_unused]] std::string_view matched, Reading& reading);        \
  };                                                                                      \
  void Action<grammar::rule>::read([[maybe_unused]] std::string_view matched, Reading& reading)
