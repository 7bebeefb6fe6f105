#include "hw/bit_serial_memory/rank_steps.h"

#include <algorithm>
#include <utility>

namespace csgsim::bit_serial_memory {

namespace {

/// One command of all slots, from a state on.
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

  /// Counted from where the last activation allows the next. What was allowed before is allowed from there on.
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
  std::size_t next_ = 0;  ///< of those that are allowed, in a ring
  std::int64_t last_ = 0;
};

}  // namespace

RankSteps::RankSteps(const Figures& figures, const Slots& slots) : figures_(figures), slots_(slots) { forget(); }

void RankSteps::start(std::uint64_t clock) {
  here_ = 0;
  zero_ = static_cast<std::int64_t>(clock);
}

void RankSteps::step(RowOp op) {
  const auto number = static_cast<std::size_t>(op);
  if (nodes_[here_].edges[number].to == most_nodes) {
    Step step(figures_, slots_, *nodes_[here_].state);
    step.take(op);
    const RankState to = step.to();
    if (nodes_.size() == most_nodes) {
      forget();
      zero_ += step.clocks();
      here_ = node_of(to);
      return;
    }
    const std::size_t there = node_of(to);
    nodes_[here_].edges[number] = {there, step.clocks()};
  }
  const Edge& edge = nodes_[here_].edges[number];
  zero_ += edge.clocks;
  here_ = edge.to;
}

std::size_t RankSteps::node_of(const RankState& state) {
  const auto [found, is_new] = known_.try_emplace(state, nodes_.size());
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

void RankSteps::forget() {
  nodes_.clear();
  known_.clear();
  node_of(RankState{.free = std::vector<std::int64_t>(slots_.used_banks())});
}

}  // namespace csgsim::bit_serial_memory
