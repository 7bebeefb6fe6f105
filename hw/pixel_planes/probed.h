// Starts a machine with few pixels in the middle of a frame.
// Used by the Pixel-planes machine for waves.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hw/array/pixel_replay.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/pixel_planes/timing.h"
#include "hw/systemc/earlier_run.h"
#include "hw/wave/request.h"

// Starts a machine, of which only some pixels are simulated, in the middle of a frame.
namespace csgsim::pixel_planes {

/// The state of a frame at the beginning of an instruction.
struct Start {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;
  std::uint64_t ordinal = 0;  ///< number of the instruction in the frame
  Moment moment;
  std::size_t tests_before = 0;  ///< number of global-OR tests before it
  std::uint64_t end = 0;  ///< ordinal of the first instruction whose words are all sent after the end of the window
};

/// Finds the last instruction that begins at least a pipeline length before the window and does not directly follow an
/// instruction `squares`; empty if there is none.
std::optional<Start> find_start_before(const isa::Program& program, const machines::Machine& machine,
                                       const systemc::EarlierRun& earlier, wave::Window window);

/// Replays all instructions before `start` on the pixels `initial`. `answers`: as in EarlierRun.
array::PixelReplay replay_until(const isa::Program& program, const std::vector<bool>& answers, const Start& start,
                                const array::PixelReplay& initial);

/// Position in the array of a pixel of the picture. Throws InputError if no segment contains it.
array::Place position_in_array(wave::Pixel pixel, const isa::Program& program);

/// Index of the pixel at that position among the pixels of the earlier run. Throws std::out_of_range if the earlier run
/// did not record this pixel.
std::uint32_t simulated_pixel_index(const systemc::EarlierRun& earlier, array::Place position);

/// The field of pixel memory that the scan-out displays.
isa::Field displayed_field(const isa::Program& program, const machines::Machine& machine);

}  // namespace csgsim::pixel_planes
