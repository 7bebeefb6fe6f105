// Kinds and counts of processor operations.
// Used by hw/processors, hw/host and sim/software.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>

namespace csgsim::processors {

/// Kinds of operations of a processor. A word has 16 bits, a long 32: numbers of primitives, kinds and codes are words;
/// pointers, depths and bit strings are longs. A processor's description gives the clocks of each kind.
enum class Operation : std::uint8_t {
  load,
  load_long,
  store,
  store_long,
  move,
  add,
  add_long,
  compare,
  compare_long,
  logic,
  logic_long,
  shift,
  shift_long,
  shifted_bit,
  multiply,
  divide,
  multiply_long,
  divide_long,
  branch,
  branch_taken,
  call,
  come_back,
};

struct OperationRow {
  const char* name;  ///< name in descriptions and tables
  const char* meaning;
};

/// Rows in the order of the enumerators.
inline constexpr std::array operation_rows{
    OperationRow{"load", "a word is read from memory, by a register and a displacement"},
    OperationRow{"load_long", "a long is read from memory, by a register and a displacement"},
    OperationRow{"store", "a word is written to memory, by a register and a displacement"},
    OperationRow{"store_long", "a long is written to memory, by a register and a displacement"},
    OperationRow{"move", "a register or a small constant is copied to a register"},
    OperationRow{"add", "a word is added to a register or subtracted from it"},
    OperationRow{"add_long", "a long is added to a register or subtracted from it; an address is computed"},
    OperationRow{"compare", "a register is compared with a word or tested"},
    OperationRow{"compare_long", "a register is compared with a long or tested"},
    OperationRow{"logic", "AND, OR, XOR, NOT or the test of a bit, of a word"},
    OperationRow{"logic_long", "AND, OR, XOR, NOT or the test of a bit, of a long"},
    OperationRow{"shift", "a word is shifted, without the clocks per place"},
    OperationRow{"shift_long", "a long is shifted, without the clocks per place"},
    OperationRow{"shifted_bit", "one place of such a shift"},
    OperationRow{"multiply", "two words are multiplied to a long"},
    OperationRow{"divide", "a long is divided by a word"},
    OperationRow{"multiply_long", "two longs are multiplied to a number of 64 bits"},
    OperationRow{"divide_long", "a number of 64 bits is divided by a long"},
    OperationRow{"branch", "a conditional branch that is not taken"},
    OperationRow{"branch_taken", "a branch that is taken"},
    OperationRow{"call", "a subroutine is called"},
    OperationRow{"come_back", "a subroutine returns"},
};

inline constexpr std::size_t operation_kinds = operation_rows.size();
static_assert(operation_kinds == static_cast<std::size_t>(Operation::come_back) + 1);

/// Counts of operations by kind.
struct Operations {
  std::array<std::uint64_t, operation_kinds> counts{};

  [[nodiscard]] std::uint64_t of(Operation kind) const { return counts[static_cast<std::size_t>(kind)]; }
  constexpr Operations& operator+=(const Operations& more) {
    for (std::size_t i = 0; i < operation_kinds; ++i) counts[i] += more.counts[i];
    return *this;
  }
  /// Subtracts counts, each of which must be at most this object's.
  constexpr Operations& operator-=(const Operations& part) {
    for (std::size_t i = 0; i < operation_kinds; ++i) counts[i] -= part.counts[i];
    return *this;
  }
  bool operator==(const Operations&) const = default;
};

/// The operations repeated `times` times.
constexpr Operations operator*(std::uint64_t times, Operations operations) {
  for (std::uint64_t& count : operations.counts) count *= times;
  return operations;
}

/// Operations with the given counts; kinds that are not listed have the count 0.
constexpr Operations operation_counts(std::initializer_list<std::pair<Operation, std::uint64_t>> counts) {
  Operations operations;
  for (const auto& [kind, count] : counts) operations.counts[static_cast<std::size_t>(kind)] += count;
  return operations;
}

}  // namespace csgsim::processors
