// Observer that shows the progress of a run.
// Used by sim/session.
#pragma once

#include <chrono>
#include <cstdint>

#include "sim/engine/engine.h"
#include "sim/engine/numbers.h"
#include "sim/observe/long_work.h"

namespace csgsim::observe {

/// Shows progress, rate and remaining time of a run on standard error, a few times per second after the first second.
/// On request it also warns about a run that will take minutes.
class ProgressObserver : public engine::Observer {
 public:
  /// Clocks of skipped instructions are removed from the total. Program and machine have to outlive it.
  ProgressObserver(const isa::Program& program, const machines::Machine& machine);

  /// Warns through `work`; shows progress only if `shows_progress` is set.
  void warn(LongWork& work, bool shows_progress);

  ~ProgressObserver() override;
  ProgressObserver(const ProgressObserver&) = delete;
  ProgressObserver& operator=(const ProgressObserver&) = delete;

  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }
  void after_instruction(const engine::Step& step, const engine::PixelState& state) override;

  /// Counts only the part of the run after this place.
  void begin_at(engine::Place place);

 private:
  using Clock = std::chrono::steady_clock;
  const isa::Program& program_;
  const machines::Machine& machine_;
  std::uint64_t total_ = 0;
  std::uint64_t done_ = 0;
  std::uint64_t instructions_ = 0;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_shown_ = begin_;
  bool shows_ = true;
  LongWork* work_ = nullptr;
  bool shown_ = false;
};

}  // namespace csgsim::observe
