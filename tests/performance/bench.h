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
  std::filesystem::path csgsim;               ///< the program that is measured
  std::filesystem::path beside;               ///< another build of it, measured in turn with it; or empty
  std::filesystem::path folder;               ///< where generated models, Programs and pictures go
  std::vector<std::filesystem::path> models;  ///< beside the generated ones
  std::vector<std::string> machines;
  std::vector<std::string> levels;
  std::string size = "512x512";  ///< of pictures, in pixels
  Rounds rounds;
  std::vector<std::string> works;  ///< names of whole commands
};

/// The settings of each build that is measured: of this one, and of the one beside it, if there is one, in a folder of
/// its own.
std::vector<Settings> sides_of(const Settings& settings);

/// A model on a machine at a level. Seconds are those of the run alone.
struct Speed {
  std::string model;
  std::string machine;
  std::string level;
  std::uint64_t clocks = 0;
  double simulated = 0;  ///< seconds of the machine
  Compared wall;         ///< seconds here
  std::string command;

  [[nodiscard]] double ratio() const { return simulated / wall.seconds; }
};

/// The clocked engine against the dense loop, on the same Program.
struct DensePair {
  std::string model;
  std::uint64_t clocks = 0;
  double clocked = 0;  ///< seconds
  double dense = 0;    ///< seconds
  std::string command;

  [[nodiscard]] double ratio() const { return clocked / dense; }
};

/// Another program that draws the same model, and csgsim beside it: whole processes, from start to end.
struct Rival {
  std::string model;
  std::string command;
  std::string reason;  ///< why it was not measured; else empty
  double rival = 0;    ///< seconds
  std::string csgsim_command;
  double csgsim = 0;  ///< seconds

  [[nodiscard]] double ratio() const { return csgsim / rival; }
};

/// Seconds against one size, all others being equal.
struct Growth {
  std::string against;  ///< what grows
  std::string part;     ///< whose seconds: `compile` is a whole process, `run` the run alone
  std::string command;  ///< of the largest
  std::vector<Point> points;
  std::vector<Point> others{};  ///< of the build beside it, if there is one

  [[nodiscard]] std::optional<double> power() const { return exponent(points); }
};

/// What a run takes that does not depend on how fast the computer is.
struct Count {
  std::string model;
  std::string machine;
  ProgramWork work;                       ///< of the functional level
  std::string reason{};                   ///< why the processor's instructions were not counted; else empty
  std::uint64_t instructions = 0;         ///< of the processor, for the whole process
  std::optional<std::uint64_t> others{};  ///< of the build beside it
  std::string command{};                  ///< that tells the work
};

/// How long the functional level takes on so many threads, worked out from the seconds of each tile on one.
struct Schedule {
  std::string model;
  std::string machine;
  double rest = 0;              ///< seconds of a run on one thread that are not work on tiles
  std::vector<Point> tiles;     ///< threads and seconds, where they share out the tiles of a segment
  std::vector<Point> segments;  ///< where each takes whole segments of the picture
  double measured_two = 0;      ///< seconds of a run on two threads
};

/// A command, or several, from start to end.
struct Whole {
  std::string name;
  std::string what;  ///< for people
  std::vector<std::string> commands;
  Compared wall;
  double memory = 0;        ///< most bytes of one of its processes
  double other_memory = 0;  ///< of the build beside it
  double halfspaces = 0;    ///< of the model, if memory is for these
};

struct Results {
  Build build;
  Settings settings;
  std::string other{};  ///< what is beside this build, by name_of_build(); empty if nothing is
  std::vector<Speed> speeds{};
  std::vector<DensePair> dense{};
  std::vector<Rival> rivals{};
  std::vector<Growth> growths{};
  std::vector<Count> counts{};
  std::vector<Schedule> schedules{};
  std::vector<Whole> works{};
};

/// Parts of the measurement. Each writes what it draws into the folder, and throws InputError for what cannot be drawn.
std::vector<Speed> measure_speeds(const Settings& settings);
std::vector<DensePair> measure_dense(const Settings& settings);
std::vector<Rival> measure_rivals(const Settings& settings);
std::vector<Growth> measure_growths(const Settings& settings);
std::vector<Count> measure_counts(const Settings& settings);
std::vector<Schedule> measure_schedules(const Settings& settings);
std::vector<Whole> measure_works(const Settings& settings);

/// Names of the whole commands that measure_works knows.
std::vector<std::string> work_names();

}  // namespace csgsim::bench
