#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/performance/bench.h"
#include "tests/performance/process.h"

namespace csgsim::bench {

/// A model compiled for a machine.
struct Compiled {
  std::filesystem::path program;
  std::string machine;
};

/// Measurements that a run of csgsim prints.
struct Ran {
  std::uint64_t clocks = 0;
  double simulated = 0;  ///< in seconds
  double wall = 0;       ///< in seconds, for the run without start, reading and writing
};

using Words = std::vector<std::string>;

/// Writes a generated model into the folder.
std::filesystem::path put_model(const Settings& settings, const std::string& name, const std::string& text);

/// The requested models, and two generated ones: a grid of 64 cubes, and a drilled sphere of 482 half-spaces that fills
/// the picture.
std::vector<std::filesystem::path> all_models(const Settings& settings);

/// Path of the model's Program for that machine.
std::filesystem::path program_path(const Settings& settings, const std::filesystem::path& model,
                                   const std::string& machine, const std::string& size);

Words compile_words(const Settings& settings, const std::filesystem::path& model, const Compiled& compiled,
                    const std::string& size);

/// Runs `csgsim compile` for a model that fills the picture.
Compiled compile(const Settings& settings, const std::filesystem::path& model, const std::string& machine,
                 const std::string& size);

Words run_words(const Settings& settings, const Compiled& compiled, const std::string& level, unsigned threads = 1);

/// Runs `csgsim run`, and parses its output.
Ran run(const Settings& settings, const Words& words);

/// Runs a process of csgsim. Throws InputError if it fails.
double process_seconds(const Words& words);
ProcessCost run_to_end(const Words& words);

}  // namespace csgsim::bench
