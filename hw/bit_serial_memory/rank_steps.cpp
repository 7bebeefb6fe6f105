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

  /// Appends the clocks of the command to `issues`; `zero` is the clock to which the state is relative.
  void record(std::vector<Issue>& issues, std::int64_t zero) {
    issues_ = &issues;
    zero_ = zero;
  }

  /// `gate_clocks`: clocks of a logic command.
  void take(RowOp op, std::uint32_t gate_clocks) {
    const CommandClocks& clocks = figures_.command;
    if (activations(op) > 0) {
      for (std::uint64_t slot = 0; slot < slots_.count(); ++slot) issue(op, slot);
      return;
    }
    const std::int64_t taken = op == RowOp::logic  ? gate_clocks
                               : op == RowOp::leaf ? std::max(clocks.logic, clocks.leaf)
                                                   : clocks.global_or;
    for (std::size_t bank = 0; bank < state_.free.size(); ++bank) {
      if (issues_ != nullptr) issues_->push_back({.place = bank, .clock = clock_of(state_.free[bank])});
      state_.free[bank] += taken;
    }
  }

  [[nodiscard]] std::int64_t clocks() const { return last_; }

  /// The resulting state, relative to the clock at which the gap after the last activation ends. Earlier times of
  /// `allowed` and `bus` become 0; those of `free` become negative.
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

  [[nodiscard]] std::uint64_t clock_of(std::int64_t relative) const {
    return static_cast<std::uint64_t>(zero_ + relative);
  }

  void issue(RowOp op, std::uint64_t slot) {
    const std::int64_t first = begin(slot);
    const std::int64_t second = finish(op, slot, first);
    if (issues_ == nullptr) return;
    Issue issue{.place = slot, .clock = clock_of(first)};
    issue.precharge = clock_of(state_.free[slots_.bank(slot)] - figures_.command.precharge);
    if (op == RowOp::copy) issue.second = clock_of(second);
    if (op == RowOp::receive || op == RowOp::send) {
      issue.transfer_clocks = transfer_clocks(slots_.columns(slot), figures_);
      issue.transfer = clock_of(state_.bus) - issue.transfer_clocks;
    }
    issues_->push_back(issue);
  }

  /// Performs the first activation as soon as possible, and returns its clock.
  std::int64_t begin(std::uint64_t slot) {
    const std::int64_t first = std::max({state_.free[slots_.bank(slot)], last_, state_.allowed[next_]});
    activate(first);
    return first;
  }

  /// Performs the rest of a command. Returns the clock of its last activation.
  std::int64_t finish(RowOp op, std::uint64_t slot, std::int64_t first) {
    const CommandClocks& clocks = figures_.command;
    std::int64_t& free = state_.free[slots_.bank(slot)];
    switch (op) {
      case RowOp::copy: {
        const std::int64_t second = std::max({first + clocks.second, last_, state_.allowed[next_]});
        activate(second);
        free = second + clocks.restore + clocks.precharge;
        return second;
      }
      case RowOp::leaf_copy: free = first + std::max(clocks.restore + clocks.precharge, clocks.leaf); return first;
      case RowOp::receive:
      case RowOp::send:
        state_.bus = std::max(state_.bus, first + clocks.column) +
                     static_cast<std::int64_t>(transfer_clocks(slots_.columns(slot), figures_));
        free = std::max(first + clocks.restore, state_.bus + clocks.recovery) + clocks.precharge;
        return first;
      case RowOp::activate:
      case RowOp::latch:
      case RowOp::read:
      case RowOp::write: free = first + clocks.restore + clocks.precharge; return first;
      case RowOp::logic:
      case RowOp::leaf:
      case RowOp::wired_or: return first;
    }
    return first;
  }

  const Figures& figures_;
  const Slots& slots_;
  RankState state_;
  std::size_t next_ = 0;  ///< index of the oldest entry of `allowed`, a ring
  std::int64_t last_ = 0;
  std::vector<Issue>* issues_ = nullptr;
  std::int64_t zero_ = 0;
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
    step.take(op, figures_.command.logic);
    const RankState to = step.to();
    if (nodes_.size() == max_nodes) return enter(to, step.clocks());
    const std::size_t target = find_node(to);
    nodes_[current_].edges[number] = {target, step.clocks()};
  }
  const Edge& edge = nodes_[current_].edges[number];
  zero_ += edge.clocks;
  current_ = edge.to;
}

void RankSteps::step(const RowCommand& command, std::vector<Issue>& issues) {
  Step step(figures_, slots_, *nodes_[current_].state);
  step.record(issues, zero_);
  step.take(command.op, command.own != nullptr ? command.own->clocks : figures_.command.logic);
  enter(step.to(), step.clocks());
}

/// Makes `state` the current one, `clocks` after the previous one.
void RankSteps::enter(const RankState& state, std::int64_t clocks) {
  if (nodes_.size() == max_nodes) clear_nodes();
  zero_ += clocks;
  current_ = find_node(state);
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
