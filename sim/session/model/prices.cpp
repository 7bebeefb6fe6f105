#include "sim/session/model/prices.h"

#include <cstdint>

#include "hw/host/host.h"
#include "hw/host/recipes.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/instruction.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"

namespace csgsim::session {

namespace {

/// A typical instruction: the comparison of a plane with a depth of 20 bits.
constexpr isa::Instruction usual_instruction{.opcode = isa::Opcode::linear_gt,
                                             .fields = {isa::Field{0, 20}, {}, {}},
                                             .linear = {.a = 1, .b = 1, .c = 1, .width = 33, .shift = 12}};

/// Time of the host and of the array for that instruction.
double instruction_price(const machines::Machine& machine) {
  constexpr double nanoseconds_in_second = 1e9;
  host::Writer writer(machine.link.width);
  writer.add(usual_instruction);
  const double clocks = static_cast<double>(machines::clocks(usual_instruction, machine));
  return host::nanoseconds(host::count_operations(writer.written()), machine) +
         clocks * nanoseconds_in_second / static_cast<double>(machine.clock_hz);
}

}  // namespace

csg::Prices prices_on(const machines::Machine& machine) {
  csg::Prices prices{.instruction = instruction_price(machine)};
  const auto take = [&](std::uint64_t isa::Preparation::*count, double& price) {
    for (const host::Recipe& recipe : host::recipes())
      if (recipe.count == count) price = host::nanoseconds(recipe.each, machine);
  };
  take(&isa::Preparation::boxes, prices.box);
  take(&isa::Preparation::halfspaces, prices.test);
  take(&isa::Preparation::values, prices.value);
  take(&isa::Preparation::supports, prices.support);
  return prices;
}

csg::Prices weighed_prices_on(const machines::Machine& machine) {
  csg::Prices prices = prices_on(machine);
  prices.are_weighed = true;
  return prices;
}

}  // namespace csgsim::session
