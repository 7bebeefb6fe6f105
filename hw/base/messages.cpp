#include "hw/base/messages.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "hw/base/text.h"

namespace csgsim {

namespace {

thread_local KeptLines* keeper = nullptr;

}  // namespace

KeptLines::KeptLines() noexcept : before_(std::exchange(keeper, this)) {}

KeptLines::~KeptLines() { keeper = before_; }

void tell(std::string_view text) noexcept {
  std::fflush(stdout);  // where both go to one file, what was printed before stands before
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

void tell_line(std::string_view line) noexcept {
  try {
    if (keeper != nullptr) {
      keeper->lines_.emplace_back(line);
      return;
    }
    tell(printable(line) + "\n");
  } catch (...) {
    tell("csgsim: there is not enough memory\n");
  }
}

void keep_standard_numbers() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(number, F_GETFD) >= 0) continue;
    // The lowest free number is this one. What is read from it is empty, and writing to it is an error.
    static_cast<void>(::open("/dev/null", O_RDONLY));
  }
}

}  // namespace csgsim
