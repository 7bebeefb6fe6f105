#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hw/array/pixel_replay.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_planes/timing.h"
#include "hw/systemc/foretold.h"
#include "hw/wave/request.h"

/// How a machine of which some pixels alone are built begins in the middle of a frame.
namespace csgsim::pixel_planes {

/// The beginning of an instruction.
struct Start {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;
  std::uint64_t ordinal = 0;  ///< of the instruction in the frame
  Moment moment;
  std::size_t questions = 0;  ///< asked before
  std::uint64_t end = 0;      ///< ordinal of the first instruction of which no word is sent before the window is over
};

/// The last instruction from whose beginning on a machine has as many clocks before the window as its pipelines are
/// long, and which needs no squares of the one before; none if there is no such instruction.
std::optional<Start> start_before(const isa::Program& program, const machines::Machine& machine,
                                  const systemc::Foretold& foretold, wave::Window window);

/// The pixels after all that the frame carries out before that instruction. `answers`: as in Foretold.
array::PixelReplay replay_until(const isa::Program& program, const std::vector<bool>& answers, const Start& start,
                                const array::PixelReplay& fresh);

/// The place in the array of a pixel of the picture. Throws InputError if no segment holds it.
array::Place place_of(wave::Pixel pixel, const isa::Program& program);

/// Which of the foretold pixels that is. Throws std::out_of_range if it is none.
std::uint32_t foretold_place(const systemc::Foretold& foretold, array::Place place);

/// Where the colours lie that the scan-out shows.
isa::Field shown_field(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::pixel_planes
