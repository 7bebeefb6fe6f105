#pragma once

#include <cstdint>

#include "hw/machines/machine.h"

namespace csgsim::pixel_planes {

/// Works out how a picture is scanned out, without stepping. A row is latched while the one before it is shown, but for
/// the first. Edges are numbered by whoever asks.
class ScanOutTiming {
 public:
  static constexpr std::uint64_t never = ~std::uint64_t{0};

  /// Of so many bits of colour; the scan-out takes the picture at that edge.
  ScanOutTiming(const machines::Machine& machine, std::uint32_t colour_bits, std::uint64_t edge);

  /// The edge from which on a request for a refresh word waits at the controller; never, if none is to come.
  [[nodiscard]] std::uint64_t request() const { return row_ < rows_ && shared_ ? request_ : never; }

  /// The controller sends the refresh word at that edge, at which one is waited for.
  void send(std::uint64_t edge);

  /// The controller sends every word as soon as it is asked for, from that edge on.
  void send_all(std::uint64_t edge);

  /// When all words have been sent: the edge at which the controller knows that the last row has been latched, and the
  /// first at which another picture can be taken, one after the last pixel has been shown.
  [[nodiscard]] std::uint64_t latched() const { return latched_; }
  [[nodiscard]] std::uint64_t over() const { return row_begun_ + shift_clocks_; }

 private:
  void finish_row(std::uint64_t edge);

  std::uint32_t bits_;
  std::uint64_t rows_;
  std::uint64_t shift_clocks_;  ///< of a row
  std::uint64_t way_;           ///< from a refresh word's edge to the first after its bit has been latched
  bool shared_;
  std::uint64_t row_ = 0;      ///< that is being latched
  std::uint64_t row_begun_;    ///< edge from which on it is latched, and the one before it is shown
  std::uint32_t sent_ = 0;     ///< words of it
  std::uint64_t request_ = 0;  ///< edge of the next
  std::uint64_t latched_ = 0;
};

}  // namespace csgsim::pixel_planes
