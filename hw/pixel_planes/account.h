#pragma once

#include <cstdint>

#include "hw/machines/accounts.h"
#include "hw/machines/link_timing.h"
#include "hw/machines/machine.h"

namespace csgsim::pixel_planes {

/// Where the controller spent its clocks: each is in one of these.
struct ControllerAccount {
  std::uint64_t issuing = 0;        ///< a bit step of an instruction was on the wires
  std::uint64_t clearing = 0;       ///< the pixels were being cleared for a segment
  std::uint64_t starved = 0;        ///< no whole command had come
  std::uint64_t answering = 0;      ///< an answer was waited for
  std::uint64_t jumping = 0;        ///< the command that the host goes on with after a jump was waited for
  std::uint64_t draining = 0;       ///< the last step was on its way to the pixels
  std::uint64_t refreshing = 0;     ///< a refresh word was on the wires, whatever else was waited for
  std::uint64_t holding = 0;        ///< the picture before was still to be latched, so that it could not be copied over
  std::uint64_t copying = 0;        ///< the picture was copied to where it is shown
  std::uint64_t refresh_waits = 0;  ///< no activity: clocks in which the scan-out waited for a refresh word

  constexpr bool operator==(const ControllerAccount&) const = default;
};

/// As it is told of a frame in which so many instructions were carried out. What has to do with a second buffer is told
/// of machines that have one.
machines::Account account(const ControllerAccount& controller, const machines::LinkAccount& link,
                          const machines::Machine& machine, std::uint64_t instructions);

}  // namespace csgsim::pixel_planes
