#include "hw/bit_serial_memory/rank_steps.h"

#include <algorithm>
#include <utility>

namespace csgsim::bit_serial_memory {

namespace {

/// Effect of one command, executed by all slots, on a state.
class Step {
 public:
  Step(const Figures& figures, const Slots& slots, const RankState& from)
      : figures_(figures), slots_(slots), state_(from) {}

  void take(RowOp op) {
    const CommandClocks& clocks = figures_.command;
    if (activations(op) > 0) {
      for (std::uint64_t slot = 0; slot < slots_.count(); ++slot) issue(op, slot);
      return;
    }
    const std::int64_t taken = op == RowOp::logic  ? clocks.logic
                               : op == RowOp::leaf ? std::max(clocks.logic, clocks.leaf)
                                                   : clocks.global_or;
    for (std::int64_t& bank : state_.free) bank += taken;
  }

  [[nodiscard]] std::int64_t clocks() const { return last_; }

  /// The resulting state, relative to the clock at which the last activation allows another. Earlier times are clamped
  /// to that clock.
  [[nodiscard]] RankState to() const {
    RankState state = state_;
    for (std::int64_t& bank : state.free) bank -= last_;
    for (std::size_t i = 0; i < state.allowed.size(); ++i)
      state.allowed[i] = std::max<std::int64_t>(0, state_.allowed[(next_ + i) % state.allowed.size()] - last_);
    state.bus = std::max<std::int64_t>(0, state.bus - last_);
    return state;
  }

 private:
  void activate(std::int64_t clock) {
    last_ = clock + figures_.rank.activation_gap;
    state_.allowed[next_] = clock + figures_.rank.window;
    next_ = (next_ + 1) % state_.allowed.size();
  }

  void issue(RowOp op, std::uint64_t slot) {
    const CommandClocks& clocks = figures_.command;
    std::int64_t& free = state_.free[slots_.bank(slot)];
    const std::int64_t first = std::max({free, last_, state_.allowed[next_]});
    activate(first);
    switch (op) {
      case RowOp::copy: {
        const std::int64_t second = std::max({first + clocks.second, last_, state_.allowed[next_]});
        activate(second);
        free = second + clocks.restore + clocks.precharge;
        return;
      }
      case RowOp::leaf_copy: free = first + std::max(clocks.restore + clocks.precharge, clocks.leaf); return;
      case RowOp::receive:
      case RowOp::send:
        state_.bus = std::max(state_.bus, first + clocks.column) +
                     static_cast<std::int64_t>(transfer_clocks(slots_.columns(slot), figures_));
        free = std::max(first + clocks.restore, state_.bus + clocks.recovery) + clocks.precharge;
        return;
      case RowOp::activate:
      case RowOp::latch:
      case RowOp::read:
      case RowOp::write: free = first + clocks.restore + clocks.precharge; return;
      case RowOp::logic:
      case RowOp::leaf:
      case RowOp::wired_or: return;
    }
  }

  const Figures& figures_;
  const Slots& slots_;
  RankState state_;
  std::size_t next_ = 0;  ///< index of the oldest entry of `allowed`, a ring
  std::int64_t last_ = 0;
};

}  // namespace

RankSteps::RankSteps(const Figures& figures, const Slots& slots) : figures_(figures), slots_(slots) { clear_nodes(); }

void RankSteps::start(std::uint64_t clock) {
  current_ = 0;
  zero_ = static_cast<std::int64_t>(clock);
}

void RankSteps::step(RowOp op) {
  const auto number = static_cast<std::size_t>(op);
  if (nodes_[current_].edges[number].to == max_nodes) {
    Step step(figures_, slots_, *nodes_[current_].state);
    step.take(op);
    const RankState to = step.to();
    if (nodes_.size() == max_nodes) {
      clear_nodes();
      zero_ += step.clocks();
      current_ = find_node(to);
      return;
    }
    const std::size_t target = find_node(to);
    nodes_[current_].edges[number] = {target, step.clocks()};
  }
  const Edge& edge = nodes_[current_].edges[number];
  zero_ += edge.clocks;
  current_ = edge.to;
}

std::size_t RankSteps::find_node(const RankState& state) {
  const auto [found, is_new] = node_numbers_.try_emplace(state, nodes_.size());
  if (is_new) {
    const std::int64_t idle = std::max(state.bus, std::ranges::max(state.free));
    const std::int64_t next = std::max({state.free.front(), std::int64_t{0}, state.allowed.front()});
    nodes_.push_back({.state = &found->first,
                      .next_activation = next,
                      .closed = std::max(next, idle),
                      .over = std::max({std::int64_t{0}, idle, std::ranges::max(state.allowed)})});
  }
  return found->second;
}

void RankSteps::clear_nodes() {
  nodes_.clear();
  node_numbers_.clear();
  find_node(RankState{.free = std::vector<std::int64_t>(slots_.used_banks())});
}

}  // namespace csgsim::bit_serial_memory
