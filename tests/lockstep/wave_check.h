#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/machines/timeline.h"
#include "hw/wave/request.h"
#include "sim/engine/engine.h"
#include "tests/waves/vcd.h"

namespace csgsim::test {

/// Compares the wave of a pixel with the reference's states at the instruction boundaries, which the timeline maps to
/// clocks.
class WaveCheck {
 public:
  /// Chooses a random pixel of a segment that has instructions, and a window of clocks around them. One must exist.
  WaveCheck(const isa::Program& program, const machines::Machine& machine, engine::Engine& judge);

  /// The Program with fields that cover all of the memory.
  [[nodiscard]] const isa::Program& program() const { return program_; }
  /// The request for a wave that goes to `write`.
  [[nodiscard]] wave::Request request(std::function<void(std::string_view)> write) const {
    return {.windows = {window_}, .pixels = {pixel_}, .tree_levels = {}, .write = std::move(write)};
  }

  /// Throws Difference unless, in each clock of the window, the pixel has the reference's enable and memory, or unknown
  /// values while the memory belongs to another pixel, and is at the timeline's instruction. While an instruction
  /// executes a bit may be old or new, and bits of a root's field are arbitrary. `top` is the outermost scope.
  void check(const Vcd& wave, const std::string& top, std::uint64_t period_ps) const;

 private:
  /// Values by field; enable is a separate field.
  using State = std::map<std::string, std::uint64_t>;

  class Watch;

  using Shown = std::function<std::optional<std::uint64_t>(const std::string& name)>;

  void check_clock(std::uint64_t clock, const Shown& shown) const;

  isa::Program program_;
  std::uint32_t segment_ = 0;
  wave::Pixel pixel_;
  wave::Window window_;
  std::uint64_t first_ = 0;                 ///< number of the segment's first instruction
  std::vector<std::uint32_t> carried_out_;  ///< indices of its executed instructions
  std::vector<machines::ClockSpan> spans_;  ///< clocks of these at the pixel
  std::vector<State> states_;               ///< state before the first and after each of these
};

}  // namespace csgsim::test
