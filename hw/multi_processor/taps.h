#pragma once

#include <cstdint>
#include <string>
#include <systemc>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/multi_processor/bus_word.h"
#include "hw/multi_processor/control_bus.h"
#include "hw/multi_processor/display_processor.h"
#include "hw/multi_processor/node.h"
#include "hw/wave/request.h"
#include "hw/wave/tap.h"

/// Wave taps of a multi-processor.
namespace csgsim::multi_processor {

/// Name `node_ROW_COLUMN` of the node with that number.
std::string node_name(std::uint32_t node, const isa::ArrayShape& nodes);

/// Taps `display.activity` and `.segment` of the picture.
std::vector<wave::Tap> display_taps(const DisplayProcessor& display);

/// Taps `bus.activity`; `.master` that holds the bus; `.words`, the number of words delivered; `.kind` of the last
/// word.
std::vector<wave::Tap> bus_taps(const ControlBus& bus, const sc_core::sc_signal<BusLines>& lines,
                                const isa::ArrayShape& nodes);

/// Taps `PART.activity` and `.subsegment` being rendered.
std::vector<wave::Tap> node_taps(const std::string& part, const Node& node);

/// Taps of a pixel while its node renders its subsegment: the instruction that the node executes there, `.enable`, and
/// one tap per field; and `.image`, the colour that the node holds for it. Since a node executes a whole subsegment at
/// once, the pixel's states are recomputed clock by clock with the same renderer. Throws InputError for a pixel that no
/// subsegment holds.
std::vector<wave::Tap> pixel_taps(wave::Pixel pixel, const Node& node, const isa::Program& program,
                                  const machines::Machine& machine);

}  // namespace csgsim::multi_processor
