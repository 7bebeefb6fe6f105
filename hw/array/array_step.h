// ALU functions and control words of the pixel processors.
// Used by hw/array.
#pragma once

#include <cstdint>
#include <string_view>

namespace csgsim::array {

/// Functions of a pixel's ALU. In one clock the ALU applies a function to one bit of its operands, or to several bits,
/// least significant first (see function_of_bit). In the meanings, E is the enable bit, K the carry bit, L the operand
/// latch, G the sign flag of a root, P is 1 if the pixel is part of the region, and M[w] is the memory bit written; x
/// and y are the operands, k is the constant and maj(a, b, c) the carry of a full adder. Columns: function, function of
/// the second and later bits, reads x, reads y, writes memory, reads or writes K, reads or writes G, may change enable
/// or memory of a disabled pixel, meaning.
// clang-format off
#define CSGSIM_ALU_FUNCTIONS(F)                                                                                                                                 \
  F(idle,               idle,               false, false, false, false, false, false, "nothing")                                                               \
  F(latch_x,            latch_x,            true,  false, false, false, false, false, "L := x")                                                                \
  F(enable_all,         enable_all,         false, false, false, false, false, true,  "E := P")                                                                \
  F(enable_invert,      enable_invert,      false, false, false, false, false, true,  "E := P and not E")                                                      \
  F(enable_load,        enable_load,        true,  false, false, false, false, true,  "E := x")                                                                \
  F(enable_and,         enable_and,         true,  false, false, false, false, false, "E := E and x")                                                          \
  F(enable_and_not,     enable_and_not,     true,  false, false, false, false, false, "E := E and not x")                                                      \
  F(enable_or,          enable_or,          true,  false, false, false, false, true,  "E := E or x")                                                           \
  F(enable_xor,         enable_xor,         true,  false, false, false, false, true,  "E := E xor x")                                                          \
  F(enable_equal,       enable_equal,       true,  true,  false, false, false, false, "E := E and not (x xor y)")                                              \
  F(compare_from_0,     compare,            true,  true,  false, true,  false, false, "K := maj(x, not y, 0): first bit of x > y")                             \
  F(compare_from_1,     compare,            true,  true,  false, true,  false, false, "K := maj(x, not y, 1): first bit of x >= y")                            \
  F(compare,            compare,            true,  true,  false, true,  false, false, "K := maj(x, not y, K)")                                                 \
  F(compare_with_0,     compare_with_0,     true,  false, false, true,  false, false, "K := maj(x, 1, K): x is longer than y")                                 \
  F(less_from_0,        compare,            true,  true,  false, true,  false, false, "K := maj(x, not y, 0), E := E and not K")                               \
  F(less_from_1,        compare,            true,  true,  false, true,  false, false, "K := maj(x, not y, 1), E := E and not K")                               \
  F(less,               compare,            true,  true,  false, true,  false, false, "K := maj(x, not y, K), E := E and not K")                               \
  F(sign_enable,        sign_enable,        true,  false, false, true,  false, false, "K := maj(not x, 0, K), E := E and K: x is the sign")                    \
  F(sign_enable_not,    sign_enable_not,    true,  false, false, true,  false, false, "K := maj(not x, 0, K), E := E and not K: x is the sign")                \
  F(sign_select,        sign_select,        true,  false, false, true,  false, false, "K := E and maj(not x, 0, K): x is the sign")                            \
  F(sign_select_not,    sign_select_not,    true,  false, false, true,  false, false, "K := E and not maj(not x, 0, K): x is the sign")                        \
  F(enable_fits,        enable_fits,        true,  false, false, true,  false, false, "E := E and not (K and x): a bit beyond the field")                      \
  F(store_x,            store_x,            true,  false, true,  false, false, false, "M[w] := x where E")                                                     \
  F(store_x_selected,   store_x_selected,   true,  false, true,  true,  false, false, "M[w] := x where E and K")                                               \
  F(store_not_x,        store_not_x,        true,  false, true,  false, false, false, "M[w] := not x where E")                                                 \
  F(store_constant,     store_constant,     false, false, true,  false, false, false, "M[w] := k where E")                                                     \
  F(store_xor_constant, store_xor_constant, true,  false, true,  false, false, false, "M[w] := x xor k where E")                                               \
  F(store_and,          store_and,          true,  true,  true,  false, false, false, "M[w] := x and y where E")                                               \
  F(store_or,           store_or,           true,  true,  true,  false, false, false, "M[w] := x or y where E")                                                \
  F(store_xor,          store_xor,          true,  true,  true,  false, false, false, "M[w] := x xor y where E")                                               \
  F(store_and_not,      store_and_not,      true,  true,  true,  false, false, false, "M[w] := x and not y where E")                                           \
  F(sum_from_0,         sum,                true,  true,  true,  true,  false, false, "M[w] := x xor y where E, K := x and y: first bit of x + y")             \
  F(sum,                sum,                true,  true,  true,  true,  false, false, "M[w] := x xor y xor K where E, K := maj(x, y, K)")                      \
  F(sum_with_0,         sum_with_0,         false, true,  true,  true,  false, false, "M[w] := y xor K where E, K := y and K: y is longer than x")             \
  F(sum_with_1_from_0,  sum_with_1_from_0,  false, true,  true,  true,  false, false, "M[w] := not y where E, K := y: first bit of y + 1, 1 being longer")     \
  F(sum_with_1,         sum_with_1,         false, true,  true,  true,  false, false, "M[w] := not (y xor K) where E, K := y or K: a further 1 is added to y") \
  F(difference_from_1,  difference,         true,  true,  true,  true,  false, false, "M[w] := x xor y where E, K := maj(x, not y, 1): first bit of x - y")    \
  F(difference,         difference,         true,  true,  true,  true,  false, false, "M[w] := x xor not y xor K where E, K := maj(x, not y, K)")              \
  F(root_first,         root_first,         false, false, true,  true,  true,  false, "G := not K; M[w] := K where E: the first bit of a root")                \
  F(root_bit,           root_bit,           true,  true,  true,  true,  true,  false, "z = x xor not G; M[w] := y xor z xor K where E, K := maj(y, z, K)")     \
  F(root_sign,          root_sign,          false, true,  true,  true,  true,  false, "G := y xor not G xor K; M[w] := not G where E: a bit of the root")      \
  F(store_enable,       store_enable,       false, false, true,  false, false, true,  "M[w] := E at every pixel")                                              \
  F(answer,             answer,             false, false, false, false, false, false, "the wired OR of E goes to the controller")
// clang-format on

enum class AluFunction : std::uint8_t {
#define CSGSIM_ALU_ENUMERATOR(name, ...) name,
  CSGSIM_ALU_FUNCTIONS(CSGSIM_ALU_ENUMERATOR)
#undef CSGSIM_ALU_ENUMERATOR
};

struct AluInfo {
  std::string_view name;
  AluFunction rest;  ///< function of the second and later bits of a step
  bool reads_x;
  bool reads_y;
  bool writes;
  bool has_carry;
  bool has_flag;
  bool acts_where_disabled;
  std::string_view meaning;
};

inline constexpr AluInfo alu_table[] = {
#define CSGSIM_ALU_ROW(name, rest, ...) AluInfo{#name, AluFunction::rest, __VA_ARGS__},
    CSGSIM_ALU_FUNCTIONS(CSGSIM_ALU_ROW)
#undef CSGSIM_ALU_ROW
};

constexpr const AluInfo& info(AluFunction function) { return alu_table[static_cast<std::size_t>(function)]; }

/// Source of the ALU's operand x. Operand y always comes from pixel memory.
enum class OperandSource : std::uint8_t {
  tree,    ///< this pixel's leaf of the multiplier trees
  latch,   ///< the operand latch
  memory,  ///< the memory bit at address `x`
};

/// The control word that all pixels execute in one clock. If operand x comes from the trees, which deliver several bits
/// of F per clock, the step selects a function for each of these bits: `function` processes `bits` bits, starting at
/// bit `first`; `beyond` processes the next `beyond_bits`, one after another; `sign` processes the bit after these. The
/// remaining bits are ignored. Only `function` accesses memory, at the given addresses.
struct ArrayStep {
  AluFunction function = AluFunction::idle;
  OperandSource source = OperandSource::tree;  ///< source of operand x
  std::uint16_t x = 0;                         ///< address of operand x, if it comes from memory
  std::uint16_t y = 0;                         ///< address of operand y
  std::uint16_t write = 0;                     ///< address written
  std::uint16_t bits = 1;                      ///< number of adjacent bits; the addresses are those of the first
  std::uint32_t constant = 0;                  ///< `bits` bits, the first lowest; in a sum, 1 where operand x has a bit
  std::uint16_t first = 0;                     ///< index of the first tree bit that is used
  std::uint16_t beyond_bits = 0;               ///< number of tree bits for `beyond`
  AluFunction beyond = AluFunction::idle;      ///< function of the bits after those of `function`
  AluFunction sign = AluFunction::idle;        ///< function of the bit after those of `beyond`; idle if there is none

