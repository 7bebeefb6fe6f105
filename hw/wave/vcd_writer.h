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

/// Writes what taps show in each clock as a value change dump (IEEE 1364-2005, 18.2), with a `clock` of its own and its
/// number, `clock_number`. Texts are variables of the type `string`, which GTKWave, Surfer and vcd2fst know; blanks in
/// them are written `\x20`. Nothing is `z` in a number and `-` in a text. Clock n is at the time (n + 1) periods, where
/// the clock rises.
class VcdWriter final : public Writer {
 public:
  /// `top`: the scope around all. `write` takes the text, piece by piece.
  VcdWriter(std::string_view top, std::vector<Tap> taps, std::uint64_t period_ps,
            std::function<void(std::string_view)> write);

  /// Clocks that are left out are unknown (`$dumpoff`).
  void sample(std::uint64_t clock) override;
  void finish() override;

 private:
  void write_header(std::string_view top);
  void show(std::size_t tap);
  void show_unknown(std::size_t tap);
  void put_time(std::uint64_t time);

  /// What the file shows of a tap.
  struct Shown {
    enum class State : std::uint8_t { unknown, value };

    State state = State::unknown;
    Number number;
    std::string text;
  };

  std::vector<Tap> taps_;
  std::vector<std::string> codes_;  ///< a tap's, in the file, with the line's end
  std::vector<Shown> shown_;
  std::uint64_t period_;  ///< picoseconds
  Pieces out_;
  std::uint64_t next_ = 0;  ///< clock that would follow the last one
  bool begun_ = false;
};

}  // namespace csgsim::wave
