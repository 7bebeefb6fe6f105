#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace csgsim::testing::faults {

/// What a process may not do, and what it is told.
struct Conditions {
  std::map<std::string, std::string> environment;
  /// Bytes that a file may have (ulimit -f), whoever writes it.
  std::optional<std::uint64_t> longest_file;
  /// Whether a write past that ends the process by SIGXFSZ; else it fails with EFBIG.
  bool is_signalled = false;
};

/// How a process ended: with a code, or else by a signal.
struct Ended {
  int code = -1;
  int signal = 0;
  std::string err;
};

/// Runs csgsim. Its standard output and error are pipes, which no limit on files meets.
Ended run_csgsim(const std::vector<std::string>& words, const Conditions& conditions);

/// Runs csgsim with the preloaded library, which fails that call, as CSGSIM_FAULT says it (fault_library.cpp), and puts
/// into the report what it failed, or, where it is empty, how many calls there were.
Ended run_failing(const std::vector<std::string>& words, const std::string& fault, const std::string& report);

/// How many calls of each kind a report has.
std::map<std::string, std::size_t> calls(const std::string& report);

/// Does some work in a process of its own; code 1 and a line on standard error where it throws.
Ended run_apart(const std::function<void()>& work, const Conditions& conditions);

}  // namespace csgsim::testing::faults
