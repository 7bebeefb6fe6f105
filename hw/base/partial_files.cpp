#include "hw/base/partial_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <random>
#include <string>

namespace csgsim {

namespace {

/// A path in storage that a signal handler may read.
struct Slot {
  std::atomic<bool> taken = false;  ///< reserved by a PartialFile
  std::atomic<bool> valid = false;  ///< the path is complete
  std::array<char, 4096> path{};
};

/// More than any command writes at once; further files would not be deleted.
constexpr std::size_t slot_count = 32;

std::array<Slot, slot_count>& slots() {
  static std::array<Slot, slot_count> all;
  return all;
}

std::optional<std::size_t> take_slot(const std::string& path) {
  if (path.size() >= Slot{}.path.size()) return std::nullopt;
  for (std::size_t i = 0; i < slot_count; ++i) {
    Slot& slot = slots()[i];
    if (slot.taken.exchange(true)) continue;
    slot.path[path.copy(slot.path.data(), path.size())] = '\0';
    slot.valid = true;
    return i;
  }
  return std::nullopt;
}

/// All signals that end a process by default, except SIGKILL and those that report a fault in the program.
constexpr auto ending_signals =
    std::to_array({SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGALRM, SIGTERM, SIGUSR1, SIGUSR2, SIGIO, SIGPROF, SIGVTALRM,
                   SIGXCPU, SIGXFSZ, SIGSTKFLT, SIGPWR, SIGSYS, SIGABRT});

/// Signal handler: deletes the registered files, then ends the process by the signal. Async-signal-safe.
extern "C" void delete_partial_files(int signal) {
  for (const Slot& slot : slots()) {
    if (slot.valid) ::unlink(slot.path.data());
  }
  std::signal(signal, SIG_DFL);
  ::raise(signal);
}

void handle_unless_ignored(int signal) {
  if (std::signal(signal, delete_partial_files) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

std::filesystem::path unique_file_name(std::string_view ending) {
  static const unsigned host = std::random_device{}();
  static std::atomic<unsigned> number = 0;
  return fmt::format(".csgsim-{}-{:08x}-{}{}", ::getpid(), host, ++number, ending);
}

PartialFile::PartialFile(const std::filesystem::path& path) : slot_(take_slot(path.native())) {}

PartialFile::~PartialFile() {
  if (!slot_) return;
  slots()[*slot_].valid = false;
  slots()[*slot_].taken = false;
}

void delete_partial_files_on_signals() {
  slots();
  for (const int signal : ending_signals) handle_unless_ignored(signal);
  for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal) handle_unless_ignored(signal);
}

}  // namespace csgsim
