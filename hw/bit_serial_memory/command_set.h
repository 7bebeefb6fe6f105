// A designer's own set of gate commands for memories with latches, as a data file.
// Used by sim/app and sim/rows.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hw/bit_serial_memory/row_command.h"

namespace csgsim::bit_serial_memory {

/// An operand of a command in a sequence: the operands x, y and z of the gate that the sequence replaces, its target,
/// and then the temporaries.
using Place = std::uint8_t;
inline constexpr Place target_place = 3;
inline constexpr Place first_temporary = 4;
inline constexpr std::size_t max_places = first_temporary + max_temporaries;

/// A command of a sequence: the latch at `target` becomes a function of the latches at `inputs`.
struct GateStep {
  std::size_t command = 0;  ///< index in the set
  Place target = target_place;
  std::array<Place, 3> inputs{};
};

using GateSequence = std::vector<GateStep>;

/// A set of commands at the sense amplifiers that replaces the gates of csgsim's latch design.
struct CommandSet {
  std::string name;
  std::string description;
  std::string place;  ///< file:line:column of the first command, for messages
  std::uint32_t temporaries = 0;
  std::vector<GateCommand> commands;
  std::array<std::optional<GateSequence>, gate_names.size()> given;  ///< sequences in the file, by gate
};

/// Reads a command set in TOML; docs/row-traces.md describes the keys. Throws InputError with file:line:column, also
/// for a given sequence that does not compute its gate.
CommandSet read_command_set(std::string_view text, std::string_view file);

}  // namespace csgsim::bit_serial_memory
