#include "hw/base/messages.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "hw/base/text.h"

namespace csgsim {

namespace {

thread_local CollectedLines* keeper = nullptr;

}  // namespace

CollectedLines::CollectedLines() noexcept : before_(std::exchange(keeper, this)) {}

CollectedLines::~CollectedLines() { keeper = before_; }

void write_message(std::string_view text) noexcept {
  std::fflush(stdout);  // keeps the order if both streams go to one file
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

void report_line(std::string_view line) noexcept {
  try {
    if (keeper != nullptr) {
      keeper->lines_.emplace_back(line);
      return;
    }
    write_message(printable(line) + "\n");
  } catch (...) {
    write_message("csgsim: there is not enough memory\n");
  }
}

void open_closed_standard_streams() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(number, F_GETFD) >= 0) continue;
    // open() returns the lowest free number, which is `number` here. Reads from the stream return no data, and writes
    // fail.
    static_cast<void>(::open("/dev/null", O_RDONLY));
  }
}

}  // namespace csgsim
