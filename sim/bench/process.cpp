#include "sim/bench/process.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <filesystem>
#include <vector>

#include "hw/base/child_process.h"
#include "hw/base/error.h"
#include "hw/base/memory_file.h"
#include "hw/base/text.h"

namespace csgsim::bench {

namespace {

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Processor time of all children so far.
double children_seconds() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

/// What the program `timeout` ends with by itself.
constexpr int timeout_over = 124;
constexpr int timeout_not_found = 127;

struct Ended {
  int status = 0;   ///< as waitpid tells it
  std::string why;  ///< it failed, if it did
  Took took;
};

std::optional<Ended> run(std::span<const std::string> words) {
  const MemoryFile input(words.front());
  const MemoryFile output(words.front());
  const MemoryFile errors(words.front());
  const double before = children_seconds();
  const auto begin = std::chrono::steady_clock::now();
  const std::optional<int> status = run_child(words, {input, output, errors});
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  if (!status) return std::nullopt;
  return Ended{
      *status, *status == 0 ? "" : printable(why_failed(*status, errors)), {wall.count(), children_seconds() - before}};
}

std::optional<Took> took_of(const std::string& program, const std::optional<Ended>& ended) {
  if (!ended) return std::nullopt;
  if (ended->status != 0) throw InputError(program + ": fails: " + ended->why);
  return ended->took;
}

}  // namespace

std::optional<Took> run_process(std::span<const std::string> words) { return took_of(words.front(), run(words)); }

std::optional<Took> run_process_within(unsigned seconds, std::span<const std::string> words) {
  std::vector<std::string> limited{"timeout", std::to_string(seconds)};
  limited.insert(limited.end(), words.begin(), words.end());
  const std::optional<Ended> ended = run(limited);
  if (ended && WIFEXITED(ended->status) && WEXITSTATUS(ended->status) == timeout_not_found) return std::nullopt;
  if (ended && WIFEXITED(ended->status) && WEXITSTATUS(ended->status) == timeout_over)
    throw InputError(words.front() + fmt::format(": takes more than {} s", seconds));
  return took_of(words.front(), ended);
}

std::string command_text(std::span<const std::string> words) {
  std::string text = shell_word(std::filesystem::path(words.front()).filename().native());
  for (const std::string& word : words.subspan(1)) text += " " + shell_word(word);
  return text;
}

}  // namespace csgsim::bench
