#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/performance/build.h"
#include "tests/performance/program_work.h"
#include "tests/performance/rounds.h"

namespace csgsim::bench {

struct Settings {
  std::filesystem::path csgsim;               ///< the program to measure
  std::filesystem::path beside;               ///< another build, measured in turns; may be empty
  std::filesystem::path folder;               ///< folder of generated models, Programs and pictures
  std::vector<std::filesystem::path> models;  ///< in addition to the generated ones
  std::vector<std::string> machines;
  std::vector<std::string> levels;
  std::string size = "512x512";  ///< picture size in pixels
  Rounds rounds;
  std::vector<std::string> works;  ///< names of whole commands
};

/// The settings of each measured build: this one, and the other one, if given, with a separate folder.
std::vector<Settings> build_settings(const Settings& settings);

/// A model on a machine at a level. Seconds are those of the run alone.
struct Speed {
  std::string model;
  std::string machine;
  std::string level;
  std::uint64_t clocks = 0;
  double simulated = 0;  ///< seconds of the simulated machine
  Compared wall;         ///< wall time in seconds
  std::string command;

  [[nodiscard]] double ratio() const { return simulated / wall.seconds; }
};

/// The clocked engine compared with the dense loop on the same Program.
struct DensePair {
  std::string model;
  std::uint64_t clocks = 0;
  double clocked = 0;  ///< in seconds
  double dense = 0;    ///< in seconds
  std::string command;

  [[nodiscard]] double ratio() const { return clocked / dense; }
};

/// Another program that draws the same model, compared with csgsim: whole processes, from start to end.
struct Rival {
  std::string model;
  std::string command;
  std::string reason;  ///< reason if it was not measured
  double rival = 0;    ///< in seconds
  std::string csgsim_command;
  double csgsim = 0;  ///< in seconds

  [[nodiscard]] double ratio() const { return csgsim / rival; }
};

/// Seconds against one size, with everything else constant.
struct Growth {
  std::string against;  ///< the varied size
  std::string part;     ///< measured part: `compile` is a whole process, `run` the run alone
  std::string command;  ///< command of the largest size
  std::vector<Point> points;
  std::vector<Point> others{};  ///< points of the other build, if given

  [[nodiscard]] std::optional<double> power() const { return exponent(points); }
};

/// Costs of a run that do not depend on the speed of the computer.
struct Count {
  std::string model;
  std::string machine;
  ProgramWork work;                       ///< work of the functional level
  std::string reason{};                   ///< reason if the processor's instructions were not counted
  std::uint64_t instructions = 0;         ///< processor instructions of the whole process
  std::optional<std::uint64_t> others{};  ///< instructions of the other build
  std::string command{};                  ///< command that prints the work
};

/// Time of the functional level on several threads, computed from the seconds of each tile on one.
struct Schedule {
  std::string model;
  std::string machine;
  double rest = 0;              ///< seconds of a single-threaded run outside of tiles
  std::vector<Point> tiles;     ///< seconds by threads that share the tiles of a segment
  std::vector<Point> segments;  ///< seconds by threads that take whole segments of the picture
  double measured_two = 0;      ///< measured seconds of a run on two threads
};

/// One command or several, from start to end.
struct Whole {
  std::string name;
  std::string what;  ///< description
  std::vector<std::string> commands;
  Compared wall;
  double memory = 0;        ///< peak bytes of one of its processes
  double other_memory = 0;  ///< peak bytes of the other build
  double halfspaces = 0;    ///< half-spaces of the model, if memory is stated per half-space
};

struct Results {
  Build build;
  Settings settings;
  std::string other{};  ///< name_of_build() of the other build; may be empty
  std::vector<Speed> speeds{};
  std::vector<DensePair> dense{};
  std::vector<Rival> rivals{};
  std::vector<Growth> growths{};
  std::vector<Count> counts{};
  std::vector<Schedule> schedules{};
  std::vector<Whole> works{};
};

/// Parts of the measurement. Each writes its files into the folder, and throws InputError for a model that fails.
std::vector<Speed> measure_speeds(const Settings& settings);
std::vector<DensePair> measure_dense(const Settings& settings);
std::vector<Rival> measure_rivals(const Settings& settings);
std::vector<Growth> measure_growths(const Settings& settings);
std::vector<Count> measure_counts(const Settings& settings);
std::vector<Schedule> measure_schedules(const Settings& settings);
std::vector<Whole> measure_commands(const Settings& settings);

/// Names of the whole commands measured by measure_commands.
std::vector<std::string> work_names();

}  // namespace csgsim::bench
