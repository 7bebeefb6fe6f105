// Writes VCD files.
// Used by sim/waves and tests.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "hw/wave/pieces.h"
#include "hw/wave/tap.h"
#include "hw/wave/writer.h"

namespace csgsim::wave {

/// Writes the taps in each clock as a value change dump (IEEE 1364-2005, 18.2), with the variables `clock` and
/// `clock_number`. Texts are variables of the type `string`, which GTKWave, Surfer and vcd2fst support; blanks in them
/// are written as `\x20`. A missing value is `z` for a number and `-` for a text. Clock n begins at time (n + 1) *
/// period, where `clock` rises.
class VcdWriter final : public Writer {
 public:
  /// `top`: name of the outermost scope. `write` receives the text piece by piece.
  VcdWriter(std::string_view top, std::vector<Tap> taps, std::uint64_t period_ps,
            std::function<void(std::string_view)> write);

  /// Clocks not sampled are shown as unknown (`$dumpoff`).
  void sample(std::uint64_t clock) override;
  void finish() override;

 private:
  void write_header(std::string_view top);
  void write_value(std::size_t tap);
  void write_unknown(std::size_t tap);
  void write_time(std::uint64_t time);

  /// The last value of a tap written to the file.
  struct Shown {
    enum class State : std::uint8_t { unknown, value };

    State state = State::unknown;
    Number number;
    std::string text;
  };

  std::vector<Tap> taps_;
  std::vector<std::string> codes_;  ///< VCD code of each tap, with line end
  std::vector<Shown> shown_;
  std::uint64_t period_;  ///< picoseconds
  Pieces out_;
  std::uint64_t next_ = 0;  ///< clock number after the last sample
  bool begun_ = false;
};

}  // namespace csgsim::wave
