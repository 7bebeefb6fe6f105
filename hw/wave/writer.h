// Interface of wave file writers.
// Used by hw/systemc and sim/waves.
#pragma once

#include <cstdint>

namespace csgsim::wave {

/// Writes the values of taps to a file, clock by clock.
class Writer {
 public:
  virtual ~Writer() = default;

  /// Writes the current values of the taps for `clock`. Clocks must be in ascending order; omitted clocks are unknown.
  virtual void sample(std::uint64_t clock) = 0;

  /// Ends the file after the last clock.
  virtual void finish() = 0;

 protected:
  Writer() = default;
  Writer(const Writer&) = default;
  Writer(Writer&&) = default;
  Writer& operator=(const Writer&) = default;
  Writer& operator=(Writer&&) = default;
};

}  // namespace csgsim::wave
