// The lexical grammar of files of commands.
// Used by lines.cpp.
#pragma once

#include <tao/pegtl.hpp>

#include "host/read/grammar.h"

/// Words, numbers and signs in lines. The interpreter parses the lines, so no rule of this grammar nests.
namespace csgsim::commands::grammar {

namespace peg = tao::pegtl;

struct line_end : peg::eol {};
struct continued : peg::seq<peg::one<'\\'>, peg::star<peg::blank>, peg::eolf> {};
struct comment : peg::seq<peg::one<'#'>, peg::star<peg::not_one<'\n'>>> {};
struct gap
    : peg::plus<peg::sor<continued, peg::blank, peg::seq<peg::one<'\r'>, peg::not_at<peg::one<'\n'>>>, comment>> {};
struct number : read::grammar::decimal {};
struct word : peg::identifier {};
struct sign : peg::one<'=', '+', '-', '*', '(', ')'> {};
struct item : peg::sor<line_end, gap, number, word, sign> {};
struct file : peg::until<peg::eof, peg::must<item>> {};

}  // namespace csgsim::commands::grammar
