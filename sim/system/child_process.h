// Runs other programs within limits.
// Used by sim/plots, sim/session, sim/suite, sim/viewer and sim/waves.
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

/// Limits of a child program.
struct ChildLimits {
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  std::chrono::seconds time{};  ///< running time
  std::size_t output = 0;       ///< bytes on its standard output
  std::size_t errors = 0;       ///< bytes on its standard error
  std::size_t memory = none;    ///< address space of each of its processes in bytes (RLIMIT_AS)
};

/// The limit at which a program was stopped.
enum class Exceeded : std::uint8_t { nothing, time, output, errors };

/// Result of a child program.
struct ChildEnd {
  int status = 0;          ///< status from waitpid
  std::size_t memory = 0;  ///< peak resident bytes of one of its processes; at least those of its caller
  Exceeded exceeded = Exceeded::nothing;
  std::string output;  ///< up to its limit
  std::string errors;  ///< up to its limit
};

/// Runs the program named by the first word, found on the PATH like in a shell, and waits for its end. It reads `input`
/// and inherits no other file of this process. It runs in a separate process group, which ends with this function, and
/// with this process even if a signal kills it. Returns nothing if the program does not exist. Throws
/// InputError, which begins with the first word, if it cannot be run for another reason, and Interrupted if the current
/// thread's work must stop.
std::optional<ChildEnd> run_child(std::span<const std::string> words, const MemoryFile& input,
                                  const ChildLimits& limits);

/// Whether the program ended successfully and within the limits.
bool has_succeeded(const ChildEnd& end);

/// Why the program failed: the limit, the signal, or the first line of its messages.
std::string failure_text(const ChildEnd& end, const ChildLimits& limits);

}  // namespace csgsim::system
