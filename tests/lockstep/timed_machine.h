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

/// The clocked machine of the process, and when it told of what its pixels had carried out.
class TimedMachine final : public systemc::ClockedMachine {
 public:
  explicit TimedMachine(const machines::Machine& machine,
                        systemc::EvaluatorForm form = systemc::EvaluatorForm::worked_out);

  systemc::RunReport run(const isa::Program& program, systemc::RunListener& listener) override;

  /// An instruction, told of so many clock edges after the run was asked for.
  struct Told {
    std::uint32_t segment = 0;
    std::uint32_t index = 0;
    std::uint64_t edge = 0;
  };

  /// In the last run, in order.
  [[nodiscard]] const std::vector<Told>& told() const { return told_; }

  /// Throws Difference unless, in the last run, which was of that Program, each instruction was carried out when its
  /// timeline says, and those that were skipped are not in it. The next edge after the run was asked for begins
  /// clock 0.
  void check_timeline(const isa::Program& program) const;

  /// Draws the Program again, and throws Difference unless the wave of a pixel shows what the judge has there.
  void check_wave(const isa::Program& program, engine::Engine& judge);

 private:
  class Listener;

  [[nodiscard]] std::uint64_t edges() const;

  const machines::Machine& machine_;
  systemc::ClockedMachine& hardware_;
  systemc::WaveRecorder recorder_;
  std::vector<Told> told_;
  std::vector<machines::Skip> skips_;
};

}  // namespace csgsim::test
