#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::pixel_square {

/// What the tests and readings of a divider take, worked out from their numbers and the widths of a model's records.
class DivisionClocks {
 public:
  DivisionClocks(const isa::Program& program, const machines::Machine& machine);

  /// Between the model's last word and the first square.
  [[nodiscard]] std::uint64_t of_tree() const;
  /// Of the first level, before a group's first square, which counts it.
  [[nodiscard]] std::uint64_t of_group(const isa::DivisionCounts& first) const;
  /// Of the tests for a surface. `from_list`: of a square of a group whose list holds what it leaves.
  [[nodiscard]] std::uint64_t of_tests(const isa::DivisionStep& step, bool from_list) const;
  /// Of an instruction before its first word.
  [[nodiscard]] std::uint64_t of_instruction(const isa::Instruction& instruction) const;
  /// Whether a group of two levels that leaves so many entries is divided from its list.
  [[nodiscard]] bool is_listed(std::uint64_t entries) const;

 private:
  [[nodiscard]] std::uint64_t of_lists(std::uint64_t lists, std::uint64_t halfspaces, std::uint64_t read) const;

  const machines::Machine& machine_;
  std::uint64_t nodes_ = 0;
  // Clocks to read a record.
  std::uint64_t primitive_ = 0;
  std::uint64_t halfspace_ = 0;  ///< with its plane
};

/// Which divider divides each square: groups, or at one level squares, in turn.
std::vector<std::size_t> dividers_of(const isa::Program& program, const machines::Machine& machine);

/// Throws InputError where a frame's tests would take more clocks than are counted.
void check_countable(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::pixel_square
