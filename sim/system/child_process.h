#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "sim/system/memory_file.h"

namespace csgsim::system {

/// What a program that is run may take.
struct ChildLimits {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::chrono::seconds time{};  ///< until it has ended
  std::size_t output = 0;       ///< bytes that it may write to its standard output
  std::size_t errors = 0;       ///< bytes that it may write to its standard error
  std::size_t memory = none;    ///< bytes of addresses that each of its processes may have (RLIMIT_AS)
};

/// The limit that ended a program.
enum class Exceeded : std::uint8_t { nothing, time, output, errors };

/// How a program that was run has ended.
struct ChildEnd {
  int status = 0;          ///< as waitpid tells it
  std::size_t memory = 0;  ///< most bytes that one of its processes had in memory; at least what its caller has
  Exceeded exceeded = Exceeded::nothing;
  std::string output;  ///< up to its limit
  std::string errors;  ///< up to its limit
};

/// Runs the program that the first word names, found as a shell finds it, and waits for its end. It reads `input` and
/// has no other file of this process. It works in a process group of its own, of which nothing is left when this
/// returns, nor when this process ends, by whatever signal. None if there is no such program; throws InputError, which
/// begins with the first word, if it cannot be run for another reason, and Interrupted where this thread's work is to
/// stop.
std::optional<ChildEnd> run_child(std::span<const std::string> words, const MemoryFile& input,
                                  const ChildLimits& limits);

/// Whether it ended as it should, within the limits.
bool is_done(const ChildEnd& end);

/// Why it did not: the limit, the signal, or the first line of what it said.
std::string why_failed(const ChildEnd& end, const ChildLimits& limits);

}  // namespace csgsim::system
