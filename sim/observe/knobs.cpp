#include "sim/observe/knobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

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
};

struct FigureStep {
  std::string_view key;
  Step step;
};

/// Parameters, of all kinds of machines, that hardware could have chosen differently and that no Program depends on.
constexpr auto figure_steps = std::to_array<FigureStep>({
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

std::int64_t stepped(const machines::FigureSchema& figure, std::int64_t value, Step step) {
  switch (step) {
    case Step::twice: return 2 * value;
    case Step::half: return value >= 2 ? value / 2 : value;
    case Step::least: return figure.least;
    case Step::most: return figure.most;
  }
  return value;
}

struct Change {
  const machines::FigureSchema* figure = nullptr;
  std::int64_t before = 0;
  std::int64_t after = 0;
};

/// The changed parameter; nothing if the machine lacks it or it is at its best value.
std::optional<Change> change_of(const machines::Machine& machine, const FigureStep& row) {
  const auto figure = std::ranges::find(machine.kind->schema, row.key, &machines::FigureSchema::key);
  if (figure == machine.kind->schema.end()) return std::nullopt;
  const std::int64_t before = figure->load(machine);
  if (figure->ideal && before == *figure->ideal) return std::nullopt;
  const std::int64_t after = stepped(*figure, before, row.step);
  if (after == before || after < figure->least || after > figure->most) return std::nullopt;
  return Change{&*figure, before, after};
}

std::string text_of(const Change& change, std::int64_t value) {
  const bool is_named = !change.figure->names.empty();
  return is_named ? std::string(change.figure->names[static_cast<std::size_t>(value)]) : fmt::format("{}", value);
}

/// The clocks from one frame to the next; nothing if the value does not fit the machine's other parameters.
std::optional<std::uint64_t> interval_with(const Change& change, const isa::Program& program, machines::Machine machine,
                                           const machines::RunOutcome& outcome) {
  change.figure->store(machine, change.after);
  try {
    const machines::Size picture = machine.picture;
    machines::complete(machine);
    machines::set_picture_size(machine, picture);
    return host::time_frame(program, machine, outcome).interval_clocks;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The --machine option with that parameter, in place of any value it already has.
std::string option_of(const std::string& word, const Change& change) {
  const std::string key = fmt::format("+{}=", change.figure->key);
  std::string machine = word;
  if (const std::size_t at = machine.find(key); at != std::string::npos)
    machine.erase(at, std::min(machine.find('+', at + 1), machine.size()) - at);
  return fmt::format("--machine {}{}{}", machine, key, text_of(change, change.after));
}

}  // namespace

std::string worth(const Knob& knob) {
  const double saved = 1.0 - static_cast<double>(knob.clocks_after) / static_cast<double>(knob.clocks_before);
  return fmt::format("{} clocks from one frame to the next instead of {}, {:.1f} % fewer", grouped(knob.clocks_after),
                     grouped(knob.clocks_before), 100.0 * saved);
}

std::vector<Knob> helpful_knobs(std::vector<Knob> knobs) {
  std::erase_if(knobs, [](const Knob& one) { return one.clocks_after >= one.clocks_before; });
  std::ranges::stable_sort(knobs, {}, &Knob::clocks_after);
  return knobs;
}

std::vector<Knob> parameter_knobs(const isa::Program& program, const machines::Machine& machine,
                                  const engine::RunResult& result, const std::string& word) {
  std::vector<Knob> knobs;
  for (const FigureStep& row : figure_steps) {
    const std::optional<Change> change = change_of(machine, row);
    if (!change) continue;
    const std::optional<std::uint64_t> after = interval_with(*change, program, machine, engine::run_outcome(result));
    if (!after) continue;
    Knob knob{"", option_of(word, *change), result.interval_clocks, *after};
    knob.sentence = fmt::format("{} {} instead of {}: {}", change->figure->key, text_of(*change, change->after),
                                text_of(*change, change->before), worth(knob));
    knobs.push_back(std::move(knob));
  }
  return helpful_knobs(std::move(knobs));
}

std::size_t parameters_to_try(const machines::Machine& machine) {
  return static_cast<std::size_t>(
      std::ranges::count_if(figure_steps, [&](const FigureStep& row) { return change_of(machine, row).has_value(); }));
}

}  // namespace csgsim::observe
