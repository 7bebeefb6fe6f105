#pragma once

#include <array>
#include <cstdint>

#include "hw/bit_serial_memory/row_command.h"
#include "hw/machines/accounts.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// What the chips did, as far as it costs energy. Counted of all slots.
struct Work {
  std::array<std::uint64_t, row_op_count> commands{};  ///< of each op, once for all slots
  std::uint64_t activations = 0;                       ///< of rows, in all chips of a slot at once
  std::uint64_t further_rows = 0;                      ///< that were activated with them
  std::uint64_t logic = 0;                             ///< commands to the gates of a slot
  std::uint64_t leaves = 0;                            ///< commands that bring a slot a bit from the trees
  std::uint64_t transferred_bits = 0;
  std::uint64_t refreshes = 0;  ///< of all chips

  constexpr bool operator==(const Work&) const = default;
};

/// Adds a command to all slots.
void add(const RowCommand& command, std::uint64_t slots, std::uint64_t pixels, Work& work);

/// Where the controller spent its clocks: each is in one of these.
struct ControllerAccount {
  std::uint64_t issuing = 0;     ///< row commands of an instruction
  std::uint64_t answering = 0;   ///< those of a question
  std::uint64_t clearing = 0;    ///< those that make pixel memory 0
  std::uint64_t refreshing = 0;  ///< the banks were closed for a refresh, and refreshed
  std::uint64_t starved = 0;     ///< no whole command had come
  std::uint64_t jumping = 0;     ///< the command that the host goes on with after a jump was waited for

  constexpr bool operator==(const ControllerAccount&) const = default;
};

struct FrameAccount {
  ControllerAccount controller;
  std::uint64_t sending = 0;          ///< clocks in which a command was on the link
  std::uint64_t scan_out_clocks = 0;  ///< in which a finished picture goes to the host
  Work work;                          ///< scan-out included

  constexpr bool operator==(const FrameAccount&) const = default;
};

/// Energy of a frame by what takes it, in picojoules.
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

/// Of all chips. `clocks`: until the frame has been shown.
FrameEnergy energy_of(const Work& work, std::uint64_t clocks, const machines::Machine& machine);

/// As it is told of a frame of so many clocks, which was shown after `shown_clocks`.
machines::Account account(const FrameAccount& account, std::uint64_t clocks, std::uint64_t shown_clocks,
                          const machines::Machine& machine);

}  // namespace csgsim::bit_serial_memory
