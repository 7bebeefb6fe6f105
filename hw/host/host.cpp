#include "hw/host/host.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/quotient.h"
#include "hw/host/recipes.h"
#include "hw/isa/host_counts.h"
#include "hw/machines/kind.h"
#include "hw/machines/regions.h"
#include "hw/processors/processor.h"

namespace csgsim::host {

namespace {

using processors::Operations;

/// Maximum clocks of a frame; a double represents it exactly.
constexpr double max_clocks = 9e15;

void add(const isa::Preparation& preparation, Operations& all) {
  for (const Recipe& recipe : recipes()) all += preparation.*recipe.count * recipe.each;
}

/// Reads the processor's description once, because it is needed for each frame.
const processors::Processor& load_host_processor(const machines::Machine& machine) {
  constexpr std::size_t all = machines::host_processor_names.size();
  static std::array<std::once_flag, all> once;
  static std::array<processors::Processor, all> read;
  const std::size_t which = machine.host.processor;
  std::call_once(once.at(which), [&] {
    read.at(which) = processors::load_processor(std::string(machines::host_processor_names.at(which)));
  });
  return read.at(which);
}

/// Clocks of the machine until its host has finished, rounded up.
std::uint64_t clocks_of(const Operations& operations, const machines::Machine& machine, std::string_view what) {
  if (machine.host.processor == machines::ideal_processor) return 0;
  const double seconds = processors::seconds(operations, load_host_processor(machine));
  const double clocks = std::ceil(seconds * static_cast<double>(machine.clock_hz) / machine.kind->hosts(machine));
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
  constexpr std::uint64_t bytes_of_long = 4;
  Operations all;
  add(*program.preparation, all);
  if (machines::division(machine)) {
    all += quotient_up(std::uint64_t{program.display_model.size()}, bytes_of_long) * model_long_operations();
    return all;
  }
  Writer writer(machine.link.width);
  for (const isa::Segment& segment : program.segments) {
    add(*segment.preparation, all);
    writer.begin(segment.region);
    for (const isa::Instruction& instruction : segment.instructions) writer.add(instruction);
  }
  all += count_operations(writer.written());
  return all;
}

Operations count_model_operations(const isa::Program& program) {
  Operations all;
  add(*program.model_preparation, all);
  return all;
}

double nanoseconds(const Operations& operations, const machines::Machine& machine) {
  constexpr double in_second = 1e9;
  if (machine.host.processor == machines::ideal_processor) return 0;
  return in_second * processors::seconds(operations, load_host_processor(machine)) / machine.kind->hosts(machine);
}

std::uint64_t compile_clocks(const isa::Program& program, const machines::Machine& machine) {
  return clocks_of(count_operations(program, machine), machine, "frame");
}

std::uint64_t model_clocks(const isa::Program& program, const machines::Machine& machine) {
  return clocks_of(count_model_operations(program), machine, "model");
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
