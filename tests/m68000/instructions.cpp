// The effect and the clocks of each instruction.

#include <bit>
#include <utility>

#include "tests/m68000/manual_clocks.h"
#include "tests/m68000/numbers.h"
#include "tests/m68000/processor.h"

namespace csgsim::m68000 {

namespace {

using manual::address_clocks;

constexpr unsigned line_of_compare = 0xb;

/// Operand sizes encoded in bits 6 and 7; the code 3 is invalid.
constexpr Size sizes[] = {Size::byte, Size::word, Size::longword};

constexpr bool is_long(Size size) { return size == Size::longword; }
constexpr bool is_register(unsigned mode) { return mode < 2; }
/// Whether an operand is a register or a constant; long operations on these take longer.
constexpr bool is_at_hand(unsigned mode, unsigned reg) { return is_register(mode) || (mode == 7 && reg == 4); }

constexpr unsigned clocks_by(Size size, unsigned shorter, unsigned longer) { return is_long(size) ? longer : shorter; }

}  // namespace

void Processor::step() {
  const Operation operation{static_cast<std::uint16_t>(fetch(Size::word))};
  switch (operation.bits(12, 4)) {
    case 0x0: return immediate(operation);
    case 0x1:
    case 0x2:
    case 0x3: return move(operation);
    case 0x4: return execute_miscellaneous(operation);
    case 0x5: return operation.bits(6, 2) == 3 ? execute_count_down(operation) : execute_quick(operation);
    case 0x6: return execute_branch(operation);
    case 0x7: return move_quick(operation);
    case 0xc:
      if (operation.bits(6, 2) == 3) return multiply(operation);
      return execute_arithmetic(operation);
    case 0x8:
    case 0x9:
    case 0xd: return operation.bits(6, 2) == 3 ? execute_address_arithmetic(operation) : execute_arithmetic(operation);
    case line_of_compare:
      return operation.bits(6, 2) == 3 ? execute_address_arithmetic(operation)
                                       : execute_compare_or_exclusive_or(operation);
    case 0xe: return shift(operation);
    default: unknown(operation);
  }
}

bool Processor::is_condition_true(unsigned condition) const {
  const Conditions& on = conditions;
  const bool less = on.negative != on.overflow;
  const bool basis[] = {true,         !on.carry && !on.zero, !on.carry, !on.zero,
                        !on.overflow, !on.negative,          !less,     !less && !on.zero};
  return basis[condition / 2] == (condition % 2 == 0);
}

void Processor::set_logic_conditions(std::uint32_t value, Size size) {
  conditions.carry = false;
  conditions.overflow = false;
  conditions.zero = (value & mask_of(size)) == 0;
  conditions.negative = is_negative(value, size);
}

std::uint32_t Processor::add(std::uint32_t to, std::uint32_t value, Size size) {
  const std::uint64_t sum = std::uint64_t{to} + value;
  const auto result = static_cast<std::uint32_t>(sum) & mask_of(size);
  set_logic_conditions(result, size);
  conditions.carry = sum > mask_of(size);
  conditions.overflow = is_negative(~(to ^ value) & (to ^ result), size);
  conditions.extend = conditions.carry;
  return result;
}

void Processor::compare(std::uint32_t from, std::uint32_t value, Size size) {
  const std::uint32_t result = (from - value) & mask_of(size);
  set_logic_conditions(result, size);
  conditions.carry = value > from;
  conditions.overflow = is_negative((from ^ value) & (from ^ result), size);
}

std::uint32_t Processor::subtract(std::uint32_t from, std::uint32_t value, Size size) {
  compare(from, value, size);
  conditions.extend = conditions.carry;
  return (from - value) & mask_of(size);
}

/// MOVE, MOVEA.
void Processor::move(Operation operation) {
  constexpr Size move_sizes[] = {Size::byte, Size::byte, Size::longword, Size::word};
  const Size size = move_sizes[operation.bits(12, 2)];
  const unsigned to_mode = operation.bits(6, 3);
  const unsigned to = operation.upper();
  if (to_mode == 7 && to > 1) unknown(operation);
  const std::uint32_t value = get(place(operation.mode(), operation.reg(), size), size);
  put(place(to_mode, to, size), size, value);
  if (to_mode != 1) set_logic_conditions(value, size);
  take(4 + address_clocks(operation.mode(), operation.reg(), size) +
       (is_long(size) ? manual::move_to_long : manual::move_to)[manual::mode_index(to_mode, to)]);
}

void Processor::move_quick(Operation operation) {
  if (operation.bits(8, 1) != 0) unknown(operation);
  d[operation.upper()] = extended(operation.bits(0, 8), Size::byte);
  set_logic_conditions(d[operation.upper()], Size::longword);
  take(4);
}

/// ORI, ANDI, SUBI, ADDI, EORI, CMPI.
void Processor::immediate(Operation operation) {
  const unsigned what = operation.upper();
  if (operation.bits(8, 1) != 0 || operation.bits(6, 2) == 3 || what == 4 || what == 7 || operation.mode() == 1 ||
      (operation.mode() == 7 && operation.reg() > 1))
    unknown(operation);
  const Size size = sizes[operation.bits(6, 2)];
  const std::uint32_t value = fetch(size);
  const Place to = place(operation.mode(), operation.reg(), size);
  const std::uint32_t old = get(to, size);
  const unsigned address = address_clocks(operation.mode(), operation.reg(), size);
  if (what == 6) {
    compare(old, value, size);
    take(operation.mode() == 0 ? clocks_by(size, 8, 14) : clocks_by(size, 8, 12) + address);
    return;
  }
  constexpr unsigned lines[] = {0x8, 0xc, 0x9, 0xd, 0, line_of_compare};
  put(to, size, combine(lines[what], old, value, size));
  take(operation.mode() == 0 ? clocks_by(size, 8, 16) : clocks_by(size, 12, 20) + address);
}

/// Combines two operands, by the instruction's line: OR, SUB, EOR, AND or ADD.
std::uint32_t Processor::combine(unsigned line, std::uint32_t to, std::uint32_t value, Size size) {
  if (line == 0x9) return subtract(to, value, size);
  if (line == 0xd) return add(to, value, size);
  const std::uint32_t result = line == 0x8 ? to | value : line == 0xc ? to & value : to ^ value;
  set_logic_conditions(result, size);
  return result;
}

/// OR, SUB, AND, ADD.
void Processor::execute_arithmetic(Operation operation) {
  const Size size = sizes[operation.bits(6, 2)];
  const bool to_memory = operation.bits(8, 1) != 0;
  const unsigned line = operation.bits(12, 4);
  const bool is_logic = line == 0x8 || line == 0xc;
  if ((to_memory && is_register(operation.mode())) || (is_logic && operation.mode() == 1)) unknown(operation);
  if (to_memory && operation.mode() == 7 && operation.reg() > 1) unknown(operation);
  const Place at = place(operation.mode(), operation.reg(), size);
  const std::uint32_t there = get(at, size);
  const Place reg{Place::In::data, operation.upper()};
  const std::uint32_t here = get(reg, size);
  if (to_memory) {
    put(at, size, combine(line, there, here, size));
  } else {
    put(reg, size, combine(line, here, there, size));
  }
  const unsigned of_long = to_memory ? 12 : is_at_hand(operation.mode(), operation.reg()) ? 8 : 6;
  take(clocks_by(size, to_memory ? 8 : 4, of_long) + address_clocks(operation.mode(), operation.reg(), size));
}

/// SUBA, ADDA, CMPA.
void Processor::execute_address_arithmetic(Operation operation) {
  const unsigned line = operation.bits(12, 4);
  if (line == 0x8) unknown(operation);  // divisions are not supported
  const Size size = operation.bits(8, 1) != 0 ? Size::longword : Size::word;
  const std::uint32_t value = extended(get(place(operation.mode(), operation.reg(), size), size), size);
  std::uint32_t& reg = a[operation.upper()];
  const unsigned address = address_clocks(operation.mode(), operation.reg(), size);
  if (line == line_of_compare) {
    compare(reg, value, Size::longword);
    take(6 + address);
    return;
  }
  reg = line == 0x9 ? reg - value : reg + value;
  take(clocks_by(size, 8, is_at_hand(operation.mode(), operation.reg()) ? 8 : 6) + address);
}

/// MULU, MULS. The clocks depend on the source: on its ones, or on the changes between its bits with a 0 behind them.
void Processor::multiply(Operation operation) {
  if (operation.mode() == 1) unknown(operation);
  const bool is_signed = operation.bits(8, 1) != 0;
  const std::uint32_t source = get(place(operation.mode(), operation.reg(), Size::word), Size::word);
  std::uint32_t& target = d[operation.upper()];
  const std::uint32_t other = target & mask_of(Size::word);
  target = is_signed ? extended(source, Size::word) * extended(other, Size::word) : source * other;
  set_logic_conditions(target, Size::longword);
  const std::uint32_t counted = is_signed ? (source ^ source << 1U) & mask_of(Size::word) : source;
  take(38 + 2 * static_cast<unsigned>(std::popcount(counted)) +
       address_clocks(operation.mode(), operation.reg(), Size::word));
}

/// CMP, EOR.
void Processor::execute_compare_or_exclusive_or(Operation operation) {
  const Size size = sizes[operation.bits(6, 2)];
  const bool is_exclusive = operation.bits(8, 1) != 0;
  if (is_exclusive && (operation.mode() == 1 || (operation.mode() == 7 && operation.reg() > 1))) unknown(operation);
  const Place at = place(operation.mode(), operation.reg(), size);
  const std::uint32_t there = get(at, size);
  const std::uint32_t here = d[operation.upper()] & mask_of(size);
  const unsigned address = address_clocks(operation.mode(), operation.reg(), size);
  if (is_exclusive) {
    put(at, size, combine(line_of_compare, there, here, size));
    take(operation.mode() == 0 ? clocks_by(size, 4, 8) : clocks_by(size, 8, 12) + address);
  } else {
    compare(here, there, size);
    take(clocks_by(size, 4, 6) + address);
  }
}

/// ADDQ, SUBQ.
void Processor::execute_quick(Operation operation) {
  const Size size = sizes[operation.bits(6, 2)];
  const std::uint32_t value = operation.upper() == 0 ? 8 : operation.upper();
  const bool is_subtraction = operation.bits(8, 1) != 0;
  if (operation.mode() == 1) {
    std::uint32_t& reg = a[operation.reg()];
    reg = is_subtraction ? reg - value : reg + value;
    take(8);
    return;
  }
  if (operation.mode() == 7 && operation.reg() > 1) unknown(operation);
  const Place to = place(operation.mode(), operation.reg(), size);
  const std::uint32_t old = get(to, size);
  put(to, size, is_subtraction ? subtract(old, value, size) : add(old, value, size));
  take(operation.mode() == 0 ? clocks_by(size, 4, 8)
                             : clocks_by(size, 8, 12) + address_clocks(operation.mode(), operation.reg(), size));
}

/// DBcc, Scc.
void Processor::execute_count_down(Operation operation) {
  const bool is_so = is_condition_true(operation.bits(8, 4));
  if (operation.mode() != 1) {
    if (operation.mode() == 7 && operation.reg() > 1) unknown(operation);
    put(place(operation.mode(), operation.reg(), Size::byte), Size::byte, is_so ? 0xff : 0);
    take(operation.mode() != 0 ? 8 + address_clocks(operation.mode(), operation.reg(), Size::byte) : is_so ? 6 : 4);
    return;
  }
  const std::uint32_t base = pc;
  const std::uint32_t displacement = extended(fetch(Size::word), Size::word);
  if (is_so) {
    take(12);
    return;
  }
  const Place counter{Place::In::data, operation.reg()};
  const std::uint32_t left = (get(counter, Size::word) - 1) & mask_of(Size::word);
  put(counter, Size::word, left);
  take(left == mask_of(Size::word) ? 14 : 10);
  if (left != mask_of(Size::word)) pc = base + displacement;
}

/// Bcc, BRA, BSR.
void Processor::execute_branch(Operation operation) {
  const std::uint32_t base = pc;
  const unsigned condition = operation.bits(8, 4);
  const bool is_short = operation.bits(0, 8) != 0;
  const std::uint32_t displacement =
      is_short ? extended(operation.bits(0, 8), Size::byte) : extended(fetch(Size::word), Size::word);
  constexpr unsigned to_subroutine = 1;
  if (condition == to_subroutine) {
    push(pc);
    pc = base + displacement;
    take(18);
  } else if (is_condition_true(condition)) {
    pc = base + displacement;
    take(10);
  } else {
    take(is_short ? 8 : 12);
  }
}

}  // namespace csgsim::m68000