  constexpr bool operator==(const ArrayStep&) const = default;
};

/// Number of bits that the ALU processes in a step, including those of `beyond` and `sign`.
constexpr unsigned processed_bits(const ArrayStep& step) {
  return step.bits + step.beyond_bits + (step.sign == AluFunction::idle ? 0U : 1U);
}

/// The function that a step applies to one of its processed_bits(). In a comparison or sum the first bit sets the
/// carry, which ripples through the others; in a comparison of fields the last bit decides.
constexpr AluFunction function_of_bit(const ArrayStep& step, unsigned bit) {
  using enum AluFunction;
  if (bit >= step.bits) return bit - step.bits < step.beyond_bits ? step.beyond : step.sign;
  const bool first = bit == 0;
  const AluFunction rest = info(step.function).rest;
  if (rest == sum && (step.constant >> bit & 1U) == 0) return sum_with_0;
  const bool decides = step.function == less || step.function == less_from_0 || step.function == less_from_1;
  if (decides && bit + 1U == step.bits) return first ? step.function : less;
  if (!decides || !first) return first ? step.function : rest;
  return step.function == less_from_0 ? compare_from_0 : step.function == less_from_1 ? compare_from_1 : compare;
}

/// Read ports of pixel memory that a step occupies.
constexpr unsigned memory_reads(const ArrayStep& step) {
  const AluInfo& row = info(step.function);
  return (row.reads_x && step.source == OperandSource::memory ? 1U : 0U) + (row.reads_y ? 1U : 0U);
}

}  // namespace csgsim::array
