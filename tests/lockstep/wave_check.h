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

/// A pixel whose wave is held against the reference's states at the instruction boundaries, which the timeline puts
/// into clocks.
class WaveCheck {
 public:
  /// Any pixel of any segment that has instructions, and any window of clocks about them. There has to be one.
  WaveCheck(const isa::Program& program, const machines::Machine& machine, engine::Engine& judge);

  /// With fields that show all of the memory.
  [[nodiscard]] const isa::Program& program() const { return program_; }
  /// `write` takes the wave.
  [[nodiscard]] wave::Request request(std::function<void(std::string_view)> write) const {
    return {.windows = {window_}, .pixels = {pixel_}, .tree_levels = {}, .write = std::move(write)};
  }

  /// Throws Difference unless the pixel has the reference's enable and memory in each clock of the window, or nothing
  /// where it is no longer or not yet the pixel's, and is at the timeline's instruction. While one is carried out a bit
  /// may be as it was before or as it is after it, one of a root's field as it likes. `top`: the scope around all.
  void check(const Vcd& wave, const std::string& top, std::uint64_t period_ps) const;

 private:
  /// Enable as a field of its own.
  using State = std::map<std::string, std::uint64_t>;

  class Watch;

  using Shown = std::function<std::optional<std::uint64_t>(const std::string& name)>;

  void check_clock(std::uint64_t clock, const Shown& shown) const;

  isa::Program program_;
  std::uint32_t segment_ = 0;
  wave::Pixel pixel_;
  wave::Window window_;
  std::uint64_t first_ = 0;                 ///< number of the segment's first instruction
  std::vector<std::uint32_t> carried_out_;  ///< of its instructions
  std::vector<machines::ClockSpan> spans_;  ///< of these, at the pixel
  std::vector<State> states_;               ///< before the first and after each of these
};

}  // namespace csgsim::test
