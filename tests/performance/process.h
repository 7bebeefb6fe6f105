#pragma once

#include <optional>
#include <span>
#include <string>

namespace csgsim::bench {

/// The cost of a whole process.
struct ProcessCost {
  double wall = 0;       ///< in seconds
  double processor = 0;  ///< in seconds, user and system
  double memory = 0;     ///< peak bytes of one of its processes
  std::string output{};  ///< standard output
};

/// Runs a program, found through PATH, to its end; returns nothing if it does not exist. Throws InputError, beginning
/// with the program's name, if it fails.
std::optional<ProcessCost> run_process(std::span<const std::string> words);

/// As run_process(), with a time limit in seconds, after which the program is terminated with an InputError.
std::optional<ProcessCost> run_process_within(unsigned seconds, std::span<const std::string> words);

/// The words quoted for a shell, the program without its folder.
std::string command_text(std::span<const std::string> words);

}  // namespace csgsim::bench
