#include "sim/study/subdivision.h"

#include <algorithm>

#include "host/emit/compile.h"
#include "hw/machines/clocks.h"

namespace csgsim::study {

Squares measure_squares(const Subdivided& subdivided, const machines::Size& square) {
  machines::Machine machine = subdivided.machine;
  machine.array.width = square.width;
  machine.array.height = square.height;
  const isa::Program program =
      emit::compile(subdivided.tree, subdivided.scene, subdivided.view, machine, subdivided.options);
  Squares squares;
  squares.count = program.segments.size();
  for (const isa::Segment& segment : program.segments) {
    if (segment.primitives > 0) ++squares.touched;
    squares.primitives += segment.primitives;
    squares.halfspaces += segment.halfspaces;
    squares.kept_primitives += segment.kept_primitives;
    squares.kept_halfspaces += segment.kept_halfspaces;
    squares.comparisons += segment.comparisons;
    squares.instruction_clocks += machines::clocks(segment.instructions, machine);
  }
  const auto touched = static_cast<double>(std::max<std::uint64_t>(squares.touched, 1));
  for (double* sum : {&squares.primitives, &squares.halfspaces, &squares.kept_primitives, &squares.kept_halfspaces,
                      &squares.comparisons}) {
    *sum /= touched;
  }
  squares.clocks = machines::clocks(program, machine);
  return squares;
}

}  // namespace csgsim::study
