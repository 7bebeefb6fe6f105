#pragma once

#include <span>
#include <vector>

#include "hw/bit_serial_memory/bank.h"
#include "hw/bit_serial_memory/controller.h"
#include "hw/bit_serial_memory/host_link.h"
#include "hw/bit_serial_memory/memory_view.h"
#include "hw/isa/program.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"

namespace csgsim::bit_serial_memory {

/// Units that the taps read.
struct TappedParts {
  const Controller& controller;
  const HostLink& host;
  std::span<const Bank* const> banks;
  const MemoryView& pixels;
  Slots slots;
  std::uint32_t picture_width;
};

/// Wave taps of the machine: host, controller, banks, and probed pixels. Throws InputError for tree levels, which are
/// not modelled.
std::vector<wave::Tap> machine_taps(const TappedParts& parts, const isa::Program& program,
                                    const wave::Request& request);

}  // namespace csgsim::bit_serial_memory
