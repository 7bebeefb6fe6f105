#pragma once

#include <cstdint>

namespace csgsim::wave {

/// Takes what taps show, clock by clock, and writes a file of it.
class Writer {
 public:
  virtual ~Writer() = default;

  /// What the taps show in that clock. Clocks come in order; of those that are left out nothing is known.
  virtual void sample(std::uint64_t clock) = 0;

  /// After the last clock.
  virtual void finish() = 0;

 protected:
  Writer() = default;
  Writer(const Writer&) = default;
  Writer(Writer&&) = default;
  Writer& operator=(const Writer&) = default;
  Writer& operator=(Writer&&) = default;
};

}  // namespace csgsim::wave
