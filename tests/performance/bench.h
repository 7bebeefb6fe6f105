#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/performance/build.h"
#include "tests/performance/rounds.h"

namespace csgsim::bench {

struct Settings {
  std::filesystem::path csgsim;               ///< the program that is measured
  std::filesystem::path folder;               ///< where generated models, Programs and pictures go
  std::vector<std::filesystem::path> models;  ///< beside the generated ones
  std::vector<std::string> machines;
  std::vector<std::string> levels;
  std::string size = "512x512";  ///< of pictures, in pixels
  Rounds rounds;
};

/// A model on a machine at a level. Seconds are those of the run alone.
struct Speed {
  std::string model;
  std::string machine;
  std::string level;
  std::uint64_t clocks = 0;
  double simulated = 0;  ///< seconds of the machine
  double wall = 0;       ///< seconds here
  std::string command;

  [[nodiscard]] double ratio() const { return simulated / wall; }
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

  [[nodiscard]] std::optional<double> power() const { return exponent(points); }
};

struct Results {
  Build build;
  Settings settings;
  std::vector<Speed> speeds;
  std::vector<DensePair> dense;
  std::vector<Rival> rivals;
  std::vector<Growth> growths;
};

/// Parts of the measurement. Each writes what it draws into the folder, and throws InputError for what cannot be drawn.
std::vector<Speed> measure_speeds(const Settings& settings);
std::vector<DensePair> measure_dense(const Settings& settings);
std::vector<Rival> measure_rivals(const Settings& settings);
std::vector<Growth> measure_growths(const Settings& settings);

}  // namespace csgsim::bench
