#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace csgsim::testing::faults {

/// Limits and environment variables of a process.
struct Conditions {
  std::map<std::string, std::string> environment;
  /// Largest size of a file in bytes (ulimit -f), for any writer.
  std::optional<std::uint64_t> longest_file;
  /// Whether a longer write ends the process by SIGXFSZ; otherwise it fails with EFBIG.
  bool is_signalled = false;
};

/// How a process ended: with an exit code or by a signal.
struct ChildResult {
  int code = -1;
  int signal = 0;
  std::string err;
};

/// Runs csgsim. Its standard output and error are pipes, to which file size limits do not apply.
ChildResult run_csgsim(const std::vector<std::string>& words, const Conditions& conditions);

/// Runs csgsim with the preloaded library, which fails the calls given in the format of CSGSIM_FAULT
/// (fault_library.cpp). The report lists the failed calls or, for an empty `fault`, the numbers of calls.
ChildResult run_with_faults(const std::vector<std::string>& words, const std::string& fault, const std::string& report);

/// Number of calls of each kind in a report.
std::map<std::string, std::size_t> calls(const std::string& report);

/// Runs the work in a separate process; an exception there gives code 1 and a line on standard error.
ChildResult run_in_child(const std::function<void()>& work, const Conditions& conditions);

}  // namespace csgsim::testing::faults
