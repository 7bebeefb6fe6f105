// Instructions with one operand, on addresses and for subroutines; shifts.

#include <bit>
#include <utility>

#include "tests/m68000/manual_clocks.h"
#include "tests/m68000/numbers.h"
#include "tests/m68000/processor.h"

namespace csgsim::m68000 {

namespace {

constexpr Size sizes_of_one[] = {Size::byte, Size::word, Size::longword};

/// Instruction words without an operand; `LINK` and the like have a register number in their low bits.
constexpr unsigned nop = 0x4e71;
constexpr unsigned rts = 0x4e75;
constexpr unsigned link = 0x4e50 >> 3;
constexpr unsigned unlk = 0x4e58 >> 3;
constexpr unsigned swap = 0x4840 >> 3;
constexpr unsigned ext_word = 0x4880 >> 3;
constexpr unsigned ext_long = 0x48c0 >> 3;

/// Kind of shift with code 2: ROXL and ROXR.
constexpr unsigned rotation_through_x = 2;

}  // namespace

void Processor::execute_miscellaneous(Operation operation) {
  std::uint32_t& data = d[operation.reg()];
  std::uint32_t& address = a[operation.reg()];
  switch (operation.word) {
    case nop: return take(4);
    case rts: pc = pop(); return take(16);
    default: break;
  }
  switch (operation.bits(3, 13)) {
    case link: {
      const std::uint32_t displacement = extended(fetch(Size::word), Size::word);
      if (operation.reg() == 7) unknown(operation);  // the manual and emulators differ in the pushed value
      push(address);
      address = a[7];
      a[7] += displacement;
      return take(16);
    }
    case unlk: {
      a[7] = address;
      const std::uint32_t old = pop();
      address = old;
      return take(12);
    }
    case swap:
      data = std::rotl(data, 16);
      set_logic_conditions(data, Size::longword);
      return take(4);
    case ext_word:
      put({Place::In::data, operation.reg()}, Size::word, extended(data & 0xffU, Size::byte));
      set_logic_conditions(data, Size::word);
      return take(4);
    case ext_long:
      data = extended(data & 0xffffU, Size::word);
      set_logic_conditions(data, Size::longword);
      return take(4);
    default: break;
  }
  if (operation.bits(7, 5) == 0b10001) return move_multiple(operation, false);
  if (operation.bits(7, 5) == 0b11001) return move_multiple(operation, true);
  if (operation.bits(8, 1) == 0 && operation.bits(6, 2) != 3 && operation.upper() < 6 && operation.upper() != 4)
    return execute_one_operand(operation);
  execute_address_work(operation);
}

/// CLR, NEG, NOT, TST.
void Processor::execute_one_operand(Operation operation) {
  constexpr unsigned clr = 1;
  constexpr unsigned neg = 2;
  constexpr unsigned tst = 5;
  const unsigned what = operation.upper();
  if (what == 0 || operation.mode() == 1 || (operation.mode() == 7 && operation.reg() > 1)) unknown(operation);
  const Size size = sizes_of_one[operation.bits(6, 2)];
  const Place at = place(operation.mode(), operation.reg(), size);
  const std::uint32_t old = get(at, size);
  const unsigned address = manual::address_clocks(operation.mode(), operation.reg(), size);
  if (what == tst) {
    set_logic_conditions(old, size);
    return take(4 + address);
  }
  std::uint32_t value = 0;
  if (what == neg) {
    value = subtract(0, old, size);
  } else {
    value = what == clr ? 0 : ~old;
    set_logic_conditions(value, size);
  }
  put(at, size, value);
  const bool is_long = size == Size::longword;
  take(operation.mode() == 0 ? (is_long ? 6 : 4) : (is_long ? 12 : 8) + address);
}

/// MOVEM.
void Processor::move_multiple(Operation operation, bool to_registers) {
  const Size size = operation.bits(6, 1) != 0 ? Size::longword : Size::word;
  const std::uint32_t mask = fetch(Size::word);
  const unsigned base =
      (to_registers ? manual::movem_load : manual::movem_store)[manual::mode_index(operation.mode(), operation.reg())];
  if (base == 0) unknown(operation);
  const bool downwards = operation.mode() == 4;
  const bool upwards = operation.mode() == 3;
  std::uint32_t at = downwards || upwards ? a[operation.reg()] : place(operation.mode(), operation.reg(), size).at;
  std::uint32_t* const all[] = {d.data(), a.data()};
  for (std::uint32_t bit = 0; bit < 16; ++bit) {
    if (((mask >> bit) & 1U) == 0) continue;
    const std::uint32_t number = downwards ? 15 - bit : bit;
    std::uint32_t& reg = all[number / 8][number % 8];
    if (downwards) at -= bytes_of(size);
    if (to_registers) {
      reg = extended(read(at, size), size);
    } else {
      write(at, size, reg & mask_of(size));
    }
    if (!downwards) at += bytes_of(size);
  }
  if (downwards || upwards) a[operation.reg()] = at;
  take(base + static_cast<unsigned>(std::popcount(mask)) * (size == Size::longword ? 8 : 4));
}

/// LEA, PEA, JSR, JMP.
void Processor::execute_address_work(Operation operation) {
  constexpr unsigned lea = 0b111;
  constexpr unsigned pea = 0x48'40 >> 6;
  constexpr unsigned jsr = 0x4e'80 >> 6;
  constexpr unsigned jmp = 0x4e'c0 >> 6;
  const std::size_t mode = manual::mode_index(operation.mode(), operation.reg());
  if (mode >= manual::modes || manual::lea[mode] == 0) unknown(operation);
  const unsigned what = operation.bits(6, 10);
  const bool is_lea = operation.bits(6, 3) == lea;
  if (!is_lea && what != pea && what != jsr && what != jmp) unknown(operation);
  const std::uint32_t address = place(operation.mode(), operation.reg(), Size::longword).at;
  if (is_lea) {
    a[operation.upper()] = address;
    return take(manual::lea[mode]);
  }
  if (what == pea) {
    push(address);
    return take(manual::pea[mode]);
  }
  if (what == jsr) push(pc);
  pc = address;
  take((what == jsr ? manual::jsr : manual::jmp)[mode]);
}

/// Shifts and rotations: of registers by a number of places from an operand, of memory by one place.
void Processor::shift(Operation operation) {
  const bool left = operation.bits(8, 1) != 0;
  if (operation.bits(6, 2) == 3) {
    const unsigned kind = operation.bits(9, 2);
    if (operation.bits(11, 1) != 0 || kind == rotation_through_x || operation.mode() < 2 ||
        (operation.mode() == 7 && operation.reg() > 1))
      unknown(operation);
    const Place at = place(operation.mode(), operation.reg(), Size::word);
    put(at, Size::word, shift_result(kind, left, get(at, Size::word), 1, Size::word));
    return take(8 + manual::address_clocks(operation.mode(), operation.reg(), Size::word));
  }
  const Size size = sizes_of_one[operation.bits(6, 2)];
  const unsigned kind = operation.bits(3, 2);
  const bool by_register = operation.bits(5, 1) != 0;
  const unsigned places = by_register ? d[operation.upper()] & 63U : operation.upper() == 0 ? 8 : operation.upper();
  const Place at{Place::In::data, operation.reg()};
  put(at, size, shift_result(kind, left, get(at, size), places, size));
  take((size == Size::longword ? 8 : 6) + 2 * places);
}

/// Shifts one place at a time; kind 0 shifts arithmetically, 1 logically, 3 rotates.
std::uint32_t Processor::shift_result(unsigned kind, bool left, std::uint32_t value, unsigned places, Size size) {
  const std::uint32_t top = bits_of(size) - 1;
  bool carry = false;
  bool overflow = false;
  for (unsigned place_number = 0; place_number < places; ++place_number) {
    const std::uint32_t high = (value >> top) & 1U;
    const std::uint32_t low = value & 1U;
    carry = (left ? high : low) != 0;
    const std::uint32_t through_x = conditions.extend ? 1U : 0U;
    const std::uint32_t comes_in = kind == 3                    ? (left ? high : low)
                                   : kind == rotation_through_x ? through_x
                                   : kind == 0 && !left         ? high
                                                                : 0;
    value = left ? (value << 1U | comes_in) & mask_of(size) : value >> 1U | comes_in << top;
    overflow = overflow || (kind == 0 && high != ((value >> top) & 1U));
    if (kind != 3) conditions.extend = carry;
  }
  set_logic_conditions(value, size);
  conditions.carry = kind == rotation_through_x ? conditions.extend : carry;
  conditions.overflow = overflow;
  return value;
}

}  // namespace csgsim::m68000
