#include "sim/session/run/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>

#include "host/emit/compile.h"
#include "hw/base/error.h"
#include "hw/host/host.h"
#include "hw/machines/timing.h"
#include "sim/engine/engine.h"
#include "sim/functional/clocks.h"

namespace csgsim::session {

namespace {

constexpr unsigned fewer_bits = 4;
constexpr unsigned few_colour_bits = 12;

/// Changes the value and returns the option as on the command line; nothing if the value is already set.
template <class Value>
std::optional<std::string> turn(const char* option, Value& value, const Value& to) {
  if (value == to) return std::nullopt;
  value = to;
  return fmt::format("{} {}", option, to);
}

std::optional<std::string> lower(const char* option, unsigned& bits, unsigned fewest) {
  return turn(option, bits, bits < fewest + fewer_bits ? bits : bits - fewer_bits);
}

/// An option that can be changed by one step.
struct TriedSetting {
  /// The changed option as on the command line; nothing if it is at its limit.
  std::optional<std::string> (*turn)(ModelRequest& request);
  const char* but;  ///< side effect
};

constexpr const char* same_picture = "the same picture";
constexpr const char* other_picture = "another picture; csgsim accuracy counts the wrong pixels";

constexpr auto tried_settings = std::to_array<TriedSetting>({
    {[](ModelRequest& request) { return turn("--strategy", request.strategy, std::string("auto")); }, same_picture},
    {[](ModelRequest& request) { return turn("--colouring", request.colouring, std::string("auto")); }, same_picture},
    {[](ModelRequest& request) { return lower("--z-bits", request.z_bits, view::min_z_bits); }, other_picture},
    {[](ModelRequest& request) { return lower("--fraction-bits", request.fraction_bits, 0); }, other_picture},
    {[](ModelRequest& request) {
       return turn("--colour-bits", request.colour_bits, std::min(request.colour_bits, few_colour_bits));
     },
     "coarser colours"},
});

std::uint64_t interval_of(const isa::Program& program, const machines::Machine& machine) {
  if (!functional::needs_run(program, machine)) return host::time_frame(program, machine).interval_clocks;
  return engine::make_functional_engine(machine)->run(program, {}).interval_clocks;
}

/// The frame interval with other settings; nothing if the model then does not fit the machine.
std::optional<std::uint64_t> interval_with(const ModelRequest& request, const CompiledModel& model,
                                           const machines::Machine& machine) {
  try {
    const isa::Program program =
        emit::compile(model.tree, model.scene, view_of(model, request, machine), machine, emit_options_of(request),
                      [&](const isa::Program& one) { return functional::measure_clocks(one, machine); });
    return interval_of(program, machine);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<observe::Knob> setting_knobs(const CompiledModel& model, const ModelRequest& request,
                                         const machines::Machine& machine, const engine::RunResult& result) {
  std::vector<observe::Knob> knobs;
  for (const TriedSetting& setting : tried_settings) {
    ModelRequest turned = request;
    const std::optional<std::string> option = setting.turn(turned);
    if (!option) continue;
    const std::optional<std::uint64_t> after = interval_with(turned, model, machine);
    if (!after) continue;
    observe::Knob knob{"", *option, result.interval_clocks, *after};
    knob.sentence = fmt::format("{}: {}; {}", *option, observe::worth(knob), setting.but);
    knobs.push_back(std::move(knob));
  }
  return knobs;
}

std::vector<observe::Knob> knobs_of(const Advice& advice, const isa::Program& program, const machines::Machine& machine,
                                    const engine::RunResult& result) {
  if (!advice.is_asked || result.interval_clocks == 0) return {};
  engine::RunResult complete = result;
  // The cycle level counts clocks but does not record the run-time outcomes from which clocks are computed.
  if (complete.met.empty()) complete.met = functional::make_run_record(program, machine).met;
  std::vector<observe::Knob> knobs = observe::parameter_knobs(program, machine, complete, advice.machine);
  if (advice.settings) std::ranges::move(advice.settings(result), std::back_inserter(knobs));
  return observe::helpful_knobs(std::move(knobs));
}

}  // namespace csgsim::session
