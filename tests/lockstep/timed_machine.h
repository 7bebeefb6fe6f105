#pragma once

#include <cstdint>
#include <vector>

#include "hw/machines/machine.h"
#include "hw/machines/timing.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/evaluator_form.h"
#include "hw/systemc/wave_recorder.h"
#include "sim/engine/engine.h"

namespace csgsim::test {

/// The clocked machine of the process, with a record of when its instructions retired.
class TimedMachine final : public systemc::ClockedMachine {
 public:
  explicit TimedMachine(const machines::Machine& machine,
                        systemc::EvaluatorForm form = systemc::EvaluatorForm::computed);

  systemc::RunReport run(const isa::Program& program, systemc::RunListener& listener) override;

  /// A retired instruction, with the clock edges since the start of the run.
  struct Retirement {
    std::uint32_t segment = 0;
    std::uint32_t index = 0;
    std::uint64_t edge = 0;
  };

  /// Retired instructions of the last run, in order.
  [[nodiscard]] const std::vector<Retirement>& retired() const { return retired_; }

  /// Throws Difference unless each instruction of the last run, which must have run that Program, retired when its
  /// timeline predicts, and skipped ones are not in the timeline. The first edge after the start of the run begins
  /// clock 0.
  void check_timeline(const isa::Program& program) const;

  /// Draws the Program again, and throws Difference unless the wave of a pixel equals the judge's states.
  void check_wave(const isa::Program& program, engine::Engine& judge);

 private:
  class Listener;

  [[nodiscard]] std::uint64_t edges() const;

  const machines::Machine& machine_;
  systemc::ClockedMachine& hardware_;
  systemc::WaveRecorder recorder_;
  std::vector<Retirement> retired_;
  std::vector<machines::Skip> skips_;
};

}  // namespace csgsim::test
