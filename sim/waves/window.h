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

/// What of a run a wave shows, as people ask for it.
struct WindowRequest {
  enum class Kind : std::uint8_t { clocks, instructions, primitive, purpose, effect };

  Kind kind = Kind::clocks;
  std::uint64_t begin = 0;  ///< clock; number of an instruction among all of the Program; index of the primitive
  std::uint64_t end = 0;    ///< the first that does not belong to it
  std::string name;         ///< of the primitive, as people wrote it, of the purpose or of the effect
};

/// `FIRST:END` clocks; `iFIRST:iEND` or `iN` instructions; `primitive:NAME`, of which the index is left to who knows
/// the names; `purpose:NAME`, `effect:NAME`. Throws InputError for anything else.
WindowRequest parse_window(std::string_view text);

/// The clocks in which what is asked for is on its way or carried out at one of the pixels, and one more, which shows
/// what it has left. Instructions of a
/// primitive, purpose or effect are those of the segments that hold the pixels; stretches of them that are more than a
/// few clocks apart are windows of their own. Throws InputError for a name that the Program has not, the nearest one
/// named, and where nothing is carried out.
std::vector<wave::Window> windows_of(const WindowRequest& request, const isa::Program& program,
                                     const machines::Machine& machine, const Foreknowledge& known,
                                     std::span<const wave::Pixel> pixels);

/// With so many clocks before and behind each; what touches then is one. The frame may end before a window does.
std::vector<wave::Window> padded(std::span<const wave::Window> windows, std::uint64_t clocks);

/// The write that left the value of a field in a pixel.
struct LastWrite {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;            ///< of the instruction in the segment
  std::uint64_t number = 0;           ///< among all of the Program
  machines::ClockSpan at_pixel;       ///< in which it is carried out there
  std::vector<wave::Window> windows;  ///< it, some clocks before it, and one after it
};

/// `what`: owner or colour, depth, or the name of a field. Throws InputError where no instruction writes it.
LastWrite last_write(std::string_view what, const isa::Program& program, const machines::Machine& machine,
                     const Foreknowledge& known, wave::Pixel pixel);

}  // namespace csgsim::waves
