// Factories of SystemC machines.
// Used by hw.
#pragma once

#include <memory>
#include <span>

#include "hw/machines/kind.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/earlier_run.h"
#include "hw/systemc/evaluator_form.h"

namespace csgsim::systemc {

/// Factory of the SystemC models of one kind. Each kind in hw/kinds defines an `extern const Maker KIND_maker`.
struct Maker {
  const machines::Kind* kind;
  std::unique_ptr<ClockedMachine> (*make)(const machines::Machine& machine);
  /// Makes a machine with stepped multiplier trees; null if the kind has none.
  std::unique_ptr<ClockedMachine> (*make_stepped)(const machines::Machine& machine) = nullptr;
  /// Makes a machine with only the pixels of an earlier run; null if waves need the whole machine.
  std::unique_ptr<ClockedMachine> (*make_probed)(const machines::Machine& machine, const EarlierRun& earlier,
                                                 EvaluatorForm form) = nullptr;
};

/// The makers of all built-in kinds.
std::span<const Maker* const> makers();

}  // namespace csgsim::systemc
