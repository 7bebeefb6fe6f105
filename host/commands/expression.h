#pragma once

#include <cstdint>
#include <functional>

#include "host/commands/cursor.h"
#include "host/model/tree.h"

namespace csgsim::commands {

/// What an expression is made of.
struct Algebra {
  std::function<std::uint32_t(const Item& name)> solid;
  std::function<std::uint32_t(model::Operator op, std::uint32_t left, std::uint32_t right, const Item& sign)> combine;
};

/// Names with + (union), - (difference) and * (intersection), which binds closer than the others, and parentheses, up
/// to the end of the line; operators of one strength from left to right.
std::uint32_t read_expression(Cursor& line, const Algebra& algebra);

}  // namespace csgsim::commands
