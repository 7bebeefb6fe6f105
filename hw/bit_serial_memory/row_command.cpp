#include "hw/bit_serial_memory/row_command.h"

#include <fmt/format.h>

#include <span>

namespace csgsim::bit_serial_memory {

namespace {

std::string text_of(const WordLines& lines) {
  std::string text;
  for (const WordLine& line : lines) text += fmt::format(" {}{}", line.negated ? "!" : "", line.row);
  return text;
}

std::string operands_of(const RowCommand& command) {
  if (command.own != nullptr) {
    const std::array latches{command.x, command.y, command.z};
    std::string text;
    for (const Latch latch : std::span(latches).first(command.own->inputs)) text += fmt::format(" {}", name_of(latch));
    return text;
  }
  switch (command.gate) {
    case Gate::zero:
    case Gate::one: return "";
    case Gate::move:
    case Gate::invert: return fmt::format(" {}", name_of(command.x));
    case Gate::conjunction:
    case Gate::disjunction:
    case Gate::unequal:
    case Gate::equal: return fmt::format(" {} {}", name_of(command.x), name_of(command.y));
    case Gate::choose: return fmt::format(" {} {} {}", name_of(command.x), name_of(command.y), name_of(command.z));
  }
  return "";
}

}  // namespace

std::string text_of(const RowCommand& command) {
  const std::string_view name = name_of(command.op);
  const std::string where = command.masked ? fmt::format(" where {}", name_of(command.mask)) : "";
  switch (command.op) {
    case RowOp::copy: return fmt::format("{}{} ->{}{}", name, text_of(command.from), text_of(command.to), where);
    case RowOp::activate:
    case RowOp::latch:
    case RowOp::read:
    case RowOp::send:
    case RowOp::wired_or: return fmt::format("{}{}", name, text_of(command.from));
    case RowOp::write: return fmt::format("{}{}{}", name, text_of(command.to), where);
    case RowOp::logic:
      return fmt::format("{} {} = {}{}", name, name_of(command.target),
                         command.own != nullptr ? command.own->name : name_of(command.gate), operands_of(command));
    case RowOp::leaf: return fmt::format("{} {}", name, command.bit);
    case RowOp::leaf_copy:
    case RowOp::receive: return fmt::format("{} {} ->{}{}", name, command.bit, text_of(command.to), where);
  }
  return "";
}

}  // namespace csgsim::bit_serial_memory
