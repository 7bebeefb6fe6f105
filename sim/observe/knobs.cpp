#include "sim/observe/knobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "hw/host/host.h"
#include "hw/machines/kind.h"
#include "hw/machines/timing.h"

namespace csgsim::observe {

namespace {

/// Change applied to a parameter.
enum class Step : std::uint8_t {
  twice,
  half,
  least,  ///< smallest value of the schema, for parameters that are names
  most,
  other,  ///< every other named value except the ideal one
};

struct FigureStep {
  std::string_view key;
  Step step;
};

/// Parameters, of all kinds of machines, that hardware could have chosen differently and that no Program depends on.
constexpr auto figure_steps = std::to_array<FigureStep>({
    {"host.processor", Step::other},
    {"host.count", Step::twice},
    {"alu.bits", Step::twice},
    {"evaluator.bits", Step::twice},
    {"memory.reads", Step::twice},
    {"memory.clear_clocks", Step::half},
    {"link.width", Step::twice},
    {"link.fifo_depth", Step::twice},
    {"scan_out.pixels", Step::twice},
    {"scan_out.port", Step::least},
    {"cells.ports", Step::twice},
    {"chains.count", Step::twice},
    {"host.active_clocks", Step::half},
    {"renderers.count", Step::twice},
    {"renderers.buffers", Step::most},
    {"port.width", Step::twice},
    {"frame_buffer.banks", Step::twice},
    {"processors.count", Step::twice},
    {"ring.channels", Step::twice},
    {"ring.word_clocks", Step::half},
    {"refresh.bits", Step::twice},
    {"divider.count", Step::twice},
    {"divider.port", Step::twice},
    {"divider.halfspace_clocks", Step::half},
    {"divider.cell_clocks", Step::half},
    {"divider.linear_clocks", Step::half},
    {"host.link_width", Step::twice},
    {"display.transform_clocks", Step::half},
    {"display.halfspace_clocks", Step::half},
    {"display.divides_ahead", Step::most},
    {"node.halfspace_clocks", Step::half},
    {"node.multiply_clocks", Step::half},
    {"node.add_clocks", Step::half},
    {"node.read_clocks", Step::half},
    {"node.shift_bit_clocks", Step::half},
    {"node.field_clocks", Step::half},
    {"node.memory_words", Step::twice},
});

struct Change {
  const machines::FigureSchema* figure = nullptr;
  std::int64_t before = 0;
  std::int64_t after = 0;
};

std::vector<std::int64_t> stepped(const machines::FigureSchema& figure, std::int64_t value, Step step) {
  switch (step) {
    case Step::twice: return {2 * value};
    case Step::half: return {value >= 2 ? value / 2 : value};
    case Step::least: return {figure.least};
    case Step::most: return {figure.most};
    case Step::other: break;
  }
  std::vector<std::int64_t> others;
  for (std::int64_t other = figure.least; other <= figure.most; ++other)
    if (other != figure.ideal) others.push_back(other);
  return others;
}

/// The changes of a parameter; none if the machine lacks it or it is at its best value.
std::vector<Change> changes_of(const machines::Machine& machine, const FigureStep& row) {
  const auto figure = std::ranges::find(machine.kind->schema, row.key, &machines::FigureSchema::key);
  if (figure == machine.kind->schema.end()) return {};
  const std::int64_t before = figure->load(machine);
  if (figure->ideal && before == *figure->ideal) return {};
  std::vector<Change> changes;
  for (const std::int64_t after : stepped(*figure, before, row.step)) {
    if (after != before && after >= figure->least && after <= figure->most)
      changes.push_back({&*figure, before, after});
  }
  return changes;
}

std::string text_of(const Change& change, std::int64_t value) {
  const bool is_named = !change.figure->names.empty();
  return is_named ? std::string(change.figure->names[static_cast<std::size_t>(value)]) : fmt::format("{}", value);
}

/// The clocks with the change; nothing if the value does not fit the machine's other parameters.
std::optional<FrameClocks> clocks_with(const Change& change, const isa::Program& program, machines::Machine machine,
                                       const machines::RunOutcome& outcome) {
  change.figure->store(machine, change.after);
  try {
    const machines::Size picture = machine.picture;
    machines::complete(machine);
    machines::set_picture_size(machine, picture);
    return frame_clocks(host::time_frame(program, machine, outcome));
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The --machine option with that parameter, in place of any value it already has.
std::string option_of(const std::string& machine_option, const Change& change) {
  const std::string key = fmt::format("+{}=", change.figure->key);
  std::string machine = machine_option;
  if (const std::size_t at = machine.find(key); at != std::string::npos)
    machine.erase(at, std::min(machine.find('+', at + 1), machine.size()) - at);
  return fmt::format("--machine {}{}{}", machine, key, text_of(change, change.after));
}

/// Order of changes: the best first.
bool is_better(const Knob& one, const Knob& other) {
  return std::tie(one.after.hosted, one.after.interval) < std::tie(other.after.hosted, other.after.interval);
}

/// `26.2 ms instead of 36.3 ms (27.8 % less)`, with the clocks' meaning after the first time.
std::string gain(std::uint64_t before, std::uint64_t after, std::uint64_t clock_hz, const char* meaning) {
  const auto hz = static_cast<double>(clock_hz);
  const double saved = 1.0 - static_cast<double>(after) / static_cast<double>(before);
  return fmt::format("{} {} instead of {} ({:.1f} % less)", quantity(static_cast<double>(after) / hz, "s"), meaning,
                     quantity(static_cast<double>(before) / hz, "s"), 100.0 * saved);
}

}  // namespace

FrameClocks frame_clocks(const machines::FrameTiming& timing) {
  return {timing.interval_clocks, machines::paced_clocks(timing.interval_clocks, timing.host_clocks)};
}

std::string worth(const FrameClocks& before, const FrameClocks& after, std::uint64_t clock_hz) {
  const bool is_paced = before.hosted != before.interval || after.hosted != after.interval;
  if (!is_paced) return gain(before.interval, after.interval, clock_hz, "per frame");
  if (after.hosted < before.hosted) return gain(before.hosted, after.hosted, clock_hz, "per frame with the host");
  return gain(before.interval, after.interval, clock_hz, "per frame without the host");
}

std::vector<Knob> helpful_knobs(std::vector<Knob> knobs) {
  std::erase_if(knobs, [](const Knob& one) {
    return std::tie(one.after.hosted, one.after.interval) >= std::tie(one.before.hosted, one.before.interval);
  });
  std::ranges::stable_sort(knobs, is_better);
  return knobs;
}

std::vector<Knob> best_knob(std::vector<Knob> knobs) {
  knobs = helpful_knobs(std::move(knobs));
  if (knobs.size() > 1) knobs.resize(1);
  return knobs;
}

std::vector<Knob> parameter_knobs(const isa::Program& program, const machines::Machine& machine,
                                  const engine::RunResult& result, const std::string& machine_option) {
  const FrameClocks before = frame_clocks(engine::timing_of(result));
  std::vector<Knob> knobs;
  for (const FigureStep& row : figure_steps) {
    std::vector<Knob> of_figure;
    for (const Change& change : changes_of(machine, row)) {
      const std::optional<FrameClocks> after = clocks_with(change, program, machine, engine::run_outcome(result));
      if (!after) continue;
      Knob knob{option_of(machine_option, change), "", worth(before, *after, machine.clock_hz), before, *after};
      knob.sentence = fmt::format("{} {} instead of {}: {}", change.figure->key, text_of(change, change.after),
                                  text_of(change, change.before), knob.worth);
      of_figure.push_back(std::move(knob));
    }
    std::ranges::move(best_knob(std::move(of_figure)), std::back_inserter(knobs));
  }
  return helpful_knobs(std::move(knobs));
}

std::size_t parameters_to_try(const machines::Machine& machine) {
  return static_cast<std::size_t>(
      std::ranges::count_if(figure_steps, [&](const FigureStep& row) { return !changes_of(machine, row).empty(); }));
}

}  // namespace csgsim::observe
