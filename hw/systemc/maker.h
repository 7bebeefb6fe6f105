#pragma once

#include <memory>
#include <span>

#include "hw/machines/kind.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/evaluator_form.h"
#include "hw/systemc/foretold.h"

namespace csgsim::systemc {

/// Makes the SystemC models of a kind's machines; of each kind in hw/kinds there is an `extern const Maker KIND_maker`.
struct Maker {
  const machines::Kind* kind;
  std::unique_ptr<ClockedMachine> (*make)(const machines::Machine& machine);
  /// Makes a machine whose multiplier trees are stepped; null if the kind has none.
  std::unique_ptr<ClockedMachine> (*make_stepped)(const machines::Machine& machine) = nullptr;
  /// Makes a machine with the foretold pixels alone; null if the whole machine is built for a wave.
  std::unique_ptr<ClockedMachine> (*make_probed)(const machines::Machine& machine, const Foretold& foretold,
                                                 EvaluatorForm form) = nullptr;
};

/// The makers of all built-in kinds.
std::span<const Maker* const> makers();

}  // namespace csgsim::systemc
