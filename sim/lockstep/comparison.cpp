#include "sim/lockstep/comparison.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace csgsim::lockstep {

namespace {

/// Number of instructions between comparisons of all memory, if such a comparison is slow.
constexpr std::uint64_t default_stride = 512;

bool same_operation(const isa::Instruction& a, const isa::Instruction& b) {
  return a.opcode == b.opcode && a.fields == b.fields && a.linear == b.linear && a.constant == b.constant;
}

/// Whether the Programs have the same regions with the same numbers of instructions.
bool same_layout(const isa::Program& a, const isa::Program& b) {
  return std::equal(a.segments.begin(), a.segments.end(), b.segments.begin(), b.segments.end(),
                    [](const isa::Segment& one, const isa::Segment& other) {
                      return one.region == other.region && one.instructions.size() == other.instructions.size();
                    });
}

Comparison run_both(const Side& a, const Side& b, LockstepSettings settings) {
  Comparison comparison;
  const std::unique_ptr<engine::Run> b_run = b.engine.begin(b.program);
  observe::FrameObserver a_frame(a.program);
  observe::FrameObserver b_frame(b.program);
  observe::StatsObserver a_stats(a.program);
  observe::StatsObserver b_stats(b.program);
  const std::array<engine::Observer*, 2> b_observers{&b_frame, &b_stats};
  Lockstep lockstep(a.program, b.program, *b_run, settings, b_observers);
  const std::array<engine::Observer*, 3> a_observers{&a_frame, &a_stats, &lockstep};
  engine::RunResult a_result = a.engine.run(a.program, a_observers);
  lockstep.finish();
  comparison.a = {std::move(a_result), std::move(a_frame).frame(), a_stats.stats()};
  comparison.b = {b_run->result(), std::move(b_frame).frame(), b_stats.stats()};
  comparison.divergence = lockstep.divergence();
  comparison.compared = lockstep.compared();
  // A difference may be found later than it occurred: the instructions since the last full comparison are run again,
  // with all of memory compared after each.
  const bool may_be_late = comparison.divergence && comparison.divergence->pixel && settings.whole_every > 1;
  if (!may_be_late) return comparison;
  settings.whole_every = 1;
  settings.begin = lockstep.compared_fully_until();
  return run_both(a, b, settings);
}

}  // namespace

std::optional<std::uint64_t> first_different_instruction(const isa::Program& a, const isa::Program& b) {
  std::uint64_t number = 0;
  for (std::size_t s = 0; s < std::max(a.segments.size(), b.segments.size()); ++s) {
    if (s >= a.segments.size() || s >= b.segments.size() || a.segments[s].region != b.segments[s].region) return number;
    const std::vector<isa::Instruction>& ours = a.segments[s].instructions;
    const std::vector<isa::Instruction>& theirs = b.segments[s].instructions;
    const auto [at, other] = std::mismatch(ours.begin(), ours.end(), theirs.begin(), theirs.end(), same_operation);
    number += static_cast<std::uint64_t>(at - ours.begin());
    if (at != ours.end() || other != theirs.end()) return number;
  }
  return std::nullopt;
}

std::optional<PictureDifference> first_difference(const observe::Frame& a, const observe::Frame& b) {
  std::optional<PictureDifference> difference;
  for (std::size_t i = 0; i < a.owner.size(); ++i) {
    if (a.owner[i] == b.owner[i] && a.depth[i] == b.depth[i] && a.colour[i] == b.colour[i]) continue;
    if (!difference) {
      difference = {static_cast<std::uint32_t>(i % a.width), static_cast<std::uint32_t>(i / a.width), 0};
    }
    ++difference->pixels;
  }
  return difference;
}

Comparison compare(const Side& a, const Side& b) {
  LockstepSettings settings;
  settings.whole_every = default_stride;
  settings.clocks = machines::is_same_hardware(a.machine, b.machine);
  const std::optional<std::uint64_t> other = first_different_instruction(a.program, b.program);
  if (other && !same_layout(a.program, b.program)) settings.end = *other;
  Comparison comparison = run_both(a, b, settings);
  comparison.other_instruction = other;
  comparison.picture = first_difference(comparison.a.frame, comparison.b.frame);
  return comparison;
}

}  // namespace csgsim::lockstep
