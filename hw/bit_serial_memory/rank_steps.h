#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "hw/bit_serial_memory/figures.h"
#include "hw/bit_serial_memory/row_command.h"
#include "hw/bit_serial_memory/row_listener.h"
#include "hw/bit_serial_memory/slots.h"

namespace csgsim::bit_serial_memory {

/// State of a rank between two commands. Clocks are relative to the first clock at which tRRD allows another
/// activation.
struct RankState {
  std::vector<std::int64_t> free;         ///< clock from which each bank is free
  std::array<std::int64_t, 4> allowed{};  ///< clocks from which the window allows each of the next four activations
  std::int64_t bus = 0;                   ///< clock from which the data bus is free

  bool operator<(const RankState& other) const {
    return std::tie(free, allowed, bus) < std::tie(other.free, other.allowed, other.bus);
  }
};

/// Steps a rank from command to command. Few distinct states occur, so the effect of a command on a state is computed
/// once and cached.
class RankSteps {
 public:
  RankSteps(const Figures& figures, const Slots& slots);

  /// Starts at `clock` with all banks closed and an empty activation window.
  void start(std::uint64_t clock);
  /// Lets all slots execute a command of the given kind.
  void step(RowOp op);
  /// Also appends the command's clocks in each slot or, for a command without activation, in each bank.
  void step(const RowCommand& command, std::vector<Issue>& issues);
  /// Delays everything in progress by `clocks`.
  void delay(std::uint64_t clocks) { zero_ += static_cast<std::int64_t>(clocks); }

  /// Clock at which the first bank can be activated.
  [[nodiscard]] std::uint64_t next_activation() const { return clock(nodes_[current_].next_activation); }
  /// Clock from which all banks are closed and the bus is idle, if no further command begins.
  [[nodiscard]] std::uint64_t closed() const { return clock(nodes_[current_].closed); }
  /// Clock from which the rank is in its initial state again.
  [[nodiscard]] std::uint64_t over() const { return clock(nodes_[current_].over); }

 private:
  static constexpr std::size_t max_nodes = 4096;  ///< maximum number of cached nodes

  struct Edge {
    std::size_t to = max_nodes;  ///< not computed yet
    std::int64_t clocks = 0;     ///< clocks by which the reference clock advances
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
  std::size_t find_node(const RankState& state);
  void enter(const RankState& state, std::int64_t clocks);
  void clear_nodes();

  const Figures& figures_;
  const Slots slots_;
  std::map<RankState, std::size_t> node_numbers_;
  std::vector<Node> nodes_;  ///< the first belongs to the initial state
  std::size_t current_ = 0;
  std::int64_t zero_ = 0;
};

}  // namespace csgsim::bit_serial_memory
