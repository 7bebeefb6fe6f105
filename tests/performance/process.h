#pragma once

#include <optional>
#include <span>
#include <string>

namespace csgsim::bench {

/// What a whole process took.
struct Took {
  double wall = 0;       ///< seconds
  double processor = 0;  ///< seconds, of user and system
  double memory = 0;     ///< most bytes that one of its processes had in memory
  std::string output{};  ///< what it printed, without errors
};

/// Runs a program, found as a shell finds it, to its end; nothing if there is none. Throws InputError, which begins
/// with the program's name, if it fails.
std::optional<Took> run_process(std::span<const std::string> words);

/// The same, but a program that takes more seconds than that is ended, which is an InputError too.
std::optional<Took> run_process_within(unsigned seconds, std::span<const std::string> words);

/// The words as a shell reads them, the program without its folder.
std::string command_text(std::span<const std::string> words);

}  // namespace csgsim::bench
