// Analytic timing of the scan-out.
// Used by timing.cpp.
#pragma once

#include <cstdint>

#include "hw/machines/machine.h"

namespace csgsim::pixel_planes {

/// Computes the timing of the scan-out of a picture without stepping. Each row but the first is latched while the
/// previous row is shown. The caller chooses the numbering of edges.
class ScanOutTiming {
 public:
  static constexpr std::uint64_t never = ~std::uint64_t{0};

  /// A picture of `colour_bits` bits of colour, taken by the scan-out at `edge`.
  ScanOutTiming(const machines::Machine& machine, std::uint32_t colour_bits, std::uint64_t edge);

  /// The edge at which the next request for a refresh word reaches the controller; never, if there is none.
  [[nodiscard]] std::uint64_t request() const { return row_ < rows_ && shared_ ? request_ : never; }

  /// Records that the controller sends the requested refresh word at `edge`.
  void record_refresh_word(std::uint64_t edge);

  /// Records that the controller sends each remaining word at the earliest possible edge from `edge` on.
  void record_remaining_words(std::uint64_t edge);

  // Results after all words have been sent.
  /// Edge at which the controller is notified that the last row has been latched.
  [[nodiscard]] std::uint64_t latched() const { return latched_; }
  /// First edge at which another picture can be taken, one edge after the last pixel has been shown.
  [[nodiscard]] std::uint64_t over() const { return row_begun_ + shift_clocks_; }

 private:
  void finish_row(std::uint64_t edge);

  std::uint32_t bits_;
  std::uint64_t rows_;
  std::uint64_t shift_clocks_;  ///< clocks to shift out a row
  std::uint64_t way_;           ///< clocks from a refresh word's edge to the first edge after its bit has been latched
  bool shared_;
  std::uint64_t row_ = 0;      ///< row being latched
  std::uint64_t row_begun_;    ///< edge from which the row is latched while the previous row is shown
  std::uint32_t sent_ = 0;     ///< number of refresh words sent for the row
  std::uint64_t request_ = 0;  ///< edge of the next request
  std::uint64_t latched_ = 0;
};

}  // namespace csgsim::pixel_planes
