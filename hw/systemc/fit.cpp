#include "hw/systemc/fit.h"

#include <string>

#include "hw/base/error.h"

namespace csgsim::systemc {

void check_fits(const isa::ArrayShape& program, const isa::ArrayShape& machine) {
  if (program.width <= machine.width && program.height <= machine.height &&
      program.memory_bits <= machine.memory_bits) {
    return;
  }
  const auto text = [](const isa::ArrayShape& shape) {
    return std::to_string(shape.width) + "x" + std::to_string(shape.height) + " pixels of " +
           std::to_string(shape.memory_bits) + " bits";
  };
  throw InputError("the Program is for " + text(program) + ", the machine has " + text(machine) +
                   "; compile it for this machine");
}

}  // namespace csgsim::systemc
