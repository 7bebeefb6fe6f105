#include "sim/functional/clocks.h"

#include <algorithm>
#include <utility>

#include "hw/host/host.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "hw/machines/kind.h"
#include "sim/engine/engine.h"

namespace csgsim::functional {

bool may_skip(const isa::Program& program) {
  return std::ranges::any_of(program.segments, [](const isa::Segment& segment) {
    return std::ranges::find(segment.instructions, isa::Opcode::skip_if_none, &isa::Instruction::opcode) !=
           segment.instructions.end();
  });
}

bool needs_run(const isa::Program& program, const machines::Machine& machine) {
  return machine.kind->depends_on_pixels(machine) || may_skip(program);
}

machines::RunRecord make_run_record(const isa::Program& program, const machines::Machine& machine) {
  if (!needs_run(program, machine)) return {};
  engine::RunResult result = engine::make_functional_engine(machine)->run(program, {});
  return {std::move(result.skips), std::move(result.pixel_activity)};
}

machines::FrameTiming measure_timing(const isa::Program& program, const machines::Machine& machine) {
  if (!needs_run(program, machine)) return host::time_frame(program, machine);
  return engine::timing_of(engine::make_functional_engine(machine)->run(program, {}));
}

std::uint64_t measure_clocks(const isa::Program& program, const machines::Machine& machine) {
  if (!needs_run(program, machine)) return machines::clocks(program, machine);
  return engine::make_functional_engine(machine)->run(program, {}).clocks;
}

}  // namespace csgsim::functional
