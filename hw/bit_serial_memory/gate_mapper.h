// Maps gates to sequences of a command set.
// Used by the reader of command sets and the analytic timing.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>

#include "hw/bit_serial_memory/command_set.h"

namespace csgsim::bit_serial_memory {

/// Number of operands of a gate.
constexpr unsigned operand_count(Gate gate) {
  switch (gate) {
    case Gate::zero:
    case Gate::one: return 0;
    case Gate::move:
    case Gate::invert: return 1;
    case Gate::conjunction:
    case Gate::disjunction:
    case Gate::unequal:
    case Gate::equal: return 2;
    case Gate::choose: return 3;
  }
  return 0;
}

/// Places that hold the same latch: for x, y, z and the target the first place with that latch.
using Aliases = std::array<Place, 4>;

/// The aliases of a gate whose latches all differ.
inline constexpr Aliases no_aliases{0, 1, 2, target_place};

/// Whether the sequence leaves the gate's value in its target and does not change its other operands.
bool computes(const GateSequence& sequence, Gate gate, const Aliases& aliases, const CommandSet& set);

/// Finds sequences for gates. A sequence of the file is used unless the target is also an operand and the sequence
/// overwrites this operand before its last use. Otherwise the fastest sequence is searched; among equally fast ones,
/// that with the least energy.
class GateMapper {
 public:
  explicit GateMapper(const CommandSet& set) : set_(set) {}

  /// Throws InputError if no sequence is found.
  const GateSequence& sequence(Gate gate, const Aliases& aliases);

  /// Replaces each gate command by its sequence. The commands refer to the set.
  RowCommands expand(const RowCommands& commands);

  [[nodiscard]] const CommandSet& set() const { return set_; }

 private:
  [[nodiscard]] std::optional<GateSequence> search(Gate gate, const Aliases& aliases) const;

  const CommandSet& set_;
  std::map<std::tuple<Gate, Aliases>, GateSequence> known_;
};

}  // namespace csgsim::bit_serial_memory
