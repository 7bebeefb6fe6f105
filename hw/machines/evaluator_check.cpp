#include "hw/machines/evaluator_check.h"

#include <fmt/format.h>

#include "hw/machines/figure_error.h"

namespace csgsim::machines {

void check_evaluator(const Machine& machine) {
  if (machine.evaluator_bits <= machine.alu_bits) return;
  throw FigureError(
      "evaluator.bits",
      fmt::format("evaluator.bits is {0} and alu.bits {1}: the ALU must process all bits that the trees deliver in a "
                  "clock; make evaluator.bits at most {1}, or alu.bits at least {0}",
                  machine.evaluator_bits, machine.alu_bits));
}

}  // namespace csgsim::machines
