#include "hw/host/host.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "hw/base/quotient.h"
#include "hw/host/recipes.h"
#include "hw/machines/kind.h"
#include "hw/machines/regions.h"
#include "hw/processors/processor.h"

namespace csgsim::host {

namespace {

using processors::Operations;

/// The most clocks of a frame that are told: a double holds them.
constexpr double most_clocks = 9e15;

void add(const Operations& each, std::uint64_t times, Operations& all) {
  for (std::size_t kind = 0; kind < processors::operation_kinds; ++kind) all.counts[kind] += times * each.counts[kind];
}

void add(const isa::Preparation& preparation, Operations& all) {
  for (const Recipe& recipe : recipes()) add(recipe.each, preparation.*recipe.count, all);
}

/// Read once: they are asked for each frame.
const processors::Processor& processor_of(const machines::Machine& machine) {
  static const std::vector<processors::Processor> all = [] {
    std::vector<processors::Processor> read(1);
    for (const std::string_view name : std::span(machines::host_processor_names).subspan(1))
      read.push_back(processors::load_processor(std::string(name)));
    return read;
  }();
  return all.at(machine.host.processor);
}

}  // namespace

Operations operations_of(const isa::Program& program, const machines::Machine& machine) {
  constexpr std::uint64_t bytes_of_long = 4;
  Operations all;
  add(program.preparation, all);
  if (machines::division(machine)) {
    add(of_model_long(), quotient_up(std::uint64_t{program.display_model.size()}, bytes_of_long), all);
    return all;
  }
  for (const isa::Segment& segment : program.segments) {
    add(segment.preparation, all);
    for (const isa::Instruction& instruction : segment.instructions)
      all += operations_of(instruction, machine.link.width);
  }
  return all;
}

std::uint64_t compile_clocks(const isa::Program& program, const machines::Machine& machine) {
  if (machine.host.processor == machines::ideal_processor) return 0;
  const double seconds = processors::seconds(operations_of(program, machine), processor_of(machine));
  const double clocks = std::ceil(seconds * static_cast<double>(machine.clock_hz) / machine.kind->hosts(machine));
  if (!(clocks <= most_clocks)) {
    throw InputError(
        fmt::format("the host {} takes {:.3g} clocks for the frame, more than can be told; take a faster "
                    "one, by host.processor",
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
                                 std::span<const machines::Skip> skips) {
  return with_host(machine.kind->time(program, machine, skips), program, machine);
}

}  // namespace csgsim::host
