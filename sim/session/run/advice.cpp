#include "sim/session/run/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "host/emit/compile.h"
#include "hw/base/error.h"
#include "sim/engine/engine.h"
#include "sim/functional/clocks.h"
#include "sim/session/options/prunings.h"

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

/// The selections of prunings to try: all, none, and all but one, for each pruning.
std::vector<std::string> tried_prunings() {
  const std::vector<std::string> words = pruning_words();
  std::vector<std::string> tried;
  for (const std::string& word : words) {
    const bool applies_one = std::ranges::find(words, "no-" + word) != words.end();
    if (!applies_one) tried.push_back(word);
  }
  return tried;
}

/// The clocks with other settings; nothing if the model then does not fit the machine.
std::optional<observe::FrameClocks> clocks_with(const ModelRequest& request, const CompiledModel& model,
                                                const machines::Machine& machine) {
  try {
    view::View view = view::make_view(model.scene, model.tree, model.camera, sampling_of(request, machine));
    const isa::Program program =
        emit::compile(model.tree, model.scene, std::move(view), machine, emit_options_of(request),
                      [&](const isa::Program& one) { return functional::measure_clocks(one, machine); });
    return observe::frame_clocks(functional::measure_timing(program, machine));
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Measures changed settings of one run.
class SettingTrials {
 public:
  SettingTrials(const CompiledModel& model, const machines::Machine& machine, const engine::RunResult& result)
      : model_(model), machine_(machine), before_(observe::frame_clocks(engine::timing_of(result))) {}

  /// Adds the knob to the list, unless the model does not fit with the option.
  void measure(const ModelRequest& turned, const std::string& option, const char* but,
               std::vector<observe::Knob>& knobs) const {
    const std::optional<observe::FrameClocks> after = clocks_with(turned, model_, machine_);
    if (!after) return;
    const std::string worth = observe::worth(before_, *after, machine_.clock_hz);
    knobs.push_back({option, fmt::format("{}: {}; {}", option, worth, but), worth, before_, *after});
  }

 private:
  const CompiledModel& model_;
  const machines::Machine& machine_;
  observe::FrameClocks before_;
};

/// The selection of prunings that helps most; empty if none does.
std::vector<observe::Knob> pruning_knob(const ModelRequest& request, const SettingTrials& trials) {
  std::vector<observe::Knob> knobs;
  for (const std::string& pruning : tried_prunings()) {
    ModelRequest turned = request;
    const std::optional<std::string> option = turn("--pruning", turned.pruning, pruning);
    if (option) trials.measure(turned, *option, same_picture, knobs);
  }
  return observe::best_knob(std::move(knobs));
}

}  // namespace

std::vector<observe::Knob> measure_setting_knobs(const CompiledModel& model, const ModelRequest& request,
                                                 const machines::Machine& machine, const engine::RunResult& result) {
  const SettingTrials trials(model, machine, result);
  std::vector<observe::Knob> knobs = pruning_knob(request, trials);
  for (const TriedSetting& setting : tried_settings) {
    ModelRequest turned = request;
    const std::optional<std::string> option = setting.turn(turned);
    if (option) trials.measure(turned, *option, setting.but, knobs);
  }
  return knobs;
}

std::vector<observe::Knob> measure_parameter_knobs(const Advice& advice, const isa::Program& program,
                                                   const machines::Machine& machine, const engine::RunResult& result) {
  if (!advice.is_asked || result.interval_clocks == 0) return {};
  engine::RunResult complete = result;
  // The cycle level counts clocks but does not record the run-time outcomes from which clocks are computed.
  if (complete.pixel_activity.empty())
    complete.pixel_activity = functional::make_run_record(program, machine).pixel_activity;
  std::vector<observe::Knob> knobs = observe::parameter_knobs(program, machine, complete, advice.machine);
  if (advice.settings) std::ranges::move(advice.settings(result), std::back_inserter(knobs));
  return observe::helpful_knobs(std::move(knobs));
}

}  // namespace csgsim::session
