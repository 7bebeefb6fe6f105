#pragma once

#include <array>
#include <cstdint>

#include "hw/bit_serial_memory/row_command.h"
#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// Operations of the chips that cost energy, summed over all slots.
struct Work {
  std::array<std::uint64_t, row_op_count> commands{};  ///< number of each op, counted once for all slots
  std::uint64_t activations = 0;                       ///< row activations, counted per slot
  std::uint64_t further_rows = 0;                      ///< rows activated in addition to the first row of an activation
  std::uint64_t logic = 0;                             ///< logic commands, counted per slot
  std::uint64_t leaves = 0;                            ///< commands that deliver a bit from the trees, counted per slot
  std::uint64_t own_logic = 0;                         ///< part of `logic`: commands of a designer's set
  std::uint64_t own_logic_fj = 0;                      ///< energy of these in femtojoules, for one column of each slot
  std::uint64_t transferred_bits = 0;                  ///< bits transferred between rows and host
  std::uint64_t refreshes = 0;                         ///< refreshes of all chips

  constexpr bool operator==(const Work&) const = default;
};

/// Adds a command that all slots execute.
void add(const RowCommand& command, std::uint64_t slots, std::uint64_t pixels, Work& work);

/// Clocks of the controller by activity; each clock counts for exactly one.
struct ControllerAccount {
  std::uint64_t issuing = 0;     ///< row commands of an instruction
  std::uint64_t answering = 0;   ///< row commands of a global-OR test
  std::uint64_t clearing = 0;    ///< row commands that clear pixel memory
  std::uint64_t refreshing = 0;  ///< closing all banks for a refresh, and refreshing
  std::uint64_t starved = 0;     ///< waiting for a complete command
  std::uint64_t jumping = 0;     ///< waiting for the command at which the host resumes after a skip

  constexpr bool operator==(const ControllerAccount&) const = default;
};

struct FrameAccount {
  ControllerAccount controller;
  std::uint64_t sending = 0;          ///< clocks in which a command was on the link
  std::uint64_t scan_out_clocks = 0;  ///< clocks to send a finished picture to the host
  Work work;                          ///< includes scan-out

  constexpr bool operator==(const FrameAccount&) const = default;
};

/// Energy of a frame by consumer, in picojoules.
struct FrameEnergy {
  std::uint64_t activation = 0;
  std::uint64_t logic = 0;
  std::uint64_t leaf = 0;
  std::uint64_t transfer = 0;
  std::uint64_t refresh = 0;
  std::uint64_t background = 0;

  [[nodiscard]] constexpr std::uint64_t sum() const {
    return activation + logic + leaf + transfer + refresh + background;
  }
};

/// Energy of all chips. `clocks`: clocks until the frame is shown.
FrameEnergy energy_of(const Work& work, std::uint64_t clocks, const machines::Machine& machine);

/// Converts the counts to the account of a frame of `clocks` clocks, shown after `shown_clocks`.
machines::Account account(const FrameAccount& account, std::uint64_t clocks, std::uint64_t shown_clocks,
                          const machines::Machine& machine);

}  // namespace csgsim::bit_serial_memory
