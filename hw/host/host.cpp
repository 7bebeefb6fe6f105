#include "hw/host/host.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string_view>
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

const processors::Processor& host_processor(const machines::Machine& machine) {
  return processors::built_in_processor(machines::host_processor_names.at(machine.host.processor));
}

/// Clocks of the machine until its host has finished `share`, the work of its busiest processor; rounded up.
std::uint64_t clocks_of(const Operations& share, const machines::Machine& machine, std::string_view what) {
  const double seconds = processors::seconds(share, host_processor(machine));
  const double clocks = std::ceil(seconds * static_cast<double>(machine.clock_hz));
  if (!(clocks <= max_clocks)) {
    throw InputError(
        fmt::format("the host {} takes {:.3g} clocks for the {}, more than the limit of 9e15; choose a faster "
                    "host.processor",
                    machines::host_processor_names.at(machine.host.processor), clocks, what));
  }
  return static_cast<std::uint64_t>(clocks);
}

}  // namespace

Operations count_operations(const isa::Program& program, const machines::Machine& machine) {
  Operations all;
  all += count_operations(*program.preparation);
  if (machines::division(machine)) {
    all += model_long_count(program) * model_long_operations();
    return all;
  }
  Writer writer(machine.link.width);
  for (const isa::Segment& segment : program.segments) {
    all += count_operations(*segment.preparation);
    writer.begin(segment.region);
    for (const isa::Instruction& instruction : segment.instructions) writer.add(instruction);
  }
  all += count_operations(writer.written());
  return all;
}

double nanoseconds(const Operations& operations, const machines::Machine& machine) {
  constexpr double in_second = 1e9;
  if (machine.host.processor == machines::ideal_processor) return 0;
  return in_second * processors::seconds(operations, host_processor(machine)) /
         machine.kind->host_processor_count(machine);
}

std::uint64_t compile_clocks(const isa::Program& program, const machines::Machine& machine) {
  if (machine.host.processor == machines::ideal_processor) return 0;
  const bool is_shared = machine.kind->host_processor_count(machine) > 1;
  return clocks_of(is_shared ? busiest_processor_operations(program, machine, host_processor(machine))
                             : count_operations(program, machine),
                   machine, "frame");
}

std::uint64_t model_clocks(const isa::Program& program, const machines::Machine& machine) {
  if (machine.host.processor == machines::ideal_processor) return 0;
  return clocks_of(busiest_processor_model_operations(program, machine), machine, "model");
}

machines::FrameTiming with_host(machines::FrameTiming timing, const isa::Program& program,
                                const machines::Machine& machine) {
  timing = machines::with_pace(std::move(timing));
  timing.host_clocks = compile_clocks(program, machine);
  timing.host_model_clocks = model_clocks(program, machine);
  return timing;
}

machines::FrameTiming time_frame(const isa::Program& program, const machines::Machine& machine,
                                 const machines::RunOutcome& outcome) {
  return with_host(machine.kind->time(program, machine, outcome), program, machine);
}

}  // namespace csgsim::host
