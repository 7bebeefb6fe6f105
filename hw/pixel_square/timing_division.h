#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::pixel_square {

/// Clocks of a divider's tests and reads, computed from their counts and from the widths of the model's records.
class DivisionClocks {
 public:
  DivisionClocks(const isa::Program& program, const machines::Machine& machine);

  /// Clocks between the model's last word and the first square.
  [[nodiscard]] std::uint64_t tree_clocks() const;
  /// Clocks of the first level, spent before a group's first square; `group_counts`: counts of that square, which
  /// include those of the group.
  [[nodiscard]] std::uint64_t group_clocks(const isa::DivisionCounts& group_counts) const;
  /// Clocks of the tests for a surface. `from_list`: whether the square is divided from the list of its group.
  [[nodiscard]] std::uint64_t test_clocks(const isa::DivisionStep& step, bool from_list) const;
  /// Clocks of an instruction before its first word.
  [[nodiscard]] std::uint64_t instruction_clocks(const isa::Instruction& instruction) const;
  /// Whether the squares of a group with `survivor_count` survivors are divided from the list of the group.
  [[nodiscard]] bool is_listed(std::uint64_t survivor_count) const;

 private:
  [[nodiscard]] std::uint64_t list_clocks(std::uint64_t lists, std::uint64_t halfspaces, std::uint64_t read) const;

  const machines::Machine& machine_;
  std::uint64_t nodes_ = 0;
  // Clocks to read a record.
  std::uint64_t primitive_ = 0;
  std::uint64_t halfspace_ = 0;  ///< including its plane
};

/// Index of the divider of each square. Groups, or single squares if there is one level, are assigned round-robin.
std::vector<std::size_t> divider_of_each_square(const isa::Program& program, const machines::Machine& machine);

/// Throws InputError if the clocks of a frame's tests would exceed the range of the clock counter.
void check_countable(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::pixel_square
