#include "host/read/syntax.h"

#include <fmt/format.h>

#include <concepts>

#include "host/read/grammar.h"
#include "host/read/parser.h"

namespace csgsim::read {

namespace {

template <typename Rule>
struct Action : tao::pegtl::nothing<Rule> {};

/// An action that passes the matched text to a member of the parser.
template <void (Parser::*act)(std::string_view)>
struct Calls {
  template <typename Input>
  static void apply(const Input& in, Parser& parser) {
    (parser.*act)(in.string_view());
  }
};

template <>
struct Action<grammar::comment_open> : Calls<&Parser::open_quote> {};
template <>
struct Action<grammar::string_open> : Calls<&Parser::open_quote> {};
template <>
struct Action<grammar::modifier> : Calls<&Parser::add_modifier> {};
template <>
struct Action<grammar::node_name> : Calls<&Parser::name_statement> {};
template <>
struct Action<grammar::argument_name> : Calls<&Parser::name_argument> {};
template <>
struct Action<grammar::argument> : Calls<&Parser::finish_argument> {};
template <>
struct Action<grammar::decimal> : Calls<&Parser::add_number> {};
template <>
struct Action<grammar::non_finite> : Calls<&Parser::add_number> {};
template <>
struct Action<grammar::truth> : Calls<&Parser::add_true> {};
template <>
struct Action<grammar::falsehood> : Calls<&Parser::add_false> {};
template <>
struct Action<grammar::undefined> : Calls<&Parser::add_undefined> {};
template <>
struct Action<grammar::text> : Calls<&Parser::add_string> {};
template <>
struct Action<grammar::vector_open> : Calls<&Parser::open_vector> {};
template <>
struct Action<grammar::vector> : Calls<&Parser::close_vector> {};
template <>
struct Action<grammar::semicolon> : Calls<&Parser::finish_leaf> {};
template <>
struct Action<grammar::brace_open> : Calls<&Parser::open_braces> {};
template <>
struct Action<grammar::brace_close> : Calls<&Parser::close_braces> {};

/// The expected text where a rule must match, for messages; {0} is replaced by the node's name. The default is for
/// rules that fail only if one of the rules below fails.
template <typename Rule>
constexpr auto expected = "something else";
template <>
constexpr auto expected<grammar::item> = "a node such as cube(...), or `}}`";
template <>
constexpr auto expected<grammar::node_name> = "a node such as cube(...) after its modifier";
template <>
constexpr auto expected<grammar::argument> = "`name = value`, a value or `)` in {0}(...)";
template <>
constexpr auto expected<grammar::argument_value> = "a number, true, false, undef, a \"string\" or a [vector] after `=`";
template <>
constexpr auto expected<grammar::argument_end> = "`,` or `)` in {0}(...)";
template <>
constexpr auto expected<grammar::element> = "a value or `]` in a vector of {0}(...)";
template <>
constexpr auto expected<grammar::element_end> = "`,` or `]` in a vector of {0}(...)";
template <>
constexpr auto expected<grammar::statement_end> = "`;` or `{{` after {0}(...)";

template <typename Rule>
struct Control : tao::pegtl::normal<Rule> {
  template <typename Input>
  [[noreturn]] static void raise([[maybe_unused]] const Input& in, Parser& parser) {
    if constexpr (std::same_as<Rule, grammar::comment_end>) {
      parser.fail_in_quote("this comment never ends; close it with */");
    } else if constexpr (std::same_as<Rule, grammar::string_end>) {
      parser.fail_in_quote("this string never ends; close it with \" before `)` or `, name =`");
    } else if constexpr (std::same_as<Rule, grammar::arguments_open>) {
      parser.fail_without_arguments(parser.offset_of(in.current()));
    } else {
      parser.fail_expecting(parser.offset_of(in.current()),
                            fmt::format(fmt::runtime(expected<Rule>), parser.statement_name()));
    }
  }
};

}  // namespace

void visit_statements(Source& source, StatementVisitor& visitor) {
  const std::string_view text = source.text();
  tao::pegtl::memory_input<tao::pegtl::tracking_mode::lazy> input(text.data(), text.size(), "");
  Parser parser(source, visitor);
  tao::pegtl::parse<grammar::file, Action, Control>(input, parser);
  parser.finish_file();
}

}  // namespace csgsim::read
