#pragma once

#include "hw/pixel_planes/kind.h"

namespace csgsim::testing {

/// A 10 MHz frame buffer of the given shape with a picture of the same size.
inline machines::Machine planes(isa::ArrayShape shape) {
  machines::Machine machine = machines::blank_machine(pixel_planes::kind);
  machine.name = "test";
  machine.array = shape;
  machine.picture = {shape.width, shape.height};
  machine.clock_hz = 10'000'000;
  machine.evaluator_degree = 2;
  return machine;
}

}  // namespace csgsim::testing
