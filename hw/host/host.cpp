#include "hw/host/host.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "hw/base/error.h"
#include "hw/host/recipes.h"
#include "hw/host/shares.h"
#include "hw/machines/kind.h"
#include "hw/machines/regions.h"
#include "hw/processors/processor.h"

namespace csgsim::host {

namespace {

using processors::Operations;

/// Maximum clocks of a frame; a double represents it exactly.
constexpr double max_clocks = 9e15;

}  // namespace

Operations count_operations(const isa::Program& program, const machines::Machine& machine) {
  Operations all;
  all += count_operations(*program.preparation);
  if (machines::division(machine)) {
    all += model_longs(program) * model_long_operations();
    return all;
  }
  Written written;
  for (const isa::Segment& segment : program.segments) {
    all += count_operations(*segment.preparation);
    for (const isa::Instruction& instruction : segment.instructions) written.add(instruction, machine.link.width);
  }
  all += count_operations(written);
  return all;
}

std::uint64_t compile_clocks(const isa::Program& program, const machines::Machine& machine) {
  if (machine.host.processor == machines::ideal_processor) return 0;
  const processors::Processor& processor =
      processors::built_in_processor(machines::host_processor_names.at(machine.host.processor));
  const std::uint32_t hosts = machine.kind->hosts(machine);
  const Operations work = hosts == 1 ? count_operations(program, machine) : largest_share(program, machine, processor);
  const double clocks = std::ceil(processors::seconds(work, processor) * static_cast<double>(machine.clock_hz));
  if (!(clocks <= max_clocks)) {
    throw InputError(
        fmt::format("the host {} takes {:.3g} clocks for the frame, more than the limit of 9e15; choose a faster "
                    "host.processor",
                    machines::host_processor_names.at(machine.host.processor), clocks));
  }
  return static_cast<std::uint64_t>(clocks);
}

machines::FrameTiming with_host(machines::FrameTiming timing, const isa::Program& program,
                                const machines::Machine& machine) {
  timing = machines::with_pace(std::move(timing));
  timing.host_clocks = compile_clocks(program, machine);
  return timing;
}

machines::FrameTiming time_frame(const isa::Program& program, const machines::Machine& machine,
                                 const machines::RunOutcome& outcome) {
  return with_host(machine.kind->time(program, machine, outcome), program, machine);
}

}  // namespace csgsim::host
