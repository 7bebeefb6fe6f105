#include "tests/performance/process.h"
#include "tests/performance/runs.h"

namespace csgsim::bench {

namespace {

std::string name_of(const std::filesystem::path& model) { return model.stem().native(); }

/// The levels of one model on one machine, in turn.
std::vector<Speed> speeds_of(const Settings& settings, const std::filesystem::path& model, const std::string& machine) {
  const Compiled compiled = compile(settings, model, machine, settings.size);
  std::vector<Speed> speeds(settings.levels.size());
  std::vector<Timed> timed;
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const Words words = run_words(settings, compiled, settings.levels[i]);
    speeds[i] = {name_of(model), machine, settings.levels[i], 0, 0, 0, command_text(words)};
    timed.emplace_back([&settings, &speed = speeds[i], words] {
      const Ran ran = run(settings, words);
      speed.clocks = ran.clocks;
      speed.simulated = ran.simulated;
      return ran.wall;
    });
  }
  const std::vector<double> medians = medians_in_turn(timed, settings.rounds);
  for (std::size_t i = 0; i < speeds.size(); ++i) speeds[i].wall = medians[i];
  return speeds;
}

}  // namespace

std::vector<Speed> measure_speeds(const Settings& settings) {
  std::vector<Speed> all;
  for (const std::filesystem::path& model : all_models(settings)) {
    for (const std::string& machine : settings.machines) {
      for (Speed& speed : speeds_of(settings, model, machine)) all.push_back(std::move(speed));
    }
  }
  return all;
}

}  // namespace csgsim::bench
