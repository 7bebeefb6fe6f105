#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "hw/bit_serial_memory/figures.h"
#include "hw/bit_serial_memory/row_command.h"
#include "hw/bit_serial_memory/slots.h"

namespace csgsim::bit_serial_memory {

/// What a rank is at between two commands. Clocks count from the one on from which the last activation allows the next.
struct RankState {
  std::vector<std::int64_t> free;         ///< from when on each bank is
  std::array<std::int64_t, 4> allowed{};  ///< from when on the next four activations are, by the window
  std::int64_t bus = 0;                   ///< from when on it is free

  bool operator<(const RankState& other) const {
    return std::tie(free, allowed, bus) < std::tie(other.free, other.allowed, other.bus);
  }
};

/// A rank goes from command to command. It comes back to few states again and again, so that what a command makes of
/// each of them is worked out once.
class RankSteps {
 public:
  RankSteps(const Figures& figures, const Slots& slots);

  /// All banks are closed at that clock, and as many activations allowed as there can be.
  void start(std::uint64_t clock);
  /// All slots carry out such a command.
  void step(RowOp op);
  /// All that is going on goes on later.
  void delay(std::uint64_t clocks) { zero_ += static_cast<std::int64_t>(clocks); }

  /// The clock at which the first bank can be activated.
  [[nodiscard]] std::uint64_t next_activation() const { return clock(nodes_[here_].next_activation); }
  /// The clock from which on no bank is activated and nothing on the bus, if nothing else begins.
  [[nodiscard]] std::uint64_t closed() const { return clock(nodes_[here_].closed); }
  /// The clock from which on it is as in the beginning.
  [[nodiscard]] std::uint64_t over() const { return clock(nodes_[here_].over); }

 private:
  static constexpr std::size_t most_nodes = 4096;  ///< that are kept

  struct Edge {
    std::size_t to = most_nodes;  ///< not known yet
    std::int64_t clocks = 0;      ///< by which the count goes on
  };
  struct Node {
    const RankState* state = nullptr;
    std::int64_t next_activation = 0;
    std::int64_t closed = 0;
    std::int64_t over = 0;
    std::array<Edge, row_op_count> edges{};
  };

  [[nodiscard]] std::uint64_t clock(std::int64_t after_zero) const {
    return static_cast<std::uint64_t>(zero_ + after_zero);
  }
  std::size_t node_of(const RankState& state);
  void forget();

  const Figures& figures_;
  const Slots slots_;
  std::map<RankState, std::size_t> known_;
  std::vector<Node> nodes_;  ///< the first is that of the beginning
  std::size_t here_ = 0;
  std::int64_t zero_ = 0;
};

}  // namespace csgsim::bit_serial_memory
