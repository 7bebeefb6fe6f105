// Boolean expressions over named solids.
// Used by the interpreter.
#pragma once

#include <cstdint>
#include <functional>

#include "host/commands/cursor.h"
#include "host/model/tree.h"

namespace csgsim::commands {

/// The callbacks that evaluate an expression. Solids are indices that only the callbacks interpret.
struct Algebra {
  std::function<std::uint32_t(const Item& name)> solid;  ///< the solid of that name; fails if there is none
  std::function<std::uint32_t(model::Operator op, std::uint32_t left, std::uint32_t right, const Item& sign)> combine;
};

/// Reads an expression up to the end of the line and returns its solid. It consists of names, + (union), -
/// (difference), * (intersection), and parentheses. `*` binds more tightly than
/// `+` and `-`; operators of equal precedence are left-associative.
std::uint32_t read_expression(Cursor& line, const Algebra& algebra);

}  // namespace csgsim::commands
