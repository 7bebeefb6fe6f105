// Windows of clocks to record.
// Used by sim/app.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/wave/request.h"
#include "sim/waves/foreknowledge.h"

namespace csgsim::waves {

/// The part of a run to record, as requested by the user.
struct WindowRequest {
  enum class Kind : std::uint8_t { clocks, instructions, primitive, purpose, effect };

  Kind kind = Kind::clocks;
  std::uint64_t begin = 0;  ///< clock, instruction number in the whole Program, or index of the primitive
  std::uint64_t end = 0;    ///< exclusive end
  std::string name;         ///< name of the primitive as typed, of the purpose or of the effect
};

/// Parses `FIRST:END` clocks; `iFIRST:iEND` or `iN` instructions; `primitive:NAME`, whose index the caller resolves;
/// `purpose:NAME`, `effect:NAME`. Throws InputError for any other text.
WindowRequest parse_window(std::string_view text);

/// The clocks from issue to execution of the requested instructions at any of the pixels, and one more clock, which
/// shows their result. For a primitive, purpose or effect, only segments that contain the pixels count. Stretches more
/// than a few clocks apart become separate windows. Throws InputError for an unknown name, with the nearest one, and if
/// nothing is executed.
std::vector<wave::Window> find_windows(const WindowRequest& request, const isa::Program& program,
                                       const machines::Machine& machine, const Foreknowledge& known,
                                       std::span<const wave::Pixel> pixels);

/// Adds this number of clocks before and after each window and joins windows that touch. The frame may end before a
/// window does.
std::vector<wave::Window> pad_windows(std::span<const wave::Window> windows, std::uint64_t clocks);

/// The write that set the final value of a field in a pixel.
struct LastWrite {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;            ///< index of the instruction in the segment
  std::uint64_t number = 0;           ///< number in the whole Program
  machines::ClockSpan at_pixel;       ///< clocks of its execution at the pixel
  std::vector<wave::Window> windows;  ///< the write with some clocks before and one after
};

/// `target`: owner or colour, depth, or the name of a field. Throws InputError if no instruction changes it.
LastWrite last_write(std::string_view target, const isa::Program& program, const machines::Machine& machine,
                     const Foreknowledge& known, wave::Pixel pixel);

}  // namespace csgsim::waves
