#include "tests/performance/schedule.h"

#include <algorithm>
#include <array>
#include <functional>
#include <queue>

#include "hw/isa/program_file.h"
#include "hw/kinds/load.h"
#include "tests/performance/runs.h"

namespace csgsim::bench {

namespace {

constexpr std::array max_threads{1U, 2U, 4U, 8U, 16U, 64U};
constexpr unsigned replays = 3;
constexpr const char* level = "functional";

/// A replay with the shortest seconds of each tile over several replays, to exclude other load.
Replay shortest_replay(const isa::Program& program, const machines::Machine& machine) {
  Replay shortest = replay(program, machine);
  for (unsigned i = 1; i < replays; ++i) {
    const Replay again = replay(program, machine);
    for (std::size_t stretch = 0; stretch < again.stretches.size(); ++stretch) {
      for (std::size_t tile = 0; tile < again.stretches[stretch].tiles.size(); ++tile) {
        double& seconds = shortest.stretches[stretch].tiles[tile].seconds;
        seconds = std::min(seconds, again.stretches[stretch].tiles[tile].seconds);
      }
    }
  }
  return shortest;
}

Schedule schedule_of(const Settings& settings, const std::filesystem::path& model, const std::string& machine) {
  const Compiled compiled = compile(settings, model, machine, settings.size);
  const isa::Program program = isa::load_program(compiled.program);
  const Words one = run_words(settings, compiled, level);
  const Words two = run_words(settings, compiled, level, 2);
  const std::array<Timed, 2> timed{[&] { return run(settings, one).wall; }, [&] { return run(settings, two).wall; }};
  const std::vector<double> medians = medians_in_turn(timed, settings.rounds);
  const Replay shortest = shortest_replay(program, kinds::load(program.machine));
  Schedule schedule{
      model.stem().native(), machine, std::max(medians[0] - makespan_by_tiles(shortest, 1), 0.0), {}, {}, medians[1]};
  for (const unsigned threads : max_threads) {
    schedule.tiles.push_back({static_cast<double>(threads), schedule.rest + makespan_by_tiles(shortest, threads)});
    schedule.segments.push_back(
        {static_cast<double>(threads), schedule.rest + makespan_by_segments(shortest, threads)});
  }
  return schedule;
}

}  // namespace

double makespan(std::span<const double> jobs, unsigned threads) {
  std::priority_queue<double, std::vector<double>, std::greater<>> free(std::greater<>(),
                                                                        std::vector<double>(threads, 0.0));
  double last = 0;
  for (const double job : jobs) {
    const double end = free.top() + job;
    free.pop();
    free.push(end);
    last = std::max(last, end);
  }
  return last;
}

double makespan_by_tiles(const Replay& replay, unsigned threads) {
  double all = 0;
  std::vector<double> jobs;
  for (const StretchShares& stretch : replay.stretches) {
    jobs.clear();
    for (const TileShare& tile : stretch.tiles) jobs.push_back(tile.seconds);
    all += makespan(jobs, threads);
  }
  return all;
}

double makespan_by_segments(const Replay& replay, unsigned threads) {
  std::vector<double> jobs;
  for (const StretchShares& stretch : replay.stretches) {
    jobs.resize(std::max<std::size_t>(jobs.size(), stretch.segment + 1));
    for (const TileShare& tile : stretch.tiles) jobs[stretch.segment] += tile.seconds;
  }
  return makespan(jobs, threads);
}

std::vector<Schedule> measure_schedules(const Settings& settings) {
  std::vector<Schedule> all;
  for (const std::filesystem::path& model : all_models(settings)) {
    for (const std::string& machine : settings.machines) all.push_back(schedule_of(settings, model, machine));
  }
  return all;
}

}  // namespace csgsim::bench
