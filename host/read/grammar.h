// Grammar of `.csg` files.
// Used by syntax.cpp and host/commands.
#pragma once

#include <tao/pegtl.hpp>

/// The grammar of a `.csg` file. It is flat: braces are items of one list, so a deep tree cannot overflow the stack.
/// Only vectors nest in the grammar; the action of `vector_open` limits their depth.
namespace csgsim::read::grammar {

namespace peg = tao::pegtl;

struct line_comment : peg::seq<peg::two<'/'>, peg::until<peg::eolf>> {};
struct comment_end : peg::until<peg::string<'*', '/'>> {};
struct comment_open : peg::string<'/', '*'> {};
struct block_comment : peg::if_must<comment_open, comment_end> {};
struct blanks : peg::star<peg::sor<peg::space, line_comment, block_comment>> {};

struct identifier : peg::seq<peg::sor<peg::identifier_first, peg::one<'$'>>, peg::star<peg::identifier_other>> {};
template <char... Letters>
struct word : peg::seq<peg::string<Letters...>, peg::not_at<peg::identifier_other>> {};

struct sign : peg::opt<peg::one<'+', '-'>> {};
struct exponent : peg::seq<peg::one<'e', 'E'>, sign, peg::plus<peg::digit>> {};
struct mantissa : peg::sor<peg::seq<peg::plus<peg::digit>, peg::opt<peg::one<'.'>, peg::star<peg::digit>>>,
                           peg::seq<peg::one<'.'>, peg::plus<peg::digit>>> {};
struct decimal : peg::seq<sign, mantissa, peg::opt<exponent>, peg::not_at<peg::identifier_other>> {};
struct non_finite : peg::seq<sign, peg::sor<word<'i', 'n', 'f'>, word<'n', 'a', 'n'>>> {};

struct truth : word<'t', 'r', 'u', 'e'> {};
struct falsehood : word<'f', 'a', 'l', 's', 'e'> {};
struct undefined : word<'u', 'n', 'd', 'e', 'f'> {};

/// OpenSCAD writes strings without escaping quotes. A quote therefore ends a string only if the text after it can
/// follow a value: the end of the arguments, another named argument, or an argument that is not a string.
struct passed_over : peg::star<peg::sor<peg::space, line_comment, peg::seq<comment_open, comment_end>>> {};
struct next_argument : peg::sor<peg::seq<identifier, passed_over, peg::one<'='>>, decimal, non_finite, peg::one<'['>,
                                truth, falsehood, undefined> {};
struct after_string
    : peg::sor<peg::seq<peg::one<','>, passed_over, next_argument>,
               peg::seq<peg::one<')'>, passed_over, peg::sor<peg::one<';', '{'>, peg::eof>>, peg::one<']'>> {};
struct closing_quote : peg::seq<peg::one<'"'>, peg::at<passed_over, after_string>> {};
struct string_end : peg::until<closing_quote> {};
struct string_open : peg::one<'"'> {};
struct text : peg::if_must<string_open, string_end> {};

struct value;
struct vector_open : peg::one<'['> {};
struct vector_close : peg::one<']'> {};
struct element : peg::seq<value> {};
struct element_end : peg::sor<peg::one<','>, peg::at<vector_close>> {};
struct vector_rest : peg::until<vector_close, peg::must<element>, blanks, peg::must<element_end>, blanks> {};
struct vector : peg::if_must<vector_open, blanks, vector_rest> {};
struct value : peg::sor<decimal, vector, truth, falsehood, undefined, non_finite, text> {};

struct argument_name : peg::seq<identifier, blanks, peg::one<'='>> {};
struct argument_value : value {};
struct argument : peg::sor<peg::if_must<argument_name, blanks, argument_value>, argument_value> {};
struct arguments_open : peg::one<'('> {};
struct arguments_close : peg::one<')'> {};
struct argument_end : peg::sor<peg::one<','>, peg::at<arguments_close>> {};
struct arguments : peg::until<arguments_close, peg::must<argument>, blanks, peg::must<argument_end>, blanks> {};

struct modifier : peg::one<'%', '#', '*', '!'> {};
struct node_name : identifier {};
struct head : peg::sor<peg::if_must<peg::plus<modifier, blanks>, node_name>, node_name> {};
struct semicolon : peg::one<';'> {};
struct brace_open : peg::one<'{'> {};
struct statement_end : peg::sor<semicolon, brace_open> {};
struct statement : peg::if_must<head, blanks, arguments_open, blanks, arguments, blanks, statement_end> {};

struct brace_close : peg::one<'}'> {};
struct item : peg::sor<statement, brace_close, peg::one<';'>> {};
struct file : peg::seq<blanks, peg::until<peg::eof, peg::must<item>, blanks>> {};

}  // namespace csgsim::read::grammar
