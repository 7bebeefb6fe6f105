#include "hw/base/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <string>

namespace csgsim {

namespace {

constexpr auto standard_output_names =
    std::to_array<std::string_view>({standard_stream, "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"});

/// Standard output is descriptor 1 while text is printed to it, and is kept under another number afterwards.
struct State {
  int output = STDOUT_FILENO;
  bool is_silent = false;
};

State& state() {
  static State one;
  return one;
}

/// Redirects printed text to `number`. Text printed before still goes to the old target.
void print_to(int number) {
  std::cout.flush();
  std::fflush(stdout);
  if (prints_to_standard_output()) state().output = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  ::dup2(number, STDOUT_FILENO);
}

}  // namespace

bool is_standard_output(const std::filesystem::path& path) {
  return std::ranges::find(standard_output_names, path.native()) != standard_output_names.end();
}

bool is_terminal(const std::filesystem::path& path) {
  if (is_standard_output(path)) return ::isatty(state().output) != 0;
  std::error_code error;
  if (!std::filesystem::is_character_file(path, error)) return false;
  const Descriptor device(::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC));
  return device.is_open() && ::isatty(device.number()) != 0;
}

Descriptor reserve_standard_output() {
  if (prints_to_standard_output()) print_to(STDERR_FILENO);
  return Descriptor(::fcntl(state().output, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
}

void silence_prints() {
  const Descriptor nowhere(::open("/dev/null", O_WRONLY | O_CLOEXEC));
  if (nowhere.is_open()) print_to(nowhere.number());
  state().is_silent = true;
}

bool prints_to_standard_output() { return state().output == STDOUT_FILENO; }

bool is_silent() { return state().is_silent; }

}  // namespace csgsim
