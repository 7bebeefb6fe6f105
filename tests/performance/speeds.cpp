#include <array>

#include "tests/performance/process.h"
#include "tests/performance/runs.h"

namespace csgsim::bench {

namespace {

std::string name_of(const std::filesystem::path& model) { return model.stem().native(); }

/// Measures the levels of one model on one machine, in turns.
std::vector<Speed> speeds_of(const Settings& settings, const std::filesystem::path& model, const std::string& machine) {
  const std::vector<Settings> sides = build_settings(settings);
  std::vector<Speed> speeds(settings.levels.size());
  std::array<std::vector<Timed>, 2> timed;
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const Compiled compiled = compile(sides[side], model, machine, settings.size);
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const Words words = run_words(sides[side], compiled, settings.levels[i]);
      if (side == 0) speeds[i] = {name_of(model), machine, settings.levels[i], 0, 0, {}, command_text(words)};
      timed.at(side).emplace_back([&own = sides[side], &speed = speeds[i], words] {
        const Ran ran = run(own, words);
        speed.clocks = ran.clocks;
        speed.simulated = ran.simulated;
        return ran.wall;
      });
    }
  }
  const std::vector<Compared> walls = compare_in_turn(timed[0], timed[1], settings.rounds);
  for (std::size_t i = 0; i < speeds.size(); ++i) speeds[i].wall = walls[i];
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
