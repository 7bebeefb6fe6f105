// Clock account of the Pixel-planes controller.
// Used by the controller and the timing model.
#pragma once

#include <cstdint>

#include "hw/machines/accounts.h"
#include "hw/machines/link_timing.h"
#include "hw/machines/machine.h"

namespace csgsim::pixel_planes {

/// Clocks of the controller by activity. Each clock counts for exactly one activity. `refresh_waits` is not an
/// activity: it counts some of these clocks a second time.
struct ControllerAccount {
  std::uint64_t issuing = 0;     ///< a step of an instruction was on the wires
  std::uint64_t clearing = 0;    ///< the pixels were being cleared for a segment
  std::uint64_t starved = 0;     ///< no complete command had arrived
  std::uint64_t answering = 0;   ///< waited for the global OR
  std::uint64_t jumping = 0;     ///< waited for the first command after a skip
  std::uint64_t draining = 0;    ///< the last step was on its way to the pixels
  std::uint64_t refreshing = 0;  ///< a refresh word was on the wires while the controller waited
  /// Waited until the scan-out had latched the previous picture, before copying over it.
  std::uint64_t holding = 0;
  std::uint64_t copying = 0;        ///< copied the picture into the displayed buffer
  std::uint64_t refresh_waits = 0;  ///< not an activity: clocks in which the scan-out waited for a refresh word

  constexpr bool operator==(const ControllerAccount&) const = default;
};

/// The account of a frame that executed `instruction_count` instructions. Activities of the second buffer are listed
/// only for machines with two buffers.
machines::Account account(const ControllerAccount& controller, const machines::LinkAccount& link,
                          const machines::Machine& machine, std::uint64_t instruction_count);

}  // namespace csgsim::pixel_planes
