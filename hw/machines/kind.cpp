#include "hw/machines/kind.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include "hw/machines/clocks.h"
#include "hw/machines/regions.h"
#include "hw/machines/runs_on.h"

namespace csgsim::machines {

Machine blank_machine(const Kind& kind) {
  Machine machine;
  machine.kind = &kind;
  kind.init_own_figures(machine);
  return machine;
}

void complete(Machine& machine) { machine.kind->complete(machine); }

void set_picture_size(Machine& machine, Size size) {
  machine.kind->set_picture(machine, size);
  machine.picture = size;
}

void adopt_shape(Machine& machine, const isa::Program& program) {
  set_picture_size(machine, {program.shape.width, program.shape.height});
  machine.array.memory_bits = program.shape.memory_bits;
}

std::string used_value(const Figure& figure, const Machine& machine) {
  const auto row = std::ranges::find(machine.kind->schema, std::string_view(figure.key), &FigureSchema::key);
  const bool is_number = figure.value != ideal_value && row->names.empty() && row->least != row->most;
  return is_number ? std::to_string(row->load(machine)) : figure.value;
}

std::vector<std::string> ideal_candidates(const Machine& machine) {
  std::vector<std::string> keys;
  for (const FigureSchema& figure : machine.kind->schema) {
    if (figure.ideal && figure.load(machine) != *figure.ideal) keys.emplace_back(figure.key);
  }
  return keys;
}

void make_ideal(Machine& machine, std::string_view key) {
  const auto row = std::find_if(machine.kind->schema.begin(), machine.kind->schema.end(),
                                [&](const FigureSchema& figure) { return figure.key == key && figure.ideal; });
  if (row == machine.kind->schema.end()) throw std::out_of_range(std::string(key) + " is never ideal");
  row->store(machine, *row->ideal);
  for (Figure& figure : machine.figures) {
    if (figure.key == key) figure.value = ideal_value;
  }
  complete(machine);
}

std::vector<std::string> ideal_parameters(const Machine& machine) {
  std::vector<std::string> keys;
  for (const Figure& figure : machine.figures) {
    if (figure.value == ideal_value) keys.push_back(figure.key);
  }
  return keys;
}

isa::MachineRecord machine_record(const Machine& machine) {
  isa::MachineRecord record{machine.name, std::string(machine.kind->name), {}};
  for (const Figure& figure : machine.figures) record.figures.push_back(figure.key + "=" + figure.value);
  return record;
}

std::vector<std::string> figure_differences(const Machine& first, const Machine& second) {
  const auto text = [](const FigureSchema& figure, const Machine& machine) {
    const std::int64_t value = figure.load(machine);
    return figure.names.empty() ? std::to_string(value) : std::string(figure.names[static_cast<std::size_t>(value)]);
  };
  std::vector<std::string> others;
  for (const FigureSchema& figure : first.kind->schema) {
    if (figure.key.starts_with("picture.") || figure.load(first) == figure.load(second)) continue;
    others.push_back(std::string(figure.key) + " " + text(figure, first) + " instead of " + text(figure, second));
  }
  return others;
}

bool is_same_hardware(const Machine& first, const Machine& second) {
  const auto same = [&](const FigureSchema& figure) {
    return figure.key.starts_with("picture.") || figure.load(first) == figure.load(second);
  };
  return first.kind == second.kind && first.array == second.array &&
         std::all_of(first.kind->schema.begin(), first.kind->schema.end(), same);
}

isa::Field second_buffer(std::uint32_t colour_bits, const Machine& machine) {
  return machine.kind->second_buffer(colour_bits, machine);
}

bool has_global_or(const Machine& machine) { return machine.kind->has_global_or(machine); }

bool keeps_active_list(const Machine& machine) { return machine.kind->keeps_active_list(); }

std::optional<Division> division(const Machine& machine) { return machine.kind->division(machine); }

std::vector<isa::Region> regions(const Machine& machine) { return machine.kind->regions(machine); }

std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) {
  return machine.kind->clocks(instruction, machine);
}

std::uint64_t clocks(std::span<const isa::Instruction> instructions, const Machine& machine) {
  std::uint64_t total = 0;
  for (const isa::Instruction& instruction : instructions) total += clocks(instruction, machine);
  return total;
}

std::uint64_t clocks(const isa::Program& program, const Machine& machine) {
  return time_frame(program, machine).clocks;
}

FrameRates frame_rates(std::uint64_t clock_hz, std::uint64_t interval_clocks, std::uint64_t host_clocks) {
  const auto frames = [&](std::uint64_t clocks) {
    return clocks == 0 ? 0.0 : static_cast<double>(clock_hz) / static_cast<double>(clocks);
  };
  return {frames(interval_clocks), frames(paced_clocks(interval_clocks, host_clocks))};
}

FrameTiming with_pace(FrameTiming timing) {
  timing.shown_clocks = std::max(timing.shown_clocks, timing.clocks);
  if (timing.interval_clocks == 0) timing.interval_clocks = timing.shown_clocks;
  return timing;
}

FrameTiming time_frame(const isa::Program& program, const Machine& machine, const RunOutcome& outcome) {
  return with_pace(machine.kind->time(program, machine, outcome));
}

}  // namespace csgsim::machines
