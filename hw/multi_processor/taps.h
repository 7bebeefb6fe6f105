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

/// What waves show of a multi-processor.
namespace csgsim::multi_processor {

/// `node_ROW_COLUMN`, of the node of that number.
std::string node_name(std::uint32_t node, const isa::ArrayShape& nodes);

/// `display.activity`, `.segment` of the picture.
std::vector<wave::Tap> display_taps(const DisplayProcessor& display);

/// `bus.activity`, `.master` who has it; of the word that all got last `.words`, how many there were, and `.kind`.
std::vector<wave::Tap> bus_taps(const ControlBus& bus, const sc_core::sc_signal<BusLines>& lines,
                                const isa::ArrayShape& nodes);

/// `PART.activity`, `.subsegment` that it renders.
std::vector<wave::Tap> node_taps(const std::string& part, const Node& node);

/// A pixel while its node renders its subsegment: the instruction that the node carries out there, `.enable`, and a tap
/// a field; and `.image`, the colour that the node holds for it. The node works out a whole subsegment at once: what
/// becomes of the pixel is worked out again, by the same renderer, clock by clock. Throws InputError for a pixel that
/// no subsegment holds.
std::vector<wave::Tap> pixel_taps(wave::Pixel pixel, const Node& node, const isa::Program& program,
                                  const machines::Machine& machine);

}  // namespace csgsim::multi_processor
