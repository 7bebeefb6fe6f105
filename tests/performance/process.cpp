#include "tests/performance/process.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <utility>

#include "hw/base/error.h"
#include "hw/base/text.h"
#include "sim/system/child_process.h"
#include "sim/system/memory_file.h"

namespace csgsim::bench {

namespace {

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Processor time of all ended children.
double children_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

/// Limits of measured programs: csgsim and its rivals. Their output goes to files.
system::ChildLimits limits_of(std::chrono::seconds longest) {
  return {.time = longest, .output = std::size_t{64} << 20U, .errors = std::size_t{64} << 20U};
}

std::optional<ProcessCost> run(std::span<const std::string> words, const system::ChildLimits& limits) {
  const std::string& program = words.front();
  const system::MemoryFile input(program);
  const double before = children_seconds();
  const auto begin = std::chrono::steady_clock::now();
  std::optional<system::ChildEnd> ended = system::run_child(words, input, limits);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  if (!ended) return std::nullopt;
  if (ended->exceeded == system::Exceeded::time)
    throw InputError(fmt::format("{}: takes more than {} s", program, limits.time.count()));
  if (!system::has_succeeded(*ended))
    throw InputError(program + ": fails: " + printable(system::failure_text(*ended, limits)));
  return ProcessCost{wall.count(), children_seconds() - before, static_cast<double>(ended->memory),
                     std::move(ended->output)};
}

}  // namespace

std::optional<ProcessCost> run_process(std::span<const std::string> words) {
  return run(words, limits_of(std::chrono::hours(24)));
}

std::optional<ProcessCost> run_process_within(unsigned seconds, std::span<const std::string> words) {
  return run(words, limits_of(std::chrono::seconds(seconds)));
}

std::string command_text(std::span<const std::string> words) {
  std::string text = shell_word(std::filesystem::path(words.front()).filename().native());
  for (const std::string& word : words.subspan(1)) text += " " + shell_word(word);
  return text;
}

}  // namespace csgsim::bench
