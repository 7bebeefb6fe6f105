#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/engine/run.h"
#include "sim/lockstep/state_comparison.h"

namespace csgsim::lockstep {

/// Where two runs go apart.
struct Divergence {
  engine::Place place;  ///< of the instruction after which they differ, in A's Program
  std::optional<PixelDifference> pixel;
  /// What else differs, if no pixel does: `clocks`, `enabled pixels`, or `instruction`, the number of the one that each
  /// carries out.
  std::optional<TwoValues> otherwise;

  bool operator==(const Divergence&) const = default;
};

struct LockstepSettings {
  /// Instructions from one comparison of all memory to the next. Between, what each can write is compared; what
  /// changes elsewhere is found later.
  std::uint64_t whole_every = 1;
  /// Number of the first instruction after which states are compared.
  std::uint64_t begin = 0;
  bool clocks = true;  ///< the clocks of each instruction are compared
  /// Number of the first instruction that is not compared any more.
  std::uint64_t end = engine::Run::end;
};

/// Watches run A and has run B go along: after each instruction of A, B has carried out its one of that number, and
/// both states are compared, until they differ. Their segments have to have the same regions as far as they are
/// compared.
class Lockstep final : public engine::Observer {
 public:
  /// Programs and run, which is at its beginning, have to outlive it. `b_observers` see all of B's run.
  Lockstep(const isa::Program& a, const isa::Program& b, engine::Run& b_run, LockstepSettings settings,
           std::span<engine::Observer* const> b_observers = {});

  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return compares_; }
  void after_instruction(const engine::Step& step, const engine::PixelState& state) override;
  void after_segment(std::uint32_t segment, const engine::PixelState& state) override;

  /// Has B go on to its end when A is there.
  void finish();

  [[nodiscard]] const std::optional<Divergence>& divergence() const { return divergence_; }
  /// Number of the last instruction after which all of memory was equal, plus one; 0 if none was.
  [[nodiscard]] std::uint64_t whole_until() const { return whole_until_; }
  /// Instructions after which the states were compared and equal.
  [[nodiscard]] std::uint64_t compared() const { return compared_; }

 private:
  /// What B's last instruction told.
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

  void differ(engine::Place place, std::optional<PixelDifference> pixel, std::optional<TwoValues> otherwise);
  /// What the two steps tell differently, or nothing.
  [[nodiscard]] std::optional<TwoValues> other_step(const engine::Step& step) const;

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
