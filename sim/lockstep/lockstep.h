// An observer that runs a second run in lockstep and compares the states.
// Used by sim/lockstep and the lockstep tests.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/engine/run.h"
#include "sim/lockstep/state_comparison.h"

namespace csgsim::lockstep {

/// The point at which two runs diverge.
struct Divergence {
  engine::Place place;  ///< the last instruction before the difference, in A's Program
  std::optional<PixelDifference> pixel;
  /// The difference if no pixel differs: `clocks`, `enabled pixels`, or `instruction` (the numbers of the instructions
  /// that the two sides execute).
  std::optional<TwoValues> otherwise;

  bool operator==(const Divergence&) const = default;
};

struct LockstepSettings {
  /// Number of instructions between comparisons of all memory. In between, only what each instruction can write is
  /// compared; other changes are found later.
  std::uint64_t whole_every = 1;
  /// Number of the first instruction after which states are compared.
  std::uint64_t begin = 0;
  bool clocks = true;  ///< also compare the clocks of each instruction
  /// Number of the first instruction that is no longer compared.
  std::uint64_t end = engine::Run::end;
};

/// Observes run A and advances run B with it: after each instruction of A, B executes its instruction with the same
/// number, and the states are compared until they differ. The compared segments must have the same regions.
class Lockstep final : public engine::Observer {
 public:
  /// `b_run` must be at its start. It and the Programs must outlive this object. `b_observers` observe all of B's run.
  Lockstep(const isa::Program& a, const isa::Program& b, engine::Run& b_run, LockstepSettings settings,
           std::span<engine::Observer* const> b_observers = {});

  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return compares_; }
  void after_instruction(const engine::Step& step, const engine::PixelState& state) override;
  void after_segment(std::uint32_t segment, const engine::PixelState& state) override;

  /// Runs B to its end after A has ended.
  void finish();

  [[nodiscard]] const std::optional<Divergence>& divergence() const { return divergence_; }
  /// One more than the number of the last instruction after which all of memory was compared and equal; 0 if there was
  /// none.
  [[nodiscard]] std::uint64_t compared_fully_until() const { return whole_until_; }
  /// Number of instructions after which the states were compared and equal.
  [[nodiscard]] std::uint64_t compared() const { return compared_; }

 private:
  /// Records the last step of B.
  class Last final : public engine::Observer {
   public:
    [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }
    void after_instruction(const engine::Step& step, const engine::PixelState& /*state*/) override {
      place = {step.segment, step.index};
      clocks = step.clocks;
      enabled_pixels = step.enabled_pixels;
    }

    engine::Place place;
    std::uint64_t clocks = 0;
    std::uint64_t enabled_pixels = 0;
  };

  void record_divergence(engine::Place place, std::optional<PixelDifference> pixel, std::optional<TwoValues> otherwise);
  /// The difference between the two steps, if any.
  [[nodiscard]] std::optional<TwoValues> step_difference(const engine::Step& step) const;

  const isa::Program& b_program_;
  engine::Numbers a_numbers_;
  engine::Numbers b_numbers_;
  engine::Run& b_;
  LockstepSettings settings_;
  StateComparison comparison_;
  Last last_;
  std::vector<engine::Observer*> b_observers_;
  bool compares_ = true;
  std::uint64_t whole_until_ = 0;
  std::uint64_t compared_ = 0;
  std::optional<Divergence> divergence_;
};

}  // namespace csgsim::lockstep
