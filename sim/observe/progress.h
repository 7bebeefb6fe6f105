#pragma once

#include <chrono>
#include <cstdint>

#include "sim/engine/engine.h"
#include "sim/engine/numbers.h"
#include "sim/observe/long_work.h"

namespace csgsim::observe {

/// Tells on standard error how far a run is, its rate and the time left, a few times a second once it has taken a
/// second; and, if asked to, warns then of one that will take minutes.
class ProgressObserver : public engine::Observer {
 public:
  /// The clocks of what turns out to be skipped are taken off the total. Program and machine have to outlive it.
  ProgressObserver(const isa::Program& program, const machines::Machine& machine);

  /// Warns as LongWork does; tells how far the run is only if asked to.
  void warn(LongWork& work, bool also_tells);

  ~ProgressObserver() override;
  ProgressObserver(const ProgressObserver&) = delete;
  ProgressObserver& operator=(const ProgressObserver&) = delete;

  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }
  void after_instruction(const engine::Step& step, const engine::PixelState& state) override;

  /// Counts only what is left from there on.
  void begin_at(engine::Place place);

 private:
  using Clock = std::chrono::steady_clock;
  const isa::Program& program_;
  const machines::Machine& machine_;
  std::uint64_t total_ = 0;
  std::uint64_t done_ = 0;
  std::uint64_t instructions_ = 0;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point told_ = begin_;
  bool tells_ = true;
  LongWork* work_ = nullptr;
  bool shown_ = false;
};

}  // namespace csgsim::observe
